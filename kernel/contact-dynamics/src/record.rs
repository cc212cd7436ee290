//! The whole state of a world as named columns, for checkpoints.

use crate::cell::Settling;
use crate::detection::Feature;
use crate::local::Components;
use crate::step::Workspace;
use crate::units::Velocity;
use crate::warm_start::PointKey;
use crate::work::Work;
use crate::world::World;
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_common::record::{Column, Record, Shape};

/// Name of this kernel in records.
pub const NAME: &str = "contact-dynamics";

const COLUMNS: [(&str, Shape); 8] = [
    ("steps", Shape::Words(1)),
    ("settling", Shape::Words(2)),
    ("work", Shape::Words(5)),
    ("position", Shape::List(2)),
    ("angle", Shape::List(1)),
    ("wall", Shape::List(2)),
    ("velocity", Shape::List(3)),
    ("impulses", Shape::List(7)),
];

impl World {
    /// The whole state as a record; [`restored`](Self::restored) continues from it bit by bit.
    pub fn record(&self) -> Record {
        let columns = COLUMNS.into_iter().zip(self.words());
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

    fn words(&self) -> [Vec<u64>; 8] {
        let configuration = &self.state.configuration;
        let work = self.work.unwrap_or_default();
        let vectors = |all: &[Vec2]| all.iter().flat_map(|v| bits([v.x, v.y])).collect();
        let walls: Vec<Vec2> = configuration.wall.iter().map(|w| w.position).collect();
        let velocity = |v: &Velocity| bits([v.linear.x, v.linear.y, v.angular]);
        [
            vec![self.steps],
            vec![
                self.settling.height.to_bits(),
                u64::from(self.settling.is_settled),
            ],
            bits(work.values()).to_vec(),
            vectors(&configuration.position),
            configuration.angle.iter().map(|a| a.to_bits()).collect(),
            vectors(&walls),
            configuration.velocity.iter().flat_map(velocity).collect(),
            self.state.memory.iter().flat_map(point).collect(),
        ]
    }

    /// This world in a recorded state; `None` if the record is not one of a world with these bodies and walls.
    pub fn restored(mut self, record: &Record) -> Option<Self> {
        let fits = |(column, (name, shape)): (&Column, (&str, Shape))| {
            column.name == name && column.shape == shape && column.is_whole()
        };
        let is_ours = record.model == NAME && record.columns.len() == COLUMNS.len();
        if !is_ours || !record.columns.iter().zip(COLUMNS).all(fits) {
            return None;
        }
        let words: Vec<&[u64]> = record.columns.iter().map(|one| &one.words[..]).collect();
        let [
            steps,
            settling,
            work,
            position,
            angle,
            wall,
            velocity,
            impulses,
        ] = words[..]
        else {
            return None;
        };
        let configuration = &mut self.state.configuration;
        let counts = [
            (position.len(), 2 * configuration.position.len()),
            (angle.len(), configuration.angle.len()),
            (wall.len(), 2 * configuration.wall.len()),
            (velocity.len(), 3 * configuration.velocity.len()),
        ];
        if counts.iter().any(|(found, wanted)| found != wanted) {
            return None;
        }
        self.steps = steps[0];
        self.settling = Settling {
            height: f64::from_bits(settling[0]),
            is_settled: settling[1] != 0,
        };
        let booked = Work::from_values(numbers(work)?);
        self.work = self.work.map(|_| booked);
        configuration.position = vectors(position);
        configuration.angle = angle.iter().map(|&a| f64::from_bits(a)).collect();
        for (own, position) in configuration.wall.iter_mut().zip(vectors(wall)) {
            own.position = position;
        }
        configuration.velocity = velocities(velocity);
        self.restore_memory(impulses)?;
        self.workspace = Workspace::new(&self.assembly, &self.state, &self.settings);
        self.workspace.set_threads(self.threads);
        Some(self)
    }

    fn restore_memory(&mut self, words: &[u64]) -> Option<()> {
        let ends = self.assembly.unit.len() + self.assembly.wall_unit.len();
        self.state.memory.clear();
        let (points, _) = words.as_chunks::<7>();
        for &[i, j, feature, x, y, n, t] in points {
            let is_pair = i < j && j < ends as u64;
            let feature = u32::try_from(feature).ok().filter(|_| is_pair)?;
            let [x, y, n, t] = [x, y, n, t].map(f64::from_bits);
            let key = PointKey {
                pair: Pair::new(i as usize, j as usize),
                feature: Feature::from_word(feature),
                place: Vec2::new(x, y),
            };
            self.state.memory.push(key, Components { n, t });
        }
        Some(())
    }
}

fn bits<const N: usize>(numbers: [f64; N]) -> [u64; N] {
    numbers.map(f64::to_bits)
}

fn numbers<const N: usize>(words: &[u64]) -> Option<[f64; N]> {
    let words: [u64; N] = words.try_into().ok()?;
    Some(words.map(f64::from_bits))
}

fn vectors(words: &[u64]) -> Vec<Vec2> {
    let (pairs, _) = words.as_chunks::<2>();
    let vector = |&[x, y]: &[u64; 2]| Vec2::new(f64::from_bits(x), f64::from_bits(y));
    pairs.iter().map(vector).collect()
}

fn velocities(words: &[u64]) -> Vec<Velocity> {
    let (triples, _) = words.as_chunks::<3>();
    let velocity = |triple: &[u64; 3]| {
        let [x, y, angular] = triple.map(f64::from_bits);
        Velocity {
            linear: Vec2::new(x, y),
            angular,
        }
    };
    triples.iter().map(velocity).collect()
}

fn point((key, impulse): (&PointKey, &Components)) -> [u64; 7] {
    let [x, y, n, t] = bits([key.place.x, key.place.y, impulse.n, impulse.t]);
    let (i, j) = key.pair.indices();
    [
        i as u64,
        j as u64,
        u64::from(key.feature.to_word()),
        x,
        y,
        n,
        t,
    ]
}
