//! The picture of stresses over strains, of a run that measures both.

use super::columns::Columns;
use super::folder::{SERIES, STRESS_STRAIN, write_whole};
use crate::error::Error;
use gouge_page::{Axis, Curve, Figure};
use std::path::Path;

/// Columns of a component of strain and of stress.
const COMPONENTS: [[&str; 2]; 3] = [
    ["strain_xx", "stress_xx"],
    ["strain_yy", "stress_yy"],
    ["strain_xy", "stress_xy"],
];
/// The part of its peak to which the largest stress falls at failure.
const FAILED: f64 = 0.5;

/// Write `stress-strain.svg` if the series has stresses and strains.
///
/// # Errors
/// Failures of the file system.
pub fn write(folder: &Path) -> Result<(), Error> {
    let path = folder.join(SERIES);
    let Some(figure) = stress_strain(&Columns::read(&path)) else {
        return Ok(());
    };
    let text = figure
        .svg()
        .map_err(|error| Error::file("draw", &path, error))?;
    write_whole(&folder.join(STRESS_STRAIN), text.as_bytes())
}

/// Each component of the mean stress over the same component of the strain, until the specimen fails: the strain of
/// what is left afterwards says nothing.
pub fn stress_strain(series: &Columns) -> Option<Figure> {
    let samples = failure(series);
    let curve = |columns: [&str; 2]| {
        let mut curve = series.curve(&columns[1].replace('_', " "), columns)?;
        curve.points.truncate(samples);
        Some(curve)
    };
    let curves: Vec<Curve> = COMPONENTS.into_iter().filter_map(curve).collect();
    let figure = Figure::new(
        "Mean stress over the same component of the strain, until the largest stress has fallen to half of its peak.",
        Axis::linear("strain", ""),
        Axis::linear("stress", "Pa"),
        curves,
    );
    (!figure.curves.is_empty()).then_some(figure)
}

/// Number of samples until the component of the largest stress has fallen to half of its peak.
fn failure(series: &Columns) -> usize {
    let components = COMPONENTS
        .iter()
        .filter_map(|[_, stress]| series.get(stress));
    let peaks = components.filter_map(|stress| {
        let sizes = stress.iter().map(|value| value.abs()).enumerate();
        let peak = sizes
            .filter(|(_, size)| size.is_finite())
            .max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some((stress, peak))
    });
    let largest = peaks.max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1));
    largest.map_or(0, |(stress, (place, peak))| {
        let later = stress[place..].iter();
        let fallen = later.take_while(|value| value.abs() >= FAILED * peak);
        place + fallen.count()
    })
}
