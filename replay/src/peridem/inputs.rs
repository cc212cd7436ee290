//! What a case says: grains, contact, walls, steps.

use super::refusals::{self, CONTACT};
use super::{options, pairs};
use crate::error::Fault;
use crate::fields::Fields;
use gouge_common::geometry::Vec2;
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::ContactLaw;
use gouge_peridem::contacts::Contact;
use gouge_peridem::error::{SetupError, TooFast};
use gouge_peridem::forces::{Settings, Walls};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{BondConstants, Weight};
use gouge_peridem::mode::Mode;
use gouge_peridem::state::State;
use gouge_peridem::wall_law::WallLaw;
use gouge_peridem::world::World;
use std::collections::BTreeSet;

/// Largest number of nodes of a grain, and of steps.
const MOST: usize = 1 << 31;
/// Walls of a case without any, as its series gives them: left, right, top, bottom.
pub(super) const FAR_WALLS: [f64; 4] = [-1000.0, 1000.0, 1000.0, -1000.0];

/// A case: what moves, for how many steps, and how often it is written.
pub(super) struct Input {
    pub(super) world: World,
    pub(super) steps: usize,
    pub(super) interval: usize,
    /// Keys of grains that have no meaning here.
    pub(super) ignored: BTreeSet<String>,
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
    let shared = Shared {
        mode,
        weight: variant.weight,
        breaks: conf.switch_or("enable_fracture", false)?,
        touches_itself: conf.switch_or("self_contact", false)?,
        case,
    };
    let rows = case.filled_list("grains", "grain")?;
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
    let interval = conf.count("modulo", 1, MOST)?;
    let mut world = World::new(all, settings, state, mode.beginning())?;
    if mode == Mode::Corrected {
        let guarded = world.guarded();
        world = guarded.map_err(|motion| conf.refuse_key("dt", short_enough(1, &motion)))?;
    }
    Ok(Input {
        world,
        steps,
        interval,
        ignored: rows.iter().flat_map(options::without_meaning).collect(),
    })
}

/// What time steps are accepted instead of one with which a node is too fast in a step.
pub(super) fn short_enough(step: usize, motion: &TooFast) -> String {
    format!("short enough for contacts, but in step {step}, {motion}")
}

/// One value for all nodes, or one for each.
fn column(row: &Fields, key: &str, nodes: usize) -> Result<Vec<f64>, Fault> {
    let accepted = format!("a number, or a list of {nodes} numbers");
    let value = row.required(key, &accepted)?;
    if let Ok(number) = value.as_number() {
        return Ok(vec![number; nodes]);
    }
    let list = value.as_list().map_err(|_| value.refuse(&accepted))?;
    match list.len() == nodes {
        true => list.iter().map(Fields::as_number).collect(),
        false => Err(value.refuse(accepted)),
    }
}

/// Areas of nodes in m^2.
fn areas(row: &Fields, nodes: usize) -> Result<Vec<f64>, Fault> {
    let accepted = format!("a positive number, or a list of {nodes} positive numbers");
    let value = row.required("V", &accepted)?;
    match value.value().is_array() {
        true => row.usables_of("V", nodes),
        false => Ok(vec![value.as_usable()?; nodes]),
    }
}

/// Two columns, each zero if it is absent.
fn vectors(row: &Fields, x: &str, y: &str, nodes: usize) -> Result<Vec<Vec2>, Fault> {
    let column = |key: &str| match row.optional(key) {
        Some(_) => column(row, key, nodes),
        None => Ok(vec![0.0; nodes]),
    };
    Ok(column(x)?
        .into_iter()
        .zip(column(y)?)
        .map(|(x, y)| Vec2::new(x, y))
        .collect())
}

fn grain(row: &Fields, shared: &Shared) -> Result<Grain, Fault> {
    let nodes = row.filled_list("x", "number")?.len();
    let clamped = match (row.switch_or("movable", true)?, row.optional("clamped")) {
        (false, _) => (0..nodes).collect(),
        (true, None) => Vec::new(),
        (true, Some(list)) => list
            .as_list()?
            .iter()
            .map(|node| node.as_index(nodes, &format!("a node below {nodes}")))
            .collect::<Result<_, _>>()?,
    };
    let constants = constants(row, shared.weight)?;
    let breaks = row.switch_or("breakable", true)? && shared.breaks;
    let touches_itself = match shared.mode.is_of_authors() {
        true => shared.touches_itself && breaks,
        false => shared.touches_itself,
    };
    Ok(Grain {
        position: row.vectors("x", "y", nodes)?,
        area: areas(row, nodes)?,
        density: row.usable("rho")?,
        constants,
        breaking: breaks.then(|| shared.mode.breaking()),
        touches_itself,
        contact_stiffness: row.usable("c")?,
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
        horizon: row.usable("eps")?,
        stiffness: stiffness * row.usable("c")?,
        critical_stretch: critical_stretch * row.positive("s0")?,
    })
}

/// The bonds that a grain lists; nothing if it gives none, or a rule in words that only their number can check.
fn listed(row: &Fields, position: &[Vec2]) -> Result<Option<Vec<[usize; 2]>>, Fault> {
    let Some(bonds) = row.optional("bonds") else {
        return Ok(None);
    };
    if bonds.value().is_string() {
        row.required(
            "n_bonds",
            "the number of bonds, because bonds is a rule in words",
        )?;
        return Ok(None);
    }
    let list = bonds.as_list();
    let list = list.map_err(|_| bonds.refuse("a list of pairs of nodes, or a rule in words"))?;
    pairs::read(&list, position).map(Some)
}

/// The bonds that grains list, or all nodes within the horizon of those that list none; as many as a grain says.
fn bonds(rows: &[Fields], grains: &Grains) -> Result<Bonds, Fault> {
    let lists = rows.iter().zip(&grains.rows);
    let lists = lists.map(|(row, of)| listed(row, &grains.position[of.nodes.clone()]));
    let mut lists = lists.collect::<Result<Vec<_>, _>>()?;
    let refused = |error: SetupError| match error {
        SetupError::Bond { grain, .. } => refusals::of_bond(&rows[grain], error),
        _ => error.into(),
    };
    if lists.iter().any(Option::is_none) {
        let all = Bonds::within_horizon(grains, |_, _, _| true).map_err(refused)?;
        for (list, of) in lists.iter_mut().zip(&grains.rows) {
            let inside = all.all().filter(|(_, later, _)| of.nodes.contains(later));
            let first = of.nodes.start;
            let own = inside.map(|(earlier, later, _)| [earlier - first, later - first]);
            list.get_or_insert_with(|| own.collect());
        }
    }
    let lists: Vec<_> = lists.into_iter().flatten().collect();
    let bonds = Bonds::from_pairs(grains, &lists).map_err(refused)?;
    for (row, of) in rows.iter().zip(&grains.rows) {
        let found = bonds.count_of(of.nodes.clone());
        match row.optional("n_bonds") {
            Some(number) if number.as_number()? != found as f64 => {
                return Err(number.refuse(format!("the number of bonds, {found}")));
            }
            _ => {}
        }
    }
    Ok(bonds)
}

fn settings(shared: &Shared, conf: &Fields, state: &mut State) -> Result<Settings, Fault> {
    let contact = shared.case.inside("contact")?;
    options::require_known(conf, &contact)?;
    let coefficient = |switch: &str, key: &str| match conf.switch_or(switch, true)? {
        true => contact.not_negative(key),
        false => Ok(0.0),
    };
    let velocity = options::wall_velocity(shared.case, conf)?;
    let law = ContactLaw {
        radius: contact.usable("R_c")?,
        damping_ratio: coefficient("allow_damping", "r_d")?,
        friction: coefficient("allow_friction", "mu")?,
        reading: shared.mode.contact(),
    };
    let validated = law.validate();
    validated.map_err(|error| refusals::of_parameter(&contact, &CONTACT, error))?;
    let stiffness = contact.usable("K_n")?;
    let mut walls = None;
    state.walls = FAR_WALLS;
    if let Some(positions) = shared.case.optional("wall_left_right_top_bottom") {
        state.walls = positions.as_array()?;
        let own = Walls {
            law: WallLaw {
                radius: law.radius,
                stiffness,
                damping_ratio: law.damping_ratio,
                friction: law.friction,
                reading: shared.mode.walls(),
            },
            velocity,
        };
        let accepted = "left, right, top and bottom of a container, opposite walls more than two contact radii apart";
        let validated = own.validate(&state.walls);
        validated.map_err(|_| positions.refuse(accepted))?;
        walls = Some(own);
    }
    Ok(Settings {
        time_step: conf.usable("dt")?,
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
