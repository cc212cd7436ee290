//! The Weibull distributions closest to the strengths, and figure 8 of the thesis.

use super::distributions::{Laws, exact};
use super::sampled::independent;
use crate::checks::{Axis, Curve, Exhibit, Figure, Measurement, Outcome, Table, largest};
use crate::oracles::emergent::Strength;
use crate::oracles::minimum::minimum;
use crate::oracles::quadrature::{nodes_over, root};
use gouge_dem::distributions::{Distribution, Weibull};
use statrs::distribution::{Continuous, ContinuousCDF};
use statrs::function::gamma::gamma;

/// Strength, weight in an integral, density and probability of a distribution.
type Nodes = Vec<[f64; 4]>;
/// Density and probability of a Weibull variable with the given shape, scale and location.
type Form = fn(&[f64; 3], f64) -> [f64; 2];

/// A distribution at the nodes of an integral over its range.
fn tabulate(law: &Strength, at: impl Fn(f64) -> [f64; 2]) -> Nodes {
    let row = |[q, weight]: [f64; 2]| {
        let [density, cumulative] = at(q);
        [q, weight, density, cumulative]
    };
    nodes_over(&law.corners()).map(row).collect()
}

fn of_kernel([shape, scale, location]: &[f64; 3], q: f64) -> [f64; 2] {
    let law = Weibull {
        location: *location,
        scale: *scale,
        shape: *shape,
    };
    [law.density(q), law.cumulative(q)]
}

fn of_library([shape, scale, location]: &[f64; 3], q: f64) -> [f64; 2] {
    let u = (q - location).max(0.0);
    statrs::distribution::Weibull::new(*shape, *scale)
        .map_or([f64::NAN; 2], |law| [law.pdf(u), law.cdf(u)])
}

/// Measure of the distance of a fitted Weibull distribution from another distribution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sense {
    /// Relative entropy of the distribution with respect to the fit.
    Entropy,
    /// Mean square of the difference of probabilities.
    Squares,
}

impl Sense {
    fn distance(self, nodes: &Nodes, fit: &[f64; 3], form: Form) -> f64 {
        let term = |[q, weight, density, cumulative]: &[f64; 4]| {
            let [fitted, probability] = form(fit, *q);
            weight
                * density
                * match self {
                    Self::Squares => (cumulative - probability).powi(2),
                    // The density vanishes at the ends of the range, where the term is zero.
                    Self::Entropy if *density <= 0.0 => 0.0,
                    Self::Entropy => (density / fitted).ln(),
                }
        };
        let sum: f64 = nodes.iter().map(term).sum();
        if sum.is_nan() { f64::INFINITY } else { sum }
    }

    /// The closest Weibull distribution, with a free location or with location zero.
    fn fit(self, nodes: &Nodes, form: Form, located: bool) -> [f64; 3] {
        if located {
            return minimum([2.0, 0.45, 0.5], 0.1, |fit| self.distance(nodes, fit, form));
        }
        let [shape, scale] = minimum([5.0, 1.0], 0.1, |&[shape, scale]| {
            self.distance(nodes, &[shape, scale, 0.0], form)
        });
        [shape, scale, 0.0]
    }

    fn name(self, located: bool) -> &'static str {
        match (self, located) {
            (Self::Entropy, false) => "relative entropy, two parameters",
            (Self::Entropy, true) => "relative entropy, three parameters",
            (Self::Squares, false) => "Cramer-von Mises, two parameters",
            (Self::Squares, true) => "Cramer-von Mises, three parameters",
        }
    }
}

/// Largest difference between the probabilities of a distribution and a fit.
fn farthest(nodes: &Nodes, fit: &[f64; 3]) -> f64 {
    let gap = |[q, _, _, cumulative]: &[f64; 4]| (cumulative - of_kernel(fit, *q)[1]).abs();
    largest(nodes.iter().map(gap))
}

/// Two-parameter Weibull distribution with the given mean and coefficient of variation, from the
/// kernel's moments.
fn by_variation(mean: f64, variation: f64) -> [f64; 3] {
    let unit = |shape: f64| Weibull {
        location: 0.0,
        scale: 1.0,
        shape,
    };
    let excess = |shape: f64| unit(shape).variance().sqrt() / unit(shape).mean() - variation;
    let shape = root(1.0, 20.0, excess);
    [shape, mean / unit(shape).mean(), 0.0]
}

/// The Weibull shape with the given coefficient of variation, from gamma functions.
fn shape_of(variation: f64) -> f64 {
    let moment = |n: f64, shape: f64| gamma(1.0 + n / shape).ln();
    let wanted = (variation * variation).ln_1p();
    root(1.0, 20.0, |shape| {
        moment(2.0, shape) - 2.0 * moment(1.0, shape) - wanted
    })
}

/// Mean and coefficient of variation of a distribution of the kernel, by quadrature of its density.
fn kernel_moments(nodes: &Nodes) -> [f64; 2] {
    let moment = |n: i32| -> f64 { nodes.iter().map(|[q, w, f, _]| w * f * q.powi(n)).sum() };
    let mean = moment(1);
    [mean, (moment(2) - mean * mean).sqrt() / mean]
}

/// Both distributions: name, exact distribution, and its nodes from the kernel and from integration.
fn laws() -> [(&'static str, Strength, [Nodes; 2]); 2] {
    let (laws, [one, two]) = (Laws::granite(), exact());
    let single = |q: f64| [laws.single.density(q), laws.single.cumulative(q)];
    let smaller = |q: f64| [laws.smaller.density(q), laws.smaller.cumulative(q)];
    let by = |law: Strength| move |q: f64| [law.density(q), law.cumulative(q)];
    [
        (
            "one radius",
            one,
            [tabulate(&one, single), tabulate(&one, by(one))],
        ),
        (
            "smaller of two radii",
            two,
            [tabulate(&two, smaller), tabulate(&two, by(two))],
        ),
    ]
}

pub fn variation() -> Outcome {
    let all = laws().into_iter().flat_map(|(_, law, [nodes, _])| {
        let [mean, variation] = kernel_moments(&nodes);
        let [shape, scale, _] = by_variation(mean, variation);
        let expected = shape_of(law.variation());
        let tail = law.moment(1.0) / gamma(1.0 + 1.0 / expected);
        [
            Measurement::relative(law.moment(1.0), mean, 1e-10),
            Measurement::relative(tail, scale, 1e-10),
            Measurement::relative(expected, shape, 1e-10),
        ]
    });
    Ok(Measurement::worst(all).into())
}

pub fn weibull() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Weibull distributions closest to the two exact distributions of strength: with a free location the modulus is near two; a modulus of five requires a location of zero",
        &[
            "distribution",
            "closest in",
            "modulus k",
            "location",
            "scale",
            "relative entropy",
            "largest difference",
        ],
    );
    let mut curves = figure();
    for (name, _, [kernel, exact]) in laws() {
        let mut row = |method: &str, fit: &[f64; 3]| {
            table.push([
                name.to_owned(),
                method.to_owned(),
                format!("{:.4}", fit[0]),
                format!("{:.4}", fit[2]),
                format!("{:.4}", fit[1]),
                format!("{:.5}", Sense::Entropy.distance(&kernel, fit, of_kernel)),
                format!("{:.4}", farthest(&kernel, fit)),
            ]);
        };
        let [mean, variation] = kernel_moments(&kernel);
        row(
            "mean and variation, two parameters",
            &by_variation(mean, variation),
        );
        for located in [false, true] {
            for sense in [Sense::Entropy, Sense::Squares] {
                let fit = sense.fit(&kernel, of_kernel, located);
                let expected = sense.fit(&exact, of_library, located);
                let pairs = expected.iter().zip(fit);
                all.extend(pairs.map(|(&x, y)| Measurement::absolute(x, y, 1e-5)));
                if located && fit[0] > 3.0 {
                    all.push(Measurement::count(1));
                }
                row(sense.name(located), &fit);
                if located && sense == Sense::Entropy {
                    curves.push(dashed(name, &fit));
                }
            }
        }
    }
    curves.push(dashed("k = 5, location zero, by variation", &thesis_fit()));
    let plot = Figure::new(
        "Figure 8 of the thesis redrawn: the strengths of bonds, the thesis's curve, and Weibull distributions",
        Axis::linear("strength relative to a mean grain with factor one", ""),
        Axis::linear("probability density", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot), Exhibit::Table(table)]))
}

fn thesis_fit() -> [f64; 3] {
    let [(_, _, [single, _]), _] = laws();
    let [mean, variation] = kernel_moments(&single);
    by_variation(mean, variation)
}

/// Both exact densities, and the histogram of independent bonds of a lattice.
fn figure() -> Vec<Curve> {
    const BINS: usize = 40;
    let samples = independent();
    let [one, two] = exact();
    let (low, high) = (two.corners()[0], two.corners()[3]);
    let width = (high - low) / BINS as f64;
    let bar = |bin: usize| {
        let left = low + width * bin as f64;
        let inside = samples.iter().filter(|&&q| q >= left && q < left + width);
        [
            left + 0.5 * width,
            inside.count() as f64 / (samples.len() as f64 * width),
        ]
    };
    let laws = Laws::granite();
    let at = |k: i32| low + (high - low) * f64::from(k) / 200.0;
    let line = |density: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        (0..=200).map(|k| [at(k), density(at(k))]).collect()
    };
    vec![
        Curve::line(
            "one radius, as in the thesis",
            line(&|q| laws.single.density(q)),
        ),
        Curve::line(
            "smaller of two radii, as for bonds",
            line(&|q| laws.smaller.density(q)),
        ),
        Curve::marks("6000 bonds of a lattice", (0..BINS).map(bar)),
        Curve::marks(
            "integrated",
            (1..10).flat_map(|k| {
                let q = at(20 * k);
                [[q, one.density(q)], [q, two.density(q)]]
            }),
        ),
    ]
}

fn dashed(name: &str, fit: &[f64; 3]) -> Curve {
    let points = (0..=150).map(|k| {
        let q = 0.4 + 1.4 * f64::from(k) / 150.0;
        [q, of_kernel(fit, q)[0]]
    });
    Curve::dashed(&format!("Weibull, {name}, k = {:.2}", fit[0]), points)
}
