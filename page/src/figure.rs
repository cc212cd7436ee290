//! Figures.

use crate::axis::Axis;
use crate::curve::Curve;
use crate::draw::{draw, plot};
use crate::legend::list;
use maud::{Markup, PreEscaped, html};
use std::io;
use std::path::Path;

/// Two axes and some curves.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The statement of the figure, a sentence.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The curves; later ones are drawn over earlier ones.
    pub curves: Vec<Curve>,
    /// Straight lines across the figure.
    pub guides: Vec<Guide>,
}

/// A horizontal or vertical line at a value that curves are compared with.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Name in the legend.
    pub label: String,
    /// Where the line crosses the axis: `y` if it is horizontal, otherwise `x`.
    pub value: f64,
    /// Whether the line is horizontal.
    pub is_horizontal: bool,
}

impl Guide {
    /// The horizontal line at a value of `y`.
    pub fn horizontal(label: &str, value: f64) -> Self {
        Self {
            label: label.to_owned(),
            value,
            is_horizontal: true,
        }
    }
    /// The vertical line at a value of `x`.
    pub fn vertical(label: &str, value: f64) -> Self {
        Self {
            is_horizontal: false,
            ..Self::horizontal(label, value)
        }
    }
}

impl Figure {
    /// A figure without guides.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis, curves: Vec<Curve>) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            curves,
            guides: Vec::new(),
        }
    }

    /// With one more guide.
    #[must_use]
    pub fn with_guide(mut self, guide: Guide) -> Self {
        self.guides.push(guide);
        self
    }

    /// The figure as an element of a page, with title and legend as its caption.
    pub fn html(&self) -> Markup {
        html! {
            figure {
                @match plot(self) {
                    Ok(svg) => (PreEscaped(svg)),
                    Err(error) => p { "This figure could not be drawn: " (error) },
                }
                figcaption { (self.title) (list(self)) }
            }
        }
    }

    /// The figure as the text of an SVG file, with title and legend.
    ///
    /// # Errors
    /// A figure that cannot be drawn.
    pub fn svg(&self) -> io::Result<String> {
        draw(self)
    }

    /// Writes the figure as an SVG file, with title and legend.
    ///
    /// # Errors
    /// A figure that cannot be drawn; failures of the file system.
    pub fn write_svg(&self, path: &Path) -> io::Result<()> {
        std::fs::write(path, draw(self)?)
    }
}
