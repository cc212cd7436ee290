//! Spheres under gravity on damped springs, in closed form.

use nalgebra::{Matrix5, Vector5};

/// A damped spring that carries a mass under gravity.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// Stiffness over mass in 1/s^2.
    pub stiffness: f64,
    /// Damping over mass in 1/s, below critical.
    pub damping: f64,
    /// Acceleration of gravity in m/s^2, towards the spring.
    pub gravity: f64,
}

/// The end of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Release {
    /// Duration of the contact in s.
    pub time: f64,
    /// Remaining overlap in m.
    pub overlap: f64,
    /// Speed away from the spring in m/s.
    pub speed: f64,
}

impl Spring {
    /// Overlap in m and its rate in m/s, at a time after contact began at the given speed.
    ///
    /// The solution of x'' + 2 b x' + w0^2 x = g with x(0) = 0 and x'(0) = v.
    pub fn state(&self, speed: f64, time: f64) -> [f64; 2] {
        let b = 0.5 * self.damping;
        let w = (self.stiffness - b * b).sqrt();
        let rest = self.gravity / self.stiffness;
        let (cosine, sine) = (-rest, (speed - b * rest) / w);
        let (sin, cos) = (w * time).sin_cos();
        let decay = (-b * time).exp();
        let x = cosine * cos + sine * sin;
        let dx = w * (sine * cos - cosine * sin) - b * x;
        [rest + decay * x, decay * dx]
    }

    /// The time at which the force k x + c x' first vanishes, where a contact that does not attract
    /// ends.
    pub fn release(&self, speed: f64) -> Release {
        self.first(speed, |[x, v]| self.stiffness * x + self.damping * v)
    }

    /// The time at which the overlap vanishes, where a contact that may attract ends.
    pub fn separation(&self, speed: f64) -> Release {
        self.first(speed, |[x, _]| x)
    }

    /// First zero, after half a period, of a function that is positive before; by bisection.
    fn first(&self, speed: f64, function: impl Fn([f64; 2]) -> f64) -> Release {
        let b = 0.5 * self.damping;
        let period = std::f64::consts::TAU / (self.stiffness - b * b).sqrt();
        let ends = |time: f64| function(self.state(speed, time)) <= 0.0;
        let slice = period / 256.0;
        let count = (1..256)
            .find(|&n| ends(slice * f64::from(n)))
            .unwrap_or(256);
        let (mut low, mut high) = (slice * f64::from(count - 1), slice * f64::from(count));
        for _ in 0..64 {
            let middle = 0.5 * (low + high);
            if ends(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        let [overlap, rate] = self.state(speed, high);
        Release {
            time: high,
            overlap,
            speed: -rate,
        }
    }
}

/// Height in m above contact that a released sphere reaches: v^2 / (2 g) minus the remaining overlap.
pub fn apex(release: &Release, gravity: f64) -> f64 {
    release.speed * release.speed / (2.0 * gravity) - release.overlap
}

/// Two spheres in a vertical stack between walls, on linear springs with damping; heights and
/// velocities at a time by the matrix exponential.
#[derive(Clone, Copy, Debug)]
pub struct Stack {
    /// Masses in kg, the lower one first.
    pub masses: [f64; 2],
    /// Radius of both in m.
    pub radius: f64,
    /// Distance between the walls in m.
    pub height: f64,
    /// Stiffness of all three contacts in kg/s^2.
    pub stiffness: f64,
    /// Damping of all three contacts in kg/s.
    pub damping: f64,
    /// Acceleration downwards in m/s^2.
    pub gravity: f64,
}

impl Stack {
    /// Heights in m and velocities in m/s after a time in s, if no contact opens.
    ///
    /// With y the heights, M y'' = B - K y - C y', where K / k = C / c = [[2, -1], [-1, 2]] and B holds
    /// With y the heights, M y'' = B - K y - C y', where K / k = C / c = [[2, -1], [-1, 2]] and B
    /// contains weights and rest lengths.
    pub fn state(&self, heights: [f64; 2], time: f64) -> [f64; 4] {
        let [m, n] = self.masses;
        let (k, c) = (self.stiffness, self.damping);
        // The lower wall pushes up from r, the partner down from 2 r; the upper wall is at its height.
        let below = k * (self.radius - 2.0 * self.radius);
        let above = k * (2.0 * self.radius + self.height - self.radius);
        let g = self.gravity;
        let rate = Matrix5::new(
            0.0,
            0.0,
            1.0,
            0.0,
            0.0, //
            0.0,
            0.0,
            0.0,
            1.0,
            0.0, //
            -2.0 * k / m,
            k / m,
            -2.0 * c / m,
            c / m,
            below / m - g, //
            k / n,
            -2.0 * k / n,
            c / n,
            -2.0 * c / n,
            above / n - g, //
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        );
        let start = Vector5::new(heights[0], heights[1], 0.0, 0.0, 1.0);
        let end = (rate * time).exp() * start;
        [end[0], end[1], end[2], end[3]]
    }
}
