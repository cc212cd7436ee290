//! Tangential forces of contacts and bonds, thesis eqs. (41)-(42) and (44).

use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Tangential motion at a contact, summed over both ends.
#[derive(Clone, Copy, Debug)]
pub struct TangentialMotion<S> {
    /// Sum of the tangential displacements of both ends since the contact began, in m, thesis eq. (32).
    pub displacement: S,
    /// Sum of the tangential velocities of both ends, in m/s, thesis eq. (34).
    pub velocity: S,
}

/// Force and heat of a tangential law.
#[derive(Clone, Copy, Debug)]
pub struct Friction<S> {
    /// Force in N, work-conjugate to the sum of the tangential displacements.
    pub force: S,
    /// Continuous heat production, in W.
    pub heat_rate: S,
    /// Heat released instantaneously, in J; negative if the law creates energy.
    pub heat: S,
}

/// Tangential law of a contact.
///
/// A law with memory stores one number per contact, `memory`, which is zero when the contact begins.
pub trait TangentialLaw: Copy + Send + Sync {
    /// Whether the force is always zero.
    const ABSENT: bool = false;
    /// Whether the law has memory.
    const REMEMBERS: bool;
    /// Force and heat for a tangential motion, under the given normal force in N.
    fn friction<S: Real>(
        self,
        motion: TangentialMotion<S>,
        normal_force: S,
        memory: &mut S,
    ) -> Friction<S>;
    /// Stored energy in J, for a displacement in m and a normal force in N.
    fn stored_energy<S: Real>(self, displacement: S, normal_force: S, memory: S) -> S;
}

/// No tangential force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictionless;

impl TangentialLaw for Frictionless {
    const ABSENT: bool = true;
    const REMEMBERS: bool = false;
    #[inline(always)]
    fn friction<S: Real>(self, _: TangentialMotion<S>, _: S, _: &mut S) -> Friction<S> {
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
/// # Equation
/// Thesis eq. (41), with the velocity summed over both ends:
///
/// $$ F = -\mathrm{sgn}(\partial_t \zeta)\, \min\{\mu \lvert F^n \rvert,\ \gamma^t \lvert \partial_t \zeta \rvert\} $$
///
/// # Symbols
/// $\partial_t \zeta$ is the tangential velocity in m/s, $F^n$ the normal force in N, $\mu$ `friction` and $\gamma^t$
/// `damping` in kg/s.
///
/// # Sign
/// The force opposes the velocity.
///
/// # Domain
/// Dynamic friction only: there is no force at rest.
///
/// # Energy
/// Stores no energy; all work becomes heat.
///
/// # Example
/// ```
/// use gouge_dem::laws::{HaffWerner, TangentialMotion, TangentialLaw};
/// let law = HaffWerner { friction: 0.5, damping: 10.0 };
/// let force = |velocity: f64| law.friction(TangentialMotion { displacement: 0.0, velocity }, -4.0, &mut 0.0).force;
/// assert_eq!([force(0.1), force(-3.0)], [-1.0, 2.0]);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HaffWerner {
    /// Coefficient of friction, dimensionless.
    pub friction: f64,
    /// Damping coefficient in kg/s.
    pub damping: f64,
}

impl TangentialLaw for HaffWerner {
    const REMEMBERS: bool = false;
    #[inline(always)]
    fn friction<S: Real>(
        self,
        motion: TangentialMotion<S>,
        normal_force: S,
        _: &mut S,
    ) -> Friction<S> {
        let speed = motion.velocity.abs();
        let magnitude = (normal_force.abs() * self.friction).min(speed * self.damping);
        Friction {
            force: -(motion.velocity.signum_or_zero() * magnitude),
            heat_rate: magnitude * speed,
            heat: S::zero(),
        }
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, _: S, _: S, _: S) -> S {
        S::zero()
    }
}

/// Cundall-Strack friction as printed in the thesis.
///
/// # Equation
/// Thesis eq. (42), with displacement and velocity summed over both ends:
///
/// $$ F = -\begin{cases} \mathrm{sgn}(\partial_t \zeta)\, \mu \lvert F^n \rvert, & \mu \lvert F^n \rvert \le k^t \lvert \zeta \rvert \\ k^t \zeta, & \mu \lvert F^n \rvert > k^t \lvert \zeta \rvert \end{cases} $$
///
/// # Symbols
/// $\zeta$ is the tangential displacement in m, $\partial_t \zeta$ its rate in m/s, $F^n$ the normal force in N,
/// $\mu$ `friction` and $k^t$ `stiffness` in kg/s^2.
///
/// # Sign
/// The force opposes the displacement while the contact sticks, and the velocity while it slides.
///
/// # Energy
/// Stored energy $\tfrac12 k^t \zeta^2$ while the contact sticks, none while it slides (erratum E16 of the
/// thesis). The ledger records jumps of the stored energy as heat of either sign.
///
/// # Errata
/// The spring continues to stretch while the contact slides. A closed cycle can therefore create energy; the force
/// jumps by twice the limit when the velocity reverses; and a contact that has slid has no static friction until the
/// spring has unwound (erratum E15 of the thesis). Use [`CundallStrackTruncated`], except to reproduce the thesis.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CundallStrack {
    /// Coefficient of friction, dimensionless.
    pub friction: f64,
    /// Tangential stiffness in kg/s^2.
    pub stiffness: f64,
    /// How a sliding contact with exactly zero velocity is treated. If true, the full friction limit acts as for a
    /// positive velocity, as in the program of the thesis's author. If false there is no force, because sgn 0 = 0.
    pub grips_at_rest: bool,
}

impl CundallStrack {
    /// Value of the memory while the contact slides.
    const SLIDING: f64 = 1.0;
}

impl TangentialLaw for CundallStrack {
    const REMEMBERS: bool = true;
    #[inline(always)]
    fn friction<S: Real>(
        self,
        motion: TangentialMotion<S>,
        normal_force: S,
        memory: &mut S,
    ) -> Friction<S> {
        let limit = normal_force.abs() * self.friction;
        let spring = motion.displacement * self.stiffness;
        let stored = spring * motion.displacement * 0.5;
        let slid = *memory > S::zero();
        if limit <= spring.abs() {
            *memory = S::from_f64(Self::SLIDING);
            let sign = if self.grips_at_rest {
                motion.velocity.signum_or_one()
            } else {
                motion.velocity.signum_or_zero()
            };
            Friction {
                force: -(sign * limit),
                heat_rate: limit * motion.velocity.abs(),
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

/// Cundall-Strack friction with the spring truncated at the Coulomb limit.
///
/// # Equation
/// $$ F = -k^t (\zeta - s), \qquad \lvert \zeta - s \rvert \le \mu \lvert F^n \rvert / k^t $$
///
/// The slip $s$ is the memory of the contact. It follows the displacement such that the spring force never exceeds
/// the Coulomb limit. LAMMPS, YADE and most other codes call this law Cundall-Strack.
///
/// # Symbols
/// $\zeta$ is the tangential displacement in m, $s$ the slip in m, $F^n$ the normal force in N, $\mu$ `friction` and
/// $k^t$ `stiffness` in kg/s^2.
///
/// # Sign
/// The force opposes the elastic displacement $\zeta - s$.
///
/// # Energy
/// Stored energy $\tfrac12 k^t (\zeta - s)^2$. Slip under the limiting force becomes heat, so the law creates no
/// energy.
///
/// # Example
/// ```
/// use gouge_dem::laws::{CundallStrackTruncated, TangentialMotion, TangentialLaw};
/// let law = CundallStrackTruncated { friction: 0.5, stiffness: 10.0 };
/// let mut slip = 0.0;
/// let mut force = |displacement: f64| {
///     law.friction(TangentialMotion { displacement, velocity: 0.0 }, -4.0, &mut slip).force
/// };
/// assert_eq!([force(0.1), force(1.0), force(0.8), force(0.5)], [-1.0, -2.0, 0.0, 2.0]);
/// ```
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CundallStrackTruncated {
    /// Coefficient of friction, dimensionless.
    pub friction: f64,
    /// Tangential stiffness in kg/s^2.
    pub stiffness: f64,
}

impl TangentialLaw for CundallStrackTruncated {
    const REMEMBERS: bool = true;
    #[inline(always)]
    fn friction<S: Real>(
        self,
        motion: TangentialMotion<S>,
        normal_force: S,
        slip: &mut S,
    ) -> Friction<S> {
        let limit = normal_force.abs() * self.friction;
        let spring = (motion.displacement - *slip) * self.stiffness;
        let sticks = spring.abs() <= limit;
        let capped = spring.signum_or_zero() * limit;
        let compliance = 1.0 / self.stiffness;
        // Selected at the end, so that loops over contacts are vectorised.
        let (force, heat) = if sticks {
            (spring, S::zero())
        } else {
            (capped, capped * (spring - capped) * compliance)
        };
        *slip = if sticks {
            *slip
        } else {
            motion.displacement - capped * compliance
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

/// Bending and shearing law of a bond, applied to each end separately.
pub trait BeamLaw: Copy + Send + Sync {
    /// Whether the force is always zero.
    const ABSENT: bool;
    /// Force in N, work-conjugate to the tangential displacement `zeta` of one end in m; `d_zeta` is its rate in m/s.
    fn force<S: Real>(self, zeta: S, d_zeta: S) -> S;
    /// Energy stored at one end, in J.
    fn stored_energy<S: Real>(self, zeta: S) -> S;
    /// Heat production at one end, in W.
    fn heat_rate<S: Real>(self, d_zeta: S) -> S;
}

/// No bending or shearing: the bond has a normal force only.
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

/// Bending and shearing of a bond: the thesis's simplification of an Euler-Bernoulli beam.
///
/// # Equation
/// Thesis eqs. (44)-(45):
///
/// $$ F^{EB}_{ij} = -(\bar k^t \zeta_{ij} + \bar\gamma^t\, \partial_t \zeta_{ij}), \qquad \tau_{ij} = r_i F^{EB}_{ij}, \qquad F^t_{ij} = \frac{\tau_{ij} + \tau_{ji}}{\lvert \vec x_j - \vec x_i \rvert} $$
///
/// # Symbols
/// $\zeta_{ij}$ is the tangential displacement of the end at i in m, $\bar k^t$ `stiffness` in kg/s^2, $\bar\gamma^t$
/// `damping` in kg/s and $r_i$ the radius in m.
///
/// # Sign
/// The force opposes the displacement. Torques are positive counter-clockwise.
///
/// # Energy
/// Stored energy $\tfrac12 \bar k^t \zeta_{ij}^2$ per end, thesis eq. (77). Momentum and angular momentum are
/// conserved.
///
/// # Errata
/// The lever arm is the radius instead of the contact distance of (32): only then do torque and force derive from the
/// stored energy (erratum E17 of the thesis). Unlike in the stiffness matrix of a beam, the two ends are not
/// coupled, and bending and shearing have the same stiffness.
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
    /// Tangential stiffness in kg/s^2.
    pub stiffness: f64,
    /// Tangential damping coefficient in kg/s.
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
