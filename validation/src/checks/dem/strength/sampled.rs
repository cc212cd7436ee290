//! Strengths of bonds made by the kernel, and their distance from distributions.

use super::distributions::{Laws, exact};
use crate::checks::{Axis, Curve, Exhibit, Figure, Measurement, Outcome, largest};
use crate::oracles::quadrature::root;
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::distributions::Distribution;
use gouge_dem::laws::ZhangEckert;
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::setup::{
    Arrangement, Lattice, REACH, SizeRange, bonds_within, draw_radii, strength_factors,
};
use rand::RngExt;
use rand_pcg::Pcg64;
use statrs::distribution::{Binomial, DiscreteCDF};
use std::f64::consts::PI;

/// Number of bonds that suffice, by the claim, to distinguish the laws.
const CLAIMED: usize = 100;
const COLUMNS: usize = 120;
const ROWS: usize = 100;

/// Force that breaks a bond, relative to a bond of factor one between mean grains of 1 mm, found by
/// bisection of the criterion.
pub fn strength(radii: [f64; 2], factor: f64) -> f64 {
    let law = ZhangEckert {
        normal_strength: 1.0 / (PI * 1e-6),
        tangential_strength: 1.0,
    };
    let breaks = |force: f64| {
        if law.breaks(force, 0.0, radii, factor) {
            1.0
        } else {
            -1.0
        }
    };
    root(0.0, 4.0, breaks)
}

/// Strengths of bonds without common grains: every second bond along the rows of a bonded lattice.
pub fn independent() -> Vec<f64> {
    let mut sizes = Pcg64::new(8, 50);
    let number = COLUMNS * ROWS;
    let radii = draw_radii(SizeRange::around(1e-3), number, || sizes.random::<f64>());
    let lattice = Lattice {
        arrangement: Arrangement::Hexagonal,
        pitch: 2e-3,
        columns: COLUMNS,
        origin: Vec2::zero(),
    };
    let particle = |(n, &radius): (usize, &f64)| Particle {
        position: lattice.point(n),
        velocity: Vec2::zero(),
        angle: 0.0,
        angular_velocity: 0.0,
        radius,
        density: 2700.0,
        inertia_factor: SPHERE_INERTIA_FACTOR,
        role: Role::Free,
    };
    let particles: Particles = radii.iter().enumerate().map(particle).collect();
    let domain = Domain {
        width: None,
        height: None,
        periodic: false,
    };
    let pairs = bonds_within(&particles, &domain, REACH);
    let mut random = Pcg64::new(8, 51);
    let factors = strength_factors(pairs.len(), 0.1, || random.random::<f64>());
    let all = pairs.iter().zip(factors);
    all.filter(|(pair, _)| pair.i % 2 == 0 && pair.j == pair.i + 1)
        .map(|(pair, factor)| strength([radii[pair.i as usize], radii[pair.j as usize]], factor))
        .collect()
}

/// Largest distance between the distribution of samples and a law.
pub fn distance(samples: &[f64], cumulative: impl Fn(f64) -> f64) -> f64 {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let gap = |(k, x): (usize, &f64)| {
        let f = cumulative(*x);
        largest([f - k as f64 / n, f - (k + 1) as f64 / n].map(f64::abs))
    };
    largest(sorted.iter().enumerate().map(gap))
}

/// Distance that the distribution of independent samples exceeds with at most the given probability, by
/// the Dvoretzky-Kiefer-Wolfowitz-Massart inequality.
fn bound(number: usize, probability: f64) -> f64 {
    ((2.0 / probability).ln() / (2.0 * number as f64)).sqrt()
}

/// Strength at which the two laws differ most (where their densities cross), and the probabilities
/// there for one radius and for the smaller of two.
pub fn farthest() -> [f64; 3] {
    let [one, two] = exact();
    let q = root(0.9, 1.1, |q| one.density(q) - two.density(q));
    [q, one.cumulative(q), two.cumulative(q)]
}

pub fn lattice() -> Outcome {
    let samples = independent();
    let expected = COLUMNS / 2 * ROWS;
    let laws = Laws::granite();
    let [_, one, two] = farthest();
    let wide = bound(samples.len(), 1e-6);
    Ok(Measurement::worst([
        Measurement::absolute(expected as f64, samples.len() as f64, 0.0),
        Measurement::absolute(
            0.0,
            distance(&samples, |q| laws.smaller.cumulative(q)),
            wide,
        ),
        Measurement::absolute(
            two - one,
            distance(&samples, |q| laws.single.cumulative(q)),
            wide,
        ),
    ])
    .into())
}

/// Lower bound of the power of the test of one law against samples of the other: the power of testing
/// the point of largest difference alone, exact by the binomial distribution.
fn least_power(number: usize, critical: f64) -> f64 {
    let [_, one, two] = farthest();
    let n = number as f64;
    let Ok(count) = Binomial::new(two, number as u64) else {
        return f64::NAN;
    };
    let within = |k: f64| count.cdf(k.floor().max(0.0) as u64);
    let low = n * (one - critical);
    let below = if low < 1.0 {
        0.0
    } else {
        within((low - 1.0).ceil())
    };
    1.0 - (within(n * (one + critical)) - below)
}

pub fn power() -> Outcome {
    const REPEATS: usize = 1000;
    let laws = Laws::granite();
    let mut random = Pcg64::new(8, 52);
    let [(a, b), (c, d)] =
        [laws.smaller.of.radius, laws.smaller.of.factor].map(|one| (one.low, one.high));
    let mut draw = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let (mut all, mut found, mut least) = (Vec::new(), Vec::new(), Vec::new());
    for number in [20, 30, 40, 60, 80, 100, 150, 200] {
        let critical = bound(number, 0.01);
        let mut rejected = 0;
        for _ in 0..REPEATS {
            let one = |_| (draw(c, d) * draw(a, b).min(draw(a, b))).powi(2);
            let samples: Vec<f64> = (0..number).map(one).collect();
            rejected += usize::from(distance(&samples, |q| laws.single.cumulative(q)) > critical);
        }
        let power = rejected as f64 / REPEATS as f64;
        let expected = least_power(number, critical);
        let deviation = (expected * (1.0 - expected) / REPEATS as f64).sqrt();
        all.push(Measurement {
            expected,
            measured: power,
            error: (expected - power).max(0.0),
            tolerance: 5.0 * deviation + 1.0 / REPEATS as f64,
        });
        if number == CLAIMED {
            all.push(Measurement::count(usize::from(power < 0.98)));
        }
        found.push([number as f64, power]);
        least.push([number as f64, expected]);
    }
    let plot = Figure::new(
        "A hundred independent bonds distinguish the two laws",
        Axis::logarithmic("number of bonds", ""),
        Axis::linear(
            "probability of rejecting the single radius at level 1 %",
            "",
        ),
        vec![
            Curve::line(
                "lower bound, from the point of largest difference alone",
                least,
            ),
            Curve::marks("simulated", found),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}
