//! The phases of a run: those of the set-up, then the scene proper.

use super::observer::NamedPhase;
use crate::scene::{PhaseTable, Scene, steps_for};
use gouge_dem::model::{BondLaws, ContactLaws, Model};

/// Kind of a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PhaseKind {
    /// Loose grains settle, without friction.
    Settle(PhaseTable),
    /// The bonded and cut block relaxes.
    Relax(PhaseTable),
    /// The driven particles build up the pressure.
    Press(PhaseTable),
    /// The scene proper.
    Main,
}

/// A phase of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Phase {
    /// Name in progress and error messages.
    pub name: String,
    /// Kind of the phase.
    pub kind: PhaseKind,
    /// Number of steps.
    pub steps: u64,
}

/// All phases of a scene, the scene proper last.
pub fn phases(scene: &Scene) -> Vec<Phase> {
    let mut phases = Vec::new();
    let mut add = |name: &str, tables: &[PhaseTable], kind: fn(PhaseTable) -> PhaseKind| {
        for (i, &table) in tables.iter().enumerate() {
            phases.push(Phase {
                name: if tables.len() > 1 {
                    format!("{name} {}", i + 1)
                } else {
                    name.to_owned()
                },
                kind: kind(table),
                steps: steps_for(table.duration, table.step),
            });
        }
    };
    if let Some(setup) = &scene.setup {
        add("settle", &setup.settle, PhaseKind::Settle);
        add("relax", &setup.relax, PhaseKind::Relax);
        add("press", &setup.press, PhaseKind::Press);
    }
    phases.push(Phase {
        name: "run".to_owned(),
        kind: PhaseKind::Main,
        steps: scene.steps(),
    });
    phases
}

/// The phases as observers see them.
pub fn named(phases: &[Phase]) -> Vec<NamedPhase> {
    let named = |phase: &Phase| NamedPhase {
        name: phase.name.clone(),
        steps: phase.steps,
    };
    phases.iter().map(named).collect()
}

/// The model of a phase.
pub fn phase_model(scene: &Scene, kind: PhaseKind, radii: &[f64]) -> Model {
    let full = scene.model(radii);
    let quiet = |table: PhaseTable| Model {
        time_step: table.step,
        ambient: table.ambient,
        external: table.external,
        driving: None,
        ledger: false,
        bond: full.bond.map(|bond| BondLaws {
            yielding: None,
            ..bond
        }),
        ..full
    };
    match kind {
        PhaseKind::Main => full,
        PhaseKind::Relax(table) => quiet(table),
        PhaseKind::Press(table) => {
            let mut driving = full.driving;
            if let Some(driving) = &mut driving {
                driving.speed = table.speed;
            }
            Model {
                driving,
                ..quiet(table)
            }
        }
        PhaseKind::Settle(table) => Model {
            bond: None,
            contact: full.contact.map(|contact| ContactLaws {
                tangential: None,
                ..contact
            }),
            ..quiet(table)
        },
    }
}
