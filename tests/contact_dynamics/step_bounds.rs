//! Bounds of steps, cells and preparation, and numbers that cells are made of.

use crate::refusals::{LESS, MORE};
use crate::systems::{System, law, moving};
use core::f64::consts::{FRAC_PI_2, PI};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_contact_dynamics::assembly::Body;
use gouge_contact_dynamics::cell::{Cell, Drive, LOWER, Settling, UPPER};
use gouge_contact_dynamics::detection::Feature;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::preparation::{Deposited, Filling, deposit, glue, inscribe};
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use gouge_contact_dynamics::warm_start::PointKey;

const REST: Velocity = Velocity {
    linear: Vec2 { x: 0.0, y: 0.0 },
    angular: 0.0,
};

/// A disc above a floor by a gap, after a step at rest.
fn above_floor(gap: f64, rule: GapRule) -> System {
    let mut system = System::new(1e-3, law(0.4, 0.0, rule));
    system.body(0, 0.5, (0.0, 0.5 + gap), 0.0, REST);
    system.floor(0.0);
    system
}

/// Where only closed points count, those are closed whose gap is within the tie distance, and their gap is none.
#[test]
fn closed_points_are_within_the_tie_distance() {
    for (factor, points) in [(LESS, 1), (MORE, 0)] {
        let mut closed = above_floor(1e-3 * factor, GapRule::Closed);
        closed.settings.detection.tie_distance = 1e-3;
        assert_eq!(closed.step().points, points);
        let mut near = above_floor(1e-4 * factor, GapRule::Closed);
        near.settings.detection.tie_distance = 1e-3;
        near.settings.detection.alert_distance = 1e-4;
        assert_eq!(near.step().points, points);
        assert_eq!(
            above_floor(0.02 * factor, GapRule::Predicted).step().points,
            points
        );
    }
    let overlap = above_floor(-0.01, GapRule::Closed).step().largest_overlap;
    assert!((overlap - 0.01).abs() < 1e-15);
}

#[test]
fn the_largest_overlap_is_reported() {
    for depths in [[0.01, 0.004], [0.004, 0.01]] {
        let mut system = System::new(1e-3, law(0.4, 0.0, GapRule::Predicted));
        for (k, depth) in depths.into_iter().enumerate() {
            system.body(0, 0.5, (3.0 * k as f64, 0.5 - depth), 0.0, REST);
        }
        system.floor(0.0);
        assert!((system.step().largest_overlap - 0.01).abs() < 1e-15);
    }
}

/// An impulse follows a point that moved on its body by less than the distance of warm starts.
#[test]
fn impulses_follow_points_within_the_distance_of_warm_starts() {
    for (factor, kept) in [(LESS, 5.0), (MORE, 0.0)] {
        let mut system = above_floor(0.0, GapRule::Predicted);
        let key = PointKey {
            pair: Pair::new(0, 1),
            feature: Feature::of_first(7),
            place: Vec2::new(0.3 * factor, -0.5),
        };
        let impulse = Components { n: 5.0, t: 0.0 };
        system.state.memory.push(key, impulse);
        system.settings.sweeps.max_sweeps = 0;
        system.step();
        assert_eq!(system.impulses()[0].n, kept);
    }
}

#[test]
fn walls_move_with_their_velocities() {
    let roof = InverseMass {
        y: 1.0,
        ..InverseMass::IMPOSED
    };
    let cell = Cell::new(7.0, 3.0, roof, Shapes::new()).unwrap();
    assert_eq!((cell.width(), cell.height()), (7.0, 3.0));
    let mut configuration = cell.state.configuration;
    configuration.velocity[UPPER as usize] = moving(0.3, -0.2, 0.0);
    configuration.advance(&cell.assembly, 0.5);
    assert_eq!(
        configuration.wall[UPPER as usize].position,
        Vec2::new(0.15, 2.9)
    );
}

/// A packing has settled once the roof moves less than the distance within a window.
#[test]
fn settling_compares_heights() {
    let drive = Drive::Compaction {
        normal_stress: 1.0,
        largest_speed: 1.0,
        slowing: 0.9,
        window: 10,
        settled_distance: 0.05,
    };
    for (factor, is_settled) in [(LESS, true), (MORE, false)] {
        for sign in [-1.0, 1.0] {
            let moved = 3.0 + sign * 0.05 * factor;
            let mut settling = Settling::from_height(3.0);
            settling.follow(&drive, 5, 9.0);
            settling.follow(&drive, 10, moved);
            assert_eq!(settling.is_settled, is_settled);
            settling.follow(&drive, 20, 4.0);
            settling.follow(&drive, 30, 4.0 + sign * 0.05 * factor);
            assert_eq!(settling.is_settled, is_settled);
        }
    }
}

/// Bodies filled into circles have their sizes, and the roof lies on the highest circle.
#[test]
fn filled_circles_have_the_sizes_of_a_deposit() {
    let deposited = Deposited {
        centres: vec![Vec2::new(1.0, 0.4), Vec2::new(3.0, 0.9)],
        height: 1.6,
    };
    let filling = Filling {
        sides: None,
        density: 3.0,
        roof_mass: 2.0,
    };
    let cell = inscribe(&deposited, &[0.8, 1.4], 5.0, &filling, || 0.25).unwrap();
    assert_eq!((cell.width(), cell.height()), (5.0, 1.6));
    let (assembly, configuration) = (&cell.assembly, &cell.state.configuration);
    assert_eq!(configuration.position, deposited.centres);
    let near = |x: f64, y: f64| assert!((x / y - 1.0).abs() < 1e-14, "{x} {y}");
    near(1.0 / assembly.inverse_mass[UPPER as usize].y, 10.0);
    for (body, radius) in [(0, 0.4), (1, 0.7)] {
        assert_eq!(configuration.angle[body], FRAC_PI_2);
        near(assembly.area(body), PI * radius * radius);
        let mass = assembly.inverse_mass[assembly.unit[body] as usize];
        near(1.0 / mass.x, 3.0 * PI * radius * radius);
    }
}

/// Discs at a distance from the floor and from the roof, and one in the middle.
fn between(distance: f64) -> Cell {
    let mut shapes = Shapes::new();
    let shape = shapes.add_regular(4).unwrap();
    let mut cell = Cell::new(9.0, 5.0, InverseMass::IMPOSED, shapes).unwrap();
    for (k, y) in [0.5 + distance, 4.5 - distance, 2.5]
        .into_iter()
        .enumerate()
    {
        let body = Body {
            shape,
            scale: 0.5,
            position: Vec2::new(3.0 * k as f64, y),
            angle: 0.0,
        };
        let configuration = &mut cell.state.configuration;
        cell.assembly
            .add_free(configuration, body, 1.0, REST)
            .unwrap();
    }
    cell
}

#[test]
fn bodies_within_the_distance_are_glued() {
    let cell = glue(&between(0.1 * LESS), 0.1, 3.0).unwrap();
    assert_eq!(cell.assembly.unit[..2], [LOWER, UPPER]);
    let roof = cell.assembly.inverse_mass[UPPER as usize].y;
    // A square with a diagonal of 1 m.
    assert!((1.0 / roof - 1.5).abs() < 1e-14);
    assert!(glue(&between(0.1 * MORE), 0.1, 3.0).is_err());
}

/// Height of the lowest place for a small disc in a deposit of rows of four discs and one more disc, and that of the
/// deposit without it.
fn small_disc(rows: usize, last: f64) -> [f64; 2] {
    let mut diameters = vec![1.0; 4 * rows];
    diameters.push(last);
    let height = deposit(&diameters, 4.0).unwrap().height;
    diameters.push(0.1);
    let centres = deposit(&diameters, 4.0).unwrap().centres;
    [centres[4 * rows + 1].y, height]
}

/// Holes deeper than six largest diameters below the highest point stay empty: the diameter of the last disc, which lies
/// highest, decides which hole a small disc finds.
#[test]
fn holes_are_filled_to_a_depth_of_six_discs() {
    for rows in [6, 7] {
        let (mut low, mut high) = (0.5, 1.0);
        let [deep, _] = small_disc(rows, low);
        assert!(small_disc(rows, high)[0] > deep + 0.01);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if small_disc(rows, middle)[0] < deep + 1e-9 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let [_, height] = small_disc(rows, low);
        assert!(
            (height - deep - 6.0).abs() < 1e-9,
            "{rows}: {height} {deep}"
        );
    }
}

/// Between two touching discs and the floor there is room for a quarter of their size; a disc that is a little larger
/// lies on the floor beside them.
#[test]
fn no_disc_lies_in_the_floor() {
    for factor in [1.0 - 1e-7, 1.0 + 1e-7] {
        let small = 0.25 * factor;
        let y = deposit(&[1.0, 1.0, small], 8.0).unwrap().centres[2].y;
        assert!((y - 0.5 * small).abs() < 1e-14, "{y}");
    }
}

/// Circles around and inside: those of a disc are itself, those of a square have half its diagonal and half its side.
#[test]
fn radii_of_shapes() {
    let mut shapes = Shapes::new();
    let (disc, square) = (shapes.add_disc(), shapes.add_regular(4).unwrap());
    let measures = shapes.outline(disc).measures;
    assert_eq!((measures.circumradius, measures.inradius), (1.0, 1.0));
    let measures = shapes.outline(square).measures;
    assert!((measures.circumradius - 1.0).abs() < 1e-15);
    assert!((measures.inradius - 0.5f64.sqrt()).abs() < 1e-15);
}
