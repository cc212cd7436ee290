//! Calibration files, read and checked.

use super::calibration::{Calibration, Design, Observed, Target, Test};
use super::file_keys::{
    DesignKeys, FileKeys, KeysValue, ObserveKeys, OneOrMore, ParameterKeys, ScaleName, TargetKeys,
    TestKeys,
};
use super::parameter::{Keys, Parameter, Scale};
use crate::sweep::Observation;
use crate::text::{Place, read_text, scene_beside};
use gouge_runner::error::{Error, SceneError};
use std::ops::{Range, RangeInclusive};
use std::path::Path;
use toml::Spanned;

/// Accepted numbers of points.
const POINTS: Range<u32> = 4..4097;

/// Accepted sizes of measurements and of their standard deviations, whose squares and ratios are numbers, too.
const SIZES: RangeInclusive<f64> = 1e-60..=1e60;
/// Least width of a range, as a part of its larger end: values are written with six digits.
const NARROWEST: f64 = 1e-3;

/// What is accepted instead of a range; none if it can be used.
fn range_problem([low, high]: [f64; 2], scale: Scale) -> Option<&'static str> {
    let width = match scale {
        Scale::Log => high / low,
        Scale::Linear => high - low,
    };
    let is_narrow = high - low < NARROWEST * low.abs().max(high.abs());
    if !(low.is_finite() && high.is_finite() && low < high) {
        Some("must be two finite numbers, the smaller one first")
    } else if !width.is_finite() {
        Some(
            "must be narrower: the difference of the ends, with a logarithmic scale their ratio, is no number",
        )
    } else if is_narrow {
        Some("must be wider than a thousandth of the larger end")
    } else {
        None
    }
}

impl Calibration {
    /// Read a calibration file.
    ///
    /// # Errors
    /// A file that cannot be read, or a mistake in it: file, line, key, value and what is accepted.
    pub fn load(path: &Path) -> Result<Self, Error> {
        Ok(Self::parse(&path.display().to_string(), &read_text(path)?)?)
    }

    /// Read the text of a calibration file.
    ///
    /// # Errors
    /// A mistake in it: file, line, key, value and what is accepted.
    pub fn parse(file: &str, text: &str) -> Result<Self, SceneError> {
        let place = Place { file, text };
        let keys: FileKeys = place.keys()?;
        let tests: Vec<Test> = keys
            .test
            .iter()
            .map(|test| place.test(test))
            .collect::<Result<_, _>>()?;
        let names: Vec<&str> = tests.iter().map(|test| test.name.as_str()).collect();
        let parameters = keys
            .parameter
            .iter()
            .map(|parameter| place.parameter(parameter, &names))
            .collect::<Result<Vec<_>, _>>()?;
        place.refuse_repetitions(&keys, &names, &parameters)?;
        let targets = keys
            .target
            .iter()
            .map(|target| place.target(target, &tests))
            .collect::<Result<Vec<_>, _>>()?;
        for (name, is_empty) in [
            ("parameter", parameters.is_empty()),
            ("test", tests.is_empty()),
            ("target", targets.is_empty()),
        ] {
            if is_empty {
                let accepted = format!("needs at least one [[{name}]]");
                return Err(place.error(0..0, "", &accepted));
            }
        }
        let calibration = Self {
            title: keys.title.clone().unwrap_or_else(|| file.to_owned()),
            notes: keys.notes.clone(),
            file: file.to_owned(),
            design: place.design(keys.design.as_ref())?,
            parameters,
            tests,
            targets,
            core_hours: place.core_hours(keys.budget.core_hours.as_ref())?,
            runs: keys.budget.runs,
        };
        place.check_scenes(&keys, &calibration)?;
        Ok(calibration)
    }
}

impl Place<'_> {
    /// Refuse tests and parameters of the same name, and a key that takes the values of two parameters.
    fn refuse_repetitions(
        &self,
        keys: &FileKeys,
        tests: &[&str],
        parameters: &[Parameter],
    ) -> Result<(), SceneError> {
        let spans = keys.test.iter().map(Spanned::span);
        self.refuse_twins("test.name", tests, spans)?;
        let spans = || keys.parameter.iter().map(Spanned::span);
        let names: Vec<&str> = parameters.iter().map(|one| one.name.as_str()).collect();
        self.refuse_twins("parameter.name", &names, spans())?;
        for test in tests {
            let pairs = parameters.iter().zip(spans()).flat_map(|(one, span)| {
                let keys = one.keys_in(test).iter();
                keys.map(move |key| (key.as_str(), span.clone()))
            });
            let (keys, spans): (Vec<&str>, Vec<Range<usize>>) = pairs.unzip();
            self.refuse_twins("parameter.key", &keys, spans.into_iter())?;
        }
        Ok(())
    }

    /// Refuse a text that occurs twice.
    fn refuse_twins(
        &self,
        key: &str,
        texts: &[&str],
        spans: impl Iterator<Item = Range<usize>>,
    ) -> Result<(), SceneError> {
        let mut pairs = texts.iter().zip(spans).enumerate();
        match pairs.find(|(place, (text, _))| texts[..*place].contains(text)) {
            None => Ok(()),
            Some((_, (text, span))) => {
                let accepted = format!("must be given once, but {text} is there before");
                Err(self.error(span, key, &accepted))
            }
        }
    }

    fn parameter(
        &self,
        spanned: &Spanned<ParameterKeys>,
        tests: &[&str],
    ) -> Result<Parameter, SceneError> {
        let keys = spanned.get_ref();
        let refusal = |key: &str, accepted: &str| {
            Err(self.error(spanned.span(), &format!("parameter.{key}"), accepted))
        };
        let [low, _] = keys.range;
        let scale = match keys.scale {
            Some(ScaleName::Linear) => Scale::Linear,
            Some(ScaleName::Log) if low <= 0.0 => {
                return refusal("scale", "a logarithmic scale needs a positive range");
            }
            None if low <= 0.0 => Scale::Linear,
            _ => Scale::Log,
        };
        if let Some(accepted) = range_problem(keys.range, scale) {
            return refusal("range", accepted);
        }
        let keys_of = match &keys.key {
            KeysValue::One(key) => Keys::Same(vec![key.clone()]),
            KeysValue::List(list) => Keys::Same(list.clone()),
            KeysValue::Tests(map) => {
                if let Some(name) = map.keys().find(|name| !tests.contains(&name.as_str())) {
                    let accepted = format!("{name} is no test; those are {}", tests.join(", "));
                    return refusal("key", &accepted);
                }
                let list = |one: &OneOrMore| match one {
                    OneOrMore::One(key) => vec![key.clone()],
                    OneOrMore::List(list) => list.clone(),
                };
                Keys::Each(
                    map.iter()
                        .map(|(test, one)| (test.clone(), list(one)))
                        .collect(),
                )
            }
        };
        let first = tests.iter().find_map(|_| match &keys_of {
            Keys::Same(list) => list.first(),
            Keys::Each(map) => map.values().flatten().next(),
        });
        let Some(first) = first else {
            return refusal("key", "must name at least one key");
        };
        let last_name = first.rsplit('.').next().unwrap_or(first);
        Ok(Parameter {
            name: keys.name.clone().unwrap_or_else(|| last_name.to_owned()),
            range: keys.range,
            scale,
            unit: keys.unit.clone().unwrap_or_default(),
            keys: keys_of,
        })
    }

    fn test(&self, spanned: &Spanned<TestKeys>) -> Result<Test, SceneError> {
        let keys = spanned.get_ref();
        let seeds = keys.seeds.as_ref();
        let observed: Vec<Observed> = keys
            .observe
            .iter()
            .map(|one| self.observed(one))
            .collect::<Result<_, _>>()?;
        if observed.is_empty() {
            let accepted = "needs at least one [[test.observe]]";
            return Err(self.error(spanned.span(), "test.observe", accepted));
        }
        let names: Vec<String> = observed.iter().map(|one| one.observation.name()).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let spans = keys.observe.iter().map(Spanned::span);
        self.refuse_twins("test.observe.name", &names, spans)?;
        Ok(Test {
            name: keys.name.clone(),
            scene: scene_beside(Path::new(self.file), &keys.scene),
            set: keys.set.clone(),
            seeds: match seeds {
                Some(seeds) => self.seeds("test.seeds", seeds)?,
                None => Vec::new(),
            },
            observed,
        })
    }

    fn observed(&self, spanned: &Spanned<ObserveKeys>) -> Result<Observed, SceneError> {
        let keys = spanned.get_ref();
        let observation = Observation {
            network: keys.network.clone(),
            name: keys.name.clone(),
            quantity: keys.quantity,
            column: keys.column.clone(),
            statistic: keys.statistic,
            against: keys.against.clone(),
            range: keys.range,
            level: keys.level,
            after: keys.after,
            times: keys.times,
            unit: keys.unit.clone(),
        };
        match observation.check() {
            Ok(()) => Ok(Observed {
                observation,
                form: keys.form,
                closed_form: keys.closed_form,
            }),
            Err((key, accepted)) => {
                let key = format!("test.observe.{key}");
                Err(self.error(spanned.span(), &key, &accepted))
            }
        }
    }

    fn target(&self, spanned: &Spanned<TargetKeys>, tests: &[Test]) -> Result<Target, SceneError> {
        let keys = spanned.get_ref();
        let refusal = |key: &str, accepted: &str| {
            Err(self.error(spanned.span(), &format!("target.{key}"), accepted))
        };
        let test = match &keys.test {
            None if tests.len() == 1 => Some(0),
            None => None,
            Some(name) => tests.iter().position(|test| test.name == *name),
        };
        let Some(test) = test else {
            let names: Vec<&str> = tests.iter().map(|test| test.name.as_str()).collect();
            return refusal("test", &format!("must be one of {}", names.join(", ")));
        };
        let names: Vec<String> = tests[test]
            .observed
            .iter()
            .map(|one| one.observation.name())
            .collect();
        let Some(quantity) = names.iter().position(|name| *name == keys.quantity) else {
            return refusal("quantity", &format!("must be one of {}", names.join(", ")));
        };
        if !(keys.sd > 0.0 && SIZES.contains(&keys.sd)) {
            let accepted = format!(
                "must be a positive number, from {:e} to {:e}: no measurement is exact",
                SIZES.start(),
                SIZES.end()
            );
            return refusal("sd", &accepted);
        }
        let is_absurd = |value: f64| !(value == 0.0 || SIZES.contains(&value.abs()));
        if keys.value.is_some_and(is_absurd) {
            let accepted = format!(
                "must be zero, or a number of a size from {:e} to {:e}",
                SIZES.start(),
                SIZES.end()
            );
            return refusal("value", &accepted);
        }
        if keys.specimens == 0 {
            return refusal("specimens", "must be at least 1");
        }
        let source = keys.source.as_deref().unwrap_or_default().trim();
        if keys.value.is_some() && source.is_empty() {
            return refusal("source", "must name who measured the value");
        }
        Ok(Target {
            test,
            quantity,
            value: keys.value,
            deviation: keys.sd,
            specimens: f64::from(keys.specimens),
            source: source.to_owned(),
            is_verified: keys.verified,
        })
    }

    fn design(&self, keys: Option<&Spanned<DesignKeys>>) -> Result<Design, SceneError> {
        let span = keys.map_or(0..0, Spanned::span);
        let none = DesignKeys::default();
        let keys = keys.map_or(&none, Spanned::get_ref);
        let design = Design {
            points: keys.points.unwrap_or(32),
            waves: keys.waves.unwrap_or(2),
            predictive: keys.predictive.unwrap_or(4),
            repetitions: keys.repetitions.unwrap_or(100),
        };
        if !POINTS.contains(&design.points) {
            let accepted = format!("must be from {} to {}", POINTS.start, POINTS.end - 1);
            return Err(self.error(span, "design.points", &accepted));
        }
        let bounded = [
            ("design.waves", design.waves, 1..101),
            ("design.predictive", design.predictive, 0..4097),
            (
                "design.repetitions",
                design.repetitions as usize,
                1..100_001,
            ),
        ];
        for (key, number, accepted) in bounded {
            if !accepted.contains(&number) {
                let accepted = format!("must be from {} to {}", accepted.start, accepted.end - 1);
                return Err(self.error(span, key, &accepted));
            }
        }
        Ok(design)
    }
}
