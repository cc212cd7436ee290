//! Time per bond and step of a square lattice.
#![allow(clippy::unwrap_used)]
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::{Settings, Workspace};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{Material, Plane, Weight};
use gouge_peridem::state::State;
use std::time::Instant;

fn main() {
    let h = 1e-3;
    for (weight, breaking) in [
        (Weight::Constant, None),
        (Weight::Constant, Some(BreakingRule::TensionOnly)),
        (Weight::Conic, Some(BreakingRule::TensionOnly)),
    ] {
        let material = Material {
            young_modulus: 1e9,
            poisson_ratio: 1.0 / 3.0,
            fracture_energy: 1e5,
            density: 1200.0,
            plane: Plane::Stress,
        };
        let grain = Grain {
            position: (0..10_000)
                .map(|k| Vec2::new((k % 100) as f64 * h, (k / 100) as f64 * h))
                .collect(),
            area: vec![h * h; 10_000],
            density: 1200.0,
            constants: material.bond_constants(weight, 4.015 * h).unwrap(),
            breaking,
            touches_itself: false,
            contact_stiffness: 0.0,
            material: 0,
            clamped: Vec::new(),
            load: Vec::new(),
        };
        let grains = Grains::new(&[grain]).unwrap();
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true).unwrap();
        let count = bonds.count();
        let mut state = State::at_rest(&grains, bonds);
        for (k, place) in state.places.iter_mut().enumerate() {
            place.displacement =
                Vec2::new(1e-6 * ((k * 7) % 11) as f64, 1e-6 * ((k * 5) % 17) as f64);
        }
        for threads in [1, 2] {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let settings = Settings {
                time_step: 1e-7,
                gravity: Vec2::zero(),
                break_order: BreakOrder::BreakFirst,
                contact: None,
                walls: None,
            };
            let mut workspace = Workspace::new(&grains, &settings, &state);
            let mut best = f64::INFINITY;
            pool.install(|| {
                for _ in 0..200 {
                    let begin = Instant::now();
                    workspace.evaluate(&grains, &settings, &mut state);
                    best = best.min(begin.elapsed().as_secs_f64());
                }
            });
            println!(
                "{weight:?} {breaking:?} {threads} threads: {count} bonds {:.2} ns, {:?}",
                best * 1e9 / count as f64,
                workspace.force[5050]
            );
        }
    }
}
