//! Beginning and end of contacts.

use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{CundallStrackTruncated, KelvinVoigt};

pub fn checks() -> Vec<Check> {
    vec![begin(), end(), given()]
}

/// Unequal radii in m.
const RADII: [f64; 2] = [1e-3, 0.7e-3];
/// Relative distance from touch, small enough to detect a wrong radius.
const NEAR: f64 = 2e-7;

fn laws() -> Draft {
    Draft::open_box(Integrator::Euler, 1e-9)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .law(CundallStrackTruncated {
            friction: 1e9,
            stiffness: 1e7,
        })
}

/// Two grains side by side at a given distance; the second one has a horizontal velocity.
fn pair(radii: [f64; 2], distance: f64, velocity: f64, more: &Draft) -> Result<World, Failure> {
    let draft = laws()
        .grain(Grain::at([0.0, 0.0], radii[0]))
        .grain(Grain::at([distance, 0.0], radii[1]).moving([velocity, 0.0]))
        .and(more);
    Ok(draft.world()?)
}

fn begin() -> Check {
    Check {
        id: "estimators.contacts.begin",
        claim: "A contact begins when the distance of the centres falls below the sum of the radii: from then on it is counted, listed and remembered, and not before.",
        equations: thesis("(28), (36)"),
        scene: "Grains of 1 mm and 0.7 mm in both orders, at a relative distance of 2e-7 below and above touch",
        oracle: "Distances by construction",
        norm: "Number of wrong or missing contacts, interactions and memories, and error of the coordination number",
        origin: Origin::Exact,
        reason: "The count must be exact",
        effort: Effort::Quick,
        measure: measure_begin,
    }
}

fn measure_begin() -> Outcome {
    let mut all = Vec::new();
    for radii in [RADII, [RADII[1], RADII[0]]] {
        for (factor, expected) in [(1.0 - NEAR, 1), (1.0 + NEAR, 0)] {
            let mut world = pair(radii, factor * (radii[0] + radii[1]), 0.0, &Draft::empty())?;
            world.evaluate_if_pending()?;
            let remembered = world.contacts().map_or(0, |weak| weak.remembered().count());
            for found in [
                world.number_of_contacts(),
                world.interactions().len(),
                remembered,
            ] {
                all.push(Measurement::count(found.abs_diff(expected)));
            }
            let number = world.contact_network().coordination_number();
            all.push(Measurement::absolute(expected as f64, number, 0.0));
        }
    }
    Ok(Measurement::worst(all).into())
}

fn end() -> Check {
    Check {
        id: "estimators.contacts.end",
        claim: "A contact that has separated stores no energy, even if its spring was stretched and no force has been evaluated since. A contact that has not been evaluated yet stores its normal energy only.",
        equations: thesis("(75)-(76)"),
        scene: "A sheared contact of the grains of estimators.contacts.begin that separates by a relative 2e-7 within one step of Euler's method; the same grains with an overlap of 10 um, one of them rotated by 0.3 rad, before the first step",
        oracle: "Half the stiffness times the squared stretch before separation, zero after it",
        norm: "Relative error before separation, energy after it",
        origin: Origin::Exact,
        reason: "The rest angles are differences of angles near pi: 10 units in the last place of pi in 0.02 rad. Three roundings of 1.7 mm, in an overlap of 10 um that enters squared, are 2e-13",
        effort: Effort::Quick,
        measure: measure_end,
    }
}

fn measure_end() -> Outcome {
    let mut all = Vec::new();
    for radii in [RADII, [RADII[1], RADII[0]]] {
        let touch = radii[0] + radii[1];
        // The ends have turned by 0.02 rad and 0.03 rad since the contact began; the overlap is
        // negligible.
        let turned = [0.02, 0.03];
        let angles = [-turned[0], std::f64::consts::PI - turned[1]];
        let memory = Draft::empty().touching_since(0, 1, [angles[0], angles[1]]);
        let overlap = 1e-12;
        let speed = (NEAR * touch + overlap) / 1e-9;
        let mut world = pair(radii, touch - overlap, speed, &memory)?;
        let stretch = radii[0] * turned[0] + radii[1] * turned[1];
        let stored = 0.5 * 1e7 * (stretch * stretch + overlap * overlap);
        all.push(Measurement::relative(stored, world.energy().contact, 1e-13));
        advance(&mut world, 1)?;
        all.push(Measurement::absolute(0.0, world.energy().contact, 0.0));
        // Overlapping grains, one of them rotated, before any force has been evaluated.
        let depth = 1e-5;
        let fresh = laws()
            .grain(Grain::at([0.0, 0.0], radii[0]))
            .grain(Grain::at([touch - depth, 0.0], radii[1]).turned(0.3))
            .world()?;
        let pressed = 0.5 * 1e7 * depth * depth;
        all.push(Measurement::relative(
            pressed,
            fresh.energy().contact,
            2e-13,
        ));
    }
    Ok(Measurement::worst(all).into())
}

fn given() -> Check {
    Check {
        id: "estimators.contacts.given",
        claim: "A scene may state the memory of overlapping contacts, and of no others.",
        equations: thesis("(30)"),
        scene: "The grains of estimators.contacts.begin with a stated memory",
        oracle: "Distances by construction",
        norm: "Number of scenes wrongly accepted or refused",
        origin: Origin::Exact,
        reason: "The count must be exact",
        effort: Effort::Quick,
        measure: measure_given,
    }
}

fn measure_given() -> Outcome {
    let memory = Draft::empty().touching_since(0, 1, [0.0, 0.0]);
    let mut wrong = 0;
    for radii in [RADII, [RADII[1], RADII[0]]] {
        for (factor, expected) in [(1.0 - NEAR, true), (1.0 + NEAR, false)] {
            let taken = pair(radii, factor * (radii[0] + radii[1]), 0.0, &memory).is_ok();
            wrong += usize::from(taken != expected);
        }
    }
    Ok(Measurement::count(wrong).into())
}
