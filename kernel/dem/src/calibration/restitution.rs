//! Restitution of head-on collisions, and the damping that gives a wanted one.

use crate::laws::{Bshp, KelvinVoigt, ReboundingBshp, ReboundingKelvinVoigt};
use crate::material::Elastic;
use gouge_equations::rendered;

/// Duration of a truncated Kelvin-Voigt collision, in units of the inverse natural frequency.
///
/// $$ t = \frac{2 \arccos \zeta}{\sqrt{1 - \zeta^2}}, \quad \zeta < 1, \qquad t = \frac{2\, \mathrm{arcosh}\, \zeta}{\sqrt{\zeta^2 - 1}}, \quad \zeta > 1 $$
///
/// The collision ends when the force vanishes, before the overlap does. At critical damping the duration is 2. The
/// damping ratio is that of the pair, with its reduced mass.
#[rendered]
pub fn truncated_duration(damping_ratio: f64) -> f64 {
    // Two roots, so that nothing overflows.
    let w = (1.0 - damping_ratio).abs().sqrt() * (1.0 + damping_ratio).sqrt();
    if damping_ratio < 1.0 {
        2.0 * libm::atan2(w, damping_ratio) / w
    } else if w > 0.0 {
        2.0 * libm::asinh(w) / w
    } else {
        2.0
    }
}

/// Coefficient of restitution of a truncated Kelvin-Voigt collision.
///
/// $$ \Upsilon = e^{-\zeta t} $$
///
/// $t$ is the [`truncated_duration`]. Tends to $1 / (4 \zeta^2)$ for strong damping.
#[rendered]
pub fn truncated_restitution(damping_ratio: f64) -> f64 {
    libm::exp(-damping_ratio * truncated_duration(damping_ratio))
}

/// Damping ratio for which a truncated Kelvin-Voigt collision has a given coefficient of restitution in (0, 1].
///
/// Zero for 1, and about $1 / (2 \sqrt\Upsilon)$ for weak rebounds.
#[rendered]
pub fn damping_ratio_for(restitution: f64) -> f64 {
    argument_for(restitution, truncated_restitution)
}

/// Coefficient of restitution of a collision of viscoelastic spheres with the dissipation b > 0.
///
/// # Equation
/// With the length $(m v^2 / P)^{2/5}$ as unit and the time in which the impact speed $v$ covers it, the overlap $u$ of
/// [`Bshp`] obeys
///
/// $$ u'' = -(u^{3/2} + b\, u^{1/2} u'), \qquad u(0) = 0,\ u'(0) = 1, \qquad b = \Lambda\, v^{1/5} (P / m)^{2/5} $$
///
/// until the force vanishes, where the restitution is $-u'$.
///
/// # Method
/// For $u = y^2$, $u' = w$ and $\mathrm d t = 2 y\, \mathrm d \tau$ the equation has no root left:
///
/// $$ \frac{\mathrm d y}{\mathrm d \tau} = w, \qquad \frac{\mathrm d w}{\mathrm d \tau} = -2 y^2 (y^2 + b w) $$
///
/// It is integrated by the classical Runge-Kutta method; the relative error is below 1e-11.
#[rendered]
pub fn viscoelastic_restitution(dissipation: f64) -> f64 {
    const STEP: f64 = 4e-3;
    // With strong damping the motion takes place within b^(-1/3).
    let step = STEP / (1.0 + libm::cbrt(dissipation));
    let mut state = [0.0, 1.0];
    loop {
        let next = viscoelastic_step(dissipation, state, step);
        if has_ended(dissipation, next) {
            break;
        }
        state = next;
    }
    let (mut low, mut high) = (0.0, step);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if has_ended(dissipation, viscoelastic_step(dissipation, state, middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    -viscoelastic_step(dissipation, state, high)[1]
}

/// Dissipation b for which a collision of viscoelastic spheres has a given coefficient of restitution in (0, 1].
///
/// Zero for 1; see [`viscoelastic_restitution`].
pub fn dissipation_for(restitution: f64) -> f64 {
    argument_for(restitution, viscoelastic_restitution)
}

/// Kelvin-Voigt law for which every pair has a given coefficient of restitution in (0, 1]; stiffness in kg/s^2.
pub fn rebounding_kelvin_voigt(stiffness: f64, restitution: f64) -> ReboundingKelvinVoigt {
    let damping = 2.0 * damping_ratio_for(restitution) * stiffness.sqrt();
    ReboundingKelvinVoigt {
        of_unit_mass: KelvinVoigt { stiffness, damping },
    }
}

/// BSHP law for which every pair has a given coefficient of restitution in (0, 1] at a relative speed in m/s.
pub fn rebounding_bshp(elastic: Elastic, restitution: f64, speed: f64) -> ReboundingBshp {
    let mut of_unit_pair = Bshp {
        youngs_modulus: elastic.youngs_modulus,
        poissons_ratio: elastic.poissons_ratio,
        dissipative_constant: 0.0,
    };
    // Radii of 2 m have the reduced radius 1 m.
    let prefactor = of_unit_pair.prefactor([2.0; 2]);
    let scale = libm::pow(prefactor, 0.4) * libm::pow(speed, 0.2);
    of_unit_pair.dissipative_constant = dissipation_for(restitution) / scale;
    ReboundingBshp { of_unit_pair }
}

/// Argument at which a function that falls from 1 at 0 has a value in (0, 1].
fn argument_for(value: f64, falling: impl Fn(f64) -> f64) -> f64 {
    if value >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    while falling(high) > value {
        (low, high) = (high, 1e3 * high);
    }
    loop {
        let is_far = low > 0.0 && high > 2.0 * low;
        let middle = if is_far {
            low.sqrt() * high.sqrt()
        } else {
            0.5 * (low + high)
        };
        if middle <= low || middle >= high {
            return middle;
        }
        if falling(middle) > value {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// Whether the force of viscoelastic spheres in the state (y, w) has vanished, or nearly so: overdamped spheres approach
/// the state in which elastic and viscous force cancel so closely that rounding hides the rest.
fn has_ended(dissipation: f64, [y, w]: [f64; 2]) -> bool {
    const REST: f64 = 1e-12;
    let elastic = y * y;
    w < 0.0 && (y <= 0.0 || elastic + dissipation * w <= REST * elastic)
}

/// One step of the classical Runge-Kutta method.
fn viscoelastic_step(dissipation: f64, state: [f64; 2], step: f64) -> [f64; 2] {
    let rate = |[y, w]: [f64; 2]| [w, -2.0 * y * y * (y * y + dissipation * w)];
    let moved = |rate: [f64; 2], share: f64| [0, 1].map(|k| state[k] + share * step * rate[k]);
    let a = rate(state);
    let b = rate(moved(a, 0.5));
    let c = rate(moved(b, 0.5));
    let d = rate(moved(c, 1.0));
    moved([0, 1].map(|k| a[k] + 2.0 * (b[k] + c[k]) + d[k]), 1.0 / 6.0)
}
