//! Dual numbers: with them, laws return their derivatives, so forces equal minus the slopes of stored energies up to
//! rounding.

use approx::abs_diff_eq;
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_dem::geometry::mean_distance;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, BeamLaw, Bshp, CundallStrack, CundallStrackTruncated, EulerBernoulli,
    ExternalLaw, Gravity, HarmonicWell, KelvinVoigt, NormalLaw, TangentialLaw, TangentialMotion,
};
use gouge_scalars::Dual;
use proptest::prelude::*;

/// Whether a force equals minus a slope, up to a few rounding errors.
fn is_minus(force: f64, slope: f64) -> bool {
    abs_diff_eq!(force, -slope, epsilon = 8.0 * f64::EPSILON * slope.abs())
}

proptest! {
    #[test]
    fn normal_forces_are_minus_the_slopes_of_their_energies(
        xi in 1e-9..1e-3, r in 1e-4..1e-2, s in 1e-4..1e-2, k in 1e2..1e9, nu in -0.5..0.49,
    ) {
        let x = Dual::variable(xi);
        let radii = [r, s].map(Dual::from_f64);
        let kv = KelvinVoigt { stiffness: k, damping: 7.0 };
        prop_assert!(is_minus(kv.force([r, s], xi, 0.0), kv.stored_energy(radii, x).slope()));
        let bshp = Bshp { youngs_modulus: k, poissons_ratio: nu, dissipative_constant: 1e-4 };
        prop_assert!(is_minus(bshp.force([r, s], xi, 0.0), bshp.stored_energy(radii, x).slope()));
        prop_assert!(is_minus(bshp.elastic_force([r, s], xi), bshp.stored_energy(radii, x).slope()));
        let akv = AdjustedKelvinVoigt { stiffness: k, damping: 7.0 };
        prop_assert!(is_minus(akv.force(-xi, 0.0), -akv.stored_energy(-x).slope()));
    }

    #[test]
    fn tangential_forces_are_minus_the_slopes_of_their_energies(
        zeta in -1e-4..1e-4, k in 1e2..1e9, load in 1e3_f64..1e6,
    ) {
        let x = Dual::variable(zeta);
        let eb = EulerBernoulli { stiffness: k, damping: 3.0 };
        prop_assert!(is_minus(eb.force(zeta, 0.0), eb.stored_energy(x).slope()));
        let normal = Dual::from_f64(-load);
        let slide = TangentialMotion { displacement: zeta, velocity: 1.0 };
        let cs = CundallStrack { friction: 1e9, stiffness: k, grips_at_rest: false };
        let force = cs.friction(slide, -load, &mut 0.0).force;
        prop_assert!(is_minus(force, cs.stored_energy(x, normal, Dual::default()).slope()));
        let cut = CundallStrackTruncated { friction: 1e9, stiffness: k };
        let force = cut.friction(slide, -load, &mut 0.0).force;
        prop_assert!(is_minus(force, cut.stored_energy(x, normal, Dual::default()).slope()));
    }

    #[test]
    fn external_forces_are_minus_the_gradients_of_their_potentials(
        y in -1.0..1.0, mass in 1e-6..1.0, strength in 1e-3..1e3,
    ) {
        let at = Vec2::new(Dual::from_f64(0.3), Dual::variable(y));
        let gravity = Gravity { acceleration: strength };
        let force = gravity.force(mass, Vec2::new(0.3, y));
        let slope = gravity.potential(Dual::from_f64(mass), at).slope();
        prop_assert!(force.x == 0.0 && is_minus(force.y, slope));
        let well = HarmonicWell { stiffness: strength, centre: 0.1 };
        let force = well.force(mass, Vec2::new(0.3, y));
        let slope = well.potential(Dual::from_f64(mass), at).slope();
        prop_assert!(force.x == 0.0 && is_minus(force.y, slope));
    }

    #[test]
    fn the_mean_distance_is_smooth_through_touch(r in 1e-3..1e-2) {
        // At touch u = y = r, and du/dy = 2/3 from both sides.
        for offset in [-1e-7, -1e-9, 1e-9, 1e-7] {
            let u = mean_distance(Dual::from_f64(r), Dual::variable(r * (1.0 + offset)));
            let slope = u.slope();
            prop_assert!(abs_diff_eq!(slope, 2.0 / 3.0, epsilon = 1e-5), "{offset}: {slope}");
        }
    }
}
