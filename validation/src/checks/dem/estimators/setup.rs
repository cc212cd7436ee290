//! Sizes, lattices, bonds and faults.

use crate::checks::{Check, Effort, Evidence, Failure, Measurement, Origin, Outcome, thesis};
use crate::scenes::Draft;
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::AdjustedKelvinVoigt;
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::setup::{
    Arrangement, Fault, Lattice, REACH, SizeRange, bonds_within, draw_radii, is_above,
    strength_factors,
};

pub fn checks() -> Vec<Check> {
    vec![sizes(), lattice(), perturbed(), fault(), reach(), factors()]
}

fn sizes() -> Check {
    Check {
        id: "estimators.setup.sizes",
        claim: "The interval of radii has the requested mean, and its ends have the ratio sqrt(2); radii divide the interval as their random numbers divide [0, 1).",
        equations: thesis("(66)"),
        scene: "Intervals around 1 mm and 0.37 m; random numbers 0, 1/4, 1/2 and 1",
        oracle: "The two defining properties of the interval",
        norm: "Error of mean, ratio and radii in units in the last place",
        origin: Origin::Exact,
        reason: "At most four roundings each",
        effort: Effort::Quick,
        measure: measure_sizes,
    }
}

fn measure_sizes() -> Outcome {
    let mut all = Vec::new();
    for mean in [1e-3, 0.37] {
        let range = SizeRange::around(mean);
        let SizeRange { minimum, maximum } = range;
        all.push(Measurement::ulp(mean, 0.5 * (minimum + maximum), 4.0));
        all.push(Measurement::ulp(2.0_f64.sqrt(), maximum / minimum, 4.0));
        let mut fractions = [0.0, 0.25, 0.5, 1.0].into_iter();
        let radii = draw_radii(range, 4, || fractions.next().unwrap_or(f64::NAN));
        let quarter = 0.75 * minimum + 0.25 * maximum;
        for (expected, found) in [minimum, quarter, mean, maximum].iter().zip(radii) {
            all.push(Measurement::ulp(*expected, found, 4.0));
        }
    }
    Ok(Measurement::worst(all).into())
}

fn lattice() -> Check {
    Check {
        id: "estimators.setup.lattice",
        claim: "An inner point of a square lattice has four neighbours at the pitch, a point of a hexagonal lattice six, and no neighbour is closer.",
        equations: thesis("(103)"),
        scene: "Lattices of nine by nine points with a pitch of 2.3 mm, with the first point away from the origin",
        oracle: "Equal neighbour distances, which define the lattices",
        norm: "Relative error of the first distances from the middle point, and distance of the first point from the origin of the lattice",
        origin: Origin::Exact,
        reason: "Differences of positions of up to nine pitches lose 20 units in the last place",
        effort: Effort::Quick,
        measure: measure_lattice,
    }
}

fn measure_lattice() -> Outcome {
    const COLUMNS: usize = 9;
    let (pitch, origin) = (2.3e-3, Vec2::new(0.4e-3, -0.7e-3));
    let mut all = Vec::new();
    for (arrangement, neighbors) in [(Arrangement::Square, 4), (Arrangement::Hexagonal, 6)] {
        let lattice = Lattice {
            arrangement,
            pitch,
            columns: COLUMNS,
            origin,
        };
        let middle = COLUMNS * COLUMNS / 2;
        let from = lattice.point(middle);
        let mut distances: Vec<f64> = (0..COLUMNS * COLUMNS)
            .filter(|&k| k != middle)
            .map(|k| (lattice.point(k) - from).norm())
            .collect();
        distances.sort_by(f64::total_cmp);
        for &distance in &distances[..neighbors] {
            all.push(Measurement::relative(pitch, distance, 1e-14));
        }
        let next = if neighbors == 4 { 2.0_f64 } else { 3.0 }.sqrt() * pitch;
        all.push(Measurement::relative(next, distances[neighbors], 1e-14));
        let first = lattice.point(0) - origin;
        all.push(Measurement::absolute(0.0, first.norm(), 0.0));
    }
    Ok(Measurement::worst(all).into())
}

fn perturbed() -> Check {
    Check {
        id: "estimators.setup.perturbation",
        claim: "Points are displaced uniformly over a disc: a fraction of the random numbers covers the same fraction of its area and of its directions.",
        equations: Evidence::NONE,
        scene: "Discs of 50 um, area fractions 1/4 and 4/9, directions in steps of an eighth of a turn",
        oracle: "Radius as the square root of the area fraction; directions by symmetry",
        norm: "Largest error of a displacement in units of the radius of the disc",
        origin: Origin::Exact,
        reason: "In positions of 2 mm, displacements of 50 um are accurate to a relative 1e-14",
        effort: Effort::Quick,
        measure: measure_perturbed,
    }
}

fn measure_perturbed() -> Outcome {
    let radius = 50e-6;
    let lattice = Lattice {
        arrangement: Arrangement::Square,
        pitch: 2e-3,
        columns: 3,
        origin: Vec2::zero(),
    };
    let half = 0.5_f64.sqrt();
    let directions = [
        [1.0, 0.0],
        [half, half],
        [0.0, 1.0],
        [-half, half],
        [-1.0, 0.0],
        [-half, -half],
        [0.0, -1.0],
        [half, -half],
    ];
    let mut all = Vec::new();
    for (area, share) in [(0.25, 0.5), (4.0 / 9.0, 2.0 / 3.0)] {
        for (eighth, direction) in directions.iter().enumerate() {
            let mut numbers = [area, eighth as f64 / 8.0].into_iter();
            let point = lattice.perturbed_point(4, radius, || numbers.next().unwrap_or(f64::NAN));
            let moved = point - Vec2::new(2e-3, 2e-3);
            for (found, along) in [moved.x, moved.y].into_iter().zip(direction) {
                all.push(Measurement::scaled(
                    share * radius * along,
                    found,
                    radius,
                    1e-13,
                ));
            }
        }
    }
    Ok(Measurement::worst(all).into())
}

fn fault() -> Check {
    Check {
        id: "estimators.setup.fault",
        claim: "A jagged fault separates points that lie a relative 1e-8 of its height above and below it.",
        equations: thesis("(70)-(71)"),
        scene: "A fault at 25 mm with seven jags of 4 mm over 50 mm, at phases of whole, quarter and twelfth turns; a straight fault",
        oracle: "Sines of 0, 30, 90, 150, 210 and 270 degrees",
        norm: "Number of points on the wrong side",
        origin: Origin::Exact,
        reason: "Phases of up to seven turns are rounded by 1e-14",
        effort: Effort::Quick,
        measure: measure_fault,
    }
}

fn measure_fault() -> Outcome {
    let (level, width, jags) = (25e-3, 50e-3, 7.0);
    let sines = [
        (0.0, 0.0),
        (1.0, 0.5),
        (3.0, 1.0),
        (5.0, 0.5),
        (7.0, -0.5),
        (9.0, -1.0),
    ];
    let mut wrong = 0;
    for height in [4e-3, 0.0] {
        let fault = Fault {
            level,
            height,
            jags,
            width,
        };
        for jag in 0..7 {
            for (twelfths, sine) in sines {
                let x = width / jags * (f64::from(jag) + twelfths / 12.0);
                let y = level + 0.5 * height * sine;
                let near = 4e-11;
                wrong += usize::from(!is_above(&fault, Vec2::new(x, y + near)));
                wrong += usize::from(is_above(&fault, Vec2::new(x, y - near)));
            }
        }
        // Points on the line belong to the upper half.
        wrong += usize::from(!is_above(&fault, Vec2::new(0.0, level)));
    }
    Ok(Measurement::count(wrong).into())
}

fn reach() -> Check {
    Check {
        id: "estimators.setup.reach",
        claim: "Bonds reach the requested multiple of the sum of radii, by default sqrt(3/2), also across the seam of a periodic box.",
        equations: Evidence::NONE,
        scene: "Pairs of unequal grains at a relative distance of 1e-7 below and above reaches of 1.1, 1.5 and the default, in both orders, in open space and across a seam",
        oracle: "Distances by construction",
        norm: "Number of wrong or missing bonds, and error of the square of the default in units in the last place",
        origin: Origin::Exact,
        reason: "Counting; the square of a rounded root is off by up to two units",
        effort: Effort::Quick,
        measure: measure_reach,
    }
}

fn grain(x: f64, radius: f64) -> Particle {
    Particle {
        position: Vec2::new(x, 5e-3),
        velocity: Vec2::zero(),
        angle: 0.0,
        angular_velocity: 0.0,
        radius,
        density: 2700.0,
        inertia_factor: SPHERE_INERTIA_FACTOR,
        role: Role::Free,
    }
}

fn measure_reach() -> Outcome {
    let width = 20e-3;
    let default = 1.5_f64.sqrt();
    let told = default_reach()?;
    let mut wrong = 0;
    for (reach, multiple) in [(1.1, 1.1), (1.5, 1.5), (REACH, default), (told, default)] {
        for (factor, expected) in [(1.0 - 1e-7, 1), (1.0 + 1e-7, 0)] {
            for radii in [[1.3e-3, 0.8e-3], [0.8e-3, 1.3e-3]] {
                let distance = multiple * factor * (radii[0] + radii[1]);
                for (start, periodic) in [(4e-3, false), (4e-3, true), (19e-3, true)] {
                    let second = (start + distance).rem_euclid(width);
                    let particles: Particles = [grain(start, radii[0]), grain(second, radii[1])]
                        .into_iter()
                        .collect();
                    let domain = Domain {
                        width: Some(width),
                        height: Some(10e-3),
                        periodic,
                    };
                    let found = bonds_within(&particles, &domain, reach).len();
                    wrong += usize::from(found != expected);
                }
            }
        }
    }
    Ok(Measurement::worst([
        Measurement::count(wrong),
        Measurement::ulp(1.5, REACH * REACH, 2.0),
        Measurement::ulp(1.5, told * told, 2.0),
    ])
    .into())
}

/// The reach used if a scene does not state one.
fn default_reach() -> Result<f64, Failure> {
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-7)
        .with("box.width", 20e-3)
        .with("box.height", 20e-3)
        .with("setup.seed", 1)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .with("setup.sizes.mean", 1e-3)
        .with("setup.lattice.rows", 3)
        .with_table("setup.bonding");
    let scene = draft.scene()?;
    let bonding = scene.setup.and_then(|setup| setup.bonding);
    bonding
        .map(|bonding| bonding.reach)
        .ok_or_else(|| Failure::Oracle("no bonding".to_owned()))
}

fn factors() -> Check {
    Check {
        id: "estimators.setup.strength-factors",
        claim: "Strength factors divide their interval around one as their random numbers divide [0, 1).",
        equations: thesis("(50)"),
        scene: "A spread of 0.3; random numbers 0, 1/4, 1/2, 7/8",
        oracle: "Linear interpolation",
        norm: "Error in units in the last place",
        origin: Origin::Exact,
        reason: "At most three roundings",
        effort: Effort::Quick,
        measure: measure_factors,
    }
}

fn measure_factors() -> Outcome {
    let mut numbers = [0.0, 0.25, 0.5, 0.875].into_iter();
    let found = strength_factors(4, 0.3, || numbers.next().unwrap_or(f64::NAN));
    let pairs = [0.7, 0.85, 1.0, 1.225].into_iter().zip(found);
    let all = pairs.map(|(expected, found)| Measurement::ulp(expected, found, 3.0));
    Ok(Measurement::worst(all).into())
}
