//! Shapes in the plane: `[setup.cut]` and `output.strain_region`.

use super::table::{Range, Table};
use crate::error::SceneError;
use gouge_common::geometry::Vec2;
use std::f64::consts::PI;

type Result<T> = std::result::Result<T, SceneError>;

/// Part of the size of the box by which a shape may reach beyond it because of rounding.
const ROUNDING: f64 = 1e-9;

/// An upright rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Lower left corner in m.
    pub lower_left: Vec2,
    /// Upper right corner in m.
    pub upper_right: Vec2,
}

/// A shape that a specimen is cut to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// An upright rectangle.
    Rectangle(Rectangle),
    /// A disc.
    Disc {
        /// Centre in m.
        center: Vec2,
        /// Radius in m.
        radius: f64,
    },
}

impl Rectangle {
    /// Whether a point lies inside.
    pub fn contains(&self, point: Vec2) -> bool {
        let (low, high) = (self.lower_left, self.upper_right);
        (low.x..=high.x).contains(&point.x) && (low.y..=high.y).contains(&point.y)
    }
}

impl Shape {
    /// Whether a point lies inside.
    pub fn contains(&self, point: Vec2) -> bool {
        match self {
            Self::Rectangle(rectangle) => rectangle.contains(point),
            Self::Disc { center, radius } => (point - *center).norm() <= *radius,
        }
    }

    /// Lower left and upper right corner of the smallest upright rectangle around it, in m.
    fn bounds(&self) -> Rectangle {
        match self {
            Self::Rectangle(rectangle) => *rectangle,
            Self::Disc { center, radius } => Rectangle {
                lower_left: *center - Vec2::new(*radius, *radius),
                upper_right: *center + Vec2::new(*radius, *radius),
            },
        }
    }

    /// Area in m^2.
    pub fn area(&self) -> f64 {
        match self {
            Self::Rectangle(Rectangle {
                lower_left,
                upper_right,
            }) => (upper_right.x - lower_left.x) * (upper_right.y - lower_left.y),
            Self::Disc { radius, .. } => PI * radius * radius,
        }
    }
}

/// `[setup.cut]`.
pub fn cut(setup: &Table) -> Result<Option<Shape>> {
    let Some(table) = setup.optional_table("cut")? else {
        return Ok(None);
    };
    if table.choice("shape", &[("rectangle", true), ("disc", false)])? {
        table.allow(&["shape", "lower_left", "upper_right"])?;
        return Ok(Some(Shape::Rectangle(rectangle(&table)?)));
    }
    table.allow(&["shape", "center", "radius"])?;
    Ok(Some(Shape::Disc {
        center: vector(table.pair("center")?),
        radius: table.number("radius", Range::Positive)?,
    }))
}

/// Check that `[setup.cut]` does not reach beyond the box, whose width and height in m are given. Rounding is forgiven.
pub fn check_within_box(setup: &Table, shape: &Shape, [width, height]: [f64; 2]) -> Result<()> {
    let Some(table) = setup.optional_table("cut")? else {
        return Ok(());
    };
    let (bounds, slack) = (shape.bounds(), ROUNDING * (width + height));
    let (low, high) = (bounds.lower_left, bounds.upper_right);
    let is_low = low.x < -slack || low.y < -slack;
    let is_high = high.x > width + slack || high.y > height + slack;
    let key = match shape {
        _ if !is_low && !is_high => return Ok(()),
        Shape::Disc { .. } => "radius",
        Shape::Rectangle(_) if is_low => "lower_left",
        Shape::Rectangle(_) => "upper_right",
    };
    let accepted = format!(
        "with setup.correct_density, the shape must lie within the box, from [0, 0] to [{width:?}, {height:?}]: \
         there are no grains to fill what lies outside"
    );
    Err(table.error(key, &accepted))
}

/// The key of a table that is a rectangle, if it is present.
pub fn region(table: &Table, key: &str) -> Result<Option<Rectangle>> {
    let Some(table) = table.optional_table(key)? else {
        return Ok(None);
    };
    table.allow(&["lower_left", "upper_right"])?;
    rectangle(&table).map(Some)
}

fn rectangle(table: &Table) -> Result<Rectangle> {
    let lower_left = vector(table.pair("lower_left")?);
    let upper_right = vector(table.pair("upper_right")?);
    if lower_left.x >= upper_right.x || lower_left.y >= upper_right.y {
        let accepted = "must lie to the right of lower_left and above it";
        return Err(table.error("upper_right", accepted));
    }
    Ok(Rectangle {
        lower_left,
        upper_right,
    })
}

fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}
