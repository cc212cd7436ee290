//! Events that a run reports to its observer, and their order.

use crate::worlds::scene;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;
use gouge_runner::error::Error;
use gouge_runner::run::{Event, RunOptions, Warning, phases, run};
use gouge_runner::scene::Scene;
use gouge_validation::scenes::fault::brief;
use gouge_validation::scenes::{Draft, Grain};
use std::path::Path;

/// An event that owns its data.
#[derive(Clone, Debug, PartialEq)]
enum Seen {
    Began(usize, Vec<String>),
    Progress(usize, u64),
    Warning(f64, f64, String),
    Sample(u64, f64),
    Checkpoint(u64),
    Ended,
    AlreadyDone,
    NothingToResume,
}

fn seen(event: Event<'_>) -> Seen {
    match event {
        Event::PhaseBegan { phases, index } => Seen::Began(
            index,
            phases.iter().map(|phase| phase.name.clone()).collect(),
        ),
        Event::Progress { phase, steps } => Seen::Progress(phase, steps),
        Event::Warning(warning) => {
            let (step, bound) = match warning {
                Warning::TimeStep { step, bound, .. } => (step, bound),
                _ => (0.0, 0.0),
            };
            Seen::Warning(step, bound, warning.to_string())
        }
        Event::SampleWritten { sample, time } => Seen::Sample(sample, time),
        Event::CheckpointWritten { path, steps } => {
            assert!(path.ends_with("checkpoint") && path.exists());
            Seen::Checkpoint(steps)
        }
        Event::Ended => Seen::Ended,
        Event::AlreadyDone { .. } => Seen::AlreadyDone,
        Event::NothingToResume { .. } => Seen::NothingToResume,
    }
}

/// The events of a run and its outcome.
fn watch(scene: &Scene, folder: &Path, options: RunOptions) -> (Vec<Seen>, Result<(), Error>) {
    let mut events = Vec::new();
    let mut observer = |event: Event<'_>| events.push(seen(event));
    let outcome = run(scene, folder, options, &mut observer);
    (events, outcome.map(|_| ()))
}

/// Checkpoints only at the beginning of phases.
const RARELY: RunOptions = RunOptions {
    resume: false,
    overwrite: false,
    data_only: false,
    checkpoint_interval: f64::INFINITY,
};
/// Checkpoints as often as possible.
const OFTEN: RunOptions = RunOptions {
    resume: false,
    overwrite: false,
    data_only: false,
    checkpoint_interval: 0.0,
};

/// A small fault with short phases: two settling phases of 600 steps, relaxing and pressing phases of 800 steps,
/// shear of 4000 steps.
fn fault() -> Scene {
    scene(
        &brief()
            .replacing("time.end", 40e-6)
            .replacing("output.interval", 10e-6),
    )
}

#[test]
fn phases_samples_and_checkpoints_are_reported_in_order() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = fault();
    let phases = phases(&scene);
    let names: Vec<String> = phases.iter().map(|phase| phase.name.clone()).collect();
    assert!(phases.len() > 2, "{names:?}");
    let (events, outcome) = watch(&scene, folder.path(), RARELY);
    outcome.expect("the run succeeds");
    let (last, earlier) = phases.split_last().expect("the scene proper");
    let mut expected = Vec::new();
    for (index, phase) in earlier.iter().enumerate() {
        expected.push(Seen::Began(index, names.clone()));
        expected.push(Seen::Checkpoint(0));
        expected.push(Seen::Progress(index, phase.steps));
    }
    expected.push(Seen::Began(earlier.len(), names.clone()));
    expected.push(Seen::Checkpoint(0));
    for sample in 0..=4 {
        if sample > 0 {
            expected.push(Seen::Progress(earlier.len(), last.steps / 4 * sample));
        }
        let time = (last.steps / 4 * sample) as f64 * scene.step;
        expected.push(Seen::Sample(sample, time));
    }
    expected.push(Seen::Checkpoint(last.steps));
    expected.push(Seen::Ended);
    assert_eq!(ends_of_progress(events), expected);
}

/// The events, with only the last of consecutive progress reports. Progress must increase from report to report.
fn ends_of_progress(events: Vec<Seen>) -> Vec<Seen> {
    let mut ends: Vec<Seen> = Vec::new();
    for event in events {
        if let (Some(Seen::Progress(phase, steps)), Seen::Progress(next, more)) =
            (ends.last(), &event)
        {
            assert!(
                phase == next && steps < more,
                "{phase} {steps} {next} {more}"
            );
            ends.pop();
        }
        ends.push(event);
    }
    ends
}

/// Two touching grains, with the time step in units of sqrt(m / k).
fn pair(step: f64) -> Scene {
    // Mass 2700 4/3 pi 1e-9 kg, stiffness 1e7 N/m.
    let unit = (2700.0 * 4.0 / 3.0 * core::f64::consts::PI * 1e-9 / 1e7_f64).sqrt();
    let (stiffness, damping) = (1e7, 0.0);
    let draft = Draft::open_box(Integrator::VelocityVerlet, step * unit)
        .ending_at(2000.0 * step * unit)
        .law(KelvinVoigt { stiffness, damping })
        .with("output.interval", 1.0)
        .grain(Grain::at([0.0, 0.0], 1e-3))
        .grain(Grain::at([1.999e-3, 0.0], 1e-3));
    scene(&draft)
}

#[test]
fn a_time_step_above_the_bound_is_reported_once_before_the_first_step() {
    // Two equal masses on a spring: velocity Verlet is stable up to 2 / sqrt(2 k / m).
    for (step, warns) in [(0.5, false), (1.5, true)] {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = pair(step);
        let (events, _) = watch(&scene, folder.path(), RARELY);
        let warning = |event: &&Seen| matches!(event, Seen::Warning(step, ..) if *step > 0.0);
        assert_eq!(events.iter().filter(warning).count(), usize::from(warns));
        if !warns {
            continue;
        }
        let Seen::Warning(step, bound, text) = &events[1] else {
            panic!("{events:?}");
        };
        assert!(*step == scene.step && bound < step);
        for part in ["scene.toml: time.step = ", "gouge stability"] {
            assert!(text.contains(part), "{text}");
        }
    }
}

#[test]
fn a_failed_run_ends_without_another_checkpoint() {
    let folder = tempfile::tempdir().expect("a folder");
    let draft = Draft::open_box(Integrator::Euler, 1e-3)
        .ending_at(1.0)
        .grain(Grain::at([0.0; 2], 1e-3).moving([1e200, 0.0]));
    let (events, outcome) = watch(&scene(&draft), folder.path(), RARELY);
    assert!(matches!(outcome, Err(Error::Energy { .. })), "{outcome:?}");
    let names = vec!["run".to_owned()];
    assert_eq!(
        events,
        [Seen::Began(0, names), Seen::Checkpoint(0), Seen::Ended]
    );
}

#[test]
fn a_resumed_run_begins_in_its_phase() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = pair(0.1);
    let (events, outcome) = watch(&scene, folder.path(), OFTEN);
    outcome.expect("the run succeeds");
    let written: Vec<u64> = events
        .iter()
        .filter_map(|event| match event {
            Seen::Checkpoint(steps) => Some(*steps),
            _ => None,
        })
        .collect();
    // One checkpoint at the beginning of the phase, one per reading of the clock, one at the end.
    assert!(written.len() > 3 && written.is_sorted(), "{written:?}");
    let resumed = RunOptions {
        resume: true,
        ..RARELY
    };
    std::fs::remove_file(folder.path().join("summary.json")).expect("ours");
    let (events, outcome) = watch(&scene, folder.path(), resumed);
    outcome.expect("the run succeeds");
    // The last sample is not a regular one: it is taken again, because the checkpoint does not count it.
    let names = vec!["run".to_owned()];
    let end = scene.steps() as f64 * scene.step;
    assert_eq!(
        events,
        [
            Seen::Began(0, names),
            Seen::Sample(1, end),
            Seen::Checkpoint(2000),
            Seen::Ended
        ]
    );
    let (events, outcome) = watch(&scene, folder.path(), RARELY);
    outcome.expect("nothing is done");
    assert_eq!(events, [Seen::AlreadyDone]);
}

/// The warnings of a run, which the summary must repeat.
fn warnings(draft: &Draft) -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    let (events, outcome) = watch(&scene(draft), folder.path(), RARELY);
    outcome.expect("the run succeeds");
    let text = std::fs::read_to_string(folder.path().join("summary.json")).expect("a summary");
    let summary: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let found: Vec<String> = events
        .into_iter()
        .filter_map(|event| match event {
            Seen::Warning(_, _, text) => Some(text),
            _ => None,
        })
        .collect();
    assert_eq!(summary["warnings"], serde_json::json!(found));
    let picture = std::fs::read_to_string(folder.path().join("picture.svg")).expect("a picture");
    let is_off = found.iter().any(|text| text.contains("balance"));
    assert_eq!(picture.contains("not to be trusted"), is_off);
    found
}

/// Two grains that collide head on without damping, with the time step in units of the stability bound. They begin
/// just apart, so that only the laws tell that the step is too large.
fn collision(integrator: &str, share: f64) -> Draft {
    let mass = 2700.0 * 4.0 / 3.0 * core::f64::consts::PI * 1e-9;
    let bound = 2.0 / (2.0 * 1e7_f64 / mass).sqrt();
    let step = share * bound;
    let grain = |side: f64| Grain::at([side * 1.0001e-3, 0.0], 1e-3).moving([-side, 0.0]);
    Draft::open_box(integrator, step)
        .ending_at((20e-6 / step).ceil() * step)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .grain(grain(-1.0))
        .grain(grain(1.0))
}

#[test]
fn a_run_says_whether_its_balance_can_be_trusted() {
    // At 0.9 of the bound up to 4 * 0.81 times the energy may be gained at once; at 0.01 the energy of symplectic
    // Euler oscillates by 1 %.
    for integrator in ["velocity-verlet", "symplectic-euler"] {
        let coarse = warnings(&collision(integrator, 0.9));
        assert!(
            coarse.len() == 1 && coarse[0].contains("balance"),
            "{coarse:?}"
        );
        assert_eq!(
            warnings(&collision(integrator, 0.01)),
            Vec::<String>::new(),
            "{integrator}"
        );
        let unstable = warnings(&collision(integrator, 1.1));
        assert!(unstable[0].contains("stability bound"), "{unstable:?}");
        let unwatched = warnings(&collision(integrator, 0.9).with("output.energy", false));
        assert_eq!(unwatched, Vec::<String>::new());
    }
}

#[test]
fn scenes_in_which_nothing_happens_are_doubted() {
    let base = || Draft::open_box(Integrator::VelocityVerlet, 1e-6).ending_at(1e-5);
    let grain = |x: f64| Grain::at([x, 0.0], 1e-3);
    let cases = [
        (base().grain(grain(0.0).driven()), "no [driving]"),
        (base().grain(grain(0.0).fixed()), "nothing can move"),
        (base().grain(grain(1e7)), "move the origin"),
        (
            base().grain(grain(0.0)).grain(grain(-0.0)),
            "at the same place",
        ),
    ];
    for (draft, words) in cases {
        let found = warnings(&draft);
        assert!(found.len() == 1 && found[0].contains(words), "{found:?}");
    }
    assert_eq!(warnings(&base().grain(grain(1.0))), Vec::<String>::new());
    let lattice = |rows: i64, clip: bool| {
        base()
            .law(KelvinVoigt {
                stiffness: 1e6,
                damping: 1.0,
            })
            .with("box.width", 0.02)
            .with("box.height", 0.01)
            .with("setup.seed", 1)
            .with("setup.clip", clip)
            .with("setup.sizes.mean", 1e-3)
            .with("setup.lattice.rows", rows)
    };
    assert_eq!(warnings(&lattice(3, true)), Vec::<String>::new());
    assert!(warnings(&lattice(30, true))[0].contains("above box.height"));
    let bonded = lattice(3, false)
        .law(gouge_dem::laws::AdjustedKelvinVoigt {
            stiffness: 1e6,
            damping: 1.0,
        })
        .with("setup.lattice.pitch", 5e-3)
        .with_table("setup.bonding");
    let found = warnings(&bonded);
    assert!(
        found.iter().any(|text| text.contains("bonds nothing")),
        "{found:?}"
    );
}
