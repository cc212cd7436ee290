//! What the steps since the latest sample did.

use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::cell::UPPER;
use gouge_contact_dynamics::step::StepReport;
use gouge_contact_dynamics::world::World;

/// Overlap that counts as large, in mean diameters: the source states that none is larger.
pub const LARGE: f64 = 0.01;

/// Sums and extremes over the steps since the latest sample.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Since {
    /// Number of steps.
    pub steps: u64,
    /// Number of sweeps.
    pub sweeps: u64,
    /// Number of steps whose sweeps did not converge.
    pub unconverged: u64,
    /// Number of points whose local problem had no solution or several.
    pub not_unique: u64,
    /// Number of steps with a large overlap.
    pub large_overlaps: u64,
    /// Largest overlap in m.
    pub largest_overlap: f64,
    /// Impulse in kg m/s of the bodies on the roof and on what is glued to it.
    pub on_roof: Vec2,
}

/// Number of words.
pub const WORDS: usize = 8;

impl Since {
    /// Take note of a step of a world with a mean diameter in m.
    pub fn add(&mut self, report: &StepReport, world: &World, diameter: f64) {
        self.steps += 1;
        self.sweeps += report.sweeps.sweeps as u64;
        self.unconverged += u64::from(!report.sweeps.has_converged);
        self.not_unique += report.sweeps.not_unique as u64;
        self.large_overlaps += u64::from(report.largest_overlap > LARGE * diameter);
        self.largest_overlap = self.largest_overlap.max(report.largest_overlap);
        if world.drive().is_some() {
            self.on_roof += impulse_on_roof(world);
        }
    }

    /// Add the numbers of later steps.
    pub fn extend(&mut self, later: &Self) {
        self.steps += later.steps;
        self.sweeps += later.sweeps;
        self.unconverged += later.unconverged;
        self.not_unique += later.not_unique;
        self.large_overlaps += later.large_overlaps;
        self.largest_overlap = self.largest_overlap.max(later.largest_overlap);
        self.on_roof += later.on_roof;
    }

    /// The mean of a sum per step; none without steps.
    pub fn per_step(&self, sum: f64) -> f64 {
        sum / self.steps as f64
    }

    /// All numbers as words.
    pub fn words(&self) -> [u64; WORDS] {
        [
            self.steps,
            self.sweeps,
            self.unconverged,
            self.not_unique,
            self.large_overlaps,
            self.largest_overlap.to_bits(),
            self.on_roof.x.to_bits(),
            self.on_roof.y.to_bits(),
        ]
    }

    /// The numbers from their words.
    pub fn from_words(words: [u64; WORDS]) -> Self {
        let [
            steps,
            sweeps,
            unconverged,
            not_unique,
            large_overlaps,
            rest @ ..,
        ] = words;
        let [largest_overlap, x, y] = rest.map(f64::from_bits);
        Self {
            steps,
            sweeps,
            unconverged,
            not_unique,
            large_overlaps,
            largest_overlap,
            on_roof: Vec2::new(x, y),
        }
    }
}

fn impulse_on_roof(world: &World) -> Vec2 {
    let mut sum = Vec2::zero();
    for row in world.workspace().solver().rows() {
        let (point, impulse) = (row.kinematics(), row.impulse());
        let sign = match point.units {
            [UPPER, _] => -1.0,
            [_, UPPER] => 1.0,
            _ => continue,
        };
        let n = point.normal;
        sum += (n * impulse.n + n.perpendicular() * impulse.t) * sign;
    }
    sum
}
