//! Files of single states: constants, forces, bonds, contacts and walls, computed from their inputs alone.

mod bonds;
mod constants;
mod contact;
mod forces;
mod two_nodes;
mod walls;

use super::{Repeated, output_name};
use crate::error::{CaseError, Fault, ReplayError};
use crate::fields::Fields;
use crate::outcome::require_finite;
use gouge_peridem::mode::Mode;
use serde_json::{Map, Value};
use std::path::Path;

/// What is computed for a case, by key.
type Found = Map<String, Value>;

/// Keys that tell the kinds of files apart, for messages.
pub(super) const ACCEPTED: &str = "a trajectory with grains or same_input_as; cases with plane, weights or outer; \
     node_node, self_contact, two_node_collision or two_node_bond; single or corner";

/// A kind of file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Constants,
    Forces,
    Bonds,
    Contact,
    Walls,
}

impl Kind {
    /// The kind of a file, by its keys.
    pub(super) fn of(file: &Value) -> Option<Self> {
        let has = |keys: &[&str]| keys.iter().any(|key| file.get(key).is_some());
        let cases = file.get("cases").and_then(Value::as_array);
        let in_cases =
            |key: &str| cases.is_some_and(|cases| cases.iter().any(|case| case.get(key).is_some()));
        match () {
            () if has(&contact::LISTS) => Some(Self::Contact),
            () if has(&walls::LISTS) => Some(Self::Walls),
            () if in_cases("outer") => Some(Self::Bonds),
            () if in_cases("weights") => Some(Self::Forces),
            () if in_cases("plane") => Some(Self::Constants),
            () => None,
        }
    }
}

/// A file in the making.
struct Sheet<'a> {
    name: String,
    file: Fields<'a>,
    found: Found,
    failures: Vec<CaseError>,
    cases: usize,
    counts: String,
}

impl Sheet<'_> {
    /// Solve the cases of a list, if the file has it. Each becomes its inputs and what is computed, or an error.
    fn solve(
        &mut self,
        list: &str,
        inputs: &[&str],
        solve: impl Fn(&Fields) -> Result<Found, Fault>,
    ) -> Result<(), Fault> {
        if self.file.optional(list).is_none() {
            return Ok(());
        }
        let cases = self.file.list(list)?;
        let mut solved = 0;
        let mut results = Vec::new();
        for (k, case) in cases.iter().enumerate() {
            let mut result = case.copied(inputs);
            let own = Fields::root(case.value());
            let found = solve(&own).and_then(|found| require_finite(found.into()));
            match found {
                Ok(Value::Object(found)) => {
                    result.extend(found);
                    solved += 1;
                }
                Ok(_) => {}
                Err(fault) => {
                    result.insert("error".to_owned(), fault.to_string().into());
                    self.failures.push(CaseError {
                        file: self.name.clone(),
                        case: identity(list, k, &own),
                        fault,
                    });
                }
            }
            results.push(Value::from(result));
        }
        self.counts += &format!("{list}: {solved} of {} computed\n", cases.len());
        self.cases += cases.len();
        self.found.insert(list.to_owned(), results.into());
        Ok(())
    }
}

fn identity(list: &str, k: usize, case: &Fields) -> String {
    match case.text("name") {
        Ok(name) => format!("{list}[{k}] ({name})"),
        Err(_) => format!("{list}[{k}]"),
    }
}

/// Compute what a file expects.
pub(super) fn repeat(
    file: &Path,
    value: &Value,
    kind: Kind,
    mode: Mode,
) -> Result<Repeated, ReplayError> {
    let name = output_name(file);
    let top = Fields::root(value);
    let mut sheet = Sheet {
        name: name.clone(),
        found: top.texts(),
        file: top,
        failures: Vec::new(),
        cases: 0,
        counts: String::new(),
    };
    match kind {
        Kind::Constants => constants::solve(&mut sheet),
        Kind::Forces => forces::solve(&mut sheet),
        Kind::Bonds => bonds::solve(&mut sheet),
        Kind::Contact => contact::solve(&mut sheet, mode),
        Kind::Walls => walls::solve(&mut sheet),
    }
    .map_err(|fault| ReplayError::Structure {
        file: file.to_owned(),
        fault,
    })?;
    Ok(Repeated {
        account: format!("{}: {name}\n{}", mode.name(), sheet.counts),
        files: vec![(name, format!("{}\n", Value::from(sheet.found)))],
        failures: sheet.failures,
        cases: sheet.cases,
    })
}
