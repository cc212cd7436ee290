//! Closed forms of whole steps, and what holds for any system.

use crate::generators::Uniform;
use crate::systems::{System, law, moving};
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::step::Scheme;
use gouge_contact_dynamics::sweep::{Rule, StopCriterion, SweepOrder};
use gouge_contact_dynamics::units::Velocity;

const G: f64 = 9.81;
const FLAT: f64 = core::f64::consts::FRAC_PI_4;

/// A unit square on an incline that falls to the left, with slope `angle`; its lower side touches.
fn square_on_incline(angle: f64, friction: f64) -> System {
    let mut system = System::new(1e-3, law(friction, 0.0, GapRule::Predicted));
    let up = (-0.5 * angle.sin(), 0.5 * angle.cos());
    system.body(4, 0.5f64.sqrt(), up, angle + FLAT, Velocity::default());
    system.floor(angle);
    system.gravity(0.0, -G);
    system
}

#[test]
fn a_square_rests_on_an_incline_within_the_friction_angle() {
    let angle: f64 = 0.2;
    let mut system = square_on_incline(angle, 0.4);
    system.steps(200);
    let v = system.velocity(0);
    assert!(v.linear.norm() + v.angular.abs() < 1e-12);
    let impulses = system.impulses();
    assert_eq!(impulses.len(), 2);
    let normal: Vec<_> = impulses.iter().map(|p| p.n / 1e-3).collect();
    assert!((normal[0] + normal[1] - G * angle.cos()).abs() < 1e-9);
    assert!(((normal[0] - normal[1]).abs() - G * angle.sin()).abs() < 1e-9);
    let friction: f64 = impulses.iter().map(|p| p.t / 1e-3).sum();
    assert!((friction.abs() - G * angle.sin()).abs() < 1e-9);
}

#[test]
fn a_square_slides_down_a_steep_incline() {
    let (angle, friction): (f64, f64) = (0.39, 0.2);
    let mut system = square_on_incline(angle, friction);
    let start = system.position(0);
    system.steps(500);
    let acceleration = G * (angle.sin() - friction * angle.cos());
    let v = system.velocity(0);
    assert!((v.linear.norm() - acceleration * 0.5).abs() < 1e-10);
    assert!(v.linear.x < 0.0 && v.angular.abs() < 1e-10);
    let distance = (system.position(0) - start).norm();
    // The trapezoidal rule is exact for a constant acceleration.
    assert!((distance - 0.5 * acceleration * 0.25).abs() < 1e-9);
}

#[test]
fn a_disc_rolls_unless_the_incline_is_too_steep() {
    for (angle, friction, rolls) in [(0.3f64, 0.4, true), (1.2, 0.3, false)] {
        let mut system = System::new(1e-3, law(friction, 0.0, GapRule::Predicted));
        let up = (-0.5 * angle.sin(), 0.5 * angle.cos());
        system.body(0, 0.5, up, 0.0, Velocity::default());
        system.floor(angle);
        system.gravity(0.0, -G);
        system.steps(300);
        let acceleration = match rolls {
            true => G * angle.sin() * 2.0 / 3.0,
            false => G * (angle.sin() - friction * angle.cos()),
        };
        let spin = match rolls {
            true => acceleration * 0.3 / 0.5,
            false => 2.0 * friction * G * angle.cos() * 0.3 / 0.5,
        };
        let v = system.velocity(0);
        assert!((v.linear.norm() - acceleration * 0.3).abs() < 1e-9);
        assert!((v.angular - spin).abs() < 1e-8);
    }
}

/// Touching discs share one simultaneous law: all but the first leave with the same speed.
#[test]
fn a_touching_cradle_keeps_energy_and_momentum() {
    for n in [2, 3, 5, 10] {
        let mut system = System::new(1e-3, law(0.0, 1.0, GapRule::Closed));
        system.settings.scheme = Scheme::Beginning;
        for k in 0..n {
            let speed = if k == 0 { 1.0 } else { 0.0 };
            system.body(0, 0.5, (k as f64, 0.0), 0.0, moving(speed, 0.0, 0.0));
        }
        let before = system.energy();
        system.step();
        assert!((system.energy() / before - 1.0).abs() < 1e-12);
        for k in 0..n {
            let numerator = if k == 0 { 2.0 - n as f64 } else { 2.0 };
            assert!((system.velocity(k).linear.x - numerator / n as f64).abs() < 1e-12);
        }
    }
}

/// Discs with gaps collide one after the other, and a gap that is not closed yet neither brakes nor rebounds.
#[test]
fn a_cradle_with_gaps_passes_the_motion_on() {
    let mut system = System::new(0.01, law(0.0, 1.0, GapRule::Predicted));
    for k in 0..4 {
        let speed = if k == 0 { 1.0 } else { 0.0 };
        system.body(
            0,
            0.5,
            (1.03 * f64::from(k), 0.0),
            0.0,
            moving(speed, 0.0, 0.0),
        );
    }
    let before = system.energy();
    system.steps(40);
    assert!(system.energy() <= before * (1.0 + 1e-12));
    let momentum: f64 = (0..4).map(|k| system.velocity(k).linear.x).sum();
    assert!((momentum - 1.0).abs() < 1e-12);
}

/// The restitution of a point acts in the step in which it is closed: a disc on a floor.
#[test]
fn a_disc_rebounds_with_the_coefficient_of_restitution() {
    for (restitution, friction, horizontal) in [
        (0.0, 0.0, 0.0),
        (0.5, 0.3, 0.1),
        (0.8, 0.2, 2.0),
        (1.0, 0.0, 1.0),
    ] {
        let mut system = System::new(1e-6, law(friction, restitution, GapRule::Closed));
        system.body(0, 0.5, (0.0, 0.5), 0.0, moving(horizontal, -1.0, 0.0));
        system.floor(0.0);
        system.step();
        let v = system.velocity(0);
        assert!((v.linear.y - restitution).abs() < 1e-12);
        // The point sticks if mu (1 + e) is enough to stop it: W_tt = 3 W_nn.
        let limit = 3.0 * friction * (1.0 + restitution);
        let contact_speed = v.linear.x + 0.5 * v.angular;
        let expected = (horizontal - limit).max(0.0);
        assert!(
            (contact_speed - expected).abs() < 1e-5,
            "{contact_speed} {expected}"
        );
    }
}

/// A closing gap is consumed exactly: zero at the next detection.
#[test]
fn a_predicted_gap_closes_exactly() {
    let mut system = System::new(1.0, law(0.0, 0.0, GapRule::Predicted));
    system.body(0, 0.5, (0.0, 0.535), 0.0, moving(0.0, -0.05, 0.0));
    system.floor(0.0);
    system.step();
    assert!((system.velocity(0).linear.y + 0.01).abs() < 1e-15);
    system.step();
    assert!(system.velocity(0).linear.y.abs() < 1e-15);
    assert!(system.workspace().points()[0].gap.abs() < 1e-15);
    assert!((system.position(0).y - 0.5).abs() < 1e-15);
}

/// A loose heap of many shapes that fly at each other.
fn cloud(seed: u64, sides: &[usize], friction: f64, restitution: f64, gap: GapRule) -> System {
    let mut random = Uniform::new(seed);
    let mut system = System::new(0.005, law(friction, restitution, gap));
    system.settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-12 };
    for row in 0..5 {
        for column in 0..5 {
            let place = (f64::from(column) * 1.02, f64::from(row) * 1.02);
            let towards = (-(place.0 - 2.0) * 0.5, -(place.1 - 2.0) * 0.5);
            let shape = sides[(row * 5 + column) as usize % sides.len()];
            let velocity = moving(
                towards.0 + random.within(-0.5, 0.5),
                towards.1 + random.within(-0.5, 0.5),
                random.within(-2.0, 2.0),
            );
            let angle = random.within(-3.0, 3.0);
            system.body(shape, random.within(0.4, 0.5), place, angle, velocity);
        }
    }
    system
}

#[test]
fn energy_is_never_created_and_momentum_never_changes() {
    let shapes: [&[usize]; 4] = [&[0], &[3], &[6, 4], &[0, 5, 60, 3]];
    for (seed, sides) in (1..).zip(shapes) {
        for (friction, restitution) in [(0.4, 0.0), (0.0, 0.7), (0.0, 1.0)] {
            let mut system = cloud(seed, sides, friction, restitution, GapRule::Closed);
            let momentum = |system: &System| {
                let units = system
                    .assembly
                    .inverse_mass
                    .iter()
                    .zip(&system.state.configuration.velocity);
                units.fold((0.0, 0.0), |sum, (mass, v)| {
                    (sum.0 + v.linear.x / mass.x, sum.1 + v.linear.y / mass.x)
                })
            };
            let start = momentum(&system);
            let mut energy = system.energy();
            let mut met = 0;
            for _ in 0..150 {
                let report = system.step();
                assert!(report.sweeps.has_converged && report.sweeps.not_unique == 0);
                met += report.points;
                assert!(
                    system.energy() <= energy * (1.0 + 1e-10),
                    "{sides:?} {friction} {restitution}"
                );
                if restitution == 1.0 {
                    assert!((system.energy() / energy - 1.0).abs() < 1e-9);
                }
                energy = system.energy();
            }
            let end = momentum(&system);
            assert!((start.0 - end.0).abs() + (start.1 - end.1).abs() < 1e-11);
            assert!(met > 50, "{met}");
        }
    }
}

/// The laws themselves after each step, from positions and velocities only.
#[test]
fn every_contact_point_obeys_the_laws() {
    let mut system = cloud(11, &[3, 5, 0, 8], 0.4, 0.0, GapRule::Predicted);
    for _ in 0..100 {
        system.step();
        let velocities = &system.state.configuration.velocity;
        let workspace = system.workspace();
        for (row, point) in workspace.solver().rows().iter().zip(workspace.points()) {
            let (u, p) = (
                row.kinematics().relative_velocity(velocities),
                row.impulse(),
            );
            let closing = u.n + point.gap.max(0.0) / 0.005;
            assert!(closing > -1e-10 && p.n >= 0.0);
            assert!((closing * p.n).abs() < 1e-10);
            assert!(p.t.abs() <= 0.4 * p.n * (1.0 + 1e-14));
            if u.t.abs() > 1e-9 {
                assert!((p.t + 0.4 * p.n * u.t.signum()).abs() < 1e-9);
            }
        }
    }
}

fn column(n: usize) -> System {
    let mut system = System::new(0.01, law(0.4, 0.0, GapRule::Predicted));
    for k in 0..n {
        system.body(
            4,
            0.5f64.sqrt(),
            (0.0, 0.5 + k as f64),
            FLAT,
            Velocity::default(),
        );
    }
    system.floor(0.0);
    system.gravity(0.0, -1.0);
    system
}

#[test]
fn a_column_carries_its_weight_and_warm_starts_keep_it() {
    let mut system = column(6);
    system.settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-11 };
    let cold = system.step().sweeps.sweeps;
    let floor: f64 = system.impulses()[10..].iter().map(|p| p.n).sum();
    assert!((floor / 0.06 - 1.0).abs() < 1e-8, "{floor}");
    let warm = system.steps(5).sweeps.sweeps;
    assert!(warm * 20 < cold, "{warm} {cold}");
}

/// Discs on top of each other.
fn pile(n: usize) -> System {
    let mut system = System::new(0.01, law(0.4, 0.0, GapRule::Predicted));
    for k in 0..n {
        system.body(0, 0.5, (0.0, 0.5 + k as f64), 0.0, Velocity::default());
    }
    system.floor(0.0);
    system.gravity(0.0, -1.0);
    system
}

/// The order of the sweeps changes the way, not the result.
#[test]
fn both_orders_of_sweeps_find_the_same_impulses() {
    let mut sweeps = Vec::new();
    for order in [SweepOrder::Alternating, SweepOrder::Forward] {
        let mut system = pile(10);
        system.settings.sweeps.order = order;
        let report = system.step().sweeps;
        assert!(report.has_converged);
        sweeps.push(report.sweeps);
        for (above, impulse) in system.impulses().iter().enumerate().take(9) {
            let weight = (9 - above) as f64 * 0.01 * 0.25 * core::f64::consts::PI;
            assert!((impulse.n / weight - 1.0).abs() < 1e-9);
        }
    }
    assert_ne!(sweeps[0], sweeps[1]);
}

/// All criteria lead to the same state if they are strict.
#[test]
fn stop_criteria_agree_in_the_limit() {
    let stops = [
        StopCriterion::NaturalMap { velocity: 1e-13 },
        StopCriterion::Increment {
            tolerance: 1e-13,
            floor: 1e-15,
        },
        StopCriterion::Relative {
            tolerance: 1e-12,
            floor: 1e-3,
        },
    ];
    let speeds = stops.map(|stop| {
        let mut system = cloud(5, &[4, 6], 0.4, 0.0, GapRule::Predicted);
        system.settings.sweeps.stop = stop;
        assert!(system.steps(30).sweeps.has_converged);
        system.velocity(12).linear
    });
    assert!((speeds[0] - speeds[1]).norm() < 1e-7 && (speeds[0] - speeds[2]).norm() < 1e-7);
}

/// The correction of overlaps removes its fraction per step, and its work is what the bodies gain.
#[test]
fn corrections_of_overlaps_are_booked() {
    let gap = GapRule::Stabilized {
        fraction: 0.1,
        allowed_overlap: 0.002,
    };
    let mut system = System::new(0.01, law(0.0, 0.0, gap));
    system.settings.scheme = Scheme::Beginning;
    system.body(0, 0.5, (0.0, 0.0), 0.0, Velocity::default());
    system.body(0, 0.5, (0.98, 0.0), 0.0, Velocity::default());
    let report = system.step();
    assert!((report.largest_overlap - 0.02).abs() < 1e-14);
    assert!((report.work_of_correction / system.energy() - 1.0).abs() < 1e-12);
    assert!((system.position(1).x - system.position(0).x - 0.98 - 0.1 * 0.018).abs() < 1e-14);
}

/// What is not too deep is left alone: neither pushed apart nor pulled together.
#[test]
fn small_overlaps_and_gaps_are_not_corrected() {
    for distance in [0.9985, 1.0, 1.01] {
        let gap = GapRule::Stabilized {
            fraction: 0.1,
            allowed_overlap: 0.002,
        };
        let mut system = System::new(0.01, law(0.0, 0.0, gap));
        system.body(0, 0.5, (0.0, 0.0), 0.0, moving(-0.02, 0.0, 0.0));
        system.body(0, 0.5, (distance, 0.0), 0.0, moving(0.02, 0.0, 0.0));
        let report = system.step();
        assert_eq!(report.points, 1);
        assert_eq!(report.work_of_correction, 0.0);
        assert_eq!(system.velocity(0).linear.x, -0.02);
        system
            .state
            .configuration
            .velocity
            .fill(Velocity::default());
        system.step();
        assert_eq!(system.energy(), 0.0);
    }
}

/// The rule of the paper does not even stop a corner that hits a floor obliquely.
#[test]
fn the_printed_rule_leaves_a_corner_in_motion() {
    let hit = |rule| {
        let mut system = System::new(1e-6, law(0.2, 0.0, GapRule::Closed));
        system.settings.sweeps.rule = rule;
        system.settings.sweeps.max_sweeps = 1000;
        system.settings.scheme = Scheme::Beginning;
        let angle = 0.7 - core::f64::consts::FRAC_PI_2;
        system.body(
            3,
            0.5,
            (0.0, 0.5 * 0.7f64.cos() - 1e-12),
            angle,
            moving(0.0, -1.0, 0.0),
        );
        system.floor(0.0);
        system.step();
        let points = system.workspace().solver().rows();
        assert_eq!(points.len(), 1);
        points[0]
            .kinematics()
            .relative_velocity(&system.state.configuration.velocity)
            .n
    };
    assert!(hit(Rule::Exact).abs() < 1e-12);
    assert!(hit(Rule::Paper).abs() > 0.1);
}

/// A periodic box gives the same motion wherever its boundary lies.
#[test]
fn a_periodic_image_is_no_boundary() {
    let run = |shift: f64| {
        let mut system = cloud(3, &[5, 0, 3], 0.4, 0.0, GapRule::Predicted);
        system.assembly.domain.width = Some(12.0);
        system.assembly.domain.periodic = true;
        for position in &mut system.state.configuration.position {
            position.x = (position.x + shift).rem_euclid(12.0);
        }
        system.steps(60);
        (0..25).map(|k| system.velocity(k)).collect::<Vec<_>>()
    };
    for (one, other) in run(4.0).iter().zip(&run(10.5)) {
        assert!((one.linear - other.linear).norm() + (one.angular - other.angular).abs() < 1e-6);
    }
}

#[test]
fn a_step_allocates_nothing() {
    let mut system = column(5);
    system.settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-9 };
    system.steps(3);
    let info = allocation_counter::measure(|| {
        system.steps(5);
    });
    assert_eq!(info.count_total, 0);
}

/// A disc that meets a floor across a gap is stopped at the surface by the step that closes the gap, and restitution
/// acts on what is left of its speed when it is found closed. It is not braked while it can move freely.
#[test]
fn an_open_gap_does_not_use_up_the_rebound() {
    let mut system = System::new(1.0, law(0.0, 1.0, GapRule::Predicted));
    system.settings.scheme = Scheme::Beginning;
    system.body(0, 0.5, (0.0, 0.515), 0.0, moving(0.0, -0.01, 0.0));
    system.floor(0.0);
    // Twice the body is above the floor when points are detected, although it arrives in the second step.
    for velocity in [-0.01, -0.01, 0.01, 0.01] {
        system.step();
        assert!((system.velocity(0).linear.y - velocity).abs() < 1e-15);
    }
}

/// A bouncing disc keeps its coefficient of restitution wherever in a step it arrives, up to the velocity that gravity
/// adds in two steps.
#[test]
fn restitution_does_not_depend_on_the_phase_of_the_step() {
    for rule in [GapRule::Closed, GapRule::Predicted] {
        for start in [1.1, 1.1001, 1.1002, 1.1003, 1.1004] {
            let mut system = System::new(1e-4, law(0.0, 0.6, rule));
            system.body(0, 0.1, (0.0, start), 0.0, moving(0.0, 0.0, 0.0));
            system.floor(0.0);
            system.gravity(0.0, -G);
            let mut before = 0.0;
            while system.velocity(0).linear.y <= 0.0 {
                before = system.velocity(0).linear.y;
                system.step();
            }
            let ratio = -system.velocity(0).linear.y / before;
            assert!(
                (ratio - 0.6).abs() < 2.0 * G * 1e-4 / before.abs(),
                "{ratio}"
            );
        }
    }
}

/// With the rule of closed points, a body inside the alert distance falls until it touches.
#[test]
fn a_body_above_the_floor_does_not_hover() {
    let mut system = System::new(1e-3, law(0.0, 0.0, GapRule::Closed));
    system.body(0, 0.5, (0.0, 0.505), 0.0, moving(0.0, 0.0, 0.0));
    system.floor(0.0);
    system.gravity(0.0, -G);
    system.steps(100);
    let height = system.position(0).y - 0.5;
    // It may overlap by the way of one step.
    assert!((-1e-3..=0.0).contains(&height), "{height}");
}
