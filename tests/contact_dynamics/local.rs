//! The laws of Signorini and Coulomb at single points.

use crate::generators::Uniform;
use gouge_contact_dynamics::local::{
    Components, ExactRule, LocalProblem, LocalRule, LocalStatus, PaperRule,
};
use proptest::prelude::*;

/// A contact of two bodies with random arms: W as it arises, with a determinate sign of `w_nt`.
fn problem() -> impl Strategy<Value = LocalProblem> {
    let arms = prop::array::uniform4(-1.0..1.0f64);
    let inertia = prop::array::uniform2(0.5..6.0f64);
    let velocities = prop::array::uniform2(-3.0..3.0f64);
    (arms, inertia, velocities, 0.0..1.5f64).prop_map(|(arm, i, a, friction)| LocalProblem {
        w_nn: 2.0 + arm[1] * arm[1] * i[0] + arm[3] * arm[3] * i[1],
        w_tt: 2.0 + arm[0] * arm[0] * i[0] + arm[2] * arm[2] * i[1],
        w_nt: -(arm[0] * arm[1] * i[0] + arm[2] * arm[3] * i[1]),
        a_n: a[0],
        a_t: a[1],
        friction,
    })
}

/// Largest violation of the laws, in units of the problem's velocities.
fn violation(p: &LocalProblem, impulse: Components) -> f64 {
    let u = p.velocity(impulse);
    let (f, scale) = (impulse, p.w_nn);
    let cone = (f.t.abs() - p.friction * f.n) * scale;
    let product = (u.n * f.n * scale)
        .abs()
        .sqrt()
        .min(u.n.abs().min(f.n.abs() * scale));
    // Dissipation is the largest possible: f_t u_t = -mu f_n |u_t|.
    let opposed = (f.t * u.t + p.friction * f.n * u.t.abs()).abs() * scale;
    [-u.n, -f.n * scale, cone, product, opposed]
        .into_iter()
        .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn the_exact_rule_satisfies_the_laws(p in problem()) {
        let p = LocalProblem { friction: p.friction.min(0.99 * p.w_nn / p.w_nt.abs()), ..p };
        let solution = ExactRule.solve(&p);
        prop_assert!(solution.status.is_unique());
        prop_assert!(violation(&p, solution.impulse) < 1e-12, "{p:?} {solution:?}");
        let u = p.velocity(solution.impulse);
        match solution.status {
            LocalStatus::Separated => prop_assert_eq!(solution.impulse, Components::default()),
            LocalStatus::Sticking => prop_assert!(u.n.abs() + u.t.abs() < 1e-13),
            _ => prop_assert!((solution.impulse.t.abs() - p.friction * solution.impulse.n).abs() < 1e-14),
        }
    }

    /// No other admissible impulse satisfies the laws: the natural map contracts to the same solution from anywhere.
    #[test]
    fn the_solution_is_unique(p in problem(), start in prop::array::uniform2(-2.0..2.0f64)) {
        let friction = p.friction.min(0.5 * p.w_nn / p.w_nt.abs());
        let p = LocalProblem { friction, ..p };
        let solution = ExactRule.solve(&p).impulse;
        let (mut n, mut t) = (start[0].abs(), start[1]);
        let step = 0.3 / (p.w_nn + p.w_tt);
        for _ in 0..6000 {
            let u = p.velocity(Components { n, t });
            n = (n - step * u.n).max(0.0);
            t = (t - step * u.t).clamp(-p.friction * n, p.friction * n);
        }
        prop_assert!((n - solution.n).abs() + (t - solution.t).abs() < 1e-6, "{n} {t} {solution:?}");
    }

    /// Mirror images have mirrored solutions, and solutions scale with the velocities.
    #[test]
    fn the_solution_is_equivariant(p in problem(), factor in prop::sample::select(vec![0.25, 2.0, 1024.0])) {
        let one = ExactRule.solve(&p);
        let mirrored = LocalProblem { w_nt: -p.w_nt, a_t: -p.a_t, ..p };
        let other = ExactRule.solve(&mirrored);
        if one.status.is_unique() {
            prop_assert_eq!((one.impulse.n, one.impulse.t), (other.impulse.n, -other.impulse.t));
            let scaled = ExactRule.solve(&LocalProblem { a_n: factor * p.a_n, a_t: factor * p.a_t, ..p });
            prop_assert_eq!((scaled.impulse.n, scaled.impulse.t), (factor * one.impulse.n, factor * one.impulse.t));
        }
    }

    /// Without coupling, as between discs, the printed rule is right.
    #[test]
    fn both_rules_agree_without_coupling(p in problem()) {
        let p = LocalProblem { w_nt: 0.0, ..p };
        let [exact, paper] = [ExactRule.solve(&p), PaperRule.solve(&p)].map(|s| s.impulse);
        prop_assert!((exact.n - paper.n).abs() + (exact.t - paper.t).abs() < 1e-14);
    }

    /// Beyond the limit of uniqueness there still is a solution, because W is positive definite.
    #[test]
    fn solutions_exist_beyond_uniqueness(p in problem(), excess in 1.0..4.0) {
        prop_assume!(p.w_nt.abs() > 0.05);
        let p = LocalProblem { friction: excess * p.w_nn / p.w_nt.abs(), ..p };
        let solution = ExactRule.solve(&p);
        prop_assert!(solution.status != LocalStatus::NoSolution);
        prop_assert!(violation(&p, solution.impulse) < 1e-9 * (1.0 + p.friction), "{p:?} {solution:?}");
    }
}

#[test]
fn the_printed_rule_is_often_wrong() {
    let mut random = Uniform::new(7);
    let (mut wrong, mut loaded) = (0, 0);
    for _ in 0..20_000 {
        let [c1n, c1t, c2n, c2t] = core::array::from_fn(|_| random.within(-1.0, 1.0));
        let p = LocalProblem {
            w_nn: 2.0 + 4.0 * (c1t * c1t + c2t * c2t),
            w_tt: 2.0 + 4.0 * (c1n * c1n + c2n * c2n),
            w_nt: -4.0 * (c1n * c1t + c2n * c2t),
            a_n: random.within(0.0, 1.0),
            a_t: random.within(-2.0, 2.0),
            friction: 0.4,
        };
        if ExactRule.solve(&p).status.is_unique() {
            loaded += 1;
            wrong += usize::from(violation(&p, PaperRule.solve(&p).impulse) > 1e-6);
        }
    }
    assert!(wrong * 4 > loaded, "{wrong} of {loaded}");
}

/// The rod of Painlevé: three answers to a point that separates, and singular problems.
#[test]
fn doubtful_problems_have_a_status() {
    let p = LocalProblem {
        w_nn: 1.0,
        w_tt: 4.0,
        w_nt: 1.5,
        a_n: -1.0,
        a_t: -7.0,
        friction: 1.0,
    };
    let solution = ExactRule.solve(&p);
    assert_eq!(solution.status, LocalStatus::SeveralSolutions);
    let jammed = Components { n: 2.0, t: -2.0 };
    assert!(violation(&p, Components::default()) == 0.0);
    assert!(p.velocity(jammed).n.abs() < 1e-15 && p.velocity(jammed).t >= 0.0);
    let immobile = LocalProblem {
        w_nn: 0.0,
        w_tt: 0.0,
        w_nt: 0.0,
        a_n: 1.0,
        ..p
    };
    assert_eq!(ExactRule.solve(&immobile).status, LocalStatus::NoSolution);
    let on_rails = LocalProblem {
        w_nn: 2.0,
        w_tt: 0.0,
        w_nt: 0.0,
        a_n: 1.0,
        a_t: -3.0,
        friction: 0.5,
    };
    let solution = ExactRule.solve(&on_rails);
    assert_eq!((solution.impulse.n, solution.impulse.t), (0.5, -0.25));
    assert_eq!(
        ExactRule
            .solve(&LocalProblem {
                a_t: 0.0,
                ..on_rails
            })
            .status,
        LocalStatus::Sticking
    );
}
