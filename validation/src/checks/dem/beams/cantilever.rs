//! Statics of a clamped chain.

use super::modes::bond;
use super::stiffness::{Rest, forces, inner};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::beams::Springs;
use crate::oracles::beams::cantilever::{Chain, Tip};
use crate::scenes::{Draft, Grain};
use gouge_common::scalar::Real;
use gouge_dem::integrators::Integrator;
use gouge_dem::particles::sphere_mass;
use gouge_scalars::DoubleDouble;
use nalgebra::DVector;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "beams.cantilever",
            claim: "Clamped chains of 4 to 64 bonded particles, under small loads on the last or on every particle, have the equilibrium that statics predicts.",
            equations: thesis("(10), (43)-(45)"),
            scene: "Oblique chains for bending and hanging chains for stretching, with radius 1 mm and distance 2.1 mm, the first particle fixed, gravity on the last particle or on all; equilibrium by Newton's method on the kernel's forces in double-double, with derivatives from dual numbers",
            oracle: "Closed-form sums for the statically determinate chain of beams",
            norm: "Largest relative error of stretch, deflection and rotation of the end, for the part that is odd in the load",
            origin: Origin::Exact,
            reason: "Loads are so small that third-order deviations are below 1e-16. An iteration of Newton's method gains eight digits, and the last one changes the sixteenth. Positions of up to 0.13 m are doubles, which changes distances by 7e-15; the closed forms round a dozen times",
            effort: Effort::Quick,
            measure: statics,
        },
        Check {
            id: "beams.beam-theory",
            claim: "A clamped chain deflects like a Timoshenko beam with bending stiffness k r^2 D / 2 and shear stiffness 3 k r^2 / D, and tends to the Euler-Bernoulli beam with the square of its slenderness.",
            equations: thesis("(44)-(45)"),
            scene: "The same chains, loaded at the end or uniformly, the latter with half a weight on the last particle",
            oracle: "Beam theory for M beams. End load: the relative deviation from Euler-Bernoulli is exactly 1 / (2 M^2), and that from Timoshenko is zero. Uniform load: the deviation from Timoshenko is 1 / (3 M^2 + 2)",
            norm: "Largest error of a relative deviation",
            origin: Origin::Exact,
            reason: "The deviations are known exactly; deflections are accurate to 1e-13",
            effort: Effort::Quick,
            measure: theory,
        },
    ]
}

/// Where gravity acts.
#[derive(Clone, Copy, PartialEq)]
pub enum Load {
    /// On the last particle.
    End,
    /// On every particle.
    All,
    /// On every particle, with half a weight on the last.
    Uniform,
}

/// Density of particles of negligible weight.
const WEIGHTLESS: f64 = 2700e-30;

/// A clamped chain under gravity.
pub struct Cantilever {
    /// The chain.
    pub chain: Chain,
    /// Its angle to the horizontal.
    pub direction: f64,
    /// Where gravity acts.
    pub load: Load,
    /// Weight of a particle in N.
    pub weight: f64,
}

impl Cantilever {
    fn rest(&self) -> Result<Rest, Failure> {
        let Chain {
            radius,
            distance,
            springs,
            beams,
        } = self.chain;
        let gravity = self.weight / sphere_mass(2700.0, radius);
        let (s, c) = self.direction.sin_cos();
        let mut draft = Draft::open_box(Integrator::Euler, 1e-9)
            .and(&bond(
                springs,
                Springs {
                    normal: 0.0,
                    tangential: 0.0,
                },
            ))
            .gravity(gravity);
        for n in 0..=beams {
            let along = n as f64 * distance;
            let density = match (self.load, n == beams) {
                (Load::End, false) => WEIGHTLESS,
                (Load::Uniform, true) => 1350.0,
                _ => 2700.0,
            };
            let grain = Grain::at([along * c, along * s], radius).of_density(density);
            draft = draft.grain(if n == 0 { grain.fixed() } else { grain });
        }
        for n in 0..beams {
            draft = draft.bonded(n, n + 1);
        }
        Rest::of_draft(&draft)
    }

    /// Displacement of every coordinate in equilibrium; those of the clamped particle are zero.
    pub fn equilibrium(&self) -> Result<Vec<DoubleDouble>, Failure> {
        let rest = self.rest()?;
        let free: Vec<usize> = (3..rest.coordinates()).collect();
        let slopes = inner(&rest.stiffness()?, &free);
        let loose = || Failure::Oracle("the chain has no stiffness".to_owned());
        let factors = slopes.cholesky().ok_or_else(loose)?;
        let mut displacement = vec![DoubleDouble::default(); rest.coordinates()];
        let mut first = f64::INFINITY;
        for round in 0..60 {
            let world = rest.displaced(&displacement)?;
            let unbalanced = forces(&world);
            let load =
                DVector::from_iterator(free.len(), free.iter().map(|&n| unbalanced[n].to_f64()));
            let change = factors.solve(&load);
            free.iter()
                .zip(change.iter())
                .for_each(|(&n, &u)| displacement[n] += DoubleDouble::from_f64(u));
            if round == 0 {
                first = change.amax();
            } else if change.amax() < 1e-16 * first {
                return Ok(displacement);
            }
        }
        Err(Failure::Oracle(
            "Newton's method does not converge".to_owned(),
        ))
    }

    /// Displacement of the tip along the chain and across it in the direction of the load, and its
    /// rotation.
    fn tip(&self) -> Result<[f64; 3], Failure> {
        let u = self.equilibrium()?;
        let [x, y, turn] = [3, 2, 1].map(|back| u[u.len() - back].to_f64());
        let (s, c) = self.direction.sin_cos();
        Ok([-(x * c + y * s), x * s - y * c, -turn])
    }

    /// The part of the tip's displacement that is odd in the load: half the difference from the chain
    /// in the opposite direction, for which the load has the opposite sign.
    fn odd_tip(&self) -> Result<Tip, Failure> {
        let turned = Self {
            direction: self.direction + PI,
            ..*self
        };
        let (there, back) = (self.tip()?, turned.tip()?);
        let [stretch, deflection, turn] = std::array::from_fn(|n| 0.5 * (there[n] - back[n]));
        Ok(Tip {
            stretch,
            deflection,
            turn,
        })
    }
}

/// Angles to the horizontal: oblique for bending; hanging for stretching, because in an oblique chain
/// the stretch is smaller than the bending caused by the rounding of positions.
const SLANTED: f64 = 0.4;
const HANGING: f64 = -0.5 * PI;

fn cantilever(bodies: usize, load: Load, direction: f64) -> Cantilever {
    let springs = Springs {
        normal: 1e7,
        tangential: 0.8e7,
    };
    let chain = Chain {
        beams: bodies - 1,
        distance: 2.1e-3,
        radius: 1e-3,
        springs,
    };
    // The deflection is about 1e-10 of the length, so that its square is negligible.
    let weight = 1e-10 * chain.bending_stiffness() / (chain.distance * bodies as f64).powi(2);
    Cantilever {
        chain,
        direction,
        load,
        weight,
    }
}

const SIZES: [usize; 5] = [4, 8, 16, 32, 64];

/// Displacement of the tip according to statics.
fn exact(one: &Cantilever) -> Tip {
    let (s, c) = one.direction.sin_cos();
    match one.load {
        Load::End => one.chain.under_end_load(one.weight * s, one.weight * c),
        _ => one.chain.under_own_weight(one.weight * s, one.weight * c),
    }
}

fn statics() -> Outcome {
    let mut measured = Vec::new();
    for bodies in SIZES {
        for load in [Load::End, Load::All] {
            let slanted = cantilever(bodies, load, SLANTED);
            let hanging = cantilever(bodies, load, HANGING);
            let (bent, stretched) = (slanted.odd_tip()?, hanging.odd_tip()?);
            let pairs = [
                (exact(&slanted).deflection, bent.deflection),
                (exact(&slanted).turn, bent.turn),
                (exact(&hanging).stretch, stretched.stretch),
            ];
            measured.extend(pairs.map(|(exact, found)| Measurement::relative(exact, found, 1e-13)));
        }
    }
    Ok(Measurement::worst(measured).into())
}

fn theory() -> Outcome {
    let (mut measured, mut end, mut uniform) = (Vec::new(), Vec::new(), Vec::new());
    for bodies in SIZES {
        let one = cantilever(bodies, Load::End, SLANTED);
        let (m, across) = ((bodies - 1) as f64, one.weight * one.direction.cos());
        let found = one.odd_tip()?.deflection;
        let thin = found / one.chain.euler_bernoulli(across) - 1.0;
        let thick = found / one.chain.timoshenko(across) - 1.0;
        let found = cantilever(bodies, Load::Uniform, SLANTED)
            .odd_tip()?
            .deflection;
        let spread = found / one.chain.timoshenko_uniform(across) - 1.0;
        measured.push(Measurement::absolute(0.5 / (m * m), thin, 1e-13));
        measured.push(Measurement::absolute(0.0, thick, 1e-13));
        measured.push(Measurement::absolute(
            1.0 / (3.0 * m * m + 2.0),
            spread,
            1e-13,
        ));
        end.push([m, thin]);
        uniform.push([m, spread]);
    }
    let line = |factor: f64| {
        end.iter()
            .map(move |p| [p[0], factor / (p[0] * p[0])])
            .collect::<Vec<_>>()
    };
    let plot = Figure::new(
        "Clamped chains tend to beam theory with the square of their slenderness",
        Axis::logarithmic("number of beams M", ""),
        Axis::logarithmic("relative deviation of the deflection", ""),
        vec![
            Curve::line("1 / (2 M^2)", line(0.5)),
            Curve::line("1 / (3 M^2)", line(1.0 / 3.0)),
            Curve::marks("end load, from Euler-Bernoulli", end.clone()),
            Curve::marks("uniform load, from Timoshenko", uniform),
        ],
    );
    Ok(Measurement::worst(measured).showing([Exhibit::Figure(plot)]))
}
