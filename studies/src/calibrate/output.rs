//! Files that a calibration leaves.

use super::account::{answer, bounds, exact, range};
use super::calibration::{Calibration, Test};
use super::identify::Marginal;
use super::outcome::{Answer, Outcome};
use super::page::write_page;
use super::parameter::Parameter;
use crate::csv_table::csv_table;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::collections::BTreeMap;
use std::path::Path;

/// The file with the calibrated parameters.
pub const MATERIAL: &str = "material.toml";

impl Outcome {
    /// Write `material.toml`, `posterior.csv`, `runs.csv`, and the page `calibration.html` with its figures. There is no material of a model that is refuted.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&self, calibration: &Calibration, out: &Path) -> Result<(), Error> {
        write_whole(
            &out.join("posterior.csv"),
            &self.posterior_table(calibration)?,
        )?;
        write_page(calibration, self, out)?;
        write_whole(&out.join("runs.csv"), &self.runs_table(calibration)?)?;
        let path = out.join(MATERIAL);
        match &self.answer {
            Answer::Determined | Answer::Combinations => {
                write_whole(&path, self.material(calibration).as_bytes())
            }
            _ if path.exists() => {
                std::fs::remove_file(&path).map_err(|error| Error::file("remove", &path, error))
            }
            _ => Ok(()),
        }
    }

    /// The calibrated keys under the headers of their tables, with intervals as comments.
    fn material(&self, calibration: &Calibration) -> String {
        let mut text = comment(&calibration.title) + &comment(&answer(calibration, self));
        for (target, one) in calibration.targets.iter().zip(&self.measured) {
            let name = calibration.target_name(target);
            let (value, deviation) = (exact(one.value), exact(one.deviation));
            text += &comment(&format!(
                "{name} = {value} +- {deviation}: {}",
                target.source
            ));
        }
        for test in &calibration.tests {
            text += &comment(&self.command(calibration, test));
        }
        let mut tables: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for (parameter, one) in calibration.parameters.iter().zip(&self.marginals) {
            let mut keys: Vec<&String> = calibration
                .tests
                .iter()
                .flat_map(|test| parameter.keys_in(&test.name))
                .collect();
            keys.sort();
            keys.dedup();
            for key in keys {
                let (table, name) = key.rsplit_once('.').unwrap_or(("", key));
                // An item of an array cannot be set by its index in a file.
                let has_index = key.split('.').any(|part| part.parse::<usize>().is_ok());
                let sign = if has_index { "# " } else { "" };
                let line = format!("{sign}{name} = {}\n", line(parameter, one));
                tables.entry(table).or_default().push(line);
            }
        }
        for (table, lines) in tables {
            let header = match table {
                "" => String::new(),
                table => format!("[{table}]\n"),
            };
            text += &format!("\n{header}{}", lines.concat());
        }
        text
    }

    /// The command that runs a test with the best values.
    fn command(&self, calibration: &Calibration, test: &Test) -> String {
        let best: Vec<f64> = self.marginals.iter().map(|one| one.best).collect();
        let run = calibration.run(test, &best, test.seeds_at(0)[0]);
        let quoted = |text: &str| format!("'{}'", text.replace('\'', "'\\''"));
        let set = run
            .overrides
            .iter()
            .map(|one| format!(" --set {}", quoted(one)));
        let set: String = set.collect();
        let scene = run.scene.display().to_string();
        let is_plain = |c: char| c.is_alphanumeric() || "/._-".contains(c);
        let scene = match scene.chars().all(is_plain) {
            true => scene,
            false => quoted(&scene),
        };
        format!("gouge run {scene} --out DIR{set}")
    }

    fn posterior_table(&self, calibration: &Calibration) -> Result<Vec<u8>, Error> {
        let names = calibration.parameters.iter().map(|one| one.name.clone());
        let header = names.chain(["weight", "log_likelihood"].map(str::to_owned));
        let posterior = &self.posterior;
        let pairs = posterior.weights.iter().zip(&posterior.log_likelihood);
        let rows = posterior
            .points
            .iter()
            .zip(pairs)
            .map(|(point, (weight, height))| {
                let values = calibration.parameters.iter().zip(point);
                let values = values.map(|(parameter, &place)| parameter.value(place));
                values
                    .chain([*weight, *height])
                    .map(|one| format!("{one:?}"))
                    .collect::<Vec<String>>()
            });
        let rows = [header.collect()].into_iter().chain(rows);
        csv_table(Path::new("posterior.csv"), rows)
    }

    fn runs_table(&self, calibration: &Calibration) -> Result<Vec<u8>, Error> {
        let mut header = vec!["run".to_owned(), "purpose".to_owned(), "test".to_owned()];
        header.extend(calibration.parameters.iter().map(|one| one.name.clone()));
        header.extend(["seed", "cause"].map(str::to_owned));
        let mut names: Vec<String> = Vec::new();
        for observed in calibration.tests.iter().flat_map(|test| &test.observed) {
            let name = observed.observation.name();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        header.extend(names.iter().cloned());
        header.push("wall_seconds".to_owned());
        let parts = [
            ("calibration", &self.results),
            ("prediction", &self.predictive),
        ];
        let runs = parts.into_iter().flat_map(|(purpose, results)| {
            results
                .runs
                .iter()
                .map(move |run| (purpose, &results.points[run.point], run))
        });
        let rows = runs.map(|(purpose, point, run)| {
            let mut row = vec![run.run.name.clone(), purpose.to_owned()];
            row.push(calibration.tests[run.test].name.clone());
            let pairs = calibration.parameters.iter().zip(point);
            row.extend(pairs.map(|(parameter, &place)| parameter.written(place)));
            row.push(run.seed.map_or_else(String::new, |seed| seed.to_string()));
            let empty = Vec::new();
            let (values, cause) = match &run.outcome {
                Ok(values) => (values, String::new()),
                Err(cause) => (&empty, cause.replace('\n', "; ")),
            };
            row.push(cause);
            let observed = &calibration.tests[run.test].observed;
            let value = |name: &String| {
                let place = observed
                    .iter()
                    .position(|one| one.observation.name() == *name);
                let value = place.and_then(|place| values.get(place));
                value.map_or_else(String::new, |one| format!("{one:?}"))
            };
            row.extend(names.iter().map(value));
            row.push(format!("{:.3}", run.seconds));
            row
        });
        csv_table(Path::new("runs.csv"), [header].into_iter().chain(rows))
    }
}

/// A comment on one line, whatever the text has.
fn comment(text: &str) -> String {
    let mut line = "# ".to_owned();
    for character in text.chars() {
        match character.is_control() {
            true => line.extend(character.escape_default()),
            false => line.push(character),
        }
    }
    line + "\n"
}

/// A value with its intervals.
fn line(parameter: &Parameter, one: &Marginal) -> String {
    let value = |place: f64| parameter.value(place);
    let [_, low, high, lowest, highest] = one.quantiles.map(value);
    format!(
        "{}    # 68 %: {}, 90 %: {}{}",
        parameter.written(one.best),
        range(low, high),
        range(lowest, highest),
        bounds(parameter, one)
    )
}
