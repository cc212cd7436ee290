//! What the scenes of all models have in common.

use super::{Keys, Place, Scene};
use std::path::PathBuf;

/// A scene of any model, as its outputs see it.
pub trait SceneText {
    /// All files that were read.
    fn files(&self) -> &[PathBuf];

    /// All keys with their values.
    fn keys(&self) -> &Keys;

    /// End time in s.
    fn end(&self) -> f64;

    /// Everything that affects the bits of a run of this scene until an end time in s, as text.
    fn content_until(&self, end: f64) -> String;

    /// The time between samples in s and the keys that name it, unless the scene gives one itself.
    fn default_interval(&mut self) -> Option<(&mut f64, &mut Keys)>;
}

impl SceneText for Scene {
    fn files(&self) -> &[PathBuf] {
        &self.files
    }
    fn keys(&self) -> &Keys {
        &self.keys
    }
    fn end(&self) -> f64 {
        self.end
    }
    fn content_until(&self, end: f64) -> String {
        let mut anonymous = Self {
            end,
            file: String::new(),
            files: Vec::new(),
            title: String::new(),
            sha256: String::new(),
            keys: Keys::default(),
            laws: toml::Table::new(),
            has_default_interval: false,
            ..self.clone()
        };
        let nowhere = Place {
            file: String::new(),
            line: 0,
            key: String::new(),
        };
        if let Some(start) = &mut anonymous.start {
            start.path = PathBuf::new();
            start.refusal = nowhere.error(String::new(), String::new());
        }
        let bonds = anonymous.bonds.iter_mut().map(|(_, place)| place);
        let contacts = anonymous.contacts.iter_mut().map(|(_, place)| place);
        bonds
            .chain(contacts)
            .for_each(|place| place.clone_from(&nowhere));
        format!("{anonymous:?}")
    }
    fn default_interval(&mut self) -> Option<(&mut f64, &mut Keys)> {
        let own = (&mut self.output.interval, &mut self.keys);
        self.has_default_interval.then_some(own)
    }
}
