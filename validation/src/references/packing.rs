//! Sheared packings of LMGC90: start states and results, in `references/lmgc90/shear`.

use gouge_runner::references::file_text;
use serde_json::Value;
use std::path::Path;

const FOLDER: &str = "lmgc90/shear";

/// A body of a start state.
#[derive(Clone, Debug)]
pub struct Grain {
    /// Number of sides of a regular polygon; 0 for a disc.
    pub sides: usize,
    /// Radius of the circumscribed circle in m.
    pub radius: f64,
    /// Position of the centroid in m.
    pub position: [f64; 2],
    /// Angle in rad.
    pub angle: f64,
    /// `free`, `bottom` or `top`.
    pub role: &'static str,
}

/// A start state, with the settings and means of the engine. The mean diameter, the density and the normal stress
/// are 1.
#[derive(Clone, Debug)]
pub struct Packing {
    /// Width of the period in m.
    pub width: f64,
    /// Height of the upper wall in m.
    pub height: f64,
    /// Inverse mass of the upper wall in 1/kg.
    pub inverse_wall_mass: f64,
    /// The bodies.
    pub grains: Vec<Grain>,
    /// Shear strain per step.
    pub strain_per_step: f64,
    /// Shear rate in 1/s, which is the inertial number.
    pub rate: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Strain and q/p of single states of the engine's run.
    pub series: Vec<[f64; 2]>,
    /// Solid fraction of single states over the strain from 1 to 2.
    pub solid_fractions: Vec<f64>,
    /// What the engine found.
    averaged: Value,
    /// Name and version of the engine.
    pub engine: String,
}

impl Packing {
    /// The start state with a name, `discs` or `hexagons`.
    ///
    /// # Errors
    /// No such packing, or a file that cannot be parsed.
    pub fn read(name: &str) -> Result<Self, String> {
        let text = file_text(Path::new(FOLDER), "result.json")?;
        let result: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let packing = &result["packings"][name];
        let runs = result["runs"].as_array().map_or(&[][..], Vec::as_slice);
        let run = runs.iter().find(|run| run["name"] == name);
        let run = run.ok_or_else(|| format!("there is no run {name}"))?;
        let file = packing["file"].as_str().unwrap_or_default();
        let lines = file_text(Path::new(FOLDER), file)?.lines().skip(1);
        Ok(Self {
            width: number(&result["settings"], "width")?,
            height: number(packing, "height")?,
            inverse_wall_mass: number(packing, "inverse_wall_mass")?,
            grains: lines.map(grain).collect::<Result<_, _>>()?,
            strain_per_step: number(run, "strain_per_step")?,
            rate: number(run, "inertial_number")?,
            friction: number(&result["settings"], "friction")?,
            series: series(&run["series"], "q_over_p"),
            solid_fractions: series(&run["series"], "solid_fraction")
                .into_iter()
                .filter(|[strain, _]| *strain > 1.0)
                .map(|[_, fraction]| fraction)
                .collect(),
            averaged: run["averaged"].clone(),
            engine: [&result["engine"], &result["version"]]
                .map(|word| word.as_str().unwrap_or_default())
                .join(" "),
        })
    }

    /// A mean of the engine over the strain from 1 to 2.
    ///
    /// # Errors
    /// No such mean.
    pub fn mean(&self, name: &str) -> Result<f64, String> {
        number(&self.averaged["means"], name)
    }

    /// The engine's standard error of its mean of q/p.
    ///
    /// # Errors
    /// The number is missing.
    pub fn standard_error(&self) -> Result<f64, String> {
        number(&self.averaged, "standard_error_q_over_p")
    }
}

fn number(object: &Value, key: &str) -> Result<f64, String> {
    let found = object[key].as_f64();
    found.ok_or_else(|| format!("references/{FOLDER}: {key} is not a number"))
}

/// Strain and a quantity of single states.
fn series(table: &Value, quantity: &str) -> Vec<[f64; 2]> {
    let columns = table["columns"].as_array().map_or(&[][..], Vec::as_slice);
    let place = |name: &str| columns.iter().position(|column| column == name);
    let places = [place("strain"), place(quantity)];
    let rows = table["rows"].as_array().map_or(&[][..], Vec::as_slice);
    let row = |row: &Value| {
        let [strain, value] = places.map(|place| row[place?].as_f64());
        Some([strain?, value?])
    };
    rows.iter().filter_map(row).collect()
}

fn grain(line: &'static str) -> Result<Grain, String> {
    let wrong = || format!("references/{FOLDER}: a grain cannot be parsed: {line}");
    let cells: Vec<&str> = line.split(',').collect();
    let [sides, radius, x, y, angle, role] = cells[..] else {
        return Err(wrong());
    };
    let parse = |cell: &str| cell.parse::<f64>().map_err(|_| wrong());
    Ok(Grain {
        sides: sides.parse().map_err(|_| wrong())?,
        radius: parse(radius)?,
        position: [parse(x)?, parse(y)?],
        angle: parse(angle)?,
        role,
    })
}
