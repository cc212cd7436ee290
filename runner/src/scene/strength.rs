//! `[setup.bonding] strength`: the distribution of the strengths of bonds.

use super::rows::rows_of;
use super::table::{Range, Table};
use crate::error::SceneError;
use gouge_dem::distributions::{Tabulated, Weibull};
use std::path::{Path, PathBuf};

type Result<T> = std::result::Result<T, SceneError>;

/// How strong the bonds are that a set-up makes.
#[derive(Clone, Debug, PartialEq)]
pub enum BondStrength {
    /// Strength factors uniform in 1 plus or minus this.
    Spread(f64),
    /// Tensile strengths in N.
    Weibull(Weibull),
    /// Tensile strengths in N.
    Table(Tabulated),
}

impl BondStrength {
    /// Tensile strength in N below which bonds lie with a probability in [0, 1); `None` if strength factors are given
    /// instead.
    pub fn quantile(&self, probability: f64) -> Option<f64> {
        match self {
            Self::Spread(_) => None,
            Self::Weibull(weibull) => Some(weibull.quantile(probability)),
            Self::Table(table) => Some(table.quantile(probability)),
        }
    }
}

#[derive(Clone, Copy)]
enum Shape {
    Weibull,
    Table,
}

/// The keys `strength` and `strength_spread`; without both, all strength factors are one.
pub fn bond_strength(root: &Table, bonding: &Table, folder: &Path) -> Result<BondStrength> {
    let spread = spread(bonding)?;
    let Some(table) = bonding.optional_table("strength")? else {
        return Ok(BondStrength::Spread(spread.unwrap_or(0.0)));
    };
    if spread.is_some() {
        let accepted = "must not be given together with strength";
        return Err(bonding.error("strength_spread", accepted));
    }
    let yields = root
        .optional_table("bond")?
        .is_some_and(|bond| bond.has("yielding"));
    if !yields {
        let accepted = "needs [bond.yielding], whose criterion it scales";
        return Err(bonding.error("strength", accepted));
    }
    let shapes = [("weibull", Shape::Weibull), ("table", Shape::Table)];
    match table.choice("distribution", &shapes)? {
        Shape::Weibull => weibull(&table).map(BondStrength::Weibull),
        Shape::Table => tabulated(&table, folder).map(BondStrength::Table),
    }
}

fn spread(bonding: &Table) -> Result<Option<f64>> {
    let spread = bonding.optional_number("strength_spread", Range::NonNegative)?;
    match spread {
        Some(spread) if spread >= 1.0 => {
            Err(bonding.error("strength_spread", "must be a number from 0 to less than 1"))
        }
        spread => Ok(spread),
    }
}

fn weibull(table: &Table) -> Result<Weibull> {
    table.allow(&["distribution", "shape", "scale", "location"])?;
    let location = table.optional_number("location", Range::NonNegative)?;
    Ok(Weibull {
        shape: table.number("shape", Range::Positive)?,
        scale: table.number("scale", Range::Positive)?,
        location: location.unwrap_or(0.0),
    })
}

fn tabulated(table: &Table, folder: &Path) -> Result<Tabulated> {
    table.allow(&["distribution", "file", "strength", "probability"])?;
    if !table.has("file") {
        let tabulated = Tabulated {
            values: table.numbers("strength", Range::Positive)?,
            probabilities: table.numbers("probability", Range::NonNegative)?,
        };
        return match problem(&tabulated) {
            Some((key, problem)) => Err(table.error(key, problem)),
            None => Ok(tabulated),
        };
    }
    for key in ["strength", "probability"] {
        if table.has(key) {
            return Err(table.error(key, "must not be given together with file"));
        }
    }
    let name = table.optional_text("file")?.unwrap_or_default();
    let rows = rows_of(table, "file", &folder.join(name))?;
    let numbers = rows.read(&["strength", "probability"], &[], |row| {
        let strength = row.number("strength", Range::Positive)?;
        Ok((strength, row.number("probability", Range::NonNegative)?))
    })?;
    let (values, probabilities) = numbers.into_iter().unzip();
    let tabulated = Tabulated {
        values,
        probabilities,
    };
    match problem(&tabulated) {
        Some((column, problem)) => {
            Err(table.error("file", &format!("its column {column} {problem}")))
        }
        None => Ok(tabulated),
    }
}

/// What is wrong with a table of quantiles: in which column, and what.
fn problem(table: &Tabulated) -> Option<(&'static str, &'static str)> {
    let (x, p) = (&table.values, &table.probabilities);
    if p.len() < 2 || p.first() != Some(&0.0) || p.last() != Some(&1.0) || !p.is_sorted() {
        return Some(("probability", "must not decrease, from 0 to 1"));
    }
    if x.len() != p.len() {
        return Some(("strength", "must have as many numbers as probability"));
    }
    (!x.is_sorted()).then_some(("strength", "must not decrease"))
}

/// The file of the table, if there is one.
pub fn file(root: &Table, folder: &Path) -> Result<Option<(String, PathBuf)>> {
    let mut table = root.optional_table("setup")?;
    for key in ["bonding", "strength"] {
        table = match table {
            Some(table) => table.optional_table(key)?,
            None => None,
        };
    }
    let name = table.map(|table| table.optional_text("file")).transpose()?;
    Ok(name
        .flatten()
        .map(|name| (name.to_owned(), folder.join(name))))
}
