//! Picture of the final state with coloured fragments, modelled on thesis figure 11.

use super::dem::lines;
use super::folder::{PICTURE, write_whole};
use super::legend::Legend;
use super::scale_bar::ScaleBar;
use crate::error::Error;
use crate::scene::Scene;
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::estimators::fragments;
use gouge_dem::particles::{Particles, Role};
use std::path::Path;
use svg::Document;
use svg::node::element::{Circle, Group, Line, Rectangle, Text};

/// Length of the longer edge in pixels.
const SIZE: f64 = 1000.0;
/// Difference in hue between consecutive fragments, in degrees: the golden angle separates hues best.
const HUE: f64 = 137.507_764;
/// Longest scale bar, as a part of the longer edge.
const LONGEST_BAR: f64 = 0.25;
/// Height in pixels of the strip for the scale bar, below the grains.
pub(super) const STRIP: f64 = 70.0;
/// Distance in pixels of the scale bar from the edges and from its label.
pub(super) const MARGIN: f64 = 16.0;
/// Size of letters in pixels.
pub(super) const LETTERS: f64 = 32.0;

/// The region that the picture shows.
pub struct View {
    low: [f64; 2],
    high: [f64; 2],
}

impl View {
    fn of(scene: &Scene, particles: &Particles) -> Self {
        let discs = particles.position.iter().zip(&particles.radius);
        let corners = discs.flat_map(|(&x, &r)| [x - Vec2::new(r, r), x + Vec2::new(r, r)]);
        Self::around(corners, scene.domain.period())
    }
    /// The region around some points; as wide as the period, if there is one.
    pub fn around(points: impl Iterator<Item = Vec2>, period: Option<f64>) -> Self {
        let mut view = Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        for point in points {
            for (axis, x) in [point.x, point.y].into_iter().enumerate() {
                view.low[axis] = view.low[axis].min(x);
                view.high[axis] = view.high[axis].max(x);
            }
        }
        if let Some(width) = period {
            (view.low[0], view.high[0]) = (0.0, width);
        }
        view
    }
    /// Pixels per metre.
    pub fn scale(&self) -> f64 {
        SIZE / (self.high[0] - self.low[0]).max(self.high[1] - self.low[1])
    }
    /// Width and height in pixels.
    pub fn size(&self) -> [f64; 2] {
        self.at(self.high[0], self.low[1])
    }
    /// The place of a point in pixels.
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let scale = self.scale();
        [(x - self.low[0]) * scale, (self.high[1] - y) * scale]
    }
}

/// Write `picture.svg`.
///
/// # Errors
/// Failures of the file system.
pub fn write(folder: &Path, scene: &Scene, world: &World, is_untrusted: bool) -> Result<(), Error> {
    let mut picture = draw_picture(scene, world);
    if is_untrusted {
        picture = picture.add(
            Text::new("energy balance off: not to be trusted")
                .set("x", 12)
                .set("y", 30)
                .set("font-family", "sans-serif")
                .set("font-size", 24)
                .set("fill", "#c00"),
        );
    }
    let text = picture.to_string();
    write_whole(&folder.join(PICTURE), text.as_bytes())
}

/// The state of a scene as a picture with a scale bar.
pub fn draw_picture(scene: &Scene, world: &World) -> Document {
    let view = View::of(scene, world.particles());
    let title = format!("{}, t = {:.6e} s", scene.title, world.time());
    let parts = [grains(&view, world), bonds(&view, scene, world)];
    framed(&view, &title, parts)
}

/// A state of a scene and its picture.
pub struct Shown {
    /// Number of steps after the set-up.
    pub steps: u64,
    /// Time in s.
    pub time: f64,
    /// The picture as SVG.
    pub svg: String,
}

/// A picture of some parts with a scale bar below them.
pub fn framed(view: &View, title: &str, parts: [Group; 2]) -> Document {
    framed_with(view, title, parts, None)
}

/// A picture of some parts with a scale bar below them, and a legend below that.
pub fn framed_with(
    view: &View,
    title: &str,
    parts: [Group; 2],
    legend: Option<&Legend>,
) -> Document {
    let [mut width, mut height] = view.size();
    let mut below = Group::new();
    if let Some(bar) = ScaleBar::within(LONGEST_BAR * SIZE / view.scale()) {
        below = below.add(draw_bar(view, &bar, height));
        // A letter is about 0.6 times as wide as high.
        let label = 0.6 * LETTERS * bar.label.chars().count() as f64;
        width = width.max(bar.length * view.scale() + label + 3.0 * MARGIN);
        height += STRIP;
    }
    if let Some(legend) = legend {
        below = below.add(legend.draw(height));
        width = width.max(legend.width());
        height += STRIP;
    }
    let picture = Document::new()
        .set("viewBox", (0.0, 0.0, width.round(), height.round()))
        .set("width", width.round())
        .set("height", height.round())
        .add(svg::node::element::Title::new(title))
        .add(
            Rectangle::new()
                .set("width", "100%")
                .set("height", "100%")
                .set("fill", "white"),
        );
    parts.into_iter().fold(picture, Document::add).add(below)
}

/// The scale bar on a white strip below the given height in pixels, which hides what protrudes from the box.
fn draw_bar(view: &View, bar: &ScaleBar, top: f64) -> Group {
    let (middle, end) = (top + 0.5 * STRIP, MARGIN + bar.length * view.scale());
    let line = |[x1, y1]: [f64; 2], [x2, y2]: [f64; 2]| {
        Line::new()
            .set("x1", rounded(x1))
            .set("y1", rounded(y1))
            .set("x2", rounded(x2))
            .set("y2", rounded(y2))
    };
    let cap = |x: f64| line([x, middle - 8.0], [x, middle + 8.0]);
    let label = Text::new(bar.label.as_str())
        .set("x", rounded(end + MARGIN))
        .set("y", rounded(middle + 0.35 * LETTERS))
        .set("font-family", "sans-serif")
        .set("font-size", LETTERS)
        .set("stroke", "none")
        .set("fill", "#222");
    let strip = Rectangle::new()
        .set("y", rounded(top))
        .set("width", "100%")
        .set("height", STRIP)
        .set("stroke", "none")
        .set("fill", "white");
    Group::new()
        .set("class", "scale")
        .set("stroke", "#222")
        .set("stroke-width", 4)
        .add(strip)
        .add(line([MARGIN, middle], [end, middle]))
        .add(cap(MARGIN))
        .add(cap(end))
        .add(label)
}

fn grains(view: &View, world: &World) -> Group {
    let p = world.particles();
    let fragments = fragments(world.state());
    let mut sizes = vec![0_usize; fragments.number];
    fragments.label.iter().for_each(|&label| sizes[label] += 1);
    let mut group = Group::new().set("stroke", "#222").set("stroke-width", 0.4);
    for i in 0..p.len() {
        let [x, y] = view.at(p.position[i].x, p.position[i].y);
        let label = fragments.label[i];
        let circle = Circle::new()
            .set("cx", rounded(x))
            .set("cy", rounded(y))
            .set("r", rounded(p.radius[i] * view.scale()))
            .set("fill", colour(label, sizes[label], p.role[i]));
        group = group.add(circle);
    }
    group
}

/// Grey for fixed and driven particles, white for single grains, and one colour per larger fragment.
fn colour(label: usize, size: usize, role: Role) -> String {
    match role {
        Role::Fixed => "#777".to_owned(),
        Role::Driven => "#aaa".to_owned(),
        Role::Free if size == 1 => "#fff".to_owned(),
        Role::Free => pastel((label as f64 * HUE) % 360.0),
    }
}

/// A light colour of the given hue in degrees, as six hexadecimal digits, which every viewer supports.
fn pastel(hue: f64) -> String {
    let channel = |offset: f64| {
        let place = (hue / 60.0 + offset) % 6.0;
        let share = (2.0 - (place - 3.0).abs()).clamp(0.0, 1.0);
        (255.0 * (0.91 - 0.42 * share)).round()
    };
    let [red, green, blue] = [0.0, 4.0, 2.0].map(channel);
    format!("#{:02x}{:02x}{:02x}", red as u8, green as u8, blue as u8)
}

fn bonds(view: &View, scene: &Scene, world: &World) -> Group {
    let mut group = Group::new().set("stroke", "#222").set("stroke-width", 0.8);
    let p = world.particles();
    for (i, j) in lines(scene, world) {
        let (a, b) = (p.position[i], p.position[j]);
        let ([x1, y1], [x2, y2]) = (view.at(a.x, a.y), view.at(b.x, b.y));
        let line = Line::new()
            .set("x1", rounded(x1))
            .set("y1", rounded(y1))
            .set("x2", rounded(x2))
            .set("y2", rounded(y2));
        group = group.add(line);
    }
    group
}

/// The number rounded to two decimals, which is enough for a picture.
pub fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}
