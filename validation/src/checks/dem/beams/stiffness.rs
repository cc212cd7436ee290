//! Forces of the kernel's bonds in displaced states, and their derivatives by dual numbers.
//!
//! A world begins with unstrained bonds. To reach a displaced state with the kernel alone, the
//! particles get the velocity displacement / step, and one explicit Euler step moves them. The step is
//! a power of two, so that this is exact, and so short that accelerations are negligible.

use crate::checks::Failure;
use crate::scenes::Draft;
use gouge_common::geometry::Vec2;
use gouge_dem::bonds::BondStart;
use gouge_dem::integrators::Integrator;
use gouge_dem::model::Model;
use gouge_dem::particles::Particles;
use gouge_dem::{Number, Start, World};
use gouge_scalars::Dual;
use nalgebra::DMatrix;

/// Time step in s: 2^-30.
const STEP: f64 = 1.0 / (1u64 << 30) as f64;

/// Bonded particles at rest with unstrained bonds.
pub struct Rest {
    model: Model,
    particles: Particles,
    start: Start,
}

impl Rest {
    /// The initial state of the bonds of a scene.
    pub fn of_draft(draft: &Draft) -> Result<Self, Failure> {
        Ok(Self::of(&draft.world()?))
    }

    /// The bonds of a world, as if they began in its present state.
    pub fn of(world: &World) -> Self {
        let pairs = world.bonds().map_or(&[][..], |strong| strong.pairs());
        let bond = |pair: &gouge_common::pair::Pair| BondStart {
            between: [pair.i as usize, pair.j as usize],
            strength_factor: 1.0,
            initial_distance: None,
            initial_angles: None,
        };
        let model = Model {
            integrator: Integrator::Euler,
            time_step: STEP,
            contact: None,
            driving: None,
            ledger: false,
            ..*world.model()
        };
        Self {
            model,
            particles: world.particles().clone(),
            start: Start {
                bonds: pairs.iter().map(bond).collect(),
                ..Start::default()
            },
        }
    }

    /// The particles.
    pub fn particles(&self) -> &Particles {
        &self.particles
    }

    /// The bonded pairs.
    pub fn pairs(&self) -> impl Iterator<Item = [usize; 2]> {
        self.start.bonds.iter().map(|bond| bond.between)
    }

    /// Number of coordinates: x, y and angle of every particle.
    pub fn coordinates(&self) -> usize {
        3 * self.particles.len()
    }

    /// Inertia of every coordinate in kg or kg m^2.
    pub fn inertia(&self) -> Vec<f64> {
        let p = &self.particles;
        let of = |i: usize| [p.mass[i], p.mass[i], p.moment_of_inertia[i]];
        (0..p.len()).flat_map(of).collect()
    }

    fn moving<S: Number>(&self, model: Model, rates: &[S]) -> Result<World<S>, Failure> {
        let p = &self.particles;
        let numbers = |column: &[f64]| column.iter().map(|&x| S::from_f64(x)).collect();
        let particles = Particles {
            position: p.position.iter().map(|x| x.cast()).collect(),
            velocity: rates.chunks(3).map(|u| Vec2::new(u[0], u[1])).collect(),
            angle: numbers(&p.angle),
            angular_velocity: rates.chunks(3).map(|u| u[2]).collect(),
            radius: numbers(&p.radius),
            mass: numbers(&p.mass),
            moment_of_inertia: numbers(&p.moment_of_inertia),
            role: p.role.clone(),
        };
        Ok(World::new(model, particles, &self.start)?)
    }

    /// The undamped world, evaluated after a displacement of every coordinate.
    pub fn displaced<S: Number>(&self, displacement: &[S]) -> Result<World<S>, Failure> {
        let mut model = self.model;
        if let Some(bond) = &mut model.bond {
            bond.normal.damping = 0.0;
            if let Some(beam) = &mut bond.tangential {
                beam.damping = 0.0;
            }
        }
        let rates: Vec<S> = displacement.iter().map(|&u| u * (1.0 / STEP)).collect();
        let mut world = self.moving(model, &rates)?;
        world.step()?;
        world.evaluate_if_pending()?;
        Ok(world)
    }

    /// The world with a given rate of every coordinate, to be run with the given integrator and time
    /// step in s.
    pub fn launched<S: Number>(
        &self,
        rates: &[S],
        integrator: Integrator,
        step: f64,
    ) -> Result<World<S>, Failure> {
        let model = Model {
            integrator,
            time_step: step,
            ..self.model
        };
        self.moving(model, rates)
    }

    /// Minus the derivatives of all forces with respect to all displacements.
    pub fn stiffness(&self) -> Result<DMatrix<f64>, Failure> {
        self.slopes(|seeds| self.displaced(seeds))
    }

    /// Minus the derivatives of all forces with respect to all rates.
    pub fn damping(&self) -> Result<DMatrix<f64>, Failure> {
        self.slopes(|seeds| {
            let mut world = self.moving(self.model, seeds)?;
            world.evaluate_if_pending()?;
            Ok(world)
        })
    }

    fn slopes(
        &self,
        world: impl Fn(&[Dual]) -> Result<World<Dual>, Failure>,
    ) -> Result<DMatrix<f64>, Failure> {
        let size = self.coordinates();
        let mut matrix = DMatrix::zeros(size, size);
        let mut seeds = vec![Dual::default(); size];
        for column in 0..size {
            seeds[column] = Dual::variable(0.0);
            let forces = forces(&world(&seeds)?);
            for (row, force) in forces.iter().enumerate() {
                matrix[(row, column)] = -force.slope();
            }
            seeds[column] = Dual::default();
        }
        Ok(matrix)
    }
}

/// Force or torque on every coordinate.
pub fn forces<S: Number>(world: &World<S>) -> Vec<S> {
    let forces = world.forces();
    let of = |(force, torque): (&Vec2<S>, &S)| [force.x, force.y, *torque];
    forces
        .force
        .iter()
        .zip(&forces.torque)
        .flat_map(of)
        .collect()
}

/// Positions and angles of all particles.
pub fn coordinates<S: Number>(world: &World<S>) -> Vec<S> {
    let p = world.particles();
    let of = |(x, angle): (&Vec2<S>, &S)| [x.x, x.y, *angle];
    p.position.iter().zip(&p.angle).flat_map(of).collect()
}

/// The submatrix of the given rows and columns.
pub fn inner(matrix: &DMatrix<f64>, kept: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(kept.len(), kept.len(), |row, column| {
        matrix[(kept[row], kept[column])]
    })
}

/// Eigenvalues of M^-1/2 K M^-1/2 in ascending order, and the modes M^-1/2 y in the same order.
pub fn modes(stiffness: &DMatrix<f64>, inertia: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let scaled = DMatrix::from_fn(inertia.len(), inertia.len(), |row, column| {
        stiffness[(row, column)] / (inertia[row] * inertia[column]).sqrt()
    });
    let symmetric = (&scaled + scaled.transpose()) * 0.5;
    let solved = symmetric.symmetric_eigen();
    let mut order: Vec<usize> = (0..inertia.len()).collect();
    order.sort_by(|&a, &b| solved.eigenvalues[a].total_cmp(&solved.eigenvalues[b]));
    let mode = |&n: &usize| {
        let column = solved.eigenvectors.column(n);
        column
            .iter()
            .zip(inertia)
            .map(|(y, m)| y / m.sqrt())
            .collect()
    };
    let values = order.iter().map(|&n| solved.eigenvalues[n]).collect();
    (values, order.iter().map(mode).collect())
}
