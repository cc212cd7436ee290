//! A world that Python steps.

use crate::errors::{bad_argument, raised};
use crate::tables::{columns, numbers, pairs};
use crate::values::scene_of;
use gouge::World;
use gouge::common::geometry::Vec2;
use gouge::estimators::{friction_feedback, friction_load};
use gouge::forces::InteractionKind;
use gouge::particles::{Particles, Role};
use gouge::runner::run::{advance, begin_phase, draw_picture, phases, table_of_links};
use gouge::runner::scene::{Scene, role_name};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use sha2::{Digest, Sha256};

/// Particle-steps between looks for signals: some ten milliseconds.
const BETWEEN_LOOKS: u64 = 500_000;
/// Length of the hash before a state in bytes.
const HASH: usize = 32;

/// A scene that is stepped from Python, from t = 0 on. Its set-up is run first.
#[pyclass(subclass, module = "gouge._gouge")]
pub struct Simulation {
    scene: Scene,
    world: World,
    /// The process whose threads step the world.
    process: u32,
}

#[pymethods]
impl Simulation {
    #[new]
    #[pyo3(signature = (scene, overrides = None))]
    fn new(
        py: Python<'_>,
        scene: &Bound<'_, PyAny>,
        overrides: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let scene = scene_of(scene, overrides)?.dem("Simulation");
        let scene = scene.map_err(|error| raised(&error))?;
        let phases = phases(&scene);
        let begin = |index, before| begin_phase(&scene, &phases, index, before);
        let mut world = py
            .detach(|| begin(0, None))
            .map_err(|error| raised(&error))?;
        for (index, phase) in phases.iter().enumerate().take(phases.len() - 1) {
            step(py, &mut world, phase.steps, &phase.name)?;
            world = py
                .detach(|| begin(index + 1, Some(world)))
                .map_err(|error| raised(&error))?;
        }
        Ok(Self {
            scene,
            world,
            process: std::process::id(),
        })
    }

    /// Advance by n steps. Other threads go on meanwhile, and Ctrl-C stops between two steps.
    ///
    /// Raises StateError if the state becomes invalid, and ArgumentError if n is negative.
    #[pyo3(signature = (n = 1))]
    fn step(&mut self, py: Python<'_>, n: i64) -> PyResult<()> {
        let number = u64::try_from(n);
        let number = number.map_err(|_| bad_argument(&format!("n = {n}: must not be negative")))?;
        self.adapt_to_process();
        step(py, &mut self.world, number, "run")
    }

    /// Time in s.
    #[getter]
    fn time(&self) -> f64 {
        self.world.time()
    }
    /// Number of steps since t = 0.
    #[getter]
    fn steps(&self) -> u64 {
        self.world.steps()
    }
    /// The time step in s.
    #[getter]
    fn time_step(&self) -> f64 {
        self.scene.step
    }
    /// Time in s at which a run of the scene ends; steps may go on beyond it.
    #[getter]
    fn end(&self) -> f64 {
        self.scene.end
    }
    fn __len__(&self) -> usize {
        self.world.particles().len()
    }

    /// A column of particle data, see Particles.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let p: &Particles = self.world.particles();
        let vectors = |column: &[Vec2]| pairs(py, column.iter().map(|v| [v.x, v.y]));
        match name {
            "position" => vectors(&p.position),
            "velocity" => vectors(&p.velocity),
            "force" => vectors(&self.world.forces().force),
            "torque" => Ok(numbers(py, self.world.forces().torque.clone())),
            "angle" => Ok(numbers(py, p.angle.clone())),
            "angular_velocity" => Ok(numbers(py, p.angular_velocity.clone())),
            "radius" => Ok(numbers(py, p.radius.clone())),
            "mass" => Ok(numbers(py, p.mass.clone())),
            "moment_of_inertia" => Ok(numbers(py, p.moment_of_inertia.clone())),
            _ => Err(bad_argument(&format!("{name}: no column of particles"))),
        }
    }

    /// Names of roles, and for each particle the place of its role among them.
    fn roles<'py>(&self, py: Python<'py>) -> (Vec<&'static str>, Bound<'py, PyArray1<u8>>) {
        let names = [Role::Free, Role::Driven, Role::Fixed].map(role_name);
        let codes = self.world.particles().role.iter().map(|&role| role as u8);
        (names.to_vec(), PyArray1::from_vec(py, codes.collect()))
    }

    /// Columns of all interactions of a kind, "contact" or "bond", or of "all".
    fn interactions<'py>(&self, py: Python<'py>, kind: &str) -> PyResult<Bound<'py, PyDict>> {
        let mut links = py.detach(|| self.world.interactions());
        match kind {
            "contact" => links.retain(|link| link.kind == InteractionKind::Contact),
            "bond" => links.retain(|link| link.kind == InteractionKind::Bond),
            "all" => {}
            _ => {
                return Err(bad_argument(&format!(
                    "kind = {kind}: must be contact, bond or all"
                )));
            }
        }
        links.sort_by_key(|link| link.pair.indices());
        columns(py, table_of_links(&links))
    }

    /// Terms of the energy balance in J; heat, work and residual are zero if the scene does not keep them.
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let energy = py.detach(|| self.world.energy());
        let dict = PyDict::new(py);
        for (name, value) in gouge::estimators::Energy::<f64>::NAMES
            .iter()
            .zip(energy.values())
        {
            dict.set_item(name, value)?;
        }
        Ok(dict)
    }

    /// Coefficients of friction of the driven grains: "load", from the driving force, and "feedback", from the reaction to
    /// it; NaN without a driven grain.
    fn friction<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (drive, dict) = (self.world.drive(), PyDict::new(py));
        dict.set_item("load", friction_load(drive))?;
        dict.set_item("feedback", friction_feedback(drive))?;
        Ok(dict)
    }

    /// The whole state, for restore.
    fn checkpoint<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let words = self.world.to_words();
        let words: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let bytes = [&self.hash(&words)[..], &words].concat();
        PyBytes::new(py, &bytes)
    }

    /// Return to a state of the same scene that checkpoint gave; later steps have the same bits.
    ///
    /// Raises ArgumentError for a state of another scene, or for damaged bytes.
    fn restore(&mut self, bytes: &[u8]) -> PyResult<()> {
        let refusal = |reason: &str| bad_argument(&format!("checkpoint: {reason}"));
        let (hash, rest) = bytes
            .split_at_checked(HASH)
            .ok_or_else(|| refusal("too short"))?;
        if hash != self.hash(rest) {
            return Err(refusal("it belongs to another scene, or is damaged"));
        }
        let (words, rest) = rest.as_chunks();
        let words: Vec<u64> = words.iter().map(|&word| u64::from_le_bytes(word)).collect();
        let world = World::from_words(*self.world.model(), &words).filter(|_| rest.is_empty());
        let world = world.ok_or_else(|| refusal("it is damaged"))?;
        self.world = gouge::runner::machine::with_chosen_execution(world);
        Ok(())
    }

    /// The present state as SVG.
    fn picture(&self) -> String {
        draw_picture(&self.scene, &self.world).to_string()
    }
}

impl Simulation {
    /// Hash of the words of a state and of their scene.
    fn hash(&self, words: &[u8]) -> [u8; HASH] {
        Sha256::new_with_prefix(&self.scene.sha256)
            .chain_update(words)
            .finalize()
            .into()
    }

    /// Use one thread only in a copy of the process: it has no others.
    fn adapt_to_process(&mut self) {
        let process = std::process::id();
        if self.process != process {
            self.world = self.world.clone().with_threads(1);
            self.process = process;
        }
    }
}

/// Advance a world without the interpreter's lock, and look for signals now and then.
fn step(py: Python<'_>, world: &mut World, number: u64, phase: &str) -> PyResult<()> {
    let most = BETWEEN_LOOKS / (world.particles().len() as u64 + 1) + 1;
    let mut left = number;
    while left > 0 {
        let now = left.min(most);
        py.detach(|| advance(world, now, phase))
            .map_err(|error| raised(&error))?;
        left -= now;
        if left > 0 {
            py.check_signals()?;
        }
    }
    Ok(())
}
