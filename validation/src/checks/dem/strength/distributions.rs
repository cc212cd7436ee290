//! Each distribution of the kernel, compared with an independent calculation.

use crate::checks::{Failure, Measurement, Outcome};
use crate::oracles::emergent::{Bounded, Join, Joined, Strength};
use crate::oracles::quadrature::integral;
use gouge_dem::distributions::{
    DENSEST_DISCS, DENSEST_SPHERES, Distribution, Power, Uniform, UniformProduct, UniformSum,
    WeakestProduct, Weibull, crystallises, discs_in_square, relative_deviation_of_ratio,
    spheres_in_cube, spheres_per_disc,
};
use gouge_dem::setup::SizeRange;
use nalgebra::{Matrix2, Matrix3};
use statrs::distribution::{Continuous, ContinuousCDF};
use statrs::statistics::Distribution as Moments;
use std::f64::consts::{PI, SQRT_2};

const TOLERANCE: f64 = 1e-11;

/// The two distributions of bond strength between granite grains, relative to the strength of mean
/// grains.
#[derive(Clone, Copy, Debug)]
pub struct Laws {
    /// The thesis's distribution, for a single radius.
    pub single: Power<UniformProduct>,
    /// The distribution that follows from the breaking criterion, for the smaller of two radii.
    pub smaller: Power<WeakestProduct>,
}

impl Laws {
    /// Radii of the thesis in units of their mean, factors between 0.9 and 1.1.
    pub fn granite() -> Self {
        let sizes = SizeRange::around(1.0);
        let radius = Uniform {
            low: sizes.minimum,
            high: sizes.maximum,
        };
        let factor = Uniform {
            low: 0.9,
            high: 1.1,
        };
        Self {
            single: Power {
                of: UniformProduct(radius, factor),
                exponent: 2.0,
            },
            smaller: Power {
                of: WeakestProduct { radius, factor },
                exponent: 2.0,
            },
        }
    }
}

/// The same distributions by integration: the largest radius is sqrt(2) times the smallest, and the
/// mean is one.
pub fn exact() -> [Strength; 2] {
    [1, 2].map(|number| preferring(number, 0.0))
}

/// Strength for the smallest of the given number of radii, where a preference makes larger radii more
/// frequent.
pub fn preferring(smallest_of: i32, preference: f64) -> Strength {
    let low = 2.0 * (SQRT_2 - 1.0);
    let radius = Bounded {
        interval: [low, low * SQRT_2],
        smallest_of,
        preference,
    };
    Strength::new(radius, [0.9, 1.1])
}

/// Points that cover an interval and a little more, and points just beside its ends.
fn points(low: f64, high: f64) -> impl Iterator<Item = f64> {
    let beside = [1.0 - 4e-7, 1.0 + 4e-7].map(|side| [low * side, high * side]);
    let spread = (-2..=42).map(move |k| low + (high - low) * (f64::from(k) + 0.137) / 40.0);
    spread.chain(beside.into_iter().flatten())
}

/// Compares densities, in units of their scale, and probabilities with the expected ones.
fn compare(
    all: &mut Vec<Measurement>,
    law: &impl Distribution,
    expected: impl Fn(f64) -> [f64; 2],
    [low, high]: [f64; 2],
) {
    for x in points(low, high) {
        let [density, cumulative] = expected(x);
        let scale = 1.0 / (high - low);
        all.push(Measurement::scaled(
            density,
            law.density(x),
            scale,
            TOLERANCE,
        ));
        all.push(Measurement::absolute(
            cumulative,
            law.cumulative(x),
            TOLERANCE,
        ));
    }
}

fn uniform([low, high]: [f64; 2]) -> Uniform {
    Uniform { low, high }
}

/// Sums, products and their powers, in both orders of the cases.
fn joined(all: &mut Vec<Measurement>) {
    for (a, b) in [
        ([0.8, 1.3], [0.9, 1.1]),
        ([0.9, 1.1], [0.8, 1.3]),
        ([0.4, 0.9], [1.5, 2.5]),
    ] {
        let of = |join, smallest_of| Joined {
            factor: b,
            other: Bounded::uniform(a, smallest_of),
            join,
        };
        let pair = |joined: Joined| move |x: f64| [joined.density(x), joined.cumulative(x)];
        let (u, v) = (uniform(a), uniform(b));
        let products = [a[0] * b[0], a[1] * b[1]];
        compare(
            all,
            &UniformSum(u, v),
            pair(of(Join::Sum, 1)),
            [a[0] + b[0], a[1] + b[1]],
        );
        compare(
            all,
            &UniformProduct(u, v),
            pair(of(Join::Product, 1)),
            products,
        );
        let weakest = WeakestProduct {
            radius: u,
            factor: v,
        };
        compare(all, &weakest, pair(of(Join::Product, 2)), products);
        let cube = Power {
            of: UniformProduct(u, v),
            exponent: 3.0,
        };
        let product = of(Join::Product, 1);
        let expected = |q: f64| {
            // Values far below the support are replaced by one that is still below it.
            let x = q.max(1e-3).cbrt();
            [product.density(x) / (3.0 * x * x), product.cumulative(x)]
        };
        compare(all, &cube, expected, products.map(|x| x * x * x));
    }
}

/// The sum of two uniform variables over the same short interval, a triangle, near its corners.
fn triangle(all: &mut Vec<Measurement>) {
    let (low, width) = (1.0, 1e-3);
    let law = UniformSum(uniform([low, low + width]), uniform([low, low + width]));
    let end = 2.0 * (low + width);
    all.push(Measurement::absolute(1.0, law.cumulative(end), 0.0));
    for corner in [2.0 * low, 2.0 * low + width, end] {
        for side in [1.0 - 4e-7, 1.0 + 4e-7] {
            let x = corner * side;
            // Distances from both ends in units of the width, which lose four digits.
            let [left, right] = [x - 2.0 * low, end - x].map(|d| d / width);
            let density = left.min(right).max(0.0);
            let cumulative = if left < 1.0 {
                0.5 * left.max(0.0).powi(2)
            } else {
                1.0 - 0.5 * right.max(0.0).powi(2)
            };
            let found = [law.density(x) * width, law.cumulative(x)];
            all.push(Measurement::absolute(density, found[0], TOLERANCE));
            all.push(Measurement::absolute(cumulative, found[1], TOLERANCE));
        }
    }
}

/// The two distributions of strength.
fn strengths(all: &mut Vec<Measurement>) {
    let (laws, [one, two]) = (Laws::granite(), exact());
    let ends = |law: &Strength| [law.corners()[0], law.corners()[3]];
    let pair = |law: Strength| move |q: f64| [law.density(q), law.cumulative(q)];
    compare(all, &laws.single, pair(one), ends(&one));
    compare(all, &laws.smaller, pair(two), ends(&two));
}

/// Moments and bounds of uniform variables, by integration.
fn uniforms(all: &mut Vec<Measurement>) {
    let relative = |expected, measured| Measurement::relative(expected, measured, TOLERANCE);
    for interval in [[0.8, 1.3], [2.0, 7.0]] {
        let law = uniform(interval);
        let [low, high] = interval;
        let mean = integral(low, high, |x| x) / (high - low);
        let square = integral(low, high, |x| (x - mean).powi(2)) / (high - low);
        let again = Uniform::with_moments(mean, square.sqrt());
        all.extend([
            relative(mean, law.mean()),
            relative(square.sqrt(), law.deviation()),
            relative(square.sqrt() / mean, law.relative_deviation()),
            relative(
                square.sqrt() / mean,
                relative_deviation_of_ratio(high / low),
            ),
            relative(low, again.low),
            relative(high, again.high),
        ]);
        let expected = |x: f64| {
            let inside = x.clamp(low, high);
            let density = if x == inside { 1.0 / (high - low) } else { 0.0 };
            [density, (inside - low) / (high - low)]
        };
        compare(all, &law, expected, interval);
    }
    // The threshold of crystallisation is 0.1, to the last digit.
    let wrong = usize::from(!crystallises(0.1_f64.next_down())) + usize::from(crystallises(0.1));
    all.push(Measurement::count(wrong));
}

/// Shifted Weibull variables, compared with another implementation.
fn weibulls(all: &mut Vec<Measurement>) -> Result<(), Failure> {
    for (location, scale, shape) in [(0.0, 1.1, 5.007), (0.55, 0.4, 1.89), (-1.0, 2.0, 0.7)] {
        let law = Weibull {
            location,
            scale,
            shape,
        };
        let other = statrs::distribution::Weibull::new(shape, scale)
            .map_err(|error| Failure::Oracle(error.to_string()))?;
        let at = |x: f64| {
            let u = x - location;
            [
                if u > 0.0 { other.pdf(u) } else { 0.0 },
                other.cdf(u.max(0.0)),
            ]
        };
        compare(all, &law, at, [location, location + 3.0 * scale]);
        let (Some(mean), Some(variance)) = (other.mean(), other.variance()) else {
            return Err(Failure::Oracle("no moments".to_owned()));
        };
        all.push(Measurement::relative(
            location + mean,
            law.mean(),
            TOLERANCE,
        ));
        all.push(Measurement::relative(variance, law.variance(), TOLERANCE));
    }
    Ok(())
}

/// Packing numbers: one disc per lattice cell, one sphere per lattice cell.
fn numbers(all: &mut Vec<Measurement>) {
    let relative = |expected, measured| Measurement::relative(expected, measured, TOLERANCE);
    let (side, radius) = (0.1_f64, 1e-3_f64);
    let step = 2.0 * radius;
    let (half, height) = (0.5 * step, step * (PI / 3.0).sin());
    let area = Matrix2::new(step, 0.0, half, height).determinant();
    let edge = step / SQRT_2;
    let volume = Matrix3::new(0.0, edge, edge, edge, 0.0, edge, edge, edge, 0.0).determinant();
    let (discs, spheres) = (side.powi(2) / area, side.powi(3) / volume);
    all.extend([
        relative(PI * radius * radius / area, DENSEST_DISCS),
        relative(4.0 / 3.0 * PI * radius.powi(3) / volume, DENSEST_SPHERES),
        relative(discs, discs_in_square(side, radius)),
        relative(spheres, spheres_in_cube(side, radius)),
        relative(spheres / discs, spheres_per_disc(side, radius)),
    ]);
}

pub fn distributions() -> Outcome {
    let mut all = Vec::new();
    joined(&mut all);
    triangle(&mut all);
    strengths(&mut all);
    uniforms(&mut all);
    weibulls(&mut all)?;
    numbers(&mut all);
    Ok(Measurement::worst(all).into())
}
