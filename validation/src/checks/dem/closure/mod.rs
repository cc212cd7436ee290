//! The energy balance.

mod events;
mod fields;
mod heat;
mod links;
mod many;
mod momenta;
mod printed;
mod residual;
mod spheres;
mod whole;

use crate::checks::Topic;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "closure",
        title: "Energy balance",
        about: "The energy balance (72): each term alone against an independent value, and the residual of their sum against the order of the method; momentum and angular momentum; and the errors of the printed estimators (76)-(79).",
        checks: [
            heat::checks(),
            fields::checks(),
            links::checks(),
            residual::checks(),
            events::checks(),
            momenta::checks(),
            printed::checks(),
            many::checks(),
            whole::checks(),
        ]
        .into_iter()
        .flatten()
        .collect(),
    }
}
