//! Variants of the sweeps that must not change the solution, and what they cost.

use crate::generators::Uniform;
use crate::systems::{System, law, moving};
use core::f64::consts::PI;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::{
    Components, ExactRule, FrictionlessRule, LocalProblem, LocalRule, LocalStatus,
};
use gouge_contact_dynamics::step::StepReport;
use gouge_contact_dynamics::sweep::{Row, StopCriterion, SweepOrder};

const SIDES: [usize; 4] = [0, 3, 6, 11];

/// Bodies on a floor, pushed together from above.
fn heap(friction: f64) -> System {
    let mut system = System::new(0.01, law(friction, 0.0, GapRule::Predicted));
    let mut random = Uniform::new(7);
    for k in 0..30 {
        let at = (1.02 * (k % 6) as f64, 0.5 + (k / 6) as f64);
        let velocity = moving(random.within(-0.5, 0.5), -1.0, random.within(-1.0, 1.0));
        system.body(SIDES[k % 4], 0.5, at, random.within(0.0, 6.0), velocity);
    }
    system.floor(0.0);
    system.gravity(0.0, -1.0);
    system.settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-12 };
    system
}

fn step_with(momentum: f64, order: SweepOrder) -> (System, StepReport) {
    let mut system = heap(0.4);
    system.settings.sweeps.max_sweeps = 100;
    system.steps(100);
    system.settings.sweeps.max_sweeps = 100_000;
    system.settings.sweeps.momentum = momentum;
    system.settings.sweeps.order = order;
    let report = system.step();
    assert!(
        report.sweeps.has_converged && report.points > 40,
        "{report:?}"
    );
    (system, report)
}

/// Momentum changes the way, not the velocities; and it is worth it.
#[test]
fn momentum_finds_the_same_velocities_in_fewer_sweeps() {
    for order in [SweepOrder::Alternating, SweepOrder::Forward] {
        let (plain, slow) = step_with(0.0, order);
        let (extrapolated, fast) = step_with(0.9, order);
        assert!(2 * fast.sweeps.sweeps < slow.sweeps.sweeps);
        for unit in 0..30 {
            let (a, b) = (plain.velocity(unit), extrapolated.velocity(unit));
            let difference = (a.linear - b.linear).norm() + (a.angular - b.angular).abs();
            assert!(difference < 1e-9, "{difference}");
        }
        for p in extrapolated.impulses() {
            assert!(p.n >= 0.0 && p.t.abs() <= 0.4 * p.n);
        }
    }
}

/// Also when the sweeps stop early, the velocities are those that the impulses cause.
#[test]
fn velocities_follow_from_extrapolated_impulses() {
    let mut system = System::new(0.01, law(0.4, 0.0, GapRule::Predicted));
    for k in 0..12 {
        let inward = moving(1.0 - 0.2 * k as f64, 0.0, 0.3);
        system.body(6, 0.5, (0.87 * k as f64, 0.0), 0.52, inward);
    }
    system.settings.sweeps.momentum = 0.9;
    system.settings.sweeps.max_sweeps = 17;
    let mut velocities = system.state.configuration.velocity.clone();
    assert!(system.step().points > 15);
    let masses = &system.assembly.inverse_mass;
    for row in system.workspace().solver().rows() {
        row.kinematics()
            .apply(row.impulse(), masses, &mut velocities);
    }
    for (unit, expected) in velocities.iter().enumerate() {
        let found = system.velocity(unit);
        assert!((found.linear - expected.linear).norm() < 1e-13);
        assert!((found.angular - expected.angular).abs() < 1e-13);
    }
}

#[test]
fn a_momentum_of_one_is_refused() {
    let mut system = heap(0.4);
    assert!(system.settings.validate().is_ok());
    for momentum in [-0.1, 1.0, f64::NAN] {
        system.settings.sweeps.momentum = momentum;
        assert!(system.settings.validate().is_err());
    }
}

/// Friction too small to act takes the general path, and leaves the bits of the path without friction.
#[test]
fn a_vanishing_friction_is_none() {
    let run = |friction: f64| {
        let mut system = heap(friction);
        system.settings.sweeps.stop = StopCriterion::Increment {
            tolerance: 1e-6,
            floor: 0.0,
        };
        system.steps(20);
        let impulses: Vec<_> = system.impulses().iter().map(|p| p.n).collect();
        (system.state.configuration, impulses)
    };
    assert_eq!(run(0.0), run(1e-300));
}

#[test]
fn a_point_without_friction_has_the_impulse_that_stops_it() {
    let problem = LocalProblem {
        w_nn: 4.0,
        w_tt: 2.0,
        w_nt: 1.0,
        a_n: 3.0,
        a_t: -5.0,
        friction: 0.5,
    };
    let solution = FrictionlessRule.solve(&problem);
    assert_eq!(solution.impulse, Components { n: 0.75, t: 0.0 });
    assert_eq!(solution.status, LocalStatus::Sliding);
    let frictionless = LocalProblem {
        friction: 0.0,
        ..problem
    };
    assert_eq!(ExactRule.solve(&frictionless), solution);
    let leaving = LocalProblem {
        a_n: -1.0,
        ..problem
    };
    assert_eq!(
        FrictionlessRule.solve(&leaving).status,
        LocalStatus::Separated
    );
    let immobile = LocalProblem {
        w_nn: 0.0,
        ..problem
    };
    assert_eq!(
        FrictionlessRule.solve(&immobile).status,
        LocalStatus::NoSolution
    );
}

/// What a sweep reads per point.
#[test]
fn a_row_has_144_bytes() {
    assert_eq!(size_of::<Row>(), 144);
}

#[test]
fn a_step_with_momentum_allocates_nothing() {
    let mut system = System::new(0.01, law(0.4, 0.0, GapRule::Predicted));
    for k in 0..5 {
        let at = (0.0, 0.4 + 0.8 * k as f64);
        system.body(4, 0.8 * 0.5f64.sqrt(), at, 0.25 * PI, moving(0.0, 0.0, 0.0));
    }
    system.floor(0.0);
    system.gravity(0.0, -1.0);
    system.settings.sweeps.momentum = 0.9;
    system.settings.sweeps.max_sweeps = 10;
    system.steps(3);
    let info = allocation_counter::measure(|| {
        system.steps(5);
    });
    assert_eq!(info.count_total, 0);
}
