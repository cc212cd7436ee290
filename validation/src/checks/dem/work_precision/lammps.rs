//! LAMMPS beside our velocity Verlet, from the latest run of `gouge-bench precision`.
//!
//! LAMMPS finds the force at the end of a step h from positions there and velocities half a step older, which
//! are h a / 2 + O(h^2) off, a being the acceleration. A dashpot gamma then errs by gamma h a / 2 in every step,
//! and its impulse by gamma h / 2 times the change of velocity: order one. Without dashpots the method is
//! velocity Verlet, of order two.

use super::case::Case;
use super::sweep::{Rung, Sweep};
use crate::checks::Table;
use crate::measurements::{latest, quantile, ratios, spread};
use serde::Deserialize;

/// A file of measurements.
#[derive(Deserialize)]
struct Run {
    precision: Vec<Scene>,
}

/// A case that LAMMPS ran.
#[derive(Deserialize)]
struct Scene {
    scene: String,
    /// The program with the date of its version.
    peer: String,
    /// Whether errors are those against its own limit of vanishing steps instead of our truth.
    own_limit: bool,
    rungs: Vec<Beside>,
}

/// A run of LAMMPS, with times of both in s in the order in which they were taken in turns.
#[derive(Deserialize)]
struct Beside {
    step: f64,
    steps: u64,
    /// Error of LAMMPS in units of the largest displacement.
    error: f64,
    theirs: Vec<f64>,
    ours: Vec<f64>,
}

/// What was recorded of a case, and when.
pub struct Recorded {
    date: String,
    scene: Scene,
}

impl Recorded {
    /// What was recorded of a case, if anything was.
    pub fn of(case: &Case) -> Option<Self> {
        let (date, run) = latest::<Run>("precision")?;
        let mut scenes = run.precision.into_iter();
        let scene = scenes.find(|scene| scene.scene == case.name)?;
        Some(Self { date, scene })
    }

    /// Recorded runs, each with the run of a sweep that has as many steps.
    fn pairs<'a>(&'a self, sweep: &'a Sweep) -> impl Iterator<Item = (&'a Beside, &'a Rung)> {
        self.scene.rungs.iter().filter_map(|beside| {
            let mut rungs = sweep.rungs.iter();
            Some((beside, rungs.find(|rung| rung.steps == beside.steps)?))
        })
    }

    /// Times in s and errors: the time of the same steps of our velocity Verlet, now, times the recorded
    /// ratio.
    pub fn points(&self, verlet: &Sweep) -> Vec<[f64; 2]> {
        let point = |(beside, rung): (&Beside, &Rung)| {
            let ratio = quantile(&ratios(&beside.theirs, &beside.ours), 0.5);
            Some([ratio * rung.time?.median, beside.error])
        };
        self.pairs(verlet).filter_map(point).collect()
    }

    /// All runs beside ours.
    pub fn table(&self, verlet: &Sweep) -> Table {
        let title = format!("{}: LAMMPS beside our velocity Verlet", self.scene.scene);
        let columns = [
            "step in s",
            "error of LAMMPS",
            "error of velocity Verlet",
            "time of LAMMPS over that of velocity Verlet (quartiles)",
        ];
        let mut table = Table::new(&title, &columns);
        for (beside, rung) in self.pairs(verlet) {
            table.push([
                format!("{:.2e}", beside.step),
                format!("{:.2e}", beside.error),
                format!("{:.2e}", rung.error),
                spread(&ratios(&beside.theirs, &beside.ours), 1),
            ]);
        }
        table
    }

    /// Where the points come from.
    pub fn words(&self) -> String {
        let Self {
            date,
            scene: Scene {
                peer, own_limit, ..
            },
        } = self;
        let against = if *own_limit {
            "against the limit of its own vanishing steps, found by extrapolation: its beams have the same \
             stiffness at both ends, so that it runs the beam of two grains of the mean radius instead of ours"
        } else {
            "against the same reference as ours"
        };
        format!(
            "The points of LAMMPS are of {date}, {peer}: its errors are {against}; its times are those of our \
             velocity Verlet with the same step, taken now, multiplied by the ratio of both that was measured \
             then, in turns on one machine."
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Beside, Recorded};
    use crate::checks::Exhibit;
    use crate::checks::dem::work_precision::case::Case;
    use crate::checks::dem::work_precision::scenes::FAULT;
    use crate::checks::dem::work_precision::show::{Curves, PEER};
    use crate::checks::dem::work_precision::sweep::{Precision, Rung, Spread, Sweep};
    use crate::checks::dem::work_precision::verdict::slope;
    use crate::checks::dem::work_precision::{PACKING, PAIR, VERLET};
    use approx::abs_diff_eq;
    use gouge_runner::scene::INTEGRATORS;

    /// Dashpots act in both scenes.
    const ORDER: f64 = 1.0;

    fn rung(beside: &Beside) -> Rung {
        Rung {
            step: beside.step,
            steps: beside.steps,
            error: beside.error,
            time: None,
        }
    }

    #[test]
    fn recorded_errors_fall_at_the_order_of_theory() {
        for case in [&PAIR, &PACKING] {
            let recorded = Recorded::of(case);
            assert!(recorded.is_some(), "nothing of {}", case.name);
            let Some(recorded) = recorded else { return };
            let (coarsest, _) = case.rung(case.brief.start);
            let rungs: Vec<Rung> = recorded.scene.rungs.iter().map(rung).collect();
            let settled = rungs.iter().filter(|rung| rung.step <= coarsest);
            let order = slope(settled);
            assert!(
                abs_diff_eq!(order, ORDER, epsilon = case.margin),
                "{}: order {order}",
                case.name
            );
        }
    }

    /// Sweeps of all methods with invented errors and times.
    fn invented(case: &'static Case) -> Curves {
        let run = |rung| {
            let (step, steps) = case.rung(rung);
            let median = 1e-7 * steps as f64;
            let time = Some(Spread {
                median,
                quartiles: [median; 2],
            });
            Rung {
                step,
                steps,
                error: step,
                time,
            }
        };
        let sweep = |&(integrator, _): &(&'static str, _)| Sweep {
            integrator,
            precision: Precision::Double,
            rungs: (0..case.rungs).map(run).collect(),
        };
        Curves {
            case,
            methods: INTEGRATORS.iter().map(sweep).collect(),
            others: Vec::new(),
            uncertainty: 0.0,
        }
    }

    fn shown(curves: &Curves) -> usize {
        let exhibits = curves.exhibits();
        let curves = exhibits.iter().filter_map(|exhibit| match exhibit {
            Exhibit::Plot(plot) => Some(&plot.curves),
            _ => None,
        });
        let theirs = curves.flatten().filter(|curve| curve.label == PEER);
        theirs.map(|curve| curve.points.len()).sum()
    }

    #[test]
    fn diagrams_show_the_recorded_runs_and_only_those() {
        for case in [&PAIR, &PACKING] {
            let curves = invented(case);
            let recorded = Recorded::of(case);
            let number = recorded.map_or(0, |recorded| recorded.scene.rungs.len());
            assert!(number > 8);
            assert_eq!(shown(&curves), number, "{}", case.name);
        }
        assert_eq!(shown(&invented(&FAULT)), 0);
    }

    #[test]
    fn a_point_has_the_recorded_ratio_of_times() {
        let curves = invented(&PACKING);
        let Some(recorded) = Recorded::of(&PACKING) else {
            return;
        };
        let verlet = &curves.methods[VERLET];
        for (point, beside) in recorded.points(verlet).iter().zip(&recorded.scene.rungs) {
            let ratio = point[0] / (1e-7 * beside.steps as f64);
            let ratios = beside.theirs.iter().zip(&beside.ours).map(|(a, b)| a / b);
            let above = ratios.clone().filter(|one| *one > ratio * (1.0 + 1e-12));
            let below = ratios.clone().filter(|one| *one < ratio * (1.0 - 1e-12));
            assert_eq!(above.count(), below.count());
        }
    }
}
