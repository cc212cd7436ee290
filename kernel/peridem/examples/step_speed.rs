//! Time per step of grains that touch, with shares of contact and walls: nine discs that have settled in a container, and
//! a plate in a hundred pieces. In turns with the same grains without contact, on one thread, as time on the processor, which
//! other programs lengthen little; so it runs only on Linux. Then whole steps with two threads, by the clock on the wall.

use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::{Settings, Walls};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::limits::Limits;
use gouge_peridem::material::{Material, Plane, Weight};
use gouge_peridem::state::State;
use gouge_peridem::wall_law::{WallLaw, WallReading};
use gouge_peridem::world::{Beginning, World};
use rayon::ThreadPoolBuilder;
use std::error::Error;
use std::time::Instant;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Distance of nodes in m, a quarter of the horizon of the source.
const H: f64 = 1.25e-4;
const MATERIAL: Material = Material {
    young_modulus: 1.23e9,
    poisson_ratio: 1.0 / 3.0,
    fracture_energy: 135.0,
    density: 1200.0,
    plane: Plane::Stress,
};
const ROUNDS: usize = 21;
/// Nodes times steps of a round, which makes a quarter of a second; the clock of the processor advances every 4 ms. Lists of
/// contacts are rebuilt in a round.
const NODE_STEPS: usize = 2_000_000;

fn grain(position: Vec<Vec2>, breaking: Option<BreakingRule>) -> Outcome<Grain> {
    let constants = MATERIAL.bond_constants(Weight::Constant, 4.015 * H)?;
    Ok(Grain {
        area: vec![H * H; position.len()],
        position,
        density: MATERIAL.density,
        constants,
        breaking,
        touches_itself: breaking.is_some(),
        contact_stiffness: constants.stiffness,
        material: 0,
        clamped: Vec::new(),
        load: Vec::new(),
    })
}

/// Contact, friction and damping of the settling grains of the source, in a container or not.
fn settings(grains: &Grains, gravity: f64) -> Settings {
    let radius = 1.6 * H;
    let stiffness = grains.rows[0].constants.stiffness / radius;
    let (damping_ratio, friction) = (0.8, 0.8);
    Settings {
        time_step: 0.0,
        gravity: Vec2::new(0.0, -gravity),
        break_order: BreakOrder::BreakFirst,
        contact: Some(Contact {
            law: ContactLaw {
                radius,
                damping_ratio,
                friction,
                reading: ContactReading::Symmetric,
            },
            stiffness: vec![vec![stiffness]],
            shares_sticking: true,
        }),
        walls: Some(Walls {
            law: WallLaw {
                radius,
                stiffness,
                damping_ratio,
                friction,
                reading: WallReading::Paper,
            },
            velocity: [0.0; 4],
        }),
    }
}

/// Nine discs of 0.8 mm in a square, settled under the gravity of the source.
fn settled() -> Outcome<World> {
    let cells = 7_i32;
    let disc = |k: usize| {
        let pitch = 14.8 * H;
        let centre = Vec2::new(
            (k % 3) as f64 * 1.01 + 0.02 * (k / 3) as f64,
            (k / 3) as f64,
        ) * pitch;
        let axis = move || (-cells..cells).map(|k| (f64::from(k) + 0.5) * H);
        let all = axis().flat_map(move |y| axis().map(move |x| Vec2::new(x, y)));
        grain(
            all.filter(|arm| arm.norm() <= 6.4 * H)
                .map(|arm| centre + arm)
                .collect(),
            None,
        )
    };
    let grains = Grains::new(&(0..9).map(disc).collect::<Outcome<Vec<_>>>()?)?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    let mut state = State::at_rest(&grains, bonds);
    state.walls = [-7.5 * H, 38.0 * H, 60.0 * H, -7.5 * H];
    let mut settings = settings(&grains, 5000.0);
    settings.time_step = 0.4 * Limits::of(&grains, &state.bonds, &settings).smallest().1;
    let mut world = World::new(grains, settings, state, Beginning::Forces)?;
    for _ in 0..20_000 {
        world.step()?;
    }
    Ok(world)
}

/// A square of 100 x 100 nodes, cut into pieces of 10 x 10 that move against each other.
fn shattered() -> Outcome<World> {
    let position: Vec<_> = (0..10_000)
        .map(|k| Vec2::new((k % 100) as f64, (k / 100) as f64) * H)
        .collect();
    let piece = |at: Vec2| [at.x, at.y].map(|x| ((x / H).round() / 10.0) as usize);
    let grains = Grains::new(&[grain(position, Some(BreakingRule::TensionOnly))?])?;
    let bonds = Bonds::within_horizon(&grains, |_, from, to| piece(from) == piece(to))?;
    let mut state = State::at_rest(&grains, bonds);
    for (velocity, place) in state.velocity.iter_mut().zip(&state.places) {
        let [column, row] = piece(place.reference);
        let part = |factor: usize| ((column * factor + row * 3) % 11) as f64 - 5.0;
        *velocity = Vec2::new(part(7), part(4)) * 0.2;
    }
    let mut settings = settings(&grains, 0.0);
    settings.time_step = 0.4 * Limits::of(&grains, &state.bonds, &settings).smallest().1;
    Ok(World::new(grains, settings, state, Beginning::Forces)?)
}

/// The same world with some settings changed.
fn changed(world: &World, change: impl FnOnce(&mut Settings)) -> Outcome<World> {
    let mut settings = world.settings().clone();
    change(&mut settings);
    let (grains, state) = (world.grains().clone(), world.state().clone());
    Ok(World::new(grains, settings, state, Beginning::Given)?)
}

/// Time in us that this thread has spent on the processor.
fn on_processor() -> Outcome<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat")?;
    let nanoseconds = text.split(' ').next().ok_or("no time in schedstat")?;
    Ok(1e-3 * nanoseconds.parse::<f64>()?)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Steps of a round of a world.
fn steps(world: &World) -> usize {
    NODE_STEPS / world.grains().nodes()
}

/// Median times in us of a step with one thread: of bonds and motion, with contact, and with walls.
fn times(world: &World) -> Outcome<[f64; 3]> {
    let mut worlds = [
        changed(world, |settings| {
            (settings.contact, settings.walls) = (None, None);
        })?,
        changed(world, |settings| settings.walls = None)?,
        changed(world, |_| ())?,
    ];
    let mut all = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        for (world, times) in worlds.iter_mut().zip(&mut all) {
            let begin = on_processor()?;
            for _ in 0..steps(world) {
                world.step()?;
            }
            times.push((on_processor()? - begin) / steps(world) as f64);
        }
    }
    Ok(all.map(median))
}

/// Median time in us of a step by the clock on the wall.
fn elapsed(world: &World) -> Outcome<f64> {
    let mut world = world.clone();
    let mut times = Vec::new();
    for _ in 0..ROUNDS {
        let begin = Instant::now();
        for _ in 0..steps(&world) {
            world.step()?;
        }
        times.push(1e6 * begin.elapsed().as_secs_f64() / steps(&world) as f64);
    }
    Ok(median(times))
}

/// The outcome of a task with a number of threads.
fn with_threads<T: Send>(threads: usize, task: impl FnOnce() -> Outcome<T> + Send) -> Outcome<T> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
    Ok(pool.install(|| task().map_err(|error| error.to_string()))?)
}

fn print(name: &str, world: &World) -> Outcome<()> {
    let [bonds, contact, walls] = with_threads(1, || times(world))?;
    let with_two = with_threads(2, || elapsed(world))?;
    println!(
        "{name}: {} nodes, {} bonds; {walls:.1} us a step; bonds and motion {bonds:.1}, contact {:+.2} of it, walls {:+.2}; two \
         threads {with_two:.1} us",
        world.grains().nodes(),
        world.bonds().count(),
        contact / bonds - 1.0,
        (walls - contact) / bonds,
    );
    Ok(())
}

fn main() -> Outcome<()> {
    print("nine settled discs", &with_threads(1, settled)?)?;
    print("a plate in pieces", &shattered()?)
}
