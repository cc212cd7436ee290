//! The sweeps of the study.

use super::super::{Part, Scale};
use super::{CROSSES, CROSSES_FINE, KALTHOFF, NOTCH, PRINTED_NOTCH};

/// The parts of the study.
pub fn parts(scale: Scale) -> Vec<Part> {
    let fine = match scale {
        Scale::Small => ["", ""],
        Scale::Full => [
            ", [0.5e-3, 2.0075e-3, 0.75e-3, 2.5e-8]",
            ", \"0.5 mm, 4 h\"",
        ],
    };
    let kalthoff = KALTHOFF_SWEEP
        .replace("FINE_VALUE", fine[0])
        .replace("FINE_LABEL", fine[1]);
    let part = |name, text: &str| Part::new(name, text, "");
    vec![
        part(KALTHOFF, &kalthoff),
        part(CROSSES, CROSSES_SWEEP),
        part(CROSSES_FINE, CROSSES_FINE_SWEEP),
        part(NOTCH, NOTCH_SWEEP),
        part(PRINTED_NOTCH, PRINTED_NOTCH_SWEEP),
    ]
}

const KALTHOFF_SWEEP: &str = include_str!("kalthoff.toml");
const CROSSES_SWEEP: &str = include_str!("crosses.toml");
const CROSSES_FINE_SWEEP: &str = include_str!("crosses-spacing.toml");
const NOTCH_SWEEP: &str = include_str!("notch.toml");
const PRINTED_NOTCH_SWEEP: &str = include_str!("notch-printed.toml");
