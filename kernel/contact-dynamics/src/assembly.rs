//! Bodies, walls and the units they belong to.

use crate::detection::HalfPlane;
use crate::error::{SetupError, require};
use crate::shape::{ShapeId, Shapes};
use crate::units::{InverseMass, Load, Velocity};
use gouge_common::geometry::{Domain, Vec2};

/// What stays constant: shapes, sizes, masses and loads, as columns.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// The box.
    pub domain: Domain,
    /// Shapes of the bodies.
    pub shapes: Shapes,
    /// Shape per body.
    pub shape: Vec<ShapeId>,
    /// Size per body: the factor on the lengths of its shape.
    pub scale: Vec<f64>,
    /// Unit per body.
    pub unit: Vec<u32>,
    /// Unit per wall.
    pub wall_unit: Vec<u32>,
    /// Inverse mass per unit.
    pub inverse_mass: Vec<InverseMass>,
    /// Load per unit; it may be changed between steps.
    pub load: Vec<Load>,
    /// Whether a unit has a body, per unit.
    has_body: Vec<bool>,
}

/// What changes from step to step, apart from the remembered impulses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Configuration {
    /// Position of the centroid per body in m.
    pub position: Vec<Vec2>,
    /// Angle per body in rad.
    pub angle: Vec<f64>,
    /// Surface per wall.
    pub wall: Vec<HalfPlane>,
    /// Velocity per unit.
    pub velocity: Vec<Velocity>,
}

/// A body to be added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Its shape.
    pub shape: ShapeId,
    /// Its size: the factor on the lengths of the shape.
    pub scale: f64,
    /// Position of its centroid in m.
    pub position: Vec2,
    /// Its angle in rad.
    pub angle: f64,
}

impl Assembly {
    /// No bodies in a box.
    pub fn new(domain: Domain, shapes: Shapes) -> Self {
        Self {
            domain,
            shapes,
            shape: Vec::new(),
            scale: Vec::new(),
            unit: Vec::new(),
            wall_unit: Vec::new(),
            inverse_mass: Vec::new(),
            load: Vec::new(),
            has_body: Vec::new(),
        }
    }

    /// Add a unit without bodies, and return its index.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a negative inverse mass or a velocity that is not finite.
    pub fn add_unit(
        &mut self,
        configuration: &mut Configuration,
        inverse_mass: InverseMass,
        velocity: Velocity,
    ) -> Result<u32, SetupError> {
        let inverses = [inverse_mass.x, inverse_mass.y, inverse_mass.rotation];
        for inverse in inverses {
            require("inverse mass", inverse, "not negative", inverse >= 0.0)?;
        }
        for v in [velocity.linear.x, velocity.linear.y, velocity.angular] {
            require("velocity", v, "finite", true)?;
        }
        self.inverse_mass.push(inverse_mass);
        self.load.push(Load::default());
        self.has_body.push(false);
        configuration.velocity.push(velocity);
        Ok(self.inverse_mass.len() as u32 - 1)
    }

    /// Add a body to a unit, and return its index.
    ///
    /// Contact arms are measured from the centre of the body. A unit of several bodies therefore must not turn.
    ///
    /// # Errors
    /// [`SetupError::Missing`] without such a shape or unit, [`SetupError::Parameter`] for a size that is not positive,
    /// a position or angle that is not finite, or a second body in a unit that can turn.
    pub fn add_body(
        &mut self,
        configuration: &mut Configuration,
        body: Body,
        unit: u32,
    ) -> Result<usize, SetupError> {
        self.require_unit(unit)?;
        self.require_shape(body.shape)?;
        require("size", body.scale, "positive", body.scale > 0.0)?;
        require(
            "position",
            body.position.x + body.position.y,
            "finite",
            true,
        )?;
        require("angle", body.angle, "finite", true)?;
        if self.has_body[unit as usize] {
            let rotation = self.inverse_mass[unit as usize].rotation;
            let name = "inverse moment of inertia of a unit of several bodies";
            require(name, rotation, "zero", rotation == 0.0)?;
        }
        self.shape.push(body.shape);
        self.scale.push(body.scale);
        self.unit.push(unit);
        self.has_body[unit as usize] = true;
        configuration.position.push(body.position);
        configuration.angle.push(body.angle);
        Ok(self.shape.len() - 1)
    }

    /// Add a free body of a density in kg/m² as a unit of its own, and return the index of the unit.
    ///
    /// # Errors
    /// As [`Self::add_body`], and [`SetupError::Parameter`] for a density that is not positive.
    pub fn add_free(
        &mut self,
        configuration: &mut Configuration,
        body: Body,
        density: f64,
        velocity: Velocity,
    ) -> Result<u32, SetupError> {
        let inverse_mass = self.inverse_mass_of(body, density)?;
        let unit = self.add_unit(configuration, inverse_mass, velocity)?;
        self.add_body(configuration, body, unit)?;
        Ok(unit)
    }

    fn inverse_mass_of(&self, body: Body, density: f64) -> Result<InverseMass, SetupError> {
        self.require_shape(body.shape)?;
        let measures = self.shapes.outline(body.shape).measures;
        let square = body.scale * body.scale;
        let mass = density * square * measures.area;
        InverseMass::free(mass, density * square * square * measures.second_moment)
    }

    /// Add a flat wall to a unit.
    ///
    /// # Errors
    /// [`SetupError::Missing`] without such a unit, [`SetupError::Parameter`] for a normal whose length is not one,
    /// or a unit that can turn.
    pub fn add_wall(
        &mut self,
        configuration: &mut Configuration,
        wall: HalfPlane,
        unit: u32,
    ) -> Result<(), SetupError> {
        self.require_unit(unit)?;
        let length = wall.normal.norm();
        let is_unit = (length - 1.0).abs() < 1e-12;
        require("length of a wall's normal", length, "one", is_unit)?;
        let rotation = self.inverse_mass[unit as usize].rotation;
        let name = "inverse moment of inertia of a wall";
        require(name, rotation, "zero", rotation == 0.0)?;
        self.wall_unit.push(unit);
        configuration.wall.push(wall);
        Ok(())
    }

    /// The body of each unit that is a single body without walls.
    pub(crate) fn single_bodies(&self) -> Vec<Option<u32>> {
        let units = self.inverse_mass.len();
        let mut counts = vec![0usize; units];
        let mut bodies = vec![None; units];
        for (body, &unit) in self.unit.iter().enumerate() {
            counts[unit as usize] += 1;
            bodies[unit as usize] = Some(body as u32);
        }
        for &unit in &self.wall_unit {
            counts[unit as usize] += 1;
        }
        let single = bodies.into_iter().zip(counts);
        single
            .map(|(body, count)| body.filter(|_| count == 1))
            .collect()
    }

    /// Area of a body in m².
    pub fn area(&self, body: usize) -> f64 {
        let area = self.shapes.outline(self.shape[body]).measures.area;
        area * self.scale[body] * self.scale[body]
    }

    fn require_shape(&self, shape: ShapeId) -> Result<(), SetupError> {
        match self.shapes.contains(shape) {
            true => Ok(()),
            false => Err(SetupError::Missing {
                what: "shape",
                index: shape.index(),
                count: self.shapes.len(),
            }),
        }
    }

    fn require_unit(&self, unit: u32) -> Result<(), SetupError> {
        let count = self.inverse_mass.len();
        let index = unit as usize;
        if index < count {
            return Ok(());
        }
        Err(SetupError::Missing {
            what: "unit",
            index,
            count,
        })
    }

    /// Kinetic energy in J of all motion that is not imposed.
    pub fn kinetic_energy(&self, configuration: &Configuration) -> f64 {
        let units = self.inverse_mass.iter().zip(&configuration.velocity);
        units.map(|(mass, &v)| mass.kinetic_energy(v)).sum()
    }
}

impl Configuration {
    /// Move bodies and walls for a time in s with their present velocities, azema (A28) and (A31).
    pub fn advance(&mut self, assembly: &Assembly, time: f64) {
        for (body, &unit) in assembly.unit.iter().enumerate() {
            let velocity = self.velocity[unit as usize];
            self.position[body] += velocity.linear * time;
            self.angle[body] += velocity.angular * time;
        }
        for (wall, &unit) in self.wall.iter_mut().zip(&assembly.wall_unit) {
            wall.position += self.velocity[unit as usize].linear * time;
        }
    }

    /// Add the effect of the loads for a time in s to the velocities.
    pub fn accelerate(&mut self, assembly: &Assembly, time: f64) {
        let units = assembly.inverse_mass.iter().zip(&assembly.load);
        for (velocity, (mass, &load)) in self.velocity.iter_mut().zip(units) {
            *velocity = mass.accelerated(*velocity, load, time);
        }
    }
}
