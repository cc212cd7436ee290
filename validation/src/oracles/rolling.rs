//! A ball that rolls over a fixed one under gravity until it slips, in polar coordinates.
//!
//! With the distance rho of the centres, their polar angle f and the angle a of the ball, the
//! tangential spring is stretched by z = r a - (r + R) f - s, because the contact point moves along
//! both surfaces; the slip s is constant while the contact sticks. Lagrange's equations follow from the
//! energies
//!
//! T = m (rho'^2 + rho^2 f'^2) / 2 + J a'^2 / 2,
//! V = m g rho sin f + k (r + R - rho)^2 / 2 + q z^2 / 2,
//!
//! with the force of the dashpot added along rho. While the contact slips, the spring keeps the stretch
//! at which its force is mu N.

use super::flow::Flow;
use num_traits::Float;

/// Parameters of the ball and its contact.
#[derive(Clone, Copy, Debug)]
pub struct Rolling<F> {
    /// Radius of the ball in m.
    pub radius: F,
    /// Radius of the fixed ball in m.
    pub fixed_radius: F,
    /// Mass of the ball in kg; its moment of inertia is that of a homogeneous sphere.
    pub mass: F,
    /// Gravity in m/s^2.
    pub gravity: F,
    /// Normal stiffness k in kg/s^2.
    pub stiffness: F,
    /// Normal damping in kg/s.
    pub damping: F,
    /// Tangential stiffness q in kg/s^2.
    pub tangential_stiffness: F,
    /// Coefficient of friction mu.
    pub friction: F,
}

/// Whether the contact sticks, with the slip so far, or slips, and in which direction.
#[derive(Clone, Copy, Debug)]
enum Grip<F> {
    Sticks(F),
    Slips(F),
}

fn number<F: Float>(value: f64) -> F {
    F::from(value).unwrap_or_else(F::nan)
}

impl<F: Float> Rolling<F> {
    /// Position in m of the ball after a duration in s, and how often the contact began to slip.
    ///
    /// The initial position is relative to the centre of the fixed ball. The contact begins at the
    /// start under load and must not end. The duration is divided into slices, each of which begins
    /// with short steps, so that no brief slip is missed.
    pub fn advance(
        &self,
        position: [F; 2],
        (velocity, spin): ([F; 2], F),
        duration: F,
        slices: u32,
        tolerance: F,
    ) -> ([F; 2], u32) {
        let ([x, y], [u, v]) = (position, velocity);
        let rho = x.hypot(y);
        let turn = (x * v - y * u) / (rho * rho);
        let mut state = [
            rho,
            y.atan2(x),
            (x * u + y * v) / rho,
            turn,
            F::zero(),
            spin,
        ];
        let origin = state[1];
        let mut grip = Grip::Sticks(F::zero());
        let (slice, mut slips) = (duration / number(f64::from(slices)), 0);
        for _ in 0..slices {
            let mut left = slice;
            while left > F::zero() {
                let flow = Flow {
                    rate: |_, y: &[F; 6]| self.rates(grip, origin, y),
                    tolerance,
                };
                let (time, next) = flow.until(state, left, |_, y| self.guard(grip, origin, y));
                (state, left) = (next, left - time);
                if self.guard(grip, origin, &state) <= F::zero() {
                    slips += u32::from(matches!(grip, Grip::Sticks(_)));
                    grip = self.changed(grip, origin, &state);
                }
            }
        }
        (
            [state[0] * state[1].cos(), state[0] * state[1].sin()],
            slips,
        )
    }

    /// Tangential displacement without slip, and its rate.
    fn displacement(&self, origin: F, y: &[F; 6]) -> [F; 2] {
        let reach = self.radius + self.fixed_radius;
        [
            self.radius * y[4] - reach * (y[1] - origin),
            self.radius * y[5] - reach * y[3],
        ]
    }

    fn normal_force(&self, y: &[F; 6]) -> F {
        self.stiffness * (self.radius + self.fixed_radius - y[0]) - self.damping * y[2]
    }

    /// Tension of the spring in N.
    fn tension(&self, grip: Grip<F>, origin: F, y: &[F; 6]) -> F {
        match grip {
            Grip::Sticks(slip) => {
                self.tangential_stiffness * (self.displacement(origin, y)[0] - slip)
            }
            Grip::Slips(sign) => sign * self.friction * self.normal_force(y),
        }
    }

    fn rates(&self, grip: Grip<F>, origin: F, y: &[F; 6]) -> [F; 6] {
        let [rho, angle, d_rho, d_angle, _, spin] = *y;
        let tension = self.tension(grip, origin, y);
        let inertia = number::<F>(0.4) * self.mass * self.radius * self.radius;
        let weight = self.mass * self.gravity;
        let along = (self.radius + self.fixed_radius) * tension - weight * rho * angle.cos();
        let radial = self.normal_force(y) - weight * angle.sin();
        [
            d_rho,
            d_angle,
            radial / self.mass + rho * d_angle * d_angle,
            along / (self.mass * rho * rho) - number::<F>(2.0) * d_rho * d_angle / rho,
            spin,
            -self.radius * tension / inertia,
        ]
    }

    /// Positive until sticking or slipping ends.
    fn guard(&self, grip: Grip<F>, origin: F, y: &[F; 6]) -> F {
        match grip {
            Grip::Sticks(_) => {
                self.friction * self.normal_force(y) - self.tension(grip, origin, y).abs()
            }
            Grip::Slips(sign) => {
                let rates = self.rates(grip, origin, y);
                let growth = -(self.stiffness * y[2] + self.damping * rates[2]);
                sign * self.tangential_stiffness * self.displacement(origin, y)[1]
                    - self.friction * growth
            }
        }
    }

    fn changed(&self, grip: Grip<F>, origin: F, y: &[F; 6]) -> Grip<F> {
        let tension = self.tension(grip, origin, y);
        match grip {
            Grip::Sticks(_) => Grip::Slips(tension.signum()),
            Grip::Slips(_) => {
                Grip::Sticks(self.displacement(origin, y)[0] - tension / self.tangential_stiffness)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Rolling;
    use approx::abs_diff_eq;
    use xprec::Df64;

    /// With stiff springs the ball rolls as on a rigid surface: 7/10 m v^2 grows by the potential
    /// energy lost.
    #[test]
    fn a_ball_that_rolls_keeps_its_energy() {
        let number = |x: f64| Df64::from(x);
        let ball = Rolling {
            radius: number(1.0),
            fixed_radius: number(1.0),
            mass: number(1.0),
            gravity: number(1.0),
            stiffness: number(1e4),
            damping: number(1e2),
            tangential_stiffness: number(1e4),
            friction: number(1e3),
        };
        let start = [0.2_f64.sin(), 0.2_f64.cos()].map(|x| x * (2.0 - 1e-4));
        let after = |time: f64| {
            let velocity = [0.2_f64.cos(), -0.2_f64.sin()].map(|x| number(0.1 * x));
            let end = ball.advance(
                start.map(number),
                (velocity, number(-0.1)),
                number(time),
                4,
                number(1e-12),
            );
            assert_eq!(end.1, 0);
            end.0.map(f64::from)
        };
        let (h, [x0, y0]) = (0.1, after(1.0));
        let [x1, y1] = after(1.0 + h);
        let speed = (x1 - x0).hypot(y1 - y0) / h;
        let fallen = start[1] - 0.5 * (y0 + y1);
        let gained = 0.7 * (speed * speed - 0.01);
        assert!(
            abs_diff_eq!(gained / fallen, 1.0, epsilon = 2e-2),
            "{speed}"
        );
    }
}
