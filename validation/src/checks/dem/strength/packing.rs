//! Strengths of the bonds of settled packings.

use super::distributions::{Laws, preferring};
use super::sampled::{distance, strength};
use crate::checks::{Axis, Curve, Exhibit, Failure, Figure, Measurement, Outcome, Table, largest};
use crate::oracles::emergent::Strength;
use crate::scenes::Draft;
use crate::scenes::packing::settled;
use gouge_dem::World;
use gouge_dem::distributions::Distribution;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli};
use gouge_runner::run::run_setup;
use rand::RngExt;
use rand_pcg::Pcg64;
use rayon::prelude::*;

/// A block of about 670 grains, made like the granite fault up to bonding.
fn draft(seed: u64) -> Draft {
    let (stiffness, damping) = (1e7, 10.0);
    settled(50e-3, seed)
        .law(AdjustedKelvinVoigt { stiffness, damping })
        .law(EulerBernoulli { stiffness, damping })
        .with("output.energy", false)
        .with("setup.bonding.reach", 1.224744871391589)
        .with("setup.bonding.strength_spread", 0.1)
}

/// Grains and bonds of a packing.
struct Block {
    /// Radii in m.
    radii: Vec<f64>,
    /// Bonded pairs and their strength factors.
    bonds: Vec<(usize, usize, f64)>,
}

impl Block {
    fn of(world: &World) -> Self {
        let links = world.bonds().map(|strong| strong.iter());
        let bond = |link: gouge_dem::bonds::Bond<f64>| {
            let (i, j) = link.pair.indices();
            (i, j, link.strength_factor)
        };
        Self {
            radii: world.particles().radius.clone(),
            bonds: links.into_iter().flatten().map(bond).collect(),
        }
    }
    fn strengths(&self) -> impl Iterator<Item = f64> {
        let one = |&(i, j, factor): &(usize, usize, f64)| {
            strength([self.radii[i], self.radii[j]], factor)
        };
        self.bonds.iter().map(one)
    }
    /// Number of bonds of each grain.
    fn degrees(&self) -> Vec<f64> {
        let mut degrees = vec![0.0; self.radii.len()];
        for &(i, j, _) in &self.bonds {
            degrees[i] += 1.0;
            degrees[j] += 1.0;
        }
        degrees
    }
    /// Mean square of the smaller radius over all pairs of grains, each grain weighted.
    fn paired(&self, weights: &[f64]) -> f64 {
        let (mut sum, mut total) = (0.0, 0.0);
        for (i, r) in self.radii.iter().enumerate() {
            for (j, s) in self.radii[..i].iter().enumerate() {
                let weight = weights[i] * weights[j];
                sum += weight * r.min(*s).powi(2);
                total += weight;
            }
        }
        sum / total
    }
    /// Mean square of the smaller radius over bonds.
    fn bonded(&self) -> f64 {
        let one = |&(i, j, _): &(usize, usize, f64)| self.radii[i].min(self.radii[j]).powi(2);
        self.bonds.iter().map(one).sum::<f64>() / self.bonds.len() as f64
    }
    /// Relative change of the number of bonds per relative change of radius, by linear regression.
    fn preference(&self) -> f64 {
        let degrees = self.degrees();
        let n = degrees.len() as f64;
        let mean = |all: &[f64]| all.iter().sum::<f64>() / n;
        let (r, z) = (mean(&self.radii), mean(&degrees));
        let pairs = self.radii.iter().zip(&degrees);
        let (mut common, mut own) = (0.0, 0.0);
        for (radius, degree) in pairs {
            common += (radius - r) * (degree - z);
            own += (radius - r) * (radius - r);
        }
        common / own * r / z
    }
}

fn block(seed: u64) -> Result<Block, Failure> {
    Ok(Block::of(&run_setup(&draft(seed).scene()?)?))
}

/// First seed: the claims were formulated with packings of smaller seeds.
const FRESH: u64 = 100;

fn blocks(number: u64) -> Result<Vec<Block>, Failure> {
    (FRESH..FRESH + number).into_par_iter().map(block).collect()
}

/// Largest distance from the law over the given number of redraws of radii and factors on the same
/// bonds: the random scatter when neighbouring bonds share grains.
fn critical(blocks: &[Block], redraws: u64) -> f64 {
    let law = Laws::granite().smaller;
    let (radius, factor) = (law.of.radius, law.of.factor);
    let one = |redraw: u64| {
        let mut random = Pcg64::new(u128::from(redraw), 53);
        let mut all = Vec::new();
        for block in blocks {
            let draw = |low: f64, high: f64, u: f64| low + (high - low) * u;
            let radii: Vec<f64> = (0..block.radii.len())
                .map(|_| draw(radius.low, radius.high, random.random()))
                .collect();
            all.extend(block.bonds.iter().map(|&(i, j, _)| {
                let factor = draw(factor.low, factor.high, random.random());
                (factor * radii[i].min(radii[j])).powi(2)
            }));
        }
        distance(&all, |q| law.cumulative(q))
    };
    let all: Vec<f64> = (0..redraws).into_par_iter().map(one).collect();
    largest(all)
}

fn pooled(blocks: &[Block]) -> Vec<f64> {
    blocks.iter().flat_map(Block::strengths).collect()
}

pub fn small() -> Outcome {
    let blocks = blocks(3)?;
    let samples = pooled(&blocks);
    let wide = critical(&blocks, 1000);
    let laws = Laws::granite();
    let missed = distance(&samples, |q| laws.single.cumulative(q)) <= wide;
    Ok(Measurement::worst([
        Measurement::absolute(
            0.0,
            distance(&samples, |q| laws.smaller.cumulative(q)),
            wide,
        ),
        Measurement::count(usize::from(missed)),
    ])
    .into())
}

/// Mean of numbers and its standard error.
fn mean_and_error(all: &[f64]) -> [f64; 2] {
    let n = all.len() as f64;
    let mean = all.iter().sum::<f64>() / n;
    let square = all.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    [mean, (square / n).sqrt()]
}

/// Results for the packings.
struct Facts {
    samples: usize,
    /// Distances to the laws of one radius, of the smaller of two radii, and of the smaller of two
    /// weighted radii.
    distances: [f64; 3],
    critical: f64,
    /// Mean square of the smaller radius over bonds, relative to that over random pairs, and its error.
    excess: [f64; 2],
    /// The same for pairs weighted by their numbers of bonds.
    explained: [f64; 2],
    preference: [f64; 2],
}

impl Facts {
    fn table(&self) -> Exhibit {
        let title = format!(
            "{} bonds of 32 settled packings: the smaller of two radii explains their strengths if grains are weighted by their numbers of bonds",
            self.samples
        );
        let mut table = Table::new(&title, &["quantity", "value"]);
        let with_error = |[mean, error]: [f64; 2]| format!("{mean:.4} +- {error:.4}");
        let [one, two, preferred] = self.distances.map(|d| format!("{d:.4}"));
        for (name, value) in [
            ("distance to the thesis's law, one radius", one),
            ("distance to the law of the smaller of two radii", two),
            (
                "distance to that law with radii weighted by numbers of bonds",
                preferred,
            ),
            (
                "largest distance over 300 redraws of all radii and factors",
                format!("{:.4}", self.critical),
            ),
            (
                "relative change of a grain's number of bonds per relative change of its radius",
                with_error(self.preference),
            ),
            (
                "mean square of the smaller radius, relative to random pairs",
                with_error(self.excess),
            ),
            (
                "the same for pairs weighted by their numbers of bonds",
                with_error(self.explained),
            ),
        ] {
            table.push([name.to_owned(), value]);
        }
        Exhibit::Table(table)
    }
}

fn histogram(samples: &[f64], law: &Strength) -> Exhibit {
    const BINS: usize = 50;
    let (low, high) = (law.corners()[0], law.corners()[3]);
    let width = (high - low) / BINS as f64;
    let mut counts = [0_u32; BINS];
    for q in samples {
        counts[(((q - low) / width) as usize).min(BINS - 1)] += 1;
    }
    let scale = samples.len() as f64 * width;
    let bars = counts.iter().enumerate();
    let bars = bars.map(|(n, count)| [low + (n as f64 + 0.5) * width, f64::from(*count) / scale]);
    let laws = Laws::granite();
    let at = |k: i32| low + (high - low) * f64::from(k) / 200.0;
    let line = |density: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        (0..=200).map(|k| [at(k), density(at(k))]).collect()
    };
    Exhibit::Figure(Figure::new(
        "Strengths of the bonds of settled packings follow the smaller radius",
        Axis::linear("strength relative to a mean grain with factor one", ""),
        Axis::linear("probability density", ""),
        vec![
            Curve::line("one radius", line(&|q| laws.single.density(q))),
            Curve::line("smaller of two radii", line(&|q| laws.smaller.density(q))),
            Curve::line(
                "radii weighted by numbers of bonds",
                line(&|q| law.density(q)),
            ),
            Curve::marks("packings", bars),
        ],
    ))
}

pub fn packings() -> Outcome {
    let blocks = blocks(32)?;
    let samples = pooled(&blocks);
    let wide = critical(&blocks, 300);
    let over = |value: fn(&Block) -> f64| -> Vec<f64> {
        let each = blocks
            .par_iter()
            .map(|block| value(block) / block.paired(&vec![1.0; block.radii.len()]));
        each.collect()
    };
    let (bonded, weighted) = (
        over(Block::bonded),
        over(|block| block.paired(&block.degrees())),
    );
    let left: Vec<f64> = bonded
        .iter()
        .zip(&weighted)
        .map(|(x, y)| x / y - 1.0)
        .collect();
    let preference = mean_and_error(&blocks.iter().map(Block::preference).collect::<Vec<f64>>());
    let law = preferring(2, preference[0]);
    let laws = Laws::granite();
    let distances = [
        distance(&samples, |q| laws.single.cumulative(q)),
        distance(&samples, |q| laws.smaller.cumulative(q)),
        distance(&samples, |q| law.cumulative(q)),
    ];
    let [rest, error] = mean_and_error(&left);
    let measurement = Measurement::worst([
        Measurement::absolute(0.0, distances[2], wide),
        Measurement::scaled(0.0, rest, error, 4.0),
        Measurement::count(usize::from(distances[1] <= wide)),
    ]);
    let facts = Facts {
        samples: samples.len(),
        distances,
        critical: wide,
        excess: mean_and_error(&bonded),
        explained: mean_and_error(&weighted),
        preference,
    };
    Ok(measurement.showing([facts.table(), histogram(&samples, &law)]))
}
