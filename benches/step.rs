//! Times of whole steps: one entry per law, integrator and optional part of a scene.
//!
//! A single pass cannot be called from outside the kernel, so its cost is the difference between two entries. Set-up
//! is not timed.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use gouge_dem::World;
use gouge_runner::scene::Scene;
use std::hint::black_box;
use std::path::Path;

const KELVIN_VOIGT: &str =
    "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 10.0\n";
const BSHP: &str = "[contact.normal]\nlaw = \"bshp\"\nyoungs_modulus = 50e9\npoissons_ratio = 0.22\n\
    dissipative_constant = 1e-8\n";
const HAFF_WERNER: &str =
    "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 0.7\ndamping = 100.0\n";
const CUNDALL_STRACK: &str =
    "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.7\nstiffness = 1e8\n";
const TRUNCATED: &str =
    "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 0.7\nstiffness = 1e8\n";
const BARS: &str = "[bond.normal]\nstiffness = 1e7\ndamping = 10.0\n";
const BEAMS: &str =
    "[bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = 10.0\n";
const YIELDING: &str = "[bond.yielding]\nlaw = \"zhang-eckert\"\n\
    normal_strength = 280e9\ntangential_strength = 168e9\n";
const CREEPING: &str = "[ambient]\nlaw = \"creeping\"\nviscosity = 1.0\n";
const GRAVITY: &str = "[external]\nlaw = \"gravity\"\nacceleration = 9.81\n";
const LEDGER: &str = "[output]\nenergy = true\n";

/// 2500 grains on a lattice, overlapping by 0.1 % of their diameter; bonded if the text has bonds.
fn lattice(integrator: &str, parts: &[&str]) -> Option<World> {
    let parts = parts.concat();
    let output = if parts.contains("[output]") {
        ""
    } else {
        "[output]\nenergy = false\n"
    };
    let bonding = if parts.contains("[bond") {
        "[setup.bonding]\n"
    } else {
        ""
    };
    let text = format!(
        "[time]\nstep = 1e-9\nend = 1.0\nintegrator = \"{integrator}\"\n\
         [material]\ndensity = 2700.0\n{output}{parts}\
         [setup]\nseed = 1\n[setup.sizes]\nmean = 1e-3\n\
         [setup.lattice]\narrangement = \"hexagonal\"\npitch = 1.998e-3\ncolumns = 50\nrows = 50\n{bonding}"
    );
    let scene = Scene::parse("bench", text.as_bytes(), Path::new("."));
    let scene = scene.map_err(|error| eprintln!("{error}")).ok()?;
    gouge_runner::run::begin_phase(&scene, &gouge_runner::run::phases(&scene), 0, None).ok()
}

/// The world after some steps. In the first step every contact begins, so that this step costs more than later ones.
fn under_way(mut world: World) -> Option<World> {
    (0..10).try_for_each(|_| world.step()).ok()?;
    Some(world)
}

fn time(criterion: &mut Criterion, group: &str, cases: &[(&str, &str, &[&str])]) {
    let mut group = criterion.benchmark_group(group);
    for (name, integrator, parts) in cases {
        let Some(world) = lattice(integrator, parts).and_then(under_way) else {
            continue;
        };
        group.throughput(Throughput::Elements(world.particles().len() as u64));
        group.bench_function(*name, |bencher| {
            bencher.iter_batched_ref(
                || world.clone(),
                |world| black_box(world.step()),
                BatchSize::LargeInput,
            );
        });
    }
    group.finish();
}

fn contacts(criterion: &mut Criterion) {
    const VERLET: &str = "velocity-verlet";
    time(
        criterion,
        "step with contacts",
        &[
            ("kelvin-voigt", VERLET, &[KELVIN_VOIGT]),
            ("bshp", VERLET, &[BSHP]),
            ("haff-werner", VERLET, &[KELVIN_VOIGT, HAFF_WERNER]),
            ("cundall-strack", VERLET, &[KELVIN_VOIGT, CUNDALL_STRACK]),
            (
                "cundall-strack-truncated",
                VERLET,
                &[KELVIN_VOIGT, TRUNCATED],
            ),
            (
                "bshp and cundall-strack-truncated",
                VERLET,
                &[BSHP, TRUNCATED],
            ),
            ("ledger", VERLET, &[LEDGER, KELVIN_VOIGT, TRUNCATED]),
        ],
    );
}

fn bonds(criterion: &mut Criterion) {
    const VERLET: &str = "velocity-verlet";
    time(
        criterion,
        "step with bonds",
        &[
            ("bars", VERLET, &[BARS]),
            ("beams", VERLET, &[BARS, BEAMS]),
            ("beams that yield", VERLET, &[BARS, BEAMS, YIELDING]),
            (
                "and contacts",
                VERLET,
                &[KELVIN_VOIGT, TRUNCATED, BARS, BEAMS, YIELDING],
            ),
            ("ledger", VERLET, &[LEDGER, BARS, BEAMS, YIELDING]),
        ],
    );
}

fn free(criterion: &mut Criterion) {
    time(
        criterion,
        "step of free grains",
        &[
            ("euler", "euler", &[]),
            ("symplectic-euler", "symplectic-euler", &[]),
            ("taylor", "taylor", &[]),
            ("velocity-verlet", "velocity-verlet", &[]),
            ("beeman", "beeman", &[]),
            ("creeping", "velocity-verlet", &[CREEPING]),
            ("gravity", "velocity-verlet", &[GRAVITY]),
        ],
    );
}

criterion_group!(benches, contacts, bonds, free);
criterion_main!(benches);
