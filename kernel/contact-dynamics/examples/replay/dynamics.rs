//! Closed forms of motion, by whole steps.

use crate::motion::{Motion, disc, floor, polygon};
use crate::{id, items, number, numbers};
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::step::Scheme;
use serde_json::{Map, Value, json};

/// From the set-up of a case to its results.
type Solve = fn(&Value) -> Value;

const GRAVITY: f64 = 9.81;
const FLAT: f64 = core::f64::consts::FRAC_PI_4;

pub fn results(cases: &Value) -> Map<String, Value> {
    let solved = |case| Some((id(case), solve(case)?));
    items(cases, "cases").filter_map(solved).collect()
}

fn solve(case: &Value) -> Option<Value> {
    let name = id(case);
    let setup = &case["setup"];
    let kinds: [(&str, Solve); 10] = [
        ("incline-square", incline_square),
        ("incline-disc", incline_disc),
        ("block-stops", block_stops),
        ("disc-slide-roll", slide_roll),
        ("two-discs", two_discs),
        ("corner-drop", corner_drop),
        ("landing", landing),
        ("cradle-touching", cradle),
        ("gap-closes", gap_closes),
        ("square-pushed", square_pushed),
    ];
    let (_, solve) = kinds.iter().find(|(start, _)| name.starts_with(start))?;
    Some(solve(setup))
}

fn law(friction: f64, normal: f64, tangential: f64, gap: GapRule) -> ContactLaw {
    ContactLaw {
        friction,
        restitution: Components {
            n: normal,
            t: tangential,
        },
        gap,
    }
}

fn status(is_moving: bool, resting: &str) -> &str {
    if is_moving { "slide" } else { resting }
}

fn incline_square(setup: &Value) -> Value {
    let (angle, time_step) = (number(setup, "incline"), number(setup, "dt"));
    let law = law(number(setup, "mu"), 0.0, 0.0, GapRule::Predicted);
    let mut motion = Motion::new(time_step, law);
    let start = (-0.5 * angle.sin(), 0.5 * angle.cos());
    motion.add(
        polygon(4, 0.5f64.sqrt()),
        start,
        angle + FLAT,
        [0.0; 3],
        1.0,
    );
    floor(&mut motion, angle);
    motion.gravity(0.0, -GRAVITY);
    motion.steps(number(setup, "steps") as usize);
    let down = |x: f64, y: f64| -(x * angle.cos() + y * angle.sin());
    let (v, r) = (motion.velocity(0), motion.position(0));
    let impulses = motion.impulses();
    let sum: (f64, f64) = impulses
        .iter()
        .fold((0.0, 0.0), |s, p| (s.0 + p[0], s.1 + p[1]));
    let difference = (impulses[0][0] - impulses[1][0]).abs();
    let larger = impulses[0][0].max(impulses[1][0]);
    json!({
        "status": status(v[0].hypot(v[1]) > 1e-9, "stick"),
        "speed_down": down(v[0], v[1]),
        "distance_down": down(r[0] - start.0, r[1] - start.1),
        "rotation": motion.angle(0) - angle - FLAT,
        "normal_resultant": sum.0 / time_step,
        "friction_resultant": sum.1.abs() / time_step,
        "difference_of_the_two_normal_forces": difference / time_step,
        "larger_normal_force": larger / time_step,
    })
}

fn incline_disc(setup: &Value) -> Value {
    let (angle, radius) = (number(setup, "incline"), number(setup, "R"));
    let law = law(number(setup, "mu"), 0.0, 0.0, GapRule::Predicted);
    let mut motion = Motion::new(number(setup, "dt"), law);
    let start = (-radius * angle.sin(), radius * angle.cos());
    motion.add(disc(radius), start, 0.0, [0.0; 3], 1.0);
    floor(&mut motion, angle);
    motion.gravity(0.0, -GRAVITY);
    motion.steps(number(setup, "steps") as usize);
    let down = |x: f64, y: f64| -(x * angle.cos() + y * angle.sin());
    let (v, r) = (motion.velocity(0), motion.position(0));
    let speed = down(v[0], v[1]);
    json!({
        "status": status((speed - radius * v[2]).abs() > 1e-9, "roll"),
        "speed_down": speed,
        "distance_down": down(r[0] - start.0, r[1] - start.1),
        "spin_magnitude": v[2].abs(),
    })
}

fn block_stops(setup: &Value) -> Value {
    let law = law(number(setup, "mu"), 0.0, 0.0, GapRule::Predicted);
    let mut motion = Motion::new(number(setup, "dt"), law);
    let speed = number(setup, "v0");
    motion.add(
        polygon(4, 0.5f64.sqrt()),
        (0.0, 0.5),
        FLAT,
        [speed, 0.0, 0.0],
        1.0,
    );
    floor(&mut motion, 0.0);
    motion.gravity(0.0, -GRAVITY);
    let (mut stop, mut after_100) = (0, 0.0);
    for step in 1..=400 {
        motion.steps(1);
        if step == 100 {
            after_100 = motion.velocity(0)[0];
        }
        if stop == 0 && motion.velocity(0)[0].abs() < 1e-12 {
            stop = step;
        }
    }
    json!({"discrete": {"steps_to_stop": stop, "distance": motion.position(0)[0], "speed_after_100_steps": after_100}})
}

fn slide_roll(setup: &Value) -> Value {
    let (radius, time_step) = (number(setup, "R"), number(setup, "dt"));
    let law = law(number(setup, "mu"), 0.0, 0.0, GapRule::Predicted);
    let mut motion = Motion::new(time_step, law);
    let start = [number(setup, "v0"), 0.0, number(setup, "w0")];
    motion.add(disc(radius), (0.0, radius), 0.0, start, 1.0);
    floor(&mut motion, 0.0);
    motion.gravity(0.0, -GRAVITY);
    let mut first = 0;
    for step in 1..=2000 {
        motion.steps(1);
        let v = motion.velocity(0);
        if first == 0 && (v[0] + radius * v[2]).abs() < 1e-10 {
            first = step;
        }
    }
    let v = motion.velocity(0);
    json!({"rolling_speed": v[0], "rolling_spin": v[2], "discrete": {"first_rolling_step": first}})
}

fn two_discs(setup: &Value) -> Value {
    let [r1, r2] = ["R1", "R2"].map(|key| number(setup, key));
    let law = law(
        number(setup, "mu"),
        number(setup, "e_n"),
        number(setup, "e_t"),
        GapRule::Closed,
    );
    let mut motion = Motion::new(1e-3, law);
    motion.settings.scheme = Scheme::Beginning;
    let v2 = numbers(&setup["v2"]);
    motion.add(
        disc(r1),
        (0.0, 0.0),
        0.0,
        [0.0, 0.0, number(setup, "w1")],
        1.0,
    );
    motion.add(
        disc(r2),
        (r1 + r2, 0.0),
        0.0,
        [v2[0], v2[1], number(setup, "w2")],
        1.0,
    );
    motion.steps(1);
    let (a, b, p) = (motion.velocity(0), motion.velocity(1), motion.impulses()[0]);
    let tangential = b[1] - a[1] - b[2] * r2 - a[2] * r1;
    json!({
        "status": status(tangential.abs() > 1e-9, "stick"),
        "P_n": p[0], "P_t": p[1],
        "v1": [a[0], a[1]], "v2": [b[0], b[1]], "w1": a[2], "w2": b[2],
        "u_n_plus": b[0] - a[0], "u_t_plus": tangential,
    })
}

/// A polygon with its first vertex at a given arm, on a floor below it.
fn corner_drop(setup: &Value) -> Value {
    let (sides, radius) = (number(setup, "n") as usize, number(setup, "R"));
    let (arm, v) = (numbers(&setup["corner_arm"]), numbers(&setup["v"]));
    let mut motion = Motion::new(1e-9, law(number(setup, "mu"), 0.0, 0.0, GapRule::Closed));
    motion.settings.scheme = Scheme::Beginning;
    motion.settings.detection.alert_distance = 1e-12;
    let start = [v[0], v[1], number(setup, "w")];
    motion.add(
        polygon(sides, radius),
        (0.0, -arm[1]),
        arm[1].atan2(arm[0]),
        start,
        1.0,
    );
    floor(&mut motion, 0.0);
    motion.steps(1);
    let (v, p) = (motion.velocity(0), motion.impulses()[0]);
    json!({"v": [v[0], v[1]], "w": v[2], "P": p})
}

fn landing(setup: &Value) -> Value {
    let (sides, radius) = (number(setup, "n") as usize, number(setup, "R"));
    let (arm, v) = (numbers(&setup["arms"][1]), numbers(&setup["v"]));
    let mut motion = Motion::new(1e-9, law(number(setup, "mu"), 0.0, 0.0, GapRule::Closed));
    motion.settings.scheme = Scheme::Beginning;
    motion.settings.detection.alert_distance = 1e-12;
    let start = [v[0], v[1], number(setup, "w")];
    motion.add(
        polygon(sides, radius),
        (0.0, -arm[1]),
        arm[1].atan2(arm[0]),
        start,
        1.0,
    );
    floor(&mut motion, 0.0);
    motion.steps(1);
    let ratio = motion.velocity(0)[2] / number(setup, "w");
    // A triangle stops, and the formula for the ratio does not apply.
    if sides == 3 {
        json!({})
    } else {
        json!({"no_slip_ratio": ratio})
    }
}

fn cradle(setup: &Value) -> Value {
    let count = number(setup, "N") as usize;
    let mut motion = Motion::new(1e-3, law(0.0, number(setup, "e_n"), 0.0, GapRule::Closed));
    motion.settings.scheme = Scheme::Beginning;
    for k in 0..count {
        let speed = if k == 0 { 1.0 } else { 0.0 };
        motion.add(disc(0.5), (k as f64, 0.0), 0.0, [speed, 0.0, 0.0], 1.0);
    }
    let before = motion.energy();
    motion.steps(1);
    let mass = 0.25 * core::f64::consts::PI;
    let velocities: Vec<_> = (0..count).map(|k| motion.velocity(k)[0]).collect();
    let impulses: Vec<_> = motion.impulses().iter().map(|p| p[0] / mass).collect();
    json!({"velocities": velocities, "kinetic_energy_ratio": motion.energy() / before, "impulses_over_m": impulses})
}

fn gap_closes(setup: &Value) -> Value {
    let (speed, time_step) = (number(setup, "v"), number(setup, "dt"));
    let mut motion = Motion::new(time_step, law(0.4, 0.0, 0.0, GapRule::Predicted));
    // A small disc, so that rounding its height does not round the gap.
    let radius = 1.0 / 1024.0;
    let height = radius + number(setup, "gap") - 0.5 * time_step * speed;
    motion.add(disc(radius), (0.0, height), 0.0, [0.0, speed, 0.0], 1.0);
    floor(&mut motion, 0.0);
    motion.steps(1);
    let first = motion.velocity(0)[1];
    motion.steps(1);
    json!({
        "v_after_first_step": first,
        "v_after_second_step": motion.velocity(0)[1],
        "gap_at_second_detection": motion.gaps()[0],
        "final_gap": motion.position(0)[1] - radius,
    })
}

fn square_pushed(setup: &Value) -> Value {
    let time_step = 1e-6;
    let push = |force: f64| {
        let mut motion = Motion::new(
            time_step,
            law(number(setup, "mu"), 0.0, 0.0, GapRule::Closed),
        );
        motion.settings.scheme = Scheme::Beginning;
        motion.add(polygon(4, 0.5f64.sqrt()), (0.0, 0.5), FLAT, [0.0; 3], 1.0);
        floor(&mut motion, 0.0);
        motion.gravity(force * GRAVITY, -GRAVITY);
        motion.steps(1);
        motion.velocity(0)[2].abs() / time_step
    };
    let (mut below, mut above) = (0.5, 1.5);
    while above - below > 1e-10 {
        let middle: f64 = 0.5 * (below + above);
        if push(middle) > 1e-9 {
            above = middle
        } else {
            below = middle
        }
    }
    json!({"tips_iff_F_over_mg_above": 0.5 * (below + above), "angular_acceleration_at_F_1.5mg": push(1.5)})
}
