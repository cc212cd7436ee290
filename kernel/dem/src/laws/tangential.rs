//! Tangential forces of weak and strong links, thesis eqs. (41)-(42) and (44).

use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Tangential motion of a weak link, both ends taken together.
#[derive(Clone, Copy, Debug)]
pub struct Slide<S> {
    /// Sum of the tangential displacements of both ends since the contact began, in m (thesis eq. (32)).
    pub displacement: S,
    /// Sum of the tangential velocities of both ends, in m/s (thesis eq. (34)).
    pub velocity: S,
}

/// Outcome of a tangential law.
#[derive(Clone, Copy, Debug)]
pub struct Friction<S> {
    /// Force in N, conjugate to the sum of the tangential displacements.
    pub force: S,
    /// Power turned into heat, in W.
    pub heat_rate: S,
    /// Energy turned into heat at once, in J; negative where a law makes energy from nothing.
    pub heat: S,
}

/// Tangential force of a weak link.
///
/// A law that remembers owns one number a link, `memory`, which is zero when the contact begins.
pub trait TangentialLaw: Copy + Send + Sync {
    /// Whether the force is always zero.
    const ABSENT: bool = false;
    /// Whether the link must remember its beginning.
    const REMEMBERS: bool;
    /// Force and dissipation for a motion under the given normal force in N.
    fn friction<S: Real>(self, slide: Slide<S>, normal_force: S, memory: &mut S) -> Friction<S>;
    /// Stored energy in J.
    fn stored_energy<S: Real>(self, displacement: S, normal_force: S, memory: S) -> S;
}

/// No tangential force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictionless;

impl TangentialLaw for Frictionless {
    const ABSENT: bool = true;
    const REMEMBERS: bool = false;
    #[inline(always)]
    fn friction<S: Real>(self, _: Slide<S>, _: S, _: &mut S) -> Friction<S> {
        Friction {
            force: S::zero(),
            heat_rate: S::zero(),
            heat: S::zero(),
        }
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, _: S, _: S, _: S) -> S {
        S::zero()
    }
}

/// Haff-Werner friction: viscous up to the Coulomb limit.
///
/// $$ F = -\mathrm{sgn}(\partial_t \zeta)\, \min\{\mu \lvert F^n \rvert,\ \gamma^t \lvert \partial_t \zeta \rvert\} $$
///
/// Thesis eq. (41), with the sum of both ends for the velocity. Dynamic friction only: at rest there
/// is no force. Stores nothing.
///
/// # Example
/// ```
/// use gouge_dem::laws::{HaffWerner, Slide, TangentialLaw};
/// let law = HaffWerner { friction: 0.5, damping: 10.0 };
/// let force = |velocity: f64| law.friction(Slide { displacement: 0.0, velocity }, -4.0, &mut 0.0).force;
/// assert_eq!([force(0.1), force(-3.0)], [-1.0, 2.0]);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HaffWerner {
    /// Coefficient of friction.
    pub friction: f64,
    /// Damping coefficient in kg/s.
    pub damping: f64,
}

impl TangentialLaw for HaffWerner {
    const REMEMBERS: bool = false;
    #[inline(always)]
    fn friction<S: Real>(self, slide: Slide<S>, normal_force: S, _: &mut S) -> Friction<S> {
        let speed = slide.velocity.abs();
        let magnitude = (normal_force.abs() * self.friction).min(speed * self.damping);
        Friction {
            force: -(slide.velocity.signum_or_zero() * magnitude),
            heat_rate: magnitude * speed,
            heat: S::zero(),
        }
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, _: S, _: S, _: S) -> S {
        S::zero()
    }
}

/// Cundall-Strack friction exactly as the thesis prints it.
///
/// $$ F = -\begin{cases} \mathrm{sgn}(\partial_t \zeta)\, \mu \lvert F^n \rvert, & \mu \lvert F^n \rvert \le k^t \lvert \zeta \rvert \\ k^t \zeta, & \mu \lvert F^n \rvert > k^t \lvert \zeta \rvert \end{cases} $$
///
/// Thesis eq. (42), with the sum of both ends for displacement and velocity. Stored energy: half of k
/// times the squared displacement while it sticks, nothing while it slides (E16).
///
/// # Errata
/// The spring keeps stretching while the contact slides. A closed cycle can therefore create energy,
/// the force jumps by twice the limit where the velocity reverses, and a contact that has slid has no
/// static friction until it unwinds (E15). Use [`CundallStrackTruncated`] unless a comparison with the
/// thesis needs this form. The ledger books the jumps of the stored energy as heat of either sign.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CundallStrack {
    /// Coefficient of friction.
    pub friction: f64,
    /// Stiffness in kg/s^2.
    pub stiffness: f64,
    /// Whether a sliding contact of exactly no velocity feels the full limit, against a positive
    /// velocity, as in the thesis author's program; otherwise it feels nothing, sgn 0 = 0.
    pub grips_at_rest: bool,
}

impl CundallStrack {
    /// Memory of a contact that slides.
    const SLIDING: f64 = 1.0;
}

impl TangentialLaw for CundallStrack {
    const REMEMBERS: bool = true;
    #[inline(always)]
    fn friction<S: Real>(self, slide: Slide<S>, normal_force: S, memory: &mut S) -> Friction<S> {
        let limit = normal_force.abs() * self.friction;
        let spring = slide.displacement * self.stiffness;
        let stored = spring * slide.displacement * 0.5;
        let slid = *memory > S::zero();
        if limit <= spring.abs() {
            *memory = S::from_f64(Self::SLIDING);
            let sign = if self.grips_at_rest {
                slide.velocity.signum_or_one()
            } else {
                slide.velocity.signum_or_zero()
            };
            Friction {
                force: -(sign * limit),
                heat_rate: limit * slide.velocity.abs(),
                heat: if slid { S::zero() } else { stored },
            }
        } else {
            *memory = S::zero();
            Friction {
                force: -spring,
                heat_rate: S::zero(),
                heat: if slid { -stored } else { S::zero() },
            }
        }
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, displacement: S, normal_force: S, _: S) -> S {
        if normal_force.abs() * self.friction <= displacement.abs() * self.stiffness {
            S::zero()
        } else {
            displacement * displacement * (0.5 * self.stiffness)
        }
    }
}

/// Cundall-Strack friction with the spring cut back while it slides.
///
/// $$ F = -k^t (\zeta - s), \qquad \lvert \zeta - s \rvert \le \mu \lvert F^n \rvert / k^t $$
///
/// The slip s, remembered by the link, follows the displacement so that the spring never exceeds the
/// Coulomb limit. This is what LAMMPS, YADE and most of the field call Cundall-Strack. Passive: each
/// advance of the slip turns its work against the limiting force into heat.
///
/// # Example
/// ```
/// use gouge_dem::laws::{CundallStrackTruncated, Slide, TangentialLaw};
/// let law = CundallStrackTruncated { friction: 0.5, stiffness: 10.0 };
/// let mut slip = 0.0;
/// let mut force = |displacement: f64| {
///     law.friction(Slide { displacement, velocity: 0.0 }, -4.0, &mut slip).force
/// };
/// assert_eq!([force(0.1), force(1.0), force(0.8), force(0.5)], [-1.0, -2.0, 0.0, 2.0]);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CundallStrackTruncated {
    /// Coefficient of friction.
    pub friction: f64,
    /// Stiffness in kg/s^2.
    pub stiffness: f64,
}

impl TangentialLaw for CundallStrackTruncated {
    const REMEMBERS: bool = true;
    #[inline(always)]
    fn friction<S: Real>(self, slide: Slide<S>, normal_force: S, slip: &mut S) -> Friction<S> {
        let limit = normal_force.abs() * self.friction;
        let spring = (slide.displacement - *slip) * self.stiffness;
        let sticks = spring.abs() <= limit;
        let capped = spring.signum_or_zero() * limit;
        let compliance = 1.0 / self.stiffness;
        // Chosen at the end, so that many contacts are looked at together.
        let (force, heat) = if sticks {
            (spring, S::zero())
        } else {
            (capped, capped * (spring - capped) * compliance)
        };
        *slip = if sticks {
            *slip
        } else {
            slide.displacement - capped * compliance
        };
        Friction {
            force: -force,
            heat_rate: S::zero(),
            heat,
        }
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, displacement: S, _: S, slip: S) -> S {
        let stretch = displacement - slip;
        stretch * stretch * (0.5 * self.stiffness)
    }
}

/// Bending and shearing of a strong link, one end at a time.
pub trait BeamLaw: Copy + Send + Sync {
    /// Whether the force is always zero.
    const ABSENT: bool;
    /// Force in N conjugate to the tangential displacement of one end, in m, with its rate in m/s.
    fn force<S: Real>(self, zeta: S, d_zeta: S) -> S;
    /// Energy stored in one end, in J.
    fn stored_energy<S: Real>(self, zeta: S) -> S;
    /// Power turned into heat at one end, in W.
    fn heat_rate<S: Real>(self, d_zeta: S) -> S;
}

/// Strong link that neither bends nor shears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoBending;

impl BeamLaw for NoBending {
    const ABSENT: bool = true;
    #[inline(always)]
    fn force<S: Real>(self, _: S, _: S) -> S {
        S::zero()
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, _: S) -> S {
        S::zero()
    }
    #[inline(always)]
    fn heat_rate<S: Real>(self, _: S) -> S {
        S::zero()
    }
}

/// The thesis's simplification of an Euler-Bernoulli beam.
///
/// $$ F^{EB}_{ij} = -(\bar k^t \zeta_{ij} + \bar\gamma^t\, \partial_t \zeta_{ij}), \qquad \tau_{ij} = r_i F^{EB}_{ij}, \qquad F^t_{ij} = \frac{\tau_{ij} + \tau_{ji}}{\lvert \vec x_j - \vec x_i \rvert} $$
///
/// Thesis eqs. (44)-(45), with the radius for the contact distance of (32): only then do torque and
/// force derive from the stored energy (77) (erratum E17 of the thesis). Momentum and angular momentum
/// are conserved. Unlike the stiffness matrix of a beam, the ends do not couple, so bending and
/// shearing have the same constant.
///
/// # Example
/// ```
/// use gouge_dem::laws::{BeamLaw, EulerBernoulli};
/// let law = EulerBernoulli { stiffness: 100.0, damping: 1.0 };
/// assert_eq!(law.force(0.02, -0.5), -1.5);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerBernoulli {
    /// Stiffness in kg/s^2.
    pub stiffness: f64,
    /// Damping coefficient in kg/s.
    pub damping: f64,
}

impl BeamLaw for EulerBernoulli {
    const ABSENT: bool = false;
    #[inline(always)]
    fn force<S: Real>(self, zeta: S, d_zeta: S) -> S {
        -(zeta * self.stiffness + d_zeta * self.damping)
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, zeta: S) -> S {
        zeta * zeta * (0.5 * self.stiffness)
    }
    #[inline(always)]
    fn heat_rate<S: Real>(self, d_zeta: S) -> S {
        d_zeta * d_zeta * self.damping
    }
}
