//! Motion of single bodies and of small groups.

mod groups;
mod impacts;
mod rolling;
mod slopes;

use crate::checks::Check;

pub fn checks() -> Vec<Check> {
    let parts = [
        slopes::checks(),
        impacts::checks(),
        rolling::checks(),
        groups::checks(),
    ];
    parts.into_iter().flatten().collect()
}
