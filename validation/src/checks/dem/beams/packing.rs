//! Elastic moduli of bonded packings.

use super::modes::bond;
use super::stiffness::Rest;
use super::tension::{Pulled, pull, pulled_lattice, thesis_lattice};
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::beams::Springs;
use crate::oracles::beams::network::{Beam, settle, stiffness};
use crate::scenes::packing::settled;
use gouge_runner::run::run_setup;
use nalgebra::DVector;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// The checks.
pub fn checks() -> Vec<Check> {
    const PACKING: &str = "Packings of about 170 grains of 1 mm from the set-up of the granite fault, 25 mm square, settled, bonded, and pulled by their lowest and highest 2 mm";
    vec![
        Check {
            id: "beams.packing-network",
            claim: "A bonded packing under tension has the displacements of an independently assembled network of beams.",
            equations: thesis("(33), (43)-(45), (64)"),
            scene: PACKING,
            oracle: "Stiffness matrix assembled beam by beam, solved by sparse Cholesky factors",
            norm: "Largest error of a displacement in units of the grip's displacement",
            origin: Origin::Exact,
            reason: "Both matrices are exact to rounding, 2^-52; solving 500 equations amplifies that by the condition number, about 1e4",
            effort: Effort::Thorough,
            measure: network,
        },
        Check {
            id: "beams.packing-modulus",
            claim: "Packed blocks bonded with the thesis's k = 1e7 kg/s^2 are softer in tension than under affine deformation, and far softer than the granite that they represent.",
            equations: thesis("(33), (43)-(45), (64)"),
            scene: PACKING,
            oracle: "The thesis's granite, 50 -+ 20 GPa; for every packing the force of an affine deformation, an upper bound by the principle of minimum energy",
            norm: "Upper confidence limit, 99.5 % one-sided, of the mean Young's modulus of 12 packings, which must lie below the lower end of granite's range; a packing stiffer than affine counts as a failure",
            origin: Origin::Statistical,
            reason: "The bound is the lower end of the thesis's range for granite, 30 GPa. The confidence limit uses Student's distribution with 11 degrees of freedom. The table shows the measured values for a slice as thick as the mean diameter, assumed isotropic; the energy bound is exact",
            effort: Effort::Thorough,
            measure: modulus,
        },
    ]
}

const SIDE: f64 = 25e-3;
const GRIP: f64 = 2e-3;
const SPRINGS: Springs = Springs {
    normal: 1e7,
    tangential: 1e7,
};

/// A bonded packing.
fn packing(seed: u64) -> Result<Rest, Failure> {
    let dashpots = Springs {
        normal: 10.0,
        tangential: 10.0,
    };
    let draft = settled(SIDE, seed)
        .and(&bond(SPRINGS, dashpots))
        .with_table("setup.bonding");
    Ok(Rest::of(&run_setup(&draft.scene()?)?))
}

fn pulled(rest: &Rest) -> Result<Pulled, Failure> {
    pull(rest, SIDE, [GRIP, SIDE - GRIP])
}

/// The bonds as beams between nearest periodic images.
fn beams(rest: &Rest) -> Vec<Beam> {
    let p = rest.particles();
    let beam = |[i, j]: [usize; 2]| {
        let (from, to) = (p.position[i], p.position[j]);
        let x = to.x - from.x;
        Beam {
            between: [i, j],
            apart: [x - SIDE * (x / SIDE).round(), to.y - from.y],
            radii: [p.radius[i], p.radius[j]],
        }
    };
    rest.pairs().map(beam).collect()
}

fn network() -> Outcome {
    let rest = packing(0)?;
    let pulled = pulled(&rest)?;
    let loose = || Failure::Oracle("the network is loose".to_owned());
    let exact = settle(&beams(&rest), SPRINGS, &pulled.held).ok_or_else(loose)?;
    // An angle counts as the displacement that it causes at a mean radius.
    let scale = |n: usize| if n % 3 == 2 { 1e3 } else { 1.0 };
    let compare = |(n, (exact, found)): (usize, (&f64, &f64))| {
        Measurement::scaled(*exact, *found, scale(n), 1e-11)
    };
    let pairs = exact.iter().zip(&pulled.displacement).enumerate();
    Ok(Measurement::worst(pairs.map(compare)).into())
}

/// Force in N per m on a grip if the block deforms affinely between the grips.
fn affine_force(rest: &Rest) -> f64 {
    let lift = |y: f64| ((y - GRIP) / (SIDE - 2.0 * GRIP)).clamp(0.0, 1.0);
    let position = &rest.particles().position;
    let field: Vec<f64> = position
        .iter()
        .flat_map(|x| [0.0, lift(x.y), 0.0])
        .collect();
    let field = DVector::from_vec(field);
    field.dot(&(stiffness(position.len(), &beams(rest), SPRINGS) * &field))
}

const SEEDS: u64 = 12;

/// Mean, and half the width of its two-sided 99 % confidence interval.
fn interval(values: &[f64]) -> Result<[f64; 2], Failure> {
    let count = values.len() as f64;
    let student = StudentsT::new(0.0, 1.0, count - 1.0);
    let quantile = student
        .map_err(|error| Failure::Oracle(error.to_string()))?
        .inverse_cdf(0.995);
    let mean = values.iter().sum::<f64>() / count;
    let square = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0);
    Ok([mean, quantile * (square / count).sqrt()])
}

/// Young's modulus with its uncertainty in Pa and Poisson's ratio with its uncertainty, of the thesis's
/// granite.
const GRANITE: [f64; 4] = [50e9, 20e9, 0.22, 0.12];

fn modulus() -> Outcome {
    let (mut youngs, mut poissons, mut shares) = (Vec::new(), Vec::new(), Vec::new());
    for seed in 1..=SEEDS {
        let rest = packing(seed)?;
        let pulled = pulled(&rest)?;
        let [young, poisson] = pulled.technical();
        youngs.push(young);
        poissons.push(poisson);
        shares.push(pulled.force / affine_force(&rest));
    }
    let ([young, margin], [poisson, spread]) = (interval(&youngs)?, interval(&poissons)?);
    let stiffer = shares.iter().filter(|&&share| share >= 1.0).count();
    let below = Measurement {
        expected: GRANITE[0],
        measured: young,
        error: young + margin,
        tolerance: GRANITE[0] - GRANITE[1],
    };
    let table = table([young, margin, poisson, spread])?;
    let share = shares.iter().sum::<f64>() / shares.len() as f64;
    let text = format!(
        "Packings resist a pull with {share:.3} of the force of an affine deformation. Moduli are proportional to the stiffness: granite's 50 GPa would need k = {:.1e} kg/s^2.",
        1e7 * GRANITE[0] / young
    );
    let worst = Measurement::worst([below, Measurement::count(stiffer)]);
    Ok(worst.showing([Exhibit::Table(table), Exhibit::Text(text)]))
}

fn table(packings: [f64; 4]) -> Result<Table, Failure> {
    let mut table = Table::new(
        "Elastic moduli of granite, and of blocks bonded with k = 1e7 kg/s^2 as slices of 2 mm",
        &["block", "Young's modulus, GPa", "Poisson's ratio"],
    );
    for (name, tangential) in [
        ("hexagonal lattice of bars", 0.0),
        ("hexagonal lattice of beams", 1e7),
    ] {
        let [young, poisson] = pulled_lattice(&thesis_lattice(tangential), tangential > 0.0)?;
        table.push([
            name.to_owned(),
            format!("{:.3}", young / 1e9),
            format!("{poisson:.4}"),
        ]);
    }
    let rows = [
        (
            format!("{SEEDS} packings, mean with 99 % confidence interval"),
            packings,
        ),
        ("granite of the thesis".to_owned(), GRANITE),
    ];
    for (name, [young, margin, poisson, spread]) in rows {
        let young = format!("{:.2} -+ {:.2}", young / 1e9, margin / 1e9);
        table.push([name, young, format!("{poisson:.3} -+ {spread:.3}")]);
    }
    Ok(table)
}
