//! Problems with an assembled Delassus operator, by sweeps over its blocks.

use crate::{id, items, number, numbers};
use gouge_contact_dynamics::local::{Components, ExactRule, LocalProblem, LocalRule};
use serde_json::{Map, Value, json};

const SWEEPS: usize = 200_000;

/// The operator by rows of blocks: for each point, the points that move it and the four responses.
struct Operator {
    rows: Vec<Vec<(usize, [f64; 4])>>,
    free: Vec<Components>,
    friction: Vec<f64>,
}

pub fn results(cases: &Value) -> Map<String, Value> {
    items(cases, "problems")
        .map(|case| (id(case), solve(case)))
        .collect()
}

fn solve(case: &Value) -> Value {
    let count = number(case, "contacts") as usize;
    let (entries, free) = if case["form"] == "assembled" {
        assembled(case)
    } else {
        from_bodies(case, count)
    };
    let mut rows = vec![std::collections::BTreeMap::new(); count];
    for (row, column, value) in entries {
        let block: &mut [f64; 4] = rows[row / 2].entry(column / 2).or_default();
        block[2 * (row % 2) + column % 2] += value;
    }
    let operator = Operator {
        rows: rows
            .into_iter()
            .map(|row| row.into_iter().collect())
            .collect(),
        free: free
            .chunks(2)
            .map(|u| Components { n: u[0], t: u[1] })
            .collect(),
        friction: numbers(&case["mu"]),
    };
    let impulses: Vec<f64> = operator.solve().iter().flat_map(|p| [p.n, p.t]).collect();
    json!({"impulses": impulses})
}

type Entries = Vec<(usize, usize, f64)>;

fn assembled(case: &Value) -> (Entries, Vec<f64>) {
    let w = &case["W"];
    let [rows, columns, values] = ["row", "col", "val"].map(|key| numbers(&w[key]));
    let places = rows
        .iter()
        .zip(&columns)
        .map(|(&r, &c)| (r as usize, c as usize));
    let entries = places.zip(&values).map(|((r, c), &v)| (r, c, v)).collect();
    (entries, numbers(&case["q"]))
}

/// One row per component of each point: body, index of the body's coordinate, coefficient.
fn from_bodies(case: &Value, count: usize) -> (Entries, Vec<f64>) {
    let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); 2 * count];
    for (point, row) in items(case, "rows").enumerate() {
        for (side, body) in numbers(&row["bodies"]).into_iter().enumerate() {
            for (part, key) in ["normal_rows", "tangent_rows"].into_iter().enumerate() {
                let coefficients = numbers(&row[key][side]).into_iter().enumerate();
                rows[2 * point + part]
                    .extend(coefficients.map(|(k, x)| (3 * body as usize + k, x)));
            }
        }
    }
    let mass = numbers(&case["mass"]);
    let momentum = numbers(&case["momentum_free"]);
    let mut by_coordinate = vec![Vec::new(); mass.len()];
    for (index, row) in rows.iter().enumerate() {
        row.iter()
            .for_each(|&(k, x)| by_coordinate[k].push((index, x)));
    }
    let mut entries = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        for &(k, x) in row {
            entries.extend(
                by_coordinate[k]
                    .iter()
                    .map(|&(other, y)| (index, other, x * y / mass[k])),
            );
        }
    }
    let offset = numbers(&case["b"]);
    let speed = |row: &Vec<(usize, f64)>| {
        row.iter()
            .map(|&(k, x)| x * momentum[k] / mass[k])
            .sum::<f64>()
    };
    let free = rows
        .iter()
        .zip(offset)
        .map(|(row, b)| speed(row) + b)
        .collect();
    (entries, free)
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

    fn solve(&self) -> Vec<Components> {
        let count = self.free.len();
        let size = self
            .free
            .iter()
            .fold(0.0, |size: f64, u| size.max(u.n.abs()).max(u.t.abs()));
        let mut impulses = vec![Components::default(); count];
        for sweep in 0..SWEEPS {
            let mut largest = 0.0f64;
            for index in 0..count {
                let point = if sweep % 2 == 0 {
                    index
                } else {
                    count - 1 - index
                };
                largest = largest.max(self.update(point, &mut impulses));
            }
            if largest < 1e-15 * size {
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
        let problem = LocalProblem {
            w_nn: w[0],
            w_tt: w[3],
            w_nt: 0.5 * (w[1] + w[2]),
            a_n: w[0] * old.n + w[1] * old.t - u.n,
            a_t: w[2] * old.n + w[3] * old.t - u.t,
            friction: self.friction[point],
        };
        let new = ExactRule.solve(&problem).impulse;
        impulses[point] = new;
        (w[0] * (new.n - old.n))
            .abs()
            .max((w[3] * (new.t - old.t)).abs())
    }
}
