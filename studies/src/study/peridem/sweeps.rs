//! The sweeps of the study.

use super::super::{Part, Scale};
use super::{CROSSES, CROSSES_FINE, KALTHOFF, NOTCH, PRINTED_NOTCH};

/// The parts of the study.
pub fn parts(scale: Scale) -> Vec<Part> {
    let fine = match scale {
        Scale::Small => "",
        Scale::Full => "FINE",
    };
    let kalthoff = KALTHOFF_SWEEP
        .replace("FINE_VALUE", if fine.is_empty() { "" } else { ", [0.5e-3, 2.0075e-3, 0.75e-3, 2.5e-8]" })
        .replace("FINE_LABEL", if fine.is_empty() { "" } else { ", \"0.5 mm, 4 h\"" });
    let part = |name, text: &str| Part::new(name, text, "");
    vec![
        part(KALTHOFF, &kalthoff),
        part(CROSSES, CROSSES_SWEEP),
        part(CROSSES_FINE, CROSSES_FINE_SWEEP),
        part(NOTCH, NOTCH_SWEEP),
        part(PRINTED_NOTCH, PRINTED_NOTCH_SWEEP),
    ]
}

const KALTHOFF_SWEEP: &str = r#"scene = "kalthoff-winkler"

[[axis]]
name = "grid"
keys = ["mesh.size", "bonds.horizon", "contact.radius", "time.step"]
values = [[1e-3, 4.015e-3, 1.5e-3, 5e-8], [1e-3, 3.015e-3, 1.5e-3, 5e-8]FINE_VALUE]
labels = ["1 mm, 4 h", "1 mm, 3 h"FINE_LABEL]

[[axis]]
name = "breaking"
key = "bonds.breaking"
values = ["tension-only", "two-sided"]

[[axis]]
name = "self contact"
key = "contact.self_contact"
values = [false, true]
labels = ["off", "on"]

[[observe]]
column = "crack_angle_0"
statistic = "last"
[[observe]]
column = "crack_angle_1"
statistic = "last"
[[observe]]
column = "crack_length_0"
statistic = "last"
[[observe]]
column = "crack_length_1"
statistic = "last"
[[observe]]
name = "length_at_80_us"
column = "crack_length_0"
statistic = "at-level"
of = "time"
level = 8e-5
[[observe]]
column = "broken_bonds"
statistic = "last"
"#;
