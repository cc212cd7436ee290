//! Problems with a Delassus operator, by sweeps over its blocks.

use super::Case;
use crate::error::Fault;
use crate::fields::Fields;
use gouge_contact_dynamics::local::{Components, ExactRule, LocalProblem, LocalRule};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Most contacts of a problem.
const MOST_CONTACTS: usize = 100_000;

/// Largest number of blocks that are visited, so that a problem whose sweeps hardly converge ends.
const VISITS: usize = 1_000_000_000;

/// Change of a velocity in a sweep at which sweeps stop, relative to the largest velocity without impulses.
const CHANGE: f64 = 1e-15;

/// A point that moves another one, and the four responses.
type Block = (usize, [f64; 4]);

/// The operator by rows of blocks.
struct Operator {
    rows: Vec<Vec<Block>>,
    free: Vec<Components>,
    friction: Vec<f64>,
}

/// Entries of the operator by row and column, and the velocities without impulses.
struct Entries {
    entries: Vec<(usize, usize, f64)>,
    free: Vec<f64>,
}

/// The impulses of all contacts, normal and tangential in turn.
pub fn solve(case: &Case) -> Result<Value, Fault> {
    let fields = &case.fields;
    let count = fields.count("contacts", 0, MOST_CONTACTS)?;
    let entries = match fields.word("form", &["assembled", "global"])? {
        "assembled" => assembled(fields, count)?,
        _ => from_bodies(fields, count)?,
    };
    let mut rows = vec![BTreeMap::new(); count];
    for (row, column, value) in entries.entries {
        let block: &mut [f64; 4] = rows[row / 2].entry(column / 2).or_default();
        block[2 * (row % 2) + column % 2] += value;
    }
    let free = entries.free.chunks_exact(2);
    let operator = Operator {
        rows: rows
            .into_iter()
            .map(|row| row.into_iter().collect())
            .collect(),
        free: free.map(|u| Components { n: u[0], t: u[1] }).collect(),
        friction: fields.numbers_of("mu", count)?,
    };
    let impulses: Vec<f64> = operator.solve().iter().flat_map(|p| [p.n, p.t]).collect();
    Ok(json!({"impulses": impulses}))
}

fn assembled(fields: &Fields, count: usize) -> Result<Entries, Fault> {
    let w = fields.inside("W")?;
    let values = w.numbers("val")?;
    let (rows, columns) = (
        w.list_of("row", values.len())?,
        w.list_of("col", values.len())?,
    );
    let accepted = format!("an index below {}", 2 * count);
    let mut entries = Vec::with_capacity(values.len());
    for ((row, column), value) in rows.iter().zip(&columns).zip(values) {
        let [row, column] = [row, column].map(|index| index.as_index(2 * count, &accepted));
        entries.push((row?, column?, value));
    }
    let free = fields.numbers_of("q", 2 * count)?;
    Ok(Entries { entries, free })
}

/// The operator of bodies whose motion at each point is given by rows of coefficients.
fn from_bodies(fields: &Fields, count: usize) -> Result<Entries, Fault> {
    let bodies = fields.count("bodies", 0, MOST_CONTACTS)?;
    let mass = fields.numbers_of("mass", 3 * bodies)?;
    let momentum = fields.numbers_of("momentum_free", 3 * bodies)?;
    let offset = fields.numbers_of("b", 2 * count)?;
    if !mass.iter().all(|&mass| mass > 0.0) {
        return Err(fields.refuse("a problem with positive masses"));
    }
    let rows = coefficients(fields, count, bodies)?;
    let mut by_coordinate = vec![Vec::new(); mass.len()];
    for (index, row) in rows.iter().enumerate() {
        for &(k, x) in row {
            by_coordinate[k].push((index, x));
        }
    }
    let mut entries = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        for &(k, x) in row {
            let others = by_coordinate[k].iter();
            entries.extend(others.map(|&(other, y)| (index, other, x * y / mass[k])));
        }
    }
    let speed = |row: &Vec<(usize, f64)>| -> f64 {
        let parts = row.iter().map(|&(k, x)| x * momentum[k] / mass[k]);
        parts.sum()
    };
    let free = rows.iter().zip(offset).map(|(row, b)| speed(row) + b);
    Ok(Entries {
        entries,
        free: free.collect(),
    })
}

/// Per component of each point, the coordinates of bodies that move it.
fn coefficients(
    fields: &Fields,
    count: usize,
    bodies: usize,
) -> Result<Vec<Vec<(usize, f64)>>, Fault> {
    let accepted = format!("an index of bodies, below {bodies}");
    let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); 2 * count];
    for (point, row) in fields.list_of("rows", count)?.iter().enumerate() {
        let moved = row.list("bodies")?;
        for (part, key) in ["normal_rows", "tangent_rows"].into_iter().enumerate() {
            let coefficients = row.list_of(key, moved.len())?;
            for (body, coefficients) in moved.iter().zip(coefficients) {
                let body = body.as_index(bodies, &accepted)?;
                let coefficients = coefficients.as_array::<3>()?.into_iter().enumerate();
                rows[2 * point + part].extend(coefficients.map(|(k, x)| (3 * body + k, x)));
            }
        }
    }
    Ok(rows)
}

impl Operator {
    fn velocity(&self, point: usize, impulses: &[Components]) -> Components {
        let mut u = self.free[point];
        for &(other, w) in &self.rows[point] {
            let p = impulses[other];
            u.n += w[0] * p.n + w[1] * p.t;
            u.t += w[2] * p.n + w[3] * p.t;
        }
        u
    }

    /// Sweep forward and backward in turn until nothing changes.
    fn solve(&self) -> Vec<Components> {
        let count = self.free.len();
        let larger = |size: f64, u: &Components| size.max(u.n.abs()).max(u.t.abs());
        let size = self.free.iter().fold(0.0, larger);
        let blocks: usize = self.rows.iter().map(Vec::len).sum();
        let mut impulses = vec![Components::default(); count];
        for sweep in 0..VISITS / blocks.max(1) {
            let mut largest = 0.0f64;
            for index in 0..count {
                let point = match sweep % 2 {
                    0 => index,
                    _ => count - 1 - index,
                };
                largest = largest.max(self.update(point, &mut impulses));
            }
            if largest <= CHANGE * size {
                break;
            }
        }
        impulses
    }

    /// Solve one point, and return how much its velocity changes.
    fn update(&self, point: usize, impulses: &mut [Components]) -> f64 {
        let own = self.rows[point].iter().find(|(other, _)| *other == point);
        let w = own.map_or([0.0; 4], |(_, w)| *w);
        let (u, old) = (self.velocity(point, impulses), impulses[point]);
        // An operator that is not quite symmetric: what does not change is still a solution.
        let w_nt = 0.5 * (w[1] + w[2]);
        let problem = LocalProblem {
            w_nn: w[0],
            w_tt: w[3],
            w_nt,
            a_n: w[0] * old.n + w_nt * old.t - u.n,
            a_t: w_nt * old.n + w[3] * old.t - u.t,
            friction: self.friction[point],
        };
        let new = ExactRule.solve(&problem).impulse;
        impulses[point] = new;
        let changes = [w[0] * (new.n - old.n), w[3] * (new.t - old.t)];
        changes[0].abs().max(changes[1].abs())
    }
}
