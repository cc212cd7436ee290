//! Whether a checkpoint belongs to a scene.

use crate::scene::{Keys, SceneText};
use sha2::{Digest, Sha256};

/// Most keys that an error message lists.
const MOST_KEYS: usize = 3;

/// Fingerprint of everything in a scene that affects the bits of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fingerprint(pub [u8; 32]);

/// How the scene of a checkpoint and another scene are related.
#[derive(Clone, Debug, PartialEq)]
pub enum Kinship {
    /// They are the same.
    Same,
    /// They are the same, except that the run of the checkpoint ends earlier, at this time in s.
    Shorter(f64),
    /// They differ in other ways, for this reason.
    Other(String),
}

impl Fingerprint {
    /// The fingerprint of a scene.
    pub fn of(scene: &impl SceneText) -> Self {
        Self::digest(&scene.content_until(scene.end()))
    }

    fn digest(content: &str) -> Self {
        let text = format!("{content} {}", env!("CARGO_PKG_VERSION"));
        Self(Sha256::digest(text.as_bytes()).into())
    }
}

impl Kinship {
    /// How a scene is related to that of a checkpoint with the given fingerprint and keys.
    pub fn of(scene: &impl SceneText, fingerprint: &[u8], keys: &Keys) -> Self {
        if fingerprint == Fingerprint::of(scene).0 {
            return Self::Same;
        }
        let end = keys.number("time.end").filter(|&end| end < scene.end());
        if let Some(end) = end {
            let shorter = Fingerprint::digest(&scene.content_until(end));
            if fingerprint == shorter.0 {
                return Self::Shorter(end);
            }
        }
        Self::Other(match keys.differences(scene.keys()).as_slice() {
            [] => "it belongs to another version of the program".to_owned(),
            all => {
                let (shown, rest) = all.split_at(all.len().min(MOST_KEYS));
                let more = match rest.len() {
                    0 => String::new(),
                    number => format!("; {number} more keys differ"),
                };
                format!("it belongs to another scene: {}{more}", shown.join(", "))
            }
        })
    }
}
