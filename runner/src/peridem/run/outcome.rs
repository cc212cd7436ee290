//! The outputs at the end of a run.

use super::balance::Balance;
use super::samples::{columns, crack};
use super::scene_run::SceneRun;
use super::stability::summarized;
use super::tables;
use super::{page, picture};
use crate::error::Error;
use crate::run::context::Sampled;
use crate::run::folder::{BONDS, GRAINS, NODES, PICTURE, write_whole};
use crate::run::{Summary, UNTRUSTED, Warning};
use gouge_peridem::observables::{bulk_damage, softened_area};
use gouge_peridem::world::World;
use serde_json::{Map, Value, json};

/// Largest residual of the balance of energy in parts of the energy exchanged: that of a step near its limit.
const TRUSTED: f64 = 0.05;

impl SceneRun<'_> {
    /// Run all remaining steps, write the final outputs, and return the summary.
    ///
    /// # Errors
    /// What ended the run, or a failure of the file system.
    pub fn complete(mut self) -> Result<Summary, Error> {
        self.context.clock.begin_main();
        let failure = Summary::early_end(self.run_to_end())?;
        if failure.as_ref().is_none_or(Error::is_interruption) {
            self.write_checkpoint()?;
        }
        let status = match &failure {
            None => self.judge(),
            Some(error) => Summary::failed(error),
        };
        self.context.report_end();
        let pieces = self.pieces.count(&self.world);
        let summary = self.summary(status, &pieces);
        self.context.lock.check()?;
        let write =
            |name, text: String| write_whole(&self.context.folder.join(name), text.as_bytes());
        write(NODES, tables::nodes(&self.world).to_csv())?;
        write(GRAINS, tables::grains(&self.world, &pieces).to_csv())?;
        if self.scene.output.bonds {
            write(BONDS, tables::bonds(&self.world).to_csv())?;
        }
        let picture = picture::draw(self.scene, &self.world, &self.cells);
        write(PICTURE, picture.to_string())?;
        if !self.context.options.data_only {
            let content = (&self.world, picture.to_string());
            page::write(&self.context.folder, self.scene, content, &summary)?;
        }
        summary.write(&self.context.folder)?;
        failure.map_or(Ok(summary), Err)
    }

    /// The status of a finished run, with warnings of what is doubtful.
    fn judge(&mut self) -> String {
        let lost = behind_walls(&self.world);
        if lost > 0 {
            self.context.warn(Warning::BehindWalls(lost));
        }
        let error = self.balance.error();
        let is_off = self.scene.output.energy && error.is_nan() | (error > TRUSTED);
        if is_off {
            self.context.warn(Warning::Residual(error));
        }
        let gain = self.balance.gain();
        let has_gained = self.scene.output.energy && gain > TRUSTED;
        if has_gained {
            self.context.warn(Warning::Gained(gain));
        }
        match is_off || has_gained || lost > 0 {
            true => UNTRUSTED.to_owned(),
            false => Summary::DONE.to_owned(),
        }
    }

    fn summary(&self, status: String, pieces: &[usize]) -> Summary {
        let (scene, world) = (self.scene, &self.world);
        let [wall_seconds, stepping] = self.context.seconds();
        let rate = |amount: f64| match stepping > 0.0 {
            true => amount / stepping,
            false => 0.0,
        };
        let (nodes, steps) = (world.grains().nodes(), world.state().steps);
        let bonds = world.bonds().count();
        let columns = columns(scene).into_iter().map(str::to_owned);
        Summary {
            steps,
            time: world.time(),
            particles: nodes,
            bonds_initial: self.intact,
            bonds_broken: self.intact - bonds,
            wall_seconds,
            particle_steps_per_second: rate(nodes as f64 * steps as f64),
            link_steps_per_second: rate(self.bond_steps),
            energy: scene.output.energy.then(|| energies(&self.balance, world)),
            series_columns: columns.collect(),
            warnings: self.context.warnings.lines().map(str::to_owned).collect(),
            balance_error: scene.output.energy.then(|| self.balance.error()),
            peridem: Some(self.observations(pieces)),
            ..Summary::empty(&scene.sha256, scene.output.energy, status)
        }
    }

    /// What the summary says of this model only.
    fn observations(&self, pieces: &[usize]) -> Map<String, Value> {
        let (grains, bonds) = (self.world.grains(), self.world.bonds());
        let softened = (0..grains.rows.len()).map(|grain| softened_area(grains, bonds, grain));
        let cracks = self.scene.cracks.iter().map(|table| {
            crack(&self.world, table).map(|crack| {
                json!({ "angle": crack.angle, "length": crack.length, "nodes": crack.nodes })
            })
        });
        let all = [
            ("mode", json!(self.scene.mode.name())),
            ("grains", json!(grains.rows.len())),
            ("pieces", json!(pieces.iter().sum::<usize>())),
            ("bulk_damage", json!(bulk_damage(grains, bonds))),
            ("softened_area", json!(softened.sum::<f64>())),
            ("cracks", json!(cracks.collect::<Vec<_>>())),
            ("largest_depth_behind_walls", json!(deepest(&self.world))),
            ("limits", Value::Object(summarized(&self.limits))),
            (
                "step_over_smallest_limit",
                json!(self.scene.step / self.limits.smallest().1),
            ),
        ];
        all.map(|(name, value)| (name.to_owned(), value))
            .into_iter()
            .collect()
    }
}

fn energies(balance: &Balance, world: &World) -> Map<String, Value> {
    let terms = balance.terms(world).into_iter();
    terms
        .map(|(name, energy)| (name.to_owned(), energy.into()))
        .collect()
}

/// How far in m each node is behind a wall; negative for nodes between all walls.
fn depths(world: &World) -> impl Iterator<Item = f64> + '_ {
    let [left, right, top, bottom] = world.state().walls;
    world.state().places.iter().map(move |place| {
        let p = place.position();
        let depths = [left - p.x, p.x - right, p.y - top, bottom - p.y];
        depths.into_iter().fold(f64::NEG_INFINITY, f64::max)
    })
}

/// The largest depth in m of a node behind a wall; zero if none is.
fn deepest(world: &World) -> f64 {
    depths(world).fold(0.0, f64::max)
}

/// Number of nodes that walls have lost: farther behind them than the contact radius.
fn behind_walls(world: &World) -> usize {
    let walls = world.settings().walls.as_ref();
    let radius = walls.map_or(f64::INFINITY, |walls| walls.law.radius);
    depths(world).filter(|&depth| depth > radius).count()
}
