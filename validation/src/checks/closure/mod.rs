//! The energy balance, momentum and angular momentum.

mod convergence;
mod momentum;
mod terms;

use super::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "closure",
        title: "Closure",
        about: "The energy balance (72) with each of its terms, and the momenta that nothing may change.",
        checks: [terms::checks(), convergence::checks(), momentum::checks()]
            .into_iter()
            .flatten()
            .collect(),
    }
}
