//! Arrays in a table of a scene file.

use super::table::{Range, Table, integer_of, number_of};
use crate::error::SceneError;
use toml::Spanned;
use toml::de::DeValue;

type Result<T> = std::result::Result<T, SceneError>;

impl Table<'_> {
    /// Some of several names, none twice; empty if the key is absent.
    pub fn optional_choices<T: Copy>(&self, key: &str, names: &[(&str, T)]) -> Result<Vec<T>> {
        let Some(value) = self.value(key) else {
            return Ok(Vec::new());
        };
        let place = |value: &Spanned<DeValue>| match value.get_ref() {
            DeValue::String(text) => names.iter().position(|(name, _)| *name == text.as_ref()),
            _ => None,
        };
        let places: Option<Vec<usize>> =
            array_of(value).and_then(|array| array.iter().map(place).collect());
        let is_new = |places: &[usize], at: usize| !places[..at].contains(&places[at]);
        match places {
            Some(places) if (0..places.len()).all(|at| is_new(&places, at)) => {
                Ok(places.into_iter().map(|place| names[place].1).collect())
            }
            _ => {
                let list: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
                let accepted =
                    format!("must be an array of names, none twice: {}", list.join(", "));
                Err(self.error(key, &accepted))
            }
        }
    }

    /// A pair of finite numbers, if the key is present.
    pub fn optional_pair(&self, key: &str) -> Result<Option<[f64; 2]>> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        let accepted = "must be an array of two finite numbers";
        let pair = array_of(value).and_then(|array| match array {
            [a, b] => Some([number_of(a.get_ref())?, number_of(b.get_ref())?]),
            _ => None,
        });
        match pair {
            Some(pair) if pair.iter().all(|x| x.is_finite()) => Ok(Some(pair)),
            _ => Err(self.error(key, accepted)),
        }
    }

    /// A pair of finite numbers.
    pub fn pair(&self, key: &str) -> Result<[f64; 2]> {
        self.optional_pair(key)?
            .ok_or_else(|| self.missing(key, "must be an array of two finite numbers"))
    }

    /// An array of pairs of finite numbers.
    pub fn pairs(&self, key: &str) -> Result<Vec<[f64; 2]>> {
        self.rows(key, "must be an array of pairs of numbers")
    }

    /// An array of arrays of N finite numbers each; `accepted` says so.
    pub fn rows<const N: usize>(&self, key: &str, accepted: &str) -> Result<Vec<[f64; N]>> {
        let Some(value) = self.value(key) else {
            return Err(self.missing(key, accepted));
        };
        rows_of(value).ok_or_else(|| self.error(key, accepted))
    }

    /// As [`Table::rows`]; empty if the key is absent.
    pub fn optional_rows<const N: usize>(
        &self,
        key: &str,
        accepted: &str,
    ) -> Result<Vec<[f64; N]>> {
        match self.has(key) {
            true => self.rows(key, accepted),
            false => Ok(Vec::new()),
        }
    }

    /// An array of arrays of pairs of finite numbers; empty if the key is absent.
    pub fn rings(&self, key: &str) -> Result<Vec<Vec<[f64; 2]>>> {
        let Some(value) = self.value(key) else {
            return Ok(Vec::new());
        };
        let rings = array_of(value).and_then(|rings| rings.iter().map(rows_of).collect());
        rings.ok_or_else(|| self.error(key, "must be an array of arrays of pairs of numbers"))
    }

    /// An array of four finite numbers.
    pub fn four(&self, key: &str, accepted: &str) -> Result<[f64; 4]> {
        let Some(value) = self.value(key) else {
            return Err(self.missing(key, accepted));
        };
        row_of(value).ok_or_else(|| self.error(key, accepted))
    }

    /// An array of numbers.
    pub fn numbers(&self, key: &str, range: Range) -> Result<Vec<f64>> {
        let accepted = format!(
            "must be an array of numbers, each of which {}",
            range.text()
        );
        let Some(value) = self.value(key) else {
            return Err(self.missing(key, &accepted));
        };
        let number = |v: &Spanned<DeValue>| number_of(v.get_ref()).filter(|&x| range.contains(x));
        let numbers = array_of(value).and_then(|array| array.iter().map(number).collect());
        numbers.ok_or_else(|| self.error(key, &accepted))
    }

    /// A pair of indices.
    pub fn index_pair(&self, key: &str) -> Result<[usize; 2]> {
        let accepted = "must be an array of two particle indices, counted from 0";
        let Some(value) = self.value(key) else {
            return Err(self.missing(key, accepted));
        };
        let index = |v: &Spanned<DeValue>| usize::try_from(integer_of(v.get_ref())?).ok();
        let pair = array_of(value).and_then(|array| match array {
            [a, b] => Some([index(a)?, index(b)?]),
            _ => None,
        });
        pair.ok_or_else(|| self.error(key, accepted))
    }
}

/// An array of N finite numbers.
fn row_of<const N: usize>(value: &Spanned<DeValue>) -> Option<[f64; N]> {
    let numbers = array_of(value)?.iter().map(|one| number_of(one.get_ref()));
    let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
    let is_finite = numbers.iter().all(|number| number.is_finite());
    numbers.try_into().ok().filter(|_| is_finite)
}

fn rows_of<const N: usize>(value: &Spanned<DeValue>) -> Option<Vec<[f64; N]>> {
    array_of(value)?.iter().map(row_of).collect()
}

/// The elements of an array.
pub(super) fn array_of<'a>(value: &'a Spanned<DeValue<'a>>) -> Option<&'a [Spanned<DeValue<'a>>]> {
    match value.get_ref() {
        DeValue::Array(array) => Some(array),
        _ => None,
    }
}
