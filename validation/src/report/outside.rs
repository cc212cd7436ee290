//! What other programs say: the stored cases by program, with how closely the kernel repeats them.

use super::judged::Digits;
use super::{Entry, Record};
use crate::references::{Case, Compared, case, paths};
use std::collections::BTreeMap;

/// Another program and the checks that compare the kernel with it.
#[derive(Default)]
pub struct Program {
    /// Its versions.
    pub versions: Vec<String>,
    /// Cases that are repeated step by step.
    pub stepwise: Vec<Record>,
    /// Cases that are compared on average over many runs.
    pub averaged: Vec<Record>,
}

impl Program {
    /// The results in words.
    pub fn words(&self) -> String {
        let mut parts = Vec::new();
        if !self.stepwise.is_empty() {
            let digits = Digits::of(&self.stepwise).map_or(String::new(), |digits| {
                format!(
                    "; digits: fewest {:.1}, median {:.1}",
                    digits.fewest, digits.median
                )
            });
            let (passed, all) = passed(&self.stepwise);
            parts.push(format!("step by step {passed} of {all} cases{digits}"));
        }
        if !self.averaged.is_empty() {
            let (passed, all) = passed(&self.averaged);
            parts.push(format!("on average {passed} of {all} cases"));
        }
        parts.join("; ")
    }
}

fn passed(records: &[Record]) -> (usize, usize) {
    let passed = records.iter().filter(|record| record.passed()).count();
    (passed, records.len())
}

/// The programs by name, with the checks among the given ones.
pub fn programs(entries: &[Entry]) -> BTreeMap<String, Program> {
    let mut programs: BTreeMap<String, Program> = BTreeMap::new();
    for path in paths() {
        let (Ok(case), Some(record)) = (case(&path), of_case(&path, entries)) else {
            continue;
        };
        let program = programs.entry(case.result.engine.clone()).or_default();
        program.add(case, record);
    }
    programs
}

fn of_case<'a>(path: &str, entries: &'a [Entry]) -> Option<&'a Record> {
    let records = entries.iter().map(|entry| &entry.record);
    let id = format!("references.{path}");
    records.into_iter().find(|record| record.id == id)
}

impl Program {
    fn add(&mut self, case: &Case, record: &Record) {
        if !self.versions.contains(&case.result.version) {
            self.versions.push(case.result.version.clone());
        }
        match case.compares {
            Compared::Ensemble => self.averaged.push(record.clone()),
            _ => self.stepwise.push(record.clone()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::examples::{entry, record};
    use super::programs;
    use crate::checks::{Measurement, Origin};

    #[test]
    fn programs_are_counted_from_the_checks_that_were_run() {
        let repeated = |id, error| {
            let measurement = Measurement::absolute(0.0, error, 1e-9);
            entry(record(id, measurement, Origin::Exact))
        };
        let entries = [
            repeated("references.lammps/hertz", 1e-13),
            repeated("references.lammps/chain", 1e-8),
            repeated("references.lammps/settling", 0.0),
            repeated("references.yade/hertz", 1e-15),
            repeated("references.overview", 0.0),
        ];
        let found = programs(&entries);
        let names: Vec<&str> = found.keys().map(String::as_str).collect();
        assert_eq!(names, ["LAMMPS", "YADE"]);
        let lammps = &found["LAMMPS"];
        assert!(
            lammps
                .versions
                .iter()
                .any(|version| version.contains("2025"))
        );
        assert_eq!(
            lammps.words(),
            "step by step 1 of 2 cases; digits: fewest 8.0, median 8.0; on average 1 of 1 cases"
        );
        assert!(programs(&[]).is_empty());
    }
}
