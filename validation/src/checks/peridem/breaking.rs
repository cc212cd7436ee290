//! Bonds that break.

use super::grains::{MATERIAL, bonds_only, grain, world};
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, peridem};
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::BreakingRule;
use gouge_peridem::material::{BondConstants, Weight};

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "peridem.breaking.pair",
            claim: "A single bond breaks above the opening speed whose energy it can store, and takes that energy with it; compressed, it breaks by the two-sided rule only.",
            equations: peridem("(3.2), section 3.1, P4, Q6"),
            scene: "Two nodes of unequal areas that move apart, or towards each other, at 0.99 to 1.5 times that speed, for one period",
            oracle: "The harmonic oscillator: the speed is s0 r w, with w^2 = c w(r) V V'/(r m), m the reduced mass",
            norm: "Number of wrong breaks, and relative error of the speed after the break",
            origin: Origin::Convergent,
            reason: "The bond breaks at most one step of 1/20000 period late, which changes the square of the speed by 2 pi/20000 of the square of the critical one",
            effort: Effort::Quick,
            measure: pair,
        },
        Check {
            id: "peridem.breaking.forever",
            claim: "Broken bonds never act again, damage never falls, and bonds break on all nodes of a cut and on no others.",
            equations: peridem("section 3.1"),
            scene: "A block of 20 x 12 cells whose halves are driven apart at 40 m/s, then towards each other",
            oracle: "Bonds that cross the middle, counted from positions",
            norm: "Number of surviving bonds that cross the middle, of steps in which damage falls, and of forces on the halves when they are turned back",
            origin: Origin::Exact,
            reason: "None is tolerated",
            effort: Effort::Quick,
            measure: forever,
        },
    ]
}

const LENGTH: f64 = 2.7e-4;
const AREAS: [f64; 2] = [4e-9, 3e-9];

fn constants(weight: Weight) -> Result<BondConstants, Failure> {
    Ok(MATERIAL.bond_constants(weight, 5e-4)?)
}

/// Whether the bond breaks, and the relative speed at the end.
fn opened(
    weight: Weight,
    rule: BreakingRule,
    speed: f64,
    frequency: f64,
) -> Result<(bool, f64), Failure> {
    const STEPS: f64 = 20_000.0;
    let places = [Vec2::zero(), Vec2::new(LENGTH, 0.0)];
    let mut grain = grain(places.to_vec(), AREAS.to_vec(), constants(weight)?);
    grain.breaking = Some(rule);
    let shares = [AREAS[1], AREAS[0]].map(|area| area / (AREAS[0] + AREAS[1]));
    let step = std::f64::consts::TAU / frequency / STEPS;
    let moving = |_: usize, place: Vec2| {
        let own = if place.x > 0.0 { shares[1] } else { -shares[0] };
        Vec2::new(own * speed, 0.0)
    };
    let mut world = world(&[grain], bonds_only(step), moving)?;
    for _ in 0..STEPS as usize {
        world.step()?;
    }
    let velocity = &world.state().velocity;
    Ok((
        world.bonds().count() == 0,
        (velocity[1].x - velocity[0].x).abs(),
    ))
}

fn pair() -> Outcome {
    let mut all = Vec::new();
    for weight in [Weight::Constant, Weight::Conic] {
        let bonds = constants(weight)?;
        let ratio = LENGTH / bonds.horizon;
        let factor = match weight {
            Weight::Conic => 1.0 - ratio,
            _ => 1.0,
        };
        let sum = (AREAS[0] + AREAS[1]) / MATERIAL.density;
        let frequency = (bonds.stiffness * factor * sum / LENGTH).sqrt();
        let critical = bonds.critical_stretch * LENGTH * frequency;
        for times in [0.99, 1.01, 1.3, 1.5] {
            let (breaks, speed) = opened(
                weight,
                BreakingRule::TensionOnly,
                times * critical,
                frequency,
            )?;
            all.push(Measurement::count(usize::from(breaks != (times > 1.0))));
            if times > 1.1 {
                let expected = critical * (times * times - 1.0_f64).sqrt();
                all.push(Measurement::relative(expected, speed, 1e-3));
            }
        }
        // In the first half of the period a compressed bond is opened again, as far as it was compressed.
        for (rule, breaks) in [
            (BreakingRule::TensionOnly, 0.99),
            (BreakingRule::TwoSided, 0.99),
        ] {
            let (is_broken, _) = opened(weight, rule, -breaks * critical, frequency)?;
            all.push(Measurement::count(usize::from(is_broken)));
        }
    }
    Ok(Measurement::worst(all).into())
}

fn forever() -> Outcome {
    let mut block = super::grains::block([20, 12], 1e-4, 3.015, Weight::Constant)?;
    block.breaking = Some(BreakingRule::TensionOnly);
    block.constants.critical_stretch = 1e-3;
    let middle = 9.5e-4;
    let moving =
        |_: usize, place: Vec2| Vec2::new(if place.x > middle { 40.0 } else { -40.0 }, 0.0);
    let mut world = world(&[block], bonds_only(1e-8), moving)?;
    let (mut damage, mut fell) = (0.0, 0);
    for _ in 0..400 {
        world.step()?;
        let bonds = world.bonds();
        let now = (0..240).map(|node| bonds.damage(node)).sum::<f64>();
        fell += usize::from(now < damage);
        damage = now;
    }
    let position = &world.grains().position;
    let crosses =
        |&(i, j, _): &(usize, usize, f64)| (position[i].x > middle) != (position[j].x > middle);
    let crossing = world.bonds().all().filter(crosses).count();
    let before = world.bonds().count();
    for _ in 0..400 {
        world.step()?;
    }
    let grown = world.bonds().count() > before;
    let wrong = fell + crossing + usize::from(grown);
    Ok(Measurement::count(wrong).into())
}
