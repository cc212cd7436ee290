//! Where inputs are refused, to the last digits, and the value that the error names.

use crate::cloud::{H, at_rest, contact, grain, lattice, material, settings, walls};
use crate::generators::{plain, point, ring};
use gouge_common::geometry::Vec2;
use gouge_peridem::contact_law::{ContactLaw, ContactMaterial, ContactStiffness};
use gouge_peridem::error::SetupError;
use gouge_peridem::forces::Walls;
use gouge_peridem::grain::Grains;
use gouge_peridem::interior::{Interceptors, SectionFive};
use gouge_peridem::limits::Limits;
use gouge_peridem::material::{Material, Weight};
use gouge_peridem::mesh::Mesh;
use gouge_peridem::shape::Outline;
use gouge_peridem::wall_law::WallLaw;
use gouge_peridem::world::{Beginning, World};
use std::fmt::Debug;

/// Just above one, by less than a millionth.
const ABOVE: f64 = 1.0 + 5e-7;

/// Name and value of a refused parameter.
fn named<T: Debug>(result: Result<T, SetupError>) -> (&'static str, f64) {
    match result {
        Err(SetupError::Parameter { name, value, .. }) => (name, value),
        other => panic!("{other:?}"),
    }
}

#[test]
fn parameters_of_materials_are_named_with_their_values() {
    let of = |change: fn(&mut Material)| {
        let mut material = material();
        change(&mut material);
        material.bond_constants(Weight::Constant, 1e-3)
    };
    let young = named(of(|one| one.young_modulus = -3.0));
    assert_eq!(young, ("young_modulus", -3.0));
    assert_eq!(named(of(|one| one.density = -3.0)), ("density", -3.0));
    let energy = named(of(|one| one.fracture_energy = -3.0));
    assert_eq!(energy, ("fracture_energy", -3.0));
    assert_eq!(
        named(of(|one| one.poisson_ratio = 0.7)),
        ("poisson_ratio", 0.7)
    );
    assert!(of(|one| one.poisson_ratio = -1.0).is_err());
    assert!(of(|one| one.poisson_ratio = -1.0 + 1e-9).is_ok());
    assert!(of(|one| one.poisson_ratio = 0.5).is_err());
    assert!(of(|one| one.poisson_ratio = 0.5 - 1e-9).is_ok());
    let horizon = material().bond_constants(Weight::Constant, -3.0);
    assert_eq!(named(horizon), ("horizon", -3.0));
}

#[test]
fn products_of_parameters_are_accepted_from_1e_100_to_1e100() {
    // The squares of the speed of waves of these materials; their bonds are of medium stiffness.
    let of = |young_modulus: f64, speed_squared: f64| {
        let material = Material {
            young_modulus,
            density: young_modulus / speed_squared,
            ..material()
        };
        material.bond_constants(Weight::Constant, 1e-3)
    };
    for (inside, outside) in [
        (1e-100 * ABOVE, 1e-100 / ABOVE),
        (1e100 / ABOVE, 1e100 * ABOVE),
    ] {
        assert!(of(1.0, inside).is_ok(), "{inside:e}");
        match of(1.0, outside) {
            Err(SetupError::Product {
                name: "density",
                value,
                result,
                ..
            }) => assert_eq!([value, result], [1.0 / outside, 1.0 / (1.0 / outside)]),
            other => panic!("{other:?}"),
        }
        assert!(of(1e10, inside).is_ok() && of(1e10, outside).is_err());
    }
    let unbreakable = Material {
        young_modulus: 1e-30,
        density: 1.0,
        fracture_energy: 1e308,
        ..material()
    };
    match unbreakable.bond_constants(Weight::Constant, 1e-3) {
        Err(SetupError::Product { name, value, .. }) => {
            assert_eq!((name, value), ("fracture_energy", 1e308));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn parameters_of_contacts_are_named_with_their_values() {
    let good = contact(1.0, 0.0).law;
    let of = |change: fn(&mut ContactLaw)| {
        let mut law = good;
        change(&mut law);
        law.validate()
    };
    assert!(of(|_| ()).is_ok() && of(|law| law.damping_ratio = 0.0).is_ok());
    assert_eq!(named(of(|law| law.radius = -3.0)), ("contact radius", -3.0));
    for wrong in [ABOVE, -1e-9] {
        let law = ContactLaw {
            damping_ratio: wrong,
            ..good
        };
        assert_eq!(named(law.validate()), ("damping ratio", wrong));
    }
    assert_eq!(named(of(|law| law.friction = -3.0)), ("friction", -3.0));
    let side = ContactMaterial {
        material: material(),
        bulk_modulus: 1.0,
        horizon: 1e-3,
    };
    let between = ContactStiffness::Published.between(&side, &side, -3.0);
    assert_eq!(named(between), ("contact radius", -3.0));
    let given = ContactStiffness::Given(-3.0).between(&side, &side, 1.0);
    assert_eq!(named(given), ("contact stiffness", -3.0));
}

#[test]
fn contacts_need_a_stiffness_for_every_material() {
    let mut block = grain(lattice(2, 2), 1.5, Weight::Constant);
    block.material = 1;
    let grains = Grains::new(&[block]).unwrap();
    let mut contact = contact(0.0, 0.0);
    assert!(contact.validate(&grains).is_err());
    contact.stiffness = vec![vec![1.0, 1.0], vec![1.0, -3.0]];
    assert_eq!(
        named(contact.validate(&grains)),
        ("contact stiffness", -3.0)
    );
    contact.stiffness[1][1] = 2.0;
    assert!(contact.validate(&grains).is_ok());
}

#[test]
fn contact_radii_are_refused_below_the_smallest_safe_one() {
    let grains = Grains::new(&[grain(lattice(3, 3), 1.5, Weight::Constant)]).unwrap();
    let check = |ratio: f64| {
        let mut contact = contact(0.0, 0.0);
        contact.law.radius = ratio * H;
        contact.check_radius(&grains)
    };
    assert!(check(1.2 * (1.0 + 1e-9)).is_ok());
    let expected = SetupError::ContactRadius {
        radius: 1.2 * (1.0 - 1e-9) * H,
        smallest: H,
    };
    assert_eq!(check(1.2 * (1.0 - 1e-9)), Err(expected));
    // Nodes of the finer grain would pass between those of the coarser one.
    let coarse = lattice(3, 3)
        .iter()
        .map(|&at| at * 2.0 + Vec2::new(9.0, 0.0) * H)
        .collect();
    let fine = grain(lattice(3, 3), 1.5, Weight::Constant);
    let grains = Grains::new(&[fine, grain(coarse, 3.0, Weight::Constant)]).unwrap();
    let mut contact = contact(0.0, 0.0);
    contact.law.radius = 2.4 * (1.0 - 1e-9) * H;
    assert!(contact.check_radius(&grains).is_err());
    contact.law.radius = 2.4 * (1.0 + 1e-9) * H;
    assert!(contact.check_radius(&grains).is_ok());
}

#[test]
fn parameters_of_walls_are_named_with_their_values() {
    let good = walls(1.0, 0.0).law;
    let of = |change: fn(&mut WallLaw)| {
        let mut law = good;
        change(&mut law);
        law.validate()
    };
    assert!(of(|_| ()).is_ok() && of(|law| law.damping_ratio = 0.0).is_ok());
    assert_eq!(named(of(|law| law.radius = -3.0)), ("contact radius", -3.0));
    let stiffness = named(of(|law| law.stiffness = -3.0));
    assert_eq!(stiffness, ("contact stiffness", -3.0));
    for wrong in [ABOVE, -1e-9] {
        let law = WallLaw {
            damping_ratio: wrong,
            ..good
        };
        assert_eq!(named(law.validate()), ("damping ratio", wrong));
    }
    assert_eq!(named(of(|law| law.friction = -3.0)), ("friction", -3.0));
}

#[test]
fn walls_are_more_than_two_contact_radii_apart() {
    let mut walls = walls(0.0, 0.0);
    walls.law.radius = 1.0;
    let check = |walls: &Walls, [left, right, top, bottom]: [f64; 4]| {
        walls.validate(&[left, right, top, bottom]).is_ok()
    };
    let wide = 1e-6;
    assert!(!check(&walls, [4.0, 6.0, 50.0, -50.0]));
    assert!(check(&walls, [4.0, 6.0 + wide, 50.0, -50.0]));
    assert!(!check(&walls, [-50.0, 50.0, 6.0, 4.0]));
    assert!(check(&walls, [-50.0, 50.0, 6.0 + wide, 4.0]));
    let none = f64::INFINITY;
    assert!(check(&walls, [-none, none, none, -none]));
    assert!(check(&walls, [0.0, none, none, 0.0]));
    walls.velocity[2] = f64::NAN;
    assert!(!check(&walls, [-50.0, 50.0, 50.0, -50.0]));
}

#[test]
fn time_steps_are_accepted_up_to_the_smallest_limit() {
    let (all, state) = at_rest(&[grain(lattice(4, 4), 2.5, Weight::Constant)]);
    let begin = |step: f64| {
        World::within_limits(all.clone(), settings(step), state.clone(), Beginning::Given)
    };
    let limits = Limits::of(&all, &state.bonds, &settings(1e-9));
    let value = limits.bonds.exact;
    assert_eq!(limits.smallest(), ("bonds", value));
    assert!(begin(value).is_ok());
    let step = value * (1.0 + 1e-9);
    let expected = SetupError::TimeStep {
        step,
        limit: "bonds",
        value,
    };
    assert_eq!(begin(step).err(), Some(expected));
    assert_eq!(named(begin(-3.0)), ("time_step", -3.0));
    let forced = World::new(all.clone(), settings(0.0), state.clone(), Beginning::Given);
    assert_eq!(named(forced), ("time_step", 0.0));
}

#[test]
fn every_limit_is_named() {
    let limits = Limits {
        bonds: gouge_peridem::limits::BondLimits {
            exact: 4.0,
            row_sum: 1.0,
        },
        contact: 3.0,
        damping: 2.0,
        walls: 5.0,
    };
    let expected = [
        ("bonds", 4.0),
        ("contact", 3.0),
        ("damping", 2.0),
        ("walls", 5.0),
    ];
    assert_eq!(limits.named(), expected);
    assert_eq!(limits.smallest(), ("damping", 2.0));
}

#[test]
fn grains_with_wrong_columns_are_refused() {
    let of = |change: fn(&mut gouge_peridem::grain::Grain)| {
        let mut block = grain(lattice(2, 2), 1.5, Weight::Constant);
        change(&mut block);
        Grains::new(&[grain(lattice(2, 2), 1.5, Weight::Constant), block])
    };
    assert!(of(|_| ()).is_ok());
    assert_eq!(named(of(|one| one.density = -3.0)), ("density", -3.0));
    assert_eq!(named(of(|one| one.area[2] = -3.0)), ("area", -3.0));
    let infinite = |one: &mut gouge_peridem::grain::Grain| one.position[1].y = f64::INFINITY;
    assert_eq!(named(of(infinite)), ("y", f64::INFINITY));
    let empty = |one: &mut gouge_peridem::grain::Grain| {
        one.position.clear();
        one.area.clear();
    };
    assert_eq!(of(empty), Err(SetupError::NoNodes { grain: 1 }));
    let (grain, nodes) = (1, 4);
    let length = |column, length| SetupError::Length {
        grain,
        column,
        length,
        nodes,
    };
    let areas = of(|one| {
        one.area.pop();
    });
    assert_eq!(areas, Err(length("area", 3)));
    let loads = of(|one| one.load = vec![Vec2::zero(); 5]);
    assert_eq!(loads, Err(length("load", 5)));
}

#[test]
fn clamped_nodes_exist() {
    for node in [4, 5] {
        let mut block = grain(lattice(2, 2), 1.5, Weight::Constant);
        block.clamped = vec![3, node];
        let expected = SetupError::MissingNode {
            grain: 0,
            node,
            nodes: 4,
        };
        assert_eq!(Grains::new(&[block]), Err(expected));
    }
}

#[test]
fn parameters_of_shapes_are_named_with_their_values() {
    let numbers = [0.0, 1.0, 0.5, 0.25];
    for wrong in [0.0, -3.0] {
        assert_eq!(named(Outline::disc(wrong, 8)), ("radius", wrong));
        assert_eq!(named(Outline::square(wrong)), ("radius", wrong));
        assert_eq!(named(Outline::plus(wrong, 0.5)), ("radius", wrong));
    }
    for wrong in [0.0, -3.0, 1.0] {
        assert_eq!(named(Outline::plus(1.0, wrong)), ("ratio", wrong));
        assert_eq!(named(Outline::annulus(1.0, wrong, 8)), ("ratio", wrong));
    }
    let nearly = 1.0 - 5e-7;
    assert!(Outline::annulus(1.0, nearly, 8).is_ok() && Outline::plus(1.0, nearly).is_ok());
    for wrong in [0.0, -3.0, ABOVE] {
        let found = named(Outline::perturbed_disc(1.0, wrong, &numbers));
        assert_eq!(found, ("roundness", wrong));
    }
    assert!(Outline::perturbed_disc(1.0, 1.0, &numbers).is_ok());
    for wrong in [-1e-9, ABOVE] {
        let found = named(Outline::perturbed_disc(1.0, 0.5, &[0.5, wrong, 0.5]));
        assert_eq!(found, ("uniform number", wrong));
    }
    let square = Outline::square(1.0).unwrap();
    assert_eq!(named(square.scaled(-3.0)), ("factor", -3.0));
    let method = SectionFive::new(&square, -3.0, Interceptors::Bisectors);
    assert_eq!(named(method), ("distance", -3.0));
}

#[test]
fn coordinates_are_accepted_up_to_their_bounds() {
    let is_accepted = |x: f64, y: f64| {
        let corners = vec![point(0.0, 0.0), point(x, 0.0), point(0.0, y)];
        Outline::new(corners, Vec::new(), Vec::new()).is_ok()
    };
    for (within, beyond) in [(1e60, 1e60_f64.next_up()), (1e-60, 1e-60_f64.next_down())] {
        for sign in [1.0, -1.0] {
            assert!(is_accepted(sign * within, within) && is_accepted(within, sign * within));
            assert!(!is_accepted(sign * beyond, within) && !is_accepted(within, sign * beyond));
        }
    }
}

#[test]
fn parameters_of_meshes_are_named_with_their_values() {
    let square = Outline::square(1.0).unwrap();
    let rectangle = |columns, spacing| Mesh::rectangle(columns, 1, spacing, Vec2::zero());
    assert_eq!(named(rectangle(1, -3.0)), ("spacing", -3.0));
    assert_eq!(named(rectangle(0, 1.0)), ("number of cells", 0.0));
    assert_eq!(rectangle(1, 2.0).unwrap().area, [4.0]);
    let lattice = |size| Mesh::lattice(&square, size, Vec2::zero());
    assert_eq!(named(lattice(-3.0)), ("spacing", -3.0));
    assert_eq!(named(Mesh::triangulated(&square, -3.0)), ("size", -3.0));
    let size = |result: Result<Mesh, SetupError>| match result {
        Err(SetupError::Mesh { size, .. }) => size,
        other => panic!("{other:?}"),
    };
    assert_eq!(size(lattice(1e-9)), 1e-9);
    assert_eq!(size(Mesh::lattice(&square, 10.0, point(5.0, 5.0))), 10.0);
    assert_eq!(size(Mesh::triangulated(&square, 1e-9)), 1e-9);
    assert_eq!(size(rectangle(4_000_001, 0.25)), 0.25);
}

/// Meshes with one to three nodes or cells above four million are refused.
#[test]
fn meshes_of_slightly_more_than_four_million_nodes_are_refused() {
    assert!(Mesh::rectangle(4_000_001, 1, 1.0, Vec2::zero()).is_err());
    // A margin of one cell on either side, and a column and a row of points at the ends: 666 667 x 6 cells.
    let strip = plain(ring(&[
        (0.0, 0.0),
        (666_664.0, 0.0),
        (666_664.0, 3.0),
        (0.0, 3.0),
    ]));
    assert!(Mesh::lattice(&strip, 1.0, Vec2::zero()).is_err());
    // Nodes on the boundary and points of a triangular lattice, with two sides that are halfway between 1859 and 1860.
    let (width, height) = (1859.5, 1859.0);
    let cell = 0.75_f64.sqrt();
    let others = (4.0e6 + 1.0 - 2.0 * (1860.0 + height)) * cell / width;
    assert!(others > height - 0.5 && others < height + 0.5, "{others}");
    let outline = plain(ring(&[
        (0.0, 0.0),
        (width, 0.0),
        (width, others),
        (0.0, others),
    ]));
    assert!(Mesh::triangulated(&outline, 1.0).is_err());
}
