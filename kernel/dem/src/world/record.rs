//! The whole state of a world as named columns, for checkpoints.

use super::begin::Start;
use super::choice::NormalChoice;
use super::continuation::Continuation;
use super::simulation::World;
use super::state::{Drive, State};
use crate::balance::Ledger;
use crate::bonds::{Bond, Bonds, Rest};
use crate::contacts::ContactMemory;
use crate::forces::{Bookings, Forces};
use crate::integrators::{Integrator, Previous};
use crate::model::Model;
use crate::particles::{Particles, Role};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_common::record::{Column, Record, Shape};

/// Name of this kernel in records.
pub const NAME: &str = "dem";

/// Columns of every record, in order.
const COLUMNS: [(&str, Shape); 17] = [
    ("steps", Shape::Words(1)),
    ("is_evaluated", Shape::Words(1)),
    ("position", Shape::List(2)),
    ("velocity", Shape::List(2)),
    ("angle", Shape::List(1)),
    ("angular_velocity", Shape::List(1)),
    ("radius", Shape::List(1)),
    ("mass", Shape::List(1)),
    ("moment_of_inertia", Shape::List(1)),
    ("role", Shape::List(1)),
    ("force", Shape::List(2)),
    ("torque", Shape::List(1)),
    ("drive", Shape::Words(6)),
    ("bonds", Shape::List(7)),
    ("contacts", Shape::List(6)),
    ("ledger", Shape::Words(8)),
    ("bookings", Shape::Words(8)),
];
/// Further columns for methods that keep data of the previous evaluation.
const PREVIOUS: [(&str, Shape); 5] = [
    ("previous_is_set", Shape::Words(1)),
    ("previous_linear", Shape::List(2)),
    ("older_linear", Shape::List(2)),
    ("previous_angular", Shape::List(1)),
    ("older_angular", Shape::List(1)),
];

/// Columns of a record for a method.
fn layout(integrator: Integrator) -> Vec<(&'static str, Shape)> {
    let previous: &[_] = match integrator.needs_previous() {
        true => &PREVIOUS,
        false => &[],
    };
    [&COLUMNS[..], previous].concat()
}

/// The words of the first columns of a record; `None` if they are not those of a layout.
fn columns_of<'a>(record: &'a Record, layout: &[(&str, Shape)]) -> Option<Vec<&'a [u64]>> {
    let columns = record.columns.get(..layout.len())?;
    let fits = |(column, &(name, shape)): (&Column, &(&str, Shape))| {
        column.name == name && column.shape == shape && column.is_whole()
    };
    let is_ours = record.model == NAME && columns.iter().zip(layout).all(fits);
    is_ours.then(|| columns.iter().map(|one| &one.words[..]).collect())
}

impl<N: NormalChoice<f64>> World<f64, N> {
    /// The whole state as a record; [`from_record`](Self::from_record) continues from it bit by bit.
    pub fn record(&self) -> Record {
        let columns = layout(self.model.integrator);
        let words = words_of(&self.state, columns.len() > COLUMNS.len());
        let columns = columns.iter().zip(words).map(|(&(name, shape), words)| {
            let name = name.to_owned();
            Column { name, shape, words }
        });
        Record {
            model: NAME.to_owned(),
            columns: columns.collect(),
        }
    }

    /// The world of a model in a recorded state; `None` if the record does not fit the model.
    pub fn from_record(model: Model<N>, record: &Record) -> Option<Self> {
        let layout = layout(model.integrator);
        let columns = columns_of(record, &layout)?;
        if columns.len() < record.columns.len() {
            return None;
        }
        restore(model, &columns)
    }

    /// The words of the record in sequence.
    pub fn to_words(&self) -> Vec<u64> {
        self.record().words()
    }

    /// The world of a model in the state that [`to_words`](Self::to_words) wrote; `None` if the words do not fit
    /// the model.
    pub fn from_words(model: Model<N>, words: &[u64]) -> Option<Self> {
        let record = World::record_of_words(model.integrator, words)?;
        Self::from_record(model, &record)
    }

    /// Replace all bonds and all contact memories.
    pub(super) fn adopt(
        &mut self,
        bonds: Vec<Bond<f64>>,
        contacts: Vec<(Pair, ContactMemory<f64>)>,
    ) {
        if let Some(own) = &mut self.state.bonds {
            *own = Bonds::from_bonds(&bonds, &self.state.particles);
        }
        if let Some(own) = &mut self.state.contacts {
            own.restore(&contacts);
        }
        self.reserve();
        self.find_neighbors();
    }
}

impl World {
    /// What a record holds of a state from which a run of another model may begin; `None` if it is damaged.
    pub fn continuation_of_record(record: &Record) -> Option<Continuation> {
        let columns = columns_of(record, &COLUMNS)?;
        let parts = read_parts(&columns)?;
        Some(Continuation {
            particles: parts.particles,
            bonds: parts.bonds,
            contacts: parts.contacts,
            drive_force: parts.drive.force,
        })
    }

    /// The record of such words, for a world with the given method; `None` if they do not fill its columns.
    pub fn record_of_words(integrator: Integrator, words: &[u64]) -> Option<Record> {
        Record::from_words(NAME, &layout(integrator), words)
    }
}

/// The words of each column.
fn words_of(state: &State<f64>, with_previous: bool) -> Vec<Vec<u64>> {
    let (p, drive, previous) = (&state.particles, &state.drive, &state.previous);
    let bonds = state.bonds.iter().flat_map(Bonds::iter);
    let contacts = state.contacts.iter().flat_map(|all| all.remembered());
    let mut words = vec![
        vec![state.steps],
        vec![u64::from(state.is_evaluated)],
        vectors(&p.position),
        vectors(&p.velocity),
        numbers(&p.angle),
        numbers(&p.angular_velocity),
        numbers(&p.radius),
        numbers(&p.mass),
        numbers(&p.moment_of_inertia),
        p.role.iter().map(|&role| role as u64).collect(),
        vectors(&state.forces.force),
        numbers(&state.forces.torque),
        vectors(&[drive.force, drive.applied, drive.reaction]),
        bonds.flat_map(|bond| bond_words(&bond)).collect(),
        contacts.flat_map(|one| contact_words(&one)).collect(),
        numbers(&state.ledger.unwrap_or_default().numbers()),
        numbers(&state.bookings.numbers()),
    ];
    if with_previous {
        words.extend([
            vec![u64::from(previous.is_set)],
            vectors(&previous.linear),
            vectors(&previous.older_linear),
            numbers(&previous.angular),
            numbers(&previous.older_angular),
        ]);
    }
    words
}

fn numbers(column: &[f64]) -> Vec<u64> {
    column.iter().map(|x| x.to_bits()).collect()
}

fn vectors(column: &[Vec2]) -> Vec<u64> {
    column
        .iter()
        .flat_map(|v| [v.x.to_bits(), v.y.to_bits()])
        .collect()
}

fn pair_word(pair: Pair) -> u64 {
    u64::from(pair.i) << 32 | u64::from(pair.j)
}

fn bond_words(bond: &Bond<f64>) -> [u64; 7] {
    let Rest {
        reference,
        angles,
        distance,
    } = bond.rest;
    let numbers = [
        reference.x,
        reference.y,
        angles[0],
        angles[1],
        distance,
        bond.strength_factor,
    ];
    let [a, b, c, d, e, f] = numbers.map(f64::to_bits);
    [pair_word(bond.pair), a, b, c, d, e, f]
}

fn contact_words((pair, memory): &(Pair, ContactMemory<f64>)) -> [u64; 6] {
    let ContactMemory {
        reference,
        ends,
        state,
        ..
    } = *memory;
    let [a, b, c, d, e] = [reference.x, reference.y, ends[0], ends[1], state].map(f64::to_bits);
    [pair_word(*pair), a, b, c, d, e]
}

/// What a record holds of any state.
struct Parts {
    particles: Particles,
    bonds: Vec<Bond<f64>>,
    contacts: Vec<(Pair, ContactMemory<f64>)>,
    forces: Forces<f64>,
    drive: Drive<f64>,
    ledger: Ledger<f64>,
    bookings: Bookings<f64>,
    steps: u64,
    is_evaluated: bool,
}

/// The parts of a state from columns of the right shapes; `None` if their contents are inconsistent.
fn read_parts(columns: &[&[u64]]) -> Option<Parts> {
    let &[
        &[steps],
        &[is_evaluated],
        ref particle_columns @ ..,
        force,
        torque,
        drive,
        bonds,
        contacts,
        ledger,
        bookings,
    ] = columns
    else {
        return None;
    };
    let particles = read_particles(particle_columns)?;
    let number = particles.len();
    let forces = Forces {
        force: read_vectors(force),
        torque: read_numbers(torque),
    };
    let bonds: Vec<Bond<f64>> = read_items(bonds, read_bond);
    let contacts: Vec<(Pair, ContactMemory<f64>)> = read_items(contacts, read_contact);
    let is_consistent = are_valid(bonds.iter().map(|bond| bond.pair), number)
        && are_valid(contacts.iter().map(|one| one.0), number)
        && forces.force.len() == number
        && forces.torque.len() == number;
    is_consistent.then_some(Parts {
        particles,
        bonds,
        contacts,
        forces,
        drive: read_drive(drive)?,
        ledger: Ledger::from_numbers(read_numbers(ledger).try_into().ok()?),
        bookings: Bookings::from_numbers(read_numbers(bookings).try_into().ok()?),
        steps,
        is_evaluated: is_evaluated == 1,
    })
}

/// The world of a model from columns of the right shapes; `None` if their contents are inconsistent.
fn restore<N: NormalChoice<f64>>(model: Model<N>, columns: &[&[u64]]) -> Option<World<f64, N>> {
    let (common, previous) = columns.split_at_checked(COLUMNS.len())?;
    let parts = read_parts(common)?;
    let mut world = World::new(model, parts.particles, &Start::default()).ok()?;
    world.adopt(parts.bonds, parts.contacts);
    let state = &mut world.state;
    (state.steps, state.is_evaluated) = (parts.steps, parts.is_evaluated);
    (state.forces, state.drive, state.bookings) = (parts.forces, parts.drive, parts.bookings);
    state.ledger = state.ledger.map(|_| parts.ledger);
    if model.integrator.needs_previous() {
        state.previous = read_previous(previous, &state.previous)?;
    }
    Some(world)
}

fn read_numbers(words: &[u64]) -> Vec<f64> {
    words.iter().map(|&word| f64::from_bits(word)).collect()
}

fn read_vectors(words: &[u64]) -> Vec<Vec2> {
    read_items(words, |[x, y]| {
        Vec2::new(f64::from_bits(x), f64::from_bits(y))
    })
}

/// Read items of `WIDTH` words each.
fn read_items<T, const WIDTH: usize>(words: &[u64], read: impl Fn([u64; WIDTH]) -> T) -> Vec<T> {
    let (items, _) = words.as_chunks();
    items.iter().copied().map(read).collect()
}

fn read_particles(columns: &[&[u64]]) -> Option<Particles> {
    let &[
        position,
        velocity,
        angle,
        angular_velocity,
        radius,
        mass,
        moment_of_inertia,
        role,
    ] = columns
    else {
        return None;
    };
    let roles = role.iter().map(|word| match word {
        0 => Some(Role::Free),
        1 => Some(Role::Driven),
        2 => Some(Role::Fixed),
        _ => None,
    });
    let number = position.len() / 2;
    let others = [
        angle,
        angular_velocity,
        radius,
        mass,
        moment_of_inertia,
        role,
    ];
    let is_whole =
        velocity.len() == 2 * number && others.iter().all(|column| column.len() == number);
    is_whole.then_some(Particles {
        position: read_vectors(position),
        velocity: read_vectors(velocity),
        angle: read_numbers(angle),
        angular_velocity: read_numbers(angular_velocity),
        radius: read_numbers(radius),
        mass: read_numbers(mass),
        moment_of_inertia: read_numbers(moment_of_inertia),
        role: roles.collect::<Option<_>>()?,
    })
}

fn read_drive(words: &[u64]) -> Option<Drive<f64>> {
    let [force, applied, reaction] = read_vectors(words).try_into().ok()?;
    Some(Drive {
        force,
        applied,
        reaction,
        ..Drive::default()
    })
}

fn read_pair(word: u64) -> Pair {
    Pair {
        i: (word >> 32) as u32,
        j: word as u32,
    }
}

fn read_bond([pair, numbers @ ..]: [u64; 7]) -> Bond<f64> {
    let [x, y, a, b, distance, strength_factor] = numbers.map(f64::from_bits);
    Bond {
        pair: read_pair(pair),
        rest: Rest {
            reference: Vec2::new(x, y),
            angles: [a, b],
            distance,
        },
        strength_factor,
    }
}

fn read_contact([pair, numbers @ ..]: [u64; 6]) -> (Pair, ContactMemory<f64>) {
    let [x, y, a, b, state] = numbers.map(f64::from_bits);
    let memory = ContactMemory {
        touches: true,
        reference: Vec2::new(x, y),
        ends: [a, b],
        state,
    };
    (read_pair(pair), memory)
}

/// Whether pairs are sorted, distinct, and of existing particles.
fn are_valid(mut pairs: impl Iterator<Item = Pair> + Clone, particles: usize) -> bool {
    let exists = |pair: Pair| pair.i < pair.j && (pair.j as usize) < particles;
    pairs.clone().is_sorted_by(|a, b| a < b) && pairs.all(exists)
}

fn read_previous(columns: &[&[u64]], blank: &Previous<f64>) -> Option<Previous<f64>> {
    let &[&[is_set], linear, older_linear, angular, older_angular] = columns else {
        return None;
    };
    let previous = Previous {
        is_set: is_set == 1,
        linear: read_vectors(linear),
        older_linear: read_vectors(older_linear),
        angular: read_numbers(angular),
        older_angular: read_numbers(older_angular),
    };
    let fits = previous.linear.len() == blank.linear.len()
        && previous.angular.len() == blank.angular.len()
        && previous.older_linear.len() == blank.older_linear.len()
        && previous.older_angular.len() == blank.older_angular.len();
    fits.then_some(previous)
}
