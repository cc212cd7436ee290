//! Bonds break at the strengths that a scene asks for.

use crate::worlds::{advance, bits, scene, world};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, ZhangEckert};
use gouge_dem::model::Yielding;
use gouge_runner::run::run_setup;
use gouge_runner::scene::Scene;
use gouge_validation::scenes::{Bond, Draft, Grain};
use std::f64::consts::PI;
use std::path::Path;

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1e7;
/// Strengths in Pa: in compression, in shear, in tension.
const COMPRESSIVE: f64 = 280e6;
const TANGENTIAL: f64 = 168e6;
const TENSILE: f64 = 20e6;

fn yielding(tensile_strength: Option<f64>) -> Yielding {
    Yielding {
        law: ZhangEckert {
            normal_strength: COMPRESSIVE,
            tangential_strength: TANGENTIAL,
        },
        tensile_strength,
        unbreakable_edges: false,
    }
}

fn bonded(yielding: Yielding) -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .law(yielding)
}

/// How a bond is loaded.
#[derive(Clone, Copy, Debug)]
enum Load {
    Tension,
    Compression,
    Shear,
}

/// Whether a bond with a strength factor breaks at once under a force in N.
fn breaks(yielding: Yielding, radii: [f64; 2], factor: f64, load: Load, force: f64) -> bool {
    let distance = radii[0] + radii[1];
    // Both ends turned by the same angle a carry the tangential force k a (r^2 + s^2) / D.
    let squares = radii[0] * radii[0] + radii[1] * radii[1];
    let (stretch, angle) = match load {
        Load::Tension => (force / STIFFNESS, 0.0),
        Load::Compression => (-force / STIFFNESS, 0.0),
        Load::Shear => (0.0, force * distance / (STIFFNESS * squares)),
    };
    let bond = Bond::between(0, 1)
        .of_strength(factor)
        .of_length(distance - stretch)
        .since([-angle, PI - angle]);
    let draft = bonded(yielding)
        .grain(Grain::at([0.0, 0.0], radii[0]))
        .grain(Grain::at([distance, 0.0], radii[1]))
        .bond(bond);
    let mut world = world(&draft);
    world.evaluate_if_pending().expect("finite forces");
    world.bonds().is_some_and(|bonds| bonds.is_empty())
}

fn breaks_at(yielding: Yielding, radii: [f64; 2], factor: f64, load: Load, force: f64) -> bool {
    let [below, above] = [0.9999, 1.0001].map(|x| breaks(yielding, radii, factor, load, x * force));
    !below && above
}

#[test]
fn a_tensile_strength_counts_for_bonds_that_pull_only() {
    let section = PI * RADIUS * RADIUS;
    let radii = [RADIUS, 1.3 * RADIUS];
    for (load, weak, strong) in [
        (Load::Tension, TENSILE, COMPRESSIVE),
        (Load::Compression, COMPRESSIVE, COMPRESSIVE),
        (Load::Shear, TANGENTIAL, TANGENTIAL),
    ] {
        let with = yielding(Some(TENSILE));
        assert!(
            breaks_at(with, radii, 1.0, load, weak * section),
            "{load:?}"
        );
        let without = yielding(None);
        assert!(
            breaks_at(without, radii, 1.0, load, strong * section),
            "{load:?}"
        );
    }
}

#[test]
fn a_tensile_strength_equal_to_the_normal_one_changes_nothing() {
    let run = |tensile: Option<f64>| {
        let chain = (0..6).map(|i| {
            let x = 2.0 * RADIUS * f64::from(i);
            Grain::at([x, 0.0], RADIUS)
                .moving([if i < 3 { -150.0 } else { 150.0 }, 0.1 * f64::from(i)])
        });
        let draft = (1..6).fold(bonded(yielding(tensile)).grains(chain), |draft, i| {
            draft.bonded(i - 1, i)
        });
        let mut world = world(&draft);
        advance(&mut world, 5000);
        (world.bonds().map_or(0, |bonds| bonds.len()), bits(&world))
    };
    let (bonds, _) = run(None);
    assert!(bonds < 5, "{bonds}");
    assert!(run(None) == run(Some(COMPRESSIVE)));
}

/// A lattice of grains of different sizes whose bonds have a strength.
fn packing(strength: &str, tensile: Option<f64>) -> Scene {
    let draft = bonded(yielding(tensile))
        .with("setup.seed", 5)
        .with("setup.sizes.minimum", 0.5 * RADIUS)
        .with("setup.sizes.maximum", RADIUS)
        .with("setup.lattice.columns", 60)
        .with("setup.lattice.rows", 60)
        .with("setup.bonding.reach", 1.5)
        .and(&Draft::parse(&format!(
            "[setup.bonding.strength]\n{strength}"
        )));
    scene(&draft)
}

/// The forces in N at which the bonds of a world break when they are pulled apart, for a tensile strength in Pa.
fn strengths(world: &World, tensile: f64) -> Vec<f64> {
    let radius = &world.particles().radius;
    let bonds = world.bonds().expect("bonds").iter();
    bonds
        .map(|bond| {
            let (i, j) = bond.pair.indices();
            let weakest = bond.strength_factor * radius[i].min(radius[j]);
            tensile * PI * weakest * weakest
        })
        .collect()
}

/// Largest distance of the empirical distribution of numbers from a cumulative distribution.
fn distance(mut numbers: Vec<f64>, cumulative: impl Fn(f64) -> f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let n = numbers.len() as f64;
    let each = numbers.iter().enumerate().map(|(k, &x)| {
        let f = cumulative(x);
        (f - k as f64 / n).abs().max((f - (k + 1) as f64 / n).abs())
    });
    each.fold(0.0, f64::max)
}

/// Distance that the empirical distribution of n numbers exceeds once in a million times, by the inequality of
/// Dvoretzky, Kiefer, Wolfowitz and Massart.
fn band(n: usize) -> f64 {
    (2e6_f64.ln() / (2.0 * n as f64)).sqrt()
}

const WEIBULL: &str = "distribution = 'weibull'\nshape = 2.0\nscale = 300.0\n";
const TABLE: &str =
    "distribution = 'table'\nstrength = [100, 200, 200, 600]\nprobability = [0, 0.3, 0.5, 1]\n";

fn weibull(x: f64) -> f64 {
    1.0 - (-(x / 300.0).powi(2)).exp()
}

fn table(x: f64) -> f64 {
    match x {
        ..100.0 => 0.0,
        ..200.0 => 0.3 * (x - 100.0) / 100.0,
        _ => 0.5 + 0.5 * (x - 200.0) / 400.0,
    }
}

#[test]
fn the_strengths_of_a_packing_have_the_wanted_distribution() {
    for tensile in [None, Some(TENSILE)] {
        let pascals = tensile.unwrap_or(COMPRESSIVE);
        let made = run_setup(&packing(WEIBULL, tensile)).expect("a packing");
        let found = strengths(&made, pascals);
        assert!(found.len() > 5000);
        let far = distance(found.clone(), weibull);
        assert!(far < band(found.len()), "{far}");
        let made = run_setup(&packing(TABLE, tensile)).expect("a packing");
        // A fifth of all bonds break at 200 N, where the distribution jumps.
        let found = strengths(&made, pascals);
        let (jumping, other): (Vec<f64>, Vec<f64>) =
            found.iter().partition(|&&x| (x - 200.0).abs() < 1e-9);
        let share = jumping.len() as f64 / found.len() as f64;
        assert!((share - 0.2).abs() < band(found.len()), "{share}");
        let without_jump = |x: f64| (if x < 200.0 { table(x) } else { table(x) - 0.2 }) / 0.8;
        assert!(distance(other.clone(), without_jump) < band(other.len()));
    }
}

#[test]
fn the_strengths_of_bonds_are_independent_of_each_other_and_of_the_sizes() {
    let made = run_setup(&packing(WEIBULL, None)).expect("a packing");
    let radius = &made.particles().radius;
    let bonds = made.bonds().expect("bonds");
    let levels: Vec<f64> = strengths(&made, COMPRESSIVE)
        .into_iter()
        .map(|x| weibull(x) - 0.5)
        .collect();
    // Products of levels of bonds that share a grain: mean zero, variance 1/144, uncorrelated.
    let mut of_grain = vec![Vec::new(); made.particles().len()];
    for (bond, pair) in bonds.pairs().iter().enumerate() {
        let (i, j) = pair.indices();
        of_grain[i].push(bond);
        of_grain[j].push(bond);
    }
    let (mut sum, mut number) = (0.0, 0.0);
    for own in &of_grain {
        for (k, &one) in own.iter().enumerate() {
            for &other in &own[..k] {
                sum += levels[one] * levels[other];
                number += 1.0;
            }
        }
    }
    let score = sum / (number / 144.0_f64).sqrt();
    assert!(number > 10_000.0 && score.abs() < 5.0, "{score}");
    // Products with the deviation of the smaller radius: variance 1/12 of the sum of squares.
    let smaller: Vec<f64> = bonds
        .pairs()
        .iter()
        .map(|pair| radius[pair.indices().0].min(radius[pair.indices().1]))
        .collect();
    let mean = smaller.iter().sum::<f64>() / smaller.len() as f64;
    let products = levels.iter().zip(&smaller).map(|(u, r)| u * (r - mean));
    let squares: f64 = smaller.iter().map(|r| (r - mean).powi(2)).sum();
    let score = products.sum::<f64>() / (squares / 12.0).sqrt();
    assert!(score.abs() < 5.0, "{score}");
}

#[test]
fn every_bond_breaks_at_its_strength() {
    for tensile in [None, Some(TENSILE)] {
        let made = run_setup(&packing(WEIBULL, tensile)).expect("a packing");
        let pascals = tensile.unwrap_or(COMPRESSIVE);
        let radius = &made.particles().radius;
        let all = strengths(&made, pascals);
        let bonds = made.bonds().expect("bonds").iter();
        for (bond, force) in bonds.zip(all).step_by(97) {
            let (i, j) = bond.pair.indices();
            for (load, share) in [
                (Load::Tension, 1.0),
                (Load::Compression, COMPRESSIVE / pascals),
                (Load::Shear, TANGENTIAL / pascals),
            ] {
                let radii = [radius[i], radius[j]];
                let breaks = breaks_at(
                    yielding(tensile),
                    radii,
                    bond.strength_factor,
                    load,
                    share * force,
                );
                assert!(breaks, "{load:?} {bond:?}");
            }
        }
    }
}

#[test]
fn a_table_of_strengths_may_be_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = "strength,probability\n100,0\n200,0.3\n200,0.5\n600,1\n";
    std::fs::write(folder.path().join("q.csv"), rows).expect("writable");
    let draft = |strength: &str| {
        let draft = bonded(yielding(None))
            .with("setup.seed", 5)
            .with("setup.sizes.minimum", 0.5 * RADIUS)
            .with("setup.sizes.maximum", RADIUS)
            .with("setup.lattice.columns", 6)
            .with("setup.lattice.rows", 6)
            .and(&Draft::parse(&format!(
                "[setup.bonding.strength]\n{strength}"
            )));
        draft.text().expect("a draft")
    };
    let parse =
        |text: String| Scene::parse("scene.toml", text.as_bytes(), Path::new(folder.path()));
    let of_file = parse(draft("distribution = 'table'\nfile = 'q.csv'")).expect("a scene");
    let inline = parse(draft(TABLE)).expect("a scene");
    let bonding = |scene: &Scene| scene.setup.clone().and_then(|setup| setup.bonding);
    assert_eq!(bonding(&of_file), bonding(&inline));
    assert!(of_file.files.contains(&folder.path().join("q.csv")));
    let key = "setup.bonding.strength.file";
    let before = of_file.keys.get(key).map(str::to_owned);
    std::fs::write(folder.path().join("q.csv"), rows.replace("600", "700")).expect("writable");
    let changed = parse(draft("distribution = 'table'\nfile = 'q.csv'")).expect("a scene");
    assert!(before.is_some() && changed.keys.get(key).map(str::to_owned) != before);
}
