//! Energy lost with bonds that break, and energy of the contacts that replace them.

use super::spheres::RADIUS;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, Table};
use crate::checks::{Exhibit, thesis};
use crate::scenes::{Bond, Draft, Grain};
use gouge_dem::balance::Energy;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, Bshp, EulerBernoulli, KelvinVoigt, ZhangEckert};
use std::f64::consts::{PI, TAU};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.breaking",
            claim: "A bond breaks on the strength ellipse, and its stored energy is booked; in tension, a 1 mm granite bond books 3.868884925e-2 J.",
            equations: thesis("(43)-(50), (77)"),
            scene: "Two bonded spheres strained to 1 -+ 1e-9 of the ellipse at 16 angles, with two strength factors, each evaluated once; no contacts",
            oracle: "N^2 / (2 k) + T^2 / k, with N = 280 MPa pi (s r)^2 cos a and T = 168 MPa pi (s r)^2 sin a: the bond breaks outside the ellipse and holds inside",
            norm: "Relative error of the energy booked; a bond that holds outside or breaks inside counts as one",
            origin: Origin::Exact,
            reason: "The strain is 1e-9 beyond the ellipse, which changes the energy by 2e-9; the distance of the centres is rounded by 2^-53 of 2 mm, 3e-12 of the smallest strain",
            effort: Effort::Quick,
            measure: breaking,
        },
        Check {
            id: "closure.bonding",
            claim: "When a bond breaks between overlapping grains, the energy of the contact that replaces it is booked, and the balance stays closed to rounding.",
            equations: thesis("(72), (75), (77)"),
            scene: "Two bonded spheres of 1 and 1.5 mm with an overlap of 37 um and a bond whose initial length was 90 um longer, evaluated once; Kelvin-Voigt and viscoelastic contacts",
            oracle: "k xi^2 / 2 and (2/5) (4/3) E* sqrt(R*) xi^(5/2) for the contact, K Xi^2 / 2 for the bond",
            norm: "Relative error of both booked energies, and residual over the energy booked",
            origin: Origin::Exact,
            reason: "The rounding of the distance, 2^-53 of 2.5 mm, is 8e-15 of the overlap, whose power 5/2 enters; twenty more roundings",
            effort: Effort::Quick,
            measure: bonding,
        },
    ]
}

const BOND: f64 = 1e7;

/// The balance after one evaluation of two bonded spheres of equal radius, stretched by a length and
/// with both ends turned by an angle.
fn strained(stretch: f64, turned: f64, factor: f64) -> Result<Energy, Failure> {
    let draft = Draft::open_box(Integrator::Euler, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: BOND,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: BOND,
            damping: 0.0,
        })
        .law(ZhangEckert {
            normal_strength: 280e6,
            tangential_strength: 168e6,
        })
        .grain(Grain::at([-RADIUS, 0.0], RADIUS))
        .grain(Grain::at([RADIUS, 0.0], RADIUS))
        .bond(
            Bond::between(0, 1)
                .of_strength(factor)
                .of_length(2.0 * RADIUS - stretch)
                .since([-turned, -turned - PI]),
        );
    let mut world = draft.world()?;
    world.evaluate_if_pending()?;
    Ok(world.energy())
}

fn breaking() -> Outcome {
    let (mut all, mut table) = (
        Vec::new(),
        Table::new(
            "Energy booked when a 1 mm granite bond with strength factor one breaks",
            &[
                "angle on the ellipse in degrees",
                "expected in J",
                "booked in J",
            ],
        ),
    );
    for factor in [1.0, 0.9] {
        let area = PI * (factor * RADIUS).powi(2);
        for place in 0..16 {
            let angle = TAU * f64::from(place) / 16.0;
            let (normal, shear) = (280e6 * area * angle.cos(), 168e6 * area * angle.sin());
            let at = |scale: f64| {
                // With both ends turned by zeta / r, the shear force is 2 K zeta r / D = K zeta.
                let (stretch, zeta) = (scale * normal / BOND, scale * shear / BOND);
                strained(stretch, zeta / RADIUS, factor)
            };
            let expected = (0.5 * normal * normal + shear * shear) / BOND;
            let (beyond, within) = (at(1.0 + 1e-9)?, at(1.0 - 1e-9)?);
            all.push(Measurement::relative(expected, beyond.breaking, 2.1e-9));
            all.push(Measurement::count(usize::from(within.breaking != 0.0)));
            if factor == 1.0 {
                let cells = [22.5 * f64::from(place), expected, beyond.breaking];
                let [degrees, expected, booked] = cells;
                table.push([
                    format!("{degrees}"),
                    format!("{expected:.9e}"),
                    format!("{booked:.9e}"),
                ]);
            }
        }
    }
    all.push(Measurement::relative(
        3.868884925e-2,
        strained(
            280e6 * PI * RADIUS * RADIUS / BOND * (1.0 + 1e-10),
            0.0,
            1.0,
        )?
        .breaking,
        3.3e-10,
    ));
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn bonding() -> Outcome {
    let (small, large, overlap, longer, bond) = (1e-3, 1.5e-3, 37e-6, 90e-6, 3e7);
    let (modulus, ratio) = (50e9, 0.22);
    let viscoelastic = Draft::empty().law(Bshp {
        youngs_modulus: modulus,
        poissons_ratio: ratio,
        dissipative_constant: 1e-7,
    });
    let effective = modulus / (2.0 * (1.0 - ratio * ratio));
    let reduced: f64 = small * large / (small + large);
    let hertz = 0.4 * 4.0 / 3.0 * effective * reduced.sqrt() * f64::powf(overlap, 2.5);
    let mut all = Vec::new();
    for (contact, gained) in [
        (
            Draft::empty().law(KelvinVoigt {
                stiffness: 2e6,
                damping: 3.0,
            }),
            0.5 * 2e6 * overlap * overlap,
        ),
        (viscoelastic, hertz),
    ] {
        let distance = small + large - overlap;
        let draft = Draft::open_box(Integrator::Euler, 1e-9)
            .and(&contact)
            .law(AdjustedKelvinVoigt {
                stiffness: bond,
                damping: 2.0,
            })
            .law(ZhangEckert {
                normal_strength: 28e6,
                tangential_strength: 16.8e6,
            })
            .grain(Grain::at([0.0, 0.0], small))
            .grain(Grain::at([0.6 * distance, 0.8 * distance], large))
            .bond(Bond::between(0, 1).of_length(distance + longer));
        let mut world = draft.world()?;
        world.evaluate_if_pending()?;
        let energy = world.energy();
        let lost = 0.5 * bond * longer * longer;
        // Roundings of the distance of the centres in the two displacements.
        let unit = 0.5 * f64::EPSILON;
        let slack = 20.0 * unit + 2.5 * 4.0 * unit * distance / overlap;
        all.push(Measurement::relative(lost, energy.breaking, slack));
        all.push(Measurement::relative(gained, energy.bonding, slack));
        all.push(Measurement::scaled(0.0, energy.residual, lost, 4.0 * unit));
    }
    Ok(Measurement::worst(all).into())
}
