//! Single contact points with restitution.

use super::Case;
use crate::error::Fault;
use gouge_contact_dynamics::local::{ExactRule, LocalProblem, LocalRule, LocalStatus};
use serde_json::{Value, json};

/// Impulse and velocity after it.
///
/// Beyond the limit of uniqueness the result says under `error` that there are several solutions or none; the first of
/// several is given.
pub fn solve(case: &Case) -> Result<Value, Fault> {
    let fields = &case.fields;
    let [w_nn, w_tt] = [fields.positive("W_nn")?, fields.positive("W_tt")?];
    let w_nt = fields.number("W_nt")?;
    let (free, before) = (fields.array::<2>("u_free")?, fields.array::<2>("u_minus")?);
    let restitution = [fields.number("e_n")?, fields.number("e_t")?];
    let problem = LocalProblem {
        w_nn,
        w_tt,
        w_nt,
        a_n: -(free[0] + restitution[0] * before[0]),
        a_t: -(free[1] + restitution[1] * before[1]),
        friction: fields.not_negative("mu")?,
    };
    let solution = ExactRule.solve(&problem);
    let p = solution.impulse;
    let after = [
        free[0] + w_nn * p.n + w_nt * p.t,
        free[1] + w_nt * p.n + w_tt * p.t,
    ];
    Ok(match solution.status {
        LocalStatus::NoSolution => json!({"error": "no impulse satisfies the laws"}),
        LocalStatus::SeveralSolutions => json!({
            "error": "several impulses satisfy the laws",
            "P": [p.n, p.t],
            "u_plus": after,
        }),
        _ => json!({"P": [p.n, p.t], "u_plus": after}),
    })
}
