//! Repeats worked examples that other programs solved, and writes what the kernel finds.
//!
//! `cargo run --release --example replay -- FOLDER RESULTS.json` reads any of geometry.json, local.json, onestep.json,
//! dynamics.json and siconos2d.json in the folder. The results are grouped by file and by the identities of the problems.

mod assembled;
mod dynamics;
mod geometry;
mod local;
mod motion;
mod onestep;

use serde_json::{Map, Value};
use std::error::Error;
use std::path::Path;

type Solve = fn(&Value) -> Map<String, Value>;

const PARTS: [(&str, Solve); 5] = [
    ("geometry", geometry::results),
    ("local", local::results),
    ("onestep", onestep::results),
    ("dynamics", dynamics::results),
    ("siconos2d", assembled::results),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [folder, output] = arguments.as_slice() else {
        return Err("usage: replay FOLDER RESULTS.json".into());
    };
    let mut results = Map::new();
    for (name, solve) in PARTS {
        let path = Path::new(folder).join(format!("{name}.json"));
        if path.exists() {
            let cases: Value = serde_json::from_str(&std::fs::read_to_string(path)?)?;
            results.insert(name.to_owned(), solve(&cases).into());
        }
    }
    std::fs::write(output, Value::from(results).to_string())?;
    Ok(())
}

/// The number under a key, or NaN.
fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or(f64::NAN)
}

/// The numbers of an array.
fn numbers(value: &Value) -> Vec<f64> {
    let items = value.as_array().into_iter().flatten();
    items.map(|x| x.as_f64().unwrap_or(f64::NAN)).collect()
}

/// The items of an array.
fn items<'a>(value: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> {
    value[key].as_array().into_iter().flatten()
}

/// The identity of a problem.
fn id(value: &Value) -> String {
    value["id"].as_str().unwrap_or_default().to_owned()
}
