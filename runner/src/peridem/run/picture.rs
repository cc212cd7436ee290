//! The picture of a state: nodes coloured by their damage, and walls.

use super::super::Scene;
use super::begin::mode_text;
use super::mesh::Cells;
use super::samples::crack;
use crate::run::legend::{Legend, ramp};
use crate::run::picture::{View, framed_with, rounded};
use gouge_common::geometry::Vec2;
use gouge_peridem::world::World;
use std::fmt::Write;
use svg::Document;
use svg::node::element::{Group, Line, Path};

/// Colours of no damage and of all bonds broken, with colours between them.
pub const COLOURS: [[u8; 3]; 4] = [[205, 214, 222], [245, 200, 66], [213, 94, 0], [90, 0, 30]];
/// Number of colours.
const SHADES: usize = 12;
/// Part of the size of the grains that is shown around them.
const MARGIN: f64 = 0.02;
/// By how much discs of nodes of a triangulation are larger than squares of their areas.
const COVER: f64 = 1.35;

/// The colours of damage, from none to all bonds broken.
pub fn damage_colours() -> Vec<String> {
    ramp(&COLOURS, SHADES)
}

/// The state of a scene as a picture with a scale bar and a legend.
pub fn draw(scene: &Scene, world: &World, cells: &[Cells]) -> Document {
    let view = view(world);
    let title = format!(
        "{}, t = {:.6e} s, {}",
        scene.title,
        world.time(),
        mode_text(scene.mode)
    );
    let legend = Legend {
        label: "damage",
        ends: ["0", "1"],
        colours: damage_colours(),
    };
    let lines = Group::new()
        .add(walls(world, &view))
        .add(cracks(scene, world, &view));
    let parts = [nodes(world, cells, &view), lines];
    framed_with(&view, &title, parts, Some(&legend))
}

/// All nodes that still have bonds, or all nodes if none has, with a margin, and the walls near them.
fn view(world: &World) -> View {
    let nodes = || 0..world.grains().nodes();
    let is_bonded = |&node: &usize| world.bonds().damage(node) < 1.0;
    let has_bonds = nodes().any(|node| is_bonded(&node));
    let shown = nodes().filter(|node| !has_bonds || is_bonded(node));
    let positions = || {
        let places = shown.clone();
        places.map(|node| world.state().places[node].position())
    };
    let mut low = Vec2::new(f64::INFINITY, f64::INFINITY);
    let mut high = -low;
    for p in positions().filter(|p| p.is_finite()) {
        low = Vec2::new(low.x.min(p.x), low.y.min(p.y));
        high = Vec2::new(high.x.max(p.x), high.y.max(p.y));
    }
    let size = (high.x - low.x).max(high.y - low.y);
    let largest = world
        .grains()
        .area
        .iter()
        .fold(0.0_f64, |most, &area| most.max(area));
    let margin = Vec2::new(1.0, 1.0) * (MARGIN * size).max(COVER * largest.sqrt());
    let (mut low, mut high) = (low - margin, high + margin);
    let [left, right, top, bottom] = world.state().walls;
    let near = |wall: f64, side: f64| (wall - side).abs() < size;
    low.x = if near(left, low.x) {
        low.x.min(left)
    } else {
        low.x
    };
    high.x = if near(right, high.x) {
        high.x.max(right)
    } else {
        high.x
    };
    high.y = if near(top, high.y) {
        high.y.max(top)
    } else {
        high.y
    };
    low.y = if near(bottom, low.y) {
        low.y.min(bottom)
    } else {
        low.y
    };
    View::around([low, high].into_iter(), None)
}

/// One path of dots per grain and colour, so that the picture stays small.
fn nodes(world: &World, cells: &[Cells], view: &View) -> Group {
    let colours = damage_colours();
    let mut group = Group::new().set("fill", "none");
    for (row, cells) in world.grains().rows.iter().zip(cells) {
        let mut dots = vec![String::new(); SHADES];
        for node in row.nodes.clone() {
            let position = world.state().places[node].position();
            if !position.is_finite() {
                continue;
            }
            let shade = (world.bonds().damage(node) * SHADES as f64) as usize;
            let [x, y] = view.at(position.x, position.y);
            let dot = &mut dots[shade.min(SHADES - 1)];
            let _ = write!(dot, "M{:.1} {:.1}h.01", x, y);
        }
        let areas = &world.grains().area[row.nodes.clone()];
        let mean = areas.iter().sum::<f64>() / areas.len() as f64;
        let (cap, cover) = match cells.are_squares {
            true => ("square", 1.0),
            false => ("round", COVER),
        };
        let width = rounded(cover * mean.sqrt() * view.scale());
        for (dots, colour) in dots.into_iter().zip(&colours) {
            if dots.is_empty() {
                continue;
            }
            let path = Path::new()
                .set("d", dots)
                .set("stroke", colour.as_str())
                .set("stroke-width", width)
                .set("stroke-linecap", cap);
            group = group.add(path);
        }
    }
    group
}

fn walls(world: &World, view: &View) -> Group {
    let [width, height] = view.size();
    let [left, right, top, bottom] = world.state().walls;
    let upright = [left, right].map(|x| {
        let [x, _] = view.at(x, 0.0);
        ([x, 0.0], [x, height])
    });
    let level = [top, bottom].map(|y| {
        let [_, y] = view.at(0.0, y);
        ([0.0, y], [width, y])
    });
    let is_seen = |([x, y], _): &([f64; 2], [f64; 2])| {
        (0.0..=width).contains(x) && (0.0..=height).contains(y)
    };
    let mut group = Group::new().set("stroke", "#222").set("stroke-width", 3);
    for ([x1, y1], [x2, y2]) in upright.into_iter().chain(level).filter(is_seen) {
        let line = Line::new()
            .set("x1", rounded(x1))
            .set("y1", rounded(y1))
            .set("x2", rounded(x2))
            .set("y2", rounded(y2));
        group = group.add(line);
    }
    group
}

/// The lines whose directions and lengths the scene measures, from the undeformed tips.
fn cracks(scene: &Scene, world: &World, view: &View) -> Group {
    let mut group = Group::new()
        .set("stroke", "#0072b2")
        .set("stroke-width", 4)
        .set("stroke-dasharray", "14 8");
    for table in &scene.cracks {
        let Some(crack) = crack(world, table) else {
            continue;
        };
        let along = Vec2::new(libm::cos(crack.angle), libm::sin(crack.angle));
        let end = table.tip + along * crack.length;
        let [from, to] = [table.tip, end].map(|point| view.at(point.x, point.y).map(rounded));
        let line = Line::new()
            .set("x1", from[0])
            .set("y1", from[1])
            .set("x2", to[0])
            .set("y2", to[1]);
        group = group.add(line);
    }
    group
}
