//! Running a scene: phases, samples, checkpoints, outputs.

mod checkpoint;
mod output;
mod picture;
mod plan;
mod progress;
mod trajectory;

pub use checkpoint::{recorded, words_of, write_whole};
pub use picture::document;
pub use plan::{Kind, Phase, advance, enter, phases, prepared};
pub use trajectory::write_frame;

use crate::error::Error;
use crate::scene::Scene;
use checkpoint::Checkpoint;
use gouge_dem::{Drive, World};
use output::{Series, Summary};
use progress::Progress;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Steps between looks at the clock.
const CHUNK: u64 = 256;
/// How a run is done, apart from what the scene says.
#[derive(Clone, Copy, Debug)]
pub struct Manner {
    /// Whether to continue a run that was stopped.
    pub resume: bool,
    /// Whether to show no progress.
    pub quiet: bool,
    /// Wall time between checkpoints in s; there is one at the beginning of each phase anyway.
    pub checkpoint_interval: f64,
}

/// A scene on its way.
struct Run<'a> {
    scene: &'a Scene,
    manner: Manner,
    folder: PathBuf,
    fingerprint: [u8; 32],
    phases: Vec<Phase>,
    phase: usize,
    world: World,
    series: Option<Series>,
    samples: u64,
    bonds_initial: usize,
    link_steps: f64,
    earlier: [f64; 2],
    began: Instant,
    main_began: Instant,
    saved: Instant,
    good: World,
    progress: Progress,
}

/// Run a scene and write its outputs into a folder.
///
/// # Errors
/// Folders that cannot be written, checkpoints that do not fit, states that become senseless. What
/// was written before stays.
pub fn run(scene: &Scene, folder: &Path, manner: Manner) -> Result<(), Error> {
    spare_inputs(scene, folder)?;
    std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
    let path = folder.join("checkpoint");
    let is_unfinished = path.exists() && !folder.join("summary.json").exists();
    if is_unfinished && !manner.resume {
        return Err(Error::Argument(format!(
            "{} holds an unfinished run: continue it with --resume, or remove it first",
            folder.display()
        )));
    }
    let mut run = if manner.resume && path.exists() {
        Run::resume(scene, folder, manner)?
    } else {
        Run::begin(scene, folder, manner)?
    };
    match run.go() {
        Ok(()) => run.finish("done"),
        Err(error) => {
            if error.is_of_state() {
                run.world = run.good.clone();
                run.finish(&format!("failed: {error}"))?;
            }
            Err(error)
        }
    }
}

impl<'a> Run<'a> {
    fn begin(scene: &'a Scene, folder: &Path, manner: Manner) -> Result<Self, Error> {
        let phases = phases(scene);
        let world = enter(scene, &phases, 0, None)?;
        remove_outputs(folder)?;
        let mut run = Self::new(scene, folder, manner, phases, 0, world);
        run.enter_main()?;
        run.save()?;
        Ok(run)
    }

    fn resume(scene: &'a Scene, folder: &Path, manner: Manner) -> Result<Self, Error> {
        let path = folder.join("checkpoint");
        let saved = Checkpoint::read(&path, &checkpoint::fingerprint(scene))?;
        let phases = phases(scene);
        let phase = (saved.phase as usize).min(phases.len() - 1);
        let world = saved.world(&path, scene, phases[phase].kind)?;
        let mut run = Self::new(scene, folder, manner, phases, phase, world);
        run.samples = saved.samples;
        run.bonds_initial = saved.bonds_initial as usize;
        run.link_steps = saved.link_steps;
        run.earlier = saved.seconds;
        if run.is_main() {
            run.series = Some(Series::open(scene, folder, Some(saved.series_bytes))?);
        }
        let _ = std::fs::remove_file(folder.join("summary.json"));
        Ok(run)
    }

    fn new(
        scene: &'a Scene,
        folder: &Path,
        manner: Manner,
        phases: Vec<Phase>,
        phase: usize,
        world: World,
    ) -> Self {
        let now = Instant::now();
        Self {
            scene,
            manner,
            folder: folder.to_owned(),
            fingerprint: checkpoint::fingerprint(scene),
            progress: Progress::new(&phases, manner.quiet),
            phases,
            phase,
            good: world.clone(),
            world,
            series: None,
            samples: 0,
            bonds_initial: 0,
            link_steps: 0.0,
            earlier: [0.0; 2],
            began: now,
            main_began: now,
            saved: now,
        }
    }

    fn is_main(&self) -> bool {
        self.phase + 1 == self.phases.len()
    }

    /// All phases from the present one.
    fn go(&mut self) -> Result<(), Error> {
        while !self.is_main() {
            self.advance_to(self.phases[self.phase].steps)?;
            self.next_phase()?;
        }
        self.main_began = Instant::now();
        let last = self.phases[self.phase].steps;
        loop {
            let due = self.sample_step(self.samples).min(last);
            self.advance_to(due)?;
            // The last step is a sample too, once.
            let is_extra =
                due == last && self.samples > 0 && self.sample_step(self.samples - 1) >= last;
            if !is_extra {
                self.sample()?;
            }
            if due == last {
                return Ok(());
            }
        }
    }

    fn next_phase(&mut self) -> Result<(), Error> {
        self.good = self.world.clone();
        let before = Some(self.world.clone());
        self.world = enter(self.scene, &self.phases, self.phase + 1, before)?;
        self.phase += 1;
        self.good = self.world.clone();
        self.enter_main()?;
        self.save()
    }

    /// Begin the series if the scene proper begins.
    fn enter_main(&mut self) -> Result<(), Error> {
        if self.is_main() {
            self.bonds_initial = bonds(&self.world);
            self.series = Some(Series::open(self.scene, &self.folder, None)?);
            self.warn_of_step();
        }
        Ok(())
    }

    /// Say so, where the time step may be too large.
    fn warn_of_step(&self) {
        let estimate = gouge_dem::stable_step_estimate(&self.world);
        if self.scene.step > estimate && !self.manner.quiet {
            eprintln!(
                "gouge: warning: {}: time.step = {:?}: above the estimated stability bound, \
                 {estimate:.3e} s (run `gouge stability` for the bounds)",
                self.scene.file, self.scene.step
            );
        }
    }

    /// Step at which a sample is due.
    fn sample_step(&self, sample: u64) -> u64 {
        let exact = sample as f64 * self.scene.output.interval / self.scene.step;
        (exact.round() as u64).max(sample)
    }

    fn advance_to(&mut self, last: u64) -> Result<(), Error> {
        while self.world.steps() < last {
            let until = last.min(self.world.steps() + CHUNK);
            while self.world.steps() < until {
                if let Err(source) = self.world.step() {
                    return Err(self.step_error(source));
                }
            }
            self.progress.show(self.phase, self.world.steps());
            if self.saved.elapsed().as_secs_f64() > self.manner.checkpoint_interval {
                self.world
                    .check()
                    .map_err(|source| self.step_error(source))?;
                self.good = self.world.clone();
                self.save()?;
            }
        }
        Ok(())
    }

    fn step_error(&self, source: gouge_dem::StepError) -> Error {
        Error::Step {
            phase: self.phases[self.phase].name.clone(),
            source,
        }
    }

    /// Write down the present state.
    fn sample(&mut self) -> Result<(), Error> {
        let refreshed = self
            .world
            .refresh_neighbors()
            .and_then(|()| self.world.check());
        refreshed.map_err(|source| self.step_error(source))?;
        let drive = self.present_drive()?;
        if let Some(name) = output::infinite_energy(self.scene, &self.world) {
            return Err(Error::Energy {
                phase: self.phases[self.phase].name.clone(),
                name,
                time: self.world.time(),
            });
        }
        self.good = self.world.clone();
        if let Some(series) = &mut self.series {
            series.sample(self.scene, &self.world, &drive)?;
        }
        trajectory::write_frame(self.scene, &self.folder, self.samples, &self.world)?;
        let steps = self
            .sample_step(self.samples + 1)
            .min(self.phases[self.phase].steps);
        let links = bonds(&self.world) + self.world.number_of_contacts();
        self.link_steps += links as f64 * steps.saturating_sub(self.world.steps()) as f64;
        self.samples += 1;
        Ok(())
    }

    /// The driving force and the reaction to it in the present state. What the next step will do first,
    /// evaluate the forces and break bonds, is done in a copy.
    fn present_drive(&self) -> Result<Drive<f64>, Error> {
        if self.scene.driving.is_none() {
            return Ok(*self.world.drive());
        }
        let mut ahead = self.world.clone();
        ahead
            .evaluate_if_pending()
            .map_err(|source| self.step_error(source))?;
        Ok(*ahead.drive())
    }

    fn seconds(&self) -> [f64; 2] {
        let main = if self.is_main() {
            self.main_began.elapsed().as_secs_f64()
        } else {
            0.0
        };
        [
            self.earlier[0] + self.began.elapsed().as_secs_f64(),
            self.earlier[1] + main,
        ]
    }

    fn save(&mut self) -> Result<(), Error> {
        // The checkpoint must not know of samples that a power failure may take back.
        if let Some(series) = &self.series {
            series.sync()?;
        }
        let checkpoint = Checkpoint {
            phase: self.phase as u64,
            samples: self.samples,
            series_bytes: self.series.as_ref().map_or(0, Series::bytes),
            bonds_initial: self.bonds_initial as u64,
            seconds: self.seconds(),
            link_steps: self.link_steps,
            world: self.world.to_words(),
        };
        checkpoint.write(&self.folder.join("checkpoint"), &self.fingerprint)?;
        self.saved = Instant::now();
        Ok(())
    }

    /// Write what a finished or failed run leaves.
    fn finish(&mut self, status: &str) -> Result<(), Error> {
        self.progress.finish();
        let [wall, main] = self.seconds();
        if status == "done" {
            self.save()?;
        }
        output::write_particles(&self.folder, self.world.particles())?;
        picture::write(&self.folder, self.scene, &self.world)?;
        let steps = if self.is_main() {
            self.world.steps()
        } else {
            0
        };
        let number = self.world.particles().len();
        let rate = |amount: f64| if main > 0.0 { amount / main } else { 0.0 };
        let summary = Summary {
            status: status.to_owned(),
            steps,
            time: if self.is_main() {
                self.world.time()
            } else {
                0.0
            },
            particles: number,
            bonds_initial: self.bonds_initial,
            bonds_broken: self.bonds_initial.saturating_sub(bonds(&self.world)),
            wall_seconds: wall,
            particle_steps_per_second: rate(number as f64 * steps as f64),
            link_steps_per_second: rate(self.link_steps),
            version: env!("CARGO_PKG_VERSION"),
            scene_sha256: self.scene.sha256.clone(),
            energy: self
                .scene
                .output
                .energy
                .then(|| output::energies(&self.world)),
            series_columns: output::columns(self.scene),
            neighbor_rebuilds: self.world.rebuilds(),
        };
        output::write_summary(&self.folder, &summary)
    }
}

fn bonds(world: &World) -> usize {
    world.bonds().map_or(0, |strong| strong.len())
}

/// The files of a run, in the order in which a new run removes them: what remains if it is stopped
/// there is still a finished run, or none.
const FILES: [&str; 5] = [
    "checkpoint",
    "summary.json",
    "series.csv",
    "particles.csv",
    "picture.svg",
];

/// Refuse a folder in which the outputs would replace what the scene reads.
fn spare_inputs(scene: &Scene, folder: &Path) -> Result<(), Error> {
    for name in FILES {
        let output = folder.join(name);
        let Ok(place) = output.canonicalize() else {
            continue;
        };
        let is_it = |file: &&PathBuf| file.canonicalize().is_ok_and(|file| file == place);
        if let Some(file) = scene.files.iter().find(is_it) {
            return Err(Error::Argument(format!(
                "the run would replace {}, which the scene reads: choose another folder than {}",
                file.display(),
                folder.display()
            )));
        }
    }
    Ok(())
}

/// Remove what an earlier, finished run left, so that no mixture remains.
fn remove_outputs(folder: &Path) -> Result<(), Error> {
    for name in FILES {
        let path = folder.join(name);
        if path.exists() {
            std::fs::remove_file(&path).map_err(|error| Error::file("replace", &path, error))?;
        }
    }
    trajectory::remove_frames(folder)
}
