//! Two particles.

use crate::checks::{Check, Effort, Origin, Topic, thesis};

pub(super) mod collision;
mod kelvin_voigt;
mod momentum;
mod viscoelastic;

/// The topic.
pub fn topic() -> Topic {
    let mut checks = linear();
    checks.extend(hertzian());
    checks.push(Check {
        id: "pairs.momentum",
        claim: "A collision changes the momentum of the pair by rounding only, and that of mirror images by nothing.",
        equations: thesis("(51), (54)"),
        scene: "Head-on collisions under both laws, mass ratios 1, 4.9 and 1000, 2000 steps each",
        oracle: "Conservation",
        norm: "Change of the sum of momenta in units of the sum of their sizes",
        origin: Origin::Exact,
        reason: "Each step rounds each velocity at most five times, each time by at most 2^-53 of the largest speed, which is that of impact: 2000 steps of 5 roundings; mirror images must agree to the last bit",
        effort: Effort::Quick,
        measure: momentum::momentum,
    });
    Topic {
        id: "pairs",
        title: "Two particles",
        about: "Head-on collisions against closed forms and independent integration: restitution, duration, depth and force, and what a step of finite length costs.",
        checks,
    }
}

/// Truncated Kelvin-Voigt contacts.
fn linear() -> Vec<Check> {
    vec![
        Check {
            id: "pairs.closed-form",
            claim: "The closed form of the truncated Kelvin-Voigt collision is the integral of its equation of motion, from damping ratio 0 to 20.",
            equations: thesis("(35), (36)"),
            scene: "None: two oracles against each other",
            oracle: "Extrapolated midpoint integration in double-double, events by bisection",
            norm: "Largest relative difference of restitution, duration and square of the largest overlap",
            origin: Origin::Convergent,
            reason: "Steps of relative error 1e-27, at most a thousand of them, and strong damping magnifies the error of the final speed by up to 4 zeta^2 = 1600",
            effort: Effort::Quick,
            measure: kelvin_voigt::closed_form,
        },
        Check {
            id: "pairs.kelvin-voigt",
            claim: "Restitution, duration, largest overlap and the force there of a truncated Kelvin-Voigt collision are the closed forms, from damping ratio 0 to 20 and for mass ratios up to 1000.",
            equations: thesis("(28), (34)-(36), (51)-(54)"),
            scene: "Spheres that touch at the last digit, velocity Verlet with 50 (1 + zeta) to 800 (1 + zeta) steps a collision",
            oracle: "Closed forms: exp(-zeta t), t from the first zero of the force, and depth sqrt(restitution) v / w",
            norm: "Largest relative error, extrapolated to a step of no length",
            origin: Origin::Convergent,
            reason: "With the events located between the steps the error is a series in the step. Powers 2 to 5 are removed, which leaves that of the sixth, at most (pi / 50)^6 with interpolation constants near 10, 1e-6, times the weight of the coarsest run in the limit, 1 / (3 7 15 31): 1e-10. Rounding of the overlap, 2e-15 of the largest one, is magnified by up to 4 zeta^2, 1600, and about 100 by the interpolation: 3e-10",
            effort: Effort::Quick,
            measure: kelvin_voigt::curve,
        },
        Check {
            id: "pairs.truncation",
            claim: "The step in which the force ends costs velocity Verlet theta (1 - theta) (w dt)^2 / 2 of the final speed, theta being the fraction of the step before the end, and so at most (w dt)^2 / 8.",
            equations: thesis("(36)"),
            scene: "Collisions of damping ratio 0 to 3 with 100 to 1600 steps",
            oracle: "Trapezoidal rule across the kink: at the end of the force its rate is w^2 times the final speed",
            norm: "Distance from theta (1 - theta) / 2, times (w dt)^2 over the extra speed, in units of 1/8",
            origin: Origin::Convergent,
            reason: "The next term is smaller by the fastest rate times the step, (w + 2 zeta w) dt, with a constant near one",
            effort: Effort::Quick,
            measure: kelvin_voigt::truncation,
        },
        Check {
            id: "pairs.arrival",
            claim: "A damped contact that begins at the fraction phi of a step makes velocity Verlet first order: the restitution is off by 2 zeta w dt (1/2 - phi) of itself.",
            equations: thesis("(35), (36)"),
            scene: "Collisions of damping ratio 0.06 to 2 that begin at 20 fractions of a step, 1000 or 4000 steps",
            oracle: "Trapezoidal rule across the jump of the force at touch, 2 zeta w times the speed over the mass",
            norm: "Distance from 1/2 - phi in units of 1/2",
            origin: Origin::Convergent,
            reason: "The next term is smaller by the fastest rate times the step, (w + 2 zeta w) dt, and the smooth error of second order counts as much over 2 zeta",
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
            claim: "Without damping, depth, force and duration of a BSHP collision grow with the powers 4/5, 6/5 and -1/5 of the speed over four decades, with the prefactors of Hertz; speed times duration is 2.9432751847 depths.",
            equations: thesis("(37), (40)"),
            scene: "Spheres of 10 and 17 mm at 0.01 to 100 m/s, 100 to 3200 steps a collision",
            oracle: "Closed forms: depth (5 m v^2 / 4 P)^(2/5), force P depth^(3/2), duration (4/5) B(2/5, 1/2) depth / v",
            norm: "Largest relative error of depth, force and duration, extrapolated to a step of no length",
            origin: Origin::Convergent,
            reason: "Where the force ends it has a singularity of the power 3/2, which is not on the grid: it leaves dt^(5/2) times at most 0.03, 1e-9 at the finest step, magnified fivefold by the extrapolation",
            effort: Effort::Quick,
            measure: viscoelastic::hertz,
        },
        Check {
            id: "pairs.elastic",
            claim: "Without damping the restitution is one, for either law and over four decades of speed.",
            equations: thesis("(35), (37)"),
            scene: "Spheres of 10 and 17 mm at 0.01 to 100 m/s, 100 to 3200 steps a collision",
            oracle: "Conservation of energy",
            norm: "Largest distance of the restitution from one, extrapolated to a step of no length",
            origin: Origin::Convergent,
            reason: "As for the duration of Hertzian collisions: 0.03 dt^(5/2), magnified fivefold",
            effort: Effort::Quick,
            measure: viscoelastic::elastic,
        },
        Check {
            id: "pairs.viscoelastic",
            claim: "Restitution, duration, largest overlap and the force there of a BSHP collision follow its equation of motion, for three dissipative constants over four decades of speed.",
            equations: thesis("(28), (34), (37), (40), (51)-(54)"),
            scene: "Spheres of 10 and 17 mm at 0.01 to 100 m/s, dissipation b = Lambda kappa^(2/5) v^(1/5) from 0.02 to 3, 100 to 3200 steps a collision",
            oracle: "Extrapolated midpoint integration, in the root of the overlap where the force is not smooth in time",
            norm: "Largest relative error, extrapolated to a step of no length",
            origin: Origin::Convergent,
            reason: "The force begins like the root of time, so that the error is a series in powers 3/2, 2, 5/2, ... of the step; five are removed, which leaves dt^4 times the weight of the coarsest run: (3/100)^4 / (1.8 3 4.7 7 10.3), 4e-10 with a constant of a few units for b = 3",
            effort: Effort::Quick,
            measure: viscoelastic::curve,
        },
        Check {
            id: "pairs.onset",
            claim: "Because a viscoelastic force begins like the root of time, velocity Verlet converges with the power 3/2 of the step, and its first error is -zeta(-1/2) b (dt)^(3/2) of speed at touch.",
            equations: thesis("(37)"),
            scene: "A collision with b = 0.2 and b = 1, 100 to 3200 steps",
            oracle: "Error of the trapezoidal rule for a root, zeta(-1/2) = -0.2078862..., carried to the end by the derivative of the final speed by that of impact, from the independent integration",
            norm: "Relative error of the coefficient of dt^(3/2) in the restitution, extrapolated to a step of no length",
            origin: Origin::Convergent,
            reason: "The coefficient is a series in powers 1/2, 1, ... of the step, of which five are removed; the fifth correction is about 1e-4 of the result for b = 1",
            effort: Effort::Quick,
            measure: viscoelastic::onset,
        },
    ]
}
