//! Stiffness and damping of a whole world by dual numbers.

use crate::checks::dem::remembered::start;
use crate::checks::{Failure, largest};
use crate::oracles::spectrum::{Entry, Network};
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::model::Model;
use gouge_dem::particles::Particles;
use gouge_scalars::Dual;

/// Coordinates per particle: two positions and one angle.
const COORDINATES: usize = 3;

/// A network, and the asymmetry of its matrices relative to their largest entry.
pub struct Linearisation {
    /// Masses, stiffness and damping over three coordinates per particle; fixed particles have none.
    pub network: Network,
    /// Largest difference between an entry and its transpose, in units of the largest entry, for K and
    /// for C.
    pub asymmetry: [f64; 2],
    /// Number of force evaluations used.
    pub evaluations: usize,
}

/// The state variable that carries the derivative.
#[derive(Clone, Copy)]
enum Variable {
    Displacement,
    Velocity,
}

/// K = -dF/dq and C = -dF/dv of a world at its present state, under another model.
///
/// Particles without common neighbours are perturbed in the same evaluation, so that every force
/// depends on only one of them.
///
/// # Errors
/// States that the kernel refuses.
pub fn linearise(world: &World, model: Model) -> Result<Linearisation, Failure> {
    let neighbours = neighbours(world);
    let colours = colours(&neighbours);
    let number = colours.iter().max().map_or(0, |most| most + 1);
    let mut entries = [Vec::new(), Vec::new()];
    let variables = [Variable::Displacement, Variable::Velocity];
    for (variable, entries) in variables.into_iter().zip(&mut entries) {
        for colour in 0..number {
            for coordinate in 0..COORDINATES {
                let moved: Vec<usize> = (0..colours.len())
                    .filter(|&i| colours[i] == colour)
                    .collect();
                let forces = slopes(world, model, variable, coordinate, &moved)?;
                for &i in &moved {
                    let column = COORDINATES * i + coordinate;
                    let touched = neighbours[i].iter().chain([&i]);
                    entries.extend(touched.flat_map(|&j| column_entries(j, column, forces[j])));
                }
            }
        }
    }
    let p = world.particles();
    let inertia = (0..p.len()).flat_map(|i| [p.mass[i], p.mass[i], p.moment_of_inertia[i]]);
    let asymmetry = [asymmetry(&entries[0]), asymmetry(&entries[1])];
    let [stiffness, damping] = entries;
    Ok(Linearisation {
        network: Network {
            inertia: inertia.collect(),
            stiffness,
            damping,
        },
        asymmetry,
        evaluations: 2 * COORDINATES * number,
    })
}

/// Entries of a matrix column from the derivative of the force on a particle.
fn column_entries(
    particle: usize,
    column: usize,
    slope: [f64; COORDINATES],
) -> impl Iterator<Item = Entry> {
    let rows = slope.into_iter().enumerate();
    rows.map(move |(n, f)| (COORDINATES * particle + n, column, -f))
}

/// The particles that share a bond, or may share a contact, with each particle.
fn neighbours(world: &World) -> Vec<Vec<usize>> {
    let mut neighbours = vec![Vec::new(); world.particles().len()];
    let bonded = world
        .bonds()
        .map_or(&[][..], |strong| strong.pairs())
        .iter()
        .copied();
    let near = world.contacts().map_or(&[][..], |weak| &weak.pairs);
    for pair in bonded.chain(near.iter().copied()) {
        let (i, j) = pair.indices();
        neighbours[i].push(j);
        neighbours[j].push(i);
    }
    neighbours
}

/// Colours particles greedily so that neighbours and neighbours of neighbours differ.
fn colours(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let mut colours = vec![usize::MAX; neighbours.len()];
    for i in 0..neighbours.len() {
        let near = neighbours[i].iter();
        let taken: Vec<usize> = near
            .flat_map(|&j| neighbours[j].iter().copied().chain([j]))
            .map(|k| colours[k])
            .collect();
        colours[i] = (0..).find(|colour| !taken.contains(colour)).unwrap_or(0);
    }
    colours
}

/// Derivatives of all forces and torques when the given particles are perturbed along a coordinate.
fn slopes(
    world: &World,
    model: Model,
    variable: Variable,
    coordinate: usize,
    moved: &[usize],
) -> Result<Vec<[f64; COORDINATES]>, Failure> {
    let mut particles = in_duals(world.particles());
    for &i in moved {
        let (place, angle) = match variable {
            Variable::Displacement => (&mut particles.position[i], &mut particles.angle[i]),
            Variable::Velocity => (
                &mut particles.velocity[i],
                &mut particles.angular_velocity[i],
            ),
        };
        let moving = [&mut place.x, &mut place.y, angle]
            .into_iter()
            .nth(coordinate);
        if let Some(moving) = moving {
            *moving = Dual::variable(moving.value());
        }
    }
    let mut dual = World::new(model, particles, &start(world))?;
    dual.evaluate_if_pending()?;
    let forces = dual.forces();
    let slope = |i: usize| [forces.force[i].x, forces.force[i].y, forces.torque[i]];
    Ok((0..world.particles().len())
        .map(|i| slope(i).map(Dual::slope))
        .collect())
}

/// The same particles with zero derivatives.
fn in_duals(p: &Particles) -> Particles<Dual> {
    let numbers = |column: &[f64]| column.iter().map(|&x| Dual::new(x, 0.0)).collect();
    let vectors = |column: &[Vec2]| {
        let vector = |v: &Vec2| Vec2::new(Dual::new(v.x, 0.0), Dual::new(v.y, 0.0));
        column.iter().map(vector).collect()
    };
    Particles {
        position: vectors(&p.position),
        velocity: vectors(&p.velocity),
        angle: numbers(&p.angle),
        angular_velocity: numbers(&p.angular_velocity),
        radius: numbers(&p.radius),
        mass: numbers(&p.mass),
        moment_of_inertia: numbers(&p.moment_of_inertia),
        role: p.role.clone(),
    }
}

/// Largest difference between an entry and its transpose, in units of the largest entry.
fn asymmetry(entries: &[Entry]) -> f64 {
    let map: std::collections::BTreeMap<(usize, usize), f64> = entries
        .iter()
        .map(|&(i, j, value)| ((i, j), value))
        .collect();
    let size = largest(entries.iter().map(|entry| entry.2.abs()));
    let differs = |(&(i, j), value): (&(usize, usize), &f64)| {
        (value - map.get(&(j, i)).copied().unwrap_or(0.0)).abs()
    };
    largest(map.iter().map(differs)) / size
}
