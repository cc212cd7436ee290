//! Rolling and slip of the debris, for motions whose speeds are known.

use approx::assert_abs_diff_eq;
use gouge_dem::estimators::{debris, rolling_and_slip};
use gouge_dem::{Start, World};
use gouge_runner::scene::Scene;
use std::f64::consts::FRAC_PI_3;
use std::path::Path;

/// A disc as position, velocity, angular velocity, radius and role.
type Disc = ([f64; 2], [f64; 2], f64, f64, &'static str);

fn world(discs: &[Disc], bonds: &str) -> World {
    let particles: String = discs
        .iter()
        .map(|(position, velocity, spin, radius, role)| {
            format!(
                "[[particles]]\nposition = {position:?}\nvelocity = {velocity:?}\nangular_velocity = {spin:?}\n\
                 radius = {radius:?}\nrole = \"{role}\"\n"
            )
        })
        .collect();
    let text = format!(
        "[time]\nstep = 1e-9\nend = 1e-6\nintegrator = \"velocity-verlet\"\n[material]\ndensity = 2700.0\n[contact]\n\
         [contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 0.0\n[bond.normal]\nstiffness = 1e7\n\
         damping = 0.0\n{particles}{bonds}"
    );
    let scene = Scene::parse("scene.toml", text.as_bytes(), Path::new("."));
    let scene = scene.unwrap_or_else(|error| panic!("{error}\n{text}"));
    let particles = scene.particles.iter().copied().collect();
    let radii: Vec<f64> = scene.particles.iter().map(|one| one.radius).collect();
    let start = Start {
        bonds: scene.bonds.iter().map(|(bond, _)| *bond).collect(),
        ..Start::default()
    };
    World::new(scene.model(&radii), particles, &start).expect("a world")
}

/// Overlap of the discs, as a part of their radius.
const OVERLAP: f64 = 1e-9;

/// Two free discs of 1 mm with given spins, carried around the origin at `turn` in rad/s and along at `along` in m/s.
fn gears(spins: [f64; 2], turn: f64, along: [f64; 2]) -> [f64; 2] {
    let r = 1e-3;
    let distance = 2.0 * r * (1.0 - OVERLAP);
    let (sin, cos) = FRAC_PI_3.sin_cos();
    let disc = |at: [f64; 2], spin: f64| -> Disc {
        let velocity = [along[0] - turn * at[1], along[1] + turn * at[0]];
        (at, velocity, spin + turn, r, "free")
    };
    let world = world(
        &[
            disc([0.0, 0.0], spins[0]),
            disc([distance * cos, distance * sin], spins[1]),
        ],
        "",
    );
    rolling_and_slip(&world)
}

#[test]
fn gears_roll_and_equal_spins_slip_for_every_observer() {
    for (turn, along) in [(0.0, [0.0; 2]), (700.0, [3.0, -5.0])] {
        let [rolling, slip] = gears([200.0, -200.0], turn, along);
        assert_abs_diff_eq!(rolling, 0.2, epsilon = 1e-8);
        assert_abs_diff_eq!(slip, 0.0, epsilon = 1e-8);
        let [rolling, slip] = gears([200.0, 200.0], turn, along);
        assert_abs_diff_eq!(rolling, 0.0, epsilon = 1e-8);
        assert_abs_diff_eq!(slip, 0.4, epsilon = 1e-8);
    }
}

#[test]
fn a_disc_that_rolls_around_a_fixed_one_rolls_over_its_circumference() {
    // Its centre moves at 2 m/s on a circle of 3 mm + 1 mm. It rolls without slip at the spin 2 / 1 mm; then the
    // contact point moves over both surfaces at 2 m/s times 3/4.
    let distance = 4e-3 * (1.0 - OVERLAP);
    let fixed: Disc = ([0.0; 2], [0.0; 2], 0.0, 3e-3, "fixed");
    let orbit = |spin: f64| -> Disc { ([distance, 0.0], [0.0, 2.0], spin, 1e-3, "free") };
    let [rolling, slip] = rolling_and_slip(&world(&[fixed, orbit(2000.0)], ""));
    assert_abs_diff_eq!(rolling, 1.5, epsilon = 1e-8);
    assert_abs_diff_eq!(slip, 0.0, epsilon = 1e-8);
    // Without spin it slides along at 2 m/s.
    let [_, slip] = rolling_and_slip(&world(&[fixed, orbit(0.0)], ""));
    assert_abs_diff_eq!(slip, 2.0, epsilon = 1e-8);
}

#[test]
fn only_contacts_of_the_debris_count() {
    // A fixed disc holds a free one by a bond: together they are a block, on which a third disc slides.
    let step = 2e-3 * (1.0 - OVERLAP);
    let disc = |x: f64, speed: f64, role| -> Disc { ([x, 0.0], [0.0, speed], 0.0, 1e-3, role) };
    let discs = [
        disc(0.0, 0.0, "fixed"),
        disc(step, 4.0, "free"),
        disc(2.0 * step, 5.0, "free"),
    ];
    let one_block = world(&discs, "[[bonds]]\nbetween = [0, 1]\n");
    assert_eq!(debris(one_block.state()), [false, false, true]);
    assert_abs_diff_eq!(rolling_and_slip(&one_block)[1], 1.0, epsilon = 1e-7);
    let no_debris = world(
        &discs,
        "[[bonds]]\nbetween = [0, 1]\n[[bonds]]\nbetween = [1, 2]\n",
    );
    assert_eq!(rolling_and_slip(&no_debris), [0.0; 2]);
    let all_debris = world(&discs, "");
    assert_abs_diff_eq!(rolling_and_slip(&all_debris)[1], 5.0, epsilon = 1e-7);
}
