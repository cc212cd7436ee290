//! The whole state of a world as a list of words, for checkpoints.

use super::{Drive, Start, World};
use crate::balance::Ledger;
use crate::bonds::{Bond, Bonds, Rest};
use crate::contacts::ContactMemory;
use crate::forces::{Forces, Tally};
use crate::integrators::Previous;
use crate::model::Model;
use crate::particles::{Particles, Role};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;

/// Words in the order in which they were written.
struct Reader<'a> {
    words: &'a [u64],
}

impl Reader<'_> {
    fn word(&mut self) -> Option<u64> {
        let (first, rest) = self.words.split_first()?;
        self.words = rest;
        Some(*first)
    }
    fn number(&mut self) -> Option<f64> {
        self.word().map(f64::from_bits)
    }
    fn vector(&mut self) -> Option<Vec2> {
        Some(Vec2::new(self.number()?, self.number()?))
    }
    fn pair(&mut self) -> Option<Pair> {
        let word = self.word()?;
        Some(Pair {
            i: (word >> 32) as u32,
            j: word as u32,
        })
    }
    /// A list that is preceded by its length.
    fn list<T>(&mut self, read: impl Fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let length = usize::try_from(self.word()?).ok()?;
        // A damaged length must not reserve memory that the words cannot fill.
        if length > self.words.len() {
            return None;
        }
        let mut list = Vec::with_capacity(length);
        for _ in 0..length {
            list.push(read(self)?);
        }
        Some(list)
    }
}

#[derive(Default)]
struct Writer {
    words: Vec<u64>,
}

impl Writer {
    fn word(&mut self, word: u64) {
        self.words.push(word);
    }
    fn number(&mut self, number: f64) {
        self.word(number.to_bits());
    }
    fn vector(&mut self, vector: Vec2) {
        self.number(vector.x);
        self.number(vector.y);
    }
    fn pair(&mut self, pair: Pair) {
        self.word(u64::from(pair.i) << 32 | u64::from(pair.j));
    }
    fn list<T>(&mut self, items: &[T], write: impl Fn(&mut Self, &T)) {
        self.word(items.len() as u64);
        items.iter().for_each(|item| write(self, item));
    }
}

fn write_particles(writer: &mut Writer, p: &Particles) {
    writer.list(&p.position, |w, &x| w.vector(x));
    writer.list(&p.velocity, |w, &v| w.vector(v));
    for column in [
        &p.angle,
        &p.angular_velocity,
        &p.radius,
        &p.mass,
        &p.moment_of_inertia,
    ] {
        writer.list(column, |w, &x| w.number(x));
    }
    writer.list(&p.role, |w, &role| w.word(role as u64));
}

fn read_particles(reader: &mut Reader) -> Option<Particles> {
    let role = |r: &mut Reader| match r.word()? {
        0 => Some(Role::Free),
        1 => Some(Role::Driven),
        2 => Some(Role::Fixed),
        _ => None,
    };
    let particles = Particles {
        position: reader.list(Reader::vector)?,
        velocity: reader.list(Reader::vector)?,
        angle: reader.list(Reader::number)?,
        angular_velocity: reader.list(Reader::number)?,
        radius: reader.list(Reader::number)?,
        mass: reader.list(Reader::number)?,
        moment_of_inertia: reader.list(Reader::number)?,
        role: reader.list(role)?,
    };
    let number = particles.len();
    let lengths = [
        particles.velocity.len(),
        particles.angle.len(),
        particles.angular_velocity.len(),
        particles.radius.len(),
        particles.mass.len(),
        particles.moment_of_inertia.len(),
        particles.role.len(),
    ];
    lengths
        .iter()
        .all(|&length| length == number)
        .then_some(particles)
}

fn write_strong_link(writer: &mut Writer, link: &Bond<f64>) {
    writer.pair(link.pair);
    writer.vector(link.rest.reference);
    link.rest
        .angles
        .iter()
        .for_each(|&angle| writer.number(angle));
    writer.number(link.rest.distance);
    writer.number(link.strength_factor);
}

fn read_strong_link(reader: &mut Reader) -> Option<Bond<f64>> {
    Some(Bond {
        pair: reader.pair()?,
        rest: Rest {
            reference: reader.vector()?,
            angles: [reader.number()?, reader.number()?],
            distance: reader.number()?,
        },
        strength_factor: reader.number()?,
    })
}

fn write_contact(writer: &mut Writer, (pair, memory): &(Pair, ContactMemory<f64>)) {
    writer.pair(*pair);
    writer.vector(memory.reference);
    memory.ends.iter().for_each(|&angle| writer.number(angle));
    writer.number(memory.state);
}

fn read_contact(reader: &mut Reader) -> Option<(Pair, ContactMemory<f64>)> {
    let pair = reader.pair()?;
    let memory = ContactMemory {
        touches: true,
        reference: reader.vector()?,
        ends: [reader.number()?, reader.number()?],
        state: reader.number()?,
    };
    Some((pair, memory))
}

impl World {
    /// The whole state as words; [`from_words`](Self::from_words) continues from it with the same bits.
    pub fn to_words(&self) -> Vec<u64> {
        let mut writer = Writer::default();
        writer.word(self.steps);
        writer.word(u64::from(self.is_evaluated));
        write_particles(&mut writer, &self.particles);
        writer.list(&self.forces.force, |w, &force| w.vector(force));
        writer.list(&self.forces.torque, |w, &torque| w.number(torque));
        [self.drive.force, self.drive.applied, self.drive.reaction]
            .iter()
            .for_each(|&v| writer.vector(v));
        let strong: Vec<_> = self
            .strong
            .as_ref()
            .map_or_else(Vec::new, |strong| strong.iter().collect());
        writer.list(&strong, write_strong_link);
        let contacts: Vec<_> = self
            .weak
            .as_ref()
            .map_or_else(Vec::new, |weak| weak.remembered().collect());
        writer.list(&contacts, write_contact);
        self.ledger
            .unwrap_or_default()
            .numbers()
            .iter()
            .for_each(|&x| writer.number(x));
        self.tally.numbers().iter().for_each(|&x| writer.number(x));
        if self.model.integrator.needs_previous() {
            let previous = &self.previous;
            writer.word(u64::from(previous.is_set));
            for column in [&previous.linear, &previous.older_linear] {
                writer.list(column, |w, &a| w.vector(a));
            }
            for column in [&previous.angular, &previous.older_angular] {
                writer.list(column, |w, &a| w.number(a));
            }
        }
        writer.words
    }

    /// The world of a model in a recorded state; nothing if the words are not such a state.
    pub fn from_words(model: Model, words: &[u64]) -> Option<Self> {
        let mut reader = Reader { words };
        let steps = reader.word()?;
        let is_evaluated = reader.word()? == 1;
        let particles = read_particles(&mut reader)?;
        let number = particles.len();
        let forces = Forces {
            force: reader.list(Reader::vector)?,
            torque: reader.list(Reader::number)?,
        };
        if forces.force.len() != number || forces.torque.len() != number {
            return None;
        }
        let drive = Drive {
            force: reader.vector()?,
            applied: reader.vector()?,
            reaction: reader.vector()?,
            ..Drive::default()
        };
        let links = reader.list(read_strong_link)?;
        let contacts = reader.list(read_contact)?;
        let bonded = links.iter().map(|link| link.pair);
        let touching = contacts.iter().map(|&(pair, _)| pair);
        if !can_be(bonded, number) || !can_be(touching, number) {
            return None;
        }
        let mut world = Self::new(model, particles, &Start::default()).ok()?;
        world.adopt_links(links, contacts);
        (world.steps, world.is_evaluated) = (steps, is_evaluated);
        (world.forces, world.drive) = (forces, drive);
        let ledger = Ledger::from_numbers(reader.numbers()?);
        world.ledger = world.ledger.map(|_| ledger);
        world.tally = Tally::from_numbers(reader.numbers()?);
        if model.integrator.needs_previous() {
            world.previous = read_previous(&mut reader, &world.previous)?;
        }
        reader.words.is_empty().then_some(world)
    }

    /// Replace all links.
    pub(super) fn adopt_links(
        &mut self,
        links: Vec<Bond<f64>>,
        contacts: Vec<(Pair, ContactMemory<f64>)>,
    ) {
        if let Some(strong) = &mut self.strong {
            *strong = Bonds::from_links(&links, &self.particles);
        }
        if let Some(weak) = &mut self.weak {
            weak.restore(&contacts);
        }
        self.make_room();
        self.find_neighbors();
    }
}

/// Whether pairs are such that links have: in order, each once, of so many particles.
fn can_be(mut pairs: impl Iterator<Item = Pair> + Clone, particles: usize) -> bool {
    let exists = |pair: Pair| pair.i < pair.j && (pair.j as usize) < particles;
    pairs.clone().is_sorted_by(|a, b| a < b) && pairs.all(exists)
}

impl Reader<'_> {
    fn numbers<const N: usize>(&mut self) -> Option<[f64; N]> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Some(numbers)
    }
}

fn read_previous(reader: &mut Reader, blank: &Previous<f64>) -> Option<Previous<f64>> {
    let is_set = reader.word()? == 1;
    let previous = Previous {
        is_set,
        linear: reader.list(Reader::vector)?,
        older_linear: reader.list(Reader::vector)?,
        angular: reader.list(Reader::number)?,
        older_angular: reader.list(Reader::number)?,
    };
    let fits = previous.linear.len() == blank.linear.len()
        && previous.angular.len() == blank.angular.len()
        && previous.older_linear.len() == blank.older_linear.len()
        && previous.older_angular.len() == blank.older_angular.len();
    fits.then_some(previous)
}
