//! Observables of the whole system, as engines record them in a series.

use crate::checks::Failure;
use crate::checks::dem::scenes::advance;
use crate::references::{Observable, Statistic, Table};
use gouge_dem::World;
use gouge_dem::particles::Role;

/// Mass in kg above which a free particle represents a moving wall.
const WALL: f64 = 1.0;

/// The kernel's series of a run, with the columns and steps of the engine's series.
pub(super) struct Course(pub Table);

impl Course {
    /// Runs a world and measures at the steps of a recorded series.
    pub fn beside(world: &mut World, recorded: &Table) -> Result<Self, Failure> {
        let place = recorded.column("step").map_err(Failure::Oracle)?;
        let mut rows = Vec::with_capacity(recorded.rows.len());
        for row in &recorded.rows {
            let missing = (row[place] as u64).saturating_sub(world.steps());
            advance(world, missing)?;
            world.evaluate_if_pending()?;
            let columns = recorded.columns.iter();
            rows.push(
                columns
                    .map(|name| measured(world, name))
                    .collect::<Result<_, _>>()?,
            );
        }
        Ok(Self(Table {
            columns: recorded.columns.clone(),
            rows,
        }))
    }
}

/// Value of an observable in a series.
///
/// # Errors
/// A missing column, or no record within the steps of the observable.
pub(super) fn value(series: &Table, observable: &Observable) -> Result<f64, String> {
    let step = series.column("step")?;
    let [first, last] = observable.steps;
    let taken = |name: &str| {
        let place = series.column(name)?;
        let within = |row: &&Vec<f64>| (first as f64..=last as f64).contains(&row[step]);
        let values: Vec<f64> = series
            .rows
            .iter()
            .filter(within)
            .map(|row| row[place])
            .collect();
        if values.is_empty() {
            return Err(format!(
                "{name} has no record between steps {first} and {last}"
            ));
        }
        Ok(values)
    };
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let values = taken(&observable.name)?;
    let value = match observable.statistic {
        Statistic::Mean => mean(&values),
        Statistic::Largest => values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        Statistic::Last => values[values.len() - 1],
    };
    match &observable.over {
        None => Ok(value),
        Some(other) => Ok(value / mean(&taken(other)?)),
    }
}

/// A column of the kernel's series, in SI units.
fn measured(world: &World, name: &str) -> Result<f64, Failure> {
    let p = world.particles();
    let grains = || (0..p.len()).filter(|&i| is_grain(world, i));
    let pulled = || (0..p.len()).filter(|&i| p.role[i] == Role::Free && p.mass[i] > WALL);
    let number = grains().count() as f64;
    Ok(match name {
        "step" => world.steps() as f64,
        "kinetic_energy" => grains()
            .map(|i| 0.5 * p.mass[i] * p.velocity[i].norm_squared())
            .sum(),
        "mean_height" => grains().map(|i| p.position[i].y).sum::<f64>() / number,
        "coordination" => touches(world) as f64 / number,
        "wall_force_x" => pulled().map(|i| world.forces().force[i].x).sum(),
        "wall_force_y" => pulled().map(|i| world.forces().force[i].y).sum(),
        "tension" => -pulled().map(|i| world.forces().force[i].y).sum::<f64>(),
        "bonds" => world.bonds().map_or(0, |strong| strong.len()) as f64,
        _ => return Err(Failure::Oracle(format!("unknown observable {name}"))),
    })
}

fn is_grain(world: &World, i: usize) -> bool {
    let p = world.particles();
    p.role[i] == Role::Free && p.mass[i] <= WALL
}

/// Contacts of all grains; a contact between two grains counts twice.
fn touches(world: &World) -> usize {
    let links = world.interactions();
    let ends = |(i, j): (usize, usize)| [i, j].into_iter().filter(|&i| is_grain(world, i)).count();
    links.iter().map(|link| ends(link.pair.indices())).sum()
}
