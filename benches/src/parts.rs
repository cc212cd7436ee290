//! What each optional part of a scene costs: time and bytes with it, without it, and of a loop written by
//! hand for the scene without it.

use crate::by_hand::Grains;
use crate::peers::Timer;
use crate::sample::Sample;
use crate::worlds::{Friction, fault, pressed, rubbing};
use gouge_kernel::laws::{CreepingDrag, Gravity};
use gouge_kernel::model::{Ambient, External, Model};
use gouge_kernel::{Start, World};
use gouge_validation::error::Error;
use serde::Serialize;
use std::time::Instant;

const STEPS: u64 = 500;
/// Time step in s: so short that grains without a wall stay where they are.
const STEP: f64 = 1e-12;
/// The loop by hand may differ from the kernel by rounding, but for a closed form of the normal: in m.
const SAME: f64 = 1e-13;

/// A part and what it costs.
#[derive(Serialize)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// Times of a particle-step with it, in ns.
    pub with: Sample,
    /// Times without it.
    pub without: Sample,
    /// Times of the loop by hand without it, where there is one.
    pub by_hand: Option<Sample>,
    /// Bytes a particle with and without it.
    pub bytes: [f64; 2],
}

impl Part {
    fn words(&self) -> String {
        let hand = self.by_hand.as_ref().map_or(String::new(), |hand| {
            format!(
                "  by hand {}, ratio {}",
                hand.words(),
                self.without.over(hand).words()
            )
        });
        format!(
            "{:16} with {}  without {}{hand}  bytes {:.0} and {:.0}",
            self.name,
            self.with.words(),
            self.without.words(),
            self.bytes[0],
            self.bytes[1]
        )
    }
}

/// Bytes a particle that a world keeps, with the room that it reserves.
pub fn bytes(world: &World) -> f64 {
    let (mut copy, words) = (None, world.to_words());
    let taken = allocation_counter::measure(|| copy = World::from_words(*world.model(), &words));
    taken.bytes_current as f64 / world.particles().len() as f64
}

/// The same grains at rest in an open box without driving, with a changed model.
fn changed(world: &World, change: impl Fn(&mut Model)) -> Result<World, Error> {
    let mut model = Model {
        driving: None,
        time_step: STEP,
        ..*world.model()
    };
    model.domain.periodic = false;
    change(&mut model);
    let start = Start {
        drive_force: world.drive().force,
        ..Start::default()
    };
    Ok(World::new(model, world.particles().clone(), &start)?)
}

/// Time all parts in so many rounds.
///
/// # Errors
/// Scenes that cannot be set up, and a loop by hand that moves otherwise than the kernel.
pub fn measure(rounds: usize) -> Result<Vec<Part>, Error> {
    let grains = pressed(0.1)?;
    let rubbed = |friction| rubbing(&grains, friction, 1);
    let bare = changed(&grains, |_| {})?;
    let haff_werner = changed(&rubbed(Friction::HaffWerner)?, |_| {})?;
    let cundall_strack = changed(&rubbed(Friction::CundallStrack)?, |_| {})?;
    let block = fault(Friction::CundallStrack, false)?;
    let block = block.clone().continue_with(
        Model {
            time_step: STEP,
            ..*block.model()
        },
        None,
    )?;
    let unyielding = block.clone().continue_with(
        Model {
            bond: block.model().bond.map(|bond| gouge_kernel::model::Bond {
                yielding: None,
                ..bond
            }),
            ..*block.model()
        },
        None,
    )?;
    let loose = changed(&block, |model| {
        model.bond = None;
        model.domain.periodic = true;
        model.driving = block.model().driving;
    })?;
    let cases: [(&'static str, World, World); 9] = [
        ("friction memory", cundall_strack, haff_werner.clone()),
        ("rotation", haff_werner, bare.clone()),
        ("bonds", unyielding.clone(), loose),
        ("yielding", block, unyielding),
        (
            "drag",
            changed(&grains, |model| {
                model.ambient = Some(Ambient::Creeping(CreepingDrag { viscosity: 1.0 }));
            })?,
            bare.clone(),
        ),
        (
            "external field",
            changed(&grains, |model| {
                model.external = Some(External::Gravity(Gravity { acceleration: 9.81 }));
            })?,
            bare.clone(),
        ),
        (
            "driving",
            changed(&grains, |model| model.driving = grains.model().driving)?,
            bare.clone(),
        ),
        (
            "periodic image",
            changed(&grains, |model| model.domain.periodic = true)?,
            bare.clone(),
        ),
        (
            "energy ledger",
            changed(&grains, |model| model.ledger = true)?,
            bare,
        ),
    ];
    let mut parts = Vec::new();
    for (name, with, without) in cases {
        let part = compare(name, with, without, rounds)?;
        println!("{}", part.words());
        parts.push(part);
    }
    Ok(parts)
}

fn compare(name: &'static str, with: World, without: World, rounds: usize) -> Result<Part, Error> {
    let bytes = [bytes(&with), bytes(&without)];
    let number = without.particles().len() as f64;
    let (mut with, mut without) = (Timer::new(with, 10)?, Timer::new(without, 10)?);
    let hand = Grains::of(without.world()).filter(|_| without.world().strong_links().is_none());
    let mut hand = hand.filter(|_| without.world().model().period().is_none());
    let mut part = Part {
        name,
        with: Sample::default(),
        without: Sample::default(),
        by_hand: hand.as_ref().map(|_| Sample::default()),
        bytes,
    };
    for _ in 0..rounds {
        part.with.0.push(with.time(STEPS)?);
        part.without.0.push(without.time(STEPS)?);
        if let (Some(loop_), Some(sample)) = (&mut hand, &mut part.by_hand) {
            let began = Instant::now();
            let is_good = loop_.advance(STEPS);
            sample
                .0
                .push(began.elapsed().as_secs_f64() * 1e9 / (STEPS as f64 * number));
            let apart = loop_.distance(without.world());
            if !is_good || apart > SAME {
                return Err(Error::Argument(format!(
                    "{name}: the loop by hand is {apart:e} m away"
                )));
            }
        }
    }
    Ok(part)
}
