//! Results of several steps, extrapolated to no step.

/// Rows of results with steps each half of the one before, whose errors are series in the step with the
/// given powers: Richardson's extrapolation through all of them.
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
