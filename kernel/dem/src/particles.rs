//! Particles: spheres that move in a plane, thesis eqs. (51)-(54).

use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_common::neighbors::SearchSpheres;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// How a particle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Moves under all forces.
    Free,
    /// Moves under all forces and carries an equal share of the driving force.
    Driven,
    /// Neither moves nor rotates.
    Fixed,
}

/// Particles, as columns of equal length.
#[doc(alias = "grain")]
#[doc(alias = "element")]
#[derive(Clone, Debug, PartialEq)]
pub struct Particles<S = f64> {
    /// Positions of the centres in m.
    pub position: Vec<Vec2<S>>,
    /// Velocities in m/s.
    pub velocity: Vec<Vec2<S>>,
    /// Angles in rad, counter-clockwise, never wrapped.
    pub angle: Vec<S>,
    /// Angular velocities in rad/s.
    pub angular_velocity: Vec<S>,
    /// Radii in m.
    pub radius: Vec<S>,
    /// Masses in kg.
    pub mass: Vec<S>,
    /// Moments of inertia in kg m^2.
    pub moment_of_inertia: Vec<S>,
    /// Roles.
    pub role: Vec<Role>,
}

impl<S> Default for Particles<S> {
    fn default() -> Self {
        Self {
            position: Vec::new(),
            velocity: Vec::new(),
            angle: Vec::new(),
            angular_velocity: Vec::new(),
            radius: Vec::new(),
            mass: Vec::new(),
            moment_of_inertia: Vec::new(),
            role: Vec::new(),
        }
    }
}

/// A single particle, to be appended to [`Particles`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Position in m.
    pub position: Vec2,
    /// Velocity in m/s.
    pub velocity: Vec2,
    /// Angle in rad.
    pub angle: f64,
    /// Angular velocity in rad/s.
    pub angular_velocity: f64,
    /// Radius in m.
    pub radius: f64,
    /// Density in kg/m^3.
    pub density: f64,
    /// Moment of inertia in units of mass times radius squared; [`SPHERE_INERTIA_FACTOR`] for a sphere.
    pub inertia_factor: f64,
    /// Role.
    pub role: Role,
}

impl Particle {
    /// A free homogeneous sphere at rest, from its position and radius in m and its density in kg/m^3.
    pub fn sphere(position: Vec2, radius: f64, density: f64) -> Self {
        Self {
            position,
            velocity: Vec2::zero(),
            angle: 0.0,
            angular_velocity: 0.0,
            radius,
            density,
            inertia_factor: SPHERE_INERTIA_FACTOR,
            role: Role::Free,
        }
    }
}

impl<S: Real> Particles<S> {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.position.len()
    }
    /// Whether there are no particles.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
    /// Append a particle.
    pub fn push(&mut self, particle: &Particle) {
        let mass = sphere_mass(particle.density, particle.radius);
        let inertia = moment_of_inertia(particle.inertia_factor, mass, particle.radius);
        self.position.push(particle.position.cast());
        self.velocity.push(particle.velocity.cast());
        self.angle.push(S::from_f64(particle.angle));
        self.angular_velocity
            .push(S::from_f64(particle.angular_velocity));
        self.radius.push(S::from_f64(particle.radius));
        self.mass.push(S::from_f64(mass));
        self.moment_of_inertia.push(S::from_f64(inertia));
        self.role.push(particle.role);
    }
    /// Whether particle `i` is fixed.
    #[inline(always)]
    pub fn is_fixed(&self, i: usize) -> bool {
        self.role[i] == Role::Fixed
    }
    /// Input of the neighbour search: positions and radii.
    pub fn search_spheres(&self) -> SearchSpheres<'_, S> {
        SearchSpheres {
            positions: &self.position,
            radii: &self.radius,
        }
    }
    /// Whether forces between two particles can move anything: not if both are fixed.
    pub fn may_interact(&self, i: usize, j: usize) -> bool {
        !(self.is_fixed(i) && self.is_fixed(j))
    }
    /// The inverse of the inertia factor of particle `i`, m r^2 / J, dimensionless: 5/2 for a sphere.
    ///
    /// Rounded to a multiple of 2^-40, so that the rounding of J does not show: it is exactly 5/2 for a sphere.
    pub fn inverse_inertia_factor(&self, i: usize) -> f64 {
        const UNIT: f64 = 1.0 / (1_u64 << 40) as f64;
        let (mass, radius) = (self.mass[i].to_f64(), self.radius[i].to_f64());
        let inverse = mass * radius * radius / self.moment_of_inertia[i].to_f64();
        libm::round(inverse / UNIT) * UNIT
    }
    /// Indices of the particles with the given role.
    pub fn with_role(&self, role: Role) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(move |&i| self.role[i] == role)
    }
    /// Largest radius in m, zero without particles.
    pub fn largest_radius(&self) -> f64 {
        self.radius.iter().map(|r| r.to_f64()).fold(0.0, f64::max)
    }
}

impl<S: Real> FromIterator<Particle> for Particles<S> {
    fn from_iter<I: IntoIterator<Item = Particle>>(particles: I) -> Self {
        let mut columns = Self::default();
        particles
            .into_iter()
            .for_each(|particle| columns.push(&particle));
        columns
    }
}

impl Particles {
    /// Set the roles of all particles. Fixed particles stop.
    pub fn assign(&mut self, roles: Vec<Role>) {
        for (i, role) in roles.iter().enumerate() {
            if *role == Role::Fixed {
                self.velocity[i] = Vec2::zero();
                self.angular_velocity[i] = 0.0;
            }
        }
        self.role = roles;
    }

    /// Multiply masses and moments of inertia of the first `number` particles by a factor.
    pub fn scale_mass(&mut self, number: usize, factor: f64) {
        self.mass
            .iter_mut()
            .take(number)
            .for_each(|mass| *mass *= factor);
        self.moment_of_inertia
            .iter_mut()
            .take(number)
            .for_each(|inertia| *inertia *= factor);
    }

    /// The particles with the given indices, in the given order.
    pub fn select(&self, kept: &[usize]) -> Self {
        fn pick<T: Copy>(column: &[T], kept: &[usize]) -> Vec<T> {
            kept.iter().map(|&i| column[i]).collect()
        }
        Self {
            position: pick(&self.position, kept),
            velocity: pick(&self.velocity, kept),
            angle: pick(&self.angle, kept),
            angular_velocity: pick(&self.angular_velocity, kept),
            radius: pick(&self.radius, kept),
            mass: pick(&self.mass, kept),
            moment_of_inertia: pick(&self.moment_of_inertia, kept),
            role: pick(&self.role, kept),
        }
    }

    /// Copies placed side by side along x, `width` in m apart.
    pub fn repeated(&self, width: f64, times: usize) -> Self {
        let number = self.len();
        let all: Vec<usize> = (0..times).flat_map(|_| 0..number).collect();
        let mut copies = self.select(&all);
        for (k, position) in copies.position.iter_mut().enumerate() {
            position.x += width * (k / number) as f64;
        }
        copies
    }
}

/// Mass of a homogeneous sphere in kg.
///
/// $$ m = \tfrac43 \pi \rho\, r^3 $$
///
/// Thesis eq. (52), read with the density in the numerator (erratum E26 of the thesis).
#[rendered]
pub fn sphere_mass(density: f64, radius: f64) -> f64 {
    4.0 / 3.0 * PI * density * radius * radius * radius
}

/// Inertia factor of a homogeneous sphere about an axis through its centre, dimensionless.
///
/// Thesis eq. (53); a disc has 1/2.
pub const SPHERE_INERTIA_FACTOR: f64 = 0.4;

/// Inertia factor with which the thesis's author computed, dimensionless.
///
/// The second moment of a homogeneous sphere about its centre as a point, not about an axis (erratum E64
/// of the thesis).
pub const COMPUTED_INERTIA_FACTOR: f64 = 0.6;

/// Moment of inertia in kg m^2 of a round body, for its inertia factor c > 0, mass in kg and radius in m.
///
/// $$ J = c\, m r^2 $$
///
/// Thesis eq. (53), with [`SPHERE_INERTIA_FACTOR`].
#[rendered]
pub fn moment_of_inertia(factor: f64, mass: f64, radius: f64) -> f64 {
    factor * mass * radius * radius
}
