//! One dimensionless collision over all stiffnesses, sizes, damping ratios and positions.

use super::pairs::{free, kelvin_voigt, mass, model, restitution, world};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
    unit_in_last_place,
};
use crate::oracles::oscillator::truncated_restitution;
use gouge_common::geometry::Domain;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::particles::Particles;
use gouge_dem::{Start, World};
use gouge_runner::scene::wrap;

pub(super) fn checks() -> Vec<Check> {
    let check = |id, claim, scene, reason, measure| Check {
        id,
        claim,
        equations: thesis("(36), (54)"),
        scene,
        oracle: "Closed form of the restitution of the truncated oscillator",
        norm: "Error of the restitution over its bound",
        origin: Origin::Convergent,
        reason,
        effort: Effort::Quick,
        measure,
    };
    vec![
        check(
            "extremes.stiffness",
            "Over twelve decades of stiffness the restitution of a collision is the same, up to rounding of positions.",
            "Two spheres of 1 mm collide head on at 0.1 m/s, damping ratio 0.2, stiffness 1e2 to 1e14 kg/s^2 in half decades; velocity Verlet, time step 1e-3 over the frequency",
            "h^2 from the method. If the overlap v / w is so small that positions are coarse, each step rounds by half a unit in the last place of the radius; four standard deviations of a random random_walk of N steps are 4 sqrt(N / 12) ulp / (v / w)",
            stiffness,
        ),
        check(
            "extremes.sizes",
            "A sphere rebounds from a sphere up to 1e4 times as large, 1e12 times as heavy, with the same restitution as from a wall.",
            "A sphere of radius 1 mm and one of up to 10 m collide head on at 0.1 m/s, damping ratio 0.2, stiffness 1e4 kg/s^2; velocity Verlet, time step 1e-3 over the frequency",
            "h^2, and a random random_walk of roundings of the larger position, as for extremes.stiffness",
            sizes,
        ),
        check(
            "extremes.damping",
            "The restitution follows its closed form from one, at damping ratios down to 1e-9, to zero, at 1e4.",
            "Two spheres of 1 mm collide head on, damping ratios 1e-9 to 1e4 in decades; velocity Verlet, time step 1e-3 over the fastest rate",
            "At most h^2; above critical damping h times the restitution, because the force vanishes within a step; plus the rounding of positions over the overlap",
            damping,
        ),
        check(
            "extremes.places",
            "A collision up to 1e9 box widths from the origin has the same restitution as at the origin, up to rounding of positions. In a periodic box, where positions are wrapped, it is the same to the last bit.",
            "Two spheres collide head on with an overlap of 0.1 mm, up to 1.25e8 m from the origin; a box of 0.125 m, open and periodic",
            "h^2, plus the initial overlap of 2^-26 m times twice the damping ratio, and half a unit in the last place of the position per step, in the worst case all of the same sign; both over the overlap",
            places,
        ),
    ]
}

const SPEED: f64 = 0.1;
const H: f64 = 1e-3;

/// Four standard deviations of the sum of the roundings of a position over the given number of steps.
fn random_walk(steps: f64, place: f64) -> f64 {
    4.0 * (steps / 12.0).sqrt() * unit_in_last_place(place)
}

/// The measurements of a parameter sweep, plotted against the parameter.
fn sweep(title: &str, parameter: Axis, found: Vec<(f64, Measurement)>) -> Outcome {
    let points = |of: fn(&Measurement) -> f64| {
        found
            .iter()
            .map(|(x, one)| [*x, of(one)])
            .collect::<Vec<_>>()
    };
    let bound = Curve::dashed("bound", points(|one| one.tolerance));
    let plot = Figure::new(
        title.to_owned(),
        parameter,
        Axis::logarithmic("error of the restitution", ""),
        vec![bound, Curve::marks("kernel", points(|one| one.error))],
    );
    Ok(Measurement::worst(found.iter().map(|(_, one)| *one)).showing([Exhibit::Figure(plot)]))
}

/// Two touching spheres of the given radii and damping ratio collide along x, the first one moving.
/// Returns their restitution and the scale of the overlap.
fn collide(radii: [f64; 2], k: f64, zeta: f64, h: f64) -> Result<[f64; 2], Failure> {
    let [a, b] = radii.map(mass);
    let reduced = a * b / (a + b);
    let rate = (k / reduced).sqrt();
    let damping = 2.0 * zeta * (k * reduced).sqrt();
    let contact = kelvin_voigt(k, damping, ContactDistance::Radius, None);
    let step = h / (rate * (1.0_f64).max(2.0 * zeta));
    // The contact point is the origin, up to three units in the last place, which make the spheres
    // overlap.
    let place = radii[1] - 3.0 * unit_in_last_place(radii[0] + radii[1]);
    let particles = [
        free([-radii[0], 0.0], [SPEED, 0.0], radii[0]),
        free([place, 0.0], [0.0; 2], radii[1]),
    ];
    let mut world = world(model(contact, step), &particles)?;
    // The force vanishes within thirty units of the fastest rate; an overdamped pair separates much
    // later.
    Ok([restitution(&mut world, (30.0 / h) as u64)?, SPEED / rate])
}

fn stiffness() -> Outcome {
    let (radius, zeta) = (1e-3, 0.2);
    let e = truncated_restitution(zeta);
    let mut found = Vec::new();
    for half in 4..=28 {
        let k = 10.0_f64.powf(0.5 * f64::from(half));
        let [measured, overlap] = collide([radius; 2], k, zeta, H)?;
        let tolerance = H * H + random_walk(3.0 / H, radius) / overlap;
        found.push((k, Measurement::absolute(e, measured, tolerance)));
    }
    sweep(
        "Error of the restitution over twelve decades of stiffness",
        Axis::logarithmic("stiffness", "kg/s²"),
        found,
    )
}

fn sizes() -> Outcome {
    let (radius, zeta) = (1e-3, 0.2);
    let e = truncated_restitution(zeta);
    let mut found = Vec::new();
    for decade in 0..=4 {
        let ratio = 10.0_f64.powi(decade);
        let [measured, overlap] = collide([radius, ratio * radius], 1e4, zeta, H)?;
        let tolerance = H * H + random_walk(3.0 / H, ratio * radius) / overlap;
        found.push((ratio, Measurement::absolute(e, measured, tolerance)));
    }
    sweep(
        "Error of the restitution over ratios of radii",
        Axis::logarithmic("ratio of the radii", ""),
        found,
    )
}

fn damping() -> Outcome {
    let radius = 1e-3;
    let mut found = Vec::new();
    for decade in -9..=4 {
        let zeta = 10.0_f64.powi(decade);
        let e = truncated_restitution(zeta);
        let [measured, overlap] = collide([radius; 2], 1e4, zeta, H)?;
        let rounding = random_walk(3.0 / H, radius) / overlap;
        let tolerance = H * H.min(1.0 / zeta) + rounding + if zeta > 1.0 { H * e } else { 0.0 };
        found.push((zeta, Measurement::absolute(e, measured, tolerance)));
    }
    sweep(
        "Error of the restitution over damping ratios",
        Axis::logarithmic("damping ratio", ""),
        found,
    )
}

/// Width of the box, a power of two, so that its multiples are exact.
const WIDTH: f64 = 0.125;
/// Initial overlap: the spacing of numbers at the largest distance.
const GAP: f64 = 1.0 / 67_108_864.0;

/// Restitution of a collision at a distance from the origin, and the final positions.
fn far(distance: f64, periodic: bool) -> Result<(f64, [f64; 2]), Failure> {
    // Radius, overlap and speed are multiples of 2^-26 m, the spacing of numbers at 1.25e8 m.
    let (radius, gap, speed) = (0.0078125, GAP, 0.25);
    let k = 2.0 * mass(radius) * (speed / 1e-4) * (speed / 1e-4);
    let damping = 2.0 * 0.2 * (k * 0.5 * mass(radius)).sqrt();
    let contact = kelvin_voigt(k, damping, ContactDistance::Radius, None);
    let rate = (2.0 * k / mass(radius)).sqrt();
    let mut model = model(contact, H / rate);
    model.domain = Domain {
        width: Some(WIDTH),
        height: None,
        periodic,
    };
    let ball = |x: f64, v: f64| free([x, 0.0], [v, 0.0], radius);
    let place = distance + 0.0625;
    let particles = [
        ball(place - radius, speed),
        ball(place + radius - gap, -speed),
    ];
    let mut particles: Particles = particles.into_iter().collect();
    wrap(&model.domain, &mut particles);
    let mut world = World::new(model, particles, &Start::default())?;
    let e = restitution(&mut world, 20_000)?;
    let x = &world.particles().position;
    Ok((e, [x[0].x, x[1].x]))
}

fn places() -> Outcome {
    let e = truncated_restitution(0.2);
    let (origin, at_origin) = far(0.0, true)?;
    let (mut found, mut same_everywhere) = (Vec::new(), Vec::new());
    for decade in 0..=9 {
        let distance = WIDTH * 10.0_f64.powi(decade);
        let (measured, _) = far(distance, false)?;
        let overlap = 1e-4;
        let lost = 0.4 * GAP + (3.0 / H) * 0.5 * unit_in_last_place(distance);
        let tolerance = H * H + lost / overlap;
        found.push((distance, Measurement::absolute(e, measured, tolerance)));
        let (wrapped, places) = far(distance, true)?;
        let same = wrapped == origin && places == at_origin;
        same_everywhere.push(Measurement::count(usize::from(!same)));
    }
    let mut finding = sweep(
        "Error of the restitution over distances from the origin",
        Axis::logarithmic("distance from the origin", "m"),
        found,
    )?;
    same_everywhere.push(finding.measurement);
    finding.measurement = Measurement::worst(same_everywhere);
    Ok(finding)
}
