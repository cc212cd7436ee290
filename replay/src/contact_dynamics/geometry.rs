//! Pairs of shapes: separation, normal and contact points.

use super::Case;
use crate::error::Fault;
use crate::fields::Fields;
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::detection::{DetectionSettings, Placed, Touch, detect};
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use serde_json::{Value, json};

/// Most sides of a regular polygon.
pub const MOST_SIDES: usize = 10_000;

/// Separation, normal and contact points of two shapes, with an alert distance of 0.02.
pub fn solve(case: &Case) -> Result<Value, Fault> {
    let bodies = ["a", "b"].map(|key| case.fields.inside(key));
    let [a, b] = bodies;
    let (a, b) = (a?, b?);
    let mut shapes = Shapes::new();
    let (first, second) = (add(&mut shapes, &a)?, add(&mut shapes, &b)?);
    let first = placed(&shapes, first, &a)?;
    let second = placed(&shapes, second, &b)?;
    let (from, to) = (centre(&a)?, centre(&b)?);
    let d = domain(&case.fields)?.displacement(from, to);
    let mut touches = Vec::new();
    let settings = DetectionSettings::for_diameter(1.0);
    let separation = detect(&first, &second, d, &settings, &mut touches);
    let point = |touch: &Touch| {
        let p = from + touch.arms[0];
        json!({"g": touch.gap, "p": [p.x, p.y]})
    };
    let points: Vec<_> = touches.iter().map(point).collect();
    let normal = separation.normal;
    Ok(json!({"sep": separation.distance, "normal": [normal.x, normal.y], "points": points}))
}

fn placed<'a>(shapes: &'a Shapes, shape: ShapeId, body: &Fields) -> Result<Placed<'a>, Fault> {
    let angle = body.number("th")?;
    Ok(Placed::new(
        shapes.outline(shape),
        body.positive("R")?,
        angle,
    ))
}

/// The centre of a body.
pub fn centre(body: &Fields) -> Result<Vec2, Fault> {
    Ok(Vec2::new(body.number("x")?, body.number("y")?))
}

/// The box of a case: open, or with a period in x.
pub fn domain(fields: &Fields) -> Result<Domain, Fault> {
    let width = match fields.optional("period_x") {
        Some(_) => Some(fields.positive("period_x")?),
        None => None,
    };
    Ok(Domain {
        width,
        height: None,
        periodic: width.is_some(),
    })
}

/// The shape of a body: n sides, or a disc for n = 0.
pub fn add(shapes: &mut Shapes, body: &Fields) -> Result<ShapeId, Fault> {
    let sides = body.count("n", 0, MOST_SIDES)?;
    regular(shapes, sides)
}

/// The regular shape with a number of sides, or a disc for none.
pub fn regular(shapes: &mut Shapes, sides: usize) -> Result<ShapeId, Fault> {
    match sides {
        0 => Ok(shapes.add_disc()),
        _ => Ok(shapes.add_regular(sides)?),
    }
}
