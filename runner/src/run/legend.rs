//! Scales of colours, and the legend of a picture.

use super::picture::{LETTERS, MARGIN, STRIP, rounded};
use svg::node::element::{Group, Rectangle, Text};

/// Width in pixels of the bar of a legend.
const BAR: f64 = 300.0;
/// Height in pixels of the bar.
const HEIGHT: f64 = 28.0;

/// What the colours of a picture mean.
pub struct Legend {
    /// The quantity.
    pub label: &'static str,
    /// Its values at both ends of the scale.
    pub ends: [&'static str; 2],
    /// The colours from one end to the other.
    pub colours: Vec<String>,
}

/// A number of colours between anchors, which are equally spaced along the scale.
pub fn ramp(anchors: &[[u8; 3]], number: usize) -> Vec<String> {
    let last = anchors.len().saturating_sub(1);
    let colour = |k: usize| {
        let at = k as f64 / (number.max(2) - 1) as f64 * last as f64;
        let below = (at as usize).min(last.saturating_sub(1));
        let part = at - below as f64;
        let [from, to] = [below, (below + 1).min(last)].map(|anchor| anchors[anchor]);
        let channel =
            |c: usize| f64::from(from[c]) + part * (f64::from(to[c]) - f64::from(from[c]));
        let [red, green, blue] = [0, 1, 2].map(|c| channel(c).round() as u8);
        format!("#{red:02x}{green:02x}{blue:02x}")
    };
    (0..number).map(colour).collect()
}

/// Width in pixels of a text and the space behind it: a letter is at most about 0.65 times as wide as high.
fn advance(text: &str) -> f64 {
    0.65 * LETTERS * (text.chars().count() + 1) as f64
}

impl Legend {
    /// Width in pixels.
    pub fn width(&self) -> f64 {
        let texts = [self.label, self.ends[0], self.ends[1]];
        BAR + 2.0 * MARGIN + texts.into_iter().map(advance).sum::<f64>()
    }

    /// The legend on a white strip below the given height in pixels.
    pub fn draw(&self, top: f64) -> Group {
        let middle = top + 0.5 * STRIP;
        let text = |content: &str, x: f64| {
            Text::new(content)
                .set("x", rounded(x))
                .set("y", rounded(middle + 0.35 * LETTERS))
                .set("font-family", "sans-serif")
                .set("font-size", LETTERS)
                .set("fill", "#222")
        };
        let strip = Rectangle::new()
            .set("y", rounded(top))
            .set("width", "100%")
            .set("height", STRIP)
            .set("fill", "white");
        let low = MARGIN + advance(self.label);
        let bar = low + advance(self.ends[0]);
        let width = BAR / self.colours.len().max(1) as f64;
        let mut group = Group::new().set("class", "legend").add(strip);
        for (k, colour) in self.colours.iter().enumerate() {
            let cell = Rectangle::new()
                .set("x", rounded(bar + k as f64 * width))
                .set("y", rounded(middle - 0.5 * HEIGHT))
                .set("width", rounded(width + 0.5))
                .set("height", HEIGHT)
                .set("fill", colour.as_str());
            group = group.add(cell);
        }
        group
            .add(text(self.label, MARGIN))
            .add(text(self.ends[0], low))
            .add(text(self.ends[1], bar + BAR + MARGIN))
    }
}
