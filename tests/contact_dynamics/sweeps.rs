//! What sweeps start from, and the residual that they leave.

use crate::systems::{law, moving};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::detection::Feature;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::{ContactInput, Solver};
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use gouge_contact_dynamics::warm_start::{Memory, PointKey};

/// Points that change their order or their vertex keep their impulses, and no impulse is used twice.
#[test]
fn impulses_follow_their_points() {
    let key = |body: usize, vertex: usize, x: f64| PointKey {
        pair: Pair::new(body, 9),
        feature: Feature::of_first(vertex),
        place: Vec2::new(x, 0.0),
    };
    let impulse = |n: f64| Components { n, t: -n };
    let mut memory = Memory::new();
    memory.push(key(1, 4, 0.0), impulse(1.0));
    memory.push(key(2, 0, 0.0), impulse(2.0));
    memory.push(key(2, 1, 1.0), impulse(3.0));
    memory.push(key(5, 0, 0.0), impulse(4.0));
    let new = [
        key(0, 0, 0.0),
        key(2, 1, 1.0),
        key(2, 2, 0.9),
        key(2, 3, 0.2),
        key(5, 7, 0.4),
        key(6, 0, 0.0),
    ];
    let mut guesses = Vec::new();
    memory.guess(&new, 0.3, &mut guesses);
    let found: Vec<_> = guesses.iter().map(|guess| guess.n).collect();
    assert_eq!(found, [0.0, 3.0, 0.0, 2.0, 0.0, 0.0]);
}

/// The residual sees a point that slides although its impulse could stop it, and one whose impulse pulls.
#[test]
fn the_residual_has_both_directions() {
    let masses = [
        InverseMass::IMPOSED,
        InverseMass {
            x: 1.0,
            y: 1.0,
            rotation: 0.0,
        },
    ];
    let velocities = [Velocity::default(), moving(0.3, 0.0, 0.0)];
    let up = Vec2::new(0.0, 1.0);
    let residual = |n: f64, friction: f64| {
        let point = ContactInput {
            kinematics: PointKinematics::new([0, 1], up, [Vec2::zero(); 2]),
            gap: 0.0,
            impulse: Components { n, t: 0.0 },
        };
        let mut solver = Solver::new();
        let law = law(friction, 0.0, GapRule::Closed);
        solver.prepare(&[point], &law, 1.0, &velocities, &masses);
        solver.residual(&velocities)
    };
    assert_eq!(residual(0.0, 0.5), 0.0);
    assert!((residual(10.0, 0.5) - 0.3).abs() < 1e-15);
    assert!((residual(0.2, 0.5) - 0.1).abs() < 1e-15);
    assert!((residual(-0.7, 0.5) - 0.7).abs() < 1e-15);
    assert!(residual(f64::NAN, 0.5).is_nan());
}
