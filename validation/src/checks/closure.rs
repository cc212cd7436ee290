//! The energy balance.

use super::{Check, Measurement, Origin, advance, impossible, world};

/// Checks of the balance (72).
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "closure.beam",
        claim: "The residual of the energy balance of a swinging, damped beam falls with the order of velocity Verlet.",
        equations: "(72)-(79)",
        origin: Origin::Convergent,
        measure: beam,
    }]
}

/// Residual after a fixed time, for a number of steps.
fn residual(steps: u64) -> Option<f64> {
    let mut text = format!(
        "[time]\nstep = {:e}\nend = 1.0\nintegrator = \"velocity-verlet\"\n\
         [material]\ndensity = 2700.0\n\
         [bond.normal]\nstiffness = 1e6\ndamping = 1.0\n\
         [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e6\ndamping = 1.0\n\
         [ambient]\nlaw = \"creeping\"\nviscosity = 0.1\n\
         [external]\nlaw = \"gravity\"\nacceleration = 1e4\n\
         [[particles]]\nposition = [0.0, 0.0]\nradius = 1e-3\nrole = \"fixed\"\n",
        1e-4 / steps as f64
    );
    for i in 1..5 {
        let x = f64::from(i) * 2e-3;
        text += &format!(
            "[[particles]]\nposition = [{x:e}, 0.0]\nradius = {:e}\n",
            1e-3 - 1e-4 * f64::from(i)
        );
        text += &format!("[[bonds]]\nbetween = [{}, {i}]\n", i - 1);
    }
    let mut world = world(&text)?;
    let ok = advance(&mut world, steps);
    ok.then(|| world.energy().residual.abs())
}

fn beam() -> Measurement {
    let (Some(coarse), Some(fine)) = (residual(2000), residual(4000)) else {
        return impossible();
    };
    Measurement::absolute(2.0, (coarse / fine).log2(), 0.05)
}
