//! Drawings with equal scales along both axes.

use gouge_common::geometry::Vec2;
use maud::{Markup, html};

/// Colours that are distinguishable with colour blindness, after Okabe and Ito.
pub(super) const BLUE: &str = "#0072b2";
pub(super) const ORANGE: &str = "#d55e00";
pub(super) const INK: &str = "#222";
pub(super) const PALE: &str = "#dfe5ea";
pub(super) const GREY: &str = "#9aa4ad";

/// A drawing in units of its own, y upwards.
pub(super) struct Drawing {
    low: Vec2,
    high: Vec2,
    scale: f64,
    parts: Vec<Markup>,
}

/// How a line is drawn: its colour, its width in pixels, and its dashes.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    pub(super) colour: &'static str,
    pub(super) width: f64,
    pub(super) dashes: &'static str,
}

impl Pen {
    pub(super) const fn solid(colour: &'static str, width: f64) -> Self {
        Self {
            colour,
            width,
            dashes: "none",
        }
    }

    pub(super) const fn dashed(colour: &'static str, width: f64) -> Self {
        Self {
            dashes: "7 5",
            ..Self::solid(colour, width)
        }
    }
}

impl Drawing {
    /// An empty drawing of a rectangle, with pixels per unit.
    pub(super) fn new(low: Vec2, high: Vec2, scale: f64) -> Self {
        Self {
            low,
            high,
            scale,
            parts: Vec::new(),
        }
    }

    fn place(&self, point: Vec2) -> String {
        let x = (point.x - self.low.x) * self.scale;
        let y = (self.high.y - point.y) * self.scale;
        format!("{x:.1} {y:.1}")
    }

    /// Segments in one colour.
    pub(super) fn segments(&mut self, segments: impl IntoIterator<Item = [Vec2; 2]>, pen: Pen) {
        let path = segments
            .into_iter()
            .map(|[from, to]| format!("M{}L{}", self.place(from), self.place(to)));
        let path: String = path.collect();
        self.path(&path, "none", pen);
    }

    /// Closed rings, filled by the rule of even and odd.
    pub(super) fn area<'a>(
        &mut self,
        rings: impl IntoIterator<Item = &'a [Vec2]>,
        fill: &str,
        pen: Pen,
    ) {
        let ring = |ring: &'a [Vec2]| {
            let points: Vec<String> = ring.iter().map(|&point| self.place(point)).collect();
            format!("M{}Z", points.join("L"))
        };
        let path: String = rings.into_iter().map(ring).collect();
        self.path(&path, fill, pen);
    }

    fn path(&mut self, path: &str, fill: &str, pen: Pen) {
        self.parts.push(html! {
            path d=(path) fill=(fill) fill-rule="evenodd" stroke=(pen.colour) stroke-width=(pen.width) stroke-dasharray=(pen.dashes) {}
        });
    }

    /// A filled disc with a radius in pixels.
    pub(super) fn dot(&mut self, at: Vec2, radius: f64, colour: &'static str) {
        let place = self.place(at);
        let (x, y) = place.split_once(' ').unwrap_or_default();
        self.parts
            .push(html! { circle cx=(x) cy=(y) r=(radius) fill=(colour) {} });
    }

    /// A line of text that begins at a point.
    pub(super) fn text(&mut self, at: Vec2, text: &str) {
        let place = self.place(at);
        let (x, y) = place.split_once(' ').unwrap_or_default();
        self.parts.push(html! { text x=(x) y=(y) { (text) } });
    }

    /// The SVG element.
    pub(super) fn svg(&self) -> Markup {
        let size = (self.high - self.low) * self.scale;
        html! {
            svg viewBox=(format!("0 0 {:.0} {:.0}", size.x, size.y)) font-family="sans-serif" font-size="17" fill=(INK) {
                @for part in &self.parts { (part) }
            }
        }
    }
}

/// Points of an arc of a circle between two angles in rad.
pub(super) fn arc(centre: Vec2, radius: f64, [from, to]: [f64; 2]) -> Vec<Vec2> {
    const PIECES: i32 = 60;
    let angle = |k: i32| from + (to - from) * f64::from(k) / f64::from(PIECES);
    let point = |angle: f64| centre + Vec2::new(angle.cos(), angle.sin()) * radius;
    (0..=PIECES).map(|k| point(angle(k))).collect()
}
