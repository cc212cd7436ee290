//! Results depend neither on the instructions of the machine nor on the number of threads, nor on compiler
//! optimisation. Fingerprints of the bits are recorded; `cargo test --profile dev machine` compares them
//! without optimisation.

use crate::program::{gouge, stderr};
use crate::recorded::record;
use crate::worlds::{advance, sheared_with, world};
use gouge_common::instructions::Instructions;
use gouge_dem::bonds::BondStart;
use gouge_dem::laws::{Bshp, HaffWerner};
use gouge_dem::model::Model;
use gouge_dem::{Start, World};
use gouge_validation::scenes::Draft;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Another law or another way for the fault.
const VARIANTS: [fn(Draft) -> Draft; 8] = [
    |fault| fault,
    |fault| fault.replacing("time.integrator", "beeman"),
    |fault| fault.replacing("time.integrator", "taylor"),
    |fault| fault.replacing("contact.tangential.law", "cundall-strack"),
    |fault| {
        let fault = fault.replacing("reading", "thesis");
        fault.with("material.inertia_factor", 0.4)
    },
    |fault| {
        fault.law(HaffWerner {
            friction: 0.7,
            damping: 100.0,
        })
    },
    |fault| {
        fault.law(Bshp {
            youngs_modulus: 50e9,
            poissons_ratio: 0.22,
            dissipative_constant: 1e-8,
        })
    },
    |fault| fault.replacing("contact.distance", "focal"),
];

/// The same world without an energy ledger: only then are contacts and bonds divided among threads.
fn without_ledger(world: &World) -> World {
    let model = Model {
        ledger: false,
        ..*world.model()
    };
    let continued = world.clone().continue_with(model, None);
    continued.expect("nothing else changes")
}

/// The state after some steps from a recorded state, computed with the given instructions and number of threads.
fn continued(world: &World, instructions: Instructions, threads: usize, steps: u64) -> Vec<u64> {
    let copy = World::from_words(*world.model(), &world.to_words()).expect("just recorded");
    let mut copy = copy.with_instructions(instructions).with_threads(threads);
    advance(&mut copy, steps);
    copy.to_words()
}

/// A fingerprint of the bits after some steps; checks that it is the same for all instructions and numbers of threads.
fn fingerprint(world: &World, steps: u64, what: &str) -> String {
    let portable = continued(world, Instructions::portable(), 1, steps);
    let sets = Instructions::available().into_iter().map(|set| (set, 1));
    let divisions = [2, 3, 5].map(|threads| (Instructions::widest(), threads));
    for (instructions, threads) in sets.chain(divisions) {
        assert!(
            continued(world, instructions, threads, steps) == portable,
            "{what}: {} with {threads} threads give different bits than portable instructions with one thread",
            instructions.name()
        );
    }
    let bytes: Vec<u8> = portable
        .iter()
        .flat_map(|word| word.to_le_bytes())
        .collect();
    Sha256::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// Whether bonds break, neighbour lists are rebuilt and particles touch within some steps.
fn shows_enough(world: &World, steps: u64) -> bool {
    let bonds = |world: &World| world.bonds().map_or(0, |bonds| bonds.len());
    let mut after = world.clone();
    advance(&mut after, steps);
    bonds(&after) < bonds(world)
        && after.rebuilds() > world.rebuilds()
        && after.number_of_contacts() > 0
}

#[test]
fn a_fault_has_the_same_bits_on_every_machine() {
    let mut fingerprints = String::new();
    for (number, variant) in VARIANTS.iter().enumerate() {
        let world = sheared_with(variant);
        for (ledger, world) in [("", &world), (" without ledger", &without_ledger(&world))] {
            let bits = fingerprint(world, 12_000, &format!("variant {number}{ledger}"));
            fingerprints += &format!("variant {number}{ledger} {bits}\n");
            assert!(
                shows_enough(world, 12_000),
                "the scene shows too little: variant {number}"
            );
        }
    }
    record("bits_of_a_fault", &fingerprints);
}

/// A world of at least `least` particles: copies of a world, side by side along the periodic direction. Contacts and
/// bonds begin again; bonds across the periodic boundary are left out.
fn repeated(world: &World, least: usize) -> World {
    let number = world.particles().len();
    let width = world.model().period().expect("the box is periodic");
    let times = least.div_ceil(number);
    let mut model = *world.model();
    model.domain.width = Some(width * times as f64);
    if let Some(driving) = &mut model.driving {
        driving.area *= times as f64;
    }
    let particles = world.particles().repeated(width, times);
    let x = |i: usize| world.particles().position[i].x;
    let bonds = world.bonds().expect("there are bonds");
    let pairs = bonds.pairs().iter().map(|pair| pair.indices());
    let inner = pairs.filter(|&(i, j)| (x(j) - x(i)).abs() < 0.5 * width);
    let bond = |(i, j): (usize, usize)| BondStart {
        between: [i, j],
        strength_factor: 1.0,
        initial_distance: None,
        initial_angles: None,
    };
    let start = Start {
        bonds: (0..times)
            .flat_map(|copy| {
                inner
                    .clone()
                    .map(move |(i, j)| (i + copy * number, j + copy * number))
            })
            .map(bond)
            .collect(),
        drive_force: world.drive().force * times as f64,
        ..Start::default()
    };
    World::new(model, particles, &start).expect("the kernel takes the copies")
}

#[test]
fn a_world_beyond_the_caches_has_the_same_bits_on_every_machine() {
    let sheared = sheared_with(|fault| fault);
    let mut fingerprints = String::new();
    for (ledger, world) in [("with", &sheared), ("without", &without_ledger(&sheared))] {
        // More particles than `forces/ahead.rs` treats as a small world.
        let world = repeated(world, 21_000);
        assert!(
            world.number_of_contacts() > 1000
                && world.bonds().is_some_and(|bonds| bonds.len() > 1000)
        );
        let bits = fingerprint(&world, 100, &format!("copies {ledger} ledger"));
        fingerprints += &format!("{ledger} ledger {bits}\n");
    }
    record("bits_beyond_the_caches", &fingerprints);
}

#[test]
fn single_collisions_have_the_same_bits_on_every_machine() {
    let mut fingerprints = String::new();
    for name in ["head-on", "oblique", "rolling", "cantilever"] {
        let bits = fingerprint(&world(&Draft::builtin(name)), 3000, name);
        fingerprints += &format!("{name} {bits}\n");
    }
    record("bits_of_single_collisions", &fingerprints);
}

/// Contents of all tables that a run writes with an environment variable set.
fn outputs((variable, value): (&str, &str)) -> BTreeMap<String, Vec<u8>> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut command = gouge();
    command
        .args(["run", "oblique", "--quiet", "--out"])
        .arg(folder.path())
        .env(variable, value);
    let output = command.output().expect("the program starts");
    assert!(output.status.success(), "{}", stderr(&output));
    let files = std::fs::read_dir(folder.path()).expect("a folder of outputs");
    let paths = files.map(|file| file.expect("readable").path());
    paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "csv"))
        .map(|path| {
            let name = path.file_name().expect("has a name").to_string_lossy();
            (name.into_owned(), std::fs::read(&path).expect("readable"))
        })
        .collect()
}

#[test]
fn environment_variables_choose_instructions_and_threads() {
    let usual = outputs(("UNRELATED", ""));
    assert!(!usual.is_empty());
    for instructions in Instructions::available() {
        assert!(outputs(("GOUGE_INSTRUCTIONS", instructions.name())) == usual);
    }
    assert!(outputs(("GOUGE_THREADS", "2")) == usual);
}

#[test]
fn invalid_environment_variables_are_refused() {
    let cases = [
        ("GOUGE_INSTRUCTIONS", "fast", "portable"),
        ("GOUGE_THREADS", "0", "from 1 to 1024"),
        ("GOUGE_THREADS", "two", "from 1 to 1024"),
    ];
    for (variable, value, accepted) in cases {
        let output = gouge()
            .arg("scenes")
            .env(variable, value)
            .output()
            .expect("the program starts");
        assert_eq!(output.status.code(), Some(2));
        let message = stderr(&output);
        assert!(message.contains(&format!("{variable} = {value}")) && message.contains(accepted));
    }
}
