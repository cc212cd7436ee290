//! Checks of a calibration file against its scenes, before anything is run.

use super::calibration::{Calibration, Test};
use super::file_keys::{FileKeys, TestKeys};
use super::sobol;
use crate::text::Place;
use gouge_runner::any_scene::AnyScene;
use gouge_runner::error::{Error, SceneError};
use gouge_runner::scene::Overrides;
use toml::Spanned;

/// Most points of the ranges at which a scene is tried.
const MOST_TRIED: u32 = 64;

impl Place<'_> {
    /// Check that the scene of each test accepts some values of the parameters, and can have what is observed.
    pub(super) fn check_scenes(
        &self,
        keys: &FileKeys,
        calibration: &Calibration,
    ) -> Result<(), SceneError> {
        for (test, spanned) in calibration.tests.iter().zip(&keys.test) {
            let scene = usable_scene(calibration, test)
                .map_err(|error| self.scene_error(keys, calibration, (test, spanned), &error))?;
            for (one, place) in test.observed.iter().zip(&spanned.get_ref().observe) {
                let refusal = |key: &str, accepted: &str| {
                    self.error(place.span(), &format!("test.observe.{key}"), accepted)
                };
                let checked = one.observation.check_in(&scene);
                checked.map_err(|(key, accepted)| refusal(key, &accepted))?;
                if let Some(form) = one.closed_form {
                    let expected = calibration.expected(test, form);
                    expected.map_err(|reason| refusal("closed_form", &reason))?;
                }
            }
        }
        Ok(())
    }

    /// The error of a scene as one of the key that causes it: of a parameter, of an override, of seeds, or of the scene.
    fn scene_error(
        &self,
        keys: &FileKeys,
        calibration: &Calibration,
        (test, spanned): (&Test, &Spanned<TestKeys>),
        error: &Error,
    ) -> SceneError {
        let reason = error.to_string();
        let is_of = |set: &str| reason.starts_with(&format!("--set {set}"));
        let mut parameters = calibration.parameters.iter().zip(&keys.parameter);
        let parameter = parameters.find(|(parameter, _)| {
            let mut keys = parameter.keys_in(&test.name).iter();
            keys.any(|key| is_of(&format!("{key}=")))
        });
        let (span, key) = match parameter {
            Some((_, parameter)) => (parameter.span(), "parameter.key"),
            None if test.set.iter().any(|one| is_of(one)) => (spanned.span(), "test.set"),
            None if is_of("setup.seed=") => (spanned.span(), "test.seeds"),
            None => (spanned.span(), "test.scene"),
        };
        self.error(span, key, &reason)
    }
}

/// The scene of a test at the middle of the ranges or, if it refuses the values there, at the first point that it
/// accepts; what it says about the middle if it accepts none.
fn usable_scene(calibration: &Calibration, test: &Test) -> Result<AnyScene, Error> {
    let seed = test.seeds_at(0).first().copied().flatten();
    let load = |point: &[f64]| {
        let overrides = calibration.overrides(test, point, seed);
        AnyScene::load_with(&test.scene, &Overrides::parse(&overrides)?)
    };
    let dimensions = calibration.parameters.len();
    load(&vec![0.5; dimensions]).or_else(|error| {
        let number = calibration.design.points.min(MOST_TRIED);
        let mut points = sobol::points(number, dimensions, 0);
        points.find_map(|point| load(&point).ok()).ok_or(error)
    })
}
