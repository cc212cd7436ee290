//! Closed forms of the motion of rigid bodies on floors.

/// Square of the radius of gyration of a regular polygon, or of a disc for 0 sides, over that of the circumscribed
/// circle: the sum over its triangles, (2 + cos(2 pi/n))/6.
pub fn gyration(sides: usize) -> f64 {
    match sides {
        0 => 0.5,
        n => (2.0 + (std::f64::consts::TAU / n as f64).cos()) / 6.0,
    }
}

/// Acceleration down an incline in m/s^2 of a block, which rests up to the friction angle.
pub fn block_on_incline(gravity: f64, angle: f64, friction: f64) -> f64 {
    (gravity * (angle.sin() - friction * angle.cos())).max(0.0)
}

/// Acceleration in m/s^2 and angular acceleration times radius of a disc on an incline: it rolls with two thirds of the
/// weight's component, until the third that friction carries exceeds the Coulomb limit.
pub fn disc_on_incline(gravity: f64, angle: f64, friction: f64) -> [f64; 2] {
    let rolling = gravity * angle.sin() * 2.0 / 3.0;
    if angle.tan() <= 3.0 * friction {
        return [rolling; 2];
    }
    let sliding = gravity * (angle.sin() - friction * angle.cos());
    [sliding, 2.0 * friction * gravity * angle.cos()]
}

/// Velocity in m/s and angular velocity times radius of a disc after a collision with a floor, from its velocity along
/// the floor, its speed towards it, and its angular velocity times radius before: friction ends the sliding if it can.
///
/// Angular momentum about the point of contact is conserved.
pub fn disc_after_impact(
    along: f64,
    towards: f64,
    spin: f64,
    restitution: f64,
    friction: f64,
) -> [f64; 2] {
    // Sliding velocity of the lowest point with the spin anticlockwise; an impulse J per mass changes it by 3 J.
    let sliding = along + spin;
    let most = friction * (1.0 + restitution) * towards;
    let impulse = -sliding.signum() * most.min(sliding.abs() / 3.0);
    [along + impulse, spin + 2.0 * impulse]
}

/// Ratio of the angular velocities after and before a polygon that rolls over its corners lands on the next one:
/// angular momentum about the new corner is conserved.
pub fn landing(sides: usize) -> f64 {
    let own = gyration(sides);
    let swing = (std::f64::consts::TAU / sides as f64).cos();
    ((own + swing) / (own + 1.0)).max(0.0)
}

/// Angular velocity in rad/s just before landing of a regular polygon with a circumscribed circle of 1 m that rolls down
/// an incline steadily: what it gains from corner to corner is what each landing takes.
pub fn steady_landing(gravity: f64, sides: usize, angle: f64) -> f64 {
    let side = 2.0 * (std::f64::consts::PI / sides as f64).sin();
    let gained = 2.0 * gravity * side * angle.sin() / (gyration(sides) + 1.0);
    (gained / (1.0 - landing(sides).powi(2))).sqrt()
}

/// Relative change per step and angle of a step of the angular velocity of this motion, if every landing is found two
/// steps early: gravity then works for two steps less, and the losses of all earlier landings add up.
pub fn early_landing(gravity: f64, sides: usize, angle: f64) -> f64 {
    let half = std::f64::consts::PI / sides as f64;
    let acceleration = gravity * (half + angle).sin() / (gyration(sides) + 1.0);
    let speed = steady_landing(gravity, sides, angle);
    2.0 * acceleration / speed.powi(2) / (1.0 - landing(sides).powi(2))
}

/// Forces over the weight of each of three equal discs: one rests on two that stand apart on a floor, with the line of
/// centres at an angle from the vertical. Normal force and friction between discs, normal force and friction at the
/// floor. No disc turns, so that both frictions of a lower disc are equal.
pub fn pyramid(angle: f64) -> [f64; 4] {
    let friction = 0.5 * (0.5 * angle).tan();
    [0.5, friction, 1.5, friction]
}

/// Factor per sweep by which errors of the impulses in a column of n discs on a floor fall in Gauss-Seidel sweeps: the
/// square of the largest eigenvalue of the Jacobi iteration, cos(pi/2n).
pub fn column_rate(discs: usize) -> f64 {
    (0.5 * std::f64::consts::PI / discs as f64).cos().powi(2)
}

/// Angle from the vertical after a time in s of a point that slides down a circle from rest, with gravity over the
/// radius in 1/s^2: a Runge-Kutta method of the fourth order.
pub fn sliding_down(ratio: f64, start: f64, time: f64) -> f64 {
    let steps = 4000;
    let h = time / f64::from(steps);
    let slope = |[angle, speed]: [f64; 2]| [speed, ratio * angle.sin()];
    let along = |[a, v]: [f64; 2], [da, dv]: [f64; 2], h: f64| [a + h * da, v + h * dv];
    let mut state = [start, 0.0];
    for _ in 0..steps {
        let k1 = slope(state);
        let k2 = slope(along(state, k1, 0.5 * h));
        let k3 = slope(along(state, k2, 0.5 * h));
        let k4 = slope(along(state, k3, h));
        let mean = [0, 1].map(|k| (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]) / 6.0);
        state = along(state, mean, h);
    }
    state[0]
}
