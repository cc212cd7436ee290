//! Single contact points with restitution.

use crate::{id, items, number, numbers};
use gouge_contact_dynamics::local::{ExactRule, LocalProblem, LocalRule};
use serde_json::{Map, Value, json};

pub fn results(cases: &Value) -> Map<String, Value> {
    items(cases, "problems")
        .map(|case| (id(case), solve(case)))
        .collect()
}

fn solve(case: &Value) -> Value {
    let [w_nn, w_tt, w_nt] = ["W_nn", "W_tt", "W_nt"].map(|key| number(case, key));
    let (free, before) = (numbers(&case["u_free"]), numbers(&case["u_minus"]));
    let restitution = ["e_n", "e_t"].map(|key| number(case, key));
    let problem = LocalProblem {
        w_nn,
        w_tt,
        w_nt,
        a_n: -(free[0] + restitution[0] * before[0]),
        a_t: -(free[1] + restitution[1] * before[1]),
        friction: number(case, "mu"),
    };
    let solution = ExactRule.solve(&problem);
    if !solution.status.is_unique() {
        return json!({"error": format!("{:?}", solution.status)});
    }
    let p = solution.impulse;
    let after = [
        free[0] + w_nn * p.n + w_nt * p.t,
        free[1] + w_nt * p.n + w_tt * p.t,
    ];
    json!({"P": [p.n, p.t], "u_plus": after})
}
