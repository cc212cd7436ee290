//! Grains without friction, integrated to high order from event to event.
//!
//! Between the moments at which a pair touches, stops pressing or separates, the motion is smooth and
//! [`Flow`] follows it; the moments are located to rounding. It is generic over the number type.

use super::flow::Flow;
use num_traits::Float;

/// Repulsion of a pair with overlap xi in m; negative forces are truncated to zero.
#[derive(Clone, Copy, Debug)]
pub enum Repulsion<F> {
    /// k xi + c xi', in N.
    SpringDashpot {
        /// Stiffness k in kg/s^2.
        stiffness: F,
        /// Damping c in kg/s.
        damping: F,
    },
    /// 2/3 Y / (1 - nu^2) sqrt(R xi) (xi + L xi'), in N, with R the reduced radius.
    Viscoelastic {
        /// Plane modulus Y / (1 - nu^2) in Pa.
        modulus: F,
        /// Dissipative constant L in s.
        dissipation: F,
    },
}

impl<F: Float> Repulsion<F> {
    /// A number with the sign of the untruncated force.
    fn tendency(&self, xi: F, rate: F) -> F {
        match *self {
            Self::SpringDashpot { stiffness, damping } => stiffness * xi + damping * rate,
            Self::Viscoelastic { dissipation, .. } => xi + dissipation * rate,
        }
    }
    fn force(&self, reduced_radius: F, xi: F, rate: F) -> F {
        let tendency = self.tendency(xi, rate);
        match *self {
            Self::SpringDashpot { .. } => tendency,
            Self::Viscoelastic { modulus, .. } => {
                let two_thirds = number::<F>(2.0) / number(3.0);
                two_thirds * modulus * (reduced_radius * xi.max(F::zero())).sqrt() * tendency
            }
        }
    }
}

fn number<F: Float>(value: f64) -> F {
    F::from(value).unwrap_or_else(F::nan)
}

/// One grain: radius in m and inverse mass in 1/kg, zero for a fixed one.
#[derive(Clone, Copy, Debug)]
pub struct Grain<F> {
    /// Radius in m.
    pub radius: F,
    /// Inverse mass in 1/kg.
    pub inverse_mass: F,
}

/// Grains, their repulsion and the external fields.
#[derive(Clone, Debug)]
pub struct Grains<F> {
    /// The grains.
    pub grains: Vec<Grain<F>>,
    /// The force between them.
    pub repulsion: Repulsion<F>,
    /// Stokes drag over radius and velocity, 6 pi eta, in Pa s.
    pub drag: F,
    /// Stiffness in kg/s^2 and height in m of the centre line of a harmonic well.
    pub well: [F; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Apart,
    Pressing,
    /// Overlapping, but separating faster than the contact can follow.
    Released,
}

/// The state of a pair: overlap, its rate, and the unit vector from the first to the second grain.
struct Meeting<F> {
    xi: F,
    rate: F,
    normal: [F; 2],
}

struct Pairs {
    pairs: Vec<(usize, usize)>,
    phases: Vec<Phase>,
}

impl<F: Float> Grains<F> {
    /// State after a duration in s; a state holds x, y and their rates for one grain after the other.
    ///
    /// Events are detected at the ends of steps. The duration is divided into slices, each of which
    /// begins with short steps, so that no brief contact is missed. The tolerance must allow for the
    /// digits that an overlap loses relative to a distance.
    pub fn advance<const N: usize>(
        &self,
        start: [F; N],
        duration: F,
        slices: u32,
        tolerance: F,
    ) -> [F; N] {
        let mut state = start;
        let mut pairs = self.pairs(&state);
        let slice = duration / number(f64::from(slices));
        for _ in 0..slices {
            let mut left = slice;
            while left > F::zero() {
                let flow = Flow {
                    rate: |_, y: &[F; N]| self.rates(&pairs, y),
                    tolerance,
                };
                let guard = |_, y: &[F; N]| {
                    let all = (0..pairs.pairs.len()).map(|at| self.guard(&pairs, at, y));
                    all.fold(F::infinity(), F::min)
                };
                let (time, next) = flow.until(state, left, guard);
                (state, left) = (next, left - time);
                self.pass_events(&mut pairs, &state);
            }
        }
        state
    }

    fn pairs<const N: usize>(&self, state: &[F; N]) -> Pairs {
        let moves = |i: usize| self.grains[i].inverse_mass > F::zero();
        let number = self.grains.len();
        let all = (0..number).flat_map(|i| (i + 1..number).map(move |j| (i, j)));
        let pairs: Vec<(usize, usize)> = all.filter(|&(i, j)| moves(i) || moves(j)).collect();
        let phase = |&pair: &(usize, usize)| {
            let meeting = self.meeting(pair, state);
            if meeting.xi <= F::zero() {
                Phase::Apart
            } else if self.repulsion.tendency(meeting.xi, meeting.rate) > F::zero() {
                Phase::Pressing
            } else {
                Phase::Released
            }
        };
        let phases = pairs.iter().map(phase).collect();
        Pairs { pairs, phases }
    }

    fn meeting<const N: usize>(&self, (i, j): (usize, usize), y: &[F; N]) -> Meeting<F> {
        let gap = |k: usize| y[4 * j + k] - y[4 * i + k];
        let (dx, dy) = (gap(0), gap(1));
        let distance = (dx * dx + dy * dy).sqrt();
        let normal = [dx / distance, dy / distance];
        Meeting {
            xi: self.grains[i].radius + self.grains[j].radius - distance,
            rate: -(gap(2) * normal[0] + gap(3) * normal[1]),
            normal,
        }
    }

    fn rates<const N: usize>(&self, pairs: &Pairs, y: &[F; N]) -> [F; N] {
        let mut rates = [F::zero(); N];
        for (i, grain) in self.grains.iter().enumerate() {
            let at = 4 * i;
            if grain.inverse_mass > F::zero() {
                let drag = self.drag * grain.radius;
                let pull = self.well[0] * (self.well[1] - y[at + 1]);
                rates[at] = y[at + 2];
                rates[at + 1] = y[at + 3];
                rates[at + 2] = -drag * y[at + 2] * grain.inverse_mass;
                rates[at + 3] = (pull - drag * y[at + 3]) * grain.inverse_mass;
            }
        }
        let pressing = pairs.pairs.iter().zip(&pairs.phases);
        for (&(i, j), _) in pressing.filter(|(_, phase)| **phase == Phase::Pressing) {
            let meeting = self.meeting((i, j), y);
            let (a, b) = (self.grains[i], self.grains[j]);
            let reduced = a.radius * b.radius / (a.radius + b.radius);
            let force = self.repulsion.force(reduced, meeting.xi, meeting.rate);
            for k in 0..2 {
                let push = force * meeting.normal[k];
                rates[4 * i + 2 + k] = rates[4 * i + 2 + k] - push * a.inverse_mass;
                rates[4 * j + 2 + k] = rates[4 * j + 2 + k] + push * b.inverse_mass;
            }
        }
        rates
    }

    /// Positive until the phase of the pair changes.
    fn guard<const N: usize>(&self, pairs: &Pairs, at: usize, y: &[F; N]) -> F {
        let Meeting { xi, rate, .. } = self.meeting(pairs.pairs[at], y);
        match pairs.phases[at] {
            Phase::Apart => -xi,
            Phase::Pressing => self.repulsion.tendency(xi, rate),
            Phase::Released => xi.min(-self.repulsion.tendency(xi, rate)),
        }
    }

    fn pass_events<const N: usize>(&self, pairs: &mut Pairs, y: &[F; N]) {
        for at in 0..pairs.pairs.len() {
            if self.guard(pairs, at, y) > F::zero() {
                continue;
            }
            let xi = self.meeting(pairs.pairs[at], y).xi;
            pairs.phases[at] = match pairs.phases[at] {
                Phase::Apart => Phase::Pressing,
                Phase::Pressing => Phase::Released,
                Phase::Released if xi <= F::zero() => Phase::Apart,
                Phase::Released => Phase::Pressing,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Grain, Grains, Repulsion};
    use crate::oracles::oscillator::truncated_restitution;
    use approx::assert_abs_diff_eq;

    #[test]
    fn a_bounce_loses_what_the_closed_form_says() {
        let grain = |inverse_mass| Grain {
            radius: 1.0,
            inverse_mass,
        };
        let zeta: f64 = 0.3;
        let grains = Grains {
            grains: vec![grain(0.0), grain(1.0)],
            repulsion: Repulsion::SpringDashpot {
                stiffness: 1.0,
                damping: 2.0 * zeta,
            },
            drag: 0.0,
            well: [0.0; 2],
        };
        let start = [0.0, 0.0, 0.0, 0.0, 3.0, 0.0, -0.1, 0.0];
        let end = grains.advance(start, 20.0, 50, 1e-11);
        let restitution: f64 = end[6] / 0.1;
        assert_abs_diff_eq!(restitution, truncated_restitution(zeta), epsilon = 1e-9);
    }
}
