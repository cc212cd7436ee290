//! Collisions of two particles.

use crate::checks::{Check, Effort, Origin, Topic, thesis};

pub(super) mod collision;
mod kelvin_voigt;
mod momentum;
mod restitution;
mod viscoelastic;

/// The topic.
pub fn topic() -> Topic {
    let mut checks = linear();
    checks.extend(hertzian());
    checks.push(Check {
        id: "pairs.momentum",
        claim: "A collision conserves the momentum of the pair up to rounding, and exactly if the spheres are mirror images of each other.",
        equations: thesis("(51), (54)"),
        scene: "Head-on collisions with both normal laws, mass ratios 1, 4.9 and 1000, 2000 steps each",
        oracle: "Conservation of momentum",
        norm: "Change of total momentum in units of the sum of the initial magnitudes",
        origin: Origin::Exact,
        reason: "Each step rounds each velocity at most five times, each time by at most 2^-53 of the impact speed, which is the largest. The bound is thus 5 roundings in each of 2000 steps. For mirror images the sum must be exactly zero",
        effort: Effort::Quick,
        measure: momentum::momentum,
    });
    checks.push(Check {
        id: "pairs.restitution",
        claim: "If a scene gives a restitution instead of a damping constant, every pair rebounds with it, for both normal laws, size ratios up to 100 and restitutions from 0.05 to 1.",
        equations: thesis("(35)-(37), (40), (51), (52)"),
        scene: "Spheres that initially overlap by a few units in the last place; velocity Verlet with 50 (1 + zeta) to 800 (1 + zeta) steps per collision for Kelvin-Voigt, 200 to 6400 for BSHP",
        oracle: "The restitution that the scene asks for",
        norm: "Largest relative error, extrapolated to zero time step",
        origin: Origin::Convergent,
        reason: "Kelvin-Voigt: 1e-10 from the extrapolation, as in pairs.kelvin-voigt. At a size ratio of 100 the positions have a rounding error of 1e-14 small radii, 3e-12 of the overlap; amplified by 4 zeta^2 = 15 and about 100 in the interpolation, 5e-9. BSHP: the time step remains to the power 4, (7 x 3 / 200)^4 for b = 7, times the weight of the coarsest run, 1 / (1.8 3 4.7 7 10.3): 7e-8",
        effort: Effort::Quick,
        measure: restitution::wanted,
    });
    Topic {
        id: "pairs",
        title: "Collisions of two particles",
        about: "Head-on collisions against closed forms and independent integration: restitution, duration, depth and force, and the errors caused by a finite time step.",
        checks,
    }
}

/// Truncated Kelvin-Voigt contacts.
fn linear() -> Vec<Check> {
    vec![
        Check {
            id: "pairs.closed-form",
            claim: "The closed form of the truncated Kelvin-Voigt collision solves its equation of motion, for damping ratios from 0 to 20.",
            equations: thesis("(35), (36)"),
            scene: "None: two oracles are compared with each other",
            oracle: "Extrapolated midpoint integration in double-double, with events located by bisection",
            norm: "Largest relative difference of restitution, duration and square of the largest overlap",
            origin: Origin::Convergent,
            reason: "Steps have a relative error of 1e-27, and there are at most a thousand of them; strong damping amplifies the error of the final speed by up to 4 zeta^2 = 1600",
            effort: Effort::Quick,
            measure: kelvin_voigt::closed_form,
        },
        Check {
            id: "pairs.kelvin-voigt",
            claim: "Restitution, duration, largest overlap and the force at the largest overlap of a truncated Kelvin-Voigt collision agree with the closed forms, for damping ratios from 0 to 20 and mass ratios up to 1000.",
            equations: thesis("(28), (34)-(36), (51)-(54)"),
            scene: "Spheres that initially overlap by a few units in the last place; velocity Verlet with 50 (1 + zeta) to 800 (1 + zeta) steps per collision",
            oracle: "Closed forms: restitution exp(-zeta t), with t the first zero of the force, and depth sqrt(restitution) v / w",
            norm: "Largest relative error, extrapolated to zero time step",
            origin: Origin::Convergent,
            reason: "With the events located between the steps, the error is a power series in the time step. Powers 2 to 5 are removed. The sixth leaves at most (pi / 50)^6 with interpolation constants near 10, 1e-6, times the weight of the coarsest run in the limit, 1 / (3 7 15 31): 1e-10. The rounding of the overlap, 2e-15 of the largest overlap, is amplified by up to 4 zeta^2 = 1600 and by about 100 in the interpolation: 3e-10",
            effort: Effort::Quick,
            measure: kelvin_voigt::curve,
        },
        Check {
            id: "pairs.truncation",
            claim: "The step in which the force ends adds a relative error of theta (1 - theta) (w dt)^2 / 2 to the final speed of velocity Verlet, with theta the fraction of the step before the end; this is at most (w dt)^2 / 8.",
            equations: thesis("(36)"),
            scene: "Collisions with damping ratios from 0 to 3 and 100 to 1600 steps",
            oracle: "Trapezoidal rule across the kink: where the force ends, its rate per unit mass is w^2 times the final speed",
            norm: "Distance of the relative excess speed over (w dt)^2 from theta (1 - theta) / 2, in units of 1/8",
            origin: Origin::Convergent,
            reason: "The next term is smaller by the fastest rate times the time step, (w + 2 zeta w) dt, with a constant near one",
            effort: Effort::Quick,
            measure: kelvin_voigt::truncation,
        },
        Check {
            id: "pairs.arrival",
            claim: "If a damped contact begins at a fraction phi of a step, velocity Verlet is only first order: the relative error of the restitution is 2 zeta w dt (1/2 - phi).",
            equations: thesis("(35), (36)"),
            scene: "Collisions with damping ratios from 0.06 to 2 that begin at 20 different fractions of a step, 1000 or 4000 steps",
            oracle: "Trapezoidal rule across the jump of the force at touch, 2 zeta w times speed and reduced mass",
            norm: "Distance of the scaled error from 1/2 - phi, in units of 1/2",
            origin: Origin::Convergent,
            reason: "The next term is smaller by the fastest rate times the time step, (w + 2 zeta w) dt; the smooth second-order error adds as much, divided by 2 zeta",
            effort: Effort::Quick,
            measure: kelvin_voigt::arrival,
        },
    ]
}

/// Viscoelastic and Hertzian contacts.
fn hertzian() -> Vec<Check> {
    vec![
        Check {
            id: "pairs.hertz",
            claim: "Without damping, depth, force and duration of a BSHP collision scale with the speed to the powers 4/5, 6/5 and -1/5 over four decades, with Hertz's prefactors; speed times duration is 2.9432751847 depths.",
            equations: thesis("(37), (40)"),
            scene: "Spheres of 10 and 17 mm radius at 0.01 to 100 m/s, 100 to 3200 steps per collision",
            oracle: "Closed forms: depth (5 m v^2 / 4 P)^(2/5), force P depth^(3/2), duration (4/5) B(2/5, 1/2) depth / v",
            norm: "Largest relative error of depth, force and duration, extrapolated to zero time step",
            origin: Origin::Convergent,
            reason: "At its end the force has a singularity of power 3/2 that does not lie on the time grid. It leaves an error of dt^(5/2) times at most 0.03, which is 1e-9 for the finest step, amplified fivefold by the extrapolation",
            effort: Effort::Quick,
            measure: viscoelastic::hertz,
        },
        Check {
            id: "pairs.elastic",
            claim: "Without damping the restitution is one, for both normal laws and over four decades of speed.",
            equations: thesis("(35), (37)"),
            scene: "Spheres of 10 and 17 mm radius at 0.01 to 100 m/s, 100 to 3200 steps per collision",
            oracle: "Conservation of energy",
            norm: "Largest distance of the restitution from one, extrapolated to zero time step",
            origin: Origin::Convergent,
            reason: "As for the duration of Hertzian collisions: 0.03 dt^(5/2), amplified fivefold",
            effort: Effort::Quick,
            measure: viscoelastic::elastic,
        },
        Check {
            id: "pairs.viscoelastic",
            claim: "Restitution, duration, largest overlap and the force at the largest overlap of a BSHP collision follow from its equation of motion, for three dissipative constants and over four decades of speed.",
            equations: thesis("(28), (34), (37), (40), (51)-(54)"),
            scene: "Spheres of 10 and 17 mm radius at 0.01 to 100 m/s, dissipation b = Lambda kappa^(2/5) v^(1/5) from 0.02 to 3, 100 to 3200 steps per collision",
            oracle: "Extrapolated midpoint integration, using the square root of the overlap where the force is not smooth in time",
            norm: "Largest relative error, extrapolated to zero time step",
            origin: Origin::Convergent,
            reason: "The force begins like the square root of time, so the error is a series in the powers 3/2, 2, 5/2, ... of the time step. Five are removed, which leaves dt^4 times the weight of the coarsest run: (3/100)^4 / (1.8 3 4.7 7 10.3), 4e-10 with a constant of a few units for b = 3",
            effort: Effort::Quick,
            measure: viscoelastic::curve,
        },
        Check {
            id: "pairs.onset",
            claim: "Because a viscoelastic force begins like the square root of time, velocity Verlet converges with the power 3/2 of the time step, and its leading error equals an extra speed of -zeta(-1/2) b (dt)^(3/2) at touch.",
            equations: thesis("(37)"),
            scene: "Collisions with b = 0.2 and b = 1, 100 to 3200 steps",
            oracle: "Error of the trapezoidal rule for a square root, zeta(-1/2) = -0.2078862..., carried to the end by the derivative of the final speed with respect to the impact speed, from the independent integration",
            norm: "Relative error of the coefficient of dt^(3/2) in the restitution, extrapolated to zero time step",
            origin: Origin::Convergent,
            reason: "The coefficient is a series in the powers 1/2, 1, ... of the time step, of which five are removed; the fifth correction is about 1e-4 of the result for b = 1",
            effort: Effort::Quick,
            measure: viscoelastic::onset,
        },
    ]
}
