//! The picture of stresses over strains, of a run that measures both.

use super::folder::{SERIES, STRESS_STRAIN, write_whole};
use crate::error::Error;
use crate::scene::{Measure, Scene};
use gouge_page::{Axis, Curve, Figure};
use std::path::Path;

/// Columns of a component of strain and of stress.
const COMPONENTS: [[&str; 2]; 3] = [
    ["strain_xx", "stress_xx"],
    ["strain_yy", "stress_yy"],
    ["strain_xy", "stress_xy"],
];

/// Write `stress-strain.svg` from the series if the scene measures stress and strain.
///
/// # Errors
/// Failures of the file system.
pub fn write(folder: &Path, scene: &Scene) -> Result<(), Error> {
    let measures = &scene.output.measure;
    let both = [Measure::Stress, Measure::Strain];
    let series = folder.join(SERIES);
    if !both.iter().all(|one| measures.contains(one)) || !series.exists() {
        return Ok(());
    }
    let failed = |error| Error::file("draw", &series, error);
    let mut reader = csv::Reader::from_path(&series).map_err(|error| failed(error.into()))?;
    let header = reader.headers().map_err(|error| failed(error.into()))?;
    let header = header.clone();
    let rows: Vec<csv::StringRecord> = reader.records().flatten().collect();
    let curve = |[strain, stress]: [&str; 2]| {
        let number = |row: &csv::StringRecord, name: &str| -> Option<f64> {
            let place = header.iter().position(|column| column == name)?;
            row.get(place)?.parse().ok()
        };
        let points = rows.iter().filter_map(|row| {
            let point = [number(row, strain)?, number(row, stress)?];
            point.iter().all(|x: &f64| x.is_finite()).then_some(point)
        });
        Curve::line(&stress.replace('_', " "), points)
    };
    let figure = Figure::new(
        format!("{}: stress over the same component of strain", scene.title),
        Axis::linear("strain", "1"),
        Axis::linear("stress", "Pa"),
        COMPONENTS.into_iter().map(curve).collect(),
    );
    let text = figure.svg().map_err(failed)?;
    write_whole(&folder.join(STRESS_STRAIN), text.as_bytes())
}
