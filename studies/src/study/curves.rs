//! Friction and heat over time, of the runs that figures show.

use super::results::{Results, Run};
use crate::columns::Columns;
use crate::csv_table::CsvFile;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::collections::BTreeMap;
use std::path::Path;

/// Pressures whose curves are kept, in units of the normal strength: those of thesis figure 14 and one of each decade.
pub const PRESSURES: [f64; 5] = [0.075, 0.1, 0.15, 0.3, 0.6];
/// Columns of the file.
const COLUMNS: [&str; 4] = ["run", "time", "friction", "heat"];
/// Points of a curve.
const POINTS: usize = 50;

/// A point of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Middle of the stretch of time that the point stands for, in s.
    pub time: f64,
    /// Mean horizontal over mean vertical driving force in that stretch.
    pub friction: f64,
    /// Heat at its end in J.
    pub heat: f64,
}

/// Curves by the name of their run.
#[derive(Clone, Debug, Default)]
pub struct Curves {
    curves: BTreeMap<String, Vec<Point>>,
}

impl Curves {
    /// The curve of a run.
    pub fn of(&self, run: &Run) -> Option<&[Point]> {
        self.curves.get(&run.name).map(Vec::as_slice)
    }

    /// Add the curves of a file, if it exists.
    ///
    /// # Errors
    /// A file that cannot be read or does not hold curves: file, line, column and cell.
    pub fn add(&mut self, path: &Path) -> Result<(), Error> {
        if !path.exists() {
            return Ok(());
        }
        let table = CsvFile::read(path)?;
        table.check_header(COLUMNS.into_iter())?;
        let place = |name: &str| table.header.iter().position(|column| column == name);
        let [run, time, friction, heat] = COLUMNS.map(|name| place(name).unwrap_or_default());
        for (line, row) in &table.rows {
            let number = |column: usize| {
                let cell = &row[column];
                let refusal =
                    |_| table.error(*line, &table.header[column], cell, "must be a number");
                cell.parse::<f64>().map_err(refusal)
            };
            let point = Point {
                time: number(time)?,
                friction: number(friction)?,
                heat: number(heat)?,
            };
            self.curves
                .entry(row[run].to_owned())
                .or_default()
                .push(point);
        }
        Ok(())
    }

    /// Add the curves of runs whose series stand below a folder.
    pub fn observe(&mut self, results: &Results, out: &Path) {
        let is_shown = |run: &&Run| run.counts() && PRESSURES.contains(&run.pressure());
        for run in results.runs().iter().filter(is_shown) {
            let folder = out.join(&run.part).join("runs").join(&run.name);
            if let Some(curve) = Columns::of_series(&folder).and_then(|series| curve(&series)) {
                self.curves.insert(run.name.clone(), curve);
            }
        }
    }

    /// Write all curves.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let mut text = COLUMNS.join(",") + "\n";
        for (run, curve) in &self.curves {
            for Point {
                time,
                friction,
                heat,
            } in curve
            {
                text += &format!("{run},{time:.6e},{friction:.5},{heat:.5e}\n");
            }
        }
        write_whole(path, text.as_bytes())
    }
}

fn curve(series: &Columns) -> Option<Vec<Point>> {
    let [time, x, y, heat] =
        ["time", "drive_force_x", "drive_force_y", "friction"].map(|name| series.get(name));
    let (time, x, y, heat) = (time?, x?, y?, heat?);
    let size = time.len().div_ceil(POINTS);
    let points = (0..time.len()).step_by(size).map(|from| {
        let to = (from + size).min(time.len());
        let sum = |column: &[f64]| column[from..to].iter().sum::<f64>();
        Point {
            time: 0.5 * (time[from] + time[to - 1]),
            friction: -sum(x) / sum(y),
            heat: heat[to - 1],
        }
    });
    Some(points.collect())
}
