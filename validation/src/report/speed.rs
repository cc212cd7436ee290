//! The chapter on speed, from the measurements in `benches/runs/`, which are not repeated with the
//! checks.

use super::fold::Fold;
use crate::measurements::{latest, quantile, ratios, spread};
use maud::{Markup, html};
use serde::Deserialize;

/// A file of measurements.
#[derive(Deserialize)]
struct Run {
    before: Machine,
    cases: Vec<Case>,
    parts: Vec<Part>,
    counting: Option<Counting>,
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

impl Case {
    /// The number of steps and the kernel's total time for them, from alternating runs of equal length.
    fn duration(&self) -> String {
        let steps = self.rebuilds[1];
        let of_step =
            self.ours.iter().sum::<f64>() / self.ours.len() as f64 * self.particles as f64;
        let seconds = (1e-9 * of_step * steps).round();
        format!(
            "the kernel took {:.0} min {:.0} s for {steps:.0} steps",
            (seconds / 60.0).floor(),
            seconds % 60.0
        )
    }
}

#[derive(Deserialize)]
struct Part {
    name: String,
    with: Vec<f64>,
    without: Vec<f64>,
    by_hand: Option<Vec<f64>>,
    bytes: [f64; 2],
}

/// Instructions and memory traffic per step, and the limits of the machine.
#[derive(Deserialize)]
struct Counting {
    instructions: String,
    limits: Limits,
    scenes: Vec<Counts>,
}

#[derive(Deserialize)]
struct Limits {
    instructions_per_ns: f64,
    root_and_division_ns: f64,
    bytes_per_ns: f64,
    usual_bytes_per_ns: f64,
}

/// Counts per particle and step.
#[derive(Deserialize)]
struct Counts {
    name: String,
    links: f64,
    instructions: f64,
    bytes_beyond_first_cache: f64,
    bytes_of_memory: f64,
    ours: Vec<f64>,
}

impl Counts {
    /// Shortest possible time in ns for the instructions, for the square roots with divisions (one per
    /// near pair or bond), and for the memory traffic.
    fn least_times(&self, limits: &Limits) -> [f64; 3] {
        [
            self.instructions / limits.instructions_per_ns,
            self.links * limits.root_and_division_ns,
            self.bytes_of_memory / limits.bytes_per_ns,
        ]
    }
}

/// The chapter; sections without measurements are left out.
pub fn chapter() -> Markup {
    Fold {
        id: "speed",
        title: "Speed",
        count: "stored measurements",
        class: "other",
    }
    .around(html! {
            p.about {
                "Measured by " code { "gouge-bench" } " on the machines named below, not when this page was made. Raw results are in "
                code { "benches/runs/" } "; how to repeat the measurements, and what was tried, is in " code { "docs/performance.md" }
                ". Times are ns per particle and step: medians with quartiles. Programs that are compared ran alternately; ratios are those of neighbouring runs."
            }
            (scenes("peers", "Compared with LAMMPS", "The same states, boxes and time steps; LAMMPS moves the upper plate at 2 m/s, our scene drives it."))
            (whole())
            (scenes("growth", "From a thousand to a million particles", "Compressed grains with truncated Cundall-Strack friction, repeated along the period; one thread."))
            (scenes("threads", "Threads", "The same grains with the default number of threads for their number, compared with one thread."))
            (parts())
            (counting())
    })
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
    let Some((date, run)) = latest::<Run>(kind) else {
        return html! {};
    };
    let is_compared = run.cases.iter().any(|case| case.peer.is_some());
    html! {
        h3 { (title) }
        p { (about) }
        (machine(&date, &run))
        div.data {
            table {
                tr {
                    th { "scene" } th.n { "kernel / ns" }
                    @if is_compared { th { "compared with" } th.n { "its time / ns" } th.n { "ratio" } }
                    th.n { "particles" } th.n { "contacts per particle" } th.n { "bonds per particle" }
                    th.n { "bytes per particle" } th.n { "rebuilds in 1000 steps" }
                }
                @for case in &run.cases {
                    tr {
                        td { (case.name) }
                        td.n { (spread(&case.ours, 1)) }
                        @match &case.peer {
                            Some((name, times)) => {
                                td { (name) } td.n { (spread(times, 1)) } td.n { (spread(&ratios(&case.ours, times), 3)) }
                            }
                            None if is_compared => { td {} td {} td {} }
                            None => {}
                        }
                        td.n { (case.particles) }
                        td.n { (format!("{:.2}", case.contacts)) }
                        td.n { (format!("{:.2}", case.bonds)) }
                        td.n { (format!("{:.0}", case.bytes)) }
                        td.n { (format!("{:.2}", 1e3 * case.rebuilds[0] / case.rebuilds[1])) }
                    }
                }
            }
        }
    }
}

/// The granite fault over its whole shear.
fn whole() -> Markup {
    let run = latest::<Run>("whole");
    let Some(case) = run.as_ref().and_then(|(_, run)| run.cases.first()) else {
        return html! {};
    };
    let about = format!(
        "Energy ledger off, one thread, in {} alternating runs with LAMMPS: {}.",
        case.ours.len(),
        case.duration()
    );
    scenes("whole", "The whole shear of the granite fault", &about)
}

fn counting() -> Markup {
    let Some((date, run)) = latest::<Run>("counts") else {
        return html! {};
    };
    let Some(Counting {
        instructions,
        limits,
        scenes,
    }) = &run.counting
    else {
        return html! {};
    };
    html! {
        h3 { "Distance from the limits of the machine" }
        p {
            "Instructions and cache misses are counted by callgrind with " (instructions)
            " (first cache 32 KiB, last cache 16 MiB; lines of 64 bytes, including those written back) and divided by the number of near pairs and bonds. "
            "The machine executes " (format!("{:.2}", limits.instructions_per_ns)) " instructions per ns in a loop without dependencies or memory access, "
            "takes " (format!("{:.2}", limits.root_and_division_ns)) " ns per square root with a division if many are independent, and moves "
            (format!("{:.1}", limits.bytes_per_ns)) " bytes per ns from and to its memory with one core alone, usually "
            (format!("{:.1}", limits.usual_bytes_per_ns)) " while other users of the host access it too. "
            "A fraction is the shortest time allowed by this limit alone over the median time of the kernel."
        }
        (machine(&date, &run))
        div.data {
            table {
                tr {
                    th { "scene" } th.n { "near pairs and bonds per particle" } th.n { "instructions per pair and step" } th.n { "bytes per pair and step from beyond the first cache" }
                    th.n { "from memory" } th.n { "kernel / ns per particle and step" } th.n { "fraction of the instruction limit" } th.n { "of the limit of roots and divisions" } th.n { "of the memory limit" }
                }
                @for scene in scenes {
                    tr {
                        td { (scene.name) }
                        td.n { (format!("{:.2}", scene.links)) }
                        td.n { (format!("{:.0}", scene.instructions / scene.links)) }
                        td.n { (format!("{:.0}", scene.bytes_beyond_first_cache / scene.links)) }
                        td.n { (format!("{:.0}", scene.bytes_of_memory / scene.links)) }
                        td.n { (spread(&scene.ours, 1)) }
                        @for least in scene.least_times(limits) {
                            td.n { (format!("{:.0} %", 100.0 * least / quantile(&scene.ours, 0.5))) }
                        }
                    }
                }
            }
        }
    }
}

fn parts() -> Markup {
    let Some((date, run)) = latest::<Run>("parts") else {
        return html! {};
    };
    html! {
        h3 { "Parts that a scene does not use cost nothing" }
        p {
            "Each optional part with and without it. The loop by hand is plain code for exactly the scene without the part ("
            code { "benches/src/by_hand.rs" } "); it moves every grain as the kernel does to within 1e-13 m. "
            "A trajectory is a frame of extended XYZ every 500 steps; its bytes are all bytes allocated for writing."
        }
        (machine(&date, &run))
        div.data {
            table {
                tr {
                    th { "part" } th.n { "with / ns" } th.n { "without / ns" } th.n { "by hand / ns" } th.n { "without / by hand" }
                    th.n { "bytes per particle with" } th.n { "bytes per particle without" }
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
}

#[cfg(test)]
mod tests {
    use super::{Run, chapter};
    use crate::measurements::{RUNS, latest};

    #[test]
    fn every_run_can_be_read_and_every_kind_is_shown() {
        let is_json = |path: &std::path::Path| path.extension().is_some_and(|end| end == "json");
        for file in RUNS.files().filter(|file| is_json(file.path())) {
            let run = serde_json::from_slice::<Run>(file.contents());
            assert!(run.is_ok(), "{}: {:?}", file.path().display(), run.err());
        }
        let page = chapter().into_string();
        for kind in ["peers", "whole", "growth", "threads", "parts", "counts"] {
            let newest = latest::<Run>(kind);
            assert!(newest.is_some(), "no run of {kind}");
            if let Some((date, run)) = newest {
                assert!(page.contains(&date));
                let counts = run.counting.iter().flat_map(|counting| &counting.scenes);
                let scenes = run.cases.iter().map(|case| &case.name);
                for name in scenes.chain(counts.map(|counts| &counts.name)) {
                    assert!(page.contains(name), "{name} is not shown");
                }
            }
        }
        assert!(!page.contains("NaN"));
    }
}
