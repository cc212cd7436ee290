//! Distributions compared with quadrature and samples.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use gouge_dem::distributions::{
    DENSEST_DISCS, Distribution, Power, Uniform, UniformProduct, UniformSum, WeakestProduct,
    Weibull, crystallises, discs_in_square, spheres_in_cube,
};
use gouge_dem::setup::SizeRange;
use rand::RngExt;
use rand_pcg::Pcg64;

/// Largest distance between the cumulative distribution and the empirical one of samples (Kolmogorov-Smirnov).
fn distance(law: &impl Distribution, mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    let n = samples.len() as f64;
    let gap = |(k, x): (usize, &f64)| {
        let f = law.cumulative(*x);
        (f - k as f64 / n).abs().max((f - (k + 1) as f64 / n).abs())
    };
    samples.iter().enumerate().map(gap).fold(0.0, f64::max)
}

/// Largest difference between the density and the slope of the cumulative distribution.
fn slope_error(law: &impl Distribution, low: f64, high: f64) -> f64 {
    let h = (high - low) * 1e-5;
    let at = |k: u32| low + (high - low) * (f64::from(k) + 0.37) / 997.0;
    let scale = (0..997).map(|k| law.density(at(k))).fold(0.0, f64::max);
    let error = |x: f64| {
        let slope = (law.cumulative(x + h) - law.cumulative(x - h)) / (2.0 * h);
        (slope - law.density(x)).abs() / scale
    };
    (0..997).map(|k| error(at(k))).fold(0.0, f64::max)
}

const N: usize = 100_000;
/// Kolmogorov's bound, which a correct law exceeds with probability 10^-8: sqrt(ln(2 10^8) / 2 N).
const BOUND: f64 = 9.78e-3;

#[test]
fn samples_follow_the_closed_form_distributions() {
    let mut random = Pcg64::new(1, 2);
    let mut draw = |u: &Uniform| u.low + (u.high - u.low) * random.random::<f64>();
    // Both orders of the cases of (122) and (124).
    let wide = Uniform {
        low: 0.8,
        high: 1.3,
    };
    let narrow = Uniform {
        low: 0.9,
        high: 1.1,
    };
    for (a, b) in [(wide, narrow), (narrow, wide)] {
        let pairs: Vec<(f64, f64)> = (0..N).map(|_| (draw(&a), draw(&b))).collect();
        let sums = pairs.iter().map(|(x, y)| x + y).collect();
        let products = pairs.iter().map(|(x, y)| x * y).collect();
        let squares = pairs.iter().map(|(x, y)| x * y * x * y).collect();
        assert!(distance(&UniformSum(a, b), sums) < BOUND);
        assert!(distance(&UniformProduct(a, b), products) < BOUND);
        let square = Power {
            of: UniformProduct(a, b),
            exponent: 2.0,
        };
        assert!(distance(&square, squares) < BOUND);
    }
    let weakest = WeakestProduct {
        radius: wide,
        factor: narrow,
    };
    let samples = (0..N)
        .map(|_| draw(&narrow) * draw(&wide).min(draw(&wide)))
        .collect();
    assert!(distance(&weakest, samples) < BOUND);
    // The single radius of the thesis gives another distribution, which exceeds the bound.
    let other = (0..N).map(|_| draw(&narrow) * draw(&wide)).collect();
    assert!(distance(&weakest, other) > 10.0 * BOUND);
}

#[test]
fn densities_are_derivatives_of_cumulative_distributions() {
    let a = Uniform {
        low: 0.8,
        high: 1.3,
    };
    let b = Uniform {
        low: 0.9,
        high: 1.1,
    };
    assert!(slope_error(&UniformSum(a, b), 1.5, 2.6) < 1e-3);
    assert!(slope_error(&UniformProduct(a, b), 0.6, 1.6) < 1e-3);
    assert!(
        slope_error(
            &Power {
                of: UniformProduct(a, b),
                exponent: 2.0
            },
            0.4,
            2.3
        ) < 1e-3
    );
    assert!(
        slope_error(
            &WeakestProduct {
                radius: a,
                factor: b
            },
            0.6,
            1.6
        ) < 1e-3
    );
    assert!(
        slope_error(
            &Weibull {
                location: 0.5,
                scale: 0.6,
                shape: 2.2
            },
            0.4,
            2.0
        ) < 1e-3
    );
}

/// The upper end of these supports is more than twice as large as a kink inside.
#[test]
fn densities_of_wide_ranges_are_derivatives_of_cumulative_distributions() {
    let b = Uniform {
        low: 0.9,
        high: 1.1,
    };
    let near_zero = Uniform {
        low: 0.0,
        high: 0.7,
    };
    assert!(slope_error(&UniformSum(near_zero, b), 0.8, 1.9) < 2e-3);
    let (wide, wider) = (
        Uniform {
            low: 0.3,
            high: 1.2,
        },
        Uniform {
            low: 0.2,
            high: 1.0,
        },
    );
    let weakest = WeakestProduct {
        radius: wide,
        factor: wider,
    };
    assert!(slope_error(&UniformProduct(wide, wider), 0.05, 1.3) < 2e-3);
    assert!(slope_error(&weakest, 0.05, 1.3) < 2e-3);
}

#[test]
fn moments_of_the_strength_of_the_thesis_match_quadrature() {
    let sizes = SizeRange::around(1.0);
    let radius = Uniform {
        low: sizes.minimum,
        high: sizes.maximum,
    };
    let factor = Uniform {
        low: 0.9,
        high: 1.1,
    };
    // Mean and coefficient of variation by quadrature of 1 - F and of 2 q (1 - F).
    let moments = |law: &dyn Distribution| {
        let (n, top) = (200_000, 2.0);
        let h = top / f64::from(n);
        let (mut first, mut second) = (0.0, 0.0);
        for k in 0..n {
            let q = (f64::from(k) + 0.5) * h;
            let above = 1.0 - law.cumulative(q);
            first += h * above;
            second += 2.0 * h * q * above;
        }
        (first, (second - first * first).sqrt() / first)
    };
    let (mean, spread) = moments(&Power {
        of: UniformProduct(radius, factor),
        exponent: 2.0,
    });
    assert!(
        abs_diff_eq!(mean, 1.013_18, epsilon = 1e-5)
            && abs_diff_eq!(spread, 0.228_76, epsilon = 1e-5),
        "{mean} {spread}"
    );
    let (mean, spread) = moments(&Power {
        of: WeakestProduct { radius, factor },
        exponent: 2.0,
    });
    assert!(
        abs_diff_eq!(mean, 0.898_42, epsilon = 1e-5)
            && abs_diff_eq!(spread, 0.210_12, epsilon = 1e-5),
        "{mean} {spread}"
    );
}

#[test]
fn weibull_moments_match_special_cases() {
    let exponential = Weibull {
        location: 1.0,
        scale: 2.0,
        shape: 1.0,
    };
    assert_abs_diff_eq!(exponential.mean(), 3.0, epsilon = 1e-12);
    assert_abs_diff_eq!(exponential.variance(), 4.0, epsilon = 1e-12);
    let rayleigh = Weibull {
        location: 0.0,
        scale: 2.0_f64.sqrt(),
        shape: 2.0,
    };
    assert_abs_diff_eq!(
        rayleigh.variance(),
        2.0 - std::f64::consts::FRAC_PI_2,
        epsilon = 1e-12
    );
}

#[test]
fn size_bounds_are_at_the_onset_of_ordering() {
    let sizes = SizeRange::around(1.0);
    let uniform = Uniform {
        low: sizes.minimum,
        high: sizes.maximum,
    };
    let relative = uniform.deviation() / uniform.mean();
    assert_abs_diff_eq!(uniform.mean(), 1.0, epsilon = 1e-15);
    assert_abs_diff_eq!(
        sizes.maximum / sizes.minimum,
        2.0_f64.sqrt(),
        epsilon = 1e-15
    );
    // The thesis prints 0.99; the exact value lies inside the ordering region.
    assert_abs_diff_eq!(relative, 0.099_057_6, epsilon = 1e-7);
    assert!(crystallises(relative) && !crystallises(0.1));
    let back = Uniform::with_moments(uniform.mean(), uniform.deviation());
    assert!(
        abs_diff_eq!(back.low, uniform.low, epsilon = 1e-15)
            && abs_diff_eq!(back.high, uniform.high, epsilon = 1e-15)
    );
}

#[test]
fn two_dimensions_need_sixty_one_times_fewer_particles() {
    assert_abs_diff_eq!(
        DENSEST_DISCS,
        std::f64::consts::PI / 12.0_f64.sqrt(),
        epsilon = 1e-15
    );
    let (flat, full) = (discs_in_square(0.1, 1e-3), spheres_in_cube(0.1, 1e-3));
    assert_abs_diff_eq!(full / flat, 6.0_f64.sqrt() / 4.0 * 100.0, epsilon = 1e-9);
    assert_eq!((full / flat).round(), 61.0);
}

/// Integral of a function over an interval by the midpoint rule.
fn quadrature(low: f64, high: f64, function: impl Fn(f64) -> f64) -> f64 {
    let n = 100_000;
    let h = (high - low) / f64::from(n);
    (0..n)
        .map(|k| h * function(low + (f64::from(k) + 0.5) * h))
        .sum()
}

#[test]
fn densities_of_functions_of_two_variables_match_integration() {
    let (wide, narrow) = (
        Uniform {
            low: 0.8,
            high: 1.3,
        },
        Uniform {
            low: 0.9,
            high: 1.1,
        },
    );
    for (a, b) in [(wide, narrow), (narrow, wide), (wide, wide)] {
        for x in [0.7, 0.75, 0.9, 1.1, 1.4, 1.6] {
            let given = |y: f64| a.density(y) * b.density(x / y) / y;
            let expected = quadrature(a.low, a.high, given);
            assert_abs_diff_eq!(UniformProduct(a, b).density(x), expected, epsilon = 2e-4);
        }
        for x in [1.65, 1.75, 2.0, 2.1, 2.35, 2.5] {
            let expected = quadrature(a.low, a.high, |y| a.density(y) * b.density(x - y));
            assert_abs_diff_eq!(UniformSum(a, b).density(x), expected, epsilon = 2e-4);
        }
    }
    // The smaller of two radii exceeds y if both radii do.
    let law = WeakestProduct {
        radius: wide,
        factor: narrow,
    };
    for x in [0.73, 0.8, 0.9, 1.0, 1.2, 1.4] {
        let exceeds = |y: f64| (1.0 - wide.cumulative(y)) * (1.0 - wide.cumulative(y));
        let expected = quadrature(narrow.low, narrow.high, |s| {
            narrow.density(s) * exceeds(x / s)
        });
        assert!(
            abs_diff_eq!(1.0 - law.cumulative(x), expected, epsilon = 1e-8),
            "{x}"
        );
    }
}

#[test]
fn distributions_have_no_mass_outside_their_support() {
    let (a, b) = (
        Uniform {
            low: 0.8,
            high: 1.3,
        },
        Uniform {
            low: 0.9,
            high: 1.1,
        },
    );
    let power = Power {
        of: UniformProduct(a, b),
        exponent: 2.0,
    };
    let weakest = WeakestProduct {
        radius: a,
        factor: b,
    };
    let weibull = Weibull {
        location: 0.5,
        scale: 0.5,
        shape: 5.0,
    };
    let laws: [&dyn Distribution; 6] = [
        &a,
        &UniformSum(a, b),
        &UniformProduct(a, b),
        &power,
        &weakest,
        &weibull,
    ];
    for law in laws {
        for x in [-1e12, -1.0, 0.0, 0.5] {
            assert_eq!([law.density(x), law.cumulative(x)], [0.0; 2]);
        }
        for x in [3.0, 1e3, 1e8, 1e9, 1e12, 1e100] {
            assert_eq!([law.density(x), law.cumulative(x)], [0.0, 1.0], "{x}");
        }
    }
}

#[test]
fn the_size_interval_of_the_thesis_has_ratio_root_two() {
    use gouge_dem::distributions::{relative_deviation_of_ratio, spheres_per_disc};
    let sizes = SizeRange::around(3.0);
    let uniform = Uniform {
        low: sizes.minimum,
        high: sizes.maximum,
    };
    let relative = relative_deviation_of_ratio(2.0_f64.sqrt());
    assert_abs_diff_eq!(relative, uniform.relative_deviation(), epsilon = 1e-15);
    assert_abs_diff_eq!(
        relative,
        3.0_f64.sqrt() - 24.0_f64.sqrt() / 3.0,
        epsilon = 1e-15
    );
    assert_abs_diff_eq!(spheres_per_disc(0.1, 1e-3), 61.237, epsilon = 1e-3);
}

#[test]
fn the_weibull_modulus_of_the_thesis_assumes_a_zero_location() {
    // Figure 8: coefficient of variation and skewness of the emergent strength.
    let spread = |shape: f64| {
        let law = Weibull {
            location: 0.0,
            scale: 1.0,
            shape,
        };
        law.variance().sqrt() / law.mean()
    };
    assert_abs_diff_eq!(spread(5.007), 0.228_76, epsilon = 1e-5);
    assert_abs_diff_eq!(spread(5.494), 0.210_12, epsilon = 1e-5);
    // Moments of a Weibull variable by quadrature of its survival.
    let law = Weibull {
        location: 0.465,
        scale: 0.6,
        shape: 2.533,
    };
    let first = quadrature(0.0, 4.0, |x| 1.0 - law.cumulative(x));
    let second = quadrature(0.0, 4.0, |x| 2.0 * x * (1.0 - law.cumulative(x)));
    assert_abs_diff_eq!(law.mean(), first, epsilon = 1e-8);
    assert_abs_diff_eq!(law.variance(), second - first * first, epsilon = 1e-8);
}
