//! The page of a calibration.

mod figures;
mod sections;

use super::account::answer;
use super::calibration::Calibration;
use super::outcome::Outcome;
use figures::figures;
use gouge_page::{Figure, page};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use maud::html;
use std::path::Path;

/// Write `calibration.html`, and its figures as files.
///
/// # Errors
/// Failures of the file system.
pub fn write_page(calibration: &Calibration, outcome: &Outcome, out: &Path) -> Result<(), Error> {
    let figures = figures(calibration, outcome);
    let folder = out.join("figures");
    std::fs::create_dir_all(&folder).map_err(|error| Error::file("create", &folder, error))?;
    for (name, figure) in &figures {
        let path = folder.join(format!("{}.svg", name.replace([' ', '/'], "-")));
        let written = figure.write_svg(&path);
        written.map_err(|error| Error::file("write", &path, error))?;
    }
    let text = html(calibration, outcome, &figures);
    write_whole(&out.join("calibration.html"), text.as_bytes())
}

fn html(calibration: &Calibration, outcome: &Outcome, figures: &[(String, Figure)]) -> String {
    let of = |start: &[&str]| {
        let is_of = |name: &str| start.iter().any(|start| name.starts_with(start));
        let chosen = figures.iter().filter(|(name, _)| is_of(name));
        html! { @for (_, figure) in chosen { (figure.html()) } }
    };
    let body = html! {
        h1 { (calibration.title) }
        p { strong { "Answer: " (answer(calibration, outcome)) "." } }
        @if !calibration.notes.is_empty() {
            ul { @for note in &calibration.notes { li { (note) } } }
        }
        h2 { "Targets" }
        (sections::targets(calibration, outcome))
        (of(&["predictive"]))
        (sections::predictive(calibration, outcome))
        h2 { "Parameters" }
        (sections::parameters(calibration, outcome))
        (sections::combinations(calibration, outcome))
        (of(&["marginal", "profile", "pair"]))
        h2 { "Emulators" }
        (sections::emulators(calibration, outcome))
        (of(&["left-out", "residuals"]))
        h2 { "Runs" }
        (sections::runs(calibration, outcome))
        h2 { "What was computed" }
        (sections::method())
    };
    page(&calibration.title, body).into_string()
}
