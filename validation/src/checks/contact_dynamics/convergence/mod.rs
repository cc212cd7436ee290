//! How results depend on sweeps, tolerances and steps.

mod column;
mod overlap;
mod schemes;
mod sound;
mod sweeps;

use crate::checks::Check;

pub fn checks() -> Vec<Check> {
    let parts = [
        sweeps::checks(),
        column::checks(),
        sound::checks(),
        schemes::checks(),
        overlap::checks(),
    ];
    parts.into_iter().flatten().collect()
}
