//! Forces of straight walls.

use crate::contact_law::{FrictionStep, Node};
use crate::error::{SetupError, require};
use crate::grain::Grains;
use crate::state::{State, moved};
use crate::wall_law::{NodeAtWall, WallLaw, WallReading};
use gouge_common::geometry::Vec2;

/// Names of the walls, in their order.
const WALLS: [&str; 4] = ["left", "right", "top", "bottom"];

/// Unit normals that point out of the container.
const OUTWARD: [Vec2; 4] = [
    Vec2 { x: -1.0, y: 0.0 },
    Vec2 { x: 1.0, y: 0.0 },
    Vec2 { x: 0.0, y: 1.0 },
    Vec2 { x: 0.0, y: -1.0 },
];

/// Four straight walls: left, right, top, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walls {
    /// How they act.
    pub law: WallLaw,
    /// Their velocities in m/s, along x for the left and the right one, along y for the others.
    pub velocity: [f64; 4],
}

impl Walls {
    /// Check the coefficients, and that the walls are so far apart that no node touches two opposite ones.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a number outside its range.
    pub fn validate(&self, positions: &[f64; 4]) -> Result<(), SetupError> {
        self.law.validate()?;
        let [left, right, top, bottom] = *positions;
        for distance in [right - left, top - bottom] {
            let is_wide = distance > 2.0 * self.law.radius || distance.is_infinite();
            let distance = distance.min(f64::MAX);
            require(
                "distance of walls",
                distance,
                "more than two contact radii",
                is_wide,
            )?;
        }
        for velocity in self.velocity {
            require("velocity of walls", velocity, "finite", true)?;
        }
        Ok(())
    }

    /// Move the walls by a time step in s.
    pub(crate) fn advance(&self, positions: &mut [f64; 4], step: f64) {
        for (position, velocity) in positions.iter_mut().zip(self.velocity) {
            *position += velocity * step;
        }
    }

    /// Whether nodes at a distance in m from a wall are so far behind it that it no longer pushes them back. The authors'
    /// readings let them go.
    fn is_lost(&self, distance: f64) -> bool {
        distance <= -self.law.radius
            && matches!(self.law.reading, WallReading::Paper | WallReading::Exact)
    }

    /// The first node that a wall has lost, with the wall and the depth in m.
    pub(crate) fn first_behind(&self, state: &State) -> Option<(usize, &'static str, f64)> {
        state.places.iter().enumerate().find_map(|(node, place)| {
            let distances = distances(&state.walls, place.position());
            let behind = |wall: &usize| self.is_lost(distances[*wall]);
            let wall = (0..WALLS.len()).find(behind)?;
            Some((node, WALLS[wall], -distances[wall]))
        })
    }
}

/// Distances in m of a point from all walls, positive inside.
fn distances(walls: &[f64; 4], point: Vec2) -> [f64; 4] {
    let [left, right, top, bottom] = *walls;
    [
        point.x - left,
        right - point.x,
        top - point.y,
        point.y - bottom,
    ]
}

/// The nearer one of two walls.
fn nearer(first: usize, second: usize, distances: &[f64; 4]) -> usize {
    if distances[second] < distances[first] {
        second
    } else {
        first
    }
}

/// The walls that a node may touch.
struct NearWalls {
    /// The nearer one of the left and the right wall, and of the top and the bottom wall.
    walls: [usize; 2],
    /// Distances in m from them, positive inside.
    distances: [f64; 2],
}

/// What a pass over walls reads.
pub(super) struct WallPass<'a> {
    pub(super) grains: &'a Grains,
    pub(super) walls: &'a Walls,
    pub(super) time_step: f64,
}

impl WallPass<'_> {
    /// Elastic forces of all walls on each node in N per metre of depth.
    pub(super) fn elastic(&self, state: &State) -> Vec<Vec2> {
        let of_node = |node: usize| {
            let near = self.near(state, node);
            let push = self
                .walls
                .law
                .corner_push(near.distances, self.grains.area[node]);
            let forces = [0, 1].map(|k| OUTWARD[near.walls[k]] * -push[k]);
            forces[0] + forces[1]
        };
        (0..self.grains.nodes()).map(of_node).collect()
    }

    /// The nearer wall of either direction.
    fn near(&self, state: &State, node: usize) -> NearWalls {
        let distances = distances(&state.walls, state.places[node].position());
        let walls = [nearer(0, 1, &distances), nearer(2, 3, &distances)];
        NearWalls {
            walls,
            distances: walls.map(|wall| distances[wall]),
        }
    }

    /// Add the forces of all walls to force densities in N/m^3, book their work, and return the forces on the walls, and
    /// whether a wall has lost a node.
    ///
    /// Elastic work is the mean of the forces before and after the step times the displacement in it. What damping and
    /// friction do on the motion relative to a wall is lost; what they do on the motion of the wall is its work, too.
    pub(super) fn add_forces(
        &self,
        state: &mut State,
        pushes: &mut [Vec2],
        force: &mut [Vec2],
    ) -> ([Vec2; 4], bool) {
        let mut reactions = [Vec2::zero(); 4];
        let mut has_lost = false;
        for node in 0..self.grains.nodes() {
            let NearWalls { walls, distances } = self.near(state, node);
            let before = pushes[node];
            let radius = self.walls.law.radius;
            let is_far = distances.iter().all(|&distance| distance >= radius);
            if is_far && before == Vec2::zero() {
                continue;
            }
            has_lost |= distances
                .iter()
                .any(|&distance| self.walls.is_lost(distance));
            let area = self.grains.area[node];
            let push = self.walls.law.corner_push(distances, area);
            let mut total = Vec2::zero();
            let mut after = Vec2::zero();
            for (wall, (distance, push)) in walls.into_iter().zip(distances.into_iter().zip(push)) {
                let on_node = self.force(state, node, wall, distance, push);
                after += on_node.repulsion;
                total += on_node.total();
                reactions[wall] += -on_node.total();
                let of_wall = self.velocity_of(wall);
                let velocity = state.velocity[node] - of_wall;
                state.work.damping -= on_node.damping.dot(velocity) * self.time_step;
                state.work.friction -= on_node.friction.dot(velocity) * self.time_step;
                let dragging = on_node.damping + on_node.friction;
                state.work.walls += dragging.dot(of_wall) * self.time_step;
            }
            let moved = moved(
                state.velocity[node],
                state.acceleration[node],
                self.time_step,
            );
            state.work.walls += (before + after).dot(moved) * 0.5;
            pushes[node] = after;
            force[node] += total * (1.0 / area);
        }
        (reactions, has_lost)
    }

    /// Velocity of a wall in m/s.
    fn velocity_of(&self, wall: usize) -> Vec2 {
        let outward = OUTWARD[wall];
        Vec2::new(outward.x.abs(), outward.y.abs()) * self.walls.velocity[wall]
    }

    fn force(
        &self,
        state: &State,
        node: usize,
        wall: usize,
        distance: f64,
        push: f64,
    ) -> crate::contact_law::ContactForce {
        let at = NodeAtWall {
            node: Node {
                area: self.grains.area[node],
                density: self.grains.of(node).density,
            },
            distance,
            outward: OUTWARD[wall],
            velocity: state.velocity[node] - self.velocity_of(wall),
        };
        let step = FrictionStep {
            time_step: self.time_step,
            stick_share: 1.0,
        };
        self.walls.law.force(&at, push, &step)
    }
}
