//! The chapter on the program of the thesis's author: the effect of its moment of inertia on friction,
//! from recorded runs.

use super::fold::Fold;
use crate::measurements::{FrictionRun, Paired, friction_runs};
use gouge_dem::model::Reading;
use maud::{Markup, html};

/// Confidence level of the intervals.
const LEVEL: f64 = 0.95;
/// Change of a friction coefficient below which it is considered irrelevant, fixed before the runs.
const MARGIN: f64 = 0.05;

/// A quantity with the moment of inertia of spheres and with the author's.
struct Compared {
    name: &'static str,
    means: [f64; 2],
    changes: Paired,
    verdict: &'static str,
}

impl Compared {
    /// Expects the runs of each seed next to each other.
    fn of(
        name: &'static str,
        margin: Option<f64>,
        runs: &[FrictionRun],
        value: fn(&FrictionRun) -> f64,
    ) -> Self {
        let column = |reading: Reading| -> Vec<f64> {
            let factor = reading.inertia_factor();
            let chosen = runs.iter().filter(|run| run.inertia_factor == factor);
            chosen.map(value).collect()
        };
        let [sphere, computed] = [Reading::Corrected, Reading::Thesis].map(column);
        let differences = sphere.iter().zip(&computed).map(|(s, c)| c - s).collect();
        let changes = Paired::new(differences);
        let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
        Self {
            name,
            verdict: verdict(changes.interval(LEVEL), margin),
            means: [mean(sphere), mean(computed)],
            changes,
        }
    }

    fn row(&self) -> Markup {
        let [low, high] = self.changes.interval(LEVEL);
        html! {
            tr {
                td { (self.name) }
                td { (self.changes.number()) }
                @for mean in self.means { td { (format!("{mean:.4}")) } }
                td { (format!("{:+.4}", self.changes.mean())) }
                td { (format!("{low:+.4} to {high:+.4}")) }
                td { (format!("{:.3}", self.changes.p_by_t())) }
                td { (format!("{:.3}", self.changes.p_by_signs())) }
                td { (self.verdict) }
            }
        }
    }
}

/// Verdict from the confidence interval of a change and the margin, if there is one, within which the
/// change is irrelevant.
fn verdict([low, high]: [f64; 2], margin: Option<f64>) -> &'static str {
    let is_shown = low > 0.0 || high < 0.0;
    let is_small = margin.map(|margin| low > -margin && high < margin);
    match (is_shown, is_small) {
        (true, Some(true)) => "significant, but below 0.05",
        (true, _) => "significant",
        (false, Some(true)) => "not significant; below 0.05",
        (false, Some(false)) => "not significant; a change of 0.05 is not excluded",
        (false, None) => "not significant",
    }
}

/// The chapter; empty without recorded runs.
pub fn chapter() -> Markup {
    let Some((date, runs)) = friction_runs() else {
        return html! {};
    };
    let margin = Some(MARGIN);
    let compared = [
        Compared::of(
            "friction from the load, thesis (85)",
            margin,
            &runs,
            |run| run.friction_load,
        ),
        Compared::of(
            "friction from the reaction, thesis (86)",
            margin,
            &runs,
            |run| run.friction_feedback,
        ),
        Compared::of("broken bonds", None, &runs, |run| run.bonds_broken),
    ];
    Fold {
        id: "original",
        title: "The author's program",
        count: "stored measurements",
        class: "other",
    }
    .around(html! {
            p.about {
                "The author's program uses the moment of inertia 3/5 m r^2 instead of the printed 2/5 m r^2 (thesis E64), so every grain resists rotation 1.5 times too much. "
                "The effect on friction was measured on the small fault, the scene " code { "granite-fault-small" }
                ": each seed was run with both values and no other change. "
                "Friction is the signed mean over all samples while the fault slides, from 2.5 ms (after 5 mm of sliding) to the end at 12.5 ms. Start, margin and tests were fixed before the runs. "
                "Intervals and tests refer to single quantities, without a correction for multiple testing. "
                "Recorded on " (date) " by " code { "gouge-bench inertia" } ", not when this page was made; raw results are in " code { "benches/runs/" } "."
            }
            div.data {
                table {
                    caption { "3/5 m r^2 compared with 2/5 m r^2, paired by seed" }
                    tr {
                        @for name in ["", "seeds", "mean, 2/5", "mean, 3/5", "change", "95 % interval", "p, t test", "p, sign test", "verdict"] { th { (name) } }
                    }
                    @for one in &compared { (one.row()) }
                }
            }
    })
}

#[cfg(test)]
mod tests {
    use super::chapter;
    use crate::measurements::friction_runs;

    #[test]
    fn the_recorded_runs_can_be_read_and_each_seed_is_paired() {
        let (date, runs) = friction_runs().unwrap_or_default();
        assert!(runs.len() >= 32, "at least sixteen seeds");
        for factor in [0.4, 0.6] {
            let number = runs
                .iter()
                .filter(|run| run.inertia_factor == factor)
                .count();
            assert_eq!(2 * number, runs.len(), "{factor}");
        }
        let page = chapter().into_string();
        assert!(page.contains(&date) && !page.contains("NaN"));
    }
}
