//! The scenes that are timed, at full size.

use gouge_dem::laws::{CundallStrackTruncated, HaffWerner};
use gouge_dem::model::{ContactTangential, Model};
use gouge_dem::{Start, World};
use gouge_runner::error::Error;
use gouge_runner::run::{PhaseKind, run_setup, world_of_record};
use gouge_runner::scene::Scene;
use gouge_validation::scenes::Draft;
use std::time::Instant;

const PRESSED: &str = include_str!("../scenes/pressed.toml");

/// Time step in s that is stable with Haff-Werner friction, whose damping needs a shorter one than springs.
const VISCOUS_STEP: f64 = 4e-9;

/// Friction of contacts.
#[derive(Clone, Copy, PartialEq)]
pub enum Friction {
    /// No friction.
    None,
    /// Haff-Werner friction.
    HaffWerner,
    /// Truncated Cundall-Strack friction.
    CundallStrack,
}

impl Friction {
    fn law(self) -> Option<ContactTangential> {
        match self {
            Self::None => None,
            Self::HaffWerner => Some(ContactTangential::HaffWerner(HaffWerner {
                friction: 0.7,
                damping: 100.0,
            })),
            Self::CundallStrack => {
                let law = CundallStrackTruncated {
                    friction: 0.7,
                    stiffness: 1e8,
                };
                Some(ContactTangential::CundallStrackTruncated(law))
            }
        }
    }
}

fn prepare(draft: &Draft) -> Result<World, Error> {
    let scene = draft.scene()?;
    let began = Instant::now();
    let world = run_setup(&scene)?;
    let (number, seconds) = (world.particles().len(), began.elapsed().as_secs_f64());
    eprintln!("set up {number} particles in {seconds:.1} s");
    Ok(world)
}

/// The granite fault at the beginning of its shear phase.
pub fn fault(friction: Friction, ledger: bool) -> Result<World, Error> {
    prepare(&fault_draft(friction, ledger))
}

/// Number of steps of the shear phase of the granite fault.
pub fn fault_steps() -> Result<u64, Error> {
    Ok(fault_draft(Friction::CundallStrack, false).scene()?.steps())
}

fn fault_draft(friction: Friction, ledger: bool) -> Draft {
    let draft = Draft::builtin("granite-fault").with("output.energy", ledger);
    match friction {
        Friction::HaffWerner => draft.replacing("time.step", VISCOUS_STEP).law(HaffWerner {
            friction: 0.7,
            damping: 100.0,
        }),
        _ => draft,
    }
}

/// The recorded fault, with Cundall-Strack friction and without an energy balance.
pub fn fault_again(words: &[u64]) -> Result<World, Error> {
    again(&fault_draft(Friction::CundallStrack, false), words)
}

/// The recorded pressed grains in the box of the scene.
pub fn pressed_again(words: &[u64]) -> Result<World, Error> {
    again(&Draft::parse(PRESSED), words)
}

/// The world of a scene in a recorded state.
fn again(draft: &Draft, words: &[u64]) -> Result<World, Error> {
    let scene = draft.scene()?;
    let record = World::<f64>::record_of_words(scene.integrator, words);
    let world = record.and_then(|record| world_of_record(&scene, PhaseKind::Main, &record));
    world.ok_or_else(|| Error::Argument("the file does not hold a state of the scene".to_owned()))
}

/// Pressed grains without friction in a box of the given width in m.
pub fn pressed(width: f64) -> Result<World, Error> {
    prepare(&Draft::parse(PRESSED).replacing("box.width", width))
}

/// The scene of the pressed grains, with frames of a trajectory.
pub fn pressed_with_frames() -> Result<Scene, Error> {
    Ok(Draft::parse(PRESSED)
        .with("output.trajectory", "extxyz")
        .scene()?)
}

/// The pressed grains with friction, repeated `times` times along the periodic direction. All contacts begin again.
pub fn rubbing(pressed: &World, friction: Friction, times: usize) -> Result<World, Error> {
    let mut model: Model = *pressed.model();
    if friction == Friction::HaffWerner {
        model.time_step = model.time_step.min(VISCOUS_STEP);
    }
    let width = model.period().unwrap_or_default();
    model.domain.width = Some(width * times as f64);
    if let Some(driving) = &mut model.driving {
        driving.area *= times as f64;
    }
    if let Some(contact) = &mut model.contact {
        contact.tangential = friction.law();
    }
    let start = Start {
        drive_force: pressed.drive().force * times as f64,
        ..Start::default()
    };
    Ok(World::new(
        model,
        pressed.particles().repeated(width, times),
        &start,
    )?)
}
