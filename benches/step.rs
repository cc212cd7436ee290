//! Whole steps of small worlds, by what their scenes contain. Set-up is outside the timed part.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use gouge_kernel::World;
use gouge_validation::scene::{Scene, builtin};
use std::hint::black_box;
use std::path::Path;

/// A bonded block of equal grains on a hexagonal lattice, or the same grains loose.
fn block(contact: &str, bond: &str, ledger: bool) -> Option<World> {
    let head = format!(
        "[time]\nstep = 1e-9\nend = 1.0\nintegrator = \"symplectic-euler\"\n\
         [material]\ndensity = 2700.0\n[output]\nenergy = {ledger}\n{contact}{bond}\n\
         [setup]\nseed = 1\n[setup.sizes]\nmean = 1e-3\n\
         [setup.lattice]\narrangement = \"hexagonal\"\npitch = 2e-3\ncolumns = 50\nrows = 50\n"
    );
    let text = if bond.is_empty() {
        head
    } else {
        head + "[setup.bonding]\n"
    };
    let scene = Scene::parse("bench", text.as_bytes(), Path::new(".")).ok()?;
    gouge_validation::run::enter(&scene, &gouge_validation::run::phases(&scene), 0, None).ok()
}

const NORMAL: &str = "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 10.0\n";
const HAFF_WERNER: &str =
    "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 0.7\ndamping = 100.0\n";
const CUNDALL_STRACK: &str =
    "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 0.7\nstiffness = 1e8\n";
const BOND: &str = "[bond.normal]\nstiffness = 1e7\ndamping = 10.0\n\
    [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = 10.0\n\
    [bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = 280e9\ntangential_strength = 168e9\n";

fn steps(criterion: &mut Criterion) {
    let cases = [
        ("contacts/frictionless", NORMAL.to_owned(), "", false),
        (
            "contacts/haff-werner",
            format!("{NORMAL}{HAFF_WERNER}"),
            "",
            false,
        ),
        (
            "contacts/cundall-strack-truncated",
            format!("{NORMAL}{CUNDALL_STRACK}"),
            "",
            false,
        ),
        ("bonds", String::new(), BOND, false),
        (
            "bonds and contacts",
            format!("{NORMAL}{CUNDALL_STRACK}"),
            BOND,
            false,
        ),
        (
            "bonds and contacts/ledger",
            format!("{NORMAL}{CUNDALL_STRACK}"),
            BOND,
            true,
        ),
    ];
    let mut group = criterion.benchmark_group("step of 2500 particles");
    for (name, contact, bond, ledger) in cases {
        let Some(world) = block(&contact, bond, ledger) else {
            continue;
        };
        group.throughput(Throughput::Elements(world.particles().len() as u64));
        group.bench_function(name, |bencher| {
            bencher.iter_batched_ref(
                || world.clone(),
                |world| black_box(world.step()),
                BatchSize::LargeInput,
            );
        });
    }
    group.finish();
}

fn scenes(criterion: &mut Criterion) {
    let text = builtin::text("granite-fault-small").unwrap_or_default();
    criterion.bench_function("read a scene", |bencher| {
        bencher.iter(|| Scene::parse("bench", black_box(text.as_bytes()), Path::new(".")));
    });
}

criterion_group!(benches, steps, scenes);
criterion_main!(benches);
