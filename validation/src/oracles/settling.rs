//! A sphere that settles in a medium at rest.

use super::flow::Flow;
use std::f64::consts::PI;

/// A sphere and its medium.
#[derive(Clone, Copy, Debug)]
pub struct Settling {
    /// Radius in m.
    pub radius: f64,
    /// Density of the sphere in kg/m^3.
    pub density: f64,
    /// Density of the medium in kg/m^3.
    pub medium: f64,
    /// Dynamic viscosity in Pa s.
    pub viscosity: f64,
    /// Acceleration of gravity in m/s^2; there is no buoyancy.
    pub gravity: f64,
}

impl Settling {
    /// Relaxation times of velocity and spin in creeping flow in s: 2 rho r^2 / (9 eta), rho r^2 / (15 eta).
    pub fn relaxation(&self) -> [f64; 2] {
        let scale = self.density * self.radius * self.radius / self.viscosity;
        [2.0 / 9.0 * scale, scale / 15.0]
    }
    /// Distance in m and speed in m/s in creeping flow, after a time from rest.
    pub fn creeping(&self, time: f64) -> [f64; 2] {
        let [tau, _] = self.relaxation();
        let gained = -(-time / tau).exp_m1();
        let terminal = self.gravity * tau;
        [terminal * (time - tau * gained), terminal * gained]
    }
    /// Deceleration in m/s^2 at a speed, with the drag coefficient 24 / Re + 3 / sqrt(Re) + c.
    fn retardation(&self, speed: f64, constant: f64) -> f64 {
        let re = self.medium * speed * 2.0 * self.radius / self.viscosity;
        if re <= 0.0 {
            return 0.0;
        }
        let coefficient = 24.0 / re + 3.0 / re.sqrt() + constant;
        let area = PI * self.radius * self.radius;
        let mass = 4.0 / 3.0 * PI * self.density * self.radius.powi(3);
        0.5 * self.medium * speed * speed * area * coefficient / mass
    }
    /// Terminal speed in m/s with that drag, by bisection.
    pub fn terminal(&self, constant: f64) -> f64 {
        let (mut low, mut high) = (0.0, self.gravity * self.relaxation()[0]);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if self.retardation(middle, constant) < self.gravity {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }
    /// Speed in m/s with that drag, after a time from rest, by integration in the square root of the
    /// speed, in which the drag is analytic.
    pub fn speed(&self, constant: f64, time: f64) -> f64 {
        let flow = Flow {
            // With v = s^2 and dt = s dT: s' = a / 2. The second component is the time, with an offset
            // so that it does not begin at zero with zero slope.
            rate: |_, y: &[f64; 2]| {
                let speed = y[0] * y[0];
                [
                    0.5 * (self.gravity - self.retardation(speed, constant)),
                    y[0],
                ]
            },
            tolerance: 1e-14,
        };
        let latest = 4.0 * (time / self.gravity).sqrt() + 4.0 * time;
        let (_, end) = flow.until([0.0, time], latest, |_, y| 2.0 * time - y[1]);
        end[0] * end[0]
    }
}
