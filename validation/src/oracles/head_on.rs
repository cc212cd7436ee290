//! Head-on collisions as dimensionless ordinary differential equations.

use super::flow::Flow;
use super::quadrature::{limit, root};
use num_traits::Float;
use xprec::Df64;

/// The result of a collision.
#[derive(Clone, Copy, Debug)]
pub struct Rebound<F> {
    /// Speed after the collision over speed before it.
    pub restitution: F,
    /// Time from touch to the end of the force.
    pub duration: F,
    /// Largest overlap.
    pub depth: F,
}

fn number<F: Float>(value: f64) -> F {
    F::from(value).unwrap_or_else(F::nan)
}

/// A damped spring, x'' = -(x + 2 zeta x'), from x = 0 at unit speed until the force vanishes.
///
/// It is integrated so that the closed form can be compared with it.
pub fn spring<F: Float>(zeta: F, tolerance: F) -> Rebound<F> {
    let doubled = zeta + zeta;
    let flow = Flow {
        rate: |_: F, y: &[F; 2]| [y[1], -(y[0] + doubled * y[1])],
        tolerance,
    };
    let latest = number(4.0);
    let (_, deepest) = flow.until([F::zero(), F::one()], latest, |_, y| y[1]);
    let (duration, end) = flow.until([F::zero(), F::one()], latest, |_, y| y[0] + doubled * y[1]);
    Rebound {
        restitution: -end[1],
        duration,
        depth: deepest[0],
    }
}

/// Viscoelastic spheres, x'' = -(x + b x') sqrt(x), from x = 0 at unit speed until the force vanishes.
///
/// Lengths are in units of (v^2 / kappa)^(2/5) and times in units of that length over v, with v the
/// impact speed and kappa the prefactor of the force over the reduced mass; b is then the dissipative
/// constant times kappa^(2/5) v^(1/5).
///
/// The square root is not smooth at touch. There, the square root y of the overlap replaces time as the
/// variable: dv/dy = -2 y^2 (y^2 / v + b) and dt/dy = 2 y / v are smooth as long as v is not zero.
pub fn viscoelastic<F: Float>(b: F, tolerance: F) -> Rebound<F> {
    let half = number::<F>(0.5);
    let (entered, y, speed) = enter(b, tolerance, half);
    let flow = Flow {
        rate: |_: F, s: &[F; 2]| {
            let y = s[0].max(F::zero()).sqrt();
            [s[1], -(s[0] + b * s[1]) * y]
        },
        tolerance,
    };
    let latest = number(16.0);
    let (slowed, deepest) = flow.until([y * y, speed], latest, |_, s| s[1]);
    let (turned, back) = flow.until(deepest, latest, |_, s| (s[1] + half).min(s[0] + b * s[1]));
    let (left, end) = if back[1] > -half {
        (F::zero(), back[1])
    } else {
        leave(b, tolerance, back)
    };
    Rebound {
        restitution: -end,
        duration: entered + slowed + turned + left,
        depth: deepest[0],
    }
}

/// From touch until the speed has fallen to a value: time, square root of the overlap, and speed.
fn enter<F: Float>(b: F, tolerance: F, until: F) -> (F, F, F) {
    let flow = Flow {
        rate: |y: F, s: &[F; 2]| {
            let twice = y + y;
            [-twice * y * (y * y / s[0] + b), twice / s[0]]
        },
        tolerance,
    };
    let (y, end) = flow.until([F::one(), F::zero()], number(2.0), |_, s| s[0] - until);
    (end[1], y, end[0])
}

/// From an overlap and a negative speed until the force vanishes: time and speed.
fn leave<F: Float>(b: F, tolerance: F, from: [F; 2]) -> (F, F) {
    let start = from[0].sqrt();
    let flow = Flow {
        rate: |gone: F, s: &[F; 2]| {
            let y = start - gone;
            let twice = y + y;
            [twice * y * (y * y / s[0] + b), -twice / s[0]]
        },
        tolerance,
    };
    let ends = |gone: F, s: &[F; 2]| start - gone - (b * -s[0]).max(F::zero()).sqrt();
    let (_, end) = flow.until([from[1], F::zero()], start, ends);
    (end[1], end[0])
}

/// Dissipation b for which viscoelastic spheres have a given restitution, by bisection of the
/// integration.
pub fn dissipation_for(restitution: f64) -> f64 {
    root(0.0, 100.0, |b| {
        viscoelastic(b, 1e-14).restitution - restitution
    })
}

/// Coefficients of b and b^2 in the restitution, from integrations with successively halved b.
///
/// The series continues with half powers, 5/2, 3, 7/2, ..., because the force ends before the overlap
/// does.
pub fn series() -> [f64; 2] {
    let slopes: Vec<[f64; 2]> = (0..9)
        .map(|level| {
            let b = 0.25 * 0.5_f64.powi(level);
            let loss = viscoelastic(Df64::from(b), Df64::from(1e-22)).restitution - 1.0;
            [b, f64::from(loss) / b]
        })
        .collect();
    let values: Vec<[f64; 1]> = slopes.iter().map(|[_, slope]| [*slope]).collect();
    let [first] = limit(&values, &[1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5]);
    let values: Vec<[f64; 1]> = slopes.iter().map(|[b, s]| [(s - first) / b]).collect();
    let [second] = limit(&values, &[0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0]);
    [first, second]
}

#[cfg(test)]
mod tests {
    use super::{spring, viscoelastic};
    use crate::oracles::oscillator::{truncated_duration, truncated_restitution};
    use approx::abs_diff_eq;
    use statrs::function::beta::beta;
    use xprec::Df64;

    #[test]
    fn the_closed_form_of_the_spring_is_its_integral() {
        for zeta in [0.0, 0.05, 0.6, 0.75, 0.999, 1.0, 1.001, 3.0, 20.0] {
            let zeta = Df64::from(zeta);
            let found = spring(zeta, Df64::from(1e-27));
            let restitution: Df64 = truncated_restitution(zeta);
            let errors = [
                found.restitution / restitution - 1.0,
                found.duration / truncated_duration(zeta) - 1.0,
                found.depth / restitution.sqrt() - 1.0,
            ];
            for error in errors {
                assert!(f64::from(error).abs() < 1e-23, "{zeta:?}: {error:?}");
            }
        }
    }

    #[test]
    fn elastic_spheres_follow_hertz() {
        let found = viscoelastic(0.0_f64, 1e-14);
        let depth = 1.25_f64.powf(0.4);
        let duration = 0.8 * depth * beta(0.4, 0.5);
        assert!(
            abs_diff_eq!(found.restitution, 1.0, epsilon = 1e-13),
            "{found:?}"
        );
        assert!(
            abs_diff_eq!(found.duration / duration, 1.0, epsilon = 1e-13),
            "{found:?}"
        );
        assert!(
            abs_diff_eq!(found.depth / depth, 1.0, epsilon = 1e-13),
            "{found:?}"
        );
    }

    #[test]
    fn double_and_double_double_agree() {
        for b in [1e-3_f64, 0.1, 0.5, 2.0, 10.0] {
            let found = viscoelastic(b, 1e-14);
            let exact = viscoelastic(Df64::from(b), Df64::from(1e-24));
            for (rough, fine) in [
                (found.restitution, exact.restitution),
                (found.duration, exact.duration),
                (found.depth, exact.depth),
            ] {
                assert!(
                    abs_diff_eq!(rough / f64::from(fine), 1.0, epsilon = 1e-12),
                    "{b}: {rough}"
                );
            }
        }
    }
}
