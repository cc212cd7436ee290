//! Contacts by the direction of their normals, and contacts of two vertices.

use crate::observables::{FRICTION, components, random_contacts};
use crate::systems::{System, law};
use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::observables::{AngularSums, Contact, vertex_vertex_contacts};
use gouge_contact_dynamics::units::Velocity;

#[test]
fn bins_return_from_their_columns() {
    let mut sums = AngularSums::new();
    sums.add(&random_contacts(300, 5));
    let values = sums.values();
    assert_eq!(values.len(), AngularSums::names().len());
    assert_eq!(AngularSums::from_values(&values), Some(sums));
    assert_eq!(AngularSums::from_values(&values[1..]), None);
}

/// Contacts of two hexagons with a circumscribed radius of 1 m of which two vertices meet: the second one is at a distance
/// in m along x and y, and turned by an angle in rad.
fn meetings(distance: [f64; 2], angle: f64) -> usize {
    let mut system = System::new(1e-3, law(FRICTION, 0.0, GapRule::Predicted));
    let [x, y] = distance;
    for (at, angle) in [((0.0, 0.0), 0.0), ((x, y), angle)] {
        system.body(6, 1.0, at, angle, Velocity::default());
    }
    let contact = Contact {
        first: 0,
        second: 1,
        normal: Vec2::new(1.0, 0.0),
        branch: components(x, y),
        ..random_contacts(1, 1)[0]
    };
    vertex_vertex_contacts(&system.assembly, &system.state.configuration, &[contact])
}

#[test]
fn vertices_meet_tip_to_tip_only() {
    // Vertices of both are on the x axis.
    assert_eq!(meetings([1.99, 0.0], 0.0), 1);
    // Turned around its vertex, which is moved by (-0.01, 0.002).
    assert_eq!(
        meetings([0.99 + 0.1f64.cos(), 0.002 + 0.1f64.sin()], 0.1),
        1
    );
    // A side of the second one faces the vertex.
    assert_eq!(meetings([1.86, 0.1], PI / 6.0), 0);
    // Two parallel sides overlap in part: a vertex of each lies in the other.
    let normal = [3f64.sqrt() / 2.0, 0.5];
    let along = 0.3;
    let deep = 2.0 * normal[0] - 0.01;
    let place = [
        deep * normal[0] - along * normal[1],
        deep * normal[1] + along * normal[0],
    ];
    assert_eq!(meetings(place, 0.0), 0);
    // Apart.
    assert_eq!(meetings([2.01, 0.0], 0.0), 0);
}
