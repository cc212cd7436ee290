//! LAMMPS compared with our velocity Verlet, from the latest run of `gouge-bench precision`.
//!
//! LAMMPS computes the force at the end of a step h from positions at that time and velocities half a
//! step older, which differ by h a / 2 + O(h^2), with a the acceleration. A dashpot gamma then has an
//! error of gamma h a / 2 in every step, and its impulse an error of gamma h / 2 times the change of
//! velocity: order one. Without dashpots the method is velocity Verlet, of order two.
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

/// A case that was run with LAMMPS.
#[derive(Deserialize)]
struct Scene {
    scene: String,
    /// The program and the date of its version.
    peer: String,
    /// Whether errors refer to LAMMPS's own limit of zero time step instead of our reference solution.
    own_limit: bool,
    rungs: Vec<Beside>,
}

/// A run of LAMMPS, with the times of both programs in s in the order of their alternating runs.
#[derive(Deserialize)]
struct Beside {
    step: f64,
    steps: u64,
    /// Error of LAMMPS in units of the largest displacement.
    error: f64,
    theirs: Vec<f64>,
    ours: Vec<f64>,
}

/// The recorded runs of a case, and their date.
pub struct Recorded {
    date: String,
    scene: Scene,
}

impl Recorded {
    /// The recorded runs of a case, if there are any.
    pub fn of(case: &Case) -> Option<Self> {
        let (date, run) = latest::<Run>("precision")?;
        let mut scenes = run.precision.into_iter();
        let scene = scenes.find(|scene| scene.scene == case.name)?;
        Some(Self { date, scene })
    }

    /// Recorded runs, each with the run of a sweep that has the same number of steps.
    fn pairs<'a>(&'a self, sweep: &'a Sweep) -> impl Iterator<Item = (&'a Beside, &'a Rung)> {
        self.scene.rungs.iter().filter_map(|beside| {
            let mut rungs = sweep.rungs.iter();
            Some((beside, rungs.find(|rung| rung.steps == beside.steps)?))
        })
    }

    /// Times in s and errors: the time is that of our velocity Verlet with the same steps, measured
    /// now, times the recorded ratio.
    pub fn points(&self, verlet: &Sweep) -> Vec<[f64; 2]> {
        let point = |(beside, rung): (&Beside, &Rung)| {
            let ratio = quantile(&ratios(&beside.theirs, &beside.ours), 0.5);
            Some([ratio * rung.time?.median, beside.error])
        };
        self.pairs(verlet).filter_map(point).collect()
    }

    /// All runs next to ours.
    pub fn table(&self, verlet: &Sweep) -> Table {
        let title = format!(
            "{}: LAMMPS compared with our velocity Verlet",
            self.scene.scene
        );
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

    /// The source of the points.
    pub fn words(&self) -> String {
        let Self {
            date,
            scene: Scene {
                peer, own_limit, ..
            },
        } = self;
        let against = if *own_limit {
            "relative to its own limit of zero time step, found by extrapolation, because its beams have the same stiffness at both ends: it computes the beam of two grains of the mean radius instead of ours"
        } else {
            "relative to the same reference as ours"
        };
        format!(
            "The points of LAMMPS are from {date}, {peer}. Its errors are {against}. Its times are those of our velocity Verlet with the same time step, measured now, multiplied by the recorded ratio of the two, which was measured in alternating runs on one machine."
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

    /// Both scenes have dashpots.
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
            assert!(recorded.is_some(), "no recorded runs of {}", case.name);
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
            Exhibit::Figure(plot) => Some(&plot.curves),
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
