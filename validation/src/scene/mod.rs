//! Scene files: what a user says, checked to the last key.

pub mod builtin;
mod laws;
mod particles;
mod setup;
mod table;

pub use laws::DrivingTable;
pub use particles::{Place, Placed, role_name};
pub use setup::{Amount, Bonding, FaultTable, LatticeTable, PhaseTable, Roles, Setup};

use crate::error::{Error, SceneError};
use gouge_kernel::geometry::Vec2;
use gouge_kernel::integrators::Integrator;
use gouge_kernel::laws::characteristic_length;
use gouge_kernel::links::{BondStart, ContactStart, Pair};
use gouge_kernel::model::{Ambient, Bond, Contact, Domain, External, Model, Reading};
use gouge_kernel::particles::{Particle, Particles, Role};
use gouge_kernel::{ModelError, Start, World};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use table::{Range, Source, Table, shortened};
use toml::de::DeTable;

type Result<T> = std::result::Result<T, SceneError>;

/// A scene, complete and consistent.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Title.
    pub title: String,
    /// Form of the disputed equations.
    pub reading: Reading,
    /// Integration method.
    pub integrator: Integrator,
    /// Time step in s.
    pub step: f64,
    /// Last time in s.
    pub end: f64,
    /// The box.
    pub domain: Domain,
    /// Density of the particles in kg/m^3, where they have none of their own.
    pub density: f64,
    /// Weak links.
    pub contact: Option<Contact>,
    /// Strong links.
    pub bond: Option<Bond>,
    /// Drag.
    pub ambient: Option<Ambient>,
    /// External potential.
    pub external: Option<External>,
    /// Driving.
    pub driving: Option<DrivingTable>,
    /// Particles that the scene lists.
    pub particles: Vec<Particle>,
    /// Bonds that the scene lists.
    pub bonds: Placed<BondStart>,
    /// Contacts that began before t = 0.
    pub contacts: Placed<ContactStart>,
    /// Protocol that makes more particles.
    pub setup: Option<Setup>,
    /// What a run writes.
    pub output: Output,
    /// Name of the file.
    pub file: String,
    /// All files that were read: the scene and those beside it.
    pub files: Vec<PathBuf>,
    /// SHA-256 of the file.
    pub sha256: String,
}

/// `[output]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output {
    /// Time between samples in s.
    pub interval: f64,
    /// Frames of the trajectory.
    pub trajectory: Trajectory,
    /// Whether energies are booked and written.
    pub energy: bool,
}

/// Format of the trajectory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trajectory {
    /// No frames.
    None,
    /// Legacy VTK files.
    Vtk,
    /// Extended XYZ files.
    Extxyz,
}

const KEYS: [&str; 18] = [
    "title",
    "reading",
    "time",
    "box",
    "material",
    "contact",
    "bond",
    "ambient",
    "external",
    "driving",
    "particles",
    "particles_file",
    "bonds",
    "bonds_file",
    "contacts",
    "contacts_file",
    "setup",
    "output",
];

/// Names of the integrators.
pub const INTEGRATORS: [(&str, Integrator); 5] = [
    ("euler", Integrator::Euler),
    ("symplectic-euler", Integrator::SymplecticEuler),
    ("taylor", Integrator::Taylor),
    ("velocity-verlet", Integrator::VelocityVerlet),
    ("beeman", Integrator::Beeman),
];

impl Scene {
    /// Read a scene file, or a built-in scene by its name.
    ///
    /// # Errors
    /// Unreadable files and every mistake in them.
    pub fn load(name: &str) -> std::result::Result<Self, Error> {
        if let Some(text) = builtin::text(name) {
            return Ok(Self::parse(name, text.as_bytes(), Path::new("."))?);
        }
        let path = Path::new(name);
        let bytes = std::fs::read(path).map_err(|error| SceneError {
            file: name.to_owned(),
            line: 0,
            key: String::new(),
            value: String::new(),
            accepted: format!(
                "must be a readable scene file or one of the built-in scenes {}: {error}",
                builtin::names().join(", ")
            ),
        })?;
        let folder = path.parent().unwrap_or(Path::new("."));
        Ok(Self::parse(name, &bytes, folder)?)
    }

    /// Read a scene from the bytes of a file; side files are sought in `folder`.
    ///
    /// # Errors
    /// Every mistake in it.
    pub fn parse(file: &str, bytes: &[u8], folder: &Path) -> Result<Self> {
        let text = text_of(file, bytes)?;
        let source = Source { file, text };
        let table = DeTable::parse(text).map_err(|error| syntax_error(&source, &error))?;
        let root = Table::root(source, table.get_ref());
        let mut scene = Self::from_table(&root, folder)?;
        scene.sha256 = hex(&Sha256::digest(bytes));
        scene.check(&root)?;
        Ok(scene)
    }

    fn from_table(root: &Table, folder: &Path) -> Result<Self> {
        root.allow(&KEYS)?;
        let readings = [
            ("corrected", Reading::Corrected),
            ("thesis", Reading::Thesis),
        ];
        let reading = root
            .optional_choice("reading", &readings)?
            .unwrap_or(Reading::Corrected);
        let domain = domain(root)?;
        let time = root.table("time")?;
        time.allow(&["step", "end", "integrator"])?;
        let (end, step) = time.duration_and_step("end")?;
        let density = density(root)?;
        Ok(Self {
            title: root.optional_text("title")?.unwrap_or_default().to_owned(),
            reading,
            integrator: time.choice("integrator", &INTEGRATORS)?,
            step,
            end,
            contact: laws::contact(root, reading)?,
            bond: laws::bond(root)?,
            ambient: laws::ambient(root, reading)?,
            external: laws::external(root, &domain)?,
            driving: laws::driving(root)?,
            particles: particles::particles(root, folder, density)?,
            bonds: particles::bonds(root, folder)?,
            contacts: particles::contacts(root, folder)?,
            setup: setup::setup(root, &domain, reading, density)?,
            output: output(root, end)?,
            domain,
            density,
            file: root.source().file.to_owned(),
            files: files(root, folder)?,
            sha256: String::new(),
        })
    }

    /// What no single table can tell.
    fn check(&self, root: &Table) -> Result<()> {
        if self.particles.is_empty() && self.setup.is_none() {
            return Err(no_particles(root));
        }
        let bonds_made = self
            .setup
            .as_ref()
            .is_some_and(|setup| setup.bonding.is_some());
        if self.bond.is_none() && (!self.bonds.is_empty() || bonds_made) {
            return Err(root.error(
                "bond",
                "missing; a scene with bonds needs the laws in [bond]",
            ));
        }
        let yields = self.bond.is_some_and(|bond| bond.yielding.is_some());
        if yields && self.bonds.is_empty() && !bonds_made {
            let accepted = "yielding needs bonds: [[bonds]], bonds_file or [setup.bonding]";
            return Err(root.table("bond")?.error("yielding", accepted));
        }
        if self.contact.is_none() && !self.contacts.is_empty() {
            return Err(root.error(
                "contact",
                "missing; [[contacts]] need the laws in [contact]",
            ));
        }
        self.check_pairs()?;
        self.check_driving(root)?;
        self.check_box(root)?;
        if self.setup.is_none() {
            self.initial_world()
                .map_err(|error| self.placed(root, &error))?;
        }
        Ok(())
    }

    fn check_pairs(&self) -> Result<()> {
        if self.setup.is_some() {
            let bonds = self.bonds.iter().map(|(bond, place)| (bond.between, place));
            let contacts = self
                .contacts
                .iter()
                .map(|(contact, place)| (contact.between, place));
            return match bonds.chain(contacts).next() {
                Some((between, place)) => Err(place.error(
                    format!("{between:?}"),
                    "cannot be listed in a scene with [setup], which makes its own".to_owned(),
                )),
                None => Ok(()),
            };
        }
        let number = self.particles.len();
        check_pairs(
            number,
            self.bonds.iter().map(|(bond, place)| (bond.between, place)),
        )?;
        check_pairs(
            number,
            self.contacts
                .iter()
                .map(|(contact, place)| (contact.between, place)),
        )?;
        self.check_unbonded()
    }

    /// No pair is bonded and also in contact.
    fn check_unbonded(&self) -> Result<()> {
        let pair = |between: [usize; 2]| Pair::new(between[0], between[1]);
        let bonded: std::collections::HashSet<Pair> = self
            .bonds
            .iter()
            .map(|(bond, _)| pair(bond.between))
            .collect();
        let both = |(contact, _): &&(ContactStart, Place)| bonded.contains(&pair(contact.between));
        match self.contacts.iter().find(both) {
            Some((contact, place)) => Err(place.error(
                format!("{:?}", contact.between),
                "names a pair that is bonded; a bonded pair has no contact".to_owned(),
            )),
            None => Ok(()),
        }
    }

    fn check_driving(&self, root: &Table) -> Result<()> {
        let Some(driving) = self.driving else {
            return Ok(());
        };
        let table = root.table("driving")?;
        let listed = self.particles.iter().any(|p| p.role == Role::Driven);
        let roles = self.setup.as_ref().and_then(|setup| setup.roles);
        if !listed && roles.is_none_or(|roles| roles.driven_above.is_none()) {
            let accepted = "needs a particle whose role is \"driven\"";
            return Err(root.error("driving", accepted));
        }
        if driving.area.is_none() && self.domain.width.is_none() {
            let accepted = "missing; without box.width the area must be given, in m^2";
            return Err(table.error("area", accepted));
        }
        Ok(())
    }

    fn check_box(&self, root: &Table) -> Result<()> {
        let (true, Some(width)) = (self.domain.periodic, self.domain.width) else {
            return Ok(());
        };
        let listed = self.particles.iter().map(|p| p.radius).fold(0.0, f64::max);
        let made = self.setup.as_ref().map_or(0.0, |setup| setup.sizes.maximum);
        let cell = 2.0 * listed.max(made);
        if width < 2.0 * cell {
            let accepted = format!(
                "must be at least two cells wide, {} m: four times the largest radius",
                2.0 * cell
            );
            return Err(root.table("box")?.error("width", &accepted));
        }
        Ok(())
    }

    /// The scene's error for one that the kernel found.
    fn placed(&self, root: &Table, error: &ModelError) -> SceneError {
        let bond = |(bond, place): &(BondStart, Place)| (bond.between, place.clone());
        let contact = |(contact, place): &(ContactStart, Place)| (contact.between, place.clone());
        let place = match error {
            ModelError::LongBond { link, .. } => self.bonds.get(*link).map(bond),
            ModelError::NoOverlap { link, .. } => self.contacts.get(*link).map(contact),
            _ => None,
        };
        match place {
            Some((between, place)) => place.error(format!("{between:?}"), error.to_string()),
            None => root.source().error(0, "", "", &error.to_string()),
        }
    }

    /// The model of the scene proper, for particles of the given radii.
    pub fn model(&self, radii: &[f64]) -> Model {
        let width = self.domain.width.unwrap_or(0.0);
        Model {
            reading: self.reading,
            integrator: self.integrator,
            time_step: self.step,
            domain: self.domain,
            contact: self.contact,
            bond: self.bond,
            ambient: self.ambient,
            external: self.external,
            driving: self
                .driving
                .map(|table| table.law(width, characteristic_length(radii))),
            ledger: self.output.energy,
        }
    }

    /// The world at t = 0 of a scene without set-up.
    ///
    /// # Errors
    /// States that the kernel refuses.
    pub fn initial_world(&self) -> std::result::Result<World, ModelError> {
        let mut particles: Particles = self.particles.iter().copied().collect();
        wrap(&self.domain, &mut particles);
        let model = self.model(&particles.radius);
        let start = Start {
            bonds: self.bonds.iter().map(|(bond, _)| *bond).collect(),
            contacts: self.contacts.iter().map(|(contact, _)| *contact).collect(),
            drive_force: self.initial_force(),
        };
        World::new(model, particles, &start)
    }

    /// Total driving force at t = 0 in N.
    pub fn initial_force(&self) -> Vec2 {
        self.driving.map_or(Vec2::zero(), |driving| {
            Vec2::new(driving.initial_force[0], driving.initial_force[1])
        })
    }

    /// Number of steps to the end.
    pub fn steps(&self) -> u64 {
        steps_for(self.end, self.step)
    }
}

/// Number of steps that cover a duration: the nearest whole number where that is meant, or the next.
pub fn steps_for(duration: f64, step: f64) -> u64 {
    let exact = duration / step;
    let nearest = exact.round();
    let steps = if (exact - nearest).abs() < 1e-6 {
        nearest
    } else {
        exact.ceil()
    };
    steps as u64
}

/// Represent all particles of a periodic box in it.
pub fn wrap(domain: &Domain, particles: &mut Particles) {
    use gouge_kernel::geometry::{Metric, PeriodicX};
    if let (true, Some(length)) = (domain.periodic, domain.width) {
        particles
            .position
            .iter_mut()
            .for_each(|x| *x = PeriodicX { length }.wrap(*x));
    }
}

fn check_pairs<'a>(
    particles: usize,
    pairs: impl Iterator<Item = ([usize; 2], &'a Place)>,
) -> Result<()> {
    let mut seen = std::collections::HashSet::new();
    for ([i, j], place) in pairs {
        let problem = if i >= particles || j >= particles {
            let last = particles.saturating_sub(1);
            Some(format!(
                "names a particle that does not exist; indices go from 0 to {last}"
            ))
        } else if i == j {
            Some("connects a particle with itself; two different ones are needed".to_owned())
        } else if !seen.insert(Pair::new(i, j)) {
            Some("repeats a pair; each pair may be listed once".to_owned())
        } else {
            None
        };
        if let Some(accepted) = problem {
            return Err(place.error(format!("[{i}, {j}]"), accepted));
        }
    }
    Ok(())
}

fn domain(root: &Table) -> Result<Domain> {
    let Some(table) = root.optional_table("box")? else {
        return Ok(Domain {
            width: None,
            height: None,
            periodic: false,
        });
    };
    table.allow(&["width", "height", "boundary"])?;
    let width = table.optional_number("width", Range::Positive)?;
    let boundaries = [("open", false), ("periodic-x", true)];
    let periodic = table
        .optional_choice("boundary", &boundaries)?
        .unwrap_or(false);
    if periodic && width.is_none() {
        return Err(table.error("width", "missing; a periodic box needs its width in m"));
    }
    Ok(Domain {
        width,
        height: table.optional_number("height", Range::Positive)?,
        periodic,
    })
}

fn density(root: &Table) -> Result<f64> {
    let table = root.table("material")?;
    table.allow(&["density"])?;
    table.number("density", Range::Positive)
}

fn output(root: &Table, end: f64) -> Result<Output> {
    let default = if end > 0.0 { end / 200.0 } else { 1.0 };
    let Some(table) = root.optional_table("output")? else {
        return Ok(Output {
            interval: default,
            trajectory: Trajectory::None,
            energy: true,
        });
    };
    table.allow(&["interval", "trajectory", "energy"])?;
    let formats = [
        ("none", Trajectory::None),
        ("vtk", Trajectory::Vtk),
        ("extxyz", Trajectory::Extxyz),
    ];
    Ok(Output {
        interval: table
            .optional_number("interval", Range::Positive)?
            .unwrap_or(default),
        trajectory: table
            .optional_choice("trajectory", &formats)?
            .unwrap_or(Trajectory::None),
        energy: table.optional_truth("energy")?.unwrap_or(true),
    })
}

fn text_of<'a>(file: &str, bytes: &'a [u8]) -> Result<&'a str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let valid = &bytes[..error.valid_up_to()];
        SceneError {
            file: file.to_owned(),
            line: 1 + valid.iter().filter(|&&b| b == b'\n').count(),
            key: String::new(),
            value: format!("byte 0x{:02x}", bytes[error.valid_up_to()]),
            accepted: "must be a TOML file in UTF-8".to_owned(),
        }
    })
}

fn files(root: &Table, folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = vec![PathBuf::from(root.source().file)];
    for key in ["particles_file", "bonds_file", "contacts_file"] {
        files.extend(root.optional_text(key)?.map(|name| folder.join(name)));
    }
    Ok(files)
}

fn no_particles(root: &Table) -> SceneError {
    if root.has("particles_file") {
        return root.error("particles_file", "must list at least one particle");
    }
    let accepted = "a scene needs [[particles]], particles_file or [setup]";
    match root.has("particles") {
        true => root.error("particles", accepted),
        false => root.error("particles", &format!("missing; {accepted}")),
    }
}

/// An error in a file that is no TOML, with the key that the line seems to mean.
fn syntax_error(source: &Source, error: &toml::de::Error) -> SceneError {
    let at = error.span().map_or(0, |span| span.start);
    let before = source.line(at) - 1;
    let line = source.text.lines().nth(before).unwrap_or_default().trim();
    let table = enclosing_table(source.text, before);
    let (key, value) = match line.split_once('=') {
        _ if line.starts_with('[') => (String::new(), line),
        Some((key, value)) if table.is_empty() => (shortened(key.trim()), value.trim()),
        Some((key, value)) => (format!("{table}.{}", shortened(key.trim())), value.trim()),
        None => (table, line),
    };
    let accepted = format!("must be TOML: {}", error.message());
    source.error(at, &key, &shortened(value), &accepted)
}

/// Dotted path of the table whose header is the last one among the first lines of a text.
fn enclosing_table(text: &str, lines: usize) -> String {
    let headers = || text.lines().take(lines).filter_map(header);
    match headers().last() {
        None => String::new(),
        Some((name, false)) => name.to_owned(),
        Some(last) => format!(
            "{}[{}]",
            last.0,
            headers().filter(|&h| h == last).count() - 1
        ),
    }
}

/// Name in a line such as `[name]` or `[[name]]`, and whether it is of the latter kind.
fn header(line: &str) -> Option<(&str, bool)> {
    let (inner, _) = line.trim_start().strip_prefix('[')?.split_once(']')?;
    let name = inner.strip_prefix('[');
    let (name, is_list) = (name.unwrap_or(inner).trim(), name.is_some());
    let is_key = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
    let is_name = name.len() <= 60 && !name.is_empty() && name.chars().all(is_key);
    is_name.then_some((name, is_list))
}

/// Bytes in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
