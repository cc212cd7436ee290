//! The thesis's model with stiffer and stiffer contacts.

use super::system::{System, exact_steps, law, moving};
use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Evidence, Exhibit, Failure, Figure, Measurement, Origin, Outcome,
    azema, thesis,
};
use crate::scenes::{Draft, Grain};
use gouge_contact_dynamics::law::GapRule;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;
use std::collections::BTreeMap;
use std::f64::consts::PI;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.hard-limit",
        claim: "The contact forces of a heap of elastic discs approach those of rigid ones as the inverse of the stiffness.",
        equations: both(),
        scene: "A heap without friction: three, two and one disc of 1 kg and 1 m in the hollows of four fixed ones 1.05 m apart, so that all forces are determined; thesis's model with Kelvin-Voigt contacts of 1e4 to 1e8 N/m, at rest",
        oracle: "Either kernel is the other's; they share no code for forces",
        norm: "Largest error of the observed order in 1/k, from decade to decade",
        origin: Origin::Convergent,
        reason: "Forces change by the compression over the diameter, F/(k d) = 1e-3 at 1e4 N/m and g = 10 m/s^2, times a constant of geometry; the next term changes the first observed order by a few times 1e-3. At 1e8 N/m, rounding of positions of 2 m makes forces uncertain by 4e-8 N of a difference of 1e-5 N: 2e-3. 0.02",
        effort: Effort::Thorough,
        measure: hard_limit,
    }]
}

fn both() -> Evidence {
    azema("(A1)-(A2), (A15)-(A18)").and(thesis("(8)-(10), (35)-(36)"))
}

const GRAVITY: f64 = 10.0;
const RADIUS: f64 = 0.5;
const SPACING: f64 = 1.05;

/// Centres of the discs of each row, the fixed ones first.
fn centres() -> Vec<[f64; 2]> {
    let half = 0.5 * SPACING;
    let rise = (4.0 * RADIUS * RADIUS - half * half).sqrt();
    let row = |k: usize| {
        let disc = move |j: usize| [SPACING * j as f64 + half * k as f64, rise * k as f64];
        (0..4 - k).map(disc)
    };
    (0..4).flat_map(row).collect()
}

/// Normal forces in N by pair.
type Forces = BTreeMap<(usize, usize), f64>;

fn rigid() -> Result<Forces, Failure> {
    let mut system = System::new(exact_steps(1e-3, law(0.0, 0.0, GapRule::Predicted)));
    for (index, at) in centres().into_iter().enumerate() {
        if index < 4 {
            system.fixed_disc(RADIUS, at)?;
        } else {
            let density = 1.0 / (PI * RADIUS * RADIUS);
            system.dense_body((0, density), RADIUS, at, 0.0, moving(0.0, 0.0, 0.0))?;
        }
    }
    system.gravity([0.0, -GRAVITY]);
    system.steps(2);
    let keys = system.workspace().map_or(&[][..], |found| found.keys());
    let forces = system.forces();
    let pairs = keys.iter().map(|key| key.pair.indices());
    Ok(pairs.zip(forces.iter().map(|force| force.n)).collect())
}

fn elastic(stiffness: f64) -> Result<Forces, Failure> {
    let period = (1.0 / stiffness).sqrt();
    let grains = centres().into_iter().enumerate().map(|(index, at)| {
        let density = 1.0 / (4.0 / 3.0 * PI * RADIUS.powi(3));
        let grain = Grain::at(at, RADIUS).of_density(density);
        if index < 4 { grain.fixed() } else { grain }
    });
    let draft = Draft::open_box(Integrator::VelocityVerlet, 0.1 * period)
        .grains(grains)
        .law(KelvinVoigt {
            stiffness,
            damping: stiffness.sqrt(),
        })
        .gravity(GRAVITY);
    let mut world = draft.world()?;
    advance(&mut world, 20_000)?;
    let network = world.contact_network();
    let force = |contact: &gouge_common::estimators::NetworkContact| {
        let size = contact.force.x.hypot(contact.force.y);
        (contact.pair.indices(), size)
    };
    Ok(network.contacts.iter().map(force).collect())
}

fn hard_limit() -> Outcome {
    let rigid = rigid()?;
    if rigid.len() != 12 {
        return Err(Failure::Oracle(format!("{} contacts, not 12", rigid.len())));
    }
    let mut points = Vec::new();
    for stiffness in [1e4, 1e5, 1e6, 1e7, 1e8] {
        let elastic = elastic(stiffness)?;
        let error = |(pair, force): (&(usize, usize), &f64)| {
            let other = elastic.get(pair).copied().unwrap_or(f64::NAN);
            (other - force).abs() / GRAVITY
        };
        points.push([stiffness, crate::checks::largest(rigid.iter().map(error))]);
    }
    let orders = points.windows(2).map(|pair| {
        let observed = (pair[0][1] / pair[1][1]).log10();
        Measurement::absolute(1.0, observed, 0.02)
    });
    let worst = Measurement::worst(orders);
    let last = points[3];
    let slope = points.iter().map(|&[k, _]| [k, last[1] * last[0] / k]);
    let rate = last[1] * last[0] * 2.0 * RADIUS / GRAVITY;
    let text = format!(
        "The largest difference is {rate:.2} (m g/(k d)) m g, with the compression of a contact under one weight over the diameter in parentheses."
    );
    let figure = Figure::new(
        "Largest difference of a contact force between elastic and rigid discs",
        Axis::logarithmic("stiffness k", "N/m"),
        Axis::logarithmic("difference", "weight of a disc"),
        vec![
            Curve::dashed("1/k", slope.collect::<Vec<_>>()),
            Curve::marks("heap", points),
        ],
    );
    Ok(worst.showing([Exhibit::Figure(figure), Exhibit::Text(text)]))
}
