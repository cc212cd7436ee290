//! Stops nodes that are so fast that contacts could be missed.

use crate::error::TooFast;
use crate::forces::Settings;
use crate::grain::Grains;
use crate::state::{State, moved};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Largest displacement per step along an axis, in contact radii, of a node relative to other nodes and to walls.
const LARGEST_MOVE: f64 = 0.5;

/// The bound on displacements per step.
///
/// $$ \max_{x, y} |\Delta_x - \Delta_y| \le \frac{R_c}{2} $$
///
/// along each axis, over all nodes x and y and the walls across that axis; $\Delta$ is a displacement in a step, in m.
/// Two nodes thus approach each other by at most $R_c/\sqrt 2$ per step. A node that passes between two others at a
/// distance g is nearer than $R_c$ to one of them along $\sqrt{R_c^2 - g^2/4}$ before it is level with them. For
/// $g \le \sqrt 2 R_c$ no step is longer than that, so at least one pushes it back. Contact radii are at least 1.2 of the
/// smallest distance of nodes. A wall pushes along $R_c$: in two steps at least.
///
/// A common motion does not count, whatever its speed.
#[rendered]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guard {
    /// Largest displacement in m along an axis.
    limit: f64,
}

/// The smallest and the largest displacement in m along either axis.
struct Extent {
    least: Vec2,
    most: Vec2,
}

impl Extent {
    /// That of all nodes and of the walls that exist, in the coming step.
    fn of(settings: &Settings, state: &State) -> Self {
        let infinite = f64::INFINITY;
        let mut least = Vec2::new(infinite, infinite);
        let mut most = -least;
        let mut add = |moved: Vec2| {
            least = Vec2::new(least.x.min(moved.x), least.y.min(moved.y));
            most = Vec2::new(most.x.max(moved.x), most.y.max(moved.y));
        };
        let step = settings.time_step;
        let motions = state.velocity.iter().zip(&state.acceleration);
        motions.for_each(|(&velocity, &acceleration)| add(moved(velocity, acceleration, step)));
        for axis in [0, 1] {
            for velocity in walls_across(settings, state, axis) {
                // Minima and maxima leave out what is not a number: walls do not move along themselves.
                let moved = [velocity * step, f64::NAN];
                add(Vec2::new(moved[axis], moved[1 - axis]));
            }
        }
        Self { least, most }
    }
}

/// Velocities in m/s of the walls that exist across the x or the y axis.
fn walls_across<'a>(
    settings: &'a Settings,
    state: &'a State,
    axis: usize,
) -> impl Iterator<Item = f64> + 'a {
    let walls = settings.walls.iter();
    walls.flat_map(move |walls| {
        let both = [2 * axis, 2 * axis + 1].into_iter();
        let existing = both.filter(|&wall| state.walls[wall].is_finite());
        existing.map(|wall| walls.velocity[wall])
    })
}

fn along(vector: Vec2, axis: usize) -> f64 {
    [vector.x, vector.y][axis]
}

impl Guard {
    /// The bound for grains that can touch each other, themselves or walls; none for others.
    pub(crate) fn of(grains: &Grains, settings: &Settings) -> Option<Self> {
        let contact = settings.contact.as_ref()?;
        let touches_itself = grains.rows.iter().any(|row| row.touches_itself);
        let can_touch = grains.rows.len() > 1 || touches_itself || settings.walls.is_some();
        can_touch.then_some(Self {
            limit: LARGEST_MOVE * contact.law.radius,
        })
    }

    /// Refuse a coming step in which contacts could be missed. Nothing has moved yet.
    pub(crate) fn check(
        &self,
        grains: &Grains,
        settings: &Settings,
        state: &State,
    ) -> Result<(), Box<TooFast>> {
        let extent = Extent::of(settings, state);
        let range = extent.most - extent.least;
        if !(range.x > self.limit || range.y > self.limit) {
            return Ok(());
        }
        let axis = usize::from(range.y > range.x);
        Err(Box::new(self.too_fast(
            grains,
            settings,
            state,
            (axis, along(range, axis)),
        )))
    }

    /// The error for a relative displacement along an axis in m, which is too large.
    #[cold]
    fn too_fast(
        &self,
        grains: &Grains,
        settings: &Settings,
        state: &State,
        (axis, distance): (usize, f64),
    ) -> TooFast {
        let step = settings.time_step;
        let moved = |node: usize| {
            let all = moved(state.velocity[node], state.acceleration[node], step);
            along(all, axis)
        };
        let speed = |node: usize| state.velocity[node].norm();
        let nodes = || 0..grains.nodes();
        let ends = [
            nodes().min_by(|&i, &j| moved(i).total_cmp(&moved(j))),
            nodes().max_by(|&i, &j| moved(i).total_cmp(&moved(j))),
        ];
        let [first, last] = ends.map(Option::unwrap_or_default);
        // Of nodes alone; a wall may move farther than all of them.
        let is_of_wall = moved(last) - moved(first) < distance;
        let mut node = if speed(first) > speed(last) {
            first
        } else {
            last
        };
        if is_of_wall {
            let least = walls_across(settings, state, axis).fold(f64::INFINITY, f64::min) * step;
            node = if least < moved(first) { last } else { first };
        }
        let grain = grains.grain_of[node] as usize;
        TooFast {
            grain,
            node: node - grains.rows[grain].nodes.start,
            speed: speed(node),
            other: if is_of_wall { "a wall" } else { "another node" },
            distance,
            limit: self.limit,
            safe_step: step * (self.limit / distance),
        }
    }
}
