//! The exhibits of a case: diagrams, times and advice.

use super::VERLET;
use super::advice::{front, words};
use super::case::Case;
use super::lammps::Recorded;
use super::sweep::{Precision, Rung, Sweep};
use crate::checks::{Axis, Curve, Exhibit, Figure, Table};

/// Label of the points of LAMMPS.
pub const PEER: &str = "LAMMPS, velocity Verlet with half-step velocities";

/// Sweeps of a case: all methods in double, then the best method in single and double-double.
pub struct Curves {
    /// The case.
    pub case: &'static Case,
    /// All methods in double.
    pub methods: Vec<Sweep>,
    /// The best method in the other number types.
    pub others: Vec<Sweep>,
    /// Estimated error of the reference.
    pub uncertainty: f64,
}

impl Curves {
    /// Everything that the report shows for the case.
    pub fn exhibits(&self) -> Vec<Exhibit> {
        let name = self.case.name;
        let methods = format!("{name}: error against run time, five integrators in f64");
        let types = format!("{name}: error against run time, three number types");
        let best = self.others.first().map(|other| other.integrator);
        let double = self
            .methods
            .iter()
            .filter(|one| Some(one.integrator) == best);
        let numbers: Vec<&Sweep> = double.chain(&self.others).collect();
        let mut plot = self.plot(methods, &self.methods.iter().collect::<Vec<_>>(), |sweep| {
            sweep.integrator.to_owned()
        });
        let beside = self.beside(&mut plot);
        let exhibits = [
            Exhibit::Figure(self.plot(types, &numbers, |sweep| {
                format!("{} in {}", sweep.integrator, sweep.precision.name())
            })),
            Exhibit::Table(self.table()),
            Exhibit::Text(words(self.case, &self.methods)),
            Exhibit::Text(self.scalar_words()),
        ];
        let first = [Exhibit::Figure(plot)].into_iter();
        first.chain(beside).chain(exhibits).collect()
    }

    /// Plots the recorded runs of LAMMPS; returns their text and table.
    fn beside(&self, plot: &mut Figure) -> Vec<Exhibit> {
        let (Some(recorded), Some(verlet)) = (Recorded::of(self.case), self.methods.get(VERLET))
        else {
            return Vec::new();
        };
        let points = recorded.points(verlet).into_iter();
        let points = points.map(|[time, error]| [self.per_unit(time), error]);
        plot.curves.push(Curve::marked_line(PEER, points));
        vec![
            Exhibit::Text(recorded.words()),
            Exhibit::Table(recorded.table(verlet)),
        ]
    }

    /// Wall time of a run in s per simulated millisecond.
    fn per_unit(&self, seconds: f64) -> f64 {
        seconds / (1e3 * self.case.end())
    }

    fn plot(&self, title: String, sweeps: &[&Sweep], label: fn(&Sweep) -> String) -> Figure {
        let point = |rung: &Rung| Some([self.per_unit(rung.time?.median), rung.error]);
        let curve = |sweep: &&Sweep| {
            Curve::marked_line(&label(sweep), sweep.rungs.iter().filter_map(point))
        };
        let mut curves: Vec<Curve> = sweeps.iter().map(curve).collect();
        let front = front(sweeps.iter().copied());
        let front = front
            .iter()
            .map(|&[time, error]| [self.per_unit(time), error]);
        curves.push(Curve::dashed("Pareto front", front));
        Figure::new(
            title,
            Axis::logarithmic("wall time per simulated millisecond", "s"),
            Axis::logarithmic(
                "largest error of a position over the largest displacement",
                "",
            ),
            curves,
        )
    }

    fn table(&self) -> Table {
        let title = format!(
            "{}: time (median, quartiles) and error of selected runs",
            self.case.name
        );
        let columns = [
            "integrator",
            "number type",
            "step in s",
            "steps",
            "time in s",
            "quartiles in s",
            "error",
        ];
        let mut table = Table::new(&title, &columns);
        for sweep in self.methods.iter().chain(&self.others) {
            for rung in self.selected(sweep) {
                table.push(row(sweep, rung));
            }
        }
        table
    }

    /// The coarsest stable run, the run with the thesis's time step, and the finest run.
    fn selected<'a>(&self, sweep: &'a Sweep) -> Vec<&'a Rung> {
        let stable = sweep.rungs.iter().find(|rung| rung.error.is_finite());
        let thesis = sweep.rungs.get(self.case.doublings as usize);
        let chosen = [stable, thesis, sweep.rungs.last()];
        let mut rungs: Vec<&Rung> = chosen.into_iter().flatten().collect();
        rungs.dedup_by_key(|rung| rung.steps);
        rungs
    }

    /// Cost and accuracy of the number types.
    fn scalar_words(&self) -> String {
        let Some(best) = self.others.first().map(|other| other.integrator) else {
            return String::new();
        };
        let double = self.methods.iter().find(|one| one.integrator == best);
        let pace = |sweep: &Sweep| {
            let last = sweep
                .rungs
                .iter()
                .rev()
                .find_map(|rung| Some(rung.time?.median / rung.steps as f64));
            last.unwrap_or(f64::NAN)
        };
        let base = double.map_or(f64::NAN, pace);
        let words = |sweep: &Sweep| {
            let smallest = sweep
                .rungs
                .iter()
                .map(|rung| rung.error)
                .fold(f64::INFINITY, f64::min);
            format!(
                "{} takes {:.2} times as long per step as f64, and its smallest error here is {smallest:.1e}.",
                sweep.precision.name(),
                pace(sweep) / base,
            )
        };
        let others: Vec<String> = self.others.iter().map(words).collect();
        format!(
            "With {best}: {} In f64 a step takes {:.2e} s. The estimated error of the reference is at most {:.0e}.",
            others.join(" "),
            base,
            self.uncertainty
        )
    }
}

fn row(sweep: &Sweep, rung: &Rung) -> Vec<String> {
    let error = if rung.error.is_finite() {
        format!("{:.2e}", rung.error)
    } else {
        "unstable".to_owned()
    };
    let (median, quartiles) = match rung.time {
        Some(time) => (
            format!("{:.3e}", time.median),
            format!("{:.3e} to {:.3e}", time.quartiles[0], time.quartiles[1]),
        ),
        None => ("-".to_owned(), "-".to_owned()),
    };
    vec![
        sweep.integrator.to_owned(),
        sweep.precision.name().to_owned(),
        format!("{:.2e}", rung.step),
        rung.steps.to_string(),
        median,
        quartiles,
        error,
    ]
}

/// Number types other than double.
pub const OTHERS: [Precision; 2] = [Precision::Single, Precision::DoubleDouble];
