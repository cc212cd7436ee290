//! A calibration, as its file states it.

use super::closed_form::ClosedForm;
use super::emulator::{Expected, Form};
use super::likelihood::Measured;
use super::parameter::Parameter;
use crate::sweep::{Observation, Planned};
use gouge_runner::error::Error;
use gouge_runner::scene::{Overrides, Scene};
use std::path::PathBuf;
use std::sync::Arc;

/// A calibration.
#[derive(Clone, Debug)]
pub struct Calibration {
    /// Its title.
    pub title: String,
    /// What a reader must know of its assumptions.
    pub notes: Vec<String>,
    /// Name of its file.
    pub file: String,
    /// What is sought.
    pub parameters: Vec<Parameter>,
    /// What is run.
    pub tests: Vec<Test>,
    /// What was measured.
    pub targets: Vec<Target>,
    /// Where runs are made.
    pub design: Design,
    /// Most core-hours of a wave that may be begun.
    pub core_hours: Option<f64>,
    /// Most runs.
    pub runs: Option<usize>,
}

/// A scene that is run at all points.
#[derive(Clone, Debug)]
pub struct Test {
    /// Its name.
    pub name: String,
    /// A scene file, or the name of a built-in scene.
    pub scene: PathBuf,
    /// Overrides of its keys, as `KEY=VALUE`.
    pub set: Vec<String>,
    /// Seeds; a scene without random numbers has none.
    pub seeds: Vec<u64>,
    /// What is observed.
    pub observed: Vec<Observed>,
}

/// A quantity of a test.
#[derive(Clone, Debug)]
pub struct Observed {
    /// How it is taken from a run.
    pub observation: Observation,
    /// In which form it is emulated.
    pub form: Form,
    /// An expression for it.
    pub closed_form: Option<ClosedForm>,
}

/// A measured quantity.
#[derive(Clone, Debug)]
pub struct Target {
    /// Place of its test.
    pub test: usize,
    /// Place of the quantity among those of the test.
    pub quantity: usize,
    /// The value; a target without one serves only the recovery of known truths.
    pub value: Option<f64>,
    /// Standard deviation of the measurement.
    pub deviation: f64,
    /// Number of specimens whose mean was measured.
    pub specimens: f64,
    /// Who measured it.
    pub source: String,
    /// Whether the value was checked against its source.
    pub is_verified: bool,
}

/// Where runs are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design {
    /// Points of a wave.
    pub points: u32,
    /// Number of waves.
    pub waves: usize,
    /// Points of the posterior at which the scenes are run in the end.
    pub predictive: usize,
    /// Repetitions of the recovery of known truths.
    pub repetitions: u32,
}

impl Calibration {
    /// Name of a target: that of its quantity, and of its test if there are several.
    pub fn target_name(&self, target: &Target) -> String {
        let test = &self.tests[target.test];
        let quantity = test.observed[target.quantity].observation.name();
        match self.tests.len() {
            1 => quantity,
            _ => format!("{} of {}", quantity, test.name),
        }
    }

    /// Unit of a target on figures; empty if there is none.
    pub fn target_unit(&self, target: &Target) -> &str {
        let test = &self.tests[target.test];
        test.observed[target.quantity].observation.unit()
    }

    /// The measurements.
    ///
    /// # Errors
    /// A target without a value.
    pub fn measured(&self) -> Result<Vec<Measured>, Error> {
        let one = |target: &Target| {
            let value = target.value.ok_or_else(|| {
                let name = self.target_name(target);
                let file = &self.file;
                Error::Argument(format!(
                    "{file}: nobody measured {name}: this calibration serves only --recover"
                ))
            })?;
            Ok(target.measured(value))
        };
        self.targets.iter().map(one).collect()
    }

    /// The calibration without the tests that only predict.
    pub fn with_targets_only(&self) -> Self {
        let is_measured = |place: &usize| self.targets.iter().any(|target| target.test == *place);
        let kept: Vec<usize> = (0..self.tests.len()).filter(is_measured).collect();
        let targets = self.targets.iter().map(|target| Target {
            test: kept.partition_point(|&place| place < target.test),
            ..target.clone()
        });
        Self {
            targets: targets.collect(),
            tests: kept
                .iter()
                .map(|&place| self.tests[place].clone())
                .collect(),
            ..self.clone()
        }
    }

    /// The point whose values are those written into scenes.
    pub fn rounded(&self, point: &[f64]) -> Vec<f64> {
        let pairs = self.parameters.iter().zip(point);
        let rounded = |(parameter, &place): (&Parameter, &f64)| {
            let written = parameter.written(place).parse();
            parameter.place(written.unwrap_or(f64::NAN))
        };
        pairs.map(rounded).collect()
    }

    /// The run of a test at a point.
    pub fn run(&self, test: &Test, point: &[f64], seed: Option<u64>) -> Planned {
        Planned::new(&test.scene, self.overrides(test, point, seed))
    }

    /// The overrides of a run, as `KEY=VALUE`.
    pub fn overrides(&self, test: &Test, point: &[f64], seed: Option<u64>) -> Vec<String> {
        let mut overrides = test.set.clone();
        for (parameter, &place) in self.parameters.iter().zip(point) {
            let value = parameter.written(place);
            let keys = parameter.keys_in(&test.name).iter();
            overrides.extend(keys.map(|key| format!("{key}={value}")));
        }
        overrides.extend(seed.map(|seed| format!("setup.seed={seed}")));
        overrides
    }

    /// The expression for a quantity as a function of the place in the unit cube.
    ///
    /// # Errors
    /// A scene that cannot be used or does not fit, or a parameter that the expression does not know.
    pub fn expected(&self, test: &Test, form: ClosedForm) -> Result<Expected, String> {
        let overrides = Overrides::parse(&test.set).map_err(|error| error.to_string())?;
        let scene = Scene::load_with(&test.scene, &overrides).map_err(|error| error.to_string())?;
        let keys = form.keys();
        let mut sources: [Option<usize>; 2] = [None; 2];
        for (place, parameter) in self.parameters.iter().enumerate() {
            for key in parameter.keys_in(&test.name) {
                let known = keys.iter().position(|known| known == key);
                let known = known.ok_or_else(|| {
                    format!(
                        "this closed form is for varying {} only, not {key}",
                        keys.join(" and ")
                    )
                })?;
                sources[known] = Some(place);
            }
        }
        let parameters = self.parameters.clone();
        let fixed = keys.map(|key| scene.keys.number(key).unwrap_or(f64::NAN));
        let expected = move |point: &[f64]| {
            let number = |k: usize| match sources[k] {
                Some(place) => parameters[place].value(point[place]),
                None => fixed[k],
            };
            form.value(&scene, [number(0), number(1)])
                .unwrap_or(f64::NAN)
        };
        match expected(&vec![0.5; self.parameters.len()]).is_finite() {
            true => Ok(Arc::new(expected)),
            false => Err("this closed form does not fit the scene".to_owned()),
        }
    }
}

impl Target {
    /// The target with a value.
    pub fn measured(&self, value: f64) -> Measured {
        Measured {
            value,
            deviation: self.deviation,
            specimens: self.specimens,
        }
    }
}

impl Test {
    /// The seeds of its runs at a point, given by its place among all points. No two points share a seed, so that what
    /// their packings deviate by is independent.
    pub fn seeds_at(&self, place: usize) -> Vec<Option<u64>> {
        let ends = self.seeds.iter().min().zip(self.seeds.iter().max());
        match ends {
            None => vec![None],
            Some((first, last)) => {
                let shift = place as u64 * (last - first + 1);
                self.seeds.iter().map(|seed| Some(seed + shift)).collect()
            }
        }
    }
}
