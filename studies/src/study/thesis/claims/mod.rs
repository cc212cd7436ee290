//! The claims of the thesis, each with a rule that was fixed before the runs.

mod blocks;
mod dissipation;
mod friction;
mod variants;

use crate::study::claim::Rule;

/// All rules.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    let rules = blocks::RULES.iter().chain(&friction::RULES);
    rules.chain(&dissipation::RULES).chain(&variants::RULES)
}
