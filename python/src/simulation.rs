//! A world that Python steps.

use crate::errors::{bad_argument, raised};
use crate::tables::{columns, numbers, pairs};
use crate::values::scene_of;
use gouge::World;
use gouge::common::geometry::Vec2;
use gouge::estimators::{friction_feedback, friction_load};
use gouge::forces::InteractionKind;
use gouge::particles::Particles;
use gouge::runner::error::Error;
use gouge::runner::run::{advance, begin_phase, draw_picture, phases, table_of_links};
use gouge::runner::scene::{Scene, role_name};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

/// Particle-steps between looks for signals: some ten milliseconds.
const BETWEEN_LOOKS: u64 = 500_000;
/// Length of the fingerprint of a scene in bytes.
const FINGERPRINT: usize = 64;

/// A scene that is stepped from Python, from t = 0 on. Its set-up is run first.
#[pyclass(subclass, module = "gouge._gouge")]
pub struct Simulation {
    scene: Scene,
    world: World,
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
        let scene = scene_of(scene, overrides)?;
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
        Ok(Self { scene, world })
    }

    /// Advance by n steps.
    #[pyo3(signature = (n = 1))]
    fn step(&mut self, py: Python<'_>, n: u64) -> PyResult<()> {
        step(py, &mut self.world, n, "run")
    }

    #[getter]
    fn time(&self) -> f64 {
        self.world.time()
    }
    #[getter]
    fn steps(&self) -> u64 {
        self.world.steps()
    }
    #[getter]
    fn time_step(&self) -> f64 {
        self.scene.step
    }
    #[getter]
    fn end(&self) -> f64 {
        self.scene.end
    }
    fn __len__(&self) -> usize {
        self.world.particles().len()
    }

    /// A column of particle data.
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

    /// The roles of the particles.
    fn roles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let roles = self.world.particles().role.iter();
        PyList::new(py, roles.map(|&role| role_name(role)).collect::<Vec<_>>())
    }

    /// Contacts, bonds or both as columns.
    fn interactions<'py>(&self, py: Python<'py>, kind: &str) -> PyResult<Bound<'py, PyDict>> {
        let mut links = py.detach(|| self.world.interactions());
        match kind {
            "contact" => links.retain(|link| link.kind == InteractionKind::Contact),
            "bond" => links.retain(|link| link.kind == InteractionKind::Bond),
            _ => {}
        }
        links.sort_by_key(|link| link.pair.indices());
        columns(py, table_of_links(&links))
    }

    /// Terms of the energy balance in J.
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

    /// Coefficients of friction of the driven grains, from the driving force and from the reaction to it.
    fn friction(&self) -> (f64, f64) {
        let drive = self.world.drive();
        (friction_load(drive), friction_feedback(drive))
    }

    /// The state as bytes.
    fn checkpoint<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        let words = self.world.to_words();
        let words = words.iter().flat_map(|word| word.to_le_bytes());
        let bytes: Vec<u8> = self.fingerprint().bytes().chain(words).collect();
        PyBytes::new(py, &bytes)
    }

    /// Return to a state that `checkpoint` gave.
    fn restore(&mut self, bytes: &[u8]) -> PyResult<()> {
        let refusal = |reason: &str| raised(&Error::Argument(format!("checkpoint: {reason}")));
        let (fingerprint, rest) = bytes
            .split_at_checked(FINGERPRINT)
            .ok_or_else(|| refusal("too short"))?;
        if fingerprint != self.fingerprint().as_bytes() {
            return Err(refusal("it belongs to another scene, or is none"));
        }
        let (words, rest) = rest.as_chunks();
        let words: Vec<u64> = words.iter().map(|&word| u64::from_le_bytes(word)).collect();
        let world = World::from_words(*self.world.model(), &words).filter(|_| rest.is_empty());
        let world = world.ok_or_else(|| refusal("it is damaged"))?;
        self.world = gouge::runner::machine::with_chosen_execution(world);
        Ok(())
    }

    /// The present state as an SVG picture.
    fn picture(&self) -> String {
        draw_picture(&self.scene, &self.world).to_string()
    }
}

impl Simulation {
    /// What a checkpoint must agree with: the scene with all its keys.
    fn fingerprint(&self) -> &str {
        &self.scene.sha256
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
