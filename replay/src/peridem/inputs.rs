//! What a case says: grains, contact, walls, steps.

use crate::error::Fault;
use crate::fields::Fields;
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::ContactLaw;
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::{Settings, Walls};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{BondConstants, Weight};
use gouge_peridem::mode::Mode;
use gouge_peridem::state::State;
use gouge_peridem::wall_law::WallLaw;
use gouge_peridem::world::World;

/// Largest number of nodes of a grain, and of steps.
const MOST: usize = 1 << 31;
/// Walls of a case without any, as its series gives them: left, right, top, bottom.
pub(super) const FAR_WALLS: [f64; 4] = [-1000.0, 1000.0, 1000.0, -1000.0];

/// A case: what moves, for how many steps, and how often it is written.
pub(super) struct Input {
    pub(super) world: World,
    pub(super) steps: usize,
    pub(super) interval: usize,
}

/// A case whose grains are those of another: with its own weight and number of steps.
#[derive(Clone, Copy, Default)]
pub(super) struct Variant {
    pub(super) weight: Weight,
    pub(super) steps: Option<usize>,
}

/// What all grains of a case share.
struct Shared<'a> {
    mode: Mode,
    weight: Weight,
    breaks: bool,
    touches_itself: bool,
    case: &'a Fields<'a>,
}

/// Read a case.
pub(super) fn read(case: &Fields, mode: Mode, variant: Variant) -> Result<Input, Fault> {
    let conf = case.inside("conf")?;
    let flag = |key: &str| conf.number_or(key, 0.0).map(|value| value != 0.0);
    let shared = Shared {
        mode,
        weight: variant.weight,
        breaks: flag("enable_fracture")?,
        touches_itself: flag("self_contact")?,
        case,
    };
    let rows = case.list("grains")?;
    let grains: Vec<_> = rows
        .iter()
        .map(|row| grain(row, &shared))
        .collect::<Result<_, _>>()?;
    let all = Grains::new(&grains)?;
    let bonds = bonds(&rows, &all)?;
    let mut state = State::at_rest(&all, bonds);
    for (row, of) in rows.iter().zip(&all.rows) {
        let nodes = of.nodes.len();
        state.velocity[of.nodes.clone()].copy_from_slice(&vectors(row, "vx", "vy", nodes)?);
        state.acceleration[of.nodes.clone()].copy_from_slice(&vectors(row, "ax", "ay", nodes)?);
    }
    let settings = settings(&shared, &conf, &mut state)?;
    let steps = match variant.steps {
        Some(steps) => steps,
        None => conf.count("timesteps", 0, MOST)?,
    };
    Ok(Input {
        world: World::new(all, settings, state, mode.beginning())?,
        steps,
        interval: conf.count("modulo", 1, MOST)?,
    })
}

/// One value for all nodes, or one for each; zero if there is none.
fn column(row: &Fields, key: &str, nodes: usize) -> Result<Vec<f64>, Fault> {
    let Some(value) = row.optional(key) else {
        return Ok(vec![0.0; nodes]);
    };
    match value.as_number() {
        Ok(number) => Ok(vec![number; nodes]),
        Err(_) => row.numbers_of(key, nodes),
    }
}

fn vectors(row: &Fields, x: &str, y: &str, nodes: usize) -> Result<Vec<Vec2>, Fault> {
    let (x, y) = (column(row, x, nodes)?, column(row, y, nodes)?);
    Ok(x.into_iter().zip(y).map(|(x, y)| Vec2::new(x, y)).collect())
}

fn grain(row: &Fields, shared: &Shared) -> Result<Grain, Fault> {
    let nodes = row.list("x")?.len();
    let position = vectors(row, "x", "y", row.list_of("y", nodes)?.len())?;
    let is_set = |key: &str| row.number_or(key, 1.0).map(|value| value != 0.0);
    let clamped = match is_set("movable")? {
        true => row
            .list("clamped")?
            .iter()
            .map(|node| node.as_index(nodes, &format!("a node below {nodes}")))
            .collect::<Result<_, _>>()?,
        false => (0..nodes).collect(),
    };
    let constants = constants(row, shared.weight)?;
    let breaks = shared.breaks && is_set("breakable")?;
    let touches_itself = match shared.mode.is_of_authors() {
        true => shared.touches_itself && breaks,
        false => shared.touches_itself,
    };
    Ok(Grain {
        position,
        area: row.numbers_of("V", nodes)?,
        density: row.positive("rho")?,
        constants,
        breaking: breaks.then(|| shared.mode.breaking()),
        touches_itself,
        contact_stiffness: row.positive("c")?,
        material: 0,
        clamped,
        load: vectors(row, "force_density_x", "force_density_y", nodes)?,
    })
}

/// Constants of the bonds. Those of a case are of the constant weight; of another weight, stiffness and critical stretch
/// keep the energy of an isotropic stretch and the fracture energy.
fn constants(row: &Fields, weight: Weight) -> Result<BondConstants, Fault> {
    let (stiffness, critical_stretch) = match weight {
        Weight::Constant => (1.0, 1.0),
        Weight::Conic => (4.0, 1.25_f64.sqrt()),
        Weight::Parabolic => (2.5, 1.2_f64.sqrt()),
    };
    Ok(BondConstants {
        weight,
        horizon: row.positive("eps")?,
        stiffness: stiffness * row.positive("c")?,
        critical_stretch: critical_stretch * row.positive("s0")?,
    })
}

/// The bonds that a case lists, or all nodes within the horizon if it does not list them; as many as it says.
fn bonds(rows: &[Fields], grains: &Grains) -> Result<Bonds, Fault> {
    let mut lists = Vec::new();
    for (row, of) in rows.iter().zip(&grains.rows) {
        let nodes = of.nodes.len();
        let node = |value: &Fields| value.as_index(nodes, &format!("a node below {nodes}"));
        let Ok(list) = row.list("bonds") else {
            lists.push(None);
            continue;
        };
        let pair = |value: &Fields| {
            let ends = value.as_list()?;
            match ends.as_slice() {
                [i, j] => Ok([node(i)?, node(j)?]),
                _ => Err(value.refuse("two nodes")),
            }
        };
        lists.push(Some(list.iter().map(pair).collect::<Result<Vec<_>, _>>()?));
    }
    let bonds = if lists.iter().any(Option::is_none) {
        let all = Bonds::within_horizon(grains, |_, _, _| true)?;
        let local = |(grain, list): (usize, Option<Vec<[usize; 2]>>)| {
            let nodes = &grains.rows[grain].nodes;
            let own = || {
                let inside = all.all().filter(|(_, later, _)| nodes.contains(later));
                inside.map(|(earlier, later, _)| [earlier - nodes.start, later - nodes.start])
            };
            list.unwrap_or_else(|| own().collect())
        };
        let lists: Vec<_> = lists.into_iter().enumerate().map(local).collect();
        Bonds::from_pairs(grains, &lists)?
    } else {
        let lists: Vec<_> = lists.into_iter().flatten().collect();
        Bonds::from_pairs(grains, &lists)?
    };
    for (row, of) in rows.iter().zip(&grains.rows) {
        if let Some(number) = row.optional("n_bonds") {
            let found = bonds.count_of(of.nodes.clone());
            if number.as_number()? != found as f64 {
                return Err(number.refuse(format!("the number of bonds, {found}")));
            }
        }
    }
    Ok(bonds)
}

fn settings(shared: &Shared, conf: &Fields, state: &mut State) -> Result<Settings, Fault> {
    let contact = shared.case.inside("contact")?;
    let law = ContactLaw {
        radius: contact.positive("R_c")?,
        damping_ratio: contact.number("r_d")?,
        friction: contact.number("mu")?,
        reading: shared.mode.contact(),
    };
    let stiffness = contact.positive("K_n")?;
    let mut walls = None;
    state.walls = FAR_WALLS;
    if let Some(positions) = shared.case.optional("wall_left_right_top_bottom") {
        state.walls = positions.as_array()?;
        walls = Some(Walls {
            law: WallLaw {
                radius: law.radius,
                stiffness,
                damping_ratio: law.damping_ratio,
                friction: law.friction,
                reading: shared.mode.walls(),
            },
            velocity: wall_velocity(conf)?,
        });
    }
    Ok(Settings {
        time_step: conf.positive("dt")?,
        gravity: Vec2::zero(),
        break_order: shared.mode.break_order(),
        contact: Some(Contact {
            law,
            stiffness: vec![vec![stiffness]],
            shares_sticking: false,
        }),
        walls,
    })
}

/// Velocities of the walls: a list in the order of their positions, or one key for each.
fn wall_velocity(conf: &Fields) -> Result<[f64; 4], Fault> {
    for key in ["wall_speed", "wall_speeds", "wall_velocity"] {
        if let Some(list) = conf.optional(key) {
            return list.as_array();
        }
    }
    let mut velocity = [0.0; 4];
    for (velocity, wall) in velocity.iter_mut().zip(["left", "right", "top", "bottom"]) {
        *velocity = conf.number_or(&format!("speed_wall_{wall}"), 0.0)?;
        *velocity = conf.number_or(&format!("wall_{wall}_speed"), *velocity)?;
    }
    Ok(velocity)
}
