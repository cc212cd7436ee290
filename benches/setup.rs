//! What happens rarely: reading a scene, setting it up, finding neighbours, writing a report.

use criterion::{Criterion, criterion_group, criterion_main};
use gouge_kernel::geometry::PeriodicX;
use gouge_kernel::links::{ContactMemory, Neighbors, Pair, WeakLinks};
use gouge_validation::run::{enter, phases};
use gouge_validation::scene::{Scene, builtin};
use gouge_validation::verify;
use std::hint::black_box;
use std::path::Path;

fn fault() -> Option<Scene> {
    let text = builtin::text("granite-fault")?;
    Scene::parse("bench", text.as_bytes(), Path::new(".")).ok()
}

fn scenes(criterion: &mut Criterion) {
    let text = builtin::text("granite-fault").unwrap_or_default();
    criterion.bench_function("read a scene", |bencher| {
        bencher.iter(|| Scene::parse("bench", black_box(text.as_bytes()), Path::new(".")));
    });
    let Some(scene) = fault() else { return };
    criterion.bench_function("lay out the grains of the fault", |bencher| {
        bencher.iter(|| enter(black_box(&scene), &phases(&scene), 0, None));
    });
}

fn rebuild(criterion: &mut Criterion) {
    let world = fault().and_then(|scene| enter(&scene, &phases(&scene), 0, None).ok());
    let Some(world) = world else { return };
    let (particles, length) = (world.particles(), 0.1);
    let neighbors = || Neighbors::new(particles, [Some(length), None], Some(length));
    let number = particles.len();
    let (mut list, mut pairs): (_, Vec<Pair>) = (neighbors(), Vec::new());
    criterion.bench_function(
        &format!("find the neighbours of {number} grains"),
        |bencher| {
            bencher.iter(|| {
                list.rebuild(PeriodicX { length }, black_box(particles), &mut pairs);
                pairs.len()
            });
        },
    );
    let mut contacts = WeakLinks::new(neighbors(), true);
    contacts.rebuild(PeriodicX { length }, particles, None);
    let touching: Vec<_> = contacts
        .pairs
        .iter()
        .map(|&pair| (pair, touching()))
        .collect();
    contacts.restore(&touching);
    criterion.bench_function(
        &format!("list the contacts of {number} grains anew"),
        |bencher| {
            bencher.iter(|| {
                contacts.rebuild(PeriodicX { length }, black_box(particles), None);
                contacts.pairs.len()
            });
        },
    );
}

/// A contact that has begun.
fn touching() -> ContactMemory<f64> {
    ContactMemory {
        touches: true,
        ..ContactMemory::default()
    }
}

fn report(criterion: &mut Criterion) {
    let folder = std::env::temp_dir().join("gouge-bench-report");
    criterion.bench_function("report on the identities", |bencher| {
        bencher.iter(|| verify::verify(Some("identities.minimum-image"), black_box(&folder)));
    });
    let _ = std::fs::remove_dir_all(&folder);
}

criterion_group!(benches, scenes, rebuild, report);
criterion_main!(benches);
