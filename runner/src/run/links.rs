//! All contacts and bonds of a state as a table.

use super::table::{Column, Kinds, Table, Values};
use gouge_dem::World;
use gouge_dem::forces::{Interaction, InteractionKind};

/// A quantity of a link and the name of its column.
type Quantity = (&'static str, fn(&Interaction) -> f64);

/// The quantities in the order of their columns.
const QUANTITIES: [Quantity; 16] = [
    ("overlap_factor", |link| link.overlap_factor),
    ("focal_x", |link| link.focal_point.x),
    ("focal_y", |link| link.focal_point.y),
    ("normal_x", |link| link.normal.x),
    ("normal_y", |link| link.normal.y),
    ("normal_displacement", |link| link.normal_displacement),
    ("adjusted_normal_displacement", |link| {
        link.adjusted_normal_displacement
    }),
    ("tangential_displacement_i", |link| {
        link.tangential_displacement[0]
    }),
    ("tangential_displacement_j", |link| {
        link.tangential_displacement[1]
    }),
    ("normal_velocity", |link| link.normal_velocity),
    ("tangential_velocity_i", |link| link.tangential_velocity[0]),
    ("tangential_velocity_j", |link| link.tangential_velocity[1]),
    ("normal_force", |link| link.normal_force),
    ("tangential_force", |link| link.tangential_force),
    ("torque_i", |link| link.torque[0]),
    ("torque_j", |link| link.torque[1]),
];

/// All contacts and bonds of a world, sorted by pair: the columns `i`, `j`, `kind` and all quantities.
pub fn links_of(world: &World) -> Table {
    table_of_links(&sorted(world))
}

/// All contacts and bonds of a world, sorted by pair.
pub fn sorted(world: &World) -> Vec<Interaction> {
    let mut links = world.interactions();
    links.sort_by_key(|link| link.pair.indices());
    links
}

/// The table of some links.
pub fn table_of_links(links: &[Interaction]) -> Table {
    let integers = |of: fn(&Interaction) -> u32| {
        Values::Integers(links.iter().map(|link| of(link) as usize).collect())
    };
    let codes = links.iter().map(|link| match link.kind {
        InteractionKind::Contact => 0,
        InteractionKind::Bond => 1,
    });
    let kinds = Kinds {
        names: vec!["weak", "strong"],
        codes: codes.collect(),
    };
    let mut columns = vec![
        ("i", integers(|link| link.pair.i)),
        ("j", integers(|link| link.pair.j)),
        ("kind", Values::Kinds(kinds)),
    ];
    let numbers = |&(name, of): &Quantity| -> Column {
        (name, Values::Numbers(links.iter().map(of).collect()))
    };
    columns.extend(QUANTITIES.iter().map(numbers));
    Table { columns }
}
