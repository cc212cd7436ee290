//! Thesis figure 8: densities of bond strengths.

use gouge_dem::distributions::{Distribution, Power, Uniform, WeakestProduct, Weibull};
use gouge_page::{Axis, Curve, Figure};
use std::f64::consts::{PI, SQRT_2};

/// Normal strength in Pa, and mean radius in m, of the thesis.
const STRENGTH: f64 = 280e6;
const RADIUS: f64 = 1e-3;
/// Shapes and scales in N of the Weibull distributions of the sweep.
const WEIBULL: [[f64; 2]; 2] = [[5.0, 860.7], [2.0, 891.8]];
/// Largest strength that is shown, in N, and the number of points.
const MOST: f64 = 2000.0;
const POINTS: usize = 400;

/// The density of the strengths that the factors of the thesis give, beside Weibull distributions of the same mean.
///
/// A bond breaks at Q = pi sigma (s min{r_i, r_j})^2, with factors s uniform in 1 +- 0.1 and independent radii r uniform
/// in the interval of thesis (66).
pub fn figure() -> Figure {
    let product = WeakestProduct {
        radius: Uniform {
            low: RADIUS * 2.0 / (1.0 + SQRT_2),
            high: RADIUS * 4.0 / (2.0 + SQRT_2),
        },
        factor: Uniform {
            low: 0.9,
            high: 1.1,
        },
    };
    let square = Power {
        of: product,
        exponent: 2.0,
    };
    let unit = PI * STRENGTH;
    let emergent = |q: f64| square.density(q / unit) / unit;
    let of_weibull = |[shape, scale]: [f64; 2]| {
        let law = Weibull {
            location: 0.0,
            scale,
            shape,
        };
        Curve::line(&format!("Weibull {shape}"), points(move |q| law.density(q)))
    };
    let curves = [Curve::line("factors of the thesis", points(emergent))];
    Figure::new(
        "Densities of the strengths of bonds, all with a mean of 790.3 N (thesis figure 8, with the smaller of two radii).",
        Axis::linear("strength", "N"),
        Axis::linear("density", "1/N"),
        curves.into_iter().chain(WEIBULL.map(of_weibull)).collect(),
    )
}

fn points(density: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
    let place = |point: usize| MOST * point as f64 / POINTS as f64;
    (0..=POINTS)
        .map(|point| [place(point), density(place(point))])
        .collect()
}
