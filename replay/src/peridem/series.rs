//! Rows of the tables that a repeated case writes.

use super::inputs::FAR_WALLS;
use crate::error::Fault;
use core::fmt::Write;
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_peridem::world::World;

/// Names of the walls.
const WALLS: [&str; 4] = ["left", "right", "top", "bottom"];

/// Tables in the making.
pub(super) struct Tables {
    pub(super) frames: String,
    pub(super) series: String,
    pub(super) bonds: String,
}

/// A bond that broke: its grain and its nodes, counted from the first of the grain, smaller first.
pub(super) type Broken = (usize, usize, usize);

pub(super) fn broken(world: &World, pair: Pair) -> Broken {
    let (i, j) = pair.indices();
    let grain = world.grains().grain_of[i] as usize;
    let first = world.grains().rows[grain].nodes.start;
    (grain, i - first, j - first)
}

impl Tables {
    pub(super) fn new(grains: usize) -> Self {
        let mut series = "step,t,kinetic,bond,contact,px,py,angular,dissipated_damping,dissipated_friction,bonds".to_owned();
        for grain in 0..grains {
            let _ = write!(series, ",cx{grain},cy{grain},bonds{grain},damage{grain}");
        }
        for wall in WALLS {
            let _ = write!(series, ",wall_{wall}");
        }
        for wall in WALLS {
            let _ = write!(series, ",{wall}_x,{wall}_y");
        }
        series.push('\n');
        Self {
            frames: "step,grain,node,x,y,vx,vy\n".to_owned(),
            series,
            bonds: "step,grain,i,j\n".to_owned(),
        }
    }

    /// Positions and velocities of all nodes, if all are finite.
    pub(super) fn add_frame(&mut self, world: &World) -> Result<(), Fault> {
        let (state, step) = (world.state(), world.state().steps);
        require_finite_motion(world)?;
        for (grain, row) in world.grains().rows.iter().enumerate() {
            for (local, node) in row.nodes.clone().enumerate() {
                let (p, v) = (state.places[node].position(), state.velocity[node]);
                let _ = writeln!(
                    self.frames,
                    "{step},{grain},{local},{:?},{:?},{:?},{:?}",
                    p.x, p.y, v.x, v.y
                );
            }
        }
        Ok(())
    }

    /// All bonds that broke up to now.
    pub(super) fn add_broken(&mut self, world: &World, broken: &[Broken]) {
        let step = world.state().steps;
        for (grain, i, j) in broken {
            let _ = writeln!(self.bonds, "{step},{grain},{i},{j}");
        }
    }

    /// Sums over grains, and walls, if all are finite.
    pub(super) fn add_sums(&mut self, world: &World) -> Result<(), Fault> {
        let row = sums(world);
        require_finite_row(self.series.lines().next().unwrap_or_default(), &row)?;
        self.series += &row;
        self.series.push('\n');
        Ok(())
    }
}

/// A row of sums, without its end.
fn sums(world: &World) -> String {
    let (state, energies) = (world.state(), world.energies());
    let (momentum, angular) = momenta(world);
    let work = state.work;
    let numbers = [
        world.time(),
        energies.kinetic,
        energies.bonds,
        energies.contacts,
        momentum.x,
        momentum.y,
        angular,
        work.damping,
        work.friction,
    ];
    let mut row = state.steps.to_string();
    for number in numbers {
        let _ = write!(row, ",{number:?}");
    }
    let _ = write!(row, ",{}", state.bonds.count());
    for grain in 0..world.grains().rows.len() {
        add_grain(&mut row, world, grain);
    }
    let walls = match world.settings().walls {
        Some(_) => state.walls,
        None => FAR_WALLS,
    };
    for position in walls {
        let _ = write!(row, ",{position:?}");
    }
    for reaction in world.reactions() {
        let _ = write!(row, ",{:?},{:?}", reaction.x, reaction.y);
    }
    row
}

/// Add centre of mass, number of bonds and mean damage of a grain.
fn add_grain(row: &mut String, world: &World, grain: usize) {
    let (grains, state) = (world.grains(), world.state());
    let nodes = grains.rows[grain].nodes.clone();
    let mut centre = Vec2::zero();
    let (mut area, mut damage) = (0.0, 0.0);
    for node in nodes.clone() {
        centre += state.places[node].position() * grains.area[node];
        area += grains.area[node];
        damage += state.bonds.damage(node);
    }
    let centre = centre * (1.0 / area);
    let damage = damage / nodes.len() as f64;
    let bonds = state.bonds.count_of(nodes);
    let _ = write!(row, ",{:?},{:?},{bonds},{damage:?}", centre.x, centre.y);
}

/// Refuse a row of which a number is not finite. Its columns have the names of a header.
fn require_finite_row(header: &str, row: &str) -> Result<(), Fault> {
    let mut columns = header.split(',').zip(row.split(','));
    let wrong = columns.find_map(|(name, text)| {
        let value = text.parse().ok().filter(|value: &f64| !value.is_finite());
        Some((name, value?))
    });
    let Some((name, value)) = wrong else {
        return Ok(());
    };
    let step = row.split(',').next().and_then(|step| step.parse().ok());
    Err(Fault::NoNumber {
        step: step.unwrap_or_default(),
        quantity: format!("{name} of series.csv"),
        value,
    })
}

/// Refuse positions and velocities that are not finite.
fn require_finite_motion(world: &World) -> Result<(), Fault> {
    let (grains, state) = (world.grains(), world.state());
    for (node, (place, velocity)) in state.places.iter().zip(&state.velocity).enumerate() {
        let position = place.position();
        let numbers = [
            ("x", position.x),
            ("y", position.y),
            ("vx", velocity.x),
            ("vy", velocity.y),
        ];
        if let Some((name, value)) = numbers.into_iter().find(|(_, value)| !value.is_finite()) {
            let grain = grains.grain_of[node] as usize;
            let local = node - grains.rows[grain].nodes.start;
            return Err(Fault::NoNumber {
                step: state.steps,
                quantity: format!("{name} of node {local} of grain {grain} in frames.csv"),
                value,
            });
        }
    }
    Ok(())
}

/// Momentum in kg/s and angular momentum about the origin in kg m/s, per metre of depth.
fn momenta(world: &World) -> (Vec2, f64) {
    let (grains, state) = (world.grains(), world.state());
    let (mut linear, mut angular) = (Vec2::zero(), 0.0);
    for node in 0..grains.nodes() {
        let own = state.velocity[node] * grains.mass(node);
        linear += own;
        angular += state.places[node].position().cross(own);
    }
    (linear, angular)
}
