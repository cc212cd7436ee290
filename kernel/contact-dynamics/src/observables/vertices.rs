//! Contacts at which two polygons meet with their vertices.

use super::Contact;
use crate::assembly::{Assembly, Configuration};
use crate::detection::{Placed, separating_side};
use gouge_common::geometry::Vec2;

/// Number of contacts at which two polygons overlap with a vertex each: one vertex of either lies in the other, and the two
/// are at most twice as far apart as the overlap is deep. Where sides overlap they are farther apart.
///
/// # Errata and departures
/// Figure 2 of azema resolves such an overlap into two side-vertex contacts. Here it is a contact with the normal of the side
/// that separates most, which is fair only as long as these contacts are rare.
pub fn vertex_vertex_contacts(
    assembly: &Assembly,
    configuration: &Configuration,
    contacts: &[Contact],
) -> usize {
    let placed = |body: u32| {
        let body = body as usize;
        let outline = assembly.shapes.outline(assembly.shape[body]);
        Placed::new(outline, assembly.scale[body], configuration.angle[body])
    };
    let is_one = |contact: &&Contact| {
        let [first, second] = [contact.first, contact.second].map(placed);
        meet_with_vertices(&first, &second, contact.vector(contact.branch))
    };
    contacts.iter().filter(is_one).count()
}

/// Whether two shapes, the second displaced by `d`, overlap with a vertex each.
fn meet_with_vertices(first: &Placed, second: &Placed, d: Vec2) -> bool {
    if first.disc_radius().or(second.disc_radius()).is_some() {
        return false;
    }
    let (Some(one), Some(other)) = (vertex_in(first, second, d), vertex_in(second, first, -d))
    else {
        return false;
    };
    let separation = |a, b, d| separating_side(a, b, d, f64::INFINITY).separation;
    let depth = -separation(first, second, d).max(separation(second, first, -d));
    (one - (d + other)).norm() <= 2.0 * depth
}

/// The place, from the centre of polygon `a`, of the vertex of polygon `b` that lies in `a`; none unless there is exactly
/// one.
fn vertex_in(a: &Placed, b: &Placed, d: Vec2) -> Option<Vec2> {
    let places = (0..b.outline.vertices.len()).map(|k| d + b.to_space(b.vertex(k)));
    let mut inside = places.filter(|&place| {
        let place = a.to_body(place);
        let mut sides = a.outline.sides.iter().enumerate();
        sides.all(|(k, side)| side.normal.dot(place) <= a.offset(k))
    });
    inside.next().filter(|_| inside.next().is_none())
}
