//! The keys of calibration files; `docs/calibration.md` has their meanings.

use super::closed_form::ClosedForm;
use super::emulator::Form;
use crate::sweep::{Quantity, Statistic};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::{Spanned, Value};

/// The keys of a calibration file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileKeys {
    pub title: Option<String>,
    #[serde(default)]
    pub notes: Vec<String>,
    #[serde(default)]
    pub parameter: Vec<Spanned<ParameterKeys>>,
    #[serde(default)]
    pub test: Vec<Spanned<TestKeys>>,
    #[serde(default)]
    pub target: Vec<Spanned<TargetKeys>>,
    pub design: Option<Spanned<DesignKeys>>,
    #[serde(default)]
    pub budget: Budget,
}

/// `[[parameter]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterKeys {
    pub name: Option<String>,
    pub key: KeysValue,
    pub range: [f64; 2],
    pub scale: Option<ScaleName>,
    pub unit: Option<String>,
}

/// A key, a list of keys, or a table from tests to either.
#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "must be a key, a list of keys, or a table from tests to either"
)]
pub enum KeysValue {
    One(String),
    List(Vec<String>),
    Tests(BTreeMap<String, OneOrMore>),
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "must be a key or a list of keys")]
pub enum OneOrMore {
    One(String),
    List(Vec<String>),
}

#[derive(Clone, Copy, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum ScaleName {
    Log,
    Linear,
}

/// `[[test]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TestKeys {
    pub name: String,
    pub scene: String,
    #[serde(default)]
    pub set: Vec<String>,
    pub seeds: Option<Spanned<Value>>,
    #[serde(default)]
    pub observe: Vec<Spanned<ObserveKeys>>,
}

/// `[[test.observe]]`: the keys of an observation of a sweep, and how it is emulated.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ObserveKeys {
    pub name: Option<String>,
    pub quantity: Option<Quantity>,
    pub column: Option<String>,
    pub statistic: Option<Statistic>,
    pub network: Option<String>,
    pub against: Option<String>,
    pub range: Option<[f64; 2]>,
    pub level: Option<f64>,
    #[serde(default)]
    pub after: f64,
    pub times: Option<f64>,
    pub unit: Option<String>,
    #[serde(default)]
    pub form: Form,
    pub closed_form: Option<ClosedForm>,
}

/// `[[target]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TargetKeys {
    pub test: Option<String>,
    pub quantity: String,
    pub value: Option<f64>,
    pub sd: f64,
    #[serde(default = "one")]
    pub specimens: u32,
    pub source: Option<String>,
    #[serde(default)]
    pub verified: bool,
}

pub fn one() -> u32 {
    1
}

/// `[design]`.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DesignKeys {
    pub points: Option<u32>,
    pub waves: Option<usize>,
    pub predictive: Option<usize>,
    pub repetitions: Option<u32>,
}

/// `[budget]`.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Budget {
    pub core_hours: Option<Spanned<f64>>,
    pub runs: Option<usize>,
}
