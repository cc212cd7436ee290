//! What is observed in a run.

use super::finished::Finished;
use super::quantity::Quantity;
use gouge_runner::any_scene::AnyScene;
use gouge_runner::contact_dynamics::Means;
use serde::Deserialize;

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
    /// A mean over the contact networks of contact dynamics.
    pub network: Option<String>,
    /// Another column, for the statistics that need one.
    pub against: Option<String>,
    /// The range of values of the other column that count; all if absent.
    pub range: Option<[f64; 2]>,
    /// The level that the other column must reach.
    pub level: Option<f64>,
    /// Time in s from which on the column counts.
    #[serde(default)]
    pub after: f64,
    /// Factor of the value.
    pub times: Option<f64>,
    /// Unit of the value on figures; by default that of the quantity.
    pub unit: Option<String>,
}

/// A key with a mistake, and what is accepted.
pub type Mistake = (&'static str, String);

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
    /// The value where the other column is smallest.
    AtTrough,
    /// The value where the other column first reaches a level, on the line between two samples.
    AtLevel,
    /// The value in the last sample before the other column first changes.
    AtChange,
}

impl Statistic {
    /// Whether it needs another column.
    fn is_of_two(self) -> bool {
        matches!(
            self,
            Self::Slope | Self::AtPeak | Self::AtTrough | Self::AtLevel | Self::AtChange
        )
    }
}

impl Observation {
    /// Check that exactly one of quantity and column is given, what the statistic needs, and all numbers.
    ///
    /// # Errors
    /// The key at fault and what is accepted.
    pub fn check(&self) -> Result<(), Mistake> {
        let of_two = self.statistic.is_some_and(Statistic::is_of_two);
        let at_level = matches!(self.statistic, Some(Statistic::AtLevel));
        let is_finite = |number: Option<f64>| number.is_none_or(f64::is_finite);
        let [low, high] = self.range.unwrap_or([0.0, 1.0]);
        let (key, accepted) = match (&self.quantity, &self.column, &self.statistic) {
            _ if self.network.is_some() => return self.check_network(),
            (None, Some(_), None) => (
                "statistic",
                "a column needs one of mean, deviation, minimum, maximum, last, slope, at-peak, at-trough, at-level and at-change",
            ),
            (Some(_), Some(_), _) => ("column", "must not be given beside quantity"),
            (None, None, _) => (
                "quantity",
                "must have either quantity, or column and statistic, or network",
            ),
            (Some(_), None, Some(_)) => ("statistic", "is for a column, not for a quantity"),
            _ if of_two && self.against.is_none() => ("against", "must name another column"),
            _ if !of_two && self.against.is_some() => (
                "against",
                "is for the statistics slope, at-peak, at-trough, at-level and at-change",
            ),
            _ if !is_finite(self.level) => ("level", "must be a finite number"),
            _ if at_level != self.level.is_some() => {
                ("level", "belongs to the statistic at-level, which needs it")
            }
            _ if self.range.is_some() && self.against.is_none() => {
                ("range", "is one of the column against, which is missing")
            }
            _ if low.is_nan() || high.is_nan() || low > high => {
                ("range", "must be two numbers, the smaller one first")
            }
            _ if !self.after.is_finite() => ("after", "must be a finite number"),
            _ if !is_finite(self.times) => ("times", "must be a finite number"),
            _ => return Ok(()),
        };
        Err((key, accepted.to_owned()))
    }

    /// Check an observation of contact networks.
    fn check_network(&self) -> Result<(), Mistake> {
        let others = [
            ("quantity", self.quantity.is_some()),
            ("column", self.column.is_some()),
            ("statistic", self.statistic.is_some()),
            ("against", self.against.is_some()),
            ("range", self.range.is_some()),
            ("level", self.level.is_some()),
        ];
        if let Some((key, _)) = others.into_iter().find(|(_, is_given)| *is_given) {
            return Err((key, "must not be given beside network".to_owned()));
        }
        let names = Means::names();
        let is_known = self
            .network
            .as_ref()
            .is_some_and(|name| names.contains(name));
        match is_known {
            true => Ok(()),
            false => Err(("network", format!("must be one of {}", names.join(", ")))),
        }
    }

    /// Check that runs of a scene can have a value.
    ///
    /// # Errors
    /// The key at fault and what is accepted.
    pub fn check_in(&self, scene: &AnyScene) -> Result<(), Mistake> {
        let lacks = |quantity: Quantity| match scene.as_dem() {
            Some(scene) => quantity.lacks(scene),
            None => Some("model = \"dem\"; columns of its series can be observed"),
        };
        if let Some(needed) = self.quantity.and_then(lacks) {
            return Err(("quantity", format!("needs a scene with {needed}")));
        }
        if self.network.is_some() && !scene.measures_network() {
            let accepted = "needs a scene of contact dynamics with output.measure = [\"network\"]";
            return Err(("network", accepted.to_owned()));
        }
        let columns = scene.series_columns();
        for (key, column) in [("column", &self.column), ("against", &self.against)] {
            let is_known = |name: &String| columns.contains(&name.as_str());
            if !column.as_ref().is_none_or(is_known) {
                let list = columns.join(", ");
                return Err((key, format!("must be a column of the series: {list}")));
            }
        }
        match self.after > scene.end() {
            true => {
                let end = scene.end();
                Err(("after", format!("must not be above time.end = {end:?}")))
            }
            false => Ok(()),
        }
    }

    /// The name in tables.
    pub fn name(&self) -> String {
        let network = || self.network.clone().unwrap_or_default();
        let default = || match (&self.quantity, &self.column, &self.statistic) {
            (Some(quantity), ..) => quantity.name().to_owned(),
            (None, Some(column), Some(statistic)) => {
                format!("{column}_{}", format!("{statistic:?}").to_lowercase())
            }
            _ => network(),
        };
        self.name.clone().unwrap_or_else(default)
    }

    /// The unit on figures; empty if there is none, or if it is not known.
    pub fn unit(&self) -> &str {
        let own = self.quantity.filter(|_| self.times.is_none());
        let default = own.map_or("", Quantity::unit);
        self.unit.as_deref().unwrap_or(default)
    }

    /// The value in a finished run.
    ///
    /// # Errors
    /// That the run does not have it.
    pub fn value(&self, run: &Finished) -> Result<f64, String> {
        let value = match (self.quantity, &self.column, self.statistic) {
            (Some(quantity), ..) => quantity.value(run),
            (None, Some(column), Some(statistic)) => self.statistic(run, column, statistic),
            _ => run.network(self.after, self.network.as_deref().unwrap_or_default()),
        };
        let value = value.map(|value| self.times.unwrap_or(1.0) * value);
        let value = value.filter(|value| value.is_finite());
        value.ok_or_else(|| match self.quantity {
            Some(Quantity::Restitution | Quantity::ContactDuration) => {
                "the grains still touch at the end".to_owned()
            }
            _ => format!("the run has no {}", self.name()),
        })
    }

    fn statistic(&self, run: &Finished, name: &str, statistic: Statistic) -> Option<f64> {
        let series = run.series()?;
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
            Statistic::AtTrough => pairs.iter().min_by(|a, b| a[0].total_cmp(&b[0]))?[1],
            Statistic::AtLevel => at_level(&pairs, self.level?)?,
            Statistic::AtChange => before_change(&pairs)?,
        })
    }
}

/// The second numbers where the first ones reach a level, on the line between two pairs.
fn at_level(pairs: &[[f64; 2]], level: f64) -> Option<f64> {
    let is_crossed = |two: &&[[f64; 2]]| (two[0][0] - level) * (two[1][0] - level) <= 0.0;
    let crossing = pairs.windows(2).find(is_crossed)?;
    let [[x, a], [y, b]] = [crossing[0], crossing[1]];
    let part = if x == level {
        0.0
    } else {
        (level - x) / (y - x)
    };
    Some(a + part * (b - a))
}

/// The second number of the last pair before the first numbers change.
fn before_change(pairs: &[[f64; 2]]) -> Option<f64> {
    let changed = pairs.windows(2).find(|two| two[0][0] != two[1][0])?;
    Some(changed[0][1])
}
