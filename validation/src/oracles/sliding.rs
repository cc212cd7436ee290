//! Two equal spheres with equal spins that collide head on: their motion while they slide on each
//! other.

use super::flow::Flow;
use std::f64::consts::PI;

/// Two equal spheres with linear normal springs and friction at its limit.
#[derive(Clone, Copy, Debug)]
pub struct Rubbing {
    /// Radius in m.
    pub radius: f64,
    /// Density in kg/m^3.
    pub density: f64,
    /// Normal stiffness in kg/s^2.
    pub stiffness: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Stiffness of the tangential spring in kg/s^2, which distinguishes the slip from the motion of
    /// the surfaces.
    pub spring: f64,
    /// Speed of each sphere in m/s.
    pub speed: f64,
    /// Angular velocity of each sphere in rad/s, positive.
    pub spin: f64,
}

/// Relative position and velocity, sum of the spins, sliding distance of the surfaces, and half the
/// integral of the rate of the friction limit over the slip.
type State = [f64; 7];

impl Rubbing {
    fn mass(&self) -> f64 {
        4.0 / 3.0 * PI * self.density * self.radius.powi(3)
    }

    /// Overlap in m and its rate in m/s.
    fn overlap(&self, y: &State) -> (f64, f64) {
        let distance = y[0].hypot(y[1]);
        (
            2.0 * self.radius - distance,
            -(y[0] * y[2] + y[1] * y[3]) / distance,
        )
    }

    /// Relative velocity of the surfaces in m/s.
    fn slide(&self, y: &State) -> f64 {
        let squared = y[0] * y[0] + y[1] * y[1];
        let turning = (y[0] * y[3] - y[1] * y[2]) / squared;
        self.radius * (y[4] - 2.0 * turning)
    }

    fn rate(&self, y: &State) -> State {
        let (r, m) = (self.radius, self.mass());
        let distance = y[0].hypot(y[1]);
        let (overlap, approach) = self.overlap(y);
        let load = self.stiffness * overlap.max(0.0);
        let limit = self.friction * load;
        // Torques of -limit r act on both; the tangential force balances their sum.
        let tangential = -2.0 * r * limit / distance;
        let along = |n: f64, t: f64| (-load * n + tangential * t) / distance;
        let force = [along(y[0], -y[1]), along(y[1], y[0])];
        let slip = self.slide(y) - self.friction * self.stiffness * approach / self.spring;
        [
            y[2],
            y[3],
            -2.0 * force[0] / m,
            -2.0 * force[1] / m,
            -2.0 * r * limit / (0.4 * m * r * r),
            self.slide(y),
            0.5 * self.friction * self.stiffness * approach * slip,
        ]
    }

    fn start(&self) -> State {
        // Along (3, 4) / 5, so that no component is zero, for which a relative error would be
        // meaningless.
        let (gap, speed) = (2.0 * self.radius, 2.0 * self.speed);
        let spin = 2.0 * self.spin;
        [
            0.6 * gap,
            0.8 * gap,
            -0.6 * speed,
            -0.8 * speed,
            spin,
            0.0,
            0.0,
        ]
    }

    fn latest(&self) -> f64 {
        2.0 * PI / (2.0 * self.stiffness / self.mass()).sqrt()
    }

    /// Half the integral of the rate of the friction limit over the slip, in W, from first touch to
    /// separation, if the surfaces slide throughout.
    pub fn lag(&self) -> f64 {
        let flow = Flow {
            rate: |_: f64, y: &State| self.rate(y),
            tolerance: 1e-11,
        };
        flow.until(self.start(), self.latest(), |_, y| self.overlap(y).0)
            .1[6]
    }

    /// Time in s at which the surfaces stop sliding, and the sliding distance up to then in m.
    pub fn stop(&self) -> (f64, f64) {
        let flow = Flow {
            rate: |_: f64, y: &State| self.rate(y),
            tolerance: 1e-11,
        };
        let (time, end) = flow.until(self.start(), self.latest(), |_, y| self.slide(y));
        (time, end[5])
    }
}
