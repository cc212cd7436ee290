//! The fastest mode of all particles together.

use super::guard::{PairConstants, bond_constants, contact_constants};
use super::simulation::World;
use crate::forces::{Interaction, InteractionKind, reduced_mass};
use crate::integrators::{Oscillator, critical_step};
use gouge_common::geometry::Vec2;

/// Most iterations; the largest eigenvalue then has an error of a few per cent at most.
const ITERATIONS: usize = 300;
/// Relative change of the eigenvalue per iteration below which it is taken as found.
const CHANGE: f64 = 1e-4;
/// Factor by which the eigenvalue may still grow.
const MARGIN: f64 = 1.02;
/// Inverse of the golden ratio: its multiples give a first vector without any symmetry.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Estimate of the critical time step of a world in s, from the largest eigenvalues of its stiffness and its damping.
///
/// The relative motions of a pair with the unit normal n and the tangent t are
///
/// - along the normal, of contacts and bonds: (v_i - v_j) n;
/// - along the tangent, of a contact: (v_i - v_j) t + r_i omega_i + r_j omega_j;
/// - along the tangent, of each end of a bond: r_i omega_i + r_i / (r_i + r_j) (v_i - v_j) t, and likewise for j.
///
/// Each has its stiffness and its damping; sliding contacts count as sticking. The largest eigenvalues are found by
/// power iteration. Unlike [`stable_step_estimate`](super::stable_step_estimate), which is never too large, the result is
/// close to the critical step: within a few per cent, and too small if the stiffest and the most damped mode differ.
pub fn network_step(world: &World) -> f64 {
    let links = links(world);
    let largest = |which: usize| MARGIN * largest_eigenvalue(world, &links, which);
    let stiffest = Oscillator {
        frequency_squared: largest(0),
        damping_rate: largest(1),
    };
    critical_step(world.model().integrator, stiffest)
}

/// A contact or bond and its constants.
struct Link {
    pair: (usize, usize),
    kind: InteractionKind,
    normal: Vec2,
    /// Shares of both radii in their sum.
    shares: [f64; 2],
    constants: PairConstants,
}

fn links(world: &World) -> Vec<Link> {
    let (model, radius) = (world.model(), &world.particles().radius);
    let link = |one: Interaction| {
        let (i, j) = one.pair.indices();
        let radii = [radius[i], radius[j]];
        let constants = match one.kind {
            InteractionKind::Bond => bond_constants(model)?,
            InteractionKind::Contact => {
                let laws = model.contact?;
                let masses = [i, j].map(|end| world.inverse_mass(end));
                contact_constants::<f64, _>(&laws, radii, reduced_mass(masses))
            }
        };
        Some(Link {
            pair: (i, j),
            kind: one.kind,
            normal: one.normal,
            shares: radii.map(|r| r / (radii[0] + radii[1])),
            constants,
        })
    };
    world.interactions().into_iter().filter_map(link).collect()
}

/// Velocity of a particle, and its surface velocity r omega.
type Motion = [f64; 3];

/// Largest eigenvalue per mass of stiffness (0) in 1/s^2 or damping (1) in 1/s.
fn largest_eigenvalue(world: &World, links: &[Link], which: usize) -> f64 {
    let p = world.particles();
    let first = |n: usize| (n as f64 * GOLDEN).fract() - 0.5;
    let mut motions: Vec<Motion> = (0..p.len())
        .map(|i| [0, 1, 2].map(|axis| first(3 * i + axis + 1)))
        .collect();
    let mut eigenvalue = 0.0;
    for _ in 0..ITERATIONS {
        let forces = forces(&motions, links, which);
        let next: Vec<Motion> = forces
            .iter()
            .enumerate()
            .map(|(i, force)| accelerations(world, i, force))
            .collect();
        let norm = |all: &[Motion]| all.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
        let size = norm(&next);
        if !(size > 0.0 && size.is_finite()) {
            return eigenvalue;
        }
        let grown = size / norm(&motions);
        motions = next
            .into_iter()
            .map(|motion| motion.map(|x| x / size))
            .collect();
        let is_found = (grown - eigenvalue).abs() <= CHANGE * grown;
        eigenvalue = grown;
        if is_found {
            break;
        }
    }
    eigenvalue
}

/// The accelerations of a particle; zero if forces cannot move it.
fn accelerations(world: &World, i: usize, force: &Motion) -> Motion {
    let inverse = world.inverse_mass(i);
    let turning = inverse * world.particles().inverse_inertia_factor(i);
    [force[0] * inverse, force[1] * inverse, force[2] * turning]
}

/// Forces, and torques over radii, that act against motions.
fn forces(motions: &[Motion], links: &[Link], which: usize) -> Vec<Motion> {
    let mut forces = vec![[0.0; 3]; motions.len()];
    for link in links {
        let (i, j) = link.pair;
        let ([a, b], tangent) = ([motions[i], motions[j]], link.normal.perpendicular());
        let relative = Vec2::new(a[0] - b[0], a[1] - b[1]);
        let (along, across) = (relative.dot(link.normal), relative.dot(tangent));
        let [k, c] = [
            link.constants.normal[which],
            link.constants.tangential[which],
        ];
        let (shear, turns) = match link.kind {
            InteractionKind::Contact => {
                let slip = across + a[2] + b[2];
                (slip, [slip; 2])
            }
            InteractionKind::Bond => {
                let [s, t] = link.shares;
                let ends = [a[2] + s * across, b[2] + t * across];
                (s * ends[0] + t * ends[1], ends)
            }
        };
        let force = link.normal * (k * along) + tangent * (c * shear);
        for (particle, sign, turn) in [(i, 1.0, turns[0]), (j, -1.0, turns[1])] {
            forces[particle][0] += sign * force.x;
            forces[particle][1] += sign * force.y;
            forces[particle][2] += c * turn;
        }
    }
    forces
}
