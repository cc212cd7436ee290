//! What is observed in a run.

use crate::decay::Decay;
use crate::series::Series;
use gouge_runner::run::Summary;
use serde::Deserialize;
use std::path::Path;

/// A number taken from a finished run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observation {
    /// Its name in tables; by default that of its quantity or column and statistic.
    pub name: Option<String>,
    /// A quantity of the summary.
    pub quantity: Option<Quantity>,
    /// A column of the series.
    pub column: Option<String>,
    /// What is taken of the column.
    pub statistic: Option<Statistic>,
    /// Time in s from which on the column counts.
    #[serde(default)]
    pub after: f64,
}

/// Quantities of the summary.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Coefficient of friction of the driven block.
    Friction,
    /// Half the width of its confidence interval.
    FrictionMargin,
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
    fn value(self, folder: &Path, summary: &Summary) -> Option<f64> {
        let friction = summary.friction.as_ref();
        match self {
            Self::Friction => friction.map(|one| one.coefficient),
            Self::FrictionMargin => friction.map(|one| 0.5 * (one.interval[1] - one.interval[0])),
            Self::BondsBroken => Some(summary.bonds_broken as f64),
            _ => {
                let series = Series::read(folder)?;
                let mu = series.column("friction_load")?;
                let decay = Decay::fit(series.column("time")?, mu)?;
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
    pub fn value(&self, folder: &Path, summary: &Summary) -> Option<f64> {
        if let Some(quantity) = self.quantity {
            return quantity.value(folder, summary);
        }
        let series = Series::read(folder)?;
        let values = series.column_after(self.column.as_ref()?, self.after)?;
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
