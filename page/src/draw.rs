//! Figures as SVG: axes with plotters, title and legend around them.

use crate::axis::Ticks;
use crate::curve::{Curve, Style};
use crate::figure::{Figure, Guide};
use crate::legend;
use crate::look::{GREY, Look};
use crate::scale::Scale;
use crate::strokes::{Chart, Drawn, Failure, draw_curve, draw_guide, draw_intervals};
use crate::thin::thin;
use maud::{PreEscaped, html};
use plotters::prelude::*;
use std::io;
use std::ops::Range;

/// Size of the plot in its own units.
pub const SIZE: (u32, u32) = (1440, 930);
/// Height of letters in units of the figure, times the factor by which plotters reduces them.
const LETTERS: i32 = 50;
/// Space for the title of an axis, beside its labels.
const TITLE: u32 = 64;
/// Number of labels of the vertical axis.
const Y_LABELS: usize = 8;

/// The SVG file of a figure.
pub fn draw(figure: &Figure) -> io::Result<String> {
    const INDENT: u32 = 30;
    let plot = plot(figure)?;
    let title = textwrap::wrap(&figure.title, 66);
    let top = 64 * title.len() as u32 + 10;
    let (width, height) = SIZE;
    let (legend, below) = legend::rows(figure, (INDENT, top + height));
    let text = html! {
        svg xmlns="http://www.w3.org/2000/svg" viewBox=(format!("0 0 {width} {}", top + height + below)) font-family="sans-serif" font-size="40" {
            rect width="100%" height="100%" fill="white" {}
            @for (line, words) in title.iter().enumerate() {
                text x=(INDENT) y=(56 + 64 * line) { (words) }
            }
            svg y=(top) width=(width) height=(height) { (PreEscaped(plot)) }
            (legend)
        }
    };
    Ok(text.into_string())
}

/// The axes and curves of a figure, of any size.
pub fn plot(figure: &Figure) -> io::Result<String> {
    let mut text = String::new();
    draw_plot(figure, &mut text).map_err(|error| io::Error::other(error.to_string()))?;
    let (width, height) = SIZE;
    let sized = format!("width=\"{width}\" height=\"{height}\" ");
    Ok(text.replacen(&sized, "", 1))
}

fn draw_plot<'a>(figure: &Figure, text: &'a mut String) -> Result<(), Failure<'a>> {
    let curves = figure.curves.iter().enumerate();
    let mut curves: Vec<Drawn> = curves.map(|(k, curve)| drawn(figure, k, curve)).collect();
    let ranges = ranges(figure, &curves);
    for curve in &mut curves {
        if curve.intervals.is_empty() {
            let points = std::mem::take(&mut curve.points);
            curve.points = thin(points, (&ranges.0, &ranges.1), curve.style.is_line());
        }
    }
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    let mut chart = axes(&area, figure, &ranges)?;
    for (position, guide) in figure.guides.iter().enumerate() {
        let dashes = Look::of_guide(position).dashes;
        draw_guide(&mut chart, ends_of(figure, guide, &ranges), dashes)?;
    }
    for curve in &curves {
        draw_intervals(&mut chart, curve, &ranges.1)?;
        draw_curve(&mut chart, curve, &ranges.1)?;
    }
    area.present()
}

/// The part of a curve that can be drawn.
fn drawn(figure: &Figure, position: usize, curve: &Curve) -> Drawn {
    let (x, y) = (
        |value: f64| figure.x.along(value),
        |value: f64| figure.y.along(value),
    );
    let points = curve.points.iter().map(|point| (x(point[0]), y(point[1])));
    let intervals = curve.points.iter().zip(&curve.intervals);
    let intervals = intervals.map(|(point, interval)| (x(point[0]), interval.map(y)));
    Drawn {
        style: curve.style,
        look: Look::of(position),
        points: points
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect(),
        intervals: intervals
            .filter(|(x, [_, high])| x.is_finite() && high.is_finite())
            .collect(),
    }
}

/// The ranges of both axes: all that is drawn.
fn ranges(figure: &Figure, curves: &[Drawn]) -> (Range<f64>, Range<f64>) {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let ends = curves.iter().flat_map(|curve| &curve.intervals);
    let guides = |is_horizontal: bool| {
        let guides = figure.guides.iter();
        guides
            .filter(move |guide| guide.is_horizontal == is_horizontal)
            .map(|guide| guide.value)
    };
    let is_histogram = curves.iter().any(|curve| curve.style == Style::Steps);
    let base = (is_histogram && !figure.y.is_logarithmic()).then_some(0.0);
    let x = points().map(|point| point.0);
    let y = points().map(|point| point.1);
    let (across, up) = (
        guides(false).map(|x| figure.x.along(x)),
        guides(true).map(|y| figure.y.along(y)),
    );
    (
        figure.x.range(x.chain(across)),
        figure.y.range(
            y.chain(ends.flat_map(|(_, ends)| *ends))
                .chain(up)
                .chain(base),
        ),
    )
}

/// Axes, grid and labels.
fn axes<'a>(
    area: &DrawingArea<SVGBackend<'a>, plotters::coord::Shift>,
    figure: &Figure,
    (x, y): &(Range<f64>, Range<f64>),
) -> Result<Chart<'a>, Failure<'a>> {
    let y_ticks = Ticks::at_most(Y_LABELS, &figure.y, y);
    let left = TITLE + y_ticks.width() as u32 + 20;
    let width = SIZE.0 - left - 60;
    let x_ticks = Ticks::beside_each_other(&figure.x, x, f64::from(width));
    let (x_title, y_title) = (x_ticks.title.clone(), y_ticks.title.clone());
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .margin_top(24)
        .margin_right(48)
        .x_label_area_size(TITLE + 60)
        .y_label_area_size(left)
        .build_cartesian_2d(
            Scale::new(x.clone(), x_ticks),
            Scale::new(y.clone(), y_ticks),
        )?;
    chart
        .configure_mesh()
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(2))
        .axis_style(GREY.stroke_width(2))
        .x_desc(x_title)
        .y_desc(y_title)
        .label_style(("sans-serif", LETTERS))
        .axis_desc_style(("sans-serif", LETTERS))
        .draw()?;
    Ok(chart)
}

/// Both ends of a guide in coordinates of the axes.
fn ends_of(figure: &Figure, guide: &Guide, (x, y): &(Range<f64>, Range<f64>)) -> [(f64, f64); 2] {
    if guide.is_horizontal {
        let value = figure.y.along(guide.value);
        return [(x.start, value), (x.end, value)];
    }
    let value = figure.x.along(guide.value);
    [(value, y.start), (value, y.end)]
}

#[cfg(test)]
mod tests {
    use crate::{Axis, Curve, Figure, Guide, Style};
    use std::ops::Range;

    #[test]
    fn a_figure_of_a_million_points_is_small() {
        let wave = (0..1_000_000).map(|i| [f64::from(i), (1e-2 * f64::from(i)).sin()]);
        let curves = vec![Curve::line("line", wave.clone()), Curve::line("line", wave)];
        let figure = Figure::new(
            "A wave",
            Axis::linear("t", "s"),
            Axis::linear("x", "m"),
            curves,
        );
        let size = figure.html().into_string().len();
        assert!((10_000..300_000).contains(&size), "{size} bytes");
    }

    #[test]
    fn cells_that_touch_are_one_rectangle() -> std::io::Result<()> {
        let grid = |missing: Range<i32>| {
            let points = (0..40).flat_map(move |k| (0..60).map(move |l| [k, l]));
            let outside = move |p: &[i32; 2]| p[0] != 20 || !missing.contains(&p[1]);
            points.filter(outside).map(|p| p.map(f64::from))
        };
        let rectangles = |missing: Range<i32>| {
            let (x, y) = (Axis::linear("x", ""), Axis::linear("y", ""));
            let figure = Figure::new(
                "A map",
                x,
                y,
                vec![Curve::new("stable", Style::Cells, grid(missing))],
            );
            let plot = super::plot(&figure)?;
            std::io::Result::Ok(plot.matches("<rect ").count())
        };
        assert_eq!(rectangles(0..0)? - rectangles(0..60)?, 1);
        assert_eq!(rectangles(20..30)? - rectangles(0..0)?, 1);
        Ok(())
    }

    /// Numbers of an attribute of all elements of a kind.
    fn numbers(svg: &str, element: &str, attribute: &str) -> Vec<f64> {
        let start = format!("<{element} ");
        let elements = svg.split(&start).skip(1);
        let key = format!(" {attribute}=\"");
        let values = elements.filter_map(|e| {
            e.split('>')
                .next()?
                .split(&key)
                .nth(1)?
                .split('"')
                .next()?
                .parse()
                .ok()
        });
        values.collect()
    }

    #[test]
    fn equal_factors_are_equal_distances_on_a_logarithmic_axis() -> std::io::Result<()> {
        let points = [
            [1.0, 1e-9],
            [2.0, 1e-6],
            [3.0, 1e-3],
            [4.0, 0.0],
            [5.0, f64::NAN],
        ];
        let (x, y) = (Axis::linear("x", ""), Axis::logarithmic("error", ""));
        let svg = Figure::new("", x, y, vec![Curve::marks("marks", points)]).svg()?;
        let heights = numbers(&svg, "circle", "cy");
        assert_eq!(heights.len(), 4, "three points and the legend: {svg}");
        let (first, second) = (heights[0] - heights[1], heights[1] - heights[2]);
        assert!(
            first > 100.0 && (first - second).abs() <= 2.0,
            "{heights:?}"
        );
        Ok(())
    }

    #[test]
    fn bars_and_guides_are_within_the_axes() -> std::io::Result<()> {
        let marks = Curve::marks("mean", [[0.0, 1.0], [1.0, 2.0]])
            .with_intervals([[-5.0, 1.5], [0.0, 9.0]]);
        let (x, y) = (Axis::linear("x", ""), Axis::linear("y", ""));
        let figure =
            Figure::new("", x, y, vec![marks]).with_guide(Guide::horizontal("limit", 20.0));
        let svg = figure.svg()?;
        assert!(svg.contains(">limit<"), "{svg}");
        let lines = svg.split(" points=\"").skip(1);
        let lines = lines.filter_map(|line| line.split('"').next());
        let points = lines.flat_map(|line| line.split(' ').filter_map(|at| at.split_once(',')));
        let heights: Vec<f64> = points.filter_map(|(_, y)| y.parse().ok()).collect();
        let highest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let lowest = heights.iter().copied().fold(0.0, f64::max);
        assert!(
            highest >= 24.0 && lowest < f64::from(super::SIZE.1) - 100.0,
            "{heights:?}"
        );
        Ok(())
    }

    #[test]
    fn a_histogram_has_a_step_per_height_and_begins_at_zero() -> std::io::Result<()> {
        let counts = Curve::histogram("counts", &[1.0, 2.0, 3.0], &[40.0, 50.0]);
        let points = counts.points.clone();
        assert_eq!(points, [[1.0, 40.0], [2.0, 50.0], [3.0, 50.0]]);
        let svg = Figure::new(
            "",
            Axis::linear("x", ""),
            Axis::linear("n", ""),
            vec![counts],
        )
        .svg()?;
        assert!(svg.contains("\n0\n"), "{svg}");
        Ok(())
    }
}
