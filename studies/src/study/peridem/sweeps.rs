//! The sweeps of the study.

use super::super::{Part, Scale};
use super::{
    CROSSES, CROSSES_EARLY, CROSSES_FINE, CROSSES_FINE_EARLY, KALTHOFF, NOTCH, NOTCH_CONTACT,
    NOTCH_FINE, NOTCH_FRAMES, PRINTED_NOTCH,
};

/// The parts of the study.
pub fn parts(scale: Scale) -> Vec<Part> {
    let finer = |text: &str, value: &str, label: &str| {
        let [value, label] = match scale {
            Scale::Small => ["", ""],
            Scale::Full => [value, label],
        };
        text.replace("FINE_VALUE", value)
            .replace("FINE_LABEL", label)
    };
    let kalthoff = finer(
        KALTHOFF_SWEEP,
        ", [0.5e-3, 2.0075e-3, 0.75e-3, 2.5e-8]",
        ", \"0.5 mm, 4 h\"",
    );
    let notch_fine = finer(NOTCH_FINE_SWEEP, ", 0.1e-3", ", \"0.1 mm\"");
    // Runs of equal scenes count once: intervals keep the states of both series apart.
    let early = |sweep: &str, interval: &str| {
        CROSSES_EARLY_SWEEP
            .replace("AXIS", axis_of(sweep))
            .replace("INTERVAL", interval)
    };
    let part = |name, text: &str| Part::new(name, text, "");
    vec![
        part(KALTHOFF, &kalthoff),
        part(CROSSES, CROSSES_SWEEP),
        part(CROSSES_EARLY, &early(CROSSES_SWEEP, "2e-8")),
        part(CROSSES_FINE, CROSSES_FINE_SWEEP),
        part(CROSSES_FINE_EARLY, &early(CROSSES_FINE_SWEEP, "1e-8")),
        part(NOTCH, NOTCH_SWEEP),
        part(NOTCH_FRAMES, NOTCH_FRAMES_SWEEP),
        part(NOTCH_CONTACT, NOTCH_CONTACT_SWEEP),
        part(NOTCH_FINE, &notch_fine),
        part(PRINTED_NOTCH, PRINTED_NOTCH_SWEEP),
    ]
}

/// The axis of a sweep file with one axis, up to its observations.
fn axis_of(sweep: &str) -> &str {
    let start = sweep.find("[[axis]]").unwrap_or_default();
    let axis = &sweep[start..];
    &axis[..axis.find("[[observe]]").unwrap_or(axis.len())]
}

const KALTHOFF_SWEEP: &str = include_str!("kalthoff.toml");
const CROSSES_SWEEP: &str = include_str!("crosses.toml");
const CROSSES_EARLY_SWEEP: &str = include_str!("crosses-early.toml");
const CROSSES_FINE_SWEEP: &str = include_str!("crosses-spacing.toml");
const NOTCH_SWEEP: &str = include_str!("notch.toml");
const NOTCH_FRAMES_SWEEP: &str = include_str!("notch-frames.toml");
const NOTCH_CONTACT_SWEEP: &str = include_str!("notch-contact.toml");
const NOTCH_FINE_SWEEP: &str = include_str!("notch-fine.toml");
const PRINTED_NOTCH_SWEEP: &str = include_str!("notch-printed.toml");
