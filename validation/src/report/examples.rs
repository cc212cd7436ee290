//! Results of checks that do not exist, for tests.

use super::{Entry, Record};
use crate::checks::{Check, Effort, Evidence, Measurement, Origin, thesis};

/// The record of a measurement.
pub fn record(id: &'static str, measurement: Measurement, origin: Origin) -> Record {
    citing(id, measurement, origin, Evidence::NONE)
}

/// The record of a check that covers some places in the thesis and passes.
pub fn covering(id: &'static str, places: &'static str) -> Record {
    citing(id, Measurement::count(0), Origin::Exact, thesis(places))
}

fn citing(
    id: &'static str,
    measurement: Measurement,
    origin: Origin,
    equations: Evidence,
) -> Record {
    let check = Check {
        id,
        claim: "A claim",
        equations,
        scene: "A scene",
        oracle: "An oracle",
        norm: "An error",
        origin,
        reason: "A reason",
        effort: Effort::Quick,
        measure: || Ok(Measurement::count(0).into()),
    };
    Record::new(&check, &Ok(measurement.into()), 0.5)
}

/// The entry of a record, without exhibits.
pub fn entry(record: Record) -> Entry {
    Entry {
        record,
        exhibits: Vec::new(),
    }
}
