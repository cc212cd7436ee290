//! Properties of specimens, as experiments measure them.

use crate::columns::Columns;
use serde::Deserialize;
use std::path::Path;

/// Root of the ratio of the last to the first kinetic energy; none if the grains still touch.
pub fn restitution(series: &Columns) -> Option<f64> {
    let kinetic = series.get("kinetic")?;
    let is_over = *series.get("contact")?.last()? == 0.0;
    is_over.then_some((kinetic.last()? / kinetic.first()?).sqrt())
}

/// Time in s in which the grains touch, from halfway before the first sample with contact energy to halfway after the
/// last one; none if they never touch or still do.
pub fn contact_duration(series: &Columns) -> Option<f64> {
    let (time, contact) = (series.get("time")?, series.get("contact")?);
    let first = contact.iter().position(|&energy| energy > 0.0)?;
    let last = contact.iter().rposition(|&energy| energy > 0.0)?;
    let (before, after) = (time.get(first.checked_sub(1)?)?, time.get(last + 1)?);
    Some(0.5 * (after + time[last]) - 0.5 * (time[first] + before))
}

/// Young's modulus in Pa and Poisson's ratio of the isotropic plane solid, free to expand out of the plane, that has the
/// stress and strain of the specimen along the axes in the last sample before a bond breaks:
/// E e_x = s_x - nu s_y, E e_y = s_y - nu s_x.
pub fn isotropic(series: &Columns) -> Option<[f64; 2]> {
    let time = series.get("time")?;
    let whole = match series.get("bonds") {
        Some(bonds) => bonds
            .iter()
            .take_while(|&number| *number == bonds[0])
            .count(),
        None => time.len(),
    };
    let last = |name: &str| series.get(name)?[..whole].last().copied();
    let [stress_x, stress_y] = [last("stress_xx")?, last("stress_yy")?];
    let [strain_x, strain_y] = [last("strain_xx")?, last("strain_yy")?];
    let ratio =
        (strain_y * stress_x - strain_x * stress_y) / (strain_y * stress_y - strain_x * stress_x);
    Some([(stress_y - ratio * stress_x) / strain_y, ratio])
}

/// Angle in rad of the triangle whose centre of mass is as high above the highest fixed grain, and whose horizontal
/// variance is as large, as those of the free grains: a triangle of height H and base 2 B has its centre of mass at
/// H / 3, and its variance is B^2 / 6.
pub fn repose_angle(folder: &Path) -> Option<f64> {
    let mut reader = csv::Reader::from_path(folder.join("particles.csv")).ok()?;
    let (mut floor, mut free) = (f64::NEG_INFINITY, Vec::new());
    for grain in reader.deserialize::<Grain>() {
        let grain = grain.ok()?;
        match grain.role.as_str() {
            "fixed" => floor = floor.max(grain.y),
            _ => free.push([grain.x, grain.y]),
        }
    }
    let number = free.len() as f64;
    let mean = |k: usize| free.iter().map(|place| place[k]).sum::<f64>() / number;
    let (middle, height) = (mean(0), mean(1) - floor);
    let squares = free.iter().map(|place| (place[0] - middle).powi(2));
    let variance = squares.sum::<f64>() / number;
    Some((3.0 * height / (6.0 * variance).sqrt()).atan())
}

/// A row of the final particles.
#[derive(Deserialize)]
struct Grain {
    x: f64,
    y: f64,
    role: String,
}
