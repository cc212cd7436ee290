//! Parts that a scene does not have change nothing; a step allocates nothing.

use crate::worlds::{INTEGRATORS, advance, bits, sheared_with, world};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Controller, CundallStrackTruncated, HaffWerner, KelvinVoigt, ZhangEckert,
};
use gouge_runner::scene::DrivingTable;
use gouge_validation::scenes::{Bond, Draft, Grain};

/// A handful of grains that collide, spin and fall apart again.
fn grains(more: &Draft) -> Draft {
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, 1e-8).and(more);
    draft = draft.law(KelvinVoigt {
        stiffness: 1e7,
        damping: 2.0,
    });
    for i in 0..5 {
        let x = f64::from(i);
        draft = draft.grain(
            Grain::at([1.9e-3 * x, 0.2e-3 * (x * x)], 1e-3)
                .moving([2.0 - x, 0.3 * x])
                .spinning(100.0 * x),
        );
    }
    draft
}

fn outcome(draft: &Draft) -> Vec<u64> {
    let mut world = world(draft);
    advance(&mut world, 3000);
    bits(&world)
}

#[test]
fn absent_terms_are_terms_with_coefficient_zero() {
    let bare = outcome(&grains(&Draft::empty()));
    let zero_terms = [
        Draft::empty().creeping_drag(0.0),
        Draft::empty().gravity(0.0),
        Draft::empty().with("box.height", 1.0).harmonic_well(0.0),
        Draft::empty().law(HaffWerner {
            friction: 0.0,
            damping: 1.0,
        }),
        Draft::empty().law(HaffWerner {
            friction: 1.0,
            damping: 0.0,
        }),
        Draft::empty().friction("cundall-strack", 0.0, 1e7),
        Draft::empty().law(CundallStrackTruncated {
            friction: 0.0,
            stiffness: 1e7,
        }),
        Draft::empty().law(CundallStrackTruncated {
            friction: 1.0,
            stiffness: 0.0,
        }),
        Draft::empty().with("output.energy", false),
        Draft::empty().with("box.width", 1e3),
    ];
    for term in zero_terms {
        assert!(outcome(&grains(&term)) == bare, "differs with {term:?}");
    }
}

#[test]
fn the_ledger_changes_no_motion() {
    let with_ledger = |energy: bool| {
        grains(&Draft::empty().friction("cundall-strack", 0.5, 1e7)).with("output.energy", energy)
    };
    assert!(outcome(&with_ledger(true)) == outcome(&with_ledger(false)));
}

/// A small fault in its shear phase.
fn sheared(integrator: &str, friction: &str) -> gouge_dem::World {
    sheared_with(|fault| {
        fault
            .replacing("time.integrator", integrator)
            .replacing("contact.tangential.law", friction)
    })
}

#[test]
fn a_step_allocates_nothing() {
    for integrator in INTEGRATORS {
        let mut world = sheared(integrator, "cundall-strack-truncated");
        let bonds = |world: &gouge_dem::World| world.bonds().map(|s| s.len());
        advance(&mut world, 2000);
        let before = bonds(&world);
        let count = allocation_counter::measure(|| advance(&mut world, 10_000));
        assert_eq!(
            count.count_total,
            0,
            "{integrator}, bonds {before:?} {:?}",
            bonds(&world)
        );
    }
}

/// Pairs of grains that nearly touch, far from each other, and further pairs that meet soon: the list is rebuilt with more
/// pairs than before. All grains drift, so that it is rebuilt often.
fn meeting_pairs(touching: u32, meeting: u32) -> Draft {
    let pair = |k: u32| {
        let gap = if k < touching { 1e-9 } else { 0.4e-3 };
        let [x, y] = [k % 200, k / 200].map(|n| 10e-3 * f64::from(n));
        let approach = gap / 4e-6;
        [
            Grain::at([x, y], 1e-3).moving([100.0 + approach, 0.0]),
            Grain::at([x + 2e-3 + gap, y], 1e-3).moving([100.0, 0.0]),
        ]
    };
    Draft::open_box(Integrator::VelocityVerlet, 1e-7)
        .law(KelvinVoigt {
            stiffness: 1e4,
            damping: 0.0,
        })
        .with("output.energy", false)
        .grains((0..touching + meeting).flat_map(pair))
}

#[test]
fn lists_have_room_for_a_few_more_neighbours() {
    // The lists have room for 1/128 more and another 64; doubling would stop at 4096.
    for (touching, meeting) in [(4090, 60), (8192, 100)] {
        let mut world = world(&meeting_pairs(touching, meeting));
        advance(&mut world, 11);
        assert_eq!(world.number_of_contacts(), 0, "they are only near");
        let before = world.rebuilds();
        let count = allocation_counter::measure(|| advance(&mut world, 27));
        assert!(world.rebuilds() > before + 1);
        assert_eq!(count.count_total, 0, "{touching}");
    }
}

/// A chain whose bonds are all stretched too far.
#[test]
fn all_bonds_may_break_in_one_step_without_new_memory() {
    let number = 300;
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .law(ZhangEckert {
            normal_strength: 1e6,
            tangential_strength: 1e6,
        })
        .grains((0..=number).map(|i| Grain::at([2e-3 * i as f64, 0.0], 1e-3)));
    let bond = |i: usize| Bond::between(i, i + 1).of_length(1.9e-3);
    let draft = (0..number).map(bond).fold(draft, Draft::bond);
    let mut world = world(&draft);
    let count = allocation_counter::measure(|| advance(&mut world, 1));
    assert!(world.bonds().is_some_and(|bonds| bonds.is_empty()));
    assert_eq!(count.count_total, 0);
}

#[test]
fn a_recorded_state_continues_with_the_same_bits() {
    for integrator in INTEGRATORS {
        for friction in ["cundall-strack", "cundall-strack-truncated"] {
            let mut world = sheared(integrator, friction);
            for _ in 0..5 {
                advance(&mut world, 397);
                let words = world.to_words();
                let mut copy = gouge_dem::World::from_words(*world.model(), &words)
                    .expect("a state that was just recorded");
                assert!(copy.to_words() == words);
                advance(&mut world, 600);
                advance(&mut copy, 600);
                assert!(
                    copy.to_words() == world.to_words(),
                    "{integrator} {friction}"
                );
            }
        }
    }
}

#[test]
fn a_world_reset_to_an_earlier_state_repeats_its_bits() {
    for integrator in INTEGRATORS {
        let mut world = sheared(integrator, "cundall-strack");
        let bonds = |world: &gouge_dem::World| world.bonds().map(|bonds| bonds.len());
        for _ in 0..3 {
            let (state, words) = (world.state().clone(), world.to_words());
            let before = bonds(&world);
            advance(&mut world, 2000);
            let mut back = world.clone().with_state(state);
            assert!(back.to_words() == words, "{integrator}");
            assert_eq!(bonds(&back), before);
            advance(&mut back, 2000);
            assert!(back.to_words() == world.to_words(), "{integrator}");
        }
    }
}

#[test]
fn damaged_records_are_refused_without_panic() {
    let world = sheared("beeman", "cundall-strack");
    let words = world.to_words();
    for cut in (0..words.len()).step_by(97) {
        assert!(gouge_dem::World::from_words(*world.model(), &words[..cut]).is_none());
    }
    for place in (0..words.len()).step_by(101) {
        let mut damaged = words.clone();
        damaged[place] ^= 1 << 62;
        let _ = gouge_dem::World::from_words(*world.model(), &damaged);
    }
}

#[test]
fn records_with_wrong_indices_are_refused_or_run() {
    let draft = grains(&Draft::empty().friction("cundall-strack", 0.5, 1e7))
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .bonded(3, 4);
    let mut world = world(&draft);
    advance(&mut world, 10);
    let words = world.to_words();
    let mut refused = 0;
    // Adding at most five turns any index into one beyond the last particle.
    for place in 0..words.len() {
        for more in 1..=5 {
            let mut damaged = words.clone();
            damaged[place] = damaged[place].wrapping_add(more);
            match gouge_dem::World::from_words(*world.model(), &damaged) {
                Some(mut copy) => drop(copy.step()),
                None => refused += 1,
            }
        }
    }
    // At least five lengths of lists and the bond, whose second particle would be beyond the last.
    assert!(refused >= 6, "{refused}");
    // One number or one vector too many in any list of length five.
    let lengths = (0..words.len()).filter(|&place| words[place] == 5);
    for place in lengths.clone() {
        for more in [1, 2] {
            let mut longer = words.clone();
            longer[place] += 1;
            longer.splice(place + 1..place + 1, vec![0; more]);
            let read = gouge_dem::World::from_words(*world.model(), &longer);
            assert!(read.is_none(), "{more} words after {place}");
        }
    }
    assert!(lengths.count() >= 8);
}

#[test]
fn the_driving_force_continues_in_the_next_phase() {
    let draft = grains(&Draft::empty())
        .driving(DrivingTable {
            controller: Controller::RateLimited { force_rate: 1e6 },
            speed: 1.0,
            pressure: 1e6,
            area: None,
            initial_force: [0.0; 2],
        })
        .with("box.width", 0.1)
        .with("particles.4.role", "driven");
    let mut world = world(&draft);
    advance(&mut world, 100);
    let (force, model) = (world.drive().force, *world.model());
    assert!(force.x != 0.0 && force.y != 0.0);
    let next = world.continue_with(model, None).expect("the same model");
    assert_eq!(next.drive().force, force);
}
