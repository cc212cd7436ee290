//! Cells that several tests start from.

use crate::generators::Uniform;
use gouge_contact_dynamics::cell::{Cell, Drive};
use gouge_contact_dynamics::detection::DetectionSettings;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::preparation::{
    DiameterRange, Filling, deposit, draw_diameters, inscribe,
};
use gouge_contact_dynamics::step::{Scheme, StepSettings};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::world::World;

/// Random numbers in [0, 1).
pub fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut uniform = Uniform::new(seed);
    // The first numbers of a small seed are not yet mixed.
    (0..20).for_each(|_| {
        uniform.next();
    });
    move || uniform.next()
}

/// Steps in units of the mean diameter, the density and the normal stress.
pub fn settings(friction: f64, tolerance: f64) -> StepSettings {
    StepSettings {
        time_step: 0.05,
        scheme: Scheme::Midpoint,
        detection: DetectionSettings::for_diameter(1.0),
        law: ContactLaw {
            gap: GapRule::Stabilized {
                fraction: 0.05,
                allowed_overlap: 0.002,
            },
            ..ContactLaw::inelastic(friction)
        },
        sweeps: SweepSettings {
            stop: StopCriterion::Increment {
                tolerance,
                floor: 1e-14,
            },
            max_sweeps: 200,
            ..SweepSettings::default()
        },
        warm_start_distance: 0.3,
    }
}

pub const COMPACTION: Drive = Drive::Compaction {
    normal_stress: 1.0,
    largest_speed: 0.2,
    slowing: 0.95,
    window: 200,
    settled_distance: 0.05,
};

/// A loose cell, 10 mean diameters wide.
pub fn loose(sides: Option<usize>, number: usize, seed: u64) -> Cell {
    let mut random = random(seed);
    let range = DiameterRange::with_mean(1.0, 4.0).unwrap();
    let diameters = draw_diameters(range, number, &mut random);
    let deposited = deposit(&diameters, 10.0).unwrap();
    let filling = Filling {
        sides,
        density: 1.0,
        roof_mass: 1.0,
    };
    inscribe(&deposited, &diameters, 10.0, &filling, &mut random).unwrap()
}

/// The same cell after its compaction.
pub fn compacted(sides: Option<usize>, number: usize, seed: u64) -> Cell {
    let cell = loose(sides, number, seed);
    let mut world = World::of_cell(cell, settings(0.0, 1e-2), COMPACTION).unwrap();
    while !world.has_settled() {
        world.step().unwrap();
        assert!(world.steps() < 10_000);
    }
    world.into_cell()
}
