//! Times of rare operations: reading a scene, setting it up, finding neighbours, writing a report.

use criterion::{Criterion, criterion_group, criterion_main};
use gouge_common::geometry::Domain;
use gouge_common::geometry::PeriodicX;
use gouge_common::neighbors::Neighbors;
use gouge_dem::contacts::{ContactMemory, Contacts};
use gouge_dem::particles::Particles;
use gouge_runner::run::{begin_phase, phases};
use gouge_runner::scene::{Scene, builtin};
use gouge_validation::report::Figures;
use gouge_validation::scenes::Draft;
use gouge_validation::verify;
use std::hint::black_box;
use std::path::Path;

/// The box of the fault.
const BOX: PeriodicX = PeriodicX { length: 0.1 };

fn fault() -> Option<Scene> {
    Draft::builtin("granite-fault").scene().ok()
}

fn scenes(criterion: &mut Criterion) {
    let text = builtin::text("granite-fault").unwrap_or_default();
    criterion.bench_function("read a scene", |bencher| {
        bencher.iter(|| Scene::parse("bench", black_box(text.as_bytes()), Path::new(".")));
    });
    let Some(scene) = fault() else { return };
    criterion.bench_function("lay out the grains of the fault", |bencher| {
        bencher.iter(|| begin_phase(black_box(&scene), &phases(&scene), 0, None));
    });
}

fn rebuild(criterion: &mut Criterion) {
    let world = fault().and_then(|scene| begin_phase(&scene, &phases(&scene), 0, None).ok());
    let Some(world) = world else { return };
    find_neighbors(criterion, world.particles());
    list_contacts(criterion, world.particles());
}

fn neighbors(particles: &Particles<f64>) -> Neighbors<f64> {
    let length = BOX.length;
    let domain = Domain {
        width: Some(length),
        height: None,
        periodic: true,
    };
    Neighbors::new(particles.search_spheres(), &domain)
}

fn find_neighbors(criterion: &mut Criterion, particles: &Particles<f64>) {
    let (mut list, mut pairs) = (neighbors(particles), Vec::new());
    let name = format!("find the neighbours of {} grains", particles.len());
    criterion.bench_function(&name, |bencher| {
        bencher.iter(|| {
            let particles = black_box(particles);
            let may_interact = |i, j| particles.may_interact(i, j);
            list.rebuild(BOX, particles.search_spheres(), may_interact, &mut pairs);
            pairs.len()
        });
    });
}

fn list_contacts(criterion: &mut Criterion, particles: &Particles<f64>) {
    let (mut contacts, mut list) = (Contacts::new(true), neighbors(particles));
    contacts.rebuild(BOX, particles, None, &mut list);
    let near = contacts.pairs.iter();
    let touching: Vec<_> = near.map(|&pair| (pair, touching())).collect();
    contacts.restore(&touching);
    let name = format!("rebuild the contact list of {} grains", particles.len());
    criterion.bench_function(&name, |bencher| {
        bencher.iter(|| {
            contacts.rebuild(BOX, black_box(particles), None, &mut list);
            contacts.pairs.len()
        });
    });
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
    criterion.bench_function("report on one check", |bencher| {
        bencher.iter(|| {
            verify::verify(
                Some("identities.minimum-image"),
                black_box(&folder),
                Figures::Inside,
            )
        });
    });
    let _ = std::fs::remove_dir_all(&folder);
}

criterion_group!(benches, scenes, rebuild, report);
criterion_main!(benches);
