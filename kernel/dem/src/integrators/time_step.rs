//! Bounds of the time step: stability of each method, waves and cracks, thesis (59)-(62).

use super::method::Integrator;
use crate::material::Elastic;
use gouge_equations::rendered;

/// A damped oscillator. Every mode of interacting particles reduces to one.
///
/// $$ \ddot x = -\omega^2 x - 2 \zeta \omega\, \dot x $$
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    /// Squared angular frequency: stiffness divided by inertia, in 1/s^2.
    pub frequency_squared: f64,
    /// Damping coefficient divided by inertia, $2 \zeta \omega$, in 1/s.
    pub damping_rate: f64,
}

/// Characteristic polynomial of a step: its roots are the factors by which one step multiplies the modes of an
/// oscillator. Coefficients begin with the highest power.
///
/// `k` is (w dt)^2 and `c` is 2 zeta w dt, both dimensionless. The coefficients follow from writing one step as a
/// linear map and expanding its determinant. The map acts on position and velocity; for velocity Verlet also on
/// the acceleration, and for Beeman also on two accelerations. Velocity Verlet with forces at the half-step
/// velocity is symplectic Euler for that velocity.
pub fn characteristic_polynomial(integrator: Integrator, k: f64, c: f64) -> Vec<f64> {
    match integrator {
        Integrator::Euler => vec![1.0, c - 2.0, 1.0 - c + k],
        Integrator::SymplecticEuler | Integrator::VelocityVerletHalfStep => {
            vec![1.0, c + k - 2.0, 1.0 - c]
        }
        Integrator::Taylor => vec![1.0, c + 0.5 * k - 2.0, 1.0 - c + 0.5 * k],
        Integrator::VelocityVerlet => vec![1.0, k + 1.5 * c - 2.0, 1.0 - 2.0 * c, 0.5 * c],
        Integrator::Beeman => vec![
            1.0,
            7.0 * k / 6.0 + 11.0 * c / 6.0 - 2.0,
            1.0 - 0.5 * k - 3.0 * c,
            0.5 * k + 1.5 * c,
            -k / 6.0 - c / 3.0,
        ],
    }
}

/// Growth of a mode per step that still counts as stable, so that methods which conserve undamped amplitudes exactly
/// are accepted.
const GROWTH: f64 = 1e-9;

/// Whether no mode of an oscillator grows with the given time step in s.
pub fn is_stable(integrator: Integrator, oscillator: Oscillator, step: f64) -> bool {
    let mut polynomial = characteristic_polynomial(
        integrator,
        oscillator.frequency_squared * step * step,
        oscillator.damping_rate * step,
    );
    // Scaling the roots by 1 / (1 + growth) accepts roots up to the modulus 1 + growth.
    let mut scale = 1.0;
    for coefficient in polynomial.iter_mut() {
        *coefficient *= scale;
        scale /= 1.0 + GROWTH;
    }
    all_roots_inside(polynomial)
}

/// Schur-Cohn test: whether all roots lie strictly inside the unit circle.
fn all_roots_inside(mut polynomial: Vec<f64>) -> bool {
    while polynomial.len() > 1 {
        let (first, last) = (polynomial[0], polynomial[polynomial.len() - 1]);
        if last.abs() >= first.abs() {
            return false;
        }
        let ratio = last / first;
        let reversed: Vec<f64> = polynomial.iter().rev().copied().collect();
        for (coefficient, mirror) in polynomial.iter_mut().zip(reversed) {
            *coefficient -= ratio * mirror;
        }
        polynomial.pop();
    }
    true
}

/// Largest time step in s for which a method is stable for an oscillator; infinite without forces.
///
/// The smallest time step at which a mode begins to grow, found by a scan and bisection.
pub fn critical_step(integrator: Integrator, oscillator: Oscillator) -> f64 {
    let Oscillator {
        frequency_squared,
        damping_rate,
    } = oscillator;
    let rate = frequency_squared.sqrt().max(damping_rate);
    if rate <= 0.0 {
        return f64::INFINITY;
    }
    const SCAN: u32 = 4000;
    let step_at = |i: f64| i * 4.0 / (f64::from(SCAN) * rate);
    let first = (1..=SCAN).find(|&i| !is_stable(integrator, oscillator, step_at(f64::from(i))));
    let Some(first) = first else {
        return step_at(f64::from(SCAN));
    };
    let (mut low, mut high) = (step_at(f64::from(first - 1)), step_at(f64::from(first)));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if is_stable(integrator, oscillator, middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Whether a method is stable for an oscillator with a time step in s and with shorter ones, tried at a few of them: much
/// faster than [`critical_step`].
pub fn is_stable_below(integrator: Integrator, oscillator: Oscillator, step: f64) -> bool {
    const TRIED: u32 = 8;
    let tried = (1..=TRIED).map(|part| step * f64::from(part) / f64::from(TRIED));
    let mut tried =
        tried.filter(|_| oscillator.frequency_squared > 0.0 || oscillator.damping_rate > 0.0);
    tried.all(|step| is_stable(integrator, oscillator, step))
}

/// Time in s in which a primary wave crosses a particle with radius in m; an upper bound of the time step.
///
/// $$ \Delta t < \frac{2 R}{c^P} $$
///
/// Thesis eq. (61), with the density in kg/m^3.
#[rendered]
pub fn wave_bound(elastic: Elastic, density: f64, radius: f64) -> f64 {
    2.0 * radius / elastic.primary_wave_speed(density)
}

/// Time in s in which a crack with the given Mach number crosses a particle; an upper bound of the time step.
///
/// $$ \Delta t < \frac{2 R}{Ma\, c^P} $$
///
/// Thesis eq. (62), with radius in m and density in kg/m^3.
#[rendered]
pub fn crack_bound(elastic: Elastic, density: f64, radius: f64, mach_number: f64) -> f64 {
    wave_bound(elastic, density, radius) / mach_number
}
