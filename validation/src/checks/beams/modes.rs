//! Modes of two bonded beads.

use super::{BEAM, STIFFNESS};
use crate::checks::random::Random;
use crate::checks::scenes::{advance, head, particle, world};
use crate::checks::time_step::network::linearise;
use crate::checks::{Check, Effort, Exhibit, Measurement, Origin, Outcome, Table};
use crate::oracles::beads;
use gouge_kernel::World;
use gouge_kernel::integrators::Integrator;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "beams.pair-modes",
            claim: "Two bonded beads have just the modes of their energy: along, two across, and three that cost nothing; for equal beads in touch 2 k/m, 5 k/2m and 7 k/2m.",
            equations: "(33), (43)-(45), (77)",
            scene: "Bonded pairs at rest: 1 mm beads in touch, and 200 pairs of radii over two decades at distances up to 1.3 times their sum, in any direction",
            oracle: "Eigenvalues of the energy's own matrix, reduced by hand to three coordinates; 2, 5/2 and 7/2",
            norm: "Largest difference of a squared frequency in units of the largest of the pair",
            origin: Origin::Exact,
            reason: "Entries of the matrix round to a few units, and rotating the frame mixes stiff and soft directions of radii up to a hundred apart: 1e-12 of the stiffest",
            effort: Effort::Quick,
            measure: modes,
        },
        Check {
            id: "beams.pair-period",
            claim: "A beam that swings does so at the frequency that velocity Verlet gives its mode, sin(w' dt/2) = w dt/2.",
            equations: "(43), (51)",
            scene: "1 mm beads in touch, stretched by 1e-9 of their distance and released: 4000 steps of 0.2 / w",
            oracle: "Cosine of the discrete frequency at the last step",
            norm: "Difference of the elongation in units of the amplitude",
            origin: Origin::Exact,
            reason: "The elongation of 2 pm is known to the rounding of positions, 2e-19 m: 1e-7, accumulated as a random walk over 4000 steps",
            effort: Effort::Quick,
            measure: period,
        },
    ]
}

fn frequencies(world: &World) -> Result<Vec<f64>, crate::checks::Failure> {
    let mut model = *world.model();
    model.integrator = Integrator::Euler;
    Ok(linearise(world, model)?.network.squared_frequencies())
}

fn modes() -> Outcome {
    let mut random = Random::new(41);
    let mut worst = Vec::new();
    let mut table = Table::new(
        "Squared frequencies of two 1 mm beads in touch, in units of k/m",
        &["mode", "closed form", "kernel"],
    );
    for case in 0..=200 {
        let radii = if case == 0 {
            [1e-3; 2]
        } else {
            [random.magnitude(1e-4, 1e-2), random.magnitude(1e-4, 1e-2)]
        };
        let distance = (radii[0] + radii[1])
            * if case == 0 {
                1.0
            } else {
                random.between(0.9, 1.3)
            };
        let angle = if case == 0 {
            0.0
        } else {
            random.between(0.0, 2.0 * PI)
        };
        let text = head("euler", 1e-9)
            + BEAM
            + &particle([0.0, 0.0], [0.0, 0.0], 0.0, radii[0])
            + &particle(
                [distance * libm::cos(angle), distance * libm::sin(angle)],
                [0.0, 0.0],
                0.0,
                radii[1],
            )
            + "[[bonds]]\nbetween = [0, 1]\n";
        let world: World = world(&text)?;
        let found = frequencies(&world)?;
        let p = world.particles();
        let exact = beads::pair(
            [p.mass[0], p.mass[1]],
            [p.moment_of_inertia[0], p.moment_of_inertia[1]],
            radii,
            distance,
        );
        let largest = exact[5] * STIFFNESS;
        worst.extend(
            found.iter().zip(exact).map(|(&found, exact)| {
                Measurement::scaled(exact * STIFFNESS, found, largest, 1e-12)
            }),
        );
        if case == 0 {
            let unit = STIFFNESS / p.mass[0];
            let names = [
                ("along", 2.0),
                ("ends oppositely", 2.5),
                ("ends alike", 3.5),
            ];
            for ((name, form), &found) in names.into_iter().zip(&found[3..]) {
                worst.push(Measurement::relative(form, found / unit, 1e-12));
                table.push([
                    name.to_owned(),
                    format!("{form}"),
                    format!("{:.13}", found / unit),
                ]);
            }
        }
    }
    Ok(Measurement::worst(worst).showing([Exhibit::Table(table)]))
}

fn period() -> Outcome {
    let mass = 4.0 / 3.0 * PI * 2700.0 * 1e-9;
    let (rate, steps) = ((2.0 * STIFFNESS / mass).sqrt(), 4000_u64);
    let (h, stretch) = (0.2, 2e-12);
    let text = head("velocity-verlet", h / rate)
        + BEAM
        + &particle([-1e-3, 0.0], [0.0, 0.0], 0.0, 1e-3)
        + &particle([1e-3 + stretch, 0.0], [0.0, 0.0], 0.0, 1e-3)
        + "[[bonds]]\nbetween = [0, 1]\ninitial_distance = 2e-3\n";
    let mut world: World = world(&text)?;
    let elongation = |world: &World| {
        (world.particles().position[1] - world.particles().position[0]).norm() - 2e-3
    };
    let amplitude = elongation(&world);
    advance(&mut world, steps)?;
    let turned = 2.0 * (0.5 * h).asin() * steps as f64;
    let rounding = 2e-19 / amplitude * (steps as f64).sqrt();
    Ok(Measurement::scaled(turned.cos(), elongation(&world) / amplitude, rounding, 8.0).into())
}
