//! What is observed in a run.

use crate::columns::Columns;
use crate::decay::Decay;
use gouge_dem::laws::characteristic_length;
use gouge_runner::run::Summary;
use gouge_runner::scene::Scene;
use serde::Deserialize;
use std::path::Path;

/// A number taken from a finished run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observation {
    /// Its name in tables; by default that of its quantity or column and statistic.
    pub name: Option<String>,
    /// A quantity of the run.
    pub quantity: Option<Quantity>,
    /// A column of the series.
    pub column: Option<String>,
    /// What is taken of the column.
    pub statistic: Option<Statistic>,
    /// Another column, for the statistics that need one.
    pub against: Option<String>,
    /// The range of values of the other column that count; all if absent.
    pub range: Option<[f64; 2]>,
    /// Time in s from which on the column counts.
    #[serde(default)]
    pub after: f64,
    /// Factor of the value.
    pub times: Option<f64>,
}

/// A finished run.
pub struct Finished<'a> {
    /// Its folder.
    pub folder: &'a Path,
    /// Its summary.
    pub summary: &'a Summary,
    /// Reads its scene.
    pub scene: &'a dyn Fn() -> Option<Scene>,
}

/// Quantities of a run.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Coefficient of friction of the driven block.
    Friction,
    /// Half the width of its confidence interval.
    FrictionMargin,
    /// Slip in m over which that coefficient is averaged.
    Slip,
    /// Mean load over the second half of the run, in units of the pressure times the area.
    LoadHeld,
    /// Number of broken bonds.
    BondsBroken,
    /// Limit of friction in the fit of thesis (100).
    DecayLimit,
    /// Half the width of its confidence interval.
    DecayLimitMargin,
    /// Rate of the decay in 1/s.
    DecayRate,
    /// Largest friction.
    DecayPeak,
    /// Its time in s.
    DecayPeakTime,
    /// Standard deviation of the residuals.
    DecayDeviation,
    /// Correlation of neighbouring residuals.
    DecayCorrelation,
    /// Coefficient of restitution of two grains that meet head on in the frame of their centre of mass: the root of
    /// the ratio of the last to the first kinetic energy.
    Restitution,
    /// Angle of repose in rad of the free grains, see `repose_angle`.
    ReposeAngle,
}

impl Quantity {
    /// Its name in files and tables.
    fn name(self) -> &'static str {
        match self {
            Self::Friction => "friction",
            Self::FrictionMargin => "friction-margin",
            Self::Slip => "slip",
            Self::LoadHeld => "load-held",
            Self::BondsBroken => "bonds-broken",
            Self::DecayLimit => "decay-limit",
            Self::DecayLimitMargin => "decay-limit-margin",
            Self::DecayRate => "decay-rate",
            Self::DecayPeak => "decay-peak",
            Self::DecayPeakTime => "decay-peak-time",
            Self::DecayDeviation => "decay-deviation",
            Self::DecayCorrelation => "decay-correlation",
            Self::Restitution => "restitution",
            Self::ReposeAngle => "repose-angle",
        }
    }

    /// Its value in a finished run.
    fn value(self, run: &Finished) -> Option<f64> {
        let Finished {
            folder, summary, ..
        } = run;
        let friction = summary.friction.as_ref();
        match self {
            Self::Slip => friction.map(|one| one.slip),
            Self::LoadHeld => load_held(run),
            Self::Friction => friction.map(|one| one.coefficient),
            Self::FrictionMargin => friction.map(|one| 0.5 * (one.interval[1] - one.interval[0])),
            Self::BondsBroken => Some(summary.bonds_broken as f64),
            Self::Restitution => restitution(folder),
            Self::ReposeAngle => repose_angle(folder),
            _ => {
                let series = Columns::of_series(folder)?;
                let mu = series.get("friction_load")?;
                let decay = Decay::fit(series.get("time")?, mu)?;
                Some(match self {
                    Self::DecayLimitMargin => decay.limit_margin(),
                    Self::DecayLimit => decay.limit,
                    Self::DecayRate => decay.rate,
                    Self::DecayPeak => decay.peak,
                    Self::DecayPeakTime => decay.peak_time,
                    Self::DecayDeviation => decay.deviation(),
                    _ => decay.correlation(),
                })
            }
        }
    }
}

/// What is taken of a column.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Statistic {
    /// The mean.
    Mean,
    /// The standard deviation.
    Deviation,
    /// The smallest value.
    Minimum,
    /// The largest value.
    Maximum,
    /// The last value.
    Last,
    /// The slope of the line of least squares through the column against another one.
    Slope,
    /// The value where the other column is largest.
    AtPeak,
}

impl Observation {
    /// Check that exactly one of quantity and column is given, and what the statistic needs.
    ///
    /// # Errors
    /// What is accepted.
    pub fn check(&self) -> Result<(), String> {
        let of_two = matches!(self.statistic, Some(Statistic::Slope | Statistic::AtPeak));
        let accepted = match (&self.quantity, &self.column, &self.statistic) {
            (None, Some(_), None) => {
                "needs statistic: mean, deviation, minimum, maximum, last, slope or at-peak"
            }
            (Some(_), Some(_), _) | (None, None, _) | (Some(_), None, Some(_)) => {
                "must have either quantity, or column and statistic"
            }
            _ if of_two && self.against.is_none() => "needs against: another column",
            _ if !of_two && self.against.is_some() => {
                "against is for the statistics slope and at-peak"
            }
            _ if self.range.is_some() && self.against.is_none() => {
                "range is one of the column against"
            }
            _ => return Ok(()),
        };
        Err(accepted.to_owned())
    }

    /// The name in tables.
    pub fn name(&self) -> String {
        let default = || match (&self.quantity, &self.column, &self.statistic) {
            (Some(quantity), ..) => quantity.name().to_owned(),
            (None, Some(column), Some(statistic)) => {
                format!("{column}_{}", format!("{statistic:?}").to_lowercase())
            }
            _ => String::new(),
        };
        self.name.clone().unwrap_or_else(default)
    }

    /// The value in a finished run.
    ///
    /// # Errors
    /// That the run does not have it.
    pub fn value(&self, run: &Finished) -> Result<f64, String> {
        let value = match (self.quantity, &self.column, self.statistic) {
            (Some(quantity), ..) => quantity.value(run),
            (None, Some(column), Some(statistic)) => self.statistic(run.folder, column, statistic),
            _ => None,
        };
        let value = value.map(|value| self.times.unwrap_or(1.0) * value);
        let value = value.filter(|value| value.is_finite());
        value.ok_or_else(|| match self.quantity {
            Some(Quantity::Restitution) => "the grains still touch at the end".to_owned(),
            _ => format!("the run has no {}", self.name()),
        })
    }

    fn statistic(&self, folder: &Path, name: &str, statistic: Statistic) -> Option<f64> {
        let series = Columns::of_series(folder)?;
        let values = series.after(name, self.after)?;
        let others = series.after(self.against.as_deref().unwrap_or("time"), self.after)?;
        let [low, high] = self.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let pairs: Vec<[f64; 2]> = others
            .iter()
            .zip(values)
            .filter(|(other, _)| (low..=high).contains(*other))
            .map(|(&other, &value)| [other, value])
            .collect();
        let (last, number) = (pairs.last()?, pairs.len() as f64);
        let values = || pairs.iter().map(|pair| pair[1]);
        let mean = |k: usize| pairs.iter().map(|pair| pair[k]).sum::<f64>() / number;
        let means = [mean(0), mean(1)];
        let moment = |k: usize, l: usize| {
            let products = pairs
                .iter()
                .map(|pair| (pair[k] - means[k]) * (pair[l] - means[l]));
            products.sum::<f64>()
        };
        Some(match statistic {
            Statistic::Mean => means[1],
            Statistic::Deviation => (moment(1, 1) / (number - 1.0)).sqrt(),
            Statistic::Minimum => values().fold(f64::INFINITY, f64::min),
            Statistic::Maximum => values().fold(f64::NEG_INFINITY, f64::max),
            Statistic::Last => last[1],
            Statistic::Slope => moment(0, 1) / moment(0, 0),
            Statistic::AtPeak => pairs.iter().max_by(|a, b| a[0].total_cmp(&b[0]))?[1],
        })
    }
}

fn load_held(run: &Finished) -> Option<f64> {
    let scene = (run.scene)()?;
    let particles = Columns::read(&run.folder.join("particles.csv"))?;
    let driving = scene.driving?;
    let law = driving.law(
        scene.domain.width?,
        characteristic_length(particles.get("radius")?),
    );
    let series = Columns::of_series(run.folder)?;
    let force = series.after("drive_force_y", 0.5 * run.summary.time)?;
    let load = -force.iter().sum::<f64>() / force.len() as f64;
    Some(load / (law.pressure * law.area))
}

/// Root of the ratio of the last to the first kinetic energy; none if the grains still touch.
fn restitution(folder: &Path) -> Option<f64> {
    let series = Columns::of_series(folder)?;
    let kinetic = series.get("kinetic")?;
    let is_over = *series.get("contact")?.last()? == 0.0;
    is_over.then_some((kinetic.last()? / kinetic.first()?).sqrt())
}

/// Angle in rad of the triangle whose centre of mass is as high above the highest fixed grain, and whose horizontal
/// variance is as large, as those of the free grains: a triangle of height H and base 2 B has its centre of mass at
/// H / 3, and its variance is B^2 / 6.
fn repose_angle(folder: &Path) -> Option<f64> {
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
