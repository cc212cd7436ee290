//! Pairs of shapes: separation, normal and contact points.

use crate::{id, items, number};
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::detection::{DetectionSettings, Placed, Touch, detect};
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use serde_json::{Map, Value, json};

pub fn results(cases: &Value) -> Map<String, Value> {
    items(cases, "pairs")
        .map(|case| (id(case), pair(case)))
        .collect()
}

fn pair(case: &Value) -> Value {
    let mut shapes = Shapes::new();
    let [first, second] = [&case["a"], &case["b"]].map(|body| (body, add(&mut shapes, body)));
    let [first, second] = [first, second].map(|(body, shape)| {
        Placed::new(shapes.outline(shape), number(body, "R"), number(body, "th"))
    });
    let [from, to] =
        [&case["a"], &case["b"]].map(|body| Vec2::new(number(body, "x"), number(body, "y")));
    let domain = Domain {
        width: case["period_x"].as_f64(),
        height: None,
        periodic: true,
    };
    let d = domain.displacement(from, to);
    let mut touches = Vec::new();
    let separation = detect(
        &first,
        &second,
        d,
        &DetectionSettings::for_diameter(1.0),
        &mut touches,
    );
    let point = |touch: &Touch| {
        let p = from + touch.arms[0];
        json!({"g": touch.gap, "p": [p.x, p.y]})
    };
    let points: Vec<_> = touches.iter().map(point).collect();
    let normal = separation.normal;
    json!({"sep": separation.distance, "normal": [normal.x, normal.y], "points": points})
}

/// The shape of a body: n sides, or a disc for n = 0.
pub fn add(shapes: &mut Shapes, body: &Value) -> ShapeId {
    let sides = body["n"].as_u64().unwrap_or_default() as usize;
    match shapes.add_regular(sides) {
        Ok(shape) => shape,
        Err(_) => shapes.add_disc(),
    }
}
