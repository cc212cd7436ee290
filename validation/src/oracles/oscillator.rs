//! The damped oscillator in closed form.

use num_traits::Float;

/// Duration, in units of 1/w0, of a collision whose force is that of a damped spring until it first
/// vanishes.
///
/// With beta = zeta w0 and, below critical damping, w = w0 sqrt(1 - zeta^2), the overlap is exp(-beta
/// t) sin(w t) / w, and the force vanishes when tan(w t) = 2 beta w / (beta^2 - w^2). The result
/// depends on the damping ratio only.
pub fn truncated_duration<F: Float>(zeta: F) -> F {
    let one = F::one();
    let squared = (one - zeta) * (one + zeta);
    let w = squared.abs().sqrt();
    if w == F::zero() {
        return one + one;
    }
    if squared > F::zero() {
        return ((zeta + zeta) * w).atan2(zeta * zeta - squared) / w;
    }
    ((zeta + w) / (zeta - w)).ln() / w
}

/// Restitution of that collision: the final speed is exp(-beta t) times the initial speed.
pub fn truncated_restitution<F: Float>(zeta: F) -> F {
    (-zeta * truncated_duration(zeta)).exp()
}

/// Displacement, at a time in units of 1/w0, of an oscillator released at rest from one; zeta < 1.
pub fn released(time: f64, zeta: f64) -> f64 {
    let w = (1.0 - zeta * zeta).sqrt();
    (-zeta * time).exp() * ((w * time).cos() + zeta / w * (w * time).sin())
}
