//! A periodic cell between two horizontal walls, and what is done to it.

use crate::assembly::Assembly;
use crate::detection::HalfPlane;
use crate::error::{SetupError, require};
use crate::shape::Shapes;
use crate::step::State;
use crate::units::{InverseMass, Load, Velocity};
use gouge_common::geometry::{Domain, Vec2};
use gouge_equations::rendered;

/// Unit of the lower wall, which does not move.
pub const LOWER: u32 = 0;
/// Unit of the upper wall, whose horizontal motion is imposed.
pub const UPPER: u32 = 1;

/// A cell, periodic in x, between a fixed floor at y = 0 and a roof that keeps horizontal.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Bodies and walls.
    pub assembly: Assembly,
    /// Their motion.
    pub state: State,
}

impl Cell {
    /// An empty cell of a width and a height in m. The roof moves vertically with its mass.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for sizes that are not positive.
    pub fn new(
        width: f64,
        height: f64,
        roof: InverseMass,
        shapes: Shapes,
    ) -> Result<Self, SetupError> {
        require("width", width, "positive", width > 0.0)?;
        require("height", height, "positive", height > 0.0)?;
        let domain = Domain {
            width: Some(width),
            height: None,
            periodic: true,
        };
        let mut cell = Self {
            assembly: Assembly::new(domain, shapes),
            state: State::default(),
        };
        for (mass, y, normal) in [(InverseMass::IMPOSED, 0.0, 1.0), (roof, height, -1.0)] {
            let configuration = &mut cell.state.configuration;
            let unit = cell
                .assembly
                .add_unit(configuration, mass, Velocity::default())?;
            let wall = HalfPlane {
                position: Vec2::new(0.0, y),
                normal: Vec2::new(0.0, normal),
            };
            cell.assembly.add_wall(configuration, wall, unit)?;
        }
        Ok(cell)
    }

    /// Width in m.
    pub fn width(&self) -> f64 {
        self.assembly.domain.width.unwrap_or(f64::INFINITY)
    }

    /// Height of the roof in m.
    pub fn height(&self) -> f64 {
        roof_height(&self.state)
    }
}

/// Height of the roof of a cell in m.
pub fn roof_height(state: &State) -> f64 {
    state.configuration.wall[UPPER as usize].position.y
}

/// How fast the roof goes sideways.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// At the height of the roof times a shear rate in 1/s, so that the rate stays the same.
    Rate(f64),
    /// At a velocity in m/s, as the source says.
    Constant(f64),
}

/// What is done to the walls of a cell.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// The roof is loaded and driven sideways.
    Shear {
        /// Stress on the roof in Pa, positive downwards.
        normal_stress: f64,
        /// Horizontal velocity.
        speed: Speed,
    },
    /// The roof is loaded and may move only slowly, and all bodies are slowed down after each step, until the packing
    /// bears the load.
    Compaction {
        /// Stress on the roof in Pa, positive downwards.
        normal_stress: f64,
        /// Largest speed of the roof in m/s.
        largest_speed: f64,
        /// Factor on all velocities after each step, in [0, 1].
        slowing: f64,
        /// Number of steps after which the height of the roof is compared; at least 1.
        window: u64,
        /// The packing has settled once the roof moved less than this in a window; in m.
        settled_distance: f64,
    },
}

impl Drive {
    /// Check all numbers.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a negative stress or speed, or a factor outside [0, 1].
    pub fn validate(&self) -> Result<(), SetupError> {
        let at_least_zero = |name, value| require(name, value, "not negative", value >= 0.0);
        match *self {
            Self::Shear {
                normal_stress,
                speed: Speed::Rate(speed) | Speed::Constant(speed),
            } => {
                at_least_zero("normal stress", normal_stress)?;
                require("speed of the roof", speed, "finite", true)
            }
            Self::Compaction {
                normal_stress,
                largest_speed,
                slowing,
                window,
                settled_distance,
            } => {
                require("window", window as f64, "at least 1", window >= 1)?;
                at_least_zero("distance of settling", settled_distance)?;
                at_least_zero("normal stress", normal_stress)?;
                at_least_zero("largest speed of the roof", largest_speed)?;
                let is_valid = (0.0..=1.0).contains(&slowing);
                require("factor on velocities", slowing, "in [0, 1]", is_valid)
            }
        }
    }

    /// Load and velocity of the roof before a step.
    pub fn before_step(&self, assembly: &mut Assembly, state: &mut State) {
        let (Self::Shear { normal_stress, .. } | Self::Compaction { normal_stress, .. }) = *self;
        let width = assembly.domain.width.unwrap_or(0.0);
        assembly.load[UPPER as usize] = Load {
            force: Vec2::new(0.0, -normal_stress * width),
            torque: 0.0,
        };
        if let Self::Shear { speed, .. } = *self {
            let velocity = match speed {
                Speed::Rate(rate) => rate * roof_height(state),
                Speed::Constant(velocity) => velocity,
            };
            state.configuration.velocity[UPPER as usize].linear.x = velocity;
        }
    }

    /// What happens to velocities after a step.
    pub fn after_step(&self, state: &mut State) {
        let Self::Compaction {
            largest_speed,
            slowing,
            ..
        } = *self
        else {
            return;
        };
        let velocities = &mut state.configuration.velocity;
        for velocity in velocities.iter_mut() {
            velocity.linear = velocity.linear * slowing;
            velocity.angular *= slowing;
        }
        let vertical = &mut velocities[UPPER as usize].linear.y;
        *vertical = vertical.clamp(-largest_speed, largest_speed);
    }
}

/// How far a compaction has come.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settling {
    /// Height of the roof in m at the beginning of the present window.
    pub height: f64,
    /// Whether the roof moved too little in the latest window.
    pub is_settled: bool,
}

impl Settling {
    /// At the beginning of a compaction, with the roof at a height in m.
    pub fn from_height(height: f64) -> Self {
        Self {
            height,
            is_settled: false,
        }
    }

    /// Take note of the height of the roof in m after a number of steps.
    pub fn follow(&mut self, drive: &Drive, steps: u64, height: f64) {
        if let Drive::Compaction {
            window,
            settled_distance,
            ..
        } = *drive
            && steps.is_multiple_of(window)
        {
            self.is_settled = (height - self.height).abs() < settled_distance;
            self.height = height;
        }
    }
}
