//! Absent terms have no effect and store nothing.

use super::scenes::{advance, bits, head, particle, world};
use crate::checks::{
    Check, Effort, Evidence, Exhibit, Failure, Measurement, Origin, Outcome, Table, Topic, thesis,
};
use gouge_dem::World;
use gouge_runner::scene::INTEGRATORS;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "economy",
        title: "Absent terms",
        about: "A term that a scene does not name has no effect: leaving it out and setting its coefficients to zero give the same bits. Nor does it store anything.",
        checks: vec![zero(), bonded(), stored(), recorded()],
    }
}

fn zero() -> Check {
    Check {
        id: "economy.zero.loose",
        claim: "A term that is absent and a term whose coefficients are zero give the same bits, with every integrator; the ledger and a wide box change no bit either.",
        equations: thesis("(9)-(25), (35)-(42), (64), (67)"),
        scene: "Five spinning grains that collide and separate again, 1000 steps; 19 terms in turn",
        oracle: "The same scene without the term",
        norm: "Number of combinations of term and integrator that differ in any bit of a position, velocity or angle",
        origin: Origin::Exact,
        reason: "Adding zero causes no rounding",
        effort: Effort::Quick,
        measure: measure_zero,
    }
}

fn bonded() -> Check {
    Check {
        id: "economy.zero.bonded",
        claim: "Bonds and beams with zero coefficients, unreachable strengths and the ledger change no bit, with every integrator.",
        equations: thesis("(33), (43)-(50)"),
        scene: "Eight grains that never touch, with bonds between some of them, 1000 steps",
        oracle: "The same scene without bonds, without beams, without yielding or with the other choice of ledger",
        norm: "Number of combinations of term and integrator that differ in any bit of a position, velocity or angle",
        origin: Origin::Exact,
        reason: "Adding zero causes no rounding",
        effort: Effort::Quick,
        measure: measure_bonded,
    }
}

fn stored() -> Check {
    Check {
        id: "economy.stored",
        claim: "A scene without a term stores nothing for it: the record of a state grows only by what the term needs.",
        equations: Evidence::NONE,
        scene: "Five grains without contacts and bonds, with contacts, with contacts that have a memory, with bonds, and with each integrator that keeps accelerations",
        oracle: "Words counted by hand: two per vector, one per number, seven per bond, six per contact with a memory",
        norm: "Largest difference in words",
        origin: Origin::Exact,
        reason: "The count must be exact",
        effort: Effort::Quick,
        measure: measure_stored,
    }
}

fn recorded() -> Check {
    Check {
        id: "economy.recorded",
        claim: "The record of a state is complete: a world read from it has the same record, after every step and after 300 further ones.",
        equations: Evidence::NONE,
        scene: "Nine grains in a periodic box with breaking bonds, contacts with a memory, drag, driving and ledger, 600 steps and 300 more, for each integrator and both friction laws with a memory",
        oracle: "The world that was recorded",
        norm: "Number of states whose records differ in any word",
        origin: Origin::Exact,
        reason: "The count must be exact",
        effort: Effort::Quick,
        measure: measure_recorded,
    }
}

/// Three by three grains in a dense periodic packing, bonded below, driven above, with every term.
fn everything(integrator: &str, friction: &str) -> String {
    let mut text = head(integrator, 2e-8)
        + "[box]\nwidth = 8e-3\nboundary = \"periodic-x\"\n[output]\nenergy = true\n"
        + "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 5.0\n"
        + &format!("[contact.tangential]\nlaw = \"{friction}\"\nfriction = 0.5\nstiffness = 5e6\n")
        + "[bond.normal]\nstiffness = 1e7\ndamping = 5.0\n\
           [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 5e6\ndamping = 5.0\n\
           [bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = 5e6\n\
           tangential_strength = 3e6\n[ambient]\nlaw = \"creeping\"\nviscosity = 1.0\n\
           [driving]\ncontroller = \"rate-limited\"\nforce_rate = 1e6\nspeed = 3.0\n\
           pressure = 1e6\narea = 1e-5\n";
    for k in 0..9 {
        let [column, row] = [k % 3, k / 3].map(f64::from);
        let at = [2.6e-3 * column + 0.7e-3 * row, 1e-3 + 1.6e-3 * row];
        text += &particle(
            at,
            [row - 1.0, 0.3 * column - 0.5],
            200.0 * (column - row),
            1e-3,
        );
        text += if k < 6 { "" } else { "role = \"driven\"\n" };
    }
    text + "[[bonds]]\nbetween = [0, 3]\n[[bonds]]\nbetween = [1, 4]\n\
            [[bonds]]\nbetween = [4, 5]\nstrength_factor = 2.0\n"
}

fn measure_recorded() -> Outcome {
    let mut wrong = 0;
    for (integrator, _) in INTEGRATORS {
        for friction in ["cundall-strack", "cundall-strack-truncated"] {
            let mut world = world(&everything(integrator, friction))?;
            for _ in 0..600 {
                advance(&mut world, 1)?;
                let words = world.to_words();
                let copy = World::from_words(*world.model(), &words);
                wrong += usize::from(copy.is_none_or(|copy| copy.to_words() != words));
            }
            wrong += usize::from(!continues_alike(&mut world)?);
        }
    }
    Ok(Measurement::count(wrong).into())
}

/// Whether a copy made from the record has the same energies and, after further steps, the same record.
fn continues_alike(world: &mut World) -> Result<bool, Failure> {
    let copy = World::from_words(*world.model(), &world.to_words());
    let Some(mut copy) = copy.filter(|copy| copy.energy() == world.energy()) else {
        return Ok(false);
    };
    advance(world, 300)?;
    advance(&mut copy, 300)?;
    Ok(copy.to_words() == world.to_words())
}

/// Grains that collide, spin and separate again; the last one is driven in scenes with driving.
fn grains(integrator: &str, normal: &str, more: &str) -> String {
    let mut text = head(integrator, 1e-8) + normal + more;
    for i in 0..5 {
        let x = f64::from(i);
        // In the middle of the widest box.
        text += &particle(
            [0.5 + 1.9e-3 * x, 2e-3 + 0.2e-3 * (x * x)],
            [2.0 - x, 0.3 * x + 0.1],
            100.0 * x,
            1e-3,
        );
    }
    text + "role = \"driven\"\n"
}

const KELVIN_VOIGT: &str =
    "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 2.0\n";
const BSHP: &str = "[contact.normal]\nlaw = \"bshp\"\nyoungs_modulus = 5e10\n\
                    poissons_ratio = 0.22\ndissipative_constant = 1e-7\n";

/// Terms without effect: name, and text of the scene.
const ZERO: [(&str, &str); 19] = [
    (
        "creeping drag",
        "[ambient]\nlaw = \"creeping\"\nviscosity = 0.0\n",
    ),
    // The coefficients must be positive, so the medium is so thin that its drag is lost in rounding.
    (
        "correlation drag",
        "[ambient]\nlaw = \"correlation\"\nviscosity = 1e-300\ndensity = 1e-300\n",
    ),
    (
        "gravity",
        "[external]\nlaw = \"gravity\"\nacceleration = 0.0\n",
    ),
    (
        "well",
        "[box]\nheight = 1.0\n[external]\nlaw = \"harmonic-well\"\nstiffness = 0.0\n",
    ),
    (
        "Haff-Werner, no friction",
        "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 0.0\ndamping = 1.0\n",
    ),
    (
        "Haff-Werner, no damping",
        "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 1.0\ndamping = 0.0\n",
    ),
    (
        "Cundall-Strack, no friction",
        "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.0\nstiffness = 1e7\n",
    ),
    (
        "Cundall-Strack, no stiffness",
        "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 1.0\nstiffness = 0.0\n",
    ),
    (
        "truncated, no friction",
        "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 0.0\nstiffness = 1e7\n",
    ),
    (
        "truncated, no stiffness",
        "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 1.0\nstiffness = 0.0\n",
    ),
    ("focal lever arms", "[contact]\ndistance = \"focal\"\n"),
    ("mean lever arms", "[contact]\ndistance = \"mean\"\n"),
    (
        "driving",
        "[driving]\ncontroller = \"rate-limited\"\nforce_rate = 0.0\nspeed = 1.0\npressure = 1e3\narea = 1.0\n",
    ),
    ("ledger", "[output]\nenergy = true\n"),
    ("no ledger", "[output]\nenergy = false\n"),
    ("box", "[box]\nwidth = 1.0\nheight = 0.1\n"),
    (
        "periodic box",
        "[box]\nwidth = 1.0\nboundary = \"periodic-x\"\n",
    ),
    (
        "bonds, none listed",
        "[bond.normal]\nstiffness = 1e7\ndamping = 1.0\n",
    ),
    (
        "beams, none listed",
        "[bond.normal]\nstiffness = 1e7\ndamping = 1.0\n[bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = 1.0\n",
    ),
];

fn outcome(text: &str, steps: u64) -> Result<Vec<u64>, Failure> {
    let mut world = world(text)?;
    advance(&mut world, steps)?;
    Ok(bits(&world))
}

/// The text of a scene, from the name of its integrator and the text of a term.
type SceneText<'a> = &'a dyn Fn(&str, &str) -> String;

/// Compares a scene with and without each term, for each integrator.
fn compare(
    steps: u64,
    pairs: &[(&str, &str, &str)],
    scene: SceneText,
) -> Result<(usize, Table), Failure> {
    let names = INTEGRATORS.iter().map(|(name, _)| *name);
    let columns: Vec<&str> = std::iter::once("term").chain(names.clone()).collect();
    let mut table = Table::new("Terms without effect change no bit", &columns);
    let mut wrong = 0;
    for (name, absent, idle) in pairs {
        let mut row = vec![(*name).to_owned()];
        for integrator in names.clone() {
            let bare = outcome(&scene(integrator, absent), steps)?;
            let same = bare == outcome(&scene(integrator, idle), steps)?;
            wrong += usize::from(!same);
            row.push(if same { "same bits" } else { "differs" }.to_owned());
        }
        table.push(row);
    }
    Ok((wrong, table))
}

fn measure_zero() -> Outcome {
    let pairs = ZERO.map(|(name, idle)| (name, "", idle));
    let (mut wrong, table) = compare(1000, &pairs, &|integrator, more| {
        // A table may be opened only once, so the normal law must come after its parent table.
        grains(integrator, "", &(more.to_owned() + KELVIN_VOIGT))
    })?;
    let hertzian = [
        ("Haff-Werner, no friction", "", ZERO[4].1),
        ("Cundall-Strack, no friction", "", ZERO[6].1),
        ("truncated, no friction", "", ZERO[8].1),
        ("mean lever arms", "", ZERO[11].1),
    ];
    let (more_wrong, hertzian) = compare(1000, &hertzian, &|integrator, more| {
        grains(integrator, "", &(more.to_owned() + BSHP))
    })?;
    wrong += more_wrong;
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table), Exhibit::Table(hertzian)]))
}

/// Eight grains in a row, slightly apart, that move and spin.
fn row(integrator: &str, laws: &str, bonds: &str) -> String {
    let mut text = head(integrator, 1e-8) + laws;
    for i in 0..8 {
        let x = f64::from(i);
        let v = [0.3 * (1.3 * x).sin(), 0.4 * (2.1 * x).cos()];
        text += &particle([2.1e-3 * x, 0.1e-3 * x], v, 50.0 * (x - 3.0), 1e-3);
    }
    text + bonds
}

const BONDS: &str = "[[bonds]]\nbetween = [0, 1]\n[[bonds]]\nbetween = [1, 2]\n\
                     [[bonds]]\nbetween = [3, 2]\n[[bonds]]\nbetween = [5, 6]\n";

fn measure_bonded() -> Outcome {
    let normal = "[bond.normal]\nstiffness = 1e6\ndamping = 2.0\n";
    let idle = "[bond.normal]\nstiffness = 0.0\ndamping = 0.0\n";
    let beam = |k: f64| {
        let c = 1e-6 * k;
        format!(
            "[bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = {k:e}\ndamping = {c:e}\n"
        )
    };
    let endless = "[bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = 1e300\n\
                   tangential_strength = 1e300\n";
    let bars = normal.to_owned();
    let beams = bars.clone() + &beam(1e6);
    let pairs = [
        ("bonds", String::new(), idle.to_owned()),
        (
            "bonds and beams",
            String::new(),
            idle.to_owned() + &beam(0.0),
        ),
        ("beams", bars.clone(), bars.clone() + &beam(0.0)),
        ("strength of bars", bars.clone(), bars + endless),
        ("strength of beams", beams.clone(), beams.clone() + endless),
        (
            "ledger",
            beams.clone() + "[output]\nenergy = true\n",
            beams + "[output]\nenergy = false\n",
        ),
    ];
    let pairs = pairs
        .each_ref()
        .map(|(name, absent, idle)| (*name, absent.as_str(), idle.as_str()));
    let (wrong, table) = compare(1000, &pairs, &|integrator, laws| {
        let bonds = if laws.contains("[bond") { BONDS } else { "" };
        row(integrator, laws, bonds)
    })?;
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}

fn measure_stored() -> Outcome {
    let words = |integrator: &str, laws: &str, bonds: &str| -> Result<f64, Failure> {
        let mut world = world(&(grains(integrator, laws, "") + bonds))?;
        world.evaluate_if_pending()?;
        Ok(world.to_words().len() as f64)
    };
    let (remembers, forgets) = (
        KELVIN_VOIGT.to_owned() + ZERO[8].1,
        KELVIN_VOIGT.to_owned() + ZERO[4].1,
    );
    let bond = "[bond.normal]\nstiffness = 1e6\ndamping = 0.0\n";
    let two = "[[bonds]]\nbetween = [0, 1]\n[[bonds]]\nbetween = [1, 2]\n";
    let bare = words("euler", "", "")?;
    // Vectors and numbers of five particles.
    let (vectors, numbers) = (2.0 * 5.0, 5.0);
    let mut all = Vec::new();
    let mut grows = |by: f64, found: f64| all.push(Measurement::absolute(bare + by, found, 0.0));
    grows(0.0, words("euler", KELVIN_VOIGT, "")?);
    grows(0.0, words("taylor", &forgets, "")?);
    // Two pairs of grains touch: their distances are 1.91 mm and 1.99 mm.
    grows(2.0 * 6.0, words("symplectic-euler", &remembers, "")?);
    grows(2.0 * 7.0, words("euler", bond, two)?);
    // The forces kept by velocity Verlet exist only within a step.
    grows(0.0, words("velocity-verlet", "", "")?);
    // Beeman: a flag, four lengths, and the accelerations of two evaluations.
    grows(5.0 + 2.0 * (vectors + numbers), words("beeman", "", "")?);
    let world = world(&grains("euler", "", ""))?;
    let nothing = world.contacts().is_none() && world.bonds().is_none();
    all.push(Measurement::count(usize::from(!nothing)));
    let forgetful = super::scenes::world(&grains("euler", KELVIN_VOIGT, ""))?;
    let memories = forgetful
        .contacts()
        .map_or(0, |weak| weak.memory_capacity());
    all.push(Measurement::count(memories));
    Ok(Measurement::worst(all).into())
}
