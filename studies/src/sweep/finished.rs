//! A finished run, whose files are read only once however much is observed in it.

use crate::columns::Columns;
use crate::decay::Decay;
use crate::final_state::FinalState;
use gouge_runner::contact_dynamics::Means;
use gouge_runner::run::Summary;
use gouge_runner::scene::Scene;
use std::cell::{OnceCell, RefCell};
use std::path::Path;

/// A finished run.
pub struct Finished<'a> {
    /// Its folder.
    pub folder: &'a Path,
    /// Its summary.
    pub summary: &'a Summary,
    read_scene: &'a dyn Fn() -> Option<Scene>,
    scene: OnceCell<Option<Scene>>,
    series: OnceCell<Option<Columns>>,
    decay: OnceCell<Option<Decay>>,
    final_state: OnceCell<Option<FinalState>>,
    /// Means over contact networks, by the time in s after which samples count.
    networks: RefCell<Vec<(f64, Option<Means>)>>,
}

impl<'a> Finished<'a> {
    /// A run with its folder, its summary, and what reads its scene.
    pub fn new(
        folder: &'a Path,
        summary: &'a Summary,
        read_scene: &'a dyn Fn() -> Option<Scene>,
    ) -> Self {
        Self {
            folder,
            summary,
            read_scene,
            scene: OnceCell::new(),
            series: OnceCell::new(),
            decay: OnceCell::new(),
            final_state: OnceCell::new(),
            networks: RefCell::default(),
        }
    }

    /// Its scene.
    pub(super) fn scene(&self) -> Option<&Scene> {
        self.scene.get_or_init(self.read_scene).as_ref()
    }

    /// Its series; none if there is no readable one.
    pub(super) fn series(&self) -> Option<&Columns> {
        let read = || Columns::of_series(self.folder);
        self.series.get_or_init(read).as_ref()
    }

    /// The fit of thesis (100) to its friction.
    pub(super) fn decay(&self) -> Option<&Decay> {
        let fit = || {
            let series = self.series()?;
            Decay::fit(series.get("time")?, series.get("friction_load")?)
        };
        self.decay.get_or_init(fit).as_ref()
    }

    /// A mean over its contact networks after a time in s.
    pub(super) fn network(&self, after: f64, name: &str) -> Option<f64> {
        let mut known = self.networks.borrow_mut();
        if !known.iter().any(|(time, _)| *time == after) {
            known.push((after, Means::between(self.folder, after, f64::INFINITY)));
        }
        let means = known.iter().find(|(time, _)| *time == after);
        means.and_then(|(_, means)| means.as_ref()?.get(name))
    }

    /// Fragments and cracks at its end.
    pub(super) fn final_state(&self) -> Option<&FinalState> {
        let read = || FinalState::read(self.folder, self.scene()?.domain.period()?);
        self.final_state.get_or_init(read).as_ref()
    }
}
