//! What a page of a study shows below its tables.

use super::pictures::{Kept, Shown};
use gouge_page::Figure;
use gouge_runner::error::Error;
use gouge_runner::peridem::damage_colours;
use maud::{Markup, PreEscaped, html};

/// Rules of pictures beside each other: they share one scale of colours.
pub const STYLE: &str = "
figure.panels { max-width: none; }
figure.panels > div { display: grid; grid-template-columns: repeat(auto-fit, minmax(15rem, 1fr)); gap: .6rem 1rem; }
figure.panels figure { margin: 0; }
figure.panels g.legend { display: none; }
figure.panels > svg.scale { width: 20rem; max-width: 100%; margin: .4rem 0; }
figure.drawing { max-width: none; }
@media print { figure.panels, figure.drawing { max-width: none; } figure.panels > div { grid-template-columns: repeat(3, 1fr); } }
";

/// A figure, a drawing, or final states of runs.
pub enum Illustration {
    /// Curves between two axes.
    Figure(Figure),
    /// An SVG element and its caption.
    Drawing(Markup, String),
    /// The final state of a run.
    Picture(Shown),
    /// Final states of peridynamic grains beside each other.
    Panels(Panels),
}

/// Final states of peridynamic grains beside each other, coloured by damage.
pub struct Panels {
    /// What they show, as a sentence.
    pub caption: String,
    /// The states, each with what is said of it.
    pub panels: Vec<(Shown, String)>,
}

/// Figures as illustrations.
pub fn each(figures: Vec<Figure>) -> Vec<Illustration> {
    figures.into_iter().map(Illustration::Figure).collect()
}

impl Illustration {
    /// The element of a page; pictures that it shows are kept beside the tables of the study.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn html(&self, kept: &Kept) -> Result<Markup, Error> {
        Ok(match self {
            Self::Figure(figure) => figure.html(),
            Self::Drawing(svg, caption) => html! {
                figure.drawing { (svg) figcaption { (caption) } }
            },
            Self::Picture(shown) => match kept.picture(shown)? {
                Some((svg, caption)) => picture(&svg, &caption),
                None => Markup::default(),
            },
            Self::Panels(panels) => panels.html(kept)?,
        })
    }
}

fn picture(svg: &str, caption: &str) -> Markup {
    html! { figure { (PreEscaped(svg)) figcaption { (caption) } } }
}

impl Panels {
    /// Nothing if no state was kept.
    fn html(&self, kept: &Kept) -> Result<Markup, Error> {
        let mut panels = Vec::new();
        for (shown, label) in &self.panels {
            let found = kept.picture(shown)?;
            panels.extend(found.map(|(svg, _)| picture(&svg, label)));
        }
        Ok(match panels.is_empty() {
            true => Markup::default(),
            false => html! {
                figure.panels {
                    div { @for panel in panels { (panel) } }
                    (scale())
                    figcaption { (self.caption) }
                }
            },
        })
    }
}

/// The colours of damage from 0 to 1.
fn scale() -> Markup {
    let colours = damage_colours();
    let width = 240.0 / colours.len() as f64;
    html! {
        svg.scale viewBox="0 0 400 42" font-family="sans-serif" font-size="14" {
            text x="0" y="16" { "damage" }
            @for (k, colour) in colours.iter().enumerate() {
                rect x=(format!("{:.1}", 70.0 + width * k as f64)) y="2" width=(format!("{:.1}", width + 0.5)) height="18" fill=(colour) {}
            }
            text x="70" y="38" { "0: all bonds" }
            text x="310" y="38" text-anchor="end" { "1: none left" }
        }
    }
}
