//! A state that cannot be continued is refused, and the error names the likely culprit.

use crate::worlds::{INTEGRATORS, world};
use gouge_common::record::Shape;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{CundallStrackTruncated, KelvinVoigt};
use gouge_dem::{StepError, World};
use gouge_validation::scenes::{Draft, Grain};

/// Three overlapping grains in a row, of which one moves far in one step.
fn row(overlaps: [f64; 2], fast: usize) -> World {
    let (left, right) = (-2e-3 + overlaps[0], 2e-3 - overlaps[1]);
    let places = [left, 0.0, right];
    let speed = |i: usize| if i == fast { 1e7 } else { 0.0 };
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-6)
        .law(KelvinVoigt {
            stiffness: 1e6,
            damping: 0.0,
        })
        .grains((0..3).map(|i| Grain::at([places[i], 0.0], 1e-3).moving([0.0, speed(i)])));
    world(&draft)
}

#[test]
fn the_most_strained_interaction_of_the_particle_is_named() {
    let cases = [
        ([3e-4, 1e-4], 0, [0, 1]),
        ([1e-4, 3e-4], 2, [1, 2]),
        // Of both contacts of the middle grain, the deeper one.
        ([3e-4, 1e-4], 1, [0, 1]),
        ([1e-4, 3e-4], 1, [1, 2]),
    ];
    for (overlaps, fast, expected) in cases {
        match row(overlaps, fast).check() {
            Err(StepError::TooFast {
                particle,
                interaction,
                ..
            }) => assert_eq!((particle, interaction), (fast, Some(expected))),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_record_with_more_or_fewer_items_is_refused() {
    for integrator in INTEGRATORS {
        let draft = Draft::open_box(integrator, 1e-7)
            .law(KelvinVoigt {
                stiffness: 1e6,
                damping: 0.0,
            })
            .law(CundallStrackTruncated {
                friction: 0.5,
                stiffness: 1e6,
            })
            .grain(Grain::at([0.0, 0.0], 1e-3).spinning(10.0))
            .grain(Grain::at([1.99e-3, 0.0], 1e-3))
            .grain(Grain::at([5e-3, 0.0], 1e-3));
        let mut world = world(&draft);
        crate::worlds::advance(&mut world, 3);
        let record = world.record();
        let model = *world.model();
        assert!(World::from_record(model, &record).is_some());
        for (place, column) in record.columns.iter().enumerate() {
            let Shape::List(width) = column.shape else {
                continue;
            };
            // Contacts and bonds may be any number.
            if ["contacts", "bonds"].contains(&column.name.as_str()) {
                continue;
            }
            let mut longer = record.clone();
            longer.columns[place].words.extend(vec![0; width]);
            let mut shorter = record.clone();
            let words = &mut shorter.columns[place].words;
            words.truncate(words.len().saturating_sub(width));
            let number = column.words.len();
            for (changed, is_changed) in [(longer, true), (shorter, number > 0)] {
                let read = World::from_record(model, &changed);
                assert!(
                    !is_changed || read.is_none(),
                    "{integrator} {}",
                    column.name
                );
            }
        }
    }
}

#[test]
fn an_error_blames_the_time_step_only_above_its_bound() {
    for (time_step, is_above) in [(1.0 - 1e-7, false), (1.0 + 1e-7, true)] {
        let error = StepError::TooFast {
            particle: 0,
            interaction: None,
            distance: 1.0,
            limit: 0.1,
            time: 0.0,
            time_step,
            bound: 1.0,
        };
        let text = error.to_string();
        assert_eq!(
            text.contains("is above the stability bound"),
            is_above,
            "{text}"
        );
        assert_eq!(text.contains("the speed is too high"), !is_above, "{text}");
    }
}

/// Grains in a row that move by the given multiples of their own diameters per step.
fn moving(grains: &[(f64, f64)]) -> World {
    let (step, mut end) = (1e-6, 0.0);
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, step).law(KelvinVoigt {
        stiffness: 1.0,
        damping: 0.0,
    });
    for &(radius, diameters) in grains {
        end += 10.0 * radius;
        let speed = 2.0 * radius * diameters / step;
        draft = draft.grain(Grain::at([end, 0.0], radius).moving([0.0, speed]));
        end += 10.0 * radius;
    }
    world(&draft)
}

/// The grain that moves too far, how far it moves and how far it may.
fn too_fast(world: &World) -> Option<(usize, f64, f64)> {
    match world.check() {
        Ok(()) => None,
        Err(StepError::TooFast {
            particle,
            distance,
            limit,
            ..
        }) => Some((particle, distance, limit)),
        Err(other) => panic!("{other:?}"),
    }
}

#[test]
fn a_grain_may_move_by_its_own_diameter_relative_to_the_others() {
    let (small, large) = (1e-5, 1e-2);
    // The mean velocity is that of the large grain.
    for (diameters, is_stopped) in [(1.0 - 1e-9, false), (1.0 + 1e-9, true)] {
        let found = too_fast(&moving(&[
            (large, 0.0),
            (small, diameters),
            (small, -diameters),
        ]));
        assert_eq!(found.is_some(), is_stopped, "{diameters}");
        if let Some((particle, distance, limit)) = found {
            assert_eq!((particle, limit), (1, 2.0 * small));
            assert!((distance / limit - diameters).abs() < 1e-12, "{distance}");
        }
    }
    // Far less than the diameter of the large grain, which does not move.
    let found = too_fast(&moving(&[(large, 0.0), (small, 3.0), (small, 5.0)]));
    assert_eq!(found.map(|(particle, ..)| particle), Some(2));
}

#[test]
fn grains_that_move_together_or_alone_may_be_fast() {
    for world in [moving(&[(1e-3, 1e7)]), moving(&[(1e-3, 1e7); 7])] {
        let mut world = world;
        assert_eq!(too_fast(&world), None);
        crate::worlds::advance(&mut world, 20);
        assert_eq!(too_fast(&world), None);
    }
}

/// Two small grains whose ways cross beside a large one, each much farther per step than its size.
#[test]
fn small_grains_do_not_pass_through_each_other_unseen() {
    for integrator in INTEGRATORS {
        let small = |x: f64, speed: f64| Grain::at([x, 0.0], 1e-5).moving([speed, 0.0]);
        let draft = Draft::open_box(integrator, 1e-6)
            .law(KelvinVoigt {
                stiffness: 1e3,
                damping: 0.0,
            })
            .grains([small(-0.0251, 1e3), small(0.0251, -1e3)])
            .grain(Grain::at([0.0, 5.0], 0.01));
        let mut world = world(&draft);
        let stopped = (0..50).find_map(|_| world.step().err());
        let is_too_fast = matches!(stopped, Some(StepError::TooFast { particle: 0, .. }));
        assert!(is_too_fast, "{integrator}: {stopped:?}");
        let [left, right] = [0, 1].map(|i| world.particles().position[i].x);
        assert!(left < right, "{integrator}");
    }
}

/// The mean of huge velocities does not overflow.
#[test]
fn speeds_near_the_largest_number_are_too_fast_but_finite() {
    let found = too_fast(&moving(&[(1e-3, 1e304), (1e-3, 1e304), (1e-3, 1e301)]));
    assert!(found.is_some(), "{found:?}");
    assert_eq!(too_fast(&moving(&[(1e-3, 5e304); 4])), None);
}
