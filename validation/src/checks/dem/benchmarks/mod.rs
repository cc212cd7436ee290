//! Community benchmarks: Chung and Ooi 1-8 and MFiX DEM01-06, in planar form.

mod chung_ooi_head_on;
mod chung_ooi_oblique;
mod chung_ooi_pairs;
mod literature;
mod mfix_bounce;
mod mfix_drag;
mod mfix_oblique;
mod mfix_slip;
mod mfix_stack;
mod plane;
mod sweep;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "benchmarks",
        title: "Community benchmarks",
        about: "Chung and Ooi's tests 1-8 and MFiX DEM01-06 in planar form, over whole curves.",
        checks: [
            chung_ooi_head_on::checks(),
            chung_ooi_oblique::checks(),
            chung_ooi_pairs::checks(),
            mfix_bounce::checks(),
            mfix_stack::checks(),
            mfix_slip::checks(),
            mfix_oblique::checks(),
            mfix_drag::checks(),
        ]
        .into_iter()
        .flatten()
        .collect(),
    }
}
