//! Plates of peridynamic nodes that LAMMPS moved, in `references/lammps/peri-pmb`.

use super::case::hashes;
use super::{Recorded, Table};
use gouge_runner::references::{FOLDER, file_text};
use serde::Deserialize;
use std::path::Path;

const CASE: &str = "lammps/peri-pmb";

/// A node at the beginning.
#[derive(Clone, Debug, Deserialize)]
pub struct Node {
    /// Reference position in m.
    pub x: f64,
    /// Reference position in m.
    pub y: f64,
    /// Velocity in m/s.
    pub vx: f64,
    /// Velocity in m/s.
    pub vy: f64,
    /// Volume in m^3 of a layer of unit depth: the area in m^2.
    pub volume: f64,
    /// Density in kg/m^3.
    pub density: f64,
}

/// A run, as LAMMPS was given it, with its result.
#[derive(Clone, Debug, Deserialize)]
pub struct Plate {
    /// Its name.
    pub name: String,
    /// Stiffness c of bonds in N/m^6.
    pub stiffness: f64,
    /// Horizon in m.
    pub horizon: f64,
    /// Stretch above which bonds break.
    pub critical_stretch: f64,
    /// Time step in s.
    pub step: f64,
    /// The nodes, in their order in the tables.
    #[serde(skip)]
    pub nodes: Vec<Node>,
    /// Positions, velocities and damage of nodes at some steps; damage is the lost part of the volume of partners.
    #[serde(skip)]
    pub motion: Table,
    /// Sum of the damage of all nodes after each step.
    #[serde(skip)]
    pub series: Table,
}

#[derive(Deserialize)]
struct Listed {
    tolerance: f64,
    runs: Vec<Plate>,
}

impl Plate {
    /// All runs, and the tolerance that the case states.
    ///
    /// # Errors
    /// Files that cannot be parsed, or inputs that are not those of the result.
    pub fn all() -> Result<(Vec<Self>, f64), String> {
        let folder = Path::new(CASE);
        let listed: Listed =
            toml::from_str(file_text(folder, "case.toml")?).map_err(|e| e.to_string())?;
        let result: Recorded =
            serde_json::from_str(file_text(folder, "result.json")?).map_err(|e| e.to_string())?;
        let present = FOLDER.get_dir(folder).map(hashes).unwrap_or_default();
        let changed = result.changed_inputs(&present);
        if !changed.is_empty() {
            return Err(format!("references/{CASE}: {changed:?} changed since"));
        }
        let mut runs = listed.runs;
        for run in &mut runs {
            run.complete(&result)?;
        }
        Ok((runs, listed.tolerance))
    }

    /// Add nodes and results.
    fn complete(&mut self, result: &Recorded) -> Result<(), String> {
        let folder = Path::new(CASE).join("particles");
        let table = file_text(&folder, &format!("{}.csv", self.name))?;
        let rows = csv::Reader::from_reader(table.as_bytes()).into_deserialize();
        self.nodes = rows.collect::<Result<_, _>>().map_err(|e| e.to_string())?;
        let found = result.runs.iter().find(|run| run.name == self.name);
        let missing = || format!("references/{CASE}: {} has no result", self.name);
        let found = found.ok_or_else(missing)?;
        self.motion = found.motion.clone().ok_or_else(missing)?;
        self.series = found.series.clone().ok_or_else(missing)?;
        Ok(())
    }
}
