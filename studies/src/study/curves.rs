//! Two quantities over time, of the runs that figures show.

use super::results::{Results, Run};
use crate::columns::Columns;
use crate::csv_table::CsvFile;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

/// Points of a curve.
const POINTS: usize = 50;

/// What the curves of a study are.
#[derive(Clone, Copy)]
pub struct CurvePlan {
    /// Names of the two quantities.
    pub names: [&'static str; 2],
    /// Whether the curves of a run are kept.
    pub is_shown: fn(&Run) -> bool,
    /// The two numbers over some rows of a series; none if it lacks the columns.
    pub numbers: fn(&Columns, Range<usize>) -> Option<[f64; 2]>,
}

/// A point of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Middle of the stretch of time that the point stands for, in s.
    pub time: f64,
    /// The two quantities.
    pub numbers: [f64; 2],
}

/// Curves by the name of their run.
pub struct Curves {
    plan: CurvePlan,
    curves: BTreeMap<String, Vec<Point>>,
}

impl Curves {
    /// No curves.
    pub fn new(plan: CurvePlan) -> Self {
        Self {
            plan,
            curves: BTreeMap::new(),
        }
    }

    fn columns(&self) -> [&'static str; 4] {
        let [one, other] = self.plan.names;
        ["run", "time", one, other]
    }

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
        table.check_header(self.columns().into_iter())?;
        let place = |name: &str| table.header.iter().position(|column| column == name);
        let [run, time, one, other] = self.columns().map(|name| place(name).unwrap_or_default());
        for (line, row) in &table.rows {
            let number = |column: usize| {
                let cell = &row[column];
                let refusal =
                    |_| table.error(*line, &table.header[column], cell, "must be a number");
                cell.parse::<f64>().map_err(refusal)
            };
            let point = Point {
                time: number(time)?,
                numbers: [number(one)?, number(other)?],
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
        let plan = self.plan;
        let is_shown = |run: &&Run| run.counts() && (plan.is_shown)(run);
        for run in results.runs().iter().filter(is_shown) {
            let folder = out.join(&run.part).join("runs").join(&run.name);
            let series = Columns::of_series(&folder);
            if let Some(curve) = series.and_then(|series| curve(&plan, &series)) {
                self.curves.insert(run.name.clone(), curve);
            }
        }
    }

    /// Write all curves.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let mut text = self.columns().join(",") + "\n";
        for (run, curve) in &self.curves {
            for Point { time, numbers } in curve {
                let [one, other] = numbers;
                text += &format!("{run},{time:.6e},{one:.5},{other:.5e}\n");
            }
        }
        write_whole(path, text.as_bytes())
    }
}

fn curve(plan: &CurvePlan, series: &Columns) -> Option<Vec<Point>> {
    let time = series.get("time")?;
    let size = time.len().div_ceil(POINTS).max(1);
    let points = (0..time.len()).step_by(size).map(|from| {
        let to = (from + size).min(time.len());
        Some(Point {
            time: 0.5 * (time[from] + time[to - 1]),
            numbers: (plan.numbers)(series, from..to)?,
        })
    });
    points.collect()
}
