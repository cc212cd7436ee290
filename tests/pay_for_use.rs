//! Parts that a scene does not have change nothing; a step allocates nothing.

use crate::worlds::{INTEGRATORS, advance, bits, head, particle, sheared_with, world};

/// A few spinning grains that collide and separate again.
fn grains(more: &str) -> String {
    let mut text = head("velocity-verlet", 1e-8) + more;
    text += "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 2.0\n";
    for i in 0..5 {
        let x = f64::from(i);
        text += &particle(
            [1.9e-3 * x, 0.2e-3 * (x * x)],
            [2.0 - x, 0.3 * x],
            100.0 * x,
            1e-3,
        );
    }
    text
}

fn outcome(text: &str) -> Vec<u64> {
    let mut world = world(text);
    advance(&mut world, 3000);
    bits(&world)
}

#[test]
fn absent_terms_are_terms_with_coefficient_zero() {
    let bare = outcome(&grains(""));
    let zero_terms = [
        "[ambient]\nlaw = \"creeping\"\nviscosity = 0.0\n",
        "[external]\nlaw = \"gravity\"\nacceleration = 0.0\n",
        "[box]\nheight = 1.0\n[external]\nlaw = \"harmonic-well\"\nstiffness = 0.0\n",
        "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 0.0\ndamping = 1.0\n",
        "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 1.0\ndamping = 0.0\n",
        "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.0\nstiffness = 1e7\n",
        "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 0.0\nstiffness = 1e7\n",
        "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 1.0\nstiffness = 0.0\n",
        "[output]\nenergy = false\n",
        "[box]\nwidth = 1e3\n",
    ];
    for term in zero_terms {
        assert!(outcome(&grains(term)) == bare, "differs with {term}");
    }
}

#[test]
fn the_ledger_changes_no_motion() {
    let text = |energy: bool| {
        let tangential =
            "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.5\nstiffness = 1e7\n";
        grains(&format!("[output]\nenergy = {energy}\n{tangential}"))
    };
    assert!(outcome(&text(true)) == outcome(&text(false)));
}

/// A small fault in its shear phase.
fn sheared(integrator: &str, friction: &str) -> gouge_dem::World {
    sheared_with(&[
        ("velocity-verlet", integrator),
        ("cundall-strack-truncated", friction),
    ])
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
    let text =
        grains("[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.5\nstiffness = 1e7\n")
            + "[bond.normal]\nstiffness = 1e7\ndamping = 0.0\n[[bonds]]\nbetween = [3, 4]\n";
    let mut world = world(&text);
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
    let text = grains(
        "[driving]\ncontroller = \"rate-limited\"\nspeed = 1.0\npressure = 1e6\nforce_rate = 1e6\n[box]\nwidth = 0.1\n",
    ) + "role = \"driven\"\n";
    let mut world = world(&text);
    advance(&mut world, 100);
    let (force, model) = (world.drive().force, *world.model());
    assert!(force.x != 0.0 && force.y != 0.0);
    let next = world.continue_with(model, None).expect("the same model");
    assert_eq!(next.drive().force, force);
}
