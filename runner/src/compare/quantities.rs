//! The columns that both sides have.

use super::read::{Data, Kind};
use super::{Difference, Options, refusal};
use crate::error::Error;
use crate::run::sample_of;
use crate::scene::Scene;
use gouge_dem::World;

/// Columns of particles: our name, the unit, and names of other programs.
const PARTICLES: [(&str, &str, &[&str]); 11] = [
    ("x", "m", &["xu"]),
    ("y", "m", &["yu"]),
    ("vx", "m/s", &[]),
    ("vy", "m/s", &[]),
    ("angle", "rad", &[]),
    ("angular_velocity", "rad/s", &["omegaz"]),
    ("radius", "m", &[]),
    ("mass", "kg", &[]),
    ("fx", "N", &[]),
    ("fy", "N", &[]),
    ("torque", "N m", &["tqz"]),
];
/// Those that need an evaluation of the forces.
const FORCES: [&str; 3] = ["fx", "fy", "torque"];

/// The columns that are compared.
pub struct Quantities {
    /// Our name, and the position of the column in the data.
    chosen: Vec<(String, usize)>,
    kind: Kind,
}

/// All columns of the data but time and identifiers.
fn names_of(data: &Data) -> String {
    let all: Vec<&str> = data
        .names
        .iter()
        .chain(&data.others)
        .map(String::as_str)
        .collect();
    match all.is_empty() {
        true => "no columns besides times and identifiers".to_owned(),
        false => all.join(", "),
    }
}

/// Our name of a column of particles.
fn own_name(name: &str) -> Option<&'static str> {
    let is_it = |one: &&(&'static str, &str, &[&str])| one.0 == name || one.2.contains(&name);
    PARTICLES.iter().find(is_it).map(|one| one.0)
}

impl Quantities {
    /// The columns that the data and the run have, or those of them that are wanted.
    ///
    /// # Errors
    /// A wanted column that one side lacks, or no common column.
    pub fn of(data: &Data, wanted: &[String], scene: &Scene, world: &World) -> Result<Self, Error> {
        let ours: Vec<String> = match data.kind {
            Kind::Particles => PARTICLES.iter().map(|one| one.0.to_owned()).collect(),
            Kind::Run => sample_of(scene, world)?
                .into_iter()
                .map(|(name, _)| name.to_owned())
                .collect(),
        };
        let is_known = |name: &&String| own_name(name).is_some() || ours.contains(*name);
        if let Some(name) = data.others.iter().find(is_known) {
            return Err(refusal(
                data,
                &format!("{name}: this column holds no numbers"),
            ));
        }
        let canonical = |name: &String| match data.kind {
            Kind::Particles => own_name(name).map(str::to_owned),
            Kind::Run => ours.contains(name).then(|| name.clone()),
        };
        let both = data.names.iter().enumerate();
        let chosen: Vec<(String, usize)> = both
            .filter_map(|(place, name)| Some((canonical(name)?, place)))
            .filter(|(name, place)| {
                wanted.is_empty() || wanted.contains(name) || wanted.contains(&data.names[*place])
            })
            .collect();
        let has = |name: &&String| {
            chosen
                .iter()
                .any(|(own, place)| own == *name || data.names[*place] == **name)
        };
        if let Some(missing) = wanted.iter().find(|name| !has(name)) {
            let reason = format!(
                "--columns {missing}: the data have {}, the run has {}",
                names_of(data),
                ours.join(", ")
            );
            return Err(refusal(data, &reason));
        }
        if chosen.is_empty() {
            let reason = format!(
                "no column can be compared; the data have {}, the run has {}",
                names_of(data),
                ours.join(", ")
            );
            return Err(refusal(data, &reason));
        }
        Ok(Self {
            chosen,
            kind: data.kind,
        })
    }

    /// Position of a compared column in the data.
    pub fn column(&self, place: usize) -> usize {
        self.chosen[place].1
    }

    /// Columns of the data that are not compared.
    pub fn ignored(&self, data: &Data) -> Vec<String> {
        let names = data.names.iter().enumerate();
        let rest = names.filter(|(place, _)| self.chosen.iter().all(|one| one.1 != *place));
        rest.map(|(_, name)| name.clone())
            .chain(data.others.iter().cloned())
            .collect()
    }

    /// The differences before anything is compared.
    ///
    /// # Errors
    /// A tolerance of a column that is not compared.
    pub fn differences(&self, data: &Data, options: &Options) -> Result<Vec<Difference>, Error> {
        let is_known = |name: &String| {
            self.chosen
                .iter()
                .any(|(own, place)| own == name || data.names[*place] == *name)
        };
        let mut given = options.tolerances.iter().chain(&options.absolute);
        if let Some((name, _)) = given.find(|(name, _)| !is_known(name)) {
            return Err(refusal(
                data,
                &format!("--tolerance {name}=...: this column is not compared"),
            ));
        }
        let difference = |(own, place): &(String, usize)| {
            let is_it = |one: &&(String, f64)| one.0 == *own || one.0 == data.names[*place];
            let unit = PARTICLES
                .iter()
                .find(|one| one.0 == own)
                .map_or("", |one| one.1);
            Difference {
                name: own.clone(),
                unit,
                largest: 0.0,
                range: range(data, *place),
                time: 0.0,
                particle: None,
                absolute: options.absolute.iter().find(is_it).map_or(0.0, |one| one.1),
                tolerance: options
                    .tolerances
                    .iter()
                    .find(is_it)
                    .map_or(options.tolerance, |one| one.1),
            }
        };
        Ok(self.chosen.iter().map(difference).collect())
    }

    /// Our values of all compared columns.
    ///
    /// # Errors
    /// Forces that cannot be evaluated.
    pub fn values(&self, scene: &Scene, world: &World) -> Result<Vec<Vec<f64>>, Error> {
        if self.kind == Kind::Run {
            let sample = sample_of(scene, world)?;
            let value = |(name, _): &(String, usize)| {
                let found = sample.iter().find(|(own, _)| own == name);
                vec![found.map_or(f64::NAN, |(_, value)| value.number())]
            };
            return Ok(self.chosen.iter().map(value).collect());
        }
        let mut ahead = world.clone();
        if self
            .chosen
            .iter()
            .any(|(name, _)| FORCES.contains(&name.as_str()))
        {
            ahead.evaluate_if_pending().map_err(|source| Error::Step {
                phase: "run".to_owned(),
                source,
            })?;
        }
        Ok(self
            .chosen
            .iter()
            .map(|(name, _)| particle_values(name, &ahead))
            .collect())
    }
}

fn particle_values(name: &str, world: &World) -> Vec<f64> {
    let (p, forces) = (world.particles(), world.forces());
    let of = |value: &dyn Fn(usize) -> f64| (0..p.len()).map(value).collect();
    match name {
        "x" => of(&|i| p.position[i].x),
        "y" => of(&|i| p.position[i].y),
        "vx" => of(&|i| p.velocity[i].x),
        "vy" => of(&|i| p.velocity[i].y),
        "angle" => p.angle.clone(),
        "angular_velocity" => p.angular_velocity.clone(),
        "radius" => p.radius.clone(),
        "mass" => p.mass.clone(),
        "fx" => of(&|i| forces.force[i].x),
        "fy" => of(&|i| forces.force[i].y),
        _ => forces.torque.clone(),
    }
}

/// Difference of the largest and the smallest value of a column, or the largest magnitude if all are equal.
fn range(data: &Data, column: usize) -> f64 {
    let values = || {
        data.frames
            .iter()
            .flat_map(|frame| &frame.columns[column])
            .copied()
    };
    let high = values().fold(f64::NEG_INFINITY, f64::max);
    let low = values().fold(f64::INFINITY, f64::min);
    match high > low {
        true => high - low,
        false => high.abs(),
    }
}
