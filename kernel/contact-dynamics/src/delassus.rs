//! Kinematics of a contact point, and the response of its two bodies to its impulse.

use crate::local::{Components, LocalProblem};
use crate::units::{InverseMass, Velocity};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Where a contact point lies on its two units.
///
/// $$ u = v_2 - v_1, \qquad v_a = U_a + \omega_a\, (\hat z \times c_a) $$
///
/// | letter | field | meaning | unit |
/// |---|---|---|---|
/// | $n$ | `normal` | unit normal from the first to the second unit | 1 |
/// | $t$ | | tangent, $n$ turned by +90 degrees | 1 |
/// | $c_a$ | `arms` | from the centre of each unit to the point, as normal and tangential components | m |
///
/// # Sign
/// $u_n > 0$ separates. An impulse acts on the second unit, and its opposite on the first.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointKinematics {
    /// Indices of the two units, which differ.
    pub units: [u32; 2],
    /// Unit normal from the first to the second unit.
    pub normal: Vec2,
    /// Vectors from the centres of the units to the point in m.
    pub arms: [Components; 2],
}

/// The Delassus operator of one point, azema (A18), symmetric and positive semi-definite.
///
/// $$ W_{nn} = \sum_a \left( n \cdot M_a^{-1} n + \frac{c_{at}^2}{I_a} \right) $$
/// $$ W_{tt} = \sum_a \left( t \cdot M_a^{-1} t + \frac{c_{an}^2}{I_a} \right) $$
/// $$ W_{nt} = \sum_a \left( n \cdot M_a^{-1} t - \frac{c_{an} c_{at}}{I_a} \right) $$
///
/// All in 1/kg. $M_a$ is diagonal; its two entries differ only for a wall that is driven in one direction.
///
/// # Errata and departures
/// The minus sign is missing in print: azema E2.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Delassus {
    /// Normal response to a normal impulse in 1/kg.
    pub nn: f64,
    /// Tangential response to a tangential impulse in 1/kg.
    pub tt: f64,
    /// Response of one direction to an impulse in the other in 1/kg.
    pub nt: f64,
}

impl PointKinematics {
    /// The kinematics of a point with the given arms in m.
    #[inline]
    pub fn new(units: [u32; 2], normal: Vec2, arms: [Vec2; 2]) -> Self {
        let components = |arm: Vec2| Components {
            n: normal.dot(arm),
            t: normal.cross(arm),
        };
        Self {
            units,
            normal,
            arms: arms.map(components),
        }
    }

    /// Velocity of the second unit relative to the first at the point in m/s.
    #[inline]
    pub fn relative_velocity(&self, velocities: &[Velocity]) -> Components {
        self.velocity_of(self.units.map(|unit| velocities[unit as usize]))
    }

    /// Velocity of the second unit relative to the first at the point in m/s, from the velocities of the two.
    #[inline]
    pub fn velocity_of(&self, [first, second]: [Velocity; 2]) -> Components {
        let [one, other] = self.arms;
        let linear = second.linear - first.linear;
        Components {
            n: self.normal.dot(linear) + (first.angular * one.t - second.angular * other.t),
            t: self.normal.cross(linear) + (second.angular * other.n - first.angular * one.n),
        }
    }

    /// Add the effect of an impulse in kg m/s to the velocities of both units.
    #[inline]
    pub fn apply(
        &self,
        impulse: Components,
        inverse_masses: &[InverseMass],
        velocities: &mut [Velocity],
    ) {
        let [i, j] = self.units.map(|unit| unit as usize);
        let inverse = [inverse_masses[i], inverse_masses[j]];
        [velocities[i], velocities[j]] =
            self.pushed(impulse, inverse, [velocities[i], velocities[j]]);
    }

    /// The velocities of both units after an impulse in kg m/s.
    #[inline(always)]
    pub(crate) fn pushed(
        &self,
        impulse: Components,
        inverse: [InverseMass; 2],
        [mut first, mut second]: [Velocity; 2],
    ) -> [Velocity; 2] {
        let vector = self.normal * impulse.n + self.normal.perpendicular() * impulse.t;
        let [one, other] = self.arms;
        let moments = [
            one.n * impulse.t - one.t * impulse.n,
            other.n * impulse.t - other.t * impulse.n,
        ];
        first.linear.x -= inverse[0].x * vector.x;
        first.linear.y -= inverse[0].y * vector.y;
        first.angular -= inverse[0].rotation * moments[0];
        second.linear.x += inverse[1].x * vector.x;
        second.linear.y += inverse[1].y * vector.y;
        second.angular += inverse[1].rotation * moments[1];
        [first, second]
    }

    /// The Delassus operator of the point.
    #[inline]
    pub fn delassus(&self, inverse_masses: &[InverseMass]) -> Delassus {
        let n = self.normal;
        let mut w = Delassus::default();
        for (unit, arm) in self.units.into_iter().zip(self.arms) {
            let inverse = inverse_masses[unit as usize];
            w.nn +=
                n.x * n.x * inverse.x + n.y * n.y * inverse.y + arm.t * arm.t * inverse.rotation;
            w.tt +=
                n.y * n.y * inverse.x + n.x * n.x * inverse.y + arm.n * arm.n * inverse.rotation;
            w.nt += n.x * n.y * (inverse.y - inverse.x) - arm.n * arm.t * inverse.rotation;
        }
        w
    }
}

impl Delassus {
    /// The local problem of the point with given velocities to be stopped and friction.
    #[inline(always)]
    pub fn problem(self, a: Components, friction: f64) -> LocalProblem {
        LocalProblem {
            w_nn: self.nn,
            w_tt: self.tt,
            w_nt: self.nt,
            a_n: a.n,
            a_t: a.t,
            friction,
        }
    }
}
