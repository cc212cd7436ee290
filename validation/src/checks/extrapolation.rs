//! Results with several time steps, extrapolated to zero time step.

/// Richardson extrapolation. Each level has half the time step of the previous one, and the errors are
/// series in the time step with the given powers.
pub fn to_no_step<const N: usize>(mut levels: Vec<Vec<[f64; N]>>, powers: &[i32]) -> Vec<[f64; N]> {
    for &power in powers {
        let weight = 1.0 / (2.0_f64.powi(power) - 1.0);
        levels = levels
            .windows(2)
            .map(|pair| improved(&pair[0], &pair[1], weight))
            .collect();
    }
    levels.pop().unwrap_or_default()
}

fn improved<const N: usize>(coarse: &[[f64; N]], fine: &[[f64; N]], weight: f64) -> Vec<[f64; N]> {
    let one =
        |(a, b): (&[f64; N], &[f64; N])| std::array::from_fn(|n| b[n] + (b[n] - a[n]) * weight);
    coarse.iter().zip(fine).map(one).collect()
}
