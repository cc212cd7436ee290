//! Times of whole steps: one entry per law, integrator and optional part of a scene.
//!
//! A single pass cannot be called from outside the kernel, so its cost is the difference between two entries. Set-up
//! is not timed.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use gouge_dem::World;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Bshp, CundallStrackTruncated, EulerBernoulli, HaffWerner, KelvinVoigt,
    ZhangEckert,
};
use gouge_validation::scenes::Draft;
use std::hint::black_box;

/// Adds a law or another part to a scene.
type Part = fn(Draft) -> Draft;

const KELVIN_VOIGT: Part = |draft| {
    draft.law(KelvinVoigt {
        stiffness: 1e7,
        damping: 10.0,
    })
};
const BSHP: Part = |draft| {
    draft.law(Bshp {
        youngs_modulus: 50e9,
        poissons_ratio: 0.22,
        dissipative_constant: 1e-8,
    })
};
const HAFF_WERNER: Part = |draft| {
    draft.law(HaffWerner {
        friction: 0.7,
        damping: 100.0,
    })
};
const CUNDALL_STRACK: Part = |draft| draft.friction("cundall-strack", 0.7, 1e8);
const TRUNCATED: Part = |draft| {
    draft.law(CundallStrackTruncated {
        friction: 0.7,
        stiffness: 1e8,
    })
};
const BARS: Part = |draft| {
    draft.law(AdjustedKelvinVoigt {
        stiffness: 1e7,
        damping: 10.0,
    })
};
const BEAMS: Part = |draft| {
    draft.law(EulerBernoulli {
        stiffness: 1e7,
        damping: 10.0,
    })
};
const YIELDING: Part = |draft| {
    draft.law(ZhangEckert {
        normal_strength: 280e9,
        tangential_strength: 168e9,
    })
};
const CREEPING: Part = |draft| draft.creeping_drag(1.0);
const GRAVITY: Part = |draft| draft.gravity(9.81);
const LEDGER: Part = |draft| draft.with("output.energy", true);

/// 2500 grains on a lattice, overlapping by 0.1 % of their diameter; bonded if the text has bonds.
fn lattice(integrator: &str, parts: &[Part]) -> Option<World> {
    let bare = Draft::open_box(integrator, 1e-9)
        .with("output.energy", false)
        .with("setup.seed", 1)
        .with("setup.sizes.mean", 1e-3)
        .with("setup.lattice.arrangement", "hexagonal")
        .with("setup.lattice.pitch", 1.998e-3)
        .with("setup.lattice.columns", 50)
        .with("setup.lattice.rows", 50);
    let draft = parts.iter().fold(bare, |draft, part| part(draft));
    let draft = match draft.has("bond") {
        true => draft.with_table("setup.bonding"),
        false => draft,
    };
    let scene = draft.scene().map_err(|error| eprintln!("{error}")).ok()?;
    gouge_runner::run::begin_phase(&scene, &gouge_runner::run::phases(&scene), 0, None).ok()
}

/// The world after some steps. In the first step every contact begins, so that this step costs more than later ones.
fn under_way(mut world: World) -> Option<World> {
    (0..10).try_for_each(|_| world.step()).ok()?;
    Some(world)
}

fn time(criterion: &mut Criterion, group: &str, cases: &[(&str, &str, &[Part])]) {
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
