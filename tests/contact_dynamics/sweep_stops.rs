//! When sweeps stop: each criterion holds to a billionth of its bound, in one strip and in several.

use crate::systems::{law, moving};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::{
    ContactInput, Solver, StopCriterion, SweepOrder, SweepReport, SweepSettings,
};
use gouge_contact_dynamics::units::{InverseMass, Velocity};

const MORE: f64 = 1.0 + 1e-9;
const LESS: f64 = 1.0 - 1e-9;
/// Points on a floor, which do not feel each other.
const POINTS: usize = 40;
const ORDERS: [SweepOrder; 3] = [
    SweepOrder::Alternating,
    SweepOrder::Forward,
    SweepOrder::Strips,
];

/// Bodies without rotation on a floor, which one sweep stops.
struct Falling {
    masses: Vec<f64>,
    /// Guesses of all impulses.
    guess: f64,
    /// Velocities to the side.
    slip: f64,
    friction: f64,
}

impl Falling {
    /// Bodies with equal masses except one. All have a speed of 1 m/s.
    fn but(odd: usize, mass: f64) -> Self {
        let mut masses = vec![0.5; POINTS];
        masses[odd] = mass;
        Self {
            masses,
            guess: 0.0,
            slip: 0.0,
            friction: 0.0,
        }
    }

    /// A single sweep.
    fn sweep(&self, order: SweepOrder, stop: StopCriterion) -> SweepReport {
        let mut inverse = vec![InverseMass::IMPOSED];
        inverse.extend(self.masses.iter().map(|mass| InverseMass {
            x: 1.0 / mass,
            y: 1.0 / mass,
            rotation: 0.0,
        }));
        let mut velocities = vec![Velocity::default()];
        velocities.resize(POINTS + 1, moving(self.slip, -1.0, 0.0));
        let input = |body: u32| ContactInput {
            kinematics: PointKinematics::new([0, body], Vec2::new(0.0, 1.0), [Vec2::zero(); 2]),
            gap: 0.0,
            impulse: Components {
                n: self.guess,
                t: 0.0,
            },
        };
        let points: Vec<_> = (1..=POINTS as u32).map(input).collect();
        let law = law(self.friction, 0.0, GapRule::Closed);
        let mut solver = Solver::new();
        let places = (0..=POINTS).map(|k| if k == 0 { f64::NAN } else { k as f64 });
        solver.set_places(places, None);
        solver.prepare(&points, &law, 1.0, &velocities, &inverse);
        let settings = SweepSettings {
            stop,
            max_sweeps: 1,
            order,
            ..SweepSettings::default()
        };
        let report = solver.solve(&settings, &inverse, &mut velocities);
        let is_divided = order == SweepOrder::Strips;
        assert_eq!(solver.strips() >= 4, is_divided);
        report
    }

    /// The largest change is so many mean impulses.
    fn has_increment(&self, expected: f64) {
        for order in ORDERS {
            for (factor, stops) in [(LESS, false), (MORE, true)] {
                let criterion = |tolerance, floor| StopCriterion::Increment { tolerance, floor };
                let report = self.sweep(order, criterion(expected * factor, 1e-9));
                assert_eq!(report.has_converged, stops, "{order:?} {factor}");
            }
        }
    }

    /// The largest relative change.
    fn has_relative_change(&self, expected: f64, floor: f64) {
        for order in ORDERS {
            for (factor, stops) in [(LESS, false), (MORE, true)] {
                let tolerance = expected * factor;
                let report = self.sweep(order, StopCriterion::Relative { tolerance, floor });
                assert_eq!(report.has_converged, stops, "{order:?} {factor}");
            }
        }
    }
}

/// One body is heavier than the others by much or by very little, and is at the beginning, in the middle or at the end.
#[test]
fn the_largest_change_is_compared_with_the_mean_impulse() {
    for odd in [0, 17, POINTS - 1] {
        for mass in [0.5, 0.8, 0.5 * (1.0 + 1e-7), 0.5 * (1.0 - 1e-7), 0.2] {
            let falling = Falling::but(odd, mass);
            let mean = falling.masses.iter().sum::<f64>() / POINTS as f64;
            falling.has_increment(mass.max(0.5) / mean);
            // With this friction, all bodies stop sliding.
            let sliding = Falling {
                slip: 2.0,
                friction: 3.0,
                ..falling
            };
            sliding.has_increment(2.0 * mass.max(0.5) / mean);
        }
    }
}

#[test]
fn relative_changes_are_those_of_each_point() {
    for odd in [0, 17, POINTS - 1] {
        let falling = Falling {
            guess: 0.1,
            ..Falling::but(odd, 0.8)
        };
        falling.has_relative_change(0.7 / 0.8, 1e-9);
        // The floor is compared with the mean of the guesses.
        falling.has_relative_change(0.7 / (0.1 * 9.0), 9.0);
        let sliding = Falling {
            slip: 2.0,
            friction: 3.0,
            ..Falling::but(odd, 0.8)
        };
        sliding.has_relative_change(1.0, 1e-9);
    }
}

/// Columns of three bodies on a floor: their masses, and the points between them.
fn columns() -> (Vec<InverseMass>, Vec<ContactInput>) {
    let masses = [1.0, 0.7, 0.4].map(|mass: f64| InverseMass {
        x: 1.0 / mass,
        y: 1.0 / mass,
        rotation: 0.0,
    });
    let mut all = vec![InverseMass::IMPOSED];
    all.extend(masses.iter().cycle().take(3 * POINTS));
    let input = |units| ContactInput {
        kinematics: PointKinematics::new(units, Vec2::new(0.0, 1.0), [Vec2::zero(); 2]),
        gap: 0.0,
        impulse: Components::default(),
    };
    let lowest = (0..POINTS as u32).map(|k| 3 * k + 1);
    let units = lowest.flat_map(|first| [[0, first], [first, first + 1], [first + 1, first + 2]]);
    (all, units.map(input).collect())
}

/// One of the columns falls faster: one sweep leaves a residual, which a bound refuses or accepts.
#[test]
fn a_residual_is_bounded() {
    let (all, points) = columns();
    let run = |(order, odd): (SweepOrder, usize), stop, largest_residual| {
        let mut start = vec![Velocity::default()];
        let speeds = [(3.0, -1.0), (-1.0, -2.0), (0.3, -2.5)];
        let slow = speeds.map(|(x, y)| moving(x, y, 0.0));
        start.extend(slow.iter().cycle().take(3 * POINTS));
        start[3 * odd + 3] = moving(0.3, -4.0, 0.0);
        let mut velocities = start.clone();
        let mut solver = Solver::new();
        let place = |unit: usize| {
            if unit == 0 {
                f64::NAN
            } else {
                ((unit - 1) / 3) as f64
            }
        };
        solver.set_places((0..all.len()).map(place), None);
        solver.prepare(&points, &law(0.1, 0.0, GapRule::Closed), 1.0, &start, &all);
        let settings = SweepSettings {
            stop,
            max_sweeps: 1,
            largest_residual,
            order,
            ..SweepSettings::default()
        };
        let report = solver.solve(&settings, &all, &mut velocities);
        (report.has_converged, solver.residual(&velocities))
    };
    let loose = StopCriterion::Increment {
        tolerance: 1e9,
        floor: 1.0,
    };
    for case in ORDERS
        .into_iter()
        .flat_map(|order| [0, 20, POINTS - 1].map(|odd| (order, odd)))
    {
        let (_, residual) = run(case, loose, None);
        assert!(residual > 0.1);
        for (factor, stops) in [(LESS, false), (MORE, true)] {
            let velocity = residual * factor;
            assert_eq!(run(case, loose, Some(velocity)).0, stops);
            let stop = StopCriterion::NaturalMap { velocity };
            assert_eq!(run(case, stop, None).0, stops);
        }
    }
}

/// By default, sweeps stop at changes of a thousandth of the mean impulse.
#[test]
fn the_default_stops_at_a_thousandth() {
    for (factor, stops) in [(LESS, true), (MORE, false)] {
        let falling = Falling {
            guess: 0.5 * (1.0 - 1e-3 * factor),
            ..Falling::but(0, 0.5)
        };
        for order in ORDERS {
            let report = falling.sweep(order, SweepSettings::default().stop);
            assert_eq!(report.has_converged, stops);
        }
    }
}

/// The residual of points that do not feel each other is the largest of all, in any order.
#[test]
fn the_largest_residual_counts() {
    let law: ContactLaw = law(0.5, 0.0, GapRule::Closed);
    let up = Vec2::new(0.0, 1.0);
    let residual = |speeds: [f64; 3]| {
        let one = InverseMass {
            x: 1.0,
            y: 1.0,
            rotation: 0.0,
        };
        let masses = [InverseMass::IMPOSED, one, one, one];
        let mut velocities = [Velocity::default(); 4];
        for (velocity, speed) in velocities[1..].iter_mut().zip(speeds) {
            *velocity = moving(0.0, -speed, 0.0);
        }
        let points = [1, 2, 3].map(|body| ContactInput {
            kinematics: PointKinematics::new([0, body], up, [Vec2::zero(); 2]),
            gap: 0.0,
            impulse: Components::default(),
        });
        let mut solver = Solver::new();
        solver.prepare(&points, &law, 1.0, &velocities, &masses);
        solver.residual(&velocities)
    };
    let little = 1.0 - 1e-7;
    for speeds in [
        [1.0, little, 0.2],
        [little, 1.0, little],
        [0.5, little, 1.0],
    ] {
        assert!((residual(speeds) - 1.0).abs() < 1e-14);
    }
}
