//! Estimators.

use super::random::Random;
use super::scenes::{advance, head, particle, world};
use super::{Axis, Check, Curve, Effort, Exhibit, Measurement, Origin, Outcome, Plot, Topic};
use crate::oracles::arcs::{components, fraction_inside};
use gouge_kernel::estimators::{
    Region, connected, coordination_number, friction_feedback, friction_load, mean_stress,
    packing_fraction, radial_distribution, visible_fraction,
};
use gouge_kernel::geometry::Vec2;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::f64::consts::{FRAC_PI_4, PI};

/// The topic.
pub fn topic() -> Topic {
    let check = |id, claim, equations| Check {
        id,
        claim,
        equations,
        scene: "",
        oracle: "",
        norm: "Relative difference",
        origin: Origin::Exact,
        reason: "",
        effort: Effort::Quick,
        measure: || Err(super::Failure::Oracle(String::new())),
    };
    Topic {
        id: "estimators",
        title: "Estimators",
        about: "What is read off a state, against states whose answer is known.",
        checks: vec![
            Check {
                scene: "3000 independent points in a periodic strip of 40 by 20",
                oracle: "g = 1; pairs in a ring are nearly Poisson distributed",
                norm: "Sum over eight rings of the squared deviation of g from one, in units of its variance, over the quantile of chi squared",
                origin: Origin::Statistical,
                reason: "Significance 1e-4 with eight degrees of freedom; a deviation of 2 % in one ring, six standard deviations, is found with a power above 0.95",
                measure: gas,
                ..check(
                    "estimators.ideal-gas",
                    "The radial distribution of an ideal gas is one, and edges do not bend it.",
                    "(80)-(83)",
                )
            },
            Check {
                scene: "Square lattice of 40 by 20 points, periodic in x",
                oracle: "Four neighbours at the distances 1, root 2 and 2, eight at root 5, all circles weighted by their exact visible parts",
                norm: "Relative difference of the area under each shell, in units of the first",
                reason: "The kernel integrates to one; its sampling at 400 points a bandwidth leaves (1/400)^2 of an edge",
                origin: Origin::Convergent,
                measure: lattice,
                ..check(
                    "estimators.lattice",
                    "The radial distribution of a lattice has its shells where and as large as they are.",
                    "(80)-(83)",
                )
            },
            Check {
                scene: "20 000 random points and radii, periodic and open",
                oracle: "Arcs between the points where the circle crosses the edges",
                norm: "Largest difference",
                reason: "A few roundings of inverse sines and cosines, amplified by the root of the rounding where a circle touches an edge",
                measure: visible,
                ..check(
                    "estimators.visible",
                    "The visible part of a circle is the part of it inside the region.",
                    "(80)",
                )
            },
            Check {
                scene: "400 random graphs of up to 300 nodes",
                oracle: "Components found by walking the graph",
                norm: "Graphs with another number of components, or with labels that part an edge",
                reason: "A count that must be zero",
                measure: fragments,
                ..check(
                    "estimators.fragments",
                    "Fragments are the connected components of the bonds.",
                    "-",
                )
            },
            Check {
                scene: "A driven grain pulled at 2 m/s through creeping drag of 10 Pa s and pressed with 3 N",
                oracle: "6 pi eta r v over the load, from both sides",
                reason: "Some ten roundings of forces and of their ratio",
                measure: friction,
                ..check(
                    "estimators.friction",
                    "Friction of a driven grain with known forces is their ratio, from load and from reaction.",
                    "(85), (86)",
                )
            },
            Check {
                scene: "Ten bonded spheres in a row, stretched by 1e-3; touching discs",
                oracle: "Stiffness times elongation over the section; pi / 4; 18 links on ten grains",
                reason: "The elongation of 2 um is a difference of positions of up to 18 mm: 1e-12, and some roundings",
                measure: packed,
                ..check(
                    "estimators.chain",
                    "Stress of a loaded chain, packing fraction of touching discs and coordination number are what they are by hand.",
                    "(68)",
                )
            },
        ],
    }
}

const STRIP: Region = Region {
    width: 40.0,
    height: 20.0,
    periodic: true,
};

fn gas() -> Outcome {
    let mut random = Random::new(51);
    let number = 3000;
    let points: Vec<Vec2> = (0..number)
        .map(|_| {
            Vec2::new(
                random.between(0.0, STRIP.width),
                random.between(0.0, STRIP.height),
            )
        })
        .collect();
    let found = radial_distribution(&points, &STRIP, 0.1, 900);
    let density = number as f64 / (STRIP.width * STRIP.height);
    let ring = |k: usize| {
        let (low, high) = (1.0 + k as f64, 2.0 + k as f64);
        let inside = found
            .distance
            .iter()
            .zip(&found.g)
            .filter(|(d, _)| (low..high).contains(*d));
        let (sum, weight) = inside.fold((0.0, 0.0), |(sum, weight), (d, g)| {
            (sum + d * g, weight + d)
        });
        let pairs = 0.5 * number as f64 * density * PI * (high * high - low * low);
        (sum / weight - 1.0).powi(2) * pairs
    };
    let rings = 8;
    let measured: f64 = (0..rings).map(ring).sum();
    let limit = ChiSquared::new(rings as f64)
        .map_err(|error| super::Failure::Oracle(error.to_string()))?
        .inverse_cdf(1.0 - 1e-4);
    let points = found
        .distance
        .iter()
        .zip(&found.g)
        .filter(|(d, _)| **d > 0.3)
        .step_by(5)
        .map(|(&d, &g)| [d, g]);
    let plot = Plot {
        title: "Radial distribution of independent points".to_owned(),
        x: Axis::linear("distance in units of the length of the strip / 40"),
        y: Axis::linear("g"),
        curves: vec![
            Curve::line("one", [[0.3, 1.0], [10.0, 1.0]]),
            Curve::marks("estimated", points),
        ],
    };
    Ok(Measurement::scaled(0.0, measured, limit, 1.0).showing([Exhibit::Plot(plot)]))
}

fn lattice() -> Outcome {
    let points: Vec<[f64; 2]> = (0..800)
        .map(|k| [f64::from(k % 40) + 0.5, f64::from(k / 40) + 0.5])
        .collect();
    let vectors: Vec<Vec2> = points.iter().map(|&[x, y]| Vec2::new(x, y)).collect();
    let found = radial_distribution(&vectors, &STRIP, 0.1, 40_000);
    let spacing = found.distance[1] - found.distance[0];
    let under = |at: f64| {
        let near = found
            .distance
            .iter()
            .zip(&found.density)
            .filter(|(d, _)| (**d - at).abs() < 0.11);
        near.map(|(_, p)| p * spacing).sum::<f64>()
    };
    let weight = |way: [i32; 2]| {
        let at = (f64::from(way[0]).powi(2) + f64::from(way[1]).powi(2)).sqrt();
        let seen = points
            .iter()
            .filter(|point| (0.0..=20.0).contains(&(point[1] + f64::from(way[1]))));
        seen.map(|&point| 1.0 / fraction_inside(point, at, [f64::INFINITY, 20.0]))
            .sum::<f64>()
    };
    let shell = |ways: &[[i32; 2]]| ways.iter().map(|&way| weight(way)).sum::<f64>();
    let straight = |n: i32| [[n, 0], [-n, 0], [0, n], [0, -n]];
    let first = (under(1.0), shell(&straight(1)));
    let diagonal = shell(&[[1, 1], [1, -1], [-1, 1], [-1, -1]]);
    let knights = shell(&[
        [1, 2],
        [2, 1],
        [-1, 2],
        [-2, 1],
        [1, -2],
        [2, -1],
        [-1, -2],
        [-2, -1],
    ]);
    let others = [
        (2.0_f64.sqrt(), diagonal),
        (2.0, shell(&straight(2))),
        (5.0_f64.sqrt(), knights),
    ];
    let compare = |(at, weights): (f64, f64)| {
        Measurement::relative(weights / first.1, under(at) / first.0, 2e-5)
    };
    Ok(Measurement::worst(others.map(compare)).into())
}

fn visible() -> Outcome {
    let mut random = Random::new(52);
    let measured = (0..20_000).map(|_| {
        let region = Region {
            width: 4.0,
            height: 1.0,
            periodic: random.below(2) == 0,
        };
        let point = [random.between(0.0, 4.0), random.between(0.0, 1.0)];
        let radius = random.magnitude(1e-3, 1.0);
        let width = if region.periodic {
            f64::INFINITY
        } else {
            region.width
        };
        let exact = fraction_inside(point, radius, [width, region.height]);
        let found = visible_fraction(&region, Vec2::new(point[0], point[1]), radius);
        Measurement::absolute(exact, found, 16.0 * f64::EPSILON.sqrt() * 1e-3)
    });
    Ok(Measurement::worst(measured).into())
}

fn fragments() -> Outcome {
    let mut random = Random::new(53);
    let mut wrong = 0;
    for _ in 0..400 {
        let nodes = 1 + random.below(300);
        let edges: Vec<(usize, usize)> = (0..random.below(400))
            .map(|_| (random.below(nodes), random.below(nodes)))
            .collect();
        let found = connected(nodes, edges.iter().copied());
        let parted = edges.iter().any(|&(a, b)| found.label[a] != found.label[b]);
        let labels = found.label.iter().max().map_or(0, |last| last + 1);
        wrong += usize::from(
            parted || found.number != components(nodes, &edges) || labels != found.number,
        );
    }
    Ok(Measurement::count(wrong).into())
}

fn friction() -> Outcome {
    let text = head("symplectic-euler", 1e-6)
        + "[ambient]\nlaw = \"creeping\"\nviscosity = 10.0\n\
           [driving]\ncontroller = \"exact\"\nspeed = 2.0\npressure = 3.0\narea = 1.0\n"
        + "[[particles]]\nposition = [0.0, 0.0]\nvelocity = [2.0, 0.0]\nradius = 1e-3\nrole = \"driven\"\n";
    let mut world = world(&text)?;
    // The vertical speed at which drag takes half of the load makes both components of the reaction known.
    advance(&mut world, 100)?;
    world.evaluate_if_pending()?;
    let drag = 6.0 * PI * 10.0 * 1e-3;
    let falling = world.particles().velocity[0].y;
    let feedback = 2.0 / falling;
    Ok(Measurement::worst([
        Measurement::relative(drag * 2.0 / 3.0, friction_load(world.drive()), 1e-12),
        Measurement::relative(-feedback, friction_feedback(world.drive()), 1e-12),
    ])
    .into())
}

fn packed() -> Outcome {
    let mut text =
        head("velocity-verlet", 1e-9) + "[bond.normal]\nstiffness = 1e7\ndamping = 0.0\n";
    for i in 0..10 {
        text += &particle([f64::from(i) * 2.002e-3, 0.0], [0.0, 0.0], 0.0, 1e-3);
        if i > 0 {
            text += &format!(
                "[[bonds]]\nbetween = [{}, {i}]\ninitial_distance = 2e-3\n",
                i - 1
            );
        }
    }
    let world = world(&text)?;
    // Nine links of 2.002 mm fill nine such lengths of one square millimetre.
    let stress = mean_stress(&world, 9.0 * 2.002e-3 * 1e-6);
    Ok(Measurement::worst([
        Measurement::relative(1e7 * 2e-6 / 1e-6, stress[0][0], 1e-10),
        Measurement::relative(1.8, coordination_number(&world), 1e-15),
        Measurement::relative(FRAC_PI_4, packing_fraction(&[0.5; 100], 100.0), 1e-14),
        Measurement::absolute(
            0.0,
            stress[0][1].abs() + stress[1][0].abs() + stress[1][1].abs(),
            0.0,
        ),
    ])
    .into())
}
