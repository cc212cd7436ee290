//! Absent terms have no effect and store nothing.

use super::scenes::{advance, bits};
use crate::checks::{
    Check, Effort, Evidence, Exhibit, Failure, Measurement, Origin, Outcome, Table, Topic, thesis,
};
use crate::scenes::{Bond, Draft, Grain};
use gouge_dem::World;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Bshp, Controller, EulerBernoulli, KelvinVoigt, ZhangEckert,
};
use gouge_runner::scene::{DrivingTable, INTEGRATORS};

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
fn everything(integrator: &str, friction: &str) -> Draft {
    let mut draft = Draft::open_box(integrator, 2e-8)
        .with("box.width", 8e-3)
        .with("box.boundary", "periodic-x")
        .with("output.energy", true)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 5.0,
        })
        .friction(friction, 0.5, 5e6)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 5.0,
        })
        .law(EulerBernoulli {
            stiffness: 5e6,
            damping: 5.0,
        })
        .law(ZhangEckert {
            normal_strength: 5e6,
            tangential_strength: 3e6,
        })
        .creeping_drag(1.0)
        .driving(DrivingTable {
            controller: Controller::RateLimited { force_rate: 1e6 },
            speed: 3.0,
            pressure: 1e6,
            area: Some(1e-5),
            initial_force: [0.0; 2],
        });
    for k in 0..9 {
        let [column, row] = [k % 3, k / 3].map(f64::from);
        let at = [2.6e-3 * column + 0.7e-3 * row, 1e-3 + 1.6e-3 * row];
        let grain = Grain::at(at, 1e-3)
            .moving([row - 1.0, 0.3 * column - 0.5])
            .spinning(200.0 * (column - row));
        draft = draft.grain(if k < 6 { grain } else { grain.driven() });
    }
    draft
        .bonded(0, 3)
        .bonded(1, 4)
        .bond(Bond::between(4, 5).of_strength(2.0))
}

fn measure_recorded() -> Outcome {
    let mut wrong = 0;
    for (integrator, _) in INTEGRATORS {
        for friction in ["cundall-strack", "cundall-strack-truncated"] {
            let mut world = everything(integrator, friction).world()?;
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
fn grains(integrator: &str, laws: &Draft) -> Draft {
    let grain = |i: i32| {
        let x = f64::from(i);
        // In the middle of the widest box.
        let grain = Grain::at([0.5 + 1.9e-3 * x, 2e-3 + 0.2e-3 * (x * x)], 1e-3)
            .moving([2.0 - x, 0.3 * x + 0.1])
            .spinning(100.0 * x);
        if i < 4 { grain } else { grain.driven() }
    };
    Draft::open_box(integrator, 1e-8)
        .and(laws)
        .grains((0..5).map(grain))
}

fn kelvin_voigt() -> Draft {
    Draft::empty().law(KelvinVoigt {
        stiffness: 1e7,
        damping: 2.0,
    })
}

/// Terms without effect: name, and text of the scene.
fn idle_laws() -> [(&'static str, Draft); 12] {
    let part = Draft::empty;
    let truncated = "cundall-strack-truncated";
    [
        ("creeping drag", part().creeping_drag(0.0)),
        // The coefficients must be positive, so the medium is so thin that its drag is lost in rounding.
        ("correlation drag", part().correlation_drag(1e-300, 1e-300)),
        ("gravity", part().gravity(0.0)),
        ("well", part().with("box.height", 1.0).harmonic_well(0.0)),
        (
            "Haff-Werner, no friction",
            part().friction("haff-werner", 0.0, 1.0),
        ),
        (
            "Haff-Werner, no damping",
            part().friction("haff-werner", 1.0, 0.0),
        ),
        (
            "Cundall-Strack, no friction",
            part().friction("cundall-strack", 0.0, 1e7),
        ),
        (
            "Cundall-Strack, no stiffness",
            part().friction("cundall-strack", 1.0, 0.0),
        ),
        (
            "truncated, no friction",
            part().friction(truncated, 0.0, 1e7),
        ),
        (
            "truncated, no stiffness",
            part().friction(truncated, 1.0, 0.0),
        ),
        ("focal lever arms", part().with("contact.distance", "focal")),
        ("mean lever arms", part().with("contact.distance", "mean")),
    ]
}

/// Other terms that do nothing.
fn idle_parts() -> [(&'static str, Draft); 7] {
    let part = Draft::empty;
    let (stiffness, damping) = (1e7, 1.0);
    let driving = DrivingTable {
        controller: Controller::RateLimited { force_rate: 0.0 },
        speed: 1.0,
        pressure: 1e3,
        area: Some(1.0),
        initial_force: [0.0; 2],
    };
    let wide = part().with("box.width", 1.0);
    let bars = part().law(AdjustedKelvinVoigt { stiffness, damping });
    let beams = bars.clone().law(EulerBernoulli { stiffness, damping });
    [
        ("driving", part().driving(driving)),
        ("ledger", part().with("output.energy", true)),
        ("no ledger", part().with("output.energy", false)),
        ("box", wide.clone().with("box.height", 0.1)),
        ("periodic box", wide.with("box.boundary", "periodic-x")),
        ("bonds, none", bars),
        ("beams, none", beams),
    ]
}

fn outcome(draft: &Draft, steps: u64) -> Result<Vec<u64>, Failure> {
    let mut world = draft.world()?;
    advance(&mut world, steps)?;
    Ok(bits(&world))
}

/// The text of a scene, from the name of its integrator and the text of a term.
type SceneOf<'a> = &'a dyn Fn(&str, &Draft) -> Draft;

/// Compares a scene with and without each term, for each integrator.
fn compare(
    steps: u64,
    pairs: &[(&str, Draft, Draft)],
    scene: SceneOf,
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
    let idle = idle_laws().into_iter().chain(idle_parts());
    let pairs: Vec<_> = idle
        .map(|(name, idle)| (name, Draft::empty(), idle))
        .collect();
    let (mut wrong, table) = compare(1000, &pairs, &|integrator, more| {
        grains(integrator, &more.clone().and(&kelvin_voigt()))
    })?;
    let viscoelastic = Draft::empty().law(Bshp {
        youngs_modulus: 5e10,
        poissons_ratio: 0.22,
        dissipative_constant: 1e-7,
    });
    let hertzian = [4, 6, 8, 11].map(|at| pairs[at].clone());
    let (more_wrong, hertzian) = compare(1000, &hertzian, &|integrator, more| {
        grains(integrator, &more.clone().and(&viscoelastic))
    })?;
    wrong += more_wrong;
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table), Exhibit::Table(hertzian)]))
}

/// Eight grains in a row, slightly apart, that move and spin.
fn row(integrator: &str, laws: &Draft) -> Draft {
    let mut draft = Draft::open_box(integrator, 1e-8).and(laws);
    for i in 0..8 {
        let x = f64::from(i);
        let v = [0.3 * (1.3 * x).sin(), 0.4 * (2.1 * x).cos()];
        draft = draft.grain(
            Grain::at([2.1e-3 * x, 0.1e-3 * x], 1e-3)
                .moving(v)
                .spinning(50.0 * (x - 3.0)),
        );
    }
    draft
}

fn measure_bonded() -> Outcome {
    let normal = Draft::empty().law(AdjustedKelvinVoigt {
        stiffness: 1e6,
        damping: 2.0,
    });
    let idle = Draft::empty().law(AdjustedKelvinVoigt {
        stiffness: 0.0,
        damping: 0.0,
    });
    let beam = |k: f64| {
        let c = 1e-6 * k;
        Draft::empty().law(EulerBernoulli {
            stiffness: k,
            damping: c,
        })
    };
    let endless = Draft::empty().law(ZhangEckert {
        normal_strength: 1e300,
        tangential_strength: 1e300,
    });
    let pairs_of_grains = Draft::empty()
        .bonded(0, 1)
        .bonded(1, 2)
        .bonded(3, 2)
        .bonded(5, 6);
    let bars = normal.and(&pairs_of_grains);
    let beams = bars.clone().and(&beam(1e6));
    let idle = idle.and(&pairs_of_grains);
    let pairs = [
        ("bonds", Draft::empty(), idle.clone()),
        ("bonds and beams", Draft::empty(), idle.and(&beam(0.0))),
        ("beams", bars.clone(), bars.clone().and(&beam(0.0))),
        ("strength of bars", bars.clone(), bars.and(&endless)),
        (
            "strength of beams",
            beams.clone(),
            beams.clone().and(&endless),
        ),
        (
            "ledger",
            beams.clone().with("output.energy", true),
            beams.with("output.energy", false),
        ),
    ];
    let (wrong, table) = compare(1000, &pairs, &row)?;
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}

fn measure_stored() -> Outcome {
    let words = |integrator: &str, laws: &Draft| -> Result<f64, Failure> {
        let mut world = grains(integrator, laws).world()?;
        world.evaluate_if_pending()?;
        Ok(world.to_words().len() as f64)
    };
    let idle = idle_laws();
    let (remembers, forgets) = (
        kelvin_voigt().and(&idle[8].1),
        kelvin_voigt().and(&idle[4].1),
    );
    let bond = Draft::empty().law(AdjustedKelvinVoigt {
        stiffness: 1e6,
        damping: 0.0,
    });
    let two = bond.bonded(0, 1).bonded(1, 2);
    let none = Draft::empty();
    let bare = words("euler", &none)?;
    // Vectors and numbers of five particles.
    let (vectors, numbers) = (2.0 * 5.0, 5.0);
    let mut all = Vec::new();
    let mut grows = |by: f64, found: f64| all.push(Measurement::absolute(bare + by, found, 0.0));
    grows(0.0, words("euler", &kelvin_voigt())?);
    grows(0.0, words("taylor", &forgets)?);
    // Two pairs of grains touch: their distances are 1.91 mm and 1.99 mm.
    grows(2.0 * 6.0, words("symplectic-euler", &remembers)?);
    grows(2.0 * 7.0, words("euler", &two)?);
    // The forces kept by velocity Verlet exist only within a step.
    grows(0.0, words("velocity-verlet", &none)?);
    // Beeman: a flag, four lengths, and the accelerations of two evaluations.
    grows(5.0 + 2.0 * (vectors + numbers), words("beeman", &none)?);
    let world = grains("euler", &none).world()?;
    let nothing = world.contacts().is_none() && world.bonds().is_none();
    all.push(Measurement::count(usize::from(!nothing)));
    let forgetful = grains("euler", &kelvin_voigt()).world()?;
    let memories = forgetful
        .contacts()
        .map_or(0, |weak| weak.memory_capacity());
    all.push(Measurement::count(memories));
    Ok(Measurement::worst(all).into())
}
