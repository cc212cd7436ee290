//! What is observed in a run.

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
            (Some(quantity), ..) => format!("{quantity:?}").to_lowercase(),
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
            let friction = summary.friction.as_ref();
            return match quantity {
                Quantity::Friction => friction.map(|one| one.coefficient),
                Quantity::FrictionMargin => {
                    friction.map(|one| 0.5 * (one.interval[1] - one.interval[0]))
                }
                Quantity::BondsBroken => Some(summary.bonds_broken as f64),
            };
        }
        let values = column(folder, self.column.as_ref()?, self.after)?;
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

/// A column of the series from a time on.
fn column(folder: &Path, name: &str, after: f64) -> Option<Vec<f64>> {
    let mut reader = csv::Reader::from_path(folder.join("series.csv")).ok()?;
    let place = reader
        .headers()
        .ok()?
        .iter()
        .position(|column| column == name)?;
    let mut values = Vec::new();
    for row in reader.records() {
        let row = row.ok()?;
        let number = |cell: usize| row.get(cell)?.parse::<f64>().ok();
        if number(0)? >= after {
            values.push(number(place)?);
        }
    }
    (!values.is_empty()).then_some(values)
}
