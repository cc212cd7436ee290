//! Elastic moduli of bonded blocks, measured in tension.

use super::modes::bond;
use super::stiffness::{Rest, forces, inner};
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::oracles::beams::waves::{Lattice, technical};
use crate::oracles::beams::{Sphere, Springs};
use crate::scenes::Draft;
use gouge_common::scalar::Real;
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_runner::run::run_setup;
use gouge_scalars::DoubleDouble;
use nalgebra::DVector;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.lattice-moduli",
        claim: "A hexagonal block of spheres of 1 mm with k = 1e7 kg/s^2, as a slice of 2 mm, has a Young's modulus of 7.423 GPa and a Poisson's ratio of 1/7 with beams, and of 5.774 GPa and 1/3 with bars.",
        equations: thesis("(33), (43)-(45), (64)"),
        scene: "8 columns and 17 rows in a periodic box, the outer rows held and the upper one pulled; equilibrium from the derivatives of all forces, stresses from the kernel's forces in double-double",
        oracle: "Lattice elasticity: C11 = sqrt(3)/4 (3 k_n + k_s), C12 = sqrt(3)/4 (k_n - k_s), k_s = 2 k_t r^2 / D^2",
        norm: "Relative error of Young's modulus and Poisson's ratio",
        origin: Origin::Exact,
        reason: "Lattice positions are rounded by 2^-52 of 30 mm, 2e-15 of D; solving 360 equations of condition number 1e3 loses three more digits",
        effort: Effort::Quick,
        measure: moduli,
    }]
}

/// Thickness of the slice in m, the mean diameter.
pub const DEPTH: f64 = 2e-3;

/// The lattice of the thesis's spheres with its normal stiffness and the given tangential stiffness.
pub fn thesis_lattice(tangential: f64) -> Lattice {
    Lattice {
        sphere: Sphere {
            radius: 1e-3,
            density: 2700.0,
        },
        distance: 2e-3,
        springs: Springs {
            normal: 1e7,
            tangential,
        },
    }
}

/// A bonded hexagonal block, periodic along its rows, of beams or of bars.
pub fn hexagonal(
    lattice: &Lattice,
    columns: usize,
    rows: usize,
    beams: bool,
) -> Result<World, Failure> {
    let (radius, pitch) = (lattice.sphere.radius, lattice.distance);
    let bonds = bond(
        lattice.springs,
        Springs {
            normal: 0.0,
            tangential: 0.0,
        },
    );
    let bonds = match beams {
        true => bonds,
        false => bonds.without("bond.tangential"),
    };
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .and(&bonds)
        .replacing("material.density", lattice.sphere.density)
        .with("box.width", columns as f64 * pitch)
        .with("box.boundary", "periodic-x")
        .with("setup.seed", 0)
        .with("setup.sizes.minimum", radius)
        .with("setup.sizes.maximum", radius)
        .with("setup.lattice.arrangement", "hexagonal")
        .with("setup.lattice.pitch", pitch)
        .with("setup.lattice.columns", columns as i64)
        .with("setup.lattice.rows", rows as i64)
        .with("setup.lattice.origin", vec![0.0, 0.0])
        .with("setup.bonding.reach", 0.55 * pitch / radius);
    Ok(run_setup(&draft.scene()?)?)
}

/// Response of a pulled block.
pub struct Pulled {
    /// Stress over strain along the pull in N/m, at zero lateral strain.
    pub modulus: f64,
    /// Lateral stress over stress along the pull.
    pub lateral: f64,
    /// Force in N on the lower grip over the displacement of the upper one in m.
    pub force: f64,
    /// The prescribed displacement of each held coordinate.
    pub held: Vec<Option<f64>>,
    /// Displacement of every coordinate for a unit displacement of the upper grip.
    pub displacement: Vec<f64>,
}

impl Pulled {
    /// Young's modulus in Pa of a slice and Poisson's ratio, if isotropic.
    pub fn technical(&self) -> [f64; 2] {
        let [young, poisson] = technical([self.modulus, self.lateral * self.modulus]);
        [young / DEPTH, poisson]
    }
}

/// Pulls a block of the given width apart: particles below the lower height are held, those above the
/// upper height are lifted. Particles without bonds are held too.
pub fn pull(rest: &Rest, width: f64, grips: [f64; 2]) -> Result<Pulled, Failure> {
    let slopes = rest.stiffness()?;
    let heights: Vec<f64> = rest.particles().position.iter().map(|x| x.y).collect();
    let hold = |n: usize| {
        let (height, lifts) = (heights[n / 3], n % 3 == 1);
        if height > grips[1] {
            Some(f64::from(u8::from(lifts)))
        } else {
            (height < grips[0] || slopes[(n, n)] == 0.0).then_some(0.0)
        }
    };
    let held: Vec<Option<f64>> = (0..rest.coordinates()).map(hold).collect();
    let free: Vec<usize> = (0..held.len()).filter(|&n| held[n].is_none()).collect();
    let given = DVector::from_iterator(held.len(), held.iter().map(|u| u.unwrap_or(0.0)));
    let pushed = -(&slopes * &given);
    let load = DVector::from_iterator(free.len(), free.iter().map(|&n| pushed[n]));
    let loose = || Failure::Oracle("the block has no stiffness".to_owned());
    let solved = inner(&slopes, &free)
        .cholesky()
        .ok_or_else(loose)?
        .solve(&load);
    let mut displacement: Vec<f64> = given.iter().copied().collect();
    free.iter()
        .zip(solved.iter())
        .for_each(|(&n, &u)| displacement[n] = u);
    let [force, strain, lateral] = responses(rest, &displacement, grips)?;
    Ok(Pulled {
        modulus: force / width / strain,
        force,
        lateral,
        held,
        displacement,
    })
}

/// Displacement in m of the upper grip, small enough for quadratic terms to be negligible.
const LIFT: f64 = 1e-17;

/// Force on the lower grip and strain of the middle half, both per unit of lift, and the ratio of
/// lateral to axial stress.
fn responses(rest: &Rest, displacement: &[f64], grips: [f64; 2]) -> Result<[f64; 3], Failure> {
    let lifted: Vec<DoubleDouble> = displacement
        .iter()
        .map(|&u| DoubleDouble::from_f64(u) * LIFT)
        .collect();
    let world = rest.displaced(&lifted)?;
    let position = &rest.particles().position;
    let pulls = forces(&world);
    let below = (0..position.len()).filter(|&i| position[i].y < grips[0]);
    let force: f64 = below.map(|i| pulls[3 * i + 1].to_f64()).sum::<f64>() / LIFT;
    let quarter = 0.25 * (grips[1] - grips[0]);
    let gauge = grips[0] + quarter..grips[1] - quarter;
    let inside = (0..position.len()).filter(|&i| gauge.contains(&position[i].y));
    let points = inside
        .map(|i| [position[i].y, displacement[3 * i + 1]])
        .collect::<Vec<_>>();
    let mut stress = [0.0; 2];
    for link in world.interactions() {
        let (i, j) = link.pair.indices();
        if gauge.contains(&(0.5 * (position[i].y + position[j].y))) {
            let force = link.normal * link.normal_force
                + link.normal.perpendicular() * link.tangential_force;
            stress[0] += force.x * link.normal.x * link.distance;
            stress[1] += force.y * link.normal.y * link.distance;
        }
    }
    Ok([force, slope(&points), stress[0] / stress[1]])
}

/// Slope of the least-squares line.
fn slope(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let mean = |n: usize| points.iter().map(|point| point[n]).sum::<f64>() / count;
    let middle = [mean(0), mean(1)];
    let sum = |n: usize| {
        points
            .iter()
            .map(move |p| (p[0] - middle[0]) * (p[n] - middle[n]))
            .sum::<f64>()
    };
    sum(1) / sum(0)
}

/// Young's modulus in Pa and Poisson's ratio of the pulled lattice.
pub fn pulled_lattice(lattice: &Lattice, beams: bool) -> Result<[f64; 2], Failure> {
    let (columns, rows) = (8, 17);
    let rest = Rest::of(&hexagonal(lattice, columns, rows, beams)?);
    let height = (rows - 1) as f64 * 0.75_f64.sqrt() * lattice.distance;
    let margin = 0.1 * lattice.distance;
    let width = columns as f64 * lattice.distance;
    Ok(pull(&rest, width, [margin, height - margin])?.technical())
}

fn moduli() -> Outcome {
    let mut measured = Vec::new();
    for tangential in [1e7, 0.3e7, 0.0] {
        let lattice = thesis_lattice(tangential);
        let [young, poisson] = technical(lattice.hexagonal_moduli());
        let found = pulled_lattice(&lattice, tangential > 0.0)?;
        measured.push(Measurement::relative(young / DEPTH, found[0], 1e-12));
        measured.push(Measurement::relative(poisson, found[1], 1e-12));
    }
    Ok(Measurement::worst(measured).into())
}
