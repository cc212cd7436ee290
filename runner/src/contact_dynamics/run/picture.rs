//! The picture of a state: bodies, and the forces between them as lines between their centres.

use super::super::Scene;
use super::super::scene::Role;
use super::frame::{outline, role};
use super::statistics::{is_free, update};
use crate::run::picture::{View, framed, rounded};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::observables::{Contact, ContactKind, Network};
use gouge_contact_dynamics::world::World;
use svg::Document;
use svg::node::element::{Group, Line, Polygon, SVG};

/// Colour of the forces of side-vertex contacts.
const SIDE_VERTEX: &str = "#d55e00";
/// Colour of the forces of side-side contacts.
const SIDE_SIDE: &str = "#009e73";
/// Width of the line of the mean force, in mean diameters.
const WIDTH: f64 = 0.08;

/// The state of a scene as a picture with a scale bar.
pub fn draw(scene: &Scene, world: &World) -> Document {
    let corners: Vec<Vec<Vec2>> = (0..world.assembly().shape.len())
        .map(|body| outline(world, body))
        .collect();
    let positions = &world.state().configuration.position;
    let ends = positions.iter().zip(&corners);
    let points = ends.flat_map(|(&x, corners)| corners.iter().map(move |&corner| x + corner));
    let view = View::around(points, scene.domain.period());
    let mut network = Network::new();
    update(scene, world, &mut network);
    let title = format!("{}, t = {:.6e} s", scene.title, world.time());
    let parts = [
        bodies(scene, world, &view, &corners, network.counts()),
        forces(scene, world, &view, &network),
    ];
    framed(&view, &title, parts.map(|part| clipped(&view, part)))
}

/// A part of the picture without what is beyond the view: a nested picture shows nothing outside of itself.
fn clipped(view: &View, part: Group) -> Group {
    let [width, height] = view.size();
    let inner = SVG::new()
        .set("width", rounded(width))
        .set("height", rounded(height));
    Group::new().add(inner.add(part))
}

fn bodies(
    scene: &Scene,
    world: &World,
    view: &View,
    corners: &[Vec<Vec2>],
    counts: &[u32],
) -> Group {
    let assembly = world.assembly();
    let mut group = Group::new().set("stroke", "#222").set("stroke-width", 0.4);
    for (body, corners) in corners.iter().enumerate() {
        let floats = is_free(assembly, body) && counts[body] < 2;
        let fill = match role(scene, assembly, body) {
            Role::Free if floats => "#ccc",
            Role::Free => "#fff",
            Role::Roof => "#aaa",
            Role::Fixed | Role::Floor => "#777",
        };
        let position = world.state().configuration.position[body];
        for position in images(scene, position, corners) {
            let place = |&corner: &Vec2| {
                let [x, y] = view.at(position.x + corner.x, position.y + corner.y);
                format!("{},{}", rounded(x), rounded(y))
            };
            let points: Vec<String> = corners.iter().map(place).collect();
            let polygon = Polygon::new()
                .set("points", points.join(" "))
                .set("fill", fill);
            group = group.add(polygon);
        }
    }
    group
}

/// The position of a body, and that of its image if it extends beyond a side of the periodic box.
fn images(scene: &Scene, position: Vec2, corners: &[Vec2]) -> Vec<Vec2> {
    let mut images = vec![position];
    if let Some(width) = scene.domain.period() {
        let beyond = |shift: f64| {
            let x = |corner: &Vec2| position.x + corner.x + shift;
            corners
                .iter()
                .any(|corner| (0.0..width).contains(&x(corner)))
        };
        let shifts = [-width, width].into_iter().filter(|&shift| beyond(shift));
        images.extend(shifts.map(|shift| position + Vec2::new(shift, 0.0)));
    }
    images
}

/// Lines between centres, as wide as the normal force is large; across the periodic boundary at both sides.
fn forces(scene: &Scene, world: &World, view: &View, network: &Network) -> Group {
    let contacts = network.contacts();
    let sum: f64 = contacts.iter().map(|contact| contact.force.n).sum();
    let mean = sum / contacts.len().max(1) as f64;
    let unit = WIDTH * super::statistics::mean_diameter(world.assembly()) * view.scale();
    let mut group = Group::new().set("stroke-linecap", "round");
    for contact in contacts {
        let width = unit * contact.force.n / mean;
        for [from, to] in segments(scene, world, contact) {
            let ([x1, y1], [x2, y2]) = (view.at(from.x, from.y), view.at(to.x, to.y));
            let line = Line::new()
                .set("x1", rounded(x1))
                .set("y1", rounded(y1))
                .set("x2", rounded(x2))
                .set("y2", rounded(y2))
                .set("stroke-width", rounded(width))
                .set("stroke", colour(contact.kind));
            group = group.add(line);
        }
    }
    group
}

fn colour(kind: ContactKind) -> &'static str {
    match kind {
        ContactKind::SideVertex => SIDE_VERTEX,
        ContactKind::SideSide => SIDE_SIDE,
    }
}

/// The line of a contact from the first centre, and from the second one if they are at different sides of the box.
fn segments(scene: &Scene, world: &World, contact: &Contact) -> Vec<[Vec2; 2]> {
    let position = &world.state().configuration.position;
    let [first, second] = [contact.first, contact.second].map(|body| position[body as usize]);
    let branch = contact.vector(contact.branch);
    let mut segments = vec![[first, first + branch]];
    if scene
        .domain
        .period()
        .is_some_and(|width| (second.x - first.x).abs() > 0.5 * width)
    {
        segments.push([second - branch, second]);
    }
    segments
}
