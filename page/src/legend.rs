//! Legends: as a list below a figure of a page, and as rows of an SVG file.

use crate::curve::Style;
use crate::figure::Figure;
use crate::look::{DASHED, LINE, Look, MARK, THIN};
use maud::{Markup, html};
use plotters::style::RGBColor;

/// Width and height of the symbol of a curve in units of the figure.
const KEY: (u32, u32) = (110, 40);
/// Height of a row in units of the figure.
const ROW: u32 = 58;

/// Names and symbols of curves and guides.
fn entries(figure: &Figure) -> Vec<(Markup, &str)> {
    let curves = figure.curves.iter().enumerate();
    let curves = curves.map(|(k, curve)| (symbol(curve.style, &Look::of(k)), curve.label.as_str()));
    let guides = figure.guides.iter().enumerate();
    let guides = guides.map(|(k, guide)| {
        let look = Look::of_guide(k);
        (line(look.colour, THIN, look.dashes), guide.label.as_str())
    });
    curves.chain(guides).collect()
}

/// The legend of a figure as a list.
pub fn list(figure: &Figure) -> Markup {
    let (width, height) = KEY;
    html! {
        ul.legend {
            @for (symbol, label) in entries(figure) {
                li { svg.key viewBox=(format!("0 0 {width} {height}")) { (symbol) } " " (label) }
            }
        }
    }
}

/// The legend of a figure as rows below a point, and their height.
pub fn rows(figure: &Figure, (left, top): (u32, u32)) -> (Markup, u32) {
    let entries = entries(figure);
    let height = ROW * entries.len() as u32 + 20;
    let rows = html! {
        @for (row, (symbol, label)) in entries.into_iter().enumerate() {
            g transform=(format!("translate({left} {})", top + ROW * row as u32)) {
                (symbol)
                text x=(KEY.0 + 20) y="34" { (label) }
            }
        }
    };
    (rows, height)
}

/// The symbol of a curve.
fn symbol(style: Style, look: &Look) -> Markup {
    match style {
        Style::Line | Style::Steps => line(look.colour, LINE, look.dashes),
        Style::Dashed => line(look.colour, THIN, DASHED),
        Style::Marks => mark(look),
        Style::MarkedLine => html! { (line(look.colour, THIN, look.dashes)) (mark(look)) },
        Style::Cells => {
            html! { rect x="35" width="40" height="40" fill=(css(look.colour)) opacity="0.6" {} }
        }
    }
}

fn line(colour: RGBColor, width: u32, (dash, gap): (u32, u32)) -> Markup {
    let dashes = (gap > 0).then(|| format!("{dash} {gap}"));
    let middle = KEY.1 / 2;
    html! {
        line x2=(KEY.0) y1=(middle) y2=(middle) stroke=(css(colour)) stroke-width=(width) stroke-dasharray=[dashes] {}
    }
}

fn mark(look: &Look) -> Markup {
    let (x, y) = (f64::from(KEY.0 / 2), f64::from(KEY.1 / 2));
    let size = 1.3 * MARK;
    let corner =
        |&(across, down): &(f64, f64)| format!("{},{}", x + size * across, y + size * down);
    let corners: Vec<String> = look.corners.iter().map(corner).collect();
    let colour = css(look.colour);
    html! {
        @if corners.is_empty() { circle cx=(x) cy=(y) r=(size) fill=(colour) {} }
        @else { polygon points=(corners.join(" ")) fill=(colour) {} }
    }
}

fn css(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
