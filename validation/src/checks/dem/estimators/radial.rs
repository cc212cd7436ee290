//! Radial distribution function and excess entropy.

use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::arcs::Rectangle;
use gouge_common::estimators::{RadialDistribution, Region, radial_distribution, visible_fraction};
use gouge_common::geometry::Vec2;
use rand::RngExt;
use rand_pcg::Pcg64;
use std::f64::consts::{E, PI};

pub fn checks() -> Vec<Check> {
    vec![visible(), rows(), edges(), entropy(), gas()]
}

fn visible() -> Check {
    Check {
        id: "estimators.radial.visible-part",
        claim: "The visible fraction of a circle is the sum of its arcs inside the region, for every combination of edges and corners that it crosses.",
        equations: thesis("(80)"),
        scene: "3000 random points each in a strip and in a box, 4 m wide and 1 m high, with circles of up to 1 m; and circles that miss an edge by a relative 5e-7",
        oracle: "Arcs between the intersections of the circle with the edges, counted if their midpoints are inside",
        norm: "Largest error of the fraction",
        origin: Origin::Exact,
        reason: "An arccosine loses at most 20 units in the last place if depth and distance differ by a thousandth, which the sampling ensures; a circle that misses all edges is exactly visible",
        effort: Effort::Quick,
        measure: measure_visible,
    }
}

fn measure_visible() -> Outcome {
    let mut random = Pcg64::new(17, 5);
    let mut all = Vec::new();
    for periodic in [true, false] {
        let (width, height) = (4.0, 1.0);
        let region = Region {
            width,
            height,
            periodic,
        };
        let oracle = Rectangle {
            width: (!periodic).then_some(width),
            height,
        };
        for _ in 0..3000 {
            let [x, y] = [width, height].map(|side| side * random.random::<f64>());
            let distance: f64 = random.random();
            let depths = [x, width - x, y, height - y];
            if depths
                .iter()
                .any(|depth| (depth / distance - 1.0).abs() < 1e-3)
            {
                continue;
            }
            let expected = oracle.fraction_inside([x, y], distance);
            let found = visible_fraction(&region, Vec2::new(x, y), distance);
            all.push(Measurement::absolute(expected, found, 20.0 * f64::EPSILON));
        }
        // A circle that just misses the lower edge; the other edges are farther away.
        let found = visible_fraction(&region, Vec2::new(2.0, 0.25 * (1.0 + 5e-7)), 0.25);
        all.push(Measurement::absolute(1.0, found, 0.0));
    }
    Ok(Measurement::worst(all).into())
}

/// Three rows in a periodic strip: one in the middle, with neighbours at 8 m; one near the lower edge,
/// with neighbours at 48/7 m, and the edge at half that distance; one above, with neighbours at 12 m,
/// the limit.
const WIDTH: f64 = 48.0;
const HEIGHT: f64 = 60.0;

fn three_rows() -> Vec<Vec2> {
    let low = WIDTH / 7.0;
    let middle = (0..6).map(|k| Vec2::new(8.0 * f64::from(k), 30.0));
    let edge = (0..7).map(|k| Vec2::new(low * f64::from(k), 0.5 * low));
    let high = (0..4).map(|k| Vec2::new(12.0 * f64::from(k), 45.0));
    middle.chain(edge).chain(high).collect()
}

fn rows() -> Check {
    Check {
        id: "estimators.radial.shells",
        claim: "The radial distribution of three distant rows has one shell per row, weighted by its number of pairs over the visible fraction of their circles, which is two thirds at the edge; of the shell at the limit, half is seen.",
        equations: thesis("(80)-(83)"),
        scene: "Six points in the middle of a periodic strip of 48 m by 60 m, seven near its edge, four above; bandwidth 1 m, 600 samples",
        oracle: "Parabolas of the Epanechnikov kernel around the three distances, with areas in the ratio 12 : 21 : 8, normalised by the sum over all samples",
        norm: "Largest error of the density of pairs, of the distance, and of g in units of the limit",
        origin: Origin::Exact,
        reason: "About a hundred roundings in sums and an arccosine",
        effort: Effort::Quick,
        measure: measure_rows,
    }
}

fn measure_rows() -> Outcome {
    let region = Region {
        width: WIDTH,
        height: HEIGHT,
        periodic: true,
    };
    let (samples, limit) = (600, 0.25 * WIDTH);
    let found = radial_distribution(&three_rows(), &region, 1.0, samples);
    let spacing = limit / samples as f64;
    let bump = |d: f64, at: f64| (1.0 - (d - at) * (d - at)).max(0.0);
    let shape = |d: f64| 12.0 * bump(d, 8.0) + 21.0 * bump(d, WIDTH / 7.0) + 8.0 * bump(d, limit);
    let distances: Vec<f64> = (0..samples)
        .map(|k| (2 * k + 1) as f64 * limit / (2 * samples) as f64)
        .collect();
    let area: f64 = distances.iter().map(|&d| shape(d)).sum::<f64>() * spacing;
    let mut all = vec![Measurement::relative(
        17.0 / (WIDTH * HEIGHT),
        found.number_density,
        1e-15,
    )];
    for (k, &d) in distances.iter().enumerate() {
        let density = shape(d) / area;
        // The mean of g over the disc of radius l/4 is one.
        let g = density * limit / (2.0 * d / limit);
        all.push(Measurement::relative(d, found.distance[k], 1e-15));
        all.push(Measurement::absolute(density, found.density[k], 1e-13));
        all.push(Measurement::scaled(g, found.g[k], limit, 1e-13));
    }
    let line = distances.iter().map(|&d| [d, shape(d) / area]);
    let marks = distances.iter().zip(&found.density).step_by(10);
    let plot = Figure::new(
        "Three rows appear as three parabolas; the row at the edge is weighted for its hidden part",
        Axis::linear("distance", "m"),
        Axis::linear("probability density of the distance of a pair", "1/m"),
        vec![
            Curve::line("theory", line),
            Curve::marks("estimator", marks.map(|(&d, &p)| [d, p])),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

fn edges() -> Check {
    Check {
        id: "estimators.radial.edges",
        claim: "Points beyond the edges of the region do not count; points on the edges do.",
        equations: thesis("(80)-(81)"),
        scene: "Points on each edge of a box of 40 m by 20 m, and points a relative 5e-7 beyond it; periodic in x or not",
        oracle: "The points inside, counted by hand",
        norm: "Error of the number of points in units in the last place",
        origin: Origin::Exact,
        reason: "One product and one quotient are rounded",
        effort: Effort::Quick,
        measure: measure_edges,
    }
}

fn measure_edges() -> Outcome {
    let (width, height) = (40.0, 20.0);
    let (wide, high) = (width * (1.0 + 5e-7), height * (1.0 + 5e-7));
    let mut all = Vec::new();
    // If x is periodic, only the two points below and above are outside.
    for (periodic, inside) in [(false, 5.0), (true, 7.0)] {
        let region = Region {
            width,
            height,
            periodic,
        };
        let points = [
            [1.0, 1.0],
            [0.0, 3.0],
            [width, 5.0],
            [7.0, 0.0],
            [9.0, height],
            [-2e-5, 7.0],
            [wide, 9.0],
            [11.0, -1e-5],
            [13.0, high],
        ];
        let points: Vec<Vec2> = points.iter().map(|&[x, y]| Vec2::new(x, y)).collect();
        let found = radial_distribution(&points, &region, 0.5, 10).number_density;
        all.push(Measurement::ulp(inside, found * (width * height), 2.0));
    }
    Ok(Measurement::worst(all).into())
}

fn entropy() -> Check {
    Check {
        id: "estimators.entropy.closed-forms",
        claim: "The excess entropy of a uniform g = e is minus half the number of points in the disc; in the printed form it is minus half the density times the radius. For g = 0 both have the same values.",
        equations: thesis("(69), (84)"),
        scene: "The integrand g log g - (g - 1) is one both for g = e and for g = 0; midpoints integrate the area of a disc exactly",
        oracle: "e log e - (e - 1) = 1, the value -1 of -(0 - 1) for g = 0 likewise in absolute terms, and the area of a disc, which midpoints integrate exactly",
        norm: "Relative error",
        origin: Origin::Exact,
        reason: "A thousand roundings in a sum of terms of the same sign",
        effort: Effort::Quick,
        measure: measure_entropy,
    }
}

fn measure_entropy() -> Outcome {
    let (samples, limit, number_density) = (1000_u32, 2.5, 3.0);
    let distance: Vec<f64> = (0..samples)
        .map(|k| limit * (f64::from(k) + 0.5) / f64::from(samples))
        .collect();
    let mut all = Vec::new();
    for g in [E, 0.0] {
        let flat = RadialDistribution {
            g: vec![g; distance.len()],
            density: Vec::new(),
            distance: distance.clone(),
            number_density,
        };
        let disc = -0.5 * number_density * PI * limit * limit;
        let printed = -0.5 * number_density * limit;
        all.push(Measurement::relative(disc, flat.excess_entropy(), 1e-12));
        all.push(Measurement::relative(
            printed,
            flat.excess_entropy_printed(),
            1e-12,
        ));
    }
    Ok(Measurement::worst(all).into())
}

fn gas() -> Check {
    Check {
        id: "estimators.radial.ideal-gas",
        claim: "The radial distribution of an ideal gas is one at all distances, both in a strip and in a box that cuts most circles.",
        equations: thesis("(80)-(83)"),
        scene: "1500 random points in 20 m by 6 m, periodic or not, 12 times each; bandwidth 0.25 m",
        oracle: "Independent points have no structure: g = 1",
        norm: "Largest deviation from one of the mean g over 12 gases, between 0.5 m and 4.5 m",
        origin: Origin::Statistical,
        reason: "A shell of the width of the kernel, 0.25 m / 0.6, holds 12 000 pairs at the smallest distance, so the mean over twelve gases has a counting error of 0.0026. Where the edges hide most of a circle, few pairs have large weights; the largest standard error found there is 0.0043. The tolerance of 0.02 is more than four of these: with about forty independent distances, a correct estimator fails for one seed in 1000, and an estimator that is off by 0.035 anywhere is rejected with a probability above 0.999",
        effort: Effort::Thorough,
        measure: measure_gas,
    }
}

fn measure_gas() -> Outcome {
    const GASES: usize = 12;
    let mut random = Pcg64::new(21, 4);
    let (mut all, mut curves, mut spread) = (Vec::new(), Vec::new(), 0.0_f64);
    for periodic in [true, false] {
        let region = Region {
            width: 20.0,
            height: 6.0,
            periodic,
        };
        let mut gases = Vec::new();
        for _ in 0..GASES {
            let mut point =
                || Vec2::new(20.0 * random.random::<f64>(), 6.0 * random.random::<f64>());
            let points: Vec<Vec2> = (0..1500).map(|_| point()).collect();
            gases.push(radial_distribution(&points, &region, 0.25, 100));
        }
        let mut points = Vec::new();
        for (k, &d) in gases[0].distance.iter().enumerate() {
            let values = || gases.iter().map(|gas| gas.g[k]);
            let mean = values().sum::<f64>() / GASES as f64;
            if (0.5..4.5).contains(&d) {
                let square = values().map(|g| (g - mean).powi(2)).sum::<f64>();
                spread = spread.max(square / (GASES * (GASES - 1)) as f64);
                all.push(Measurement::absolute(1.0, mean, 0.02));
            }
            points.push([d, mean]);
        }
        let label = if periodic {
            "strip, mean of 12"
        } else {
            "box, mean of 12"
        };
        curves.push(Curve::marks(label, points));
    }
    curves.insert(0, Curve::line("ideal gas", [[0.0, 1.0], [5.0, 1.0]]));
    let plot = Figure::new(
        "An ideal gas has no structure, even where most circles are cut",
        Axis::linear("distance", "m"),
        Axis::linear("radial distribution function", ""),
        curves,
    );
    let text = format!(
        "Largest standard error of a mean over {GASES} gases, estimated from their scatter: {:.4}.",
        spread.sqrt()
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot), Exhibit::Text(text)]))
}
