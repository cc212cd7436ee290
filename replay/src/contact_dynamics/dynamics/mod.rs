//! Closed forms of motion, by whole steps.
//!
//! The beginning of the identity of a case is its kind. What a set-up may leave out has the value that the cases were
//! written for: density, restitution, and a gravity that the whole file states as `g`.

mod impact;
mod incline;
mod rest;
mod row;
mod slow_down;

use super::Case;
use crate::error::Fault;
use crate::fields::Fields;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use serde_json::Value;

/// What a case starts from.
struct Setup<'a> {
    fields: Fields<'a>,
    file: &'a Fields<'a>,
}

/// From the set-up of a case to its results.
type Solve = fn(&Setup) -> Result<Value, Fault>;

/// Beginnings of identities, and what they ask for.
const KINDS: [(&str, Solve); 10] = [
    ("incline-square", incline::square),
    ("incline-disc", incline::disc),
    ("block-stops", slow_down::block),
    ("disc-slide-roll", slow_down::disc),
    ("two-discs", impact::two_discs),
    ("corner-drop", impact::corner_drop),
    ("landing", impact::landing),
    ("cradle", row::cradle),
    ("gap-closes", rest::gap_closes),
    ("square-pushed", rest::square_pushed),
];

/// Largest number of steps of a case.
const MOST_STEPS: usize = 10_000_000;

pub fn solve(case: &Case) -> Result<Value, Fault> {
    let found = KINDS.iter().find(|(kind, _)| case.id.starts_with(kind));
    let Some((_, solve)) = found else {
        return Err(Fault::Value {
            key: "id".to_owned(),
            value: format!("{:?}", case.id),
            accepted: format!("one of these kinds, and what follows: {}", names()),
        });
    };
    solve(&Setup {
        fields: case.fields.inside("setup")?,
        file: &case.file,
    })
}

fn names() -> String {
    KINDS.map(|(kind, _)| kind).join(", ")
}

impl Setup<'_> {
    /// The acceleration of gravity, of the set-up or of the whole file.
    fn gravity(&self) -> Result<f64, Fault> {
        match (self.fields.optional("g"), self.file.optional("g")) {
            (None, Some(_)) => self.file.positive("g"),
            _ => self.fields.positive("g"),
        }
    }

    fn friction(&self) -> Result<f64, Fault> {
        self.fields.not_negative("mu")
    }

    /// Mass per area; 1 if absent.
    fn density(&self) -> Result<f64, Fault> {
        match self.fields.optional("density") {
            Some(_) => self.fields.positive("density"),
            None => Ok(1.0),
        }
    }

    /// The law of closed contacts, with the restitution of the set-up, which is 0 if absent.
    fn impact_law(&self) -> Result<ContactLaw, Fault> {
        let normal = self.fields.number_or("e_n", 0.0)?;
        let tangential = self.fields.number_or("e_t", 0.0)?;
        let friction = self.friction()?;
        Ok(super::motion::law(
            friction,
            normal,
            tangential,
            GapRule::Closed,
        ))
    }

    /// The law of slow motion: no restitution, and gaps are predicted.
    fn slow_law(&self) -> Result<ContactLaw, Fault> {
        let friction = self.friction()?;
        Ok(super::motion::law(friction, 0.0, 0.0, GapRule::Predicted))
    }

    /// A number of steps that is enough for something that takes a time, if that is few enough.
    fn steps_for(&self, time: f64, time_step: f64) -> Result<usize, Fault> {
        let steps = (time / time_step).ceil() + 10.0;
        match steps <= MOST_STEPS as f64 {
            true => Ok(steps as usize),
            false => Err(self.fields.refuse(format!(
                "a set-up that comes to its end within {MOST_STEPS} steps"
            ))),
        }
    }
}
