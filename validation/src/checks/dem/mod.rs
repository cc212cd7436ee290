//! The checks of the thesis's model.

mod beams;
mod benchmarks;
mod calibration;
mod closure;
mod economy;
mod estimators;
mod extremes;
mod identities;
mod laws;
mod order;
mod pairs;
mod references;
mod remembered;
pub mod scenes;
mod strength;
mod time_step;
pub mod work_precision;

use super::Topic;

/// Its topics, in the order of the report: first what others computed.
pub fn topics() -> Vec<Topic> {
    vec![
        references::topic(),
        benchmarks::topic(),
        identities::topic(),
        laws::topic(),
        pairs::topic(),
        calibration::topic(),
        beams::topic(),
        strength::topic(),
        time_step::topic(),
        order::topic(),
        closure::topic(),
        extremes::topic(),
        estimators::topic(),
        economy::topic(),
        work_precision::topic(),
    ]
}
