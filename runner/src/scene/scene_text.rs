//! What the scenes of all models have in common.

use super::Keys;
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
}
