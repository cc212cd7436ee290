//! One step of an integration method for a damped oscillator, from the definition of the method.
//!
//! Lengths are in units of the displacement and times in units of the step, so that the oscillator x''
//! = -k x - c x' has k = w^2 dt^2 and c = 2 zeta w dt. Every quantity of a step is a row of
//! coefficients with respect to the state at the start of the step. The rows of the state at the end
//! form the matrix of the step.

use nalgebra::DMatrix;

/// An integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Explicit Euler.
    Euler,
    /// Symplectic Euler.
    SymplecticEuler,
    /// Taylor expansion, second order in the position.
    Taylor,
    /// Velocity Verlet: the new force uses the velocity v + a dt and is kept for the next step.
    VelocityVerlet,
    /// Beeman's predictor-corrector: the force uses the prediction and is kept for the next two steps.
    Beeman,
}

impl Method {
    /// Every method.
    pub const ALL: [Self; 5] = [
        Self::Euler,
        Self::SymplecticEuler,
        Self::Taylor,
        Self::VelocityVerlet,
        Self::Beeman,
    ];

    /// Size of its state: position, velocity and the accelerations that it keeps.
    pub fn dimension(self) -> usize {
        match self {
            Self::Euler | Self::SymplecticEuler | Self::Taylor => 2,
            Self::VelocityVerlet => 3,
            Self::Beeman => 4,
        }
    }
}

type Row = [f64; 4];

/// A weighted sum of rows.
fn sum<const N: usize>(terms: [(f64, Row); N]) -> Row {
    std::array::from_fn(|n| terms.iter().map(|(weight, row)| weight * row[n]).sum())
}

/// The matrix of one step for position, velocity and kept accelerations.
pub fn one_step(method: Method, k: f64, c: f64) -> DMatrix<f64> {
    let unit = |n: usize| std::array::from_fn(|m| f64::from(u8::from(n == m)));
    let [x, v, kept, older]: [Row; 4] = std::array::from_fn(unit);
    let force = |x: Row, v: Row| sum([(-k, x), (-c, v)]);
    let a = force(x, v);
    let rows = match method {
        Method::Euler => vec![sum([(1.0, x), (1.0, v)]), sum([(1.0, v), (1.0, a)])],
        Method::SymplecticEuler => {
            let after = sum([(1.0, v), (1.0, a)]);
            vec![sum([(1.0, x), (1.0, after)]), after]
        }
        Method::Taylor => vec![
            sum([(1.0, x), (1.0, v), (0.5, a)]),
            sum([(1.0, v), (1.0, a)]),
        ],
        Method::VelocityVerlet => {
            let after = sum([(1.0, x), (1.0, v), (0.5, kept)]);
            let new = force(after, sum([(1.0, v), (1.0, kept)]));
            vec![after, sum([(1.0, v), (0.5, kept), (0.5, new)]), new]
        }
        Method::Beeman => {
            let third = 1.0 / 3.0;
            let ahead = sum([
                (1.0, x),
                (1.0, v),
                (2.0 * third, kept),
                (-0.5 * third, older),
            ]);
            let new = force(ahead, sum([(1.0, v), (1.5, kept), (-0.5, older)]));
            vec![
                sum([(1.0, x), (1.0, v), (0.5 * third, new), (third, kept)]),
                sum([
                    (1.0, v),
                    (third, new),
                    (2.5 * third, kept),
                    (-0.5 * third, older),
                ]),
                new,
                kept,
            ]
        }
    };
    let size = method.dimension();
    DMatrix::from_fn(size, size, |row, column| rows[row][column])
}

/// Position and velocity after 0, 1, ... steps from the given ones; kept accelerations are initially
/// that of the start.
pub fn course(method: Method, k: f64, c: f64, start: [f64; 2], steps: usize) -> Vec<[f64; 2]> {
    let [x, v] = start;
    let a = -k * x - c * v;
    let size = method.dimension();
    let mut state = DMatrix::from_fn(size, 1, |row, _| [x, v, a, a][row]);
    let step = one_step(method, k, c);
    let mut course = vec![start];
    for _ in 0..steps {
        state = &step * state;
        course.push([state[0], state[1]]);
    }
    course
}

/// Moduli of the eigenvalues of one step, the largest first.
pub fn moduli(method: Method, k: f64, c: f64) -> Vec<f64> {
    let values = one_step(method, k, c).complex_eigenvalues();
    let mut moduli: Vec<f64> = values.iter().map(|z| z.re.hypot(z.im)).collect();
    moduli.sort_by(|a, b| b.total_cmp(a));
    moduli
}

/// Largest of the [`moduli`].
pub fn spectral_radius(method: Method, k: f64, c: f64) -> f64 {
    moduli(method, k, c).first().copied().unwrap_or(f64::NAN)
}

/// Coefficients of the characteristic polynomial from the highest power, by the Faddeev-LeVerrier
/// algorithm.
pub fn characteristic(method: Method, k: f64, c: f64) -> Vec<f64> {
    let matrix = one_step(method, k, c);
    let size = method.dimension();
    let identity = DMatrix::<f64>::identity(size, size);
    let mut coefficients = vec![1.0];
    let mut power = identity.clone();
    for n in 1..=size {
        let product = &matrix * &power;
        let coefficient = -product.trace() / n as f64;
        coefficients.push(coefficient);
        power = product + &identity * coefficient;
    }
    coefficients
}

/// The smallest step in s at which a mode of x'' = -k x - c x' grows by more than the given amount per
/// step; infinite without forces.
pub fn boundary(method: Method, [k, c]: [f64; 2], growth: f64) -> f64 {
    const GRID: u32 = 800;
    let rate = k.sqrt().max(c);
    if rate <= 0.0 {
        return f64::INFINITY;
    }
    let grows = |step: f64| spectral_radius(method, k * step * step, c * step) > 1.0 + growth;
    // No method is stable where the larger of w dt and c dt exceeds four, which Euler reaches at critical
    // damping.
    let at = |i: u32| 4.2 * f64::from(i) / (f64::from(GRID) * rate);
    let Some(first) = (1..=GRID).find(|&i| grows(at(i))) else {
        return f64::NAN;
    };
    let (mut low, mut high) = (at(first - 1), at(first));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if grows(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    low
}

/// All steps, in units of 1/w and up to the given one, at which growth of a mode begins or ends.
///
/// Beeman's method has three below 1.33 % of critical damping: its complex pair grows between the first
/// two.
pub fn crossings(method: Method, zeta: f64, longest: f64) -> Vec<f64> {
    const GRID: u32 = 800;
    let grows = |step: f64| spectral_radius(method, step * step, 2.0 * zeta * step) > 1.0 + 1e-12;
    let at = |i: u32| longest * f64::from(i) / f64::from(GRID);
    let changes = (1..GRID).filter(|&i| grows(at(i)) != grows(at(i + 1)));
    let locate = |i: u32| {
        let (mut low, mut high) = (at(i), at(i + 1));
        let before = grows(low);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if grows(middle) == before {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    };
    changes.map(locate).collect()
}

/// The stability limit w dt in closed form at a positive damping ratio, if there is one. For Beeman it
/// is the root of the polynomial at minus one; below 1.33 % of critical damping a complex pair becomes
/// unstable first, for which there is no closed form.
///
/// Euler: the determinant 1 - c + k reaches one, or above critical damping the smaller root of
/// 4 - 2 c + k = 0. Taylor: its determinant 1 - c + k/2 reaches one, or 4 - 2 c = 0. The others: the
/// polynomial at minus one vanishes, 4 - 2 c - k = 0, 4 - 4 c - k = 0, 12 - 20 c - 7 k = 0.
pub fn closed_boundary(method: Method, zeta: f64) -> Option<f64> {
    let root = |linear: f64, square: f64, constant: f64| {
        (-linear + (linear * linear + 4.0 * square * constant).sqrt()) / (2.0 * square)
    };
    match method {
        Method::Euler if zeta <= 1.0 => Some(2.0 * zeta),
        Method::Euler => Some(2.0 / (zeta + (zeta * zeta - 1.0).sqrt())),
        Method::SymplecticEuler => Some(root(4.0 * zeta, 1.0, 4.0)),
        Method::Taylor => Some((4.0 * zeta).min(1.0 / zeta)),
        Method::VelocityVerlet => Some(root(8.0 * zeta, 1.0, 4.0)),
        Method::Beeman if zeta >= 0.02 => Some(root(40.0 * zeta, 7.0, 12.0)),
        Method::Beeman => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Method, closed_boundary, moduli, one_step};
    use approx::{abs_diff_eq, assert_abs_diff_eq};

    #[test]
    fn an_undamped_oscillator_keeps_its_area_where_the_method_is_symplectic() {
        let determinant = one_step(Method::SymplecticEuler, 0.7, 0.0).determinant();
        assert_abs_diff_eq!(determinant, 1.0, epsilon = 1e-15);
        let verlet = moduli(Method::VelocityVerlet, 0.7, 0.0);
        assert!(
            abs_diff_eq!(verlet[0], 1.0, epsilon = 1e-12)
                && abs_diff_eq!(verlet[1], 1.0, epsilon = 1e-12)
        );
        assert_eq!(closed_boundary(Method::VelocityVerlet, 0.0), Some(2.0));
    }
}
