//! Minima of functions of a few variables.

/// Minimum near a starting point, by the Nelder-Mead simplex, restarted until the value no longer
/// decreases.
pub fn minimum<const N: usize>(
    start: [f64; N],
    spread: f64,
    function: impl Fn(&[f64; N]) -> f64,
) -> [f64; N] {
    let (mut best, mut value) = (start, function(&start));
    for _ in 0..20 {
        let found = descend(best, spread, &function);
        let lower = function(&found);
        let stays = value - lower <= 1e-15 * value.abs();
        if lower <= value {
            (best, value) = (found, lower);
        }
        if stays {
            break;
        }
    }
    best
}

/// One descent of a simplex around a start, with the given relative size, until it has shrunk to a
/// point.
fn descend<const N: usize>(
    start: [f64; N],
    spread: f64,
    function: &impl Fn(&[f64; N]) -> f64,
) -> [f64; N] {
    let corner = |n: usize| {
        let mut x = start;
        if n < N {
            x[n] *= 1.0 + spread;
        }
        (function(&x), x)
    };
    let mut simplex: Vec<(f64, [f64; N])> = (0..=N).map(corner).collect();
    for _ in 0..400 * N {
        simplex.sort_by(|a, b| a.0.total_cmp(&b.0));
        let size = (0..N).map(|n| ((simplex[N].1[n] - simplex[0].1[n]) / simplex[0].1[n]).abs());
        if size.fold(0.0, f64::max) < 1e-12 {
            break;
        }
        contract(&mut simplex, function);
    }
    simplex.sort_by(|a, b| a.0.total_cmp(&b.0));
    simplex[0].1
}

/// Replaces the worst corner of a sorted simplex, or contracts all corners towards the best.
fn contract<const N: usize>(simplex: &mut [(f64, [f64; N])], function: &impl Fn(&[f64; N]) -> f64) {
    let worst = simplex[N];
    let centre: [f64; N] =
        std::array::from_fn(|n| simplex[..N].iter().map(|(_, x)| x[n]).sum::<f64>() / N as f64);
    let along = |by: f64| {
        let x = std::array::from_fn(|n| centre[n] + by * (worst.1[n] - centre[n]));
        (function(&x), x)
    };
    let reflected = along(-1.0);
    let new = if reflected.0 < simplex[0].0 {
        let expanded = along(-2.0);
        if expanded.0 < reflected.0 {
            expanded
        } else {
            reflected
        }
    } else if reflected.0 < simplex[N - 1].0 {
        reflected
    } else if reflected.0 < worst.0 {
        along(-0.5)
    } else {
        along(0.5)
    };
    if new.0 < worst.0.min(reflected.0) || new.0 < simplex[N - 1].0 {
        simplex[N] = new;
        return;
    }
    let best = simplex[0].1;
    for corner in &mut simplex[1..] {
        let x = std::array::from_fn(|n| 0.5 * (best[n] + corner.1[n]));
        *corner = (function(&x), x);
    }
}

#[cfg(test)]
mod tests {
    use super::minimum;
    use approx::abs_diff_eq;

    #[test]
    fn a_bent_valley_is_followed_to_its_end() {
        let valley = |x: &[f64; 2]| (1.0 - x[0]).powi(2) + 100.0 * (x[1] - x[0] * x[0]).powi(2);
        let found = minimum([-1.2, 1.0], 0.1, valley);
        assert!(
            abs_diff_eq!(found[0], 1.0, epsilon = 1e-6)
                && abs_diff_eq!(found[1], 1.0, epsilon = 1e-6),
            "{found:?}"
        );
    }
}
