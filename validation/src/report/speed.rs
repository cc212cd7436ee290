//! The chapter on speed: the measurements of `benches/runs/`, which running the checks does not repeat.

use include_dir::{Dir, include_dir};
use maud::{Markup, html};
use serde::Deserialize;

static RUNS: Dir = include_dir!("$CARGO_MANIFEST_DIR/../benches/runs");

/// A file of measurements.
#[derive(Deserialize)]
struct Run {
    before: Machine,
    cases: Vec<Case>,
    parts: Vec<Part>,
}

#[derive(Deserialize)]
struct Machine {
    words: String,
    instructions: String,
    addition_ns: f64,
    root_and_division_ns: f64,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    particles: usize,
    contacts: f64,
    bonds: f64,
    bytes: f64,
    rebuilds: [f64; 2],
    ours: Vec<f64>,
    peer: Option<(String, Vec<f64>)>,
}

#[derive(Deserialize)]
struct Part {
    name: String,
    with: Vec<f64>,
    without: Vec<f64>,
    by_hand: Option<Vec<f64>>,
    bytes: [f64; 2],
}

/// The latest run of a kind and its date: files are named by both.
fn latest(kind: &str) -> Option<(String, Run)> {
    let ending = format!("-{kind}.json");
    let files = RUNS.files().filter_map(|file| {
        let name = file.path().file_name()?.to_str()?;
        Some((name.strip_suffix(&ending)?.to_owned(), file))
    });
    let (date, file) = files.max_by(|a, b| a.0.cmp(&b.0))?;
    Some((date, serde_json::from_slice(file.contents()).ok()?))
}

fn quantile(sample: &[f64], probability: f64) -> f64 {
    let mut sorted = sample.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = probability * sorted.len().saturating_sub(1) as f64;
    sorted
        .get(place.round() as usize)
        .copied()
        .unwrap_or(f64::NAN)
}

/// Median and quartiles.
fn spread(sample: &[f64], digits: usize) -> String {
    let [low, middle, high] = [0.25, 0.5, 0.75].map(|probability| quantile(sample, probability));
    format!("{middle:.digits$} ({low:.digits$} to {high:.digits$})")
}

fn ratios(sample: &[f64], other: &[f64]) -> Vec<f64> {
    sample.iter().zip(other).map(|(a, b)| a / b).collect()
}

/// The chapter; nothing where nothing was measured.
pub fn chapter() -> Markup {
    html! {
        section id="speed" {
            h2 { "Speed" }
            p.about {
                "Measured by " code { "gouge-bench" } " on the machines named below, not when this page was made; raw results are in "
                code { "benches/runs/" } ", how to repeat them and what was tried in " code { "docs/performance.md" }
                ". Times are those of a particle-step in ns: medians with quartiles. What is compared took turns; ratios are those of neighbouring turns."
            }
            (scenes("peers", "Beside LAMMPS", "The same states, boxes and steps; LAMMPS moves the upper plate at 2 m/s, ours is driven."))
            (scenes("growth", "From a thousand to a million particles", "Pressed grains with truncated Cundall-Strack friction, repeated along the period; one thread."))
            (scenes("threads", "Threads", "The same grains with as many threads as are the default for their number, beside one thread."))
            (parts())
        }
    }
}

fn machine(date: &str, run: &Run) -> Markup {
    let Machine {
        words,
        instructions,
        addition_ns,
        root_and_division_ns,
    } = &run.before;
    html! {
        p.about {
            (date) ": " (words) ", " (instructions) "; a dependent addition takes " (format!("{addition_ns:.2}"))
            " ns, a square root with a division " (format!("{root_and_division_ns:.1}")) " ns."
        }
    }
}

fn scenes(kind: &str, title: &str, about: &str) -> Markup {
    let Some((date, run)) = latest(kind) else {
        return html! {};
    };
    html! {
        h3 { (title) }
        p { (about) }
        (machine(&date, &run))
        table {
            tr {
                th { "scene" } th.n { "particles" } th.n { "contacts a particle" } th.n { "bonds a particle" }
                th.n { "bytes a particle" } th.n { "rebuilds in 1000 steps" } th.n { "ours / ns" } th { "beside" } th.n { "its time / ns" } th.n { "ratio" }
            }
            @for case in &run.cases {
                tr {
                    td { (case.name) }
                    td.n { (case.particles) }
                    td.n { (format!("{:.2}", case.contacts)) }
                    td.n { (format!("{:.2}", case.bonds)) }
                    td.n { (format!("{:.0}", case.bytes)) }
                    td.n { (format!("{:.2}", 1e3 * case.rebuilds[0] / case.rebuilds[1])) }
                    td.n { (spread(&case.ours, 1)) }
                    @match &case.peer {
                        Some((name, times)) => {
                            td { (name) } td.n { (spread(times, 1)) } td.n { (spread(&ratios(&case.ours, times), 3)) }
                        }
                        None => { td {} td {} td {} }
                    }
                }
            }
        }
    }
}

fn parts() -> Markup {
    let Some((date, run)) = latest("parts") else {
        return html! {};
    };
    html! {
        h3 { "What is not there costs nothing" }
        p {
            "Each optional part with and without it; the loop by hand is plain code for exactly the scene without it ("
            code { "benches/src/by_hand.rs" } ") and moves every grain to within 1e-13 m as the kernel does."
        }
        (machine(&date, &run))
        table {
            tr {
                th { "part" } th.n { "with / ns" } th.n { "without / ns" } th.n { "by hand / ns" } th.n { "without over by hand" }
                th.n { "bytes a particle with" } th.n { "without" }
            }
            @for part in &run.parts {
                tr {
                    td { (part.name) }
                    td.n { (spread(&part.with, 1)) }
                    td.n { (spread(&part.without, 1)) }
                    @match &part.by_hand {
                        Some(hand) => { td.n { (spread(hand, 1)) } td.n { (spread(&ratios(&part.without, hand), 3)) } }
                        None => { td {} td {} }
                    }
                    td.n { (format!("{:.0}", part.bytes[0])) }
                    td.n { (format!("{:.0}", part.bytes[1])) }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{RUNS, Run, chapter, latest};

    #[test]
    fn every_run_can_be_read_and_every_kind_is_shown() {
        for file in RUNS.files() {
            let run = serde_json::from_slice::<Run>(file.contents());
            assert!(run.is_ok(), "{}: {:?}", file.path().display(), run.err());
        }
        let page = chapter().into_string();
        for kind in ["peers", "growth", "threads", "parts"] {
            let newest = latest(kind);
            assert!(newest.is_some(), "no run of {kind}");
            if let Some((date, run)) = newest {
                assert!(page.contains(&date));
                for case in &run.cases {
                    assert!(page.contains(&case.name), "{} is not shown", case.name);
                }
            }
        }
        assert!(!page.contains("NaN"));
    }
}
