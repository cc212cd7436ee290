//! Integrals, roots and limits of functions of one variable.

use std::f64::consts::FRAC_PI_2;

/// Number of nodes on each side of the middle.
const NODES: i32 = 60;
/// Distance between nodes in the transformed variable.
const STEP: f64 = 0.055;

/// Nodes and weights for integrals of functions that are analytic between the ends and may have roots
/// or logarithms at them.
///
/// The substitution x = tanh((pi/2) sinh u) makes the integrand decay doubly exponentially, and the
/// trapezoidal rule then converges exponentially: 1e-13 for smooth functions.
pub fn nodes(low: f64, high: f64) -> impl Iterator<Item = [f64; 2]> {
    let half = 0.5 * (high - low);
    (-NODES..=NODES).map(move |k| {
        let u = STEP * f64::from(k);
        let inner = FRAC_PI_2 * u.sinh();
        let weight = half * STEP * FRAC_PI_2 * u.cosh() / inner.cosh().powi(2);
        // Measured from the nearer end, which avoids cancellation.
        let from_end = half * 2.0 / (1.0 + (2.0 * inner.abs()).exp());
        let x = if k < 0 {
            low + from_end
        } else {
            high - from_end
        };
        [x, weight]
    })
}

/// The same, piecewise between points where the function is not analytic.
pub fn nodes_over(points: &[f64]) -> impl Iterator<Item = [f64; 2]> {
    points
        .windows(2)
        .filter(|pair| pair[1] > pair[0])
        .flat_map(|pair| nodes(pair[0], pair[1]))
}

/// Integral of a function between two points.
pub fn integral(low: f64, high: f64, function: impl Fn(f64) -> f64) -> f64 {
    integral_over(&[low, high], function)
}

/// Integral of a function, piecewise.
pub fn integral_over(points: &[f64], function: impl Fn(f64) -> f64) -> f64 {
    nodes_over(points)
        .map(|[x, weight]| weight * function(x))
        .sum()
}

/// The zero of a function that changes its sign once between two points, to the last digit.
pub fn root(low: f64, high: f64, function: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let rises = function(high) > 0.0;
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if (function(middle) > 0.0) == rises {
            high = middle;
        } else {
            low = middle;
        }
    }
}

/// The limit of results at successively halved arguments, whose errors are a sum of the given powers of
/// the argument.
///
/// The number of powers removed is one less than the number of results.
pub fn limit<const N: usize>(results: &[[f64; N]], powers: &[f64]) -> [f64; N] {
    let mut column = results.to_vec();
    for power in &powers[..results.len() - 1] {
        let weight = (power.exp2() - 1.0).recip();
        column = column
            .windows(2)
            .map(|pair| std::array::from_fn(|n| pair[1][n] + (pair[1][n] - pair[0][n]) * weight))
            .collect();
    }
    column.first().copied().unwrap_or([f64::NAN; N])
}

#[cfg(test)]
mod tests {
    use super::{integral, root};
    use approx::assert_abs_diff_eq;

    #[test]
    fn integrals_with_roots_and_logarithms_at_their_ends() {
        let circle = integral(0.0, 1.0, |x| (1.0 - x * x).sqrt());
        assert_abs_diff_eq!(circle, std::f64::consts::FRAC_PI_4, epsilon = 1e-14);
        let smooth = integral(1.0, 3.0, |x| x.exp());
        assert_abs_diff_eq!(
            smooth / (3.0_f64.exp() - 1.0_f64.exp()),
            1.0,
            epsilon = 1e-14
        );
        assert_abs_diff_eq!(integral(0.0, 1.0, f64::ln), -1.0, epsilon = 1e-14);
    }

    #[test]
    fn roots_are_found_in_either_direction() {
        assert_abs_diff_eq!(
            root(1.0, 2.0, |x| x * x - 2.0),
            2.0_f64.sqrt(),
            epsilon = 1e-15
        );
        assert_abs_diff_eq!(
            root(1.0, 2.0, |x| 2.0 - x * x),
            2.0_f64.sqrt(),
            epsilon = 1e-15
        );
    }
}
