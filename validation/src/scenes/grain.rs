//! The grains and bonds of a scene.

use gouge_dem::particles::Role;
use gouge_runner::scene::role_name;
use toml::{Table, Value};

/// One particle: `[[particles]]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain {
    /// Position in m.
    pub position: [f64; 2],
    /// Radius in m.
    pub radius: f64,
    /// Velocity in m/s.
    pub velocity: [f64; 2],
    /// Angular velocity in rad/s, counter-clockwise.
    pub spin: f64,
    /// Angle in rad, counter-clockwise.
    pub angle: f64,
    /// Density in kg/m^3; by default the material's.
    pub density: Option<f64>,
    /// Whether it is free, driven or fixed.
    pub role: Role,
}

impl Grain {
    /// A free grain at rest.
    pub fn at(position: [f64; 2], radius: f64) -> Self {
        Self {
            position,
            radius,
            velocity: [0.0; 2],
            spin: 0.0,
            angle: 0.0,
            density: None,
            role: Role::Free,
        }
    }

    /// With a velocity in m/s.
    pub fn moving(self, velocity: [f64; 2]) -> Self {
        Self { velocity, ..self }
    }

    /// With an angular velocity in rad/s.
    pub fn spinning(self, spin: f64) -> Self {
        Self { spin, ..self }
    }

    /// Turned by an angle in rad.
    pub fn turned(self, angle: f64) -> Self {
        Self { angle, ..self }
    }

    /// Of a density of its own in kg/m^3.
    pub fn of_density(self, density: f64) -> Self {
        Self {
            density: Some(density),
            ..self
        }
    }

    /// With a role.
    pub fn with_role(self, role: Role) -> Self {
        Self { role, ..self }
    }

    /// It never moves.
    pub fn fixed(self) -> Self {
        self.with_role(Role::Fixed)
    }

    /// It carries a share of the driving force.
    pub fn driven(self) -> Self {
        self.with_role(Role::Driven)
    }

    pub(super) fn table(self) -> Value {
        let mut table = Table::new();
        let mut add = |key: &str, value: Value| table.insert(key.to_owned(), value);
        add("position", self.position.to_vec().into());
        add("velocity", self.velocity.to_vec().into());
        add("angle", self.angle.into());
        add("angular_velocity", self.spin.into());
        add("radius", self.radius.into());
        if let Some(density) = self.density {
            add("density", density.into());
        }
        add("role", role_name(self.role).into());
        table.into()
    }
}

/// One bond: `[[bonds]]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond {
    between: [usize; 2],
    length: Option<f64>,
    angles: Option<[f64; 2]>,
    strength: Option<f64>,
}

impl Bond {
    /// Between two grains, counted from 0.
    pub fn between(i: usize, j: usize) -> Self {
        Self {
            between: [i, j],
            length: None,
            angles: None,
            strength: None,
        }
    }

    /// With an initial distance in m.
    pub fn of_length(self, length: f64) -> Self {
        Self {
            length: Some(length),
            ..self
        }
    }

    /// With the initial angles of both ends in rad.
    pub fn since(self, angles: [f64; 2]) -> Self {
        Self {
            angles: Some(angles),
            ..self
        }
    }

    /// With a factor of its strength.
    pub fn of_strength(self, factor: f64) -> Self {
        Self {
            strength: Some(factor),
            ..self
        }
    }

    pub(super) fn table(self) -> Value {
        let mut table = Table::new();
        let mut add = |key: &str, value: Value| table.insert(key.to_owned(), value);
        add("between", self.between.map(|i| i as i64).to_vec().into());
        if let Some(length) = self.length {
            add("initial_distance", length.into());
        }
        if let Some(angles) = self.angles {
            add("initial_angles", angles.to_vec().into());
        }
        if let Some(factor) = self.strength {
            add("strength_factor", factor.into());
        }
        table.into()
    }
}
