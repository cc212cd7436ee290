//! The register of checks, as `gouge verify` runs it: one test per topic.

use gouge_validation::checks::{Check, Effort, register};

/// Run the checks of a topic with the given effort; the panic message lists all failures.
fn run(topic: &str, effort: Effort) {
    let topics = register();
    let topic = topics.iter().find(|one| one.id == topic).expect("a topic");
    let failures: Vec<String> = topic
        .checks
        .iter()
        .filter(|check| check.effort == effort)
        .filter_map(failure)
        .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The reason why a check fails, if it does.
fn failure(check: &Check) -> Option<String> {
    match (check.measure)() {
        Ok(finding) if finding.measurement.passes() => None,
        Ok(finding) => Some(format!("{}: {:?}", check.id, finding.measurement)),
        Err(failure) => Some(format!("{}: {failure}", check.id)),
    }
}

macro_rules! topics {
    ($($name:ident: $id:literal,)*) => {
        mod quick {
            $(#[test] fn $name() { super::run($id, super::Effort::Quick); })*
        }
        mod thorough {
            $(#[test] fn $name() { super::run($id, super::Effort::Thorough); })*
        }
        const TOPICS: &[&str] = &[$($id),*];
    };
}

topics! {
    references: "references",
    benchmarks: "benchmarks",
    identities: "identities",
    laws: "laws",
    pairs: "pairs",
    calibration: "calibration",
    beams: "beams",
    strength: "strength",
    time_step: "time-step",
    order: "order",
    closure: "closure",
    extremes: "extremes",
    estimators: "estimators",
    economy: "economy",
    work_precision: "work-precision",
    contact_dynamics: "contact-dynamics",
    peridem: "peridem",
}

#[test]
fn every_topic_has_its_tests_and_every_check_its_own_name() {
    let register = register();
    let ids: Vec<&str> = register.iter().map(|topic| topic.id).collect();
    assert_eq!(ids, TOPICS);
    let mut seen = std::collections::BTreeSet::new();
    for topic in &register {
        for check in &topic.checks {
            let rest = check.id.strip_prefix(topic.id);
            assert!(
                rest.is_some_and(|rest| rest.starts_with('.')),
                "{}",
                check.id
            );
            assert!(seen.insert(check.id), "the check {} exists twice", check.id);
            let words = [
                check.claim,
                check.scene,
                check.oracle,
                check.norm,
                check.reason,
            ];
            assert!(words.iter().all(|word| !word.is_empty()), "{}", check.id);
        }
    }
}

#[test]
fn every_stored_case_is_compared() {
    let register = register();
    let ids: Vec<&str> = register
        .iter()
        .flat_map(|topic| topic.checks.iter().map(|check| check.id))
        .collect();
    let differences = ["lammps/disc-inertia"];
    for path in gouge_validation::references::paths() {
        let id = format!("references.{path}");
        assert!(
            ids.contains(&id.as_str()) || differences.contains(&path.as_str()),
            "{path} is in references/, but no check compares it"
        );
    }
}
