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
    /// Time in s from which on the column counts.
    #[serde(default)]
    pub after: f64,
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
#[serde(rename_all = "lowercase")]
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
}

impl Observation {
    /// Check that exactly one of quantity and column is given.
    ///
    /// # Errors
    /// What is accepted.
    pub fn check(&self) -> Result<(), String> {
        match (&self.quantity, &self.column, &self.statistic) {
            (Some(_), None, None) | (None, Some(_), Some(_)) => Ok(()),
            (None, Some(_), None) => {
                Err("needs statistic: mean, deviation, minimum, maximum or last".to_owned())
            }
            _ => Err("must have either quantity, or column and statistic".to_owned()),
        }
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

    /// The value in a finished run; none if the run does not have it.
    pub fn value(&self, run: &Finished) -> Option<f64> {
        if let Some(quantity) = self.quantity {
            return quantity.value(run);
        }
        let series = Columns::of_series(run.folder)?;
        let values = series.after(self.column.as_ref()?, self.after)?;
        let number = values.len() as f64;
        let mean = values.iter().sum::<f64>() / number;
        Some(match self.statistic? {
            Statistic::Mean => mean,
            Statistic::Deviation => {
                let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
                (squares / (number - 1.0)).sqrt()
            }
            Statistic::Minimum => values.iter().copied().fold(f64::INFINITY, f64::min),
            Statistic::Maximum => values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Statistic::Last => *values.last()?,
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
