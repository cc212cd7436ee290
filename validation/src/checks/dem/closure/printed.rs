//! Errors of the printed estimators (76), (78) and (79), and the estimators that close the balance.

use super::heat::{FRICTION, HELD, SPIN, SQUEEZE, STIFFNESS, held};
use super::spheres::{RADIUS, inertia, mass};
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::printed::{Link, Printed};
use crate::scenes::fault::weak;
use crate::scenes::{Draft, Grain, events};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{Controller, KelvinVoigt};
use gouge_dem::particles::Role;
use gouge_runner::scene::DrivingTable;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.printed-heat",
            claim: "With the displacement of one end only, (78) counts all, half or none of the heat of the same sliding motion, depending on how the particles are numbered.",
            equations: thesis("(78)"),
            scene: "A sphere that spins between two fixed ones and is first, second or last in the list; Haff-Werner at its limit, 2000 steps",
            oracle: "2, 1 and 0 times mu N times the distance under constant deceleration; with the displacements of both ends, 2 for every numbering",
            norm: "Error over the total heat",
            origin: Origin::Exact,
            reason: "Constant forces act on a linearly changing speed: one rounding per step in each of two sums, 2000 steps",
            effort: Effort::Quick,
            measure: numbered,
        },
        Check {
            id: "closure.printed-store",
            claim: "With the displacement of one end only, (76) stores energy in two spheres that roll on each other like gears, although no tangential force has acted.",
            equations: thesis("(76)"),
            scene: "Two equal spheres of opposite spin that press on each other without sliding; truncated Cundall-Strack",
            oracle: "k (r w t)^2 / 2 from the displacement of one end; zero from the sum of both",
            norm: "Error over the stored energy as printed",
            origin: Origin::Exact,
            reason: "Angles are sums of N equal rotations, N roundings of 2^-53, and enter as squares",
            effort: Effort::Quick,
            measure: gears,
        },
        Check {
            id: "closure.printed-driving",
            claim: "Because it sums absolute values, (79) overestimates the work on two driven particles that move against each other.",
            equations: thesis("(79)"),
            scene: "Two driven spheres without contacts or bonds, with opposite vertical velocities, under a constant load",
            oracle: "Work of a constant force on a uniformly accelerated mass, for each sphere",
            norm: "Relative error of either sum",
            origin: Origin::Exact,
            reason: "The method is exact for constant acceleration: one rounding per step in each of two sums, 1000 steps, and a factor of ten for the cancellation of the two works",
            effort: Effort::Quick,
            measure: apart,
        },
        Check {
            id: "closure.printed-balance",
            claim: "For an oblique impact, a rolling contact and a sheared, breaking fault, the ledger's signed terms close the balance; the printed terms do not.",
            equations: thesis("(72)-(79)"),
            scene: "Built-in scenes oblique, for 8 us, and rolling, for 20 ms; the small granite fault at 15 mm for 20 us, with bonds of a hundredth of the strength",
            oracle: "Work of all contacts, bonds and driving from their states along the run, signed and with both ends, by the trapezoidal rule",
            norm: "Residual of (72) with this work, and residual of the ledger, over the energy exchanged; a printed gap below one per cent counts as one",
            origin: Origin::Convergent,
            reason: "Contacts that begin or end and bonds that break within a step leave a first-order residual: one step over the shortest duration of a collision, 200 steps: 5e-3",
            effort: Effort::Thorough,
            measure: table,
        },
    ]
}

/// Contacts and bonds of a world in the form that the estimators take.
fn links(world: &World) -> Vec<Link> {
    let p = world.particles();
    let of = |link: &gouge_dem::forces::Interaction| {
        let (i, j) = link.pair.indices();
        let frame_rate =
            (p.velocity[j] - p.velocity[i]).dot(link.normal.perpendicular()) / link.distance;
        Link {
            pair: [i, j],
            normal_force: link.normal_force,
            normal_rate: link.normal_velocity,
            tangential_force: link.tangential_force,
            tangential_rates: link.tangential_velocity,
            torques: link.torque,
            turning: [i, j].map(|n| p.angular_velocity[n] - frame_rate),
        }
    };
    let mut all: Vec<Link> = world.interactions().iter().map(of).collect();
    all.sort_by_key(|link| link.pair);
    all
}

/// Powers of the driving force on the driven particles.
fn driving(world: &World) -> Vec<f64> {
    if world.model().driving.is_none() {
        return Vec::new();
    }
    let p = world.particles();
    let driven: Vec<usize> = p.with_role(Role::Driven).collect();
    let share = world.drive().force * (1.0 / driven.len() as f64);
    driven.iter().map(|&i| share.dot(p.velocity[i])).collect()
}

/// Steps a world and sums the estimators along the way.
fn follow(world: &mut World, steps: u64) -> Result<Printed, Failure> {
    let mut printed = Printed::default();
    let step = world.model().time_step;
    world.evaluate_if_pending()?;
    printed.look(links(world).into_iter(), driving(world), step);
    for _ in 0..steps {
        world.step()?;
        printed.look(links(world).into_iter(), driving(world), step);
    }
    Ok(printed)
}

/// In this reading the tangential force is the law's force, as printed.
const READING: &str = "thesis";
/// Moment of inertia in that reading, in m r^2.
const COMPUTED: f64 = 3.0 / 5.0;

fn numbered() -> Outcome {
    const STEPS: u32 = 2000;
    let time = f64::from(STEPS) * 1e-7;
    let limit = FRICTION * STIFFNESS * SQUEEZE;
    let deceleration = 2.0 * limit / (COMPUTED * mass(HELD) * HELD);
    let distance = HELD * (SPIN * time - 0.5 * deceleration * time * time);
    let whole = 2.0 * limit * distance;
    let rounding = 4.0 * f64::from(STEPS) * 0.5 * f64::EPSILON;
    let mut all = Vec::new();
    let mut table = Table::new(
        "Heat of one pair of sliding contacts for each numbering of the spinning sphere, in J",
        &[
            "place in the list",
            "(78) as printed",
            "signed, both ends",
            "ledger",
        ],
    );
    for (place, share) in [(0, 1.0), (1, 0.5), (2, 0.0)] {
        let mut world = held("haff-werner", place).reading(READING).world()?;
        let printed = follow(&mut world, u64::from(STEPS))?;
        let heats = [
            printed.links_as_printed(),
            printed.links(),
            world.energy().friction,
        ];
        for (heat, part) in heats.into_iter().zip([share, 1.0, 1.0]) {
            all.push(Measurement::scaled(part * whole, heat, whole, rounding));
        }
        let cells = heats.map(|heat| format!("{heat:.6e}"));
        table.push([(place + 1).to_string()].into_iter().chain(cells));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn gears() -> Outcome {
    const STEPS: u32 = 500;
    let (spin, spring, step) = (3000.0, 1e6, 1e-9);
    let draft = events::rubbing(Integrator::VelocityVerlet, step, 0.5, [spin, -spin])
        .law(KelvinVoigt {
            stiffness: 1e6,
            damping: 0.0,
        })
        .friction("cundall-strack-truncated", 0.5, spring);
    let mut world = draft.world()?;
    let printed = follow(&mut world, u64::from(STEPS))?;
    let links = world.interactions();
    let [zeta, other] = links
        .first()
        .map_or([f64::NAN; 2], |link| link.tangential_displacement);
    let store = |zeta: f64| 0.5 * spring * zeta * zeta;
    let expected = store(RADIUS * spin * f64::from(STEPS) * step);
    let rounding = 2.0 * f64::from(STEPS) * 0.5 * f64::EPSILON;
    // The energy taken up by the normal spring is all the energy exchanged.
    let taken =
        mass(RADIUS) * 0.25 - world.energy().kinetic + 2.0 * 0.5 * inertia(RADIUS) * spin * spin;
    Ok(Measurement::worst([
        Measurement::relative(expected, store(zeta), rounding),
        Measurement::scaled(0.0, store(zeta + other), expected, rounding * rounding),
        Measurement::relative(taken, printed.links(), 1e-5),
        Measurement::relative(world.energy().contact, printed.links(), 1e-5),
    ])
    .into())
}

fn apart() -> Outcome {
    const STEPS: u32 = 1000;
    let (force, step, m) = (0.002, 1e-6, mass(RADIUS));
    let speeds = [0.5, -0.4];
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .driving(DrivingTable {
            controller: Controller::Exact,
            speed: 0.0,
            pressure: force,
            area: Some(1.0),
            initial_force: [0.0; 2],
        })
        .grain(
            Grain::at([0.0; 2], RADIUS)
                .moving([0.0, speeds[0]])
                .driven(),
        )
        .grain(
            Grain::at([1.0, 0.0], RADIUS)
                .moving([0.0, speeds[1]])
                .driven(),
        );
    let mut world = draft.world()?;
    let printed = follow(&mut world, u64::from(STEPS))?;
    let (time, share) = (f64::from(STEPS) * step, -0.5 * force);
    let works = speeds.map(|v| share * (v * time + 0.5 * share / m * time * time));
    let (sum, absolute) = (works[0] + works[1], works[0].abs() + works[1].abs());
    let rounding = 10.0 * 2.0 * f64::from(STEPS) * 0.5 * f64::EPSILON;
    Ok(Measurement::worst([
        Measurement::relative(absolute, printed.driving_as_printed(), rounding),
        Measurement::relative(sum, printed.driving(), rounding),
        Measurement::relative(sum, world.energy().driving, rounding),
    ])
    .into())
}

/// The small granite fault after its set-up, so small and weak that it breaks within 2000 steps.
pub(super) fn fault(step: f64) -> Result<World, Failure> {
    let draft = weak().replacing("time.step", step);
    Ok(gouge_runner::run::run_setup(&draft.scene()?)?)
}

/// The initial world of a built-in scene.
fn named(name: &str) -> Result<World, Failure> {
    Ok(Draft::builtin(name).world()?)
}

fn table() -> Outcome {
    let mut table = Table::new(
        "Terms of (72), printed and signed, in J; gaps also in per cent of the energy exchanged",
        &[
            "scene",
            "energy and heat of contacts and bonds, printed",
            "both ends, signed",
            "work of driving, printed",
            "work of driving, signed",
            "gap as printed",
            "gap of the ledger",
        ],
    );
    let mut all = Vec::new();
    let scenes = [
        ("oblique impact", named("oblique")?, 8_000),
        ("rolling contact", named("rolling")?, 20_000),
        ("sheared fault", fault(10e-9)?, 2_000),
    ];
    for (name, mut world, steps) in scenes {
        let first = world.energy().kinetic + world.energy().external;
        let printed = follow(&mut world, steps)?;
        let energy = world.energy();
        let moved = energy.kinetic + energy.external - first;
        let turned = printed.links().abs().max(printed.driving().abs());
        let signed = moved + printed.links() - printed.driving();
        let gap = moved + printed.links_as_printed() - printed.driving_as_printed();
        all.push(Measurement::scaled(0.0, signed, turned, 5e-3));
        all.push(Measurement::scaled(0.0, energy.residual, turned, 5e-3));
        all.push(Measurement::count(usize::from(gap.abs() < 0.01 * turned)));
        let share = |gap: f64| format!("{gap:.2e} ({:.3} %)", 100.0 * gap / turned);
        // The sum of no terms is minus zero.
        let number = |x: f64| format!("{:.4e}", x + 0.0);
        table.push([
            name.to_owned(),
            number(printed.links_as_printed()),
            number(printed.links()),
            number(printed.driving_as_printed()),
            number(printed.driving()),
            share(gap),
            share(energy.residual),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
