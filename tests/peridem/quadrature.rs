//! Quadrature as an oracle: the double exponential rule, which bears roots and logarithms at the ends.

use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

/// Distances from the nearer end, which end, and weights, for an interval of length one.
static RULE: LazyLock<Vec<(f64, bool, f64)>> = LazyLock::new(|| {
    let step = 1.0 / 14.0;
    (-46_i32..=46)
        .map(|k| {
            let t = step * f64::from(k);
            let u = FRAC_PI_2 * t.abs().sinh();
            let weight = step * FRAC_PI_2 * t.cosh() / (2.0 * u.cosh().powi(2));
            (1.0 / (1.0 + (2.0 * u).exp()), k < 0, weight)
        })
        .collect()
});

/// Integral over [a, b], or zero if b <= a.
pub fn integrate(a: f64, b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let length = (b - a).max(0.0);
    if length == 0.0 {
        return 0.0;
    }
    let sum: f64 = (RULE.iter())
        .map(|&(end, is_left, weight)| {
            let x = if is_left {
                a + length * end
            } else {
                b - length * end
            };
            weight * f(x)
        })
        .sum();
    sum * length
}

/// Integral over [a, b], divided at the given points.
pub fn integrate_pieces(a: f64, b: f64, cuts: &[f64], mut f: impl FnMut(f64) -> f64) -> f64 {
    let mut ends = vec![a, b];
    ends.extend(cuts.iter().filter(|&&cut| cut > a && cut < b));
    ends.sort_by(f64::total_cmp);
    (ends.windows(2))
        .map(|piece| integrate(piece[0], piece[1], &mut f))
        .sum()
}

/// Derivative by central differences of fourth order.
pub fn derivative(x: f64, step: f64, f: impl Fn(f64) -> f64) -> f64 {
    (8.0 * (f(x + step) - f(x - step)) - (f(x + 2.0 * step) - f(x - 2.0 * step))) / (12.0 * step)
}

/// Reproducible random numbers in [0, 1): splitmix64.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}
