//! The whole state of a world as named columns, for checkpoints.

use crate::bonds::{BondColumns, Bonds};
use crate::grain::Grains;
use crate::state::{Place, State, Work};
use crate::world::World;
use gouge_common::geometry::Vec2;
use gouge_common::record::{Column, Record, Shape};

/// Name of this kernel in records.
pub const NAME: &str = "peridem";

const COLUMNS: [(&str, Shape); 12] = [
    ("steps", Shape::Words(1)),
    ("work", Shape::Words(4)),
    ("walls", Shape::Words(4)),
    ("reactions", Shape::Words(8)),
    ("displacement", Shape::List(2)),
    ("velocity", Shape::List(2)),
    ("acceleration", Shape::List(2)),
    ("start", Shape::List(1)),
    ("held", Shape::List(1)),
    ("earlier", Shape::List(1)),
    ("length", Shape::List(1)),
    ("initial", Shape::List(1)),
];

impl World {
    /// The whole state as a record; [`restored`](Self::restored) continues from it bit by bit.
    pub fn record(&self) -> Record {
        let columns = COLUMNS.into_iter().zip(words(self));
        let column = |((name, shape), words): ((&str, Shape), _)| Column {
            name: name.to_owned(),
            shape,
            words,
        };
        Record {
            model: NAME.to_owned(),
            columns: columns.map(column).collect(),
        }
    }

    /// This world in a recorded state; `None` if the record is not one of a world with these grains.
    pub fn restored(self, record: &Record) -> Option<Self> {
        let fits = |(column, (name, shape)): (&Column, (&str, Shape))| {
            column.name == name && column.shape == shape && column.is_whole()
        };
        let is_ours = record.model == NAME && record.columns.len() == COLUMNS.len();
        if !is_ours || !record.columns.iter().zip(COLUMNS).all(fits) {
            return None;
        }
        let (state, reactions) = state(self.grains(), record)?;
        Some(self.with_state(state, reactions))
    }
}

fn words(world: &World) -> [Vec<u64>; 12] {
    let state = world.state();
    let Work {
        walls,
        damping,
        friction,
        broken,
    } = state.work;
    let vectors = |all: &[Vec2]| {
        all.iter()
            .flat_map(|v| [v.x, v.y].map(f64::to_bits))
            .collect()
    };
    let displacement: Vec<_> = state.places.iter().map(|one| one.displacement).collect();
    let bonds = state.bonds.columns();
    [
        vec![state.steps],
        [walls, damping, friction, broken]
            .map(f64::to_bits)
            .to_vec(),
        state.walls.map(f64::to_bits).to_vec(),
        vectors(&world.reactions()),
        vectors(&displacement),
        vectors(&state.velocity),
        vectors(&state.acceleration),
        bonds.start.iter().map(|&one| one.into()).collect(),
        bonds.held.iter().map(|&one| one.into()).collect(),
        bonds.earlier.iter().map(|&one| one.into()).collect(),
        bonds.length.iter().map(|one| one.to_bits()).collect(),
        bonds.initial.iter().map(|&one| one.into()).collect(),
    ]
}

/// The state of a record whose columns have the right names and shapes, and the forces on the walls.
fn state(grains: &Grains, record: &Record) -> Option<(State, [Vec2; 4])> {
    let columns: Vec<&[u64]> = record.columns.iter().map(|one| &one.words[..]).collect();
    let [
        steps,
        work,
        walls,
        reactions,
        displacement,
        velocity,
        acceleration,
        start,
        held,
        earlier,
        length,
        initial,
    ] = columns[..]
    else {
        return None;
    };
    let [displacement, velocity, acceleration] =
        [displacement, velocity, acceleration].map(|words| vectors_of(words, grains.nodes()));
    let length: Vec<_> = length.iter().map(|&word| f64::from_bits(word)).collect();
    let bonds = BondColumns {
        start: &integers(start)?,
        held: &integers(held)?,
        earlier: &integers(earlier)?,
        length: &length,
        initial: &integers(initial)?,
    };
    let bonds = Bonds::from_columns(grains, bonds)?;
    let [on_walls, damping, friction, broken] = numbers(work)?;
    let place = |(&reference, displacement): (&Vec2, Vec2)| Place {
        reference,
        displacement,
    };
    let reactions = vectors_of(reactions, 4)?.try_into().ok()?;
    let state = State {
        places: grains
            .position
            .iter()
            .zip(displacement?)
            .map(place)
            .collect(),
        velocity: velocity?,
        acceleration: acceleration?,
        bonds,
        walls: numbers(walls)?,
        steps: *steps.first()?,
        work: Work {
            walls: on_walls,
            damping,
            friction,
            broken,
        },
    };
    Some((state, reactions))
}

fn integers<T: TryFrom<u64>>(words: &[u64]) -> Option<Vec<T>> {
    words.iter().map(|&word| T::try_from(word).ok()).collect()
}

fn numbers<const N: usize>(words: &[u64]) -> Option<[f64; N]> {
    let words: [u64; N] = words.try_into().ok()?;
    Some(words.map(f64::from_bits))
}

fn vectors_of(words: &[u64], number: usize) -> Option<Vec<Vec2>> {
    let (pairs, rest) = words.as_chunks::<2>();
    let vector = |&[x, y]: &[u64; 2]| Vec2::new(f64::from_bits(x), f64::from_bits(y));
    (rest.is_empty() && pairs.len() == number).then(|| pairs.iter().map(vector).collect())
}
