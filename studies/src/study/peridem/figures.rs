//! Figures of the paper, drawn from the laws and from the runs.

use super::super::results::Results;
use super::claims::{from_notch, plates};
use super::{CROSSES, CROSSES_FINE, KALTHOFF, contact, panels, shapes, square, walls};
use crate::study::curves::Curves;
use crate::study::illustration::Illustration;
use crate::study::results::Run;
use crate::study::sample::Sample;
use gouge_common::geometry::Vec2;
use gouge_page::{Axis, Curve, Figure, Guide};
use gouge_peridem::contact_law::{ContactLaw, ContactReading, FrictionStep, Node, NodePair};

/// The figures of the paper in its order, each with what explains it.
pub(super) fn illustrations(results: &Results, curves: &Curves) -> Vec<Illustration> {
    let mut all = vec![
        Illustration::Figure(friction()),
        walls::drawing(),
        Illustration::Figure(walls::forces()),
        shapes::filters(),
        panels::plate(results),
    ];
    all.extend(drawn([angles(results), growth(results, curves)]));
    all.extend([panels::horizons(), panels::spacings()]);
    let areas = [(CROSSES, "horizon"), (CROSSES_FINE, "spacing")];
    all.extend(drawn(
        areas.map(|(part, axis)| Some(area(results, part, axis))),
    ));
    all.push(panels::pieces(results));
    all.extend(drawn([
        contact::figure(),
        Some(square::over_stiffness(results)),
    ]));
    all.push(shapes::drawing());
    all
}

/// Figures that have something to show.
fn drawn<const N: usize>(figures: [Option<Figure>; N]) -> impl Iterator<Item = Illustration> {
    let has_points = |figure: &Figure| figure.curves.iter().any(|curve| !curve.points.is_empty());
    let figures = figures.into_iter().flatten();
    figures.filter(has_points).map(Illustration::Figure)
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
        "Figure 1b: friction against the tangential force that drives two equal nodes for one step. Up to μ F_r friction \
         balances it (stick), beyond it is μ F_r (slip).",
        Axis::linear("tangential force over μ F_r", ""),
        Axis::linear("friction over μ F_r", ""),
        vec![Curve::line("friction", (-40..=40).map(point))],
    )
    .with_guide(Guide::vertical("slip begins, to the right", 1.0))
    .with_guide(Guide::vertical("and to the left", -1.0))
}

/// Angles of the cracks over grids.
fn angles(results: &Results) -> Option<Figure> {
    let sample = Sample {
        results,
        part: KALTHOFF,
    };
    let curve = |(label, breaking, contact): (&str, &'static str, &'static str)| {
        let runs = plates(&sample, breaking, contact);
        let point = |(k, run): (usize, &&Run)| Some([(k + 1) as f64, from_notch(run, 0)?]);
        Curve::marks(label, runs.iter().enumerate().filter_map(point))
    };
    let curves = [
        ("tension only", "tension only", "off"),
        ("tension only, with self contact", "tension only", "on"),
        ("two-sided breaking", "two-sided", "off"),
    ];
    let grids = plates(&sample, "tension only", "off").into_iter();
    let grids: Vec<String> = grids
        .enumerate()
        .map(|(k, run)| format!("{} = {}", k + 1, run.text("grid")))
        .collect();
    let figure = Figure::new(
        format!(
            "Angle between the cracks of the plate and its notches on grids (spacing, horizon) {}. Both sides agree in all \
             digits. Printed: 68 degrees.",
            grids.join("; ")
        ),
        Axis::linear("number of the grid", ""),
        Axis::linear("angle", "degrees"),
        curves.map(curve).into(),
    );
    Some(figure.with_guide(Guide::horizontal("printed", 68.0)))
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
        format!("Figure {figure}: area of the nodes with damage, of both crosses."),
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
        "Broken bonds of the plate over time; labels as in the table of the plate.",
        Axis::linear("time", "us"),
        Axis::linear("broken bonds", ""),
        sample.runs().filter_map(curve).collect(),
    ))
}
