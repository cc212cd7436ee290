//! Single points at the edge of the Coulomb cone, of uniqueness and of singular problems.

use gouge_contact_dynamics::local::{
    Components, ExactRule, LocalProblem, LocalRule, LocalStatus, PaperRule,
};

const MORE: f64 = 1.0 + 1e-9;
const LESS: f64 = 1.0 - 1e-9;

/// The problem of an operator that an impulse solves without a velocity.
fn solved_by(w: [f64; 3], friction: f64, impulse: Components) -> LocalProblem {
    let [w_nn, w_tt, w_nt] = w;
    let p = LocalProblem {
        w_nn,
        w_tt,
        w_nt,
        a_n: 0.0,
        a_t: 0.0,
        friction,
    };
    let a = p.velocity(impulse);
    LocalProblem {
        a_n: a.n,
        a_t: a.t,
        ..p
    }
}

/// A tangential impulse a little below the Coulomb limit sticks, and one a little above it slides.
#[test]
fn points_stick_inside_the_cone() {
    // Unique, and so much coupling and friction that all statuses are tried.
    for (w, friction) in [([1.0, 2.0, 0.4], 0.5), ([1.0, 2.0, 0.9], 1.25)] {
        for (factor, status) in [(LESS, LocalStatus::Sticking), (MORE, LocalStatus::Sliding)] {
            let impulse = Components {
                n: 1.0,
                t: friction * factor,
            };
            let p = solved_by(w, friction, impulse);
            let found = ExactRule.solve(&p);
            assert_eq!(found.status, status, "{p:?}");
            assert!((found.impulse.n - 1.0).abs() < 1e-8);
            assert_eq!(PaperRule.solve(&p).status, status);
        }
    }
}

/// Friction at which the answer is no longer unique: the rod of Painlevé jams although it separates.
#[test]
fn uniqueness_ends_where_friction_compensates_the_coupling() {
    for (w_nn, status) in [
        (1.5 * LESS, LocalStatus::SeveralSolutions),
        (1.5 * MORE, LocalStatus::Separated),
    ] {
        let p = LocalProblem {
            w_nn,
            w_tt: 4.0,
            w_nt: 1.5,
            a_n: -1e-9,
            a_t: -7.0,
            friction: 1.0,
        };
        assert_eq!(ExactRule.solve(&p).status, status);
    }
}

/// An operator that is nearly singular determines the impulse, and a singular one does not.
#[test]
fn nearly_singular_problems_are_regular() {
    let impulse = Components { n: 1.0, t: 0.3 };
    let p = solved_by([1.1, 1.3, (1.1f64 * 1.3 - 1e-7).sqrt()], 1.5, impulse);
    let found = ExactRule.solve(&p);
    assert_eq!(found.status, LocalStatus::Sticking);
    assert!((found.impulse.t - 0.3).abs() < 1e-7, "{found:?}");
    // Only the sum of both components of the impulse has an effect, and it cannot stop both velocities.
    for a_t in [1.5, 2.0] {
        let p = LocalProblem {
            w_nn: 1.0,
            w_tt: 1.0,
            w_nt: 1.0,
            a_n: 1.0,
            a_t,
            friction: 2.0,
        };
        let found = ExactRule.solve(&p);
        assert_eq!(found.status, LocalStatus::Sliding);
        assert!((found.impulse.n - 1.0 / 3.0).abs() < 1e-15);
        assert!((found.impulse.t - 2.0 / 3.0).abs() < 1e-15);
    }
}

/// On rails that cannot move sideways, the impulse stops the approach and opposes the sliding.
#[test]
fn points_on_rails_slide_both_ways() {
    for (a_t, t) in [(-3.0, -0.25), (0.0, 0.0), (3.0, 0.25)] {
        let p = LocalProblem {
            w_nn: 2.0,
            w_tt: 0.0,
            w_nt: 0.0,
            a_n: 1.0,
            a_t,
            friction: 0.5,
        };
        let found = ExactRule.solve(&p).impulse;
        assert_eq!((found.n, found.t), (0.5, t));
    }
}

/// On the edge of the cone a point sticks, and a point without a velocity has no impulse.
#[test]
fn edges_belong_to_the_simpler_status() {
    let edge = solved_by([1.0, 2.0, 0.0], 0.5, Components { n: 1.0, t: 0.5 });
    assert_eq!(ExactRule.solve(&edge).status, LocalStatus::Sticking);
    for friction in [0.5, 1.25] {
        let still = solved_by([1.0, 2.0, 0.9], friction, Components::default());
        let found = ExactRule.solve(&still);
        assert_eq!(found.status, LocalStatus::Separated);
        assert_eq!(found.impulse, Components::default());
    }
}
