//! Sweep files.

use super::cost::Cost;
use super::observe::Observation;
use super::table::{COST, RUN, STATE};
use crate::text::{Place, inline, number, read_text, scene_beside};
use gouge_runner::error::{Error, SceneError};
use serde::Deserialize;
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use toml::{Spanned, Value};

/// A sweep, as its file states it.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Name of the file.
    pub file: String,
    /// Text of the file.
    pub text: String,
    /// A scene file, or the name of a built-in scene.
    pub scene: PathBuf,
    /// Overrides that all runs have, as `KEY=VALUE`.
    pub set: Vec<String>,
    /// The axes, the slowest first.
    pub axes: Vec<Axis>,
    /// The axes of seeds, crossed with everything.
    pub seeds: Vec<Axis>,
    /// Most core-hours that the sweep may take.
    pub core_hours: Option<f64>,
    /// What is observed in each run, with the places in the file.
    pub observations: Vec<Spanned<Observation>>,
    /// Whether runs whose balance cannot be trusted are observed, too.
    pub observe_untrusted: bool,
}

/// The values of a key, or of several keys that change together.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Its name in tables.
    pub name: String,
    /// The dotted keys.
    pub keys: Vec<String>,
    /// The values as TOML, of all keys at each place of the axis.
    pub values: Vec<Vec<String>>,
    /// Names of the places in tables.
    pub labels: Vec<String>,
    /// Unit of the labels on figures; empty if there is none.
    pub unit: String,
}

impl Axis {
    /// The overrides at a place, as `KEY=VALUE`.
    pub fn overrides(&self, place: usize) -> impl Iterator<Item = String> {
        let pairs = self.keys.iter().zip(&self.values[place]);
        pairs.map(|(key, value)| format!("{key}={value}"))
    }
}

/// The keys of a sweep file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    scene: String,
    #[serde(default)]
    set: Vec<String>,
    #[serde(default)]
    axis: Vec<Spanned<AxisKeys>>,
    #[serde(default)]
    seeds: BTreeMap<String, Spanned<Value>>,
    #[serde(default)]
    budget: Budget,
    #[serde(default)]
    observe: Vec<Spanned<Observation>>,
    #[serde(default)]
    observe_untrusted: bool,
}

/// `[[axis]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AxisKeys {
    key: Option<String>,
    keys: Option<Vec<String>>,
    name: Option<String>,
    values: Vec<Value>,
    labels: Option<Vec<String>>,
    times: Option<f64>,
    unit: Option<String>,
}

/// `[budget]`.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Budget {
    core_hours: Option<Spanned<f64>>,
}

impl Sweep {
    /// Read a sweep file.
    ///
    /// # Errors
    /// A file that cannot be read, or a mistake in it: file, line, key, value and what is accepted.
    pub fn load(path: &Path) -> Result<Self, Error> {
        let file = path.display().to_string();
        let text = read_text(path)?;
        let place = Place {
            file: &file,
            text: &text,
        };
        let keys: Keys = place.keys()?;
        let axes: Vec<Axis> = keys
            .axis
            .iter()
            .map(|axis| place.axis(axis))
            .collect::<Result<_, _>>()?;
        let seeds: Vec<Axis> = keys
            .seeds
            .iter()
            .map(|(name, value)| place.seed_axis(name, value))
            .collect::<Result<_, _>>()?;
        let mut known: Vec<&str> = Vec::new();
        for (axis, span) in axes.iter().zip(keys.axis.iter().map(Spanned::span)) {
            for key in &axis.keys {
                if let Some(other) = known.iter().find(|other| overlap(key, other)) {
                    let accepted = format!("must not change {other}, which an axis has already");
                    return Err(place.error(span.clone(), "axis.key", &accepted).into());
                }
                known.push(key);
            }
        }
        for observation in &keys.observe {
            if let Err((key, accepted)) = observation.get_ref().check() {
                let key = format!("observe.{key}");
                return Err(place.error(observation.span(), &key, &accepted).into());
            }
        }
        place.refuse_same_columns(&keys, &axes, &seeds)?;
        Ok(Self {
            scene: scene_beside(path, &keys.scene),
            set: keys.set,
            axes,
            seeds,
            core_hours: place.core_hours(keys.budget.core_hours.as_ref())?,
            observations: keys.observe,
            observe_untrusted: keys.observe_untrusted,
            file,
            text,
        })
    }

    /// Check a cost against the budget.
    ///
    /// # Errors
    /// A cost above the budget.
    pub fn within_budget(&self, cost: Cost) -> Result<(), Error> {
        match self.core_hours {
            Some(most) if cost.core_hours > most => Err(Error::Argument(format!(
                "{}: budget.core_hours = {most:?}: the runs that are not done yet would take about {:.3} core-hours",
                self.file, cost.core_hours
            ))),
            _ => Ok(()),
        }
    }

    /// All axes, those of seeds last.
    pub fn all_axes(&self) -> impl Iterator<Item = &Axis> {
        self.axes.iter().chain(&self.seeds)
    }
}

impl Place<'_> {
    /// Refuse two columns of the table of runs with the same name.
    fn refuse_same_columns(
        &self,
        keys: &Keys,
        axes: &[Axis],
        seeds: &[Axis],
    ) -> Result<(), SceneError> {
        let axes = axes.iter().zip(keys.axis.iter().map(Spanned::span));
        let axes = axes.map(|(axis, span)| (axis.name.clone(), span, "axis.name".to_owned()));
        let seeds = seeds.iter().zip(&keys.seeds);
        let seeds = seeds.map(|(axis, (name, value))| {
            (axis.name.clone(), value.span(), format!("seeds.{name}"))
        });
        let observed = keys.observe.iter();
        let observed =
            observed.map(|one| (one.get_ref().name(), one.span(), "observe.name".to_owned()));
        let mut seen: Vec<String> = [RUN]
            .iter()
            .chain(&STATE)
            .chain(&COST)
            .map(|&one| one.to_owned())
            .collect();
        for (name, span, key) in axes.chain(seeds).chain(observed) {
            if seen.contains(&name) {
                let accepted =
                    format!("must be unique, but runs.csv has another column {name} already");
                return Err(self.error(span, &key, &accepted));
            }
            seen.push(name);
        }
        Ok(())
    }

    fn axis(&self, axis: &Spanned<AxisKeys>) -> Result<Axis, SceneError> {
        let refusal =
            |key: &str, accepted: &str| self.error(axis.span(), &format!("axis.{key}"), accepted);
        let table = axis.get_ref();
        if table.values.is_empty() {
            return Err(refusal("values", "must hold at least one value"));
        }
        let (name, keys, values) = match (&table.key, &table.keys) {
            (Some(key), None) => {
                let values = table.values.iter().map(|value| vec![value.clone()]);
                (key, vec![key.clone()], values.collect())
            }
            (None, Some(keys)) if !keys.is_empty() => {
                let name = table
                    .name
                    .as_ref()
                    .ok_or_else(|| refusal("name", "missing; an axis of several keys needs one"))?;
                (
                    name,
                    keys.clone(),
                    together(&table.values, keys.len())
                        .map_err(|accepted| refusal("values", &accepted))?,
                )
            }
            _ => return Err(refusal("key", "must have either key, or keys with name")),
        };
        let scaled = |value: &Value| match table.times {
            None => Ok(value.clone()),
            Some(factor) => number(value)
                .map(|number| Value::Float(number * factor))
                .ok_or_else(|| refusal("times", "needs values that are numbers")),
        };
        let scaled = |values: &Vec<Value>| {
            values
                .iter()
                .map(|value| Ok(inline(&scaled(value)?)))
                .collect()
        };
        let labels =
            labels(table, values.len()).map_err(|accepted| refusal("labels", &accepted))?;
        Ok(Axis {
            name: table.name.as_ref().unwrap_or(name).clone(),
            keys,
            values: values.iter().map(scaled).collect::<Result<_, _>>()?,
            labels,
            unit: table.unit.clone().unwrap_or_default(),
        })
    }

    /// An axis of seeds; `setup` stands for `setup.seed`.
    fn seed_axis(&self, name: &str, value: &Spanned<Value>) -> Result<Axis, SceneError> {
        let seeds = self.seeds(&format!("seeds.{name}"), value)?;
        let labels: Vec<String> = seeds.iter().map(u64::to_string).collect();
        let key = match name {
            "setup" => "setup.seed",
            other => other,
        };
        Ok(Axis {
            name: key.to_owned(),
            keys: vec![key.to_owned()],
            values: labels.iter().map(|label| vec![label.clone()]).collect(),
            labels,
            unit: String::new(),
        })
    }
}

/// The names of the places of an axis.
///
/// # Errors
/// What is accepted.
fn labels(axis: &AxisKeys, number: usize) -> Result<Vec<String>, String> {
    let Some(labels) = &axis.labels else {
        return Ok(axis.values.iter().map(inline).collect());
    };
    if labels.len() != number {
        return Err(format!(
            "must hold one name for each of the {number} values"
        ));
    }
    match twin(labels) {
        Some(label) => Err(format!("must be unique, but {label:?} is there twice")),
        None => Ok(labels.clone()),
    }
}

/// The first text that occurs twice.
fn twin(texts: &[String]) -> Option<&String> {
    let mut seen = HashSet::new();
    texts.iter().find(|text| !seen.insert(text.as_str()))
}

/// Whether two dotted keys are the same, or one lies within the other.
fn overlap(one: &str, other: &str) -> bool {
    let is_within = |inner: &str, outer: &str| {
        let rest = inner.strip_prefix(outer);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    is_within(one, other) || is_within(other, one)
}

/// The values of several keys at each place of an axis.
fn together(values: &[Value], keys: usize) -> Result<Vec<Vec<Value>>, String> {
    let of_all = |value: &Value| value.as_array().filter(|list| list.len() == keys).cloned();
    let values: Option<_> = values.iter().map(of_all).collect();
    values.ok_or_else(|| format!("must hold arrays of {keys} values, one for each of the keys"))
}
