//! Cost of each optional part of a scene: time and memory with the part, without it, and of a loop written by hand
//! for the scene without the part.

use crate::by_hand::Grains;
use crate::folder::temporary_folder;
use crate::memory::{asked, kept};
use crate::peers::Timer;
use crate::sample::Sample;
use crate::worlds::{Friction, fault, pressed, pressed_with_frames, rubbing};
use gouge_dem::laws::{CreepingDrag, Gravity};
use gouge_dem::model::{Ambient, BondLaws, ContactLaws, External, Model};
use gouge_dem::{Start, World};
use gouge_runner::error::Error;
use gouge_runner::run::{FramePlan, Frames, frame_of};
use gouge_runner::scene::Scene;
use serde::Serialize;
use std::time::Instant;
use tempfile::TempDir;

/// Number of steps per measurement; if frames are written, one frame follows each measurement.
const STEPS: u64 = 500;
/// Time step in s, so short that grains do not move even without confinement.
const STEP: f64 = 1e-12;
/// Largest accepted distance in m between the loop by hand and the kernel. They may differ by rounding.
const SAME: f64 = 1e-13;

/// A part and its cost.
#[derive(Serialize)]
pub struct Part {
    /// Name of the part.
    pub name: &'static str,
    /// Times per particle-step with the part, in ns.
    pub with: Sample,
    /// Times per particle-step without the part, in ns.
    pub without: Sample,
    /// Times per particle-step of the loop by hand without the part, in ns, if there is such a loop.
    pub by_hand: Option<Sample>,
    /// Bytes per particle with and without the part.
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

/// Bytes per particle that a world occupies, including reserved capacity.
pub fn bytes(world: &World) -> f64 {
    let words = world.to_words();
    let (bytes, _copy) = kept(|| World::<f64>::from_words(*world.model(), &words));
    bytes as f64 / world.particles().len() as f64
}

/// The same grains at rest in an open box without driving, with a changed model.
fn changed(world: &World, change: impl Fn(&mut Model)) -> Result<World, Error> {
    let model = still(world, change);
    let start = Start {
        drive_force: world.drive().force,
        ..Start::default()
    };
    Ok(World::new(model, world.particles().clone(), &start)?)
}

fn still(world: &World, change: impl Fn(&mut Model)) -> Model {
    let mut model = Model {
        driving: None,
        time_step: STEP,
        ..*world.model()
    };
    model.domain.periodic = false;
    change(&mut model);
    model
}

/// A block of the fault whose contacts are frictionless, with the given bonds.
fn block(fault: &World, bond: impl Fn(BondLaws) -> Option<BondLaws>) -> Result<World, Error> {
    let model = still(fault, |model| {
        model.bond = model.bond.and_then(&bond);
        model.contact = model.contact.map(|contact| ContactLaws {
            tangential: None,
            ..contact
        });
    });
    Ok(fault.clone().continue_with(model, None)?)
}

/// A part, and a scene with it and without it.
type Compared = (&'static str, World, World);

fn of_grains(grains: &World, bare: &World) -> Result<Vec<Compared>, Error> {
    let rubbed = |friction| changed(&rubbing(grains, friction, 1)?, |_| {});
    let haff_werner = rubbed(Friction::HaffWerner)?;
    let beside_bare = |name, change: &dyn Fn(&mut Model)| -> Result<Compared, Error> {
        Ok((name, changed(grains, change)?, bare.clone()))
    };
    Ok(vec![
        (
            "friction memory",
            rubbed(Friction::CundallStrack)?,
            haff_werner.clone(),
        ),
        ("rotation", haff_werner, bare.clone()),
        beside_bare("drag", &|model| {
            model.ambient = Some(Ambient::Creeping(CreepingDrag { viscosity: 1.0 }));
        })?,
        beside_bare("external field", &|model| {
            model.external = Some(External::Gravity(Gravity { acceleration: 9.81 }));
        })?,
        beside_bare("driving", &|model| model.driving = grains.model().driving)?,
        beside_bare("periodic image", &|model| model.domain.periodic = true)?,
        beside_bare("energy ledger", &|model| model.ledger = true)?,
    ])
}

fn of_bonds() -> Result<Vec<Compared>, Error> {
    let fault = fault(Friction::CundallStrack, false)?;
    let unyielding = block(&fault, |bond| {
        Some(BondLaws {
            yielding: None,
            ..bond
        })
    })?;
    Ok(vec![
        ("bonds", unyielding.clone(), block(&fault, |_| None)?),
        ("yielding", block(&fault, Some)?, unyielding),
    ])
}

/// Scene and folder of the frames.
struct WithFrames {
    scene: Scene,
    folder: TempDir,
}

impl WithFrames {
    fn new() -> Result<Self, Error> {
        Ok(Self {
            scene: pressed_with_frames()?,
            folder: temporary_folder()?,
        })
    }
    fn write(&self, world: &World) -> Result<(), Error> {
        let plan = FramePlan {
            trajectory: self.scene.output.trajectory,
            has_links: false,
        };
        match Frames::open(&plan, self.folder.path(), &[])? {
            Some(mut frames) => frames.write(0, &frame_of(&self.scene, world), None),
            None => Ok(()),
        }
    }
    /// Bytes per particle that are allocated to write a frame.
    fn bytes(&self, world: &World) -> Result<f64, Error> {
        let (bytes, written) = asked(|| self.write(world));
        written?;
        Ok(bytes as f64 / world.particles().len() as f64)
    }
}

/// Time all parts in the given number of rounds.
///
/// # Errors
/// A scene that cannot be set up, or a loop by hand that moves grains differently from the kernel.
pub fn measure(rounds: usize) -> Result<Vec<Part>, Error> {
    let grains = pressed(0.1)?;
    let bare = changed(&grains, |_| {})?;
    let mut parts = Vec::new();
    for case in of_grains(&grains, &bare)?.into_iter().chain(of_bonds()?) {
        parts.push(compare(case, None, rounds)?);
    }
    let trajectory = ("trajectory", bare.clone(), bare);
    parts.push(compare(trajectory, Some(&WithFrames::new()?), rounds)?);
    Ok(parts)
}

fn compare(
    (name, with, without): Compared,
    frames: Option<&WithFrames>,
    rounds: usize,
) -> Result<Part, Error> {
    let mut bytes = [bytes(&with), bytes(&without)];
    if let Some(frames) = frames {
        bytes[0] += frames.bytes(&with)?;
    }
    let number = without.particles().len() as f64;
    let (mut with, mut without) = (Timer::new(with, 10)?, Timer::new(without, 10)?);
    let mut hand = Grains::of(without.world());
    let mut part = Part {
        name,
        with: Sample::default(),
        without: Sample::default(),
        by_hand: hand.as_ref().map(|_| Sample::default()),
        bytes,
    };
    let of_each = |began: Instant| began.elapsed().as_secs_f64() * 1e9 / (STEPS as f64 * number);
    for _ in 0..rounds {
        let began = Instant::now();
        with.time(STEPS)?;
        if let Some(frames) = frames {
            frames.write(with.world())?;
        }
        part.with.0.push(of_each(began));
        part.without.0.push(without.time(STEPS)?);
        if let (Some(hand), Some(sample)) = (&mut hand, &mut part.by_hand) {
            let began = Instant::now();
            let is_good = hand.advance(STEPS);
            sample.0.push(of_each(began));
            let apart = hand.distance(without.world());
            if !is_good || apart > SAME {
                return Err(Error::Argument(format!(
                    "{name}: the loop by hand and the kernel differ by {apart:e} m"
                )));
            }
        }
    }
    println!("{}", part.words());
    Ok(part)
}
