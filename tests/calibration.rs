//! Calibration against collisions integrated from the kernel's laws without its world, and against the numbers of
//! the thesis.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use gouge_dem::calibration::{
    FrictionDecay, breaking_overlap_hertzian, breaking_overlap_linear, damping_bound,
    damping_ratio_for, dissipative_constant_from_restitution,
    dissipative_constant_printed_from_restitution, first_order_coefficient, matching_stiffness,
    truncated_duration, truncated_restitution,
};
use gouge_dem::laws::{Bshp, KelvinVoigt, NormalLaw};
use gouge_dem::material::GRANITE;
use gouge_dem::particles::sphere_mass;

/// Restitution and duration of a head-on collision of equal spheres at the given speed, by classical
/// Runge-Kutta steps until the force first vanishes.
fn collide(law: impl NormalLaw, radius: f64, mass: f64, speed: f64, step: f64) -> (f64, f64) {
    // Without overlap the laws give no force, so the collision starts with an overlap of one ulp.
    let slope = |x: f64, v: f64| (v, law.force([radius; 2], x, v) / mass);
    let (mut x, mut v, mut time) = (0.0_f64, speed, 0.0);
    loop {
        let (a1, b1) = slope(x, v);
        let (a2, b2) = slope(x + 0.5 * step * a1, v + 0.5 * step * b1);
        let (a3, b3) = slope(x + 0.5 * step * a2, v + 0.5 * step * b2);
        let (a4, b4) = slope(x + step * a3, v + step * b3);
        x += step / 6.0 * (a1 + 2.0 * (a2 + a3) + a4);
        v += step / 6.0 * (b1 + 2.0 * (b2 + b3) + b4);
        time += step;
        if v < 0.0 && slope(x, v).1 >= 0.0 {
            return (-v / speed, time);
        }
    }
}

#[test]
fn truncated_restitution_and_duration_match_integrated_collisions() {
    let (mass, stiffness) = (0.5 * sphere_mass(2700.0, 1e-3), 1e7_f64);
    let frequency = (stiffness / mass).sqrt();
    for ratio in [0.01, 0.2, 0.6649, 0.999_999, 1.0, 1.000_001, 3.0] {
        let damping = 2.0 * ratio * (stiffness * mass).sqrt();
        let law = KelvinVoigt { stiffness, damping };
        let (restitution, duration) = collide(law, 1e-3, mass, 1.0, 2e-5 / frequency);
        let expected = truncated_restitution(ratio);
        assert!(
            abs_diff_eq!(restitution / expected, 1.0, epsilon = 1e-4),
            "{ratio}: {restitution} {expected}"
        );
        let expected = truncated_duration(ratio) / frequency;
        assert!(
            abs_diff_eq!(duration, expected, epsilon = 4e-5 / frequency),
            "{ratio}: {duration} {expected}"
        );
    }
}

#[test]
fn the_damping_of_the_thesis_gives_a_restitution_below_a_quarter() {
    let (mass, stiffness) = (0.5 * sphere_mass(2700.0, 1e-3), 1e7_f64);
    let critical = 2.0 * (stiffness * mass).sqrt();
    assert_abs_diff_eq!(
        truncated_restitution(10.0 / critical) / 0.222_77,
        1.0,
        epsilon = 1e-4
    );
    let seconds = truncated_duration(10.0 / critical) * (mass / stiffness).sqrt();
    assert_abs_diff_eq!(seconds / 1.698e-6, 1.0, epsilon = 1e-3);
    assert_abs_diff_eq!(
        damping_ratio_for(0.83) * critical / 0.926_70,
        1.0,
        epsilon = 1e-4
    );
}

#[test]
fn restitution_at_strong_damping_is_inversely_quadratic_in_the_damping_ratio() {
    for restitution in [1e-8, 1e-12, 1e-16, 1e-30] {
        let found = damping_ratio_for(restitution) * 2.0 * f64::sqrt(restitution);
        assert!(
            abs_diff_eq!(found, 1.0, epsilon = 1e-6),
            "{restitution}: {found}"
        );
    }
    let step = |ratio: f64| truncated_duration(ratio) - truncated_duration(1.0);
    // The duration is smooth at critical damping, with slope -2/3.
    for offset in [-1e-3, -1e-6, -1e-9, 1e-9, 1e-6, 1e-3] {
        assert_abs_diff_eq!(
            step(1.0 + offset) / offset,
            -2.0 / 3.0,
            epsilon = 1e-3 + 1e-15 / f64::abs(offset)
        );
    }
}

#[test]
fn the_damping_bound_is_the_damping_of_the_law_at_the_breaking_overlap() {
    let elastic = GRANITE.elastic();
    let (radius, strength, factor, constant) = (1e-3, 280e6, 1.07, 1.6e-4);
    let law = Bshp {
        youngs_modulus: elastic.youngs_modulus,
        poissons_ratio: elastic.poissons_ratio,
        dissipative_constant: constant,
    };
    let xi = breaking_overlap_hertzian(elastic, radius, strength, factor);
    let damping = law.force([radius; 2], xi, 0.0) - law.force([radius; 2], xi, 1.0);
    let bound = damping_bound(
        constant,
        matching_stiffness(elastic, radius, strength, factor),
    );
    assert_abs_diff_eq!(damping / bound, 1.0, epsilon = 1e-12);
    // About a tenth of the radius, although the law assumes small overlaps.
    let typical = breaking_overlap_hertzian(elastic, radius, strength, 1.0) / radius;
    assert_abs_diff_eq!(typical, 0.108, epsilon = 5e-4);
}

#[test]
fn restitution_of_metre_spheres_deviates_from_first_order_quadratically() {
    let elastic = GRANITE.elastic();
    let mass = 0.5 * sphere_mass(2700.0, 0.5);
    let rebound = |restitution: f64| {
        let law = Bshp {
            youngs_modulus: elastic.youngs_modulus,
            poissons_ratio: elastic.poissons_ratio,
            dissipative_constant: dissipative_constant_from_restitution(
                restitution,
                elastic,
                2700.0,
                0.5,
                1.0,
            ),
        };
        collide(law, 0.5, mass, 1.0, 1e-7).0
    };
    assert!(
        abs_diff_eq!(rebound(0.83), 0.8475, epsilon = 1e-4),
        "{}",
        rebound(0.83)
    );
    // The neglected term is of second order: a tenth of the damping gives a hundredth of the error.
    let error = |loss: f64| rebound(1.0 - loss) - (1.0 - loss);
    assert!(
        abs_diff_eq!(error(0.02) / error(0.002), 100.0, epsilon = 5.0),
        "{} {}",
        error(0.02),
        error(0.002)
    );
}

#[test]
fn granite_gives_the_numbers_of_the_thesis() {
    let k = matching_stiffness(GRANITE.elastic(), 1e-3, 280e6, 1.0);
    assert_abs_diff_eq!(k / 8.141_582_8e6, 1.0, epsilon = 1e-7);
    assert_abs_diff_eq!(
        breaking_overlap_linear(1e7, 1e-3, 280e6, 1.0) / 8.796_459_43e-5,
        1.0,
        epsilon = 1e-9
    );
    let printed = dissipative_constant_printed_from_restitution(0.83, 2700.0, 1.0);
    assert_abs_diff_eq!(printed / 6.269e-3, 1.0, epsilon = 1e-3);
    let right = dissipative_constant_from_restitution(0.83, GRANITE.elastic(), 2700.0, 0.5, 1.0);
    assert_abs_diff_eq!(right / 1.6249e-4, 1.0, epsilon = 1e-4);
    assert_abs_diff_eq!(damping_bound(right, k) / 1.32e3, 1.0, epsilon = 5e-3);
}

#[test]
fn both_normal_laws_reach_the_breaking_force_at_their_breaking_overlaps() {
    let elastic = GRANITE.elastic();
    let k = matching_stiffness(elastic, 1e-3, 280e6, 0.95);
    let linear = breaking_overlap_linear(k, 1e-3, 280e6, 0.95);
    let hertzian = breaking_overlap_hertzian(elastic, 1e-3, 280e6, 0.95);
    assert_abs_diff_eq!(linear / hertzian, 1.0, epsilon = 1e-12);
}

#[test]
fn the_first_restitution_coefficient_matches_an_integrated_collision() {
    // x'' = -(x^1.5 + b sqrt(x) x') from x = 0 at unit speed, by classical Runge-Kutta.
    let force = |x: f64, v: f64| -(x.max(0.0).powf(1.5) + 1e-3 * x.max(0.0).sqrt() * v);
    let (mut x, mut v, h) = (1e-12, 1.0, 1e-5);
    while x > 0.0 && (force(x, v) < 0.0 || v > 0.0) {
        let (k1, l1) = (v, force(x, v));
        let (k2, l2) = (v + 0.5 * h * l1, force(x + 0.5 * h * k1, v + 0.5 * h * l1));
        let (k3, l3) = (v + 0.5 * h * l2, force(x + 0.5 * h * k2, v + 0.5 * h * l2));
        let (k4, l4) = (v + h * l3, force(x + h * k3, v + h * l3));
        x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        v += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    let slope = (1.0 + v) / 1e-3;
    // The next term of the expansion is 0.8 b.
    assert!(
        abs_diff_eq!(slope / first_order_coefficient(), 1.0, epsilon = 1e-3),
        "{slope}"
    );
}

#[test]
fn damping_ratios_invert_restitutions() {
    for wanted in [0.99, 0.83, 0.5, 0.223, 0.1353, 0.01, 1e-3] {
        let found = truncated_restitution(damping_ratio_for(wanted));
        assert!(
            abs_diff_eq!(found / wanted, 1.0, epsilon = 1e-9),
            "{wanted} {found}"
        );
    }
    assert_abs_diff_eq!(damping_ratio_for(0.83) / 0.061_616_358, 1.0, epsilon = 1e-7);
}

#[test]
fn friction_rises_to_its_peak_and_decays_to_its_residual_value() {
    let decay = FrictionDecay {
        peak_time: 2.0,
        peak: 0.9,
        residual: 0.3,
        rate: 5.0,
    };
    assert_eq!([decay.at(1.0), decay.at(2.0)], [0.45, 0.9]);
    assert_abs_diff_eq!(decay.at(2.0 + 1e-9), 0.9, epsilon = 1e-8);
    assert_abs_diff_eq!(decay.at(100.0), 0.3, epsilon = 1e-12);
}

#[test]
fn the_printed_dissipative_constant_is_proportional_to_the_loss_of_speed() {
    let printed =
        |restitution: f64| dissipative_constant_printed_from_restitution(restitution, 2700.0, 0.5);
    for restitution in [0.01, 0.2, 0.45, 0.7, 0.95] {
        let ratio = printed(restitution) / printed(0.0);
        assert_abs_diff_eq!(ratio, 1.0 - restitution, epsilon = 1e-15);
    }
}
