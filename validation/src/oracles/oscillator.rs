//! The damped oscillator in closed form.

/// Restitution of a collision whose force is that of a damped spring until it first vanishes.
///
/// With beta = zeta w0 and, below critical damping, w = w0 sqrt(1 - zeta^2), the overlap is
/// exp(-beta t) sin(w t) / w and the force vanishes when tan(w t) = 2 beta w / (beta^2 - w^2); at that
/// moment the speed is exp(-beta t) times that of impact. Depends on the damping ratio alone.
pub fn truncated_restitution(zeta: f64) -> f64 {
    if zeta < 1.0 {
        let w = (1.0 - zeta * zeta).sqrt();
        let phase = (2.0 * zeta * w).atan2(zeta * zeta - w * w);
        return (-zeta / w * phase).exp();
    }
    let w = (zeta * zeta - 1.0).sqrt();
    if w == 0.0 {
        return (-2.0_f64).exp();
    }
    (-zeta / w * ((zeta + w) / (zeta - w)).ln()).exp()
}

/// Displacement at a time, in units of 1/w0, of an oscillator released from one at rest; zeta < 1.
pub fn released(time: f64, zeta: f64) -> f64 {
    let w = (1.0 - zeta * zeta).sqrt();
    (-zeta * time).exp() * ((w * time).cos() + zeta / w * (w * time).sin())
}
