//! Prescribed motion, specimens cut to shape, and a lattice whose elastic constants are known.

use crate::program::{run, stderr, write_draft};
use crate::worlds::{INTEGRATORS, advance, scene, world};
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::laws::{AdjustedKelvinVoigt, Controller};
use gouge_dem::particles::Role;
use gouge_runner::run::{Columns, run_setup, stress_strain};
use gouge_runner::scene::DrivingTable;
use gouge_validation::scenes::{Bond, Draft, Grain};
use std::f64::consts::PI;

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1e7;

fn steady(velocity: [f64; 2]) -> DrivingTable {
    DrivingTable {
        controller: Controller::Steady {
            velocity: Vec2::new(velocity[0], velocity[1]),
        },
        speed: velocity[0],
        pressure: 0.0,
        area: Some(1.0),
        initial_force: [0.0; 2],
    }
}

/// A grain between a fixed one and one that is pulled away at a speed in m/s, with two bonds.
fn pulled(method: &str, step: f64, speed: f64) -> World {
    let grain = |i: u32| Grain::at([2.0 * RADIUS * f64::from(i), 0.0], RADIUS);
    let draft = Draft::open_box(method, step)
        .law(AdjustedKelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .driving(steady([speed, 0.0]))
        .grain(grain(0).fixed())
        .grain(grain(1))
        .grain(grain(2).driven().moving([-3.0, 4.0]).spinning(5.0))
        .bond(Bond::between(0, 1))
        .bond(Bond::between(1, 2));
    world(&draft)
}

/// The middle grain is an oscillator that is dragged along: the force is k v (t + sin(w t) / w) / 2 with w^2 = 2 k / m.
#[test]
fn a_prescribed_motion_takes_the_force_and_the_work_that_it_must() {
    let mass = 4.0 / 3.0 * PI * 2700.0 * RADIUS.powi(3);
    let (speed, frequency) = (0.5, (2.0 * STIFFNESS / mass).sqrt());
    for method in ["velocity-verlet", "beeman"] {
        for steps in [500, 1000] {
            let step = 6.0 / frequency / f64::from(steps);
            let mut world = pulled(method, step, speed);
            advance(&mut world, u64::try_from(steps).expect("positive"));
            let time = world.time();
            let force = 0.5 * STIFFNESS * speed * (time + (frequency * time).sin() / frequency);
            let swung = (1.0 - (frequency * time).cos()) / (frequency * frequency);
            let work = 0.5 * STIFFNESS * speed * speed * (0.5 * time * time + swung);
            let tolerance = (frequency * step).powi(2);
            let found = world.drive().applied.x;
            assert!(
                (found / force - 1.0).abs() < tolerance,
                "{method} {found} {force}"
            );
            let energy = world.energy();
            assert!(
                (energy.driving / work - 1.0).abs() < tolerance,
                "{method} {energy:?}"
            );
            assert!(
                energy.residual.abs() < tolerance * work,
                "{method} {energy:?}"
            );
        }
    }
}

#[test]
fn nothing_but_the_scene_moves_what_is_driven_steadily() {
    for method in INTEGRATORS {
        let mut world = pulled(method, 1e-8, 0.5);
        let start = world.particles().position[2];
        advance(&mut world, 200);
        let p = world.particles();
        assert_eq!(p.velocity[2], Vec2::new(0.5, 0.0), "{method}");
        assert_eq!(p.angular_velocity[2], 0.0);
        let moved = p.position[2] - start;
        // 200 sums, each rounded to the spacing of numbers near 4 mm.
        assert!(
            (moved.x - 0.5 * world.time()).abs() < 200.0 * 1e-18 && moved.y == 0.0,
            "{method}"
        );
        let mut copy = World::from_words(*world.model(), &world.to_words()).expect("just recorded");
        advance(&mut copy, 100);
        advance(&mut world, 100);
        assert!(copy.to_words() == world.to_words(), "{method}");
    }
}

#[test]
fn a_grain_rebounds_from_a_steady_one_as_from_a_wall() {
    let draft = Draft::open_box("velocity-verlet", 1e-9)
        .with("contact.normal.law", "kelvin-voigt")
        .with("contact.normal.stiffness", STIFFNESS)
        .with("contact.normal.restitution", 0.4)
        .driving(steady([-1.0, 0.0]))
        .grain(Grain::at([0.0, 0.0], RADIUS).moving([1.0, 0.0]))
        .grain(Grain::at([(2.0 * RADIUS).next_down(), 0.0], RADIUS).driven());
    let mut world = world(&draft);
    advance(&mut world, 10_000);
    let left = world.particles().velocity.clone();
    assert!(
        ((left[1].x - left[0].x) / 2.0 / 0.4 - 1.0).abs() < 1e-3,
        "{left:?}"
    );
}

/// Whether a point lies inside of a shape.
type IsInside = fn(Vec2) -> bool;

/// A packing on a lattice, cut to a shape, with the density of the material.
fn cut(shape: &str) -> World {
    let draft = Draft::open_box("velocity-verlet", 1e-8)
        .with("box.width", 40e-3)
        .with("box.height", 40e-3)
        .with("setup.seed", 3)
        .with("setup.correct_density", true)
        .with("setup.sizes.mean", RADIUS)
        .with("setup.lattice.rows", 15)
        .and(&Draft::parse(&format!("[setup.cut]\n{shape}")));
    run_setup(&scene(&draft)).expect("a specimen")
}

#[test]
fn a_specimen_has_the_shape_and_the_density_that_the_scene_asks_for() {
    let whole = run_setup(&scene(
        &Draft::open_box("velocity-verlet", 1e-8)
            .with("box.width", 40e-3)
            .with("setup.seed", 3)
            .with("setup.sizes.mean", RADIUS)
            .with("setup.lattice.rows", 15),
    ))
    .expect("a packing");
    let disc: IsInside = |x| (x - Vec2::new(20e-3, 18e-3)).norm() <= 12e-3;
    let block: IsInside = |x| x.x >= 8e-3 && x.x <= 30e-3 && x.y >= 5e-3 && x.y <= 20e-3;
    let shapes: [(&str, IsInside, f64); 2] = [
        (
            "shape = 'disc'\ncenter = [20e-3, 18e-3]\nradius = 12e-3",
            disc,
            PI * 144e-6,
        ),
        (
            "shape = 'rectangle'\nlower_left = [8e-3, 5e-3]\nupper_right = [30e-3, 20e-3]",
            block,
            22e-3 * 15e-3,
        ),
    ];
    for (shape, is_inside, area) in shapes {
        let found = cut(shape);
        let places = &whole.particles().position;
        let expected: Vec<Vec2> = places.iter().copied().filter(|&x| is_inside(x)).collect();
        assert_eq!(found.particles().position, expected);
        assert!(expected.len() > 20 && expected.len() < places.len());
        // As thick as its grains, 4/3 r, the specimen would have the density of the material.
        let p = found.particles();
        let discs: f64 = p.radius.iter().map(|r| PI * r * r).sum();
        for (mass, radius) in p.mass.iter().zip(&p.radius) {
            let solid = 2700.0 * 4.0 / 3.0 * PI * radius.powi(3);
            assert!((mass * discs / (solid * area) - 1.0).abs() < 1e-12);
        }
    }
}

/// A lattice of six by twelve grains, otherwise the built-in scene.
fn lattice() -> (World, f64) {
    let draft = Draft::builtin("hexagonal-lattice-tension")
        .replacing("box.width", 12.0 * RADIUS)
        .replacing("setup.lattice.columns", 6)
        .replacing("setup.lattice.rows", 12)
        .replacing("setup.roles.driven_above", 18.5 * RADIUS)
        .replacing("driving.velocity", vec![0.0, 0.01]);
    let world = run_setup(&scene(&draft)).expect("a lattice");
    let row = 3.0_f64.sqrt() * RADIUS;
    let driven = world.particles().with_role(Role::Driven).count();
    let fixed = world.particles().with_role(Role::Fixed).count();
    assert_eq!([driven, fixed], [6, 6]);
    (world, 11.0 * row)
}

/// The sum of force times branch vector of all bonds over the volume between the outer rows, in Pa: bonds within an outer
/// row count by half, because a half of them lies outside.
fn stress(world: &World, height: f64) -> [f64; 2] {
    let p = world.particles();
    let volume = 12.0 * RADIUS * height * 2.0 * RADIUS;
    let mut sum = [0.0; 2];
    for one in world.interactions() {
        let (i, j) = one.pair.indices();
        let is_outer = p.role[i] != Role::Free && p.role[j] != Role::Free;
        let share = if is_outer { 0.5 } else { 1.0 };
        let branch = one.normal * one.distance;
        let force =
            one.normal * one.normal_force + one.normal.perpendicular() * one.tangential_force;
        sum[0] += share * force.x * branch.x;
        sum[1] += share * force.y * branch.y;
    }
    sum.map(|one| one / volume)
}

/// Elastic constants and strength of a hexagonal lattice, from the energy of its bonds.
///
/// A bond of length d and direction n stores d^2 (k_n (n e n)^2 + k_s (t e n)^2) / 2 under a strain e, with k_s = k_t / 2:
/// its two ends turn by the same angle and store k_t (d / 2)^2 each. With three bonds per grain, whose area is
/// sqrt(3) d^2 / 2, the Lame constants of the plane are sqrt(3) / 4 (k_n + k_s) and sqrt(3) / 4 (k_n - k_s).
#[test]
fn a_hexagonal_lattice_has_the_constants_of_its_bonds_and_breaks_at_their_strength() {
    let (mut world, height) = lattice();
    let (speed, thickness) = (0.01, 2.0 * RADIUS);
    let [normal, shear] = [STIFFNESS, 0.5 * STIFFNESS];
    let ratio = (normal - shear) / (3.0 * normal + shear);
    let modulus =
        3.0_f64.sqrt() / 2.0 * (1.0 - ratio * ratio) * (3.0 * normal + shear) / (2.0 * thickness);
    let strain = 1e-3;
    let step = world.model().time_step;
    advance(&mut world, (strain * height / speed / step).round() as u64);
    let [across, along] = stress(&world, height);
    // Geometric nonlinearity, of the order of the strain, with a coefficient of at most 2; the viscous stress, damping
    // over stiffness times the rate over the strain, 5e-4; the first wave, v / c over the strain, 1 %, after ten of its
    // decay times.
    let tolerance = 3e-3;
    let found = across / along;
    assert!((found / ratio - 1.0).abs() < tolerance, "{found} {ratio}");
    let found = along / strain * (1.0 - found * found);
    assert!(
        (found / modulus - 1.0).abs() < tolerance,
        "{found} {modulus}"
    );
    let force = world.drive().applied.y / (12.0 * RADIUS * thickness);
    assert!((force / along - 1.0).abs() < tolerance, "{force} {along}");

    // Inclined bonds, at 60 degrees, carry 3/4 of the strain along their normal and sqrt(3)/4 across.
    let section = PI * RADIUS * RADIUS;
    let pull = 0.75 * 2.0 * RADIUS * normal / (20e6 * section);
    let push = 3.0_f64.sqrt() / 4.0 * 2.0 * RADIUS * shear / (168e6 * section);
    let critical = 1.0 / pull.hypot(push);
    let bonds = |world: &World| world.bonds().map_or(0, |bonds| bonds.len());
    let before = bonds(&world);
    while bonds(&world) == before && world.time() < 2.0 * critical * height / speed {
        advance(&mut world, 50);
    }
    let found = world.time() * speed / height;
    // Geometric nonlinearity again, 2 times 0.42 %, and the steps between looks.
    assert!((found / critical - 1.0).abs() < 0.01, "{found} {critical}");
}

/// Grains that move with a velocity gradient; another one flies into their midst.
const FLYING: &str = r#"
[time]
step = 1e-6
end = 1e-3
integrator = "velocity-verlet"
[material]
density = 2700.0
[output]
measure = ["stress", "strain"]
"#;

fn flying(region: bool) -> Draft {
    let places = [[0.0, 0.0], [10e-3, 0.0], [0.0, 20e-3], [15e-3, 25e-3]];
    let draft = places
        .into_iter()
        .fold(Draft::parse(FLYING), |draft, [x, y]| {
            draft.grain(Grain::at([x, y], RADIUS).moving([2.0 * x - 3.0 * y, 5.0 * x - 4.0 * y]))
        });
    let draft = draft.grain(Grain::at([30e-3, 10e-3], RADIUS).moving([-15.0, 1.0]));
    match region {
        true => draft
            .with("output.strain_region.lower_left", vec![-1e-3, -1e-3])
            .with("output.strain_region.upper_right", vec![20e-3, 30e-3]),
        false => draft,
    }
}

#[test]
fn the_strain_of_a_region_is_that_of_the_grains_that_began_in_it() {
    for region in [true, false] {
        let folder = tempfile::tempdir().expect("a folder");
        let (file, out) = (folder.path().join("scene.toml"), folder.path().join("out"));
        std::fs::write(&file, flying(region).text().expect("a scene")).expect("writable");
        let [file, out] = [&file, &out].map(|path| path.display().to_string());
        let output = run(&["run", &file, "--out", &out]);
        assert!(output.status.success(), "{}", stderr(&output));
        let series = std::fs::read_to_string(format!("{out}/series.csv")).expect("a series");
        let mut rows = series.lines().map(|row| row.split(',').collect::<Vec<_>>());
        let header = rows.next().expect("a header");
        let last = rows.next_back().expect("rows");
        let strain = ["strain_xx", "strain_yy", "strain_xy"].map(|name| {
            let place = header.iter().position(|column| *column == name);
            last[place.expect("a column")]
                .parse::<f64>()
                .expect("a number")
        });
        // The gradient times 1 ms: 2, -4 and (5 - 3) / 2 per second.
        let off = [2e-3, -4e-3, 1e-3]
            .iter()
            .zip(strain)
            .map(|(a, b)| (a - b).abs());
        let farthest = off.fold(0.0, f64::max);
        assert!((farthest < 1e-12) == region, "{region} {strain:?}");
        let picture = std::fs::read_to_string(format!("{out}/stress-strain.svg"));
        assert!(picture.expect("a picture").contains("<svg"));
    }
}

/// What a run of a draft says; its status.
fn said(draft: &Draft) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), draft);
    let out = folder.path().join("out");
    let [scene, out] = [&scene, &out].map(|path| path.display().to_string());
    let output = run(&["run", &scene, "--out", &out]);
    (output.status.code(), stderr(&output))
}

/// Rows of twenty touching grains of 1 mm in a box of 40 mm by 40 mm.
fn rows(number: i64) -> Draft {
    Draft::open_box("velocity-verlet", 1e-8)
        .replacing("time.end", 1e-7)
        .with("box.width", 40e-3)
        .with("box.height", 40e-3)
        .with("setup.seed", 3)
        .with("setup.correct_density", true)
        .with("setup.sizes.minimum", RADIUS)
        .with("setup.sizes.maximum", RADIUS)
        .with("setup.lattice.columns", 20)
        .with("setup.lattice.rows", number)
}

#[test]
fn a_packing_that_does_not_fill_the_block_is_doubted() {
    // 100 discs of pi mm^2 on 1600 mm^2, and 400.
    let (status, warning) = said(&rows(5));
    assert_eq!(status, Some(0), "{warning}");
    assert!(warning.contains("multiplies masses by 5.09"), "{warning}");
    assert!(warning.contains("cover only 20 % of the box"), "{warning}");
    let (status, warning) = said(&rows(20));
    assert_eq!((status, warning.as_str()), (Some(0), ""));
}

#[test]
fn a_region_whose_strain_cannot_be_measured_is_refused_at_the_beginning() {
    let away = |draft: Draft| {
        draft
            .with("output.strain_region.lower_left", vec![1.0, 1.0])
            .with("output.strain_region.upper_right", vec![2.0, 2.0])
    };
    let measured = |draft: Draft| draft.with("output.measure", vec!["strain"]);
    let row = measured(rows(20))
        .with("output.strain_region.lower_left", vec![0.0, 0.0])
        .with("output.strain_region.upper_right", vec![40e-3, 2e-3]);
    // The grains of a row lie on a line.
    let cases = [
        (away(flying(false)), 0),
        (away(measured(rows(20))), 0),
        (row, 20),
    ];
    let words = "output.strain_region = {table}: needs at least three free grains";
    for (draft, number) in cases {
        let (status, found) = said(&draft);
        assert_eq!(status, Some(2), "{found}");
        assert!(
            found.contains("scene.toml:") && found.contains(words),
            "{found}"
        );
        assert!(
            found.contains(&format!("there are {number} at t = 0")),
            "{found}"
        );
    }
}

#[test]
fn stress_over_strain_ends_where_the_specimen_fails() {
    let rows = [
        "0,0.0,0,0.0,0",
        "1,0.1,1,-0.2,-50",
        "2,0.2,2,-0.4,-90",
        "3,0.2,40,-0.5,-60",
        "4,9.0,3,-7.0,-30",
        "5,9.0,3,-8.0,-80",
    ];
    let header = "time,strain_xx,stress_xx,strain_yy,stress_yy";
    let series = format!("{header}\n{}\n", rows.join("\n"));
    let figure = stress_strain(&Columns::of(series.as_bytes())).expect("a figure");
    let points = |curve: usize| &figure.curves[curve].points;
    let along = [[0.0, 0.0], [-0.2, -50.0], [-0.4, -90.0], [-0.5, -60.0]];
    assert_eq!(points(1)[..], along);
    assert_eq!(points(0).len(), along.len());
}
