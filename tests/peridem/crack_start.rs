//! A crack starts where the lattice says: static solutions against the kernel's breaking.

use crate::cloud::{H, forces, grain, lattice, settings};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_peridem::bond_law::BreakingRule;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::Workspace;
use gouge_peridem::grain::Grains;
use gouge_peridem::material::Weight;
use gouge_peridem::state::State;

/// A strip with a crack from its left end, whose upper and lower rows are pulled apart: linear springs of its own.
struct Strip {
    nodes: Vec<Vec2>,
    /// Ends, direction, stiffness in N/m.
    springs: Vec<(usize, usize, Vec2, f64)>,
    is_free: Vec<bool>,
}

impl Strip {
    fn new(grains: &Grains, bonds: &Bonds, held: usize) -> Self {
        let constants = grains.rows[0].constants;
        let spring = |(i, j, length): (usize, usize, f64)| {
            let direction = (grains.position[j] - grains.position[i]) * (1.0 / length);
            let weight = match constants.weight {
                Weight::Constant => 1.0,
                _ => 1.0 - length / constants.horizon,
            };
            (
                i,
                j,
                direction,
                constants.stiffness * weight * H.powi(4) / length,
            )
        };
        let top = grains.position.last().unwrap().y;
        let depth = (held as f64 - 0.5) * H;
        let is_free = |at: &Vec2| at.y > depth && at.y < top - depth;
        Self {
            nodes: grains.position.clone(),
            springs: bonds.all().map(spring).collect(),
            is_free: grains.position.iter().map(is_free).collect(),
        }
    }

    /// Forces that hold displacements, on free nodes only.
    fn product(&self, moved: &[Vec2], result: &mut [Vec2]) {
        result.fill(Vec2::zero());
        for &(i, j, direction, stiffness) in &self.springs {
            let force = direction * (stiffness * (moved[j] - moved[i]).dot(direction));
            result[i] += -force;
            result[j] += force;
        }
        for (result, &is_free) in result.iter_mut().zip(&self.is_free) {
            *result = if is_free { *result } else { Vec2::zero() };
        }
    }

    /// Displacements at rest if the held rows are one unit apart, by conjugate gradients.
    fn solve(&self) -> Vec<Vec2> {
        let middle = 0.5 * self.nodes.last().unwrap().y;
        let guess = self.nodes.iter().zip(&self.is_free).map(|(at, &is_free)| {
            let height = if is_free {
                (at.y - middle) / (2.0 * middle)
            } else {
                0.5_f64.copysign(at.y - middle)
            };
            Vec2::new(0.0, height)
        });
        let mut moved: Vec<_> = guess.collect();
        let mut product = vec![Vec2::zero(); moved.len()];
        let dot = |a: &[Vec2], b: &[Vec2]| -> f64 { a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum() };
        self.product(&moved, &mut product);
        let mut rest: Vec<_> = product.iter().map(|force| -*force).collect();
        let mut way = rest.clone();
        let (mut now, first) = (dot(&rest, &rest), dot(&rest, &rest));
        while now > 1e-16 * first {
            self.product(&way, &mut product);
            let length = now / dot(&way, &product);
            for k in 0..moved.len() {
                moved[k] += way[k] * length;
                rest[k] += product[k] * -length;
            }
            let next = dot(&rest, &rest);
            for (way, rest) in way.iter_mut().zip(&rest) {
                *way = *rest + *way * (next / now);
            }
            now = next;
        }
        moved
    }

    fn energy(&self, moved: &[Vec2]) -> f64 {
        let of = |&(i, j, direction, stiffness): &(usize, usize, Vec2, f64)| {
            0.5 * stiffness * (moved[j] - moved[i]).dot(direction).powi(2)
        };
        self.springs.iter().map(of).sum()
    }

    /// Largest stretch per unit of displacement of bonds near a tip; those in the corners of the strip do not count.
    fn largest_stretch(&self, moved: &[Vec2], tip: Vec2, reach: f64) -> f64 {
        let of = |&(i, j, direction, _): &(usize, usize, Vec2, f64)| {
            (moved[j] - moved[i]).dot(direction) / (self.nodes[j] - self.nodes[i]).norm()
        };
        let is_near = |spring: &&(usize, usize, Vec2, f64)| {
            let middle = (self.nodes[spring.0] + self.nodes[spring.1]) * 0.5;
            (middle - tip).norm() < reach
        };
        let near = self.springs.iter().filter(is_near);
        near.map(of).fold(0.0, f64::max)
    }
}

/// Bonds that do not cross the line to the left of a tip.
fn cracked(grains: &Grains, tip: Vec2) -> Bonds {
    let admits = |_, a: Vec2, b: Vec2| {
        let share = (tip.y - a.y) / (b.y - a.y);
        (a.y < tip.y) == (b.y < tip.y) || a.x + (b.x - a.x) * share > tip.x
    };
    Bonds::within_horizon(grains, admits).unwrap()
}

/// Energy release per fracture energy when the first bond breaks, and whether the kernel breaks bonds just above that and
/// none just below.
fn start(weight: Weight, ratio: f64, rows: usize) -> (f64, [usize; 2]) {
    let columns = 2 * rows;
    let held = ratio.floor() as usize;
    let mut block = grain(lattice(columns, rows), ratio, weight);
    block.breaking = Some(BreakingRule::TensionOnly);
    // Small stretches, so that the strip is linear.
    block.constants.critical_stretch = 1e-6;
    let s0 = block.constants.critical_stretch;
    let fracture_energy = block.constants.stiffness
        * s0
        * s0
        * block.constants.horizon.powi(4)
        * if weight == Weight::Constant {
            0.25
        } else {
            0.05
        };
    let grains = Grains::new(&[block]).unwrap();
    let line = (rows as f64 / 2.0 - 0.5) * H;
    let cut = |tip| cracked(&grains, Vec2::new(tip, line));
    let tip = (columns as f64 / 2.0 - 0.5) * H;
    let bonds = cut(tip);
    let strip = Strip::new(&grains, &bonds, held);
    let moved = strip.solve();
    let longer = Strip::new(&grains, &cut(tip + H), held);
    let shorter = Strip::new(&grains, &cut(tip - H), held);
    let release = (shorter.energy(&shorter.solve()) - longer.energy(&longer.solve())) / (2.0 * H);
    let pull = s0 / strip.largest_stretch(&moved, Vec2::new(tip, line), ratio * H);
    let broken = [0.999, 1.001].map(|factor| {
        let mut state = State::at_rest(&grains, bonds.clone());
        for (place, moved) in state.places.iter_mut().zip(&moved) {
            place.displacement = *moved * (pull * factor);
        }
        let still = forces(&grains, &settings(1e-9), &state);
        let mut workspace = Workspace::new(&grains, &settings(1e-9), &state);
        workspace.evaluate(&grains, &settings(1e-9), &mut state);
        let largest = still
            .iter()
            .zip(&strip.is_free)
            .filter(|(_, is_free)| **is_free);
        let largest = largest.map(|(force, _)| force.norm()).fold(0.0, f64::max);
        let scale = grains.rows[0].constants.stiffness * s0 * H * H;
        let is_near = |pair: &&Pair| {
            let (i, j) = pair.indices();
            let middle = (grains.position[i] + grains.position[j]) * 0.5;
            (middle - Vec2::new(tip, line)).norm() < ratio * H
        };
        assert!(
            factor > 1.0 || largest < 1e-4 * scale,
            "{largest:e} {scale:e}"
        );
        workspace.broken.iter().filter(is_near).count()
    });
    (release * pull * pull / fracture_energy, broken)
}

#[test]
fn a_crack_starts_at_the_energy_release_of_the_lattice() {
    for (weight, ratio, expected) in [
        (Weight::Constant, 3.015, 1.13),
        (Weight::Constant, 4.015, 0.78),
        (Weight::Conic, 3.015, 1.34),
        (Weight::Conic, 4.015, 1.00),
    ] {
        let (found, broken) = start(weight, ratio, 48);
        assert!(
            (found / expected - 1.0).abs() < 0.01,
            "{weight:?} {ratio}: {found}"
        );
        assert!(
            broken[0] == 0 && broken[1] > 0,
            "{weight:?} {ratio}: {broken:?}"
        );
    }
}
