//! Frequency and decay of a sampled oscillation.

use nalgebra::{Matrix2, Vector2};
use std::f64::consts::PI;

/// Phase advance per step of a free oscillation q_n = A sin(n theta), from q_0, q_1, ...; none if no
/// sample changes sign.
///
/// The recurrence q_{n+1} + q_{n-1} = 2 cos(theta) q_n gives a first value; the phase at the last
/// change of sign, divided by the number of steps until then, refines it.
pub fn turn_a_step(samples: &[f64]) -> Option<f64> {
    let (mut product, mut square) = (0.0, 0.0);
    for window in samples.windows(3) {
        product += window[1] * (window[0] + window[2]);
        square += 2.0 * window[1] * window[1];
    }
    let cosine = product / square;
    let sine = (1.0 - cosine * cosine).sqrt();
    let crosses = |&n: &usize| samples[n] * samples[n + 1] <= 0.0;
    let crossings: Vec<usize> = (1..samples.len() - 1).filter(crosses).collect();
    let n = *crossings.last()?;
    let upwards = (samples[n + 1] - samples[n]).signum();
    let quadrature = 0.5 * upwards * (samples[n + 1] - samples[n - 1]);
    let phase = (upwards * samples[n] * sine).atan2(quadrature);
    Some((PI * crossings.len() as f64 + phase) / n as f64)
}

/// Decay rate and angular frequency, times the step, of a damped oscillation, from the roots of the
/// recurrence q_{n+1} = a q_n - b q_{n-1} fitted by least squares.
pub fn decay_and_turn_a_step(samples: &[f64]) -> [f64; 2] {
    let (mut normal, mut right) = (Matrix2::zeros(), Vector2::zeros());
    for window in samples.windows(3) {
        let row = Vector2::new(window[1], -window[0]);
        normal += row * row.transpose();
        right += row * window[2];
    }
    let solved = normal.try_inverse().map(|inverse| inverse * right);
    let [a, b] = solved.map_or([f64::NAN; 2], |rule| [rule[0], rule[1]]);
    [-0.5 * b.ln(), (0.5 * a / b.sqrt()).acos()]
}

#[cfg(test)]
mod tests {
    use super::{decay_and_turn_a_step, turn_a_step};
    use approx::abs_diff_eq;

    #[test]
    fn both_find_what_was_put_in() {
        let free: Vec<f64> = (0..500).map(|n| (f64::from(n) * 0.1).sin()).collect();
        let turn = turn_a_step(&free).unwrap_or(f64::NAN);
        assert!(abs_diff_eq!(turn / 0.1, 1.0, epsilon = 1e-14), "{turn}");
        let damped: Vec<f64> = (0..80)
            .map(|n| (-0.02 * f64::from(n)).exp() * (f64::from(n) * 0.1).sin())
            .collect();
        let [decay, turn] = decay_and_turn_a_step(&damped);
        assert!(
            abs_diff_eq!(decay / 0.02, 1.0, epsilon = 1e-11)
                && abs_diff_eq!(turn / 0.1, 1.0, epsilon = 1e-11)
        );
    }
}
