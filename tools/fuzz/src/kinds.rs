//! The kinds of files, valid ones of each, and how they are read.

use crate::Outcome;
use crate::damage::damaged;
use clap::ValueEnum;
use gouge_runner::compare;
use gouge_runner::run::{Event, RunOptions, run, world_of_checkpoint};
use gouge_runner::scene::{Scene, builtin};
use rand::RngExt;
use rand_pcg::Pcg64;
use sha2::{Digest, Sha256};
use std::path::Path;

/// Bytes of the checksum at the end of a checkpoint.
const DIGEST: usize = 32;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Scene files.
    Scene,
    /// Particles, bonds and contacts in CSV files.
    Csv,
    /// Checkpoints, most of them with a correct checksum.
    Checkpoint,
    /// LAMMPS dumps and CSV files for comparisons.
    Data,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Scene, Self::Csv, Self::Checkpoint, Self::Data];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Csv => "csv",
            Self::Checkpoint => "checkpoint",
            Self::Data => "data",
        }
    }
}

/// A scene with every kind of interaction and list.
const FULL: &str = include_str!("full.toml");
/// Scenes whose lists are in CSV files, with the key that the damaged file belongs to.
const LISTS: [(&str, &str); 3] = [
    (
        "particles",
        "x,y,radius,vx,vy,angle,angular_velocity,density,role\n0.0,0.0,1e-3,0.1,0.0,0.0,0.0,2700,free\n1.9e-3,0.0,1e-3,0.0,0.0,0.0,5.0,2700.0,fixed\n",
    ),
    (
        "bonds",
        "i,j,strength_factor,initial_distance,initial_angle_i,initial_angle_j\n0,1,1.0,2e-3,0.0,0.0\n1,2,0.9,2e-3,0.1,-0.1\n",
    ),
    (
        "contacts",
        "i,j,initial_angle_i,initial_angle_j\n0,2,0.0,0.0\n0,1,0.1,-0.1\n",
    ),
];
/// Data for comparisons.
const DATA: [&str; 3] = [
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 1\n0 1\n0 1\nITEM: ATOMS id type x y vx vy\n1 1 0.0 0.0 1.0 0.0\n2 1 1.0 0.0 -1.0 0.0\nITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id type x y vx vy\n2 1 1.0 0.0 -1.0 0.0\n1 1 0.0 0.0 1.0 0.0\n",
    "time,id,x,y,vy\n0.0,0,0.0,1.0,2.0\n0.0,1,3.0,4.0,5.0\n1e-6,0,0.0,1.0,2.0\n",
    "time,kinetic,driving\n0.0,1.0,0.0\n1e-6,1.5,0.5\n",
];

/// Valid files of a kind, and a folder for damaged ones.
pub struct Files {
    kind: Kind,
    valid: Vec<Vec<u8>>,
    /// For checkpoints: their scenes.
    scenes: Vec<Scene>,
    folder: tempfile::TempDir,
}

impl Files {
    /// The files of a kind.
    ///
    /// # Errors
    /// Failures of the file system; files that are not valid.
    pub fn of(kind: Kind) -> Outcome<Self> {
        let mut files = Self {
            kind,
            valid: Vec::new(),
            scenes: Vec::new(),
            // Files that never reach a disk are written much faster.
            folder: tempfile::tempdir_in("/dev/shm").or_else(|_| tempfile::tempdir())?,
        };
        match kind {
            Kind::Scene => {
                let texts = builtin::SCENES.iter().map(|(_, _, text)| *text);
                files.valid = texts
                    .chain([FULL])
                    .map(|text| text.as_bytes().to_vec())
                    .collect();
            }
            Kind::Csv => files.valid = LISTS.map(|(_, text)| text.as_bytes().to_vec()).to_vec(),
            Kind::Data => files.valid = DATA.map(|text| text.as_bytes().to_vec()).to_vec(),
            Kind::Checkpoint => files.make_checkpoints()?,
        }
        Ok(files)
    }

    fn make_checkpoints(&mut self) -> Outcome<()> {
        for integrator in ["velocity-verlet", "beeman"] {
            let text = FULL.replace("velocity-verlet", integrator);
            let scene = Scene::parse("scene.toml", text.as_bytes(), Path::new("."))?;
            let out = self.folder.path().join(integrator);
            let options = RunOptions {
                resume: false,
                overwrite: false,
                data_only: false,
                checkpoint_interval: f64::INFINITY,
            };
            run(&scene, &out, options, &mut |_: Event<'_>| {})?;
            self.valid.push(std::fs::read(out.join("checkpoint"))?);
            self.scenes.push(scene);
        }
        Ok(())
    }

    /// The file with which a case begins, and its random numbers.
    fn origin(&self, seed: u64, number: u64) -> (usize, Pcg64) {
        let mut random = Pcg64::new(u128::from(seed), u128::from(number));
        (random.random_range(0..self.valid.len()), random)
    }

    /// The damaged file of a case.
    pub fn case(&self, seed: u64, number: u64) -> Vec<u8> {
        let (which, mut random) = self.origin(seed, number);
        let is_text = self.kind != Kind::Checkpoint;
        let file = &self.valid[which];
        if is_text {
            return damaged(file, &self.valid, true, &mut random);
        }
        let content = &file[..file.len() - DIGEST];
        let mut bytes = damaged(content, &self.valid, false, &mut random);
        match random.random_range(0..8) {
            0 => bytes.extend(&file[file.len() - DIGEST..]),
            _ => {
                let digest = Sha256::digest(&bytes);
                bytes.extend(digest);
            }
        }
        bytes
    }

    /// Read a file like the program does.
    pub fn read(&self, bytes: &[u8]) {
        match self.kind {
            Kind::Scene => {
                let _ = Scene::parse("scene.toml", bytes, self.folder.path());
            }
            Kind::Csv => LISTS
                .iter()
                .for_each(|(list, _)| self.read_list(list, bytes)),
            Kind::Checkpoint => self.scenes.iter().for_each(|scene| {
                if let Ok(world) = world_of_checkpoint(bytes, scene) {
                    let _ = world.check();
                }
            }),
            Kind::Data => self.read_data(bytes),
        }
    }

    fn read_list(&self, list: &str, bytes: &[u8]) {
        let name = format!("{list}.csv");
        if std::fs::write(self.folder.path().join(&name), bytes).is_err() {
            return;
        }
        let header = format!("{list}_file = {name:?}\n");
        let array = format!("[[{list}]]");
        let rest: Vec<&str> = FULL
            .split("\n\n")
            .filter(|part| !part.starts_with(&array))
            .collect();
        let text = header + &rest.join("\n\n");
        let _ = Scene::parse("scene.toml", text.as_bytes(), self.folder.path());
    }

    fn read_data(&self, bytes: &[u8]) {
        let path = self.folder.path().join("data");
        if std::fs::write(&path, bytes).is_err() {
            return;
        }
        let Ok(data) = compare::read(&path) else {
            return;
        };
        let Ok(scene) = Scene::load("head-on") else {
            return;
        };
        let options = compare::Options {
            step: None,
            tolerance: 1.0,
            tolerances: Vec::new(),
            absolute: Vec::new(),
            columns: Vec::new(),
        };
        let short = Scene {
            end: 10.0 * scene.step,
            ..scene
        };
        let _ = compare::compare(&short, &data, &options, &mut |_: Event<'_>| {});
    }
}
