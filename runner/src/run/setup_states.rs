//! States that the set-up generates: loose grains, the bonded block, and the roles of its particles.

use super::phases::{PhaseKind, phase_model};
use crate::machine::with_chosen_execution;
use crate::random::random;
use crate::scene::{Amount, BondStrength, Bonding, Scene, Setup, wrap};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_dem::bonds::BondStart;
use gouge_dem::laws::strength_factor_for;
use gouge_dem::model::Model;
use gouge_dem::particles::{Particle, Particles, Role};
use gouge_dem::setup::{Fault, bonds_within, is_above, strength_factors};
use gouge_dem::{ModelError, Start, World};

/// The grains on the lattice, in addition to the particles that the scene lists.
///
/// # Errors
/// A state that the kernel rejects.
pub fn loose_grains(scene: &Scene, setup: &Setup, kind: PhaseKind) -> Result<World, ModelError> {
    let (mut sizes, mut places) = (random(setup.seed, 1), random(setup.seed, 2));
    let table = setup.lattice;
    let lattice = table.lattice();
    let mut particles = Particles::default();
    let mut covered = 0.0;
    while wants_more(
        &table.amount,
        table.columns,
        scene,
        particles.len(),
        covered,
    ) {
        let radius = setup.sizes.at(sizes());
        covered += core::f64::consts::PI * radius * radius;
        particles.push(&Particle {
            position: lattice.perturbed_point(particles.len(), table.perturbation, &mut places),
            velocity: Vec2::zero(),
            angle: 0.0,
            angular_velocity: 0.0,
            radius,
            density: scene.material.density,
            inertia_factor: scene.material.inertia_factor,
            role: Role::Free,
        });
    }
    if matches!(table.amount, Amount::Filling(_)) {
        centre(scene, &mut particles);
    }
    scene
        .particles
        .iter()
        .for_each(|particle| particles.push(particle));
    wrap(&scene.domain, &mut particles);
    let start = Start {
        drive_force: scene.initial_force(),
        ..Start::default()
    };
    let radii = particles.radius.clone();
    let model = Model {
        driving: None,
        ledger: false,
        ..phase_model(scene, kind, &radii)
    };
    World::new(model, particles, &start).map(with_chosen_execution)
}

fn wants_more(amount: &Amount, columns: usize, scene: &Scene, number: usize, covered: f64) -> bool {
    match *amount {
        Amount::Rows(rows) => number < rows * columns,
        Amount::Filling(fraction) => {
            let area = scene.domain.width.unwrap_or(0.0) * scene.domain.height.unwrap_or(0.0);
            covered < fraction * area
        }
    }
}

/// Move the grains so that their mean height is half the height of the box.
fn centre(scene: &Scene, particles: &mut Particles) {
    let mean = particles.position.iter().map(|x| x.y).sum::<f64>() / particles.len() as f64;
    let shift = 0.5 * scene.domain.height.unwrap_or(0.0) - mean;
    particles.position.iter_mut().for_each(|x| x.y += shift);
}

/// Clip, cut to shape, bond, correct the density and cut: thesis sections 3.7.3-3.7.6.
///
/// # Errors
/// A state that the kernel rejects.
pub fn bonded_block(
    scene: &Scene,
    setup: &Setup,
    world: World,
    kind: PhaseKind,
) -> Result<World, ModelError> {
    let drive_force = world.drive().force;
    let listed = scene.particles.len();
    let mut all = world.into_particles();
    let made = all.len() - listed;
    let (width, height) = (
        scene.domain.width.unwrap_or(0.0),
        scene.domain.height.unwrap_or(0.0),
    );
    let mut number = made;
    if setup.clip || setup.cut.is_some() {
        let is_clipped = |x: Vec2| setup.clip && !(0.0..height).contains(&x.y);
        let is_cut = |x: Vec2| setup.cut.is_some_and(|shape| !shape.contains(x));
        let outside = |x: Vec2| is_clipped(x) || is_cut(x);
        let inside = |i: usize| i >= made || !outside(all.position[i]);
        let kept: Vec<usize> = (0..all.len()).filter(|&i| inside(i)).collect();
        number = kept.iter().filter(|&&i| i < made).count();
        all = all.select(&kept);
    }
    if all.is_empty() {
        return Err(ModelError::NothingLeft);
    }
    let grains = all.select(&(0..number).collect::<Vec<usize>>());
    let bonds = bonds(scene, setup, &grains);
    if setup.correct_density {
        let covered: f64 = grains
            .radius
            .iter()
            .map(|r| core::f64::consts::PI * r * r)
            .sum();
        let area = setup.cut.map_or(width * height, |shape| shape.area());
        all.scale_mass(number, area / covered);
    }
    let start = Start {
        bonds,
        drive_force,
        ..Start::default()
    };
    let radii = all.radius.clone();
    let model = Model {
        driving: None,
        ledger: false,
        ..phase_model(scene, kind, &radii)
    };
    World::new(model, all, &start).map(with_chosen_execution)
}

/// Bonds between neighbouring grains, except those that the fault cuts.
fn bonds(scene: &Scene, setup: &Setup, grains: &Particles) -> Vec<BondStart> {
    let Some(bonding) = &setup.bonding else {
        return Vec::new();
    };
    let pairs = bonds_within(grains, &scene.domain, bonding.reach);
    let factors = factors(scene, bonding, grains, &pairs, random(setup.seed, 3));
    let side = |i: usize| match setup.fault {
        Some(table) => {
            let width = scene.domain.width.unwrap_or(1.0);
            let (level, height, jags) = (table.level, table.height, table.jags);
            is_above(
                &Fault {
                    level,
                    height,
                    jags,
                    width,
                },
                grains.position[i],
            )
        }
        None => true,
    };
    let whole = pairs.iter().zip(factors).filter(|(pair, _)| {
        let (i, j) = pair.indices();
        side(i) == side(j)
    });
    let start = |(pair, strength_factor): (&Pair, f64)| BondStart {
        between: [pair.i as usize, pair.j as usize],
        strength_factor,
        initial_distance: None,
        initial_angles: None,
    };
    whole.map(start).collect()
}

/// Strength factors of the bonds of some pairs, one random number for each.
fn factors(
    scene: &Scene,
    bonding: &Bonding,
    grains: &Particles,
    pairs: &[Pair],
    mut uniform: impl FnMut() -> f64,
) -> Vec<f64> {
    if let BondStrength::Spread(spread) = bonding.strength {
        return strength_factors(pairs.len(), spread, uniform);
    }
    let yielding = scene.bond.and_then(|bond| bond.yielding);
    let strength = yielding.map_or(1.0, |yielding| yielding.tensile_strength());
    let factor = |pair: &Pair| {
        let (i, j) = pair.indices();
        let force = bonding
            .strength
            .quantile(uniform())
            .unwrap_or(f64::INFINITY);
        strength_factor_for(force, strength, [grains.radius[i], grains.radius[j]])
    };
    pairs.iter().map(factor).collect()
}

/// Roles of all particles; particles that the scene lists keep their roles.
pub fn roles(scene: &Scene, setup: &Setup, particles: &Particles) -> Vec<Role> {
    let made = particles.len() - scene.particles.len();
    let rules = setup.roles.unwrap_or_default();
    let role = |i: usize| {
        let x = particles.position[i];
        if i >= made {
            particles.role[i]
        } else if rules.fixed_below.is_some_and(|y| x.y < y)
            || rules.fixed_left_of.is_some_and(|left| x.x < left)
        {
            Role::Fixed
        } else if rules.driven_above.is_some_and(|y| x.y > y) {
            Role::Driven
        } else {
            Role::Free
        }
    };
    (0..particles.len()).map(role).collect()
}
