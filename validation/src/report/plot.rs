//! Figures as SVG.

use super::thin::thin;
use crate::checks::{Axis, Curve, Plot, Style};
use maud::{Markup, PreEscaped, html};
use plotters::coord::Shift;
use plotters::prelude::*;

/// Size of a figure in its own units; the page scales it.
const SIZE: (u32, u32) = (1200, 780);

/// Colours that are distinguishable with colour blindness, after Okabe and Ito.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(120, 120, 120),
    RGBColor(86, 180, 233),
    RGBColor(150, 110, 0),
    RGBColor(0, 0, 0),
];

fn colour(position: usize) -> RGBColor {
    COLOURS[position % COLOURS.len()]
}

type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;
type Context<'a> = ChartContext<
    'a,
    SVGBackend<'a>,
    Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>,
>;

/// A figure with its title and legend.
pub fn figure(plot: &Plot) -> Markup {
    let mut text = String::new();
    let drawn = draw(plot, &mut text).is_ok();
    html! {
        figure {
            @if drawn { (PreEscaped(scalable(&text))) } @else { p { "This figure could not be drawn." } }
            figcaption {
                (plot.title)
                ul.legend {
                    @for (position, curve) in plot.curves.iter().enumerate() {
                        li { (key(curve, colour(position))) " " (curve.label) }
                    }
                }
            }
        }
    }
}

/// The symbol of a curve in the legend.
fn key(curve: &Curve, colour: RGBColor) -> Markup {
    let symbol = match curve.style {
        Style::Line => "\u{2501}",
        Style::Dashed => "\u{2505}",
        Style::Marks => "\u{25cf}",
        Style::MarkedLine => "\u{2501}\u{25cf}",
        Style::Cells => "\u{25a0}",
    };
    let RGBColor(red, green, blue) = colour;
    html! { span style=(format!("color:rgb({red},{green},{blue})")) { (symbol) } }
}

/// The figure without a fixed size.
fn scalable(text: &str) -> String {
    let (width, height) = SIZE;
    let sized = format!("width=\"{width}\" height=\"{height}\" ");
    text.replacen(&sized, "", 1)
}

/// Points of a curve in the coordinates of the axes: logarithms if the scale is logarithmic.
fn points(plot: &Plot, curve: &Curve) -> Vec<(f64, f64)> {
    let along = |axis: &Axis, value: f64| {
        if axis.logarithmic {
            value.log10()
        } else {
            value
        }
    };
    let at = |point: &[f64; 2]| (along(&plot.x, point[0]), along(&plot.y, point[1]));
    let drawable = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
    curve.points.iter().map(at).filter(drawable).collect()
}

/// Range of an axis: all data with a margin, or whole decades for a logarithmic scale.
fn range(axis: &Axis, values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    values.for_each(|value| (low, high) = (low.min(value), high.max(value)));
    if low > high {
        (low, high) = (0.0, 1.0);
    }
    if axis.logarithmic {
        let (low, high) = (low.floor(), high.ceil());
        return low..high.max(low + 1.0);
    }
    let margin = if high > low {
        0.04 * (high - low)
    } else {
        low.abs().max(1e-300)
    };
    low - margin..high + margin
}

fn draw<'a>(plot: &Plot, text: &'a mut String) -> Result<(), Failure<'a>> {
    let mut curves: Vec<Vec<(f64, f64)>> = plot
        .curves
        .iter()
        .map(|curve| points(plot, curve))
        .collect();
    let all = || curves.iter().flatten();
    let ranges = (
        range(&plot.x, all().map(|point| point.0)),
        range(&plot.y, all().map(|point| point.1)),
    );
    for (curve, points) in plot.curves.iter().zip(&mut curves) {
        let is_line = matches!(curve.style, Style::Line | Style::Dashed);
        *points = thin(std::mem::take(points), (&ranges.0, &ranges.1), is_line);
    }
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    let mut chart = frame(&area, plot, ranges)?;
    for (position, (curve, points)) in plot.curves.iter().zip(&curves).enumerate() {
        draw_curve(&mut chart, curve.style, points, colour(position))?;
    }
    area.present()
}

/// Axes, grid and labels.
fn frame<'a>(
    area: &DrawingArea<SVGBackend<'a>, Shift>,
    plot: &Plot,
    (x, y): (std::ops::Range<f64>, std::ops::Range<f64>),
) -> Result<Context<'a>, Failure<'a>> {
    let ticks = |axis: &Axis, range: &std::ops::Range<f64>| {
        let decades = (range.end - range.start) as usize + 1;
        if axis.logarithmic { decades.min(12) } else { 8 }
    };
    let (x_ticks, y_ticks) = (ticks(&plot.x, &x), ticks(&plot.y, &y));
    let (x_label, y_label) = (label_of(&plot.x, &x), label_of(&plot.y, &y));
    let mut chart = ChartBuilder::on(area)
        .margin(16)
        .margin_right(44)
        .x_label_area_size(74)
        .y_label_area_size(120)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .max_light_lines(0)
        .bold_line_style(RGBColor(225, 225, 225))
        .x_labels(x_ticks)
        .y_labels(y_ticks)
        .x_label_formatter(&x_label)
        .y_label_formatter(&y_label)
        .x_desc(&plot.x.label)
        .y_desc(&plot.y.label)
        .label_style(("sans-serif", 26))
        .axis_desc_style(("sans-serif", 28))
        .draw()?;
    Ok(chart)
}

/// Labels of the values on an axis: powers of ten, or enough digits to distinguish them.
fn label_of(axis: &Axis, range: &std::ops::Range<f64>) -> impl Fn(&f64) -> String + use<> {
    let (logarithmic, span) = (axis.logarithmic, range.end - range.start);
    let size = range.start.abs().max(range.end.abs());
    move |value: &f64| {
        if logarithmic {
            return format!("1e{}", value.round());
        }
        if !(1e-2..1e5).contains(&size) {
            return format!("{value:.2e}");
        }
        let decimals = (1.0 - (span / 8.0).log10().floor()).clamp(0.0, 9.0) as usize;
        format!("{value:.decimals$}")
    }
}

fn draw_curve<'a>(
    chart: &mut Context<'a>,
    style: Style,
    points: &[(f64, f64)],
    colour: RGBColor,
) -> Result<(), Failure<'a>> {
    let line = colour.stroke_width(3);
    if matches!(style, Style::Line | Style::MarkedLine) {
        chart.draw_series(LineSeries::new(points.iter().copied(), line))?;
    }
    match style {
        Style::Line => {}
        Style::Dashed => {
            chart.draw_series(DashedLineSeries::new(points.iter().copied(), 12, 8, line))?;
        }
        Style::Marks | Style::MarkedLine => {
            let mark = |&point: &(f64, f64)| Circle::new(point, 5, colour.filled());
            chart.draw_series(points.iter().map(mark))?;
        }
        Style::Cells => {
            let cell = |&point: &(f64, f64)| {
                EmptyElement::at(point)
                    + Rectangle::new([(-6, -6), (6, 6)], colour.mix(0.6).filled())
            };
            chart.draw_series(points.iter().map(cell))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::figure;
    use crate::checks::{Axis, Curve, Plot};

    #[test]
    fn a_figure_of_a_million_points_is_small() {
        let wave = (0..1_000_000).map(|i| [f64::from(i), (1e-2 * f64::from(i)).sin()]);
        let plot = Plot {
            title: "A wave".to_owned(),
            x: Axis::linear("t / s"),
            y: Axis::linear("x / m"),
            curves: vec![Curve::line("line", wave.clone()), Curve::line("line", wave)],
        };
        let size = figure(&plot).into_string().len();
        assert!((10_000..300_000).contains(&size), "{size} bytes");
    }
}
