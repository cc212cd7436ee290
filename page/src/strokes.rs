//! How guides, intervals and curves are drawn with plotters.

use crate::curve::Style;
use crate::draw::SIZE;
use crate::look::{DASHED, GREY, LINE, Look, MARK, THIN};
use crate::scale::Scale;
use plotters::prelude::*;
use std::ops::Range;

/// A line that is longer than this many widths of the figure winds too much for dashes.
const WINDING: f64 = 8.0;
/// Half of the side of a cell of a map.
const CELL: i32 = 8;

/// What plotters may return.
pub type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;
/// The axes that curves are drawn on.
pub type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<Scale, Scale>>;

/// A curve in coordinates of the axes.
pub struct Drawn {
    /// Its style.
    pub style: Style,
    /// Its look.
    pub look: Look,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// Position along `x` and the ends of the interval there.
    pub intervals: Vec<(f64, [f64; 2])>,
}

/// A line across the figure.
pub fn draw_guide<'a>(
    chart: &mut Chart<'a>,
    ends: [(f64, f64); 2],
    dashes: (u32, u32),
) -> Result<(), Failure<'a>> {
    if ends
        .iter()
        .all(|end| end.0.is_finite() && end.1.is_finite())
    {
        draw_line(chart, &ends, dashes, GREY.stroke_width(THIN))?;
    }
    Ok(())
}

/// Bars at marks, a band along lines. The logarithm of an end that is not positive is off the scale.
pub fn draw_intervals<'a>(
    chart: &mut Chart<'a>,
    curve: &Drawn,
    y: &Range<f64>,
) -> Result<(), Failure<'a>> {
    const CAP: i32 = 9;
    let colour = curve.look.colour;
    let on_scale = |&(x, [low, high]): &(f64, [f64; 2])| {
        let low = if low.is_finite() { low } else { y.start };
        (x, low, high)
    };
    let intervals = || curve.intervals.iter().map(on_scale);
    if !curve.style.has_marks() {
        let above = intervals().map(|(x, _, high)| (x, high));
        let below = intervals().rev().map(|(x, low, _)| (x, low));
        let band: Vec<(f64, f64)> = above.chain(below).collect();
        chart.draw_series([Polygon::new(band, colour.mix(0.2).filled())])?;
        return Ok(());
    }
    let line = colour.stroke_width(THIN);
    chart.draw_series(
        intervals().map(|(x, low, high)| PathElement::new([(x, low), (x, high)], line)),
    )?;
    let ends = intervals().flat_map(|(x, low, high)| [(x, low), (x, high)]);
    let cap = |end| EmptyElement::at(end) + PathElement::new([(-CAP, 0), (CAP, 0)], line);
    chart.draw_series(ends.map(cap))?;
    Ok(())
}

/// The points of a curve.
pub fn draw_curve<'a>(
    chart: &mut Chart<'a>,
    curve: &Drawn,
    y: &Range<f64>,
) -> Result<(), Failure<'a>> {
    let colour = curve.look.colour;
    match curve.style {
        Style::Line => draw_line(
            chart,
            &curve.points,
            curve.look.dashes,
            colour.stroke_width(LINE),
        ),
        Style::Dashed => draw_line(chart, &curve.points, DASHED, colour.stroke_width(THIN)),
        Style::Marks => draw_marks(chart, curve),
        Style::MarkedLine => {
            draw_line(
                chart,
                &curve.points,
                curve.look.dashes,
                colour.stroke_width(THIN),
            )?;
            draw_marks(chart, curve)
        }
        Style::Cells => draw_cells(chart, &curve.points, colour.mix(0.6).filled()),
        Style::Steps => {
            let steps = steps(&curve.points);
            let base = y.start.max(0.0).min(y.end);
            let ends = [steps.last(), steps.first()].into_iter().flatten();
            let below = ends.map(|point| (point.0, base));
            let area: Vec<(f64, f64)> = steps.iter().copied().chain(below).collect();
            chart.draw_series([Polygon::new(area, colour.mix(0.15).filled())])?;
            draw_line(chart, &steps, curve.look.dashes, colour.stroke_width(LINE))
        }
    }
}

/// Squares around points; those of a column that touch each other are one rectangle, which a map has much fewer of.
fn draw_cells<'a>(
    chart: &mut Chart<'a>,
    points: &[(f64, f64)],
    style: ShapeStyle,
) -> Result<(), Failure<'a>> {
    let place = |point: &(f64, f64)| chart.backend_coord(point);
    let mut points = points.to_vec();
    points.sort_unstable_by_key(place);
    let touch = |one: &(f64, f64), next: &(f64, f64)| {
        let ((x, y), (next_x, next_y)) = (place(one), place(next));
        x == next_x && next_y - y <= 2 * CELL
    };
    let columns: Vec<_> = points.chunk_by(touch).collect();
    let rectangle = |cells: &&[(f64, f64)]| {
        let (first, last) = (cells.first()?, cells.last()?);
        let height = place(last).1 - place(first).1;
        let corners = [(-CELL, -CELL), (CELL, CELL + height)];
        Some((*first, corners))
    };
    let rectangles: Vec<_> = columns.iter().filter_map(rectangle).collect();
    let drawn = rectangles
        .into_iter()
        .map(|(first, corners)| EmptyElement::at(first) + Rectangle::new(corners, style));
    chart.draw_series(drawn)?;
    Ok(())
}

/// Horizontal from each point to the next one.
fn steps(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let each = points
        .windows(2)
        .flat_map(|two| [two[0], (two[1].0, two[0].1)]);
    each.chain(points.last().copied()).collect()
}

fn draw_line<'a>(
    chart: &mut Chart<'a>,
    points: &[(f64, f64)],
    (dash, gap): (u32, u32),
    style: ShapeStyle,
) -> Result<(), Failure<'a>> {
    let places = points.iter().map(|point| chart.backend_coord(point));
    let places: Vec<(i32, i32)> = places.collect();
    let between =
        |two: &[(i32, i32)]| f64::from(two[1].0 - two[0].0).hypot(f64::from(two[1].1 - two[0].1));
    let length: f64 = places.windows(2).map(between).sum();
    let points = points.iter().copied();
    if gap == 0 || length > WINDING * f64::from(SIZE.0) {
        chart.draw_series(LineSeries::new(points, style))?;
    } else {
        chart.draw_series(DashedLineSeries::new(points, dash, gap, style))?;
    }
    Ok(())
}

fn draw_marks<'a>(chart: &mut Chart<'a>, curve: &Drawn) -> Result<(), Failure<'a>> {
    let style = curve.look.colour.filled();
    let points = curve.points.iter().copied();
    if curve.look.corners.is_empty() {
        chart.draw_series(points.map(|point| Circle::new(point, MARK, style)))?;
        return Ok(());
    }
    let of_unit = |part: f64| (MARK * part).round() as i32;
    let corners = curve.look.corners.iter();
    let corners: Vec<(i32, i32)> = corners.map(|&(x, y)| (of_unit(x), of_unit(y))).collect();
    let mark = |point| EmptyElement::at(point) + Polygon::new(corners.clone(), style);
    chart.draw_series(points.map(mark))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::steps;

    #[test]
    fn a_step_reaches_to_the_next_point() {
        let points = [(1.0, 4.0), (2.0, 5.0), (3.0, 5.0)];
        let corners = [(1.0, 4.0), (2.0, 4.0), (2.0, 5.0), (3.0, 5.0), (3.0, 5.0)];
        assert_eq!(steps(&points), corners);
    }
}
