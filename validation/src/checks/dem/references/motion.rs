//! Step-by-step motion: the kernel compared with the particles recorded by an engine.

use crate::checks::dem::scenes::advance;
use crate::checks::{Axis, Curve, Exhibit, Failure, Figure, Measurement, Outcome};
use crate::references::{Case, RecordedRun, Table};
use crate::scenes::Draft;
use gouge_dem::World;

/// Kinds of recorded quantities, each with its own scale.
const KINDS: [(&str, &[&str]); 5] = [
    ("displacement", &["x", "y"]),
    ("velocity", &["vx", "vy"]),
    ("spin", &["omegaz"]),
    ("force", &["fx", "fy"]),
    ("torque", &["tqz"]),
];

/// The difference between the kernel's run and the engine's.
pub(super) struct Difference {
    /// Largest difference at each recorded time in s, in units of its scale.
    pub course: Vec<[f64; 2]>,
    /// Largest overlap at a recorded time, in units of the smallest radius.
    pub depth: f64,
    /// Speeds or spins of the first particles at the recorded times.
    tracks: Vec<Track>,
    /// The quantity in the tracks.
    shown: [&'static str; 2],
}

/// A quantity of a particle over time, from the engine and from the kernel.
struct Track {
    engine: Vec<[f64; 2]>,
    kernel: Vec<[f64; 2]>,
}

/// Number of particles whose motion is plotted.
const DRAWN: usize = 3;

impl Difference {
    /// The largest difference.
    pub fn largest(&self) -> f64 {
        crate::checks::largest(self.course.iter().map(|point| point[1]))
    }
}

/// Compares all runs of a case.
pub(super) fn compare(case: &Case) -> Outcome {
    let mut measured = Vec::new();
    let (mut residuals, mut motions, mut shown) = (Vec::new(), Vec::new(), [""; 2]);
    for (run, difference) in differences(case)? {
        measured.push(Measurement::absolute(
            0.0,
            difference.largest(),
            case.tolerance,
        ));
        if motions.is_empty() {
            shown = difference.shown;
            for (n, track) in (1..).zip(difference.tracks) {
                let engine = format!("{}, particle {n}", case.result.engine);
                motions.push(Curve::line(&engine, track.engine));
                motions.push(Curve::marks(&format!("kernel, particle {n}"), track.kernel));
            }
        }
        residuals.push(Curve::marked_line(run, difference.course));
    }
    let first = case.runs.first().map_or("", |run| &run.name);
    let motion = Figure::new(
        format!("Run \"{first}\""),
        Axis::linear("time", "s"),
        Axis::linear(shown[0], shown[1]),
        motions,
    );
    let residual = Figure::new(
        "Largest difference at the recorded steps, in units of the largest value of its kind; exact agreement is not shown",
        Axis::linear("time", "s"),
        Axis::logarithmic("difference", ""),
        residuals,
    );
    let mut exhibits = vec![Exhibit::Text(case.agreement.clone())];
    let moves = residual.curves.iter().any(|curve| curve.points.len() > 1);
    if moves {
        exhibits.extend([motion, residual].map(Exhibit::Figure));
    }
    Ok(Measurement::worst(measured).showing(exhibits))
}

/// Every run of a case with its difference.
pub(super) fn differences(case: &Case) -> Result<Vec<(&str, Difference)>, Failure> {
    if case.runs.len() != case.result.runs.len() {
        return Err(Failure::Oracle(
            "case.toml and result.json list different numbers of runs".to_owned(),
        ));
    }
    let pairs = case.runs.iter().zip(&case.result.runs);
    pairs
        .map(|(run, recorded)| {
            let draft = case.draft(run).map_err(Failure::Oracle)?;
            Ok((run.name.as_str(), difference(&draft, recorded)?))
        })
        .collect()
}

/// The recorded motion of a run.
pub(super) fn recorded_motion(recorded: &RecordedRun) -> Result<&Table, Failure> {
    let missing = || Failure::Oracle("the result has no motion".to_owned());
    recorded.motion.as_ref().ok_or_else(missing)
}

/// Repeat a run by a scene and compare it at the recorded steps.
pub(super) fn difference(draft: &Draft, recorded: &RecordedRun) -> Result<Difference, Failure> {
    let table = recorded_motion(recorded)?;
    let mut world = draft.world()?;
    let columns = Columns::of(table, &world)?;
    let mut difference = Difference {
        course: Vec::new(),
        depth: 0.0,
        tracks: Vec::new(),
        shown: columns.shown(),
    };
    for (step, rows) in table.steps().map_err(Failure::Oracle)? {
        let missing = step.saturating_sub(world.steps());
        advance(&mut world, missing)?;
        world.evaluate_if_pending()?;
        let time = world.time();
        difference.depth = difference.depth.max(depth(&world));
        let errors = rows.iter().flat_map(|row| columns.errors(row, &world));
        difference
            .course
            .push([time, crate::checks::largest(errors)]);
        for (n, row) in rows.iter().take(DRAWN).enumerate() {
            if difference.tracks.len() <= n {
                difference.tracks.push(Track {
                    engine: Vec::new(),
                    kernel: Vec::new(),
                });
            }
            let [engine, kernel] = columns.drawn(row, &world);
            difference.tracks[n].engine.push([time, engine]);
            difference.tracks[n].kernel.push([time, kernel]);
        }
    }
    Ok(difference)
}

/// Largest overlap of a contact in units of the smallest radius.
fn depth(world: &World) -> f64 {
    let radius = smallest_radius(world);
    let links = world.interactions();
    let depths = links.iter().map(|link| link.normal_displacement / radius);
    depths.fold(0.0, f64::max)
}

fn smallest_radius(world: &World) -> f64 {
    let radii = world.particles().radius.iter().copied();
    radii.fold(f64::INFINITY, f64::min)
}

/// Positions of the recorded quantities in a row, and their scales.
struct Columns {
    id: usize,
    /// Kind, axis within the kind, position in the row, scale.
    places: Vec<(usize, usize, usize, f64)>,
    /// Whether surfaces move faster by rotation than by translation.
    spins: bool,
}

impl Columns {
    fn of(table: &Table, world: &World) -> Result<Self, Failure> {
        let id = table.column("id").map_err(Failure::Oracle)?;
        let is_particle =
            |row: &Vec<f64>| (1.0..=world.particles().len() as f64).contains(&row[id]);
        if !table.rows.iter().all(is_particle) {
            return Err(Failure::Oracle(
                "the result contains particles that the scene does not have".to_owned(),
            ));
        }
        let scales = scales(table, id, world)?;
        let mut places = Vec::new();
        for (kind, (_, names)) in KINDS.iter().enumerate() {
            for (axis, name) in names.iter().enumerate() {
                if let Ok(place) = table.column(name) {
                    places.push((kind, axis, place, scales[kind]));
                }
            }
        }
        let spins = largest(table, 2, id) * smallest_radius(world) > largest(table, 1, id);
        Ok(Self { id, places, spins })
    }

    /// Differences of a particle's quantities in units of their scales.
    fn errors(&self, row: &[f64], world: &World) -> impl Iterator<Item = f64> {
        let i = row[self.id] as usize - 1;
        self.places.iter().map(move |&(kind, axis, place, scale)| {
            let error = (quantity(world, i, kind, axis) - row[place]).abs();
            if error == 0.0 { 0.0 } else { error / scale }
        })
    }

    /// The quantity in the tracks, and its unit.
    fn shown(&self) -> [&'static str; 2] {
        if self.spins {
            ["spin", "rad/s"]
        } else {
            ["speed", "m/s"]
        }
    }

    /// Plotted quantity of a particle, from the engine and from the kernel.
    fn drawn(&self, row: &[f64], world: &World) -> [f64; 2] {
        let i = row[self.id] as usize - 1;
        let of = |wanted: usize| self.places.iter().filter(move |(kind, ..)| *kind == wanted);
        if self.spins {
            let spin: f64 = of(2).map(|&(_, _, place, _)| row[place]).sum();
            return [spin, world.particles().angular_velocity[i]];
        }
        let squared: f64 = of(1).map(|&(_, _, place, _)| row[place] * row[place]).sum();
        [squared.sqrt(), world.particles().velocity[i].norm()]
    }
}

/// Scales of all kinds: the largest recorded value. Translation and rotation are converted at the
/// smallest radius, and the scale of displacements is at least the distance covered between two records
/// at the largest speed.
fn scales(table: &Table, id: usize, world: &World) -> Result<[f64; KINDS.len()], Failure> {
    let [length, speed, spin, force, torque] = [0, 1, 2, 3, 4].map(|kind| largest(table, kind, id));
    let radius = smallest_radius(world);
    let steps = table.steps().map_err(Failure::Oracle)?;
    let records = steps.windows(2).map(|pair| pair[1].0 - pair[0].0);
    let interval = records.min().unwrap_or(0) as f64 * world.model().time_step;
    let speed = speed.max(spin * radius);
    let force = force.max(torque / radius);
    let length = length.max(speed * interval);
    Ok([length, speed, speed / radius, force, force * radius])
}

/// The largest recorded value of a kind; for positions, the largest displacement since the first
/// record.
fn largest(table: &Table, kind: usize, id: usize) -> f64 {
    let mut largest = 0.0_f64;
    for place in KINDS[kind]
        .1
        .iter()
        .filter_map(|name| table.column(name).ok())
    {
        for row in &table.rows {
            let first = table.rows.iter().find(|first| first[id] == row[id]);
            let origin = match (kind, first) {
                (0, Some(first)) => first[place],
                _ => 0.0,
            };
            largest = largest.max((row[place] - origin).abs());
        }
    }
    largest
}

/// A quantity of a particle by kind and axis.
fn quantity(world: &World, i: usize, kind: usize, axis: usize) -> f64 {
    let (particles, forces) = (world.particles(), world.forces());
    let vector = match kind {
        0 => particles.position[i],
        1 => particles.velocity[i],
        2 => return particles.angular_velocity[i],
        3 => forces.force[i],
        _ => return forces.torque[i],
    };
    if axis == 0 { vector.x } else { vector.y }
}
