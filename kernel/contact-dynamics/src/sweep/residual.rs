//! How far impulses and velocities are from satisfying the laws.

use super::Row;
use crate::units::Velocity;
use gouge_equations::rendered;

/// Residual of the laws at one point in m/s (natural map), zero exactly for a solution.
///
/// $$ r = \frac1\rho \max(|P_n - \max(P_n - \rho u_n, 0)|, |P_t - \mathrm{clamp}(P_t - \rho u_t, \pm\mu P_n)|) $$
///
/// with $\rho = 1/\max(W_{nn}, W_{tt})$.
///
/// Here u is the velocity to which the laws apply.
#[rendered]
#[inline]
pub(super) fn natural_map(row: &Row, friction: f64, velocities: [Velocity; 2]) -> f64 {
    let (u, p) = (row.law_velocity_of(velocities), row.impulse);
    let scale = row.w.nn.max(row.w.tt);
    let limit = friction * p.n.max(0.0);
    let normal = p.n - (p.n - u.n / scale).max(0.0);
    let tangential = p.t - (p.t - u.t / scale).max(-limit).min(limit);
    if normal.is_nan() || tangential.is_nan() {
        return f64::NAN;
    }
    scale * normal.abs().max(tangential.abs())
}

/// The larger residual, or what is not a number.
pub(super) fn larger(largest: f64, residual: f64) -> f64 {
    if residual > largest || residual.is_nan() {
        residual
    } else {
        largest
    }
}
