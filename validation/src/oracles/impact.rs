//! The planar collision of two spheres with friction, as phases between located events.
//!
//! The state is in the moving frame: overlap and its rate, angular momentum of the centres, surface
//! speeds of both spheres. For a Hertzian contact the overlap is s^2 and time runs as dt = s dT, which
//! makes every phase analytic, including the beginning of the contact. A rigid plane does not
//! contribute to the reduced mass and has an inverse reach of zero.

use super::flow::Flow;
use super::oscillator::truncated_restitution;
use statrs::function::beta::{beta, beta_reg};
use std::f64::consts::PI;

/// Normal force, truncated to repulsion.
#[derive(Clone, Copy, Debug)]
pub enum Normal {
    /// Stiffness in kg/s^2, damping in kg/s.
    Linear([f64; 2]),
    /// Factor of the overlap to the power 3/2 in N/m^(3/2), dissipative constant in s.
    Hertzian([f64; 2]),
}

/// Tangential force.
#[derive(Clone, Copy, Debug)]
pub enum Tangential {
    /// Friction coefficient, and damping in kg/s: viscous up to the Coulomb limit.
    Viscous([f64; 2]),
    /// Friction coefficient, and stiffness in kg/s^2: a spring truncated at the Coulomb limit.
    Spring([f64; 2]),
}

/// A pair of spheres, or a sphere and a rigid plane.
#[derive(Clone, Copy, Debug)]
pub struct Impact {
    /// Normal law.
    pub normal: Normal,
    /// Tangential law.
    pub tangential: Tangential,
    /// Reduced mass in kg.
    pub mass: f64,
    /// Squared radius over moment of inertia, of both, in 1/kg; zero for a plane.
    pub compliance: [f64; 2],
    /// Inverse of the sum of the radii in 1/m; zero for a plane.
    pub inverse_reach: f64,
}

/// Motion of a pair at the beginning or end of its contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Rate of the overlap in m/s.
    pub approach: f64,
    /// Tangential velocity of the second relative to the first, as angular momentum over the sum of the
    /// radii, in m/s.
    pub shear: f64,
    /// Radius times angular velocity of both in m/s.
    pub surface: [f64; 2],
}

/// A moment of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    /// Time since the contact began in s.
    pub time: f64,
    /// Overlap in m.
    pub overlap: f64,
    /// Magnitude of the normal force in N.
    pub normal_force: f64,
    /// Motion.
    pub motion: Motion,
}

/// The phase of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// Below the Coulomb limit.
    Held,
    /// At the Coulomb limit, sliding in the direction of the sign.
    Slides(f64),
}

/// Overlap or its square root, its rate, time, shear, both surface speeds, stretch of the spring.
type State = [f64; 7];

/// Force at which a contact counts as over, in units of momentum over duration: below it, friction is
/// comparable to the rounding of the sliding velocity, and its events are meaningless.
const SPENT: f64 = 1e-12;
/// An upper bound for the number of phases of a contact.
const LONGEST: usize = 4096;
/// Error of a component per step of the integration.
const TOLERANCE: f64 = 2e-14;

impl Normal {
    /// Overlap in m.
    fn overlap(self, s: f64) -> f64 {
        match self {
            Self::Linear(_) => s,
            Self::Hertzian(_) => s * s,
        }
    }
    /// Rate of time.
    fn clock(self, s: f64) -> f64 {
        match self {
            Self::Linear(_) => 1.0,
            Self::Hertzian(_) => s,
        }
    }
    /// Rate of the first component.
    fn climb(self, v: f64) -> f64 {
        match self {
            Self::Linear(_) => v,
            Self::Hertzian(_) => 0.5 * v,
        }
    }
    /// Repulsion in N, negative beyond the end of the contact.
    fn force(self, s: f64, v: f64) -> f64 {
        match self {
            Self::Linear([k, gamma]) => k * s + gamma * v,
            Self::Hertzian([p, lambda]) => p * s * (s * s + lambda * v),
        }
    }
    /// Rate of the repulsion, from the rate of v.
    fn force_rate(self, s: f64, v: f64, dv: f64) -> f64 {
        match self {
            Self::Linear([k, gamma]) => k * v + gamma * dv,
            Self::Hertzian([p, lambda]) => p * (1.5 * s * s * v + lambda * (0.5 * v * v + s * dv)),
        }
    }
    /// Duration of the collision without dissipation in s, and its largest overlap in m.
    pub fn elastic(self, mass: f64, speed: f64) -> [f64; 2] {
        match self {
            Self::Linear([k, _]) => {
                let w = (k / mass).sqrt();
                [PI / w, speed / w]
            }
            Self::Hertzian([p, _]) => {
                let deepest = (1.25 * mass * speed * speed / p).powf(0.4);
                [0.8 * beta(0.4, 0.5) * deepest / speed, deepest]
            }
        }
    }
}

impl Impact {
    /// Moments of the contact up to its end, about the given number plus those of events, from an
    /// approaching motion; none if the phases do not end.
    pub fn run(&self, start: Motion, moments: u32) -> Option<Vec<Moment>> {
        let [duration, deepest] = self.normal.elastic(self.mass, start.approach);
        let [p, q] = start.surface;
        let speed = start.approach + start.shear.abs() + p.abs() + q.abs();
        let course = Course {
            impact: *self,
            lift: [duration, speed, deepest],
        };
        let chunk = duration / self.normal.clock(deepest.sqrt()) / f64::from(moments);
        let mut y: State = [
            0.0,
            start.approach,
            duration,
            start.shear + speed,
            p + speed,
            q + speed,
            deepest,
        ];
        let mut phase = course.first_phase(&y);
        let mut moments = vec![course.moment(&y)];
        for _ in 0..LONGEST {
            let flow = Flow {
                rate: |_, y: &State| course.rate(phase, y),
                tolerance: TOLERANCE,
            };
            let event = |_, y: &State| course.force(y).min(course.margin(phase, y));
            let (_, end) = flow.until(y, chunk, event);
            let happens = event(0.0, &end) <= 0.0;
            y = end;
            moments.push(course.moment(&y));
            if happens && course.force(&y) <= SPENT * self.mass * start.approach / duration {
                return Some(moments);
            }
            if happens {
                (phase, y) = course.next_phase(phase, y);
            }
        }
        None
    }

    /// The motion after the contact.
    pub fn rebound(&self, start: Motion) -> Option<Motion> {
        self.run(start, 3)?.last().map(|moment| moment.motion)
    }

    fn friction(&self) -> f64 {
        let (Tangential::Viscous([mu, _]) | Tangential::Spring([mu, _])) = self.tangential;
        mu
    }
}

/// An impact with offsets added to time, speeds and stretch, so that no component of the state begins
/// at zero with zero slope, where a relative error would be meaningless.
#[derive(Clone, Copy)]
struct Course {
    impact: Impact,
    lift: [f64; 3],
}

impl Course {
    /// Sum of the radii over the distance.
    fn stretch(&self, s: f64) -> f64 {
        1.0 / (1.0 - self.impact.normal.overlap(s) * self.impact.inverse_reach)
    }

    fn shear(&self, y: &State) -> f64 {
        y[3] - self.lift[1]
    }

    /// Sliding velocity in m/s.
    fn slip(&self, y: &State) -> f64 {
        let stretch = self.stretch(y[0]);
        (y[4] - self.lift[1]) + (y[5] - self.lift[1]) - self.shear(y) * stretch * stretch
    }

    /// Length of the spring in m.
    fn spring(&self, y: &State) -> f64 {
        y[6] - self.lift[2]
    }

    fn force(&self, y: &State) -> f64 {
        self.impact.normal.force(y[0], y[1])
    }

    fn tangential_force(&self, phase: Phase, y: &State) -> f64 {
        match (phase, self.impact.tangential) {
            (Phase::Slides(sign), _) => -sign * self.impact.friction() * self.force(y),
            (Phase::Held, Tangential::Viscous([_, gamma])) => -gamma * self.slip(y),
            (Phase::Held, Tangential::Spring([_, k])) => -k * self.spring(y),
        }
    }

    fn rate(&self, phase: Phase, y: &State) -> State {
        let Impact {
            normal,
            mass,
            compliance,
            inverse_reach,
            ..
        } = self.impact;
        let [s, v, ..] = *y;
        let clock = normal.clock(s);
        let f = clock * self.tangential_force(phase, y);
        let flung = self.shear(y).powi(2) * inverse_reach * self.stretch(s).powi(3);
        [
            normal.climb(v),
            -clock * (self.force(y) / mass + flung),
            clock,
            -f / mass,
            f * compliance[0],
            f * compliance[1],
            clock * self.slip(y),
        ]
    }

    /// Positive until the phase ends.
    fn margin(&self, phase: Phase, y: &State) -> f64 {
        let limit = self.impact.friction() * self.force(y);
        match (phase, self.impact.tangential) {
            (Phase::Held, Tangential::Viscous([_, gamma])) => limit - gamma * self.slip(y).abs(),
            (Phase::Held, Tangential::Spring([_, k])) => limit - k * self.spring(y).abs(),
            (Phase::Slides(_), Tangential::Viscous([_, gamma])) => {
                gamma * self.slip(y).abs() - limit
            }
            (Phase::Slides(sign), Tangential::Spring([mu, k])) => {
                let [s, v, ..] = *y;
                let dv = self.rate(phase, y)[1];
                let normal = self.impact.normal;
                let rate = normal.force_rate(s, v, dv);
                sign * self.slip(y) * normal.clock(s) * k - mu * rate
            }
        }
    }

    /// Whether the contact slides from the start.
    fn first_phase(&self, y: &State) -> Phase {
        let slip = self.slip(y);
        let mu = self.impact.friction();
        let is_held = match (self.impact.tangential, self.impact.normal) {
            (Tangential::Viscous([_, gamma]), _) => gamma * slip.abs() <= mu * self.force(y),
            (Tangential::Spring(_), Normal::Hertzian([_, lambda])) => lambda > 0.0,
            (Tangential::Spring([_, kt]), Normal::Linear([k, gamma])) => {
                gamma > 0.0 || kt * slip.abs() <= mu * k * y[1]
            }
        };
        if is_held || slip == 0.0 {
            Phase::Held
        } else {
            Phase::Slides(slip.signum())
        }
    }

    fn next_phase(&self, phase: Phase, mut y: State) -> (Phase, State) {
        match (phase, self.impact.tangential) {
            (Phase::Held, Tangential::Viscous(_)) => (Phase::Slides(self.slip(&y).signum()), y),
            (Phase::Held, Tangential::Spring(_)) => (Phase::Slides(self.spring(&y).signum()), y),
            (Phase::Slides(sign), Tangential::Spring([mu, k])) => {
                y[6] = self.lift[2] + sign * mu * self.force(&y) / k;
                (Phase::Held, y)
            }
            (Phase::Slides(_), Tangential::Viscous(_)) => (Phase::Held, y),
        }
    }

    fn moment(&self, y: &State) -> Moment {
        let [time, speed, _] = self.lift;
        Moment {
            time: y[2] - time,
            overlap: self.impact.normal.overlap(y[0]),
            normal_force: self.force(y).max(0.0),
            motion: Motion {
                approach: y[1],
                shear: y[3] - speed,
                surface: [y[4] - speed, y[5] - speed],
            },
        }
    }
}

/// Time of an elastic Hertzian collision, in units of largest overlap over impact speed, at an overlap
/// over the largest overlap and a rate over the impact speed.
///
/// t = (2/5) B(z; 2/5, 1/2) with z = xi^(5/2) = 1 - v^2 during loading, mirrored during unloading; z is
/// taken from whichever of the two determines it more accurately.
pub fn time_of_elastic_overlap(overlap: f64, rate: f64) -> f64 {
    let by_overlap = overlap.max(0.0).powf(2.5);
    let z = if by_overlap < 0.5 {
        by_overlap
    } else {
        1.0 - rate * rate
    };
    let time = 0.4 * beta_inc(0.4, 0.5, z.clamp(0.0, 1.0));
    if rate > 0.0 {
        time
    } else {
        0.8 * beta(0.4, 0.5) - time
    }
}

/// Incomplete beta function, not regularised.
fn beta_inc(a: f64, b: f64, x: f64) -> f64 {
    beta_reg(a, b, x) * beta(a, b)
}

/// Restitution of a head-on collision.
pub fn restitution(normal: Normal, mass: f64, speed: f64) -> Option<f64> {
    let impact = Impact {
        normal,
        tangential: Tangential::Spring([1.0, 1.0]),
        mass,
        compliance: [0.0; 2],
        inverse_reach: 0.0,
    };
    let start = Motion {
        approach: speed,
        shear: 0.0,
        surface: [0.0; 2],
    };
    Some(-impact.rebound(start)?.approach / speed)
}

/// Dissipative constant of a Hertzian contact with the given restitution, in units of the duration of
/// its elastic collision; in this unit the restitution depends on nothing else. Secant method in the
/// logarithm.
pub fn dissipative_constant(wanted: f64) -> Option<f64> {
    if wanted >= 1.0 {
        return Some(0.0);
    }
    let [duration, _] = Normal::Hertzian([1.0, 0.0]).elastic(1.0, 1.0);
    let excess = |log: f64| {
        let law = Normal::Hertzian([1.0, log.exp() * duration]);
        Some(restitution(law, 1.0, 1.0)?.ln() - wanted.ln())
    };
    let mut x = [
        (0.4 * (1.0 - wanted)).ln(),
        (0.6 * (1.0 / wanted - 1.0)).ln(),
    ];
    let mut y = [excess(x[0])?, excess(x[1])?];
    for _ in 0..32 {
        if y[1].abs() < 1e-14 || (x[1] - x[0]).abs() < 1e-14 {
            break;
        }
        let next = x[1] - y[1] * (x[1] - x[0]) / (y[1] - y[0]);
        (x, y) = ([x[1], next], [y[1], excess(next)?]);
    }
    Some(x[1].exp())
}

/// Damping ratio of a truncated linear contact with the given restitution; by bisection.
pub fn damping_ratio(wanted: f64) -> f64 {
    if wanted >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 100.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if truncated_restitution(middle) > wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::abs_diff_eq;

    #[test]
    fn a_linear_collision_has_the_restitution_of_the_closed_form() {
        for zeta in [0.05, 0.5, 0.99] {
            let e = restitution(Normal::Linear([1.0, 2.0 * zeta]), 1.0, 1.0);
            let expected = truncated_restitution(zeta);
            assert!(
                e.is_some_and(|e| abs_diff_eq!(e, expected, epsilon = 1e-12)),
                "{e:?}"
            );
        }
    }

    #[test]
    fn the_dissipative_constant_inverts_the_restitution() {
        let [duration, _] = Normal::Hertzian([1.0, 0.0]).elastic(1.0, 1.0);
        for wanted in [0.98, 0.5, 0.2] {
            let found = dissipative_constant(wanted)
                .and_then(|c| restitution(Normal::Hertzian([1.0, c * duration]), 1.0, 1.0));
            assert!(
                found.is_some_and(|e| abs_diff_eq!(e, wanted, epsilon = 1e-12)),
                "{wanted} {found:?}"
            );
        }
        // To first order 1 - e is 1.15345 times the dissipative constant in units of (v^2 /
        // kappa)^(2/5) / v.
        let unit = duration;
        let small = dissipative_constant(0.9999).map(|c| c * unit * 1.15345);
        assert!(
            small.is_some_and(|x| abs_diff_eq!(x / 1e-4, 1.0, epsilon = 1e-4)),
            "{small:?}"
        );
    }

    #[test]
    fn sliding_ends_in_the_rolling_of_a_rigid_body() {
        // A strongly viscous contact ends without slip: two sevenths of the speed are lost.
        let impact = Impact {
            normal: Normal::Hertzian([1.0, 0.0]),
            tangential: Tangential::Viscous([10.0, 100.0]),
            mass: 1.0,
            compliance: [2.5, 0.0],
            inverse_reach: 0.0,
        };
        let start = Motion {
            approach: 1.0,
            shear: -1.0,
            surface: [0.0; 2],
        };
        let end = impact.rebound(start);
        assert!(
            end.is_some_and(|end| abs_diff_eq!(end.shear, -5.0 / 7.0, epsilon = 1e-9)),
            "{end:?}"
        );
    }
}
