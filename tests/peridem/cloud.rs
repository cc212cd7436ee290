//! Grains, settings and worlds for tests, and their matrix of small vibrations.

use faer::Mat;
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::BreakOrder;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::{Settings, Walls, Workspace};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{Material, Plane, Weight};
use gouge_peridem::state::State;
use gouge_peridem::wall_law::{WallLaw, WallReading};
use gouge_peridem::world::{Beginning, World};

/// Distance of the nodes of lattices in m.
pub const H: f64 = 1e-3;

pub fn material() -> Material {
    Material {
        young_modulus: 1e9,
        poisson_ratio: 1.0 / 3.0,
        fracture_energy: 100.0,
        density: 1200.0,
        plane: Plane::Stress,
    }
}

/// Nodes of a square lattice, row by row from the origin.
pub fn lattice(columns: usize, rows: usize) -> Vec<Vec2> {
    let at = |k: usize| Vec2::new((k % columns) as f64 * H, (k / columns) as f64 * H);
    (0..columns * rows).map(at).collect()
}

/// Lattice nodes in a disc whose centre is between four nodes.
pub fn disc(centre: Vec2, radius: f64) -> Vec<Vec2> {
    let n = (radius / H).ceil() as i32;
    let axis = move || (-n..n).map(|k| (f64::from(k) + 0.5) * H);
    let all = axis().flat_map(move |y| axis().map(move |x| Vec2::new(x, y)));
    let inside = all.filter(|arm| arm.norm() <= radius);
    inside.map(|arm| centre + arm).collect()
}

/// An unbreakable grain whose nodes have the area of a lattice cell, with the horizon in lattice distances.
pub fn grain(position: Vec<Vec2>, ratio: f64, weight: Weight) -> Grain {
    let constants = material().bond_constants(weight, ratio * H).unwrap();
    let constant = material().bond_constants(Weight::Constant, ratio * H);
    Grain {
        area: vec![H * H; position.len()],
        position,
        density: material().density,
        constants,
        breaking: None,
        touches_itself: false,
        contact_stiffness: constant.unwrap().stiffness,
        material: 0,
        clamped: Vec::new(),
        load: Vec::new(),
    }
}

/// Bonds alone.
pub fn settings(time_step: f64) -> Settings {
    Settings {
        time_step,
        gravity: Vec2::zero(),
        break_order: BreakOrder::BreakFirst,
        contact: None,
        walls: None,
    }
}

/// Contact as stiff as bonds of a horizon of three lattice distances, within 1.5 lattice distances.
pub fn contact(damping_ratio: f64, friction: f64) -> Contact {
    let constants = material().bond_constants(Weight::Constant, 3.0 * H);
    Contact {
        law: ContactLaw {
            radius: 1.5 * H,
            damping_ratio,
            friction,
            reading: ContactReading::Symmetric,
        },
        stiffness: vec![vec![constants.unwrap().stiffness / (1.5 * H)]],
        shares_sticking: true,
    }
}

/// Walls at rest, as stiff as [`contact`].
pub fn walls(damping_ratio: f64, friction: f64) -> Walls {
    let contact = contact(damping_ratio, friction);
    Walls {
        law: WallLaw {
            radius: contact.law.radius,
            stiffness: contact.stiffness[0][0],
            damping_ratio,
            friction,
            reading: WallReading::Paper,
        },
        velocity: [0.0; 4],
    }
}

/// Grains at rest with all bonds within their horizons.
pub fn at_rest(grains: &[Grain]) -> (Grains, State) {
    let grains = Grains::new(grains).unwrap();
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true).unwrap();
    let state = State::at_rest(&grains, bonds);
    (grains, state)
}

/// A world of grains whose state at the beginning is changed.
pub fn world(grains: &[Grain], settings: Settings, prepare: impl FnOnce(&mut State)) -> World {
    let (grains, mut state) = at_rest(grains);
    prepare(&mut state);
    World::new(grains, settings, state, Beginning::Forces).unwrap()
}

pub fn run(world: &mut World, steps: usize) {
    for _ in 0..steps {
        world.step().unwrap();
    }
}

/// Give all nodes of a grain a velocity.
pub fn throw(grains: &Grains, state: &mut State, grain: usize, velocity: Vec2) {
    state.velocity[grains.rows[grain].nodes.clone()].fill(velocity);
}

/// Force densities on all nodes.
pub fn forces(grains: &Grains, settings: &Settings, state: &State) -> Vec<Vec2> {
    let mut workspace = Workspace::new(grains, settings, state);
    workspace.evaluate(grains, settings, &mut state.clone());
    workspace.force
}

/// Minus the derivatives of forces by displacements, scaled by the masses: its eigenvalues are squares of frequencies.
pub fn vibration(grains: &Grains, settings: &Settings, state: &State) -> Mat<f64> {
    let n = grains.nodes();
    let mut matrix = Mat::zeros(2 * n, 2 * n);
    let shift = 1e-6 * H;
    for column in 0..2 * n {
        let moved = |sign: f64| {
            let mut state = state.clone();
            let way = [Vec2::new(sign * shift, 0.0), Vec2::new(0.0, sign * shift)];
            state.places[column / 2].displacement += way[column % 2];
            forces(grains, settings, &state)
        };
        let own_mass = grains.mass(column / 2);
        for (node, (plus, minus)) in moved(1.0).iter().zip(moved(-1.0)).enumerate() {
            let slope = (minus - *plus) * (grains.area[node] / (2.0 * shift));
            let scale = 1.0 / (own_mass * grains.mass(node)).sqrt();
            matrix[(2 * node, column)] = slope.x * scale;
            matrix[(2 * node + 1, column)] = slope.y * scale;
        }
    }
    matrix
}

/// Linear and angular momentum about the origin.
pub fn momenta(world: &World) -> (Vec2, f64) {
    let (grains, state) = (world.grains(), world.state());
    let (mut linear, mut angular) = (Vec2::zero(), 0.0);
    for node in 0..grains.nodes() {
        let own = state.velocity[node] * grains.mass(node);
        linear += own;
        angular += state.places[node].position().cross(own);
    }
    (linear, angular)
}

/// Kinetic energy and energy of bonds and contacts.
pub fn energy(world: &World) -> f64 {
    let energies = world.energies();
    energies.kinetic + energies.bonds + energies.contacts + energies.external
}
