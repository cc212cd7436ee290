//! What is questionable about a scene although it can be run.

use super::warning::Warning;
use crate::scene::{Amount, Scene};
use gouge_dem::World;
use gouge_dem::particles::{Role, sphere_mass};
use std::collections::HashMap;

/// Smallest ratio of a radius to the spacing of floating-point numbers at its position that raises no doubt.
const DIGITS: f64 = 1e9;

/// Factor of masses above which a packing is too loose to be settled: loose packings of equal discs that touch cover
/// at least about three quarters of the plane, and fewer at the edges of a small block.
const LOOSEST: f64 = 1.0 / 0.6;

/// Doubts about the lattice of the set-up.
pub fn about_lattice(scene: &Scene) -> Option<Warning<'static>> {
    let table = scene.setup.as_ref()?.lattice;
    let Amount::Rows(rows) = table.amount else {
        return None;
    };
    let (top, height) = (
        table.lattice().point(rows * table.columns - 1).y,
        scene.domain.height?,
    );
    (top > height).then_some(Warning::HighLattice { top, height })
}

/// Doubts about the state at t = 0.
pub fn about_beginning(scene: &Scene, world: &World) -> Vec<Warning<'static>> {
    let roles = &world.particles().role;
    let mut doubts = Vec::new();
    if roles.contains(&Role::Driven) && scene.driving.is_none() {
        doubts.push(Warning::NothingDrives);
    }
    let pressure = scene.driving.map_or(0.0, |driving| driving.pressure);
    if pressure < 0.0 {
        doubts.push(Warning::Tension(pressure));
    }
    if roles.iter().all(|&role| role == Role::Fixed) {
        doubts.push(Warning::NothingMoves);
    }
    let bonds_made = scene
        .setup
        .as_ref()
        .is_some_and(|setup| setup.bonding.is_some());
    if bonds_made && world.bonds().is_none_or(|bonds| bonds.is_empty()) {
        doubts.push(Warning::NothingBonded);
    }
    doubts.extend(sparse(scene, world));
    doubts.extend(same_place(world));
    doubts.extend(far_out(world));
    doubts
}

/// A packing much looser than the block whose density it is to have.
fn sparse(scene: &Scene, world: &World) -> Option<Warning<'static>> {
    scene.setup.as_ref().filter(|one| one.correct_density)?;
    let p = world.particles();
    let factor = p.mass.first()? / sphere_mass(scene.material.density, *p.radius.first()?);
    (factor > LOOSEST).then_some(Warning::Sparse { factor })
}

/// The first particle at the place of an earlier one.
fn same_place(world: &World) -> Option<Warning<'static>> {
    let mut seen = HashMap::new();
    let mut places = world.particles().position.iter().enumerate();
    places.find_map(|(j, place)| {
        // Adding zero makes both zeros the same.
        let bits = [place.x + 0.0, place.y + 0.0].map(f64::to_bits);
        seen.insert(bits, j).map(|i| Warning::SamePlace([i, j]))
    })
}

/// The first particle at whose position overlaps have too few digits.
fn far_out(world: &World) -> Option<Warning<'static>> {
    let p = world.particles();
    let coarse = |particle: usize| {
        let x = p.position[particle];
        let coordinate = if x.x.abs() > x.y.abs() { x.x } else { x.y };
        let spacing = coordinate.abs().next_up() - coordinate.abs();
        let warning = Warning::FarOut {
            particle,
            coordinate,
            spacing,
        };
        (spacing * DIGITS > p.radius[particle]).then_some(warning)
    };
    (0..p.len()).find_map(coarse)
}
