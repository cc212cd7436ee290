//! Bounds of the time step of a state: what `gouge stability` prints and a run checks.

use gouge_dem::integrators::{Oscillator, crack_bound, critical_step, wave_bound};
use gouge_dem::material::Elastic;
use gouge_dem::model::{Ambient, BondLaws, ContactLaws, ContactNormal, External};
use gouge_dem::{World, is_surely_stable, network_step};
use std::f64::consts::PI;

/// Characteristic Mach number of cracks, thesis section 4.2.
const MACH_NUMBER: f64 = 15.0;

/// A bound of the time step.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// Name.
    pub name: &'static str,
    /// What sets it.
    pub meaning: &'static str,
    /// The oscillation that sets it, per mass, if it is a single one.
    pub oscillator: Option<Oscillator>,
    /// The largest stable step in s; infinite if any step is stable.
    pub step: f64,
}

/// All bounds of a state; `density` in kg/m^3 is that of the material.
pub fn bounds(world: &World, density: f64) -> Vec<Bound> {
    let mut bounds = pair_bounds(world, density);
    bounds.push(network_bound(world));
    bounds
}

fn network_bound(world: &World) -> Bound {
    Bound {
        name: "network",
        meaning: "the stiffest and the most damped mode of all touching and bonded particles together, by power iteration",
        oscillator: None,
        step: network_step(world),
    }
}

/// The smallest bound of a state, if its step is above one; `pairs` is the smallest bound of single pairs, which does not
/// depend on the state.
pub fn exceeded(world: &World, pairs: Option<Bound>) -> Option<Bound> {
    let step = world.model().time_step;
    let network = (!is_surely_stable(world)).then(|| network_bound(world));
    let both: Vec<Bound> = pairs.into_iter().chain(network).collect();
    smallest(&both).filter(|bound| step > bound.step)
}

/// The bounds of single pairs. In the set-up only these are judged: the bound of the network counts all near pairs as
/// touching, of which settling grains have many.
pub fn pair_bounds(world: &World, density: f64) -> Vec<Bound> {
    let mut bounds = Vec::new();
    let pair = Lightest::of(world);
    if let Some(laws) = world.model().contact {
        bounds.extend(contact_bounds(world, laws, &pair));
        bounds.extend(wave_bounds(laws, density, pair.radius));
    }
    if let Some(laws) = world.model().bond {
        bounds.extend(bond_bounds(world, laws, &pair));
    }
    bounds.extend(field_bound(world, &pair));
    bounds
}

/// Bound from the oscillation of the lightest particle in the harmonic well, damped by creeping drag; none without both.
fn field_bound(world: &World, pair: &Lightest) -> Option<Bound> {
    let (model, p) = (world.model(), world.particles());
    let stiffness = match model.external {
        Some(External::HarmonicWell(law)) => law.stiffness,
        _ => 0.0,
    };
    let viscosity = match model.ambient {
        Some(Ambient::Creeping(law)) => law.viscosity,
        Some(Ambient::Correlation(law)) => law.viscosity,
        None => 0.0,
    };
    // Stokes drag, of the particle on which it acts most per mass.
    let rate = |i: usize| 6.0 * PI * viscosity * p.radius[i] / p.mass[i];
    let mobile = (0..p.len()).filter(|&i| world.inverse_mass(i) > 0.0);
    let damping = mobile.map(rate).fold(0.0, f64::max);
    (stiffness > 0.0 || damping > 0.0).then(|| {
        let constants = [stiffness / pair.mass, damping];
        pair_bound(
            world,
            "field",
            "the lightest particle in the external field and in creeping drag",
            constants,
        )
    })
}

/// The smallest of some bounds.
pub fn smallest(bounds: &[Bound]) -> Option<Bound> {
    let all = bounds.iter().copied();
    all.min_by(|a, b| a.step.total_cmp(&b.step))
}

/// The pair of particles whose relative motion is fastest: the two lightest ones that can move.
struct Lightest {
    /// Inverse of the reduced mass in 1/kg.
    inverse_mass: f64,
    /// Mass of the lightest particle in kg.
    mass: f64,
    /// m r^2 / J of the lightest particle.
    inverse_inertia: f64,
    /// Radius of the smallest particle in m.
    radius: f64,
}

impl Lightest {
    /// Reduced mass in kg; zero if nothing can move.
    fn reduced_mass(&self) -> f64 {
        match self.inverse_mass > 0.0 {
            true => 1.0 / self.inverse_mass,
            false => 0.0,
        }
    }

    fn of(world: &World) -> Self {
        let p = world.particles();
        let mobile = || (0..p.len()).filter(|&i| world.inverse_mass(i) > 0.0);
        let by_mass = |i: &usize, j: &usize| p.mass[*i].total_cmp(&p.mass[*j]);
        let first = mobile().min_by(by_mass);
        let second = mobile().filter(|&i| Some(i) != first).min_by(by_mass);
        let inverse = |i: usize| 1.0 / p.mass[i];
        Self {
            inverse_mass: first.into_iter().chain(second).map(inverse).sum(),
            mass: first.map_or(f64::INFINITY, |i| p.mass[i]),
            inverse_inertia: first.map_or(0.0, |i| p.inverse_inertia_factor(i)),
            radius: p.radius.iter().copied().fold(f64::INFINITY, f64::min),
        }
    }
}

/// Bound from one oscillation; `k` and `c` are stiffness and damping per mass, in 1/s^2 and 1/s.
fn pair_bound(world: &World, name: &'static str, meaning: &'static str, [k, c]: [f64; 2]) -> Bound {
    let oscillator = Oscillator {
        frequency_squared: k,
        damping_rate: c,
    };
    Bound {
        name,
        meaning,
        oscillator: Some(oscillator),
        step: critical_step(world.model().integrator, oscillator),
    }
}

/// Bounds from a contact of two particles, whether they touch now or not.
fn contact_bounds(world: &World, laws: ContactLaws, pair: &Lightest) -> Vec<Bound> {
    let per_mass = |constants: [f64; 2], inverse: f64| constants.map(|one| one * inverse);
    let normal = laws
        .normal
        .linearised([pair.radius; 2], pair.reduced_mass());
    let mut bounds = vec![pair_bound(
        world,
        "contact normal",
        "collision of the two lightest particles",
        per_mass(normal, pair.inverse_mass),
    )];
    if let Some(law) = laws.tangential {
        // For equal spheres 1 + m r^2 / J is 7/2.
        let roll = pair.inverse_mass * (1.0 + pair.inverse_inertia);
        bounds.push(pair_bound(
            world,
            "contact tangential",
            "sticking or viscous slip of the two lightest particles",
            per_mass(law.constants(), roll),
        ));
    }
    bounds
}

/// Bounds from the oscillations of a beam of two of the lightest particles.
fn bond_bounds(world: &World, laws: BondLaws, pair: &Lightest) -> Vec<Bound> {
    let law = laws.normal;
    let push = pair.inverse_mass;
    let mut bounds = vec![pair_bound(
        world,
        "bond axial",
        "stretching of a two-particle beam",
        [push * law.stiffness, push * law.damping],
    )];
    if let Some(beam) = laws.tangential {
        // Equal particles in touch, rotating in the same and in opposite senses: 7/2 k / m and 5/2 k / m for spheres.
        let turns = [
            ("bond shear", "both ends rotate in the same sense", 1.0),
            ("bond bending", "both ends rotate in opposite senses", 0.0),
        ];
        for (name, meaning, shift) in turns {
            let inverse = (shift + pair.inverse_inertia) / pair.mass;
            let constants = [inverse * beam.stiffness, inverse * beam.damping];
            bounds.push(pair_bound(world, name, meaning, constants));
        }
    }
    bounds
}

/// Bounds (61) and (62), if the law gives elastic constants.
fn wave_bounds(laws: ContactLaws, density: f64, radius: f64) -> Vec<Bound> {
    let ContactNormal::Bshp(law) = laws.normal else {
        return Vec::new();
    };
    let elastic = Elastic {
        youngs_modulus: law.youngs_modulus,
        poissons_ratio: law.poissons_ratio,
    };
    let bound = |name, meaning, step| Bound {
        name,
        meaning,
        oscillator: None,
        step,
    };
    vec![
        bound(
            "wave",
            "a primary wave crosses the smallest particle (61)",
            wave_bound(elastic, density, radius),
        ),
        bound(
            "crack",
            "a crack at Mach 15 crosses the smallest particle (62)",
            crack_bound(elastic, density, radius, MACH_NUMBER),
        ),
    ]
}
