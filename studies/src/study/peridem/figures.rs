//! Figures of the paper, drawn from the laws and from the runs.

use super::super::results::Results;
use super::claims::{from_notch, plates};
use super::{CROSSES, CROSSES_FINE, KALTHOFF};
use crate::study::curves::Curves;
use crate::study::results::Run;
use crate::study::sample::Sample;
use gouge_common::geometry::Vec2;
use gouge_page::{Axis, Curve, Figure};
use gouge_peridem::contact_law::{ContactLaw, ContactReading, FrictionStep, Node, NodePair};
use gouge_peridem::interior::{Interceptors, SectionFive};
use gouge_peridem::shape::Outline;
use gouge_peridem::wall_law::{WallLaw, WallReading};

pub(super) fn figures(results: &Results, curves: &Curves) -> Vec<Figure> {
    let mut all = vec![friction(), walls()];
    all.extend(filters());
    all.extend(shapes());
    all.extend(angles(results));
    all.extend([
        area(results, CROSSES, "horizon"),
        area(results, CROSSES_FINE, "spacing"),
    ]);
    all.extend(growth(results, curves));
    all.into_iter()
        .filter(|figure| figure.curves.iter().any(|curve| !curve.points.is_empty()))
        .collect()
}

/// Friction against the tangential force that would stop the nodes in one step.
fn friction() -> Figure {
    let law = ContactLaw {
        radius: 1e-4,
        damping_ratio: 0.0,
        friction: 0.8,
        reading: ContactReading::Symmetric,
    };
    let node = Node {
        area: 4e-9,
        density: 1200.0,
    };
    let step = FrictionStep {
        time_step: 7e-8,
        stick_share: 1.0,
    };
    let spring = law.between_grains(2.8e23);
    let distance = 0.9e-4;
    let limit = law.friction * spring.stiffness * node.area * node.area * 1e-5;
    let mass = law.mass(&node, &node);
    let point = |k: i32| {
        let force = 0.05 * f64::from(k) * limit;
        let pair = NodePair {
            separation: Vec2::new(distance, 0.0),
            velocity: Vec2::new(0.0, force * step.time_step / mass),
            x: node,
            y: node,
        };
        let friction = law.force(&pair, &spring, &step).friction;
        [force / limit, -friction.y / limit]
    };
    Figure::new(
        "Figure 1b: friction against the tangential force, both over μ times the normal force.",
        Axis::linear("tangential force", ""),
        Axis::linear("friction", ""),
        vec![Curve::line("friction", (-40..=40).map(point))],
    )
}

/// Forces of walls in their readings.
fn walls() -> Figure {
    let curve = |(name, reading)| {
        let law = WallLaw {
            radius: 1.0,
            stiffness: 1.0,
            damping_ratio: 0.0,
            friction: 0.0,
            reading,
        };
        let distances = (-100..=100).map(|k| f64::from(k) / 100.0);
        Curve::line(name, distances.map(|d| [d, law.push(d, 1.0)]))
    };
    let readings = [
        ("at the centroid, as printed", WallReading::Paper),
        ("integral of (4.1)", WallReading::Exact),
        ("program of the authors", WallReading::Authors),
    ];
    Figure::new(
        "Figure 2: force of a wall on a node at a distance from it, over K V R³.",
        Axis::linear("distance over contact radius", ""),
        Axis::linear("force", ""),
        readings.map(curve).into(),
    )
}

/// The shapes of figure 11, beside each other.
fn outlines() -> Vec<(&'static str, Outline)> {
    let numbers: Vec<f64> = (0..20).map(|k| f64::from(k * 37 % 20) / 20.0).collect();
    let all = [
        (
            "perturbed disc",
            Outline::perturbed_disc(1.0, 0.6, &numbers),
        ),
        ("square", Outline::square(1.0)),
        ("plus", Outline::plus(1.0, 0.2)),
        ("annulus", Outline::annulus(1.0, 0.6, 40)),
    ];
    all.into_iter()
        .filter_map(|(name, outline)| Some((name, outline.ok()?)))
        .collect()
}

/// A closed chain of points, moved along x.
fn closed(ring: &[Vec2], shift: f64) -> Vec<[f64; 2]> {
    let points = ring.iter().chain(ring.first());
    points.map(|point| [point.x + shift, point.y]).collect()
}

fn shapes() -> Option<Figure> {
    let mut curves = Vec::new();
    for (k, (name, outline)) in outlines().into_iter().enumerate() {
        let shift = 2.2 * k as f64;
        for (ring, points) in outline.rings().enumerate() {
            let label = if ring == 0 { name } else { "its hole" };
            curves.push(Curve::line(label, closed(points, shift)));
        }
    }
    Some(Figure::new(
        "Figure 11: the shapes, in discs of radius 1.",
        Axis::linear("x", ""),
        Axis::linear("y", ""),
        curves,
    ))
}

/// Extended boundary and bisectors of four shapes.
fn filters() -> Option<Figure> {
    let mut curves = Vec::new();
    for (k, (name, outline)) in outlines().into_iter().enumerate() {
        let shift = 2.6 * k as f64;
        curves.push(Curve::line(name, closed(outline.outer(), shift)));
        let method = SectionFive::new(&outline, 0.04, Interceptors::BisectorsAndBoundary).ok()?;
        let near = |end: Vec2| end.norm() < 1.3;
        let segments = method.interceptors().iter();
        for &[from, to] in segments.filter(|ends| ends.iter().all(|&end| near(end))) {
            let points = [from, to].map(|end| [end.x + shift, end.y]);
            curves.push(Curve::dashed("no bond may cross", points));
        }
    }
    Some(Figure::new(
        "Figure 3: what bonds may not cross by the method of section 5, for four shapes.",
        Axis::linear("x", ""),
        Axis::linear("y", ""),
        merged(curves),
    ))
}

/// Curves of one label as one curve, with gaps.
fn merged(curves: Vec<Curve>) -> Vec<Curve> {
    let mut all: Vec<Curve> = Vec::new();
    for curve in curves {
        match all.iter_mut().find(|other| other.label == curve.label) {
            Some(other) => {
                other.points.push([f64::NAN; 2]);
                other.points.extend(curve.points);
            }
            None => all.push(curve),
        }
    }
    all
}

/// Angles of the cracks over grids.
fn angles(results: &Results) -> Option<Figure> {
    let sample = Sample {
        results,
        part: KALTHOFF,
    };
    let curve = |(label, breaking, contact): (&str, &'static str, &'static str)| {
        let runs = plates(&sample, breaking, contact);
        let point = |(k, run): (usize, &&Run)| Some([k as f64, from_notch(run, 0)?]);
        Curve::marks(label, runs.iter().enumerate().filter_map(point))
    };
    let curves = [
        ("tension only", "tension only", "off"),
        ("with self contact", "tension only", "on"),
    ];
    Some(Figure::new(
        "Angle between crack and notch, by number of the grid in the table of the plate.",
        Axis::linear("grid", ""),
        Axis::linear("angle", "degrees"),
        curves.map(curve).into(),
    ))
}

/// Areas of damaged nodes over an axis.
fn area(results: &Results, part: &'static str, axis: &str) -> Figure {
    let sample = Sample { results, part };
    let curve = |(label, column): (&str, &str)| {
        let number = |run: &Run| {
            let digits = run
                .text(axis)
                .trim_start_matches("R/")
                .trim_end_matches(" h");
            Some([digits.parse().ok()?, run.number(column)?])
        };
        Curve::marked_line(label, sample.runs().filter_map(number))
    };
    let (figure, quantity) = match part {
        CROSSES => ("8a", "horizon over spacing"),
        _ => ("8b", "radius over spacing"),
    };
    let columns = [
        ("after 400 ns", "area_at_400_ns"),
        ("after 1 us", "area_at_1_us"),
    ];
    Figure::new(
        format!("Figure {figure}: area of the damaged nodes of a cross."),
        Axis::linear(quantity, ""),
        Axis::linear("area", "mm²"),
        columns.map(curve).into(),
    )
}

/// Broken bonds over time in the runs of the plate.
fn growth(results: &Results, curves: &Curves) -> Option<Figure> {
    let sample = Sample {
        results,
        part: KALTHOFF,
    };
    let curve = |run: &Run| {
        let points = curves.of(run)?.iter();
        let label = format!(
            "{}, {}, self contact {}",
            run.text("grid"),
            run.text("breaking"),
            run.text("self contact")
        );
        let points = points.map(|point| [1e6 * point.time, point.numbers[0]]);
        Some(Curve::line(&label, points))
    };
    Some(Figure::new(
        "Broken bonds of the plate over time.",
        Axis::linear("time", "us"),
        Axis::linear("broken bonds", ""),
        sample.runs().filter_map(curve).collect(),
    ))
}
