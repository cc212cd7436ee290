//! Values of a case, read by key; errors name the key and what is accepted.

use crate::error::Fault;
use gouge_common::geometry::Vec2;
use gouge_peridem::error::USABLE;
use serde_json::{Map, Value};

/// Longest value that an error message shows in full.
const LONGEST: usize = 60;

/// A value with the path that leads to it.
#[derive(Clone, Debug)]
pub struct Fields<'a> {
    value: &'a Value,
    path: String,
}

impl<'a> Fields<'a> {
    /// The whole of a file or a case.
    pub fn root(value: &'a Value) -> Self {
        Self {
            value,
            path: String::new(),
        }
    }

    /// The value itself.
    pub fn value(&self) -> &'a Value {
        self.value
    }

    /// Those of some keys that are present, with their values.
    pub fn copied(&self, keys: &[&str]) -> Map<String, Value> {
        let item = |key: &&str| Some(((*key).to_owned(), self.value.get(key)?.clone()));
        keys.iter().filter_map(item).collect()
    }

    /// All keys with texts.
    pub fn texts(&self) -> Map<String, Value> {
        let items = self.value.as_object().into_iter().flatten();
        let texts = items.filter(|(_, value)| value.is_string());
        texts
            .map(|(key, value)| (key.clone(), value.clone()))
            .collect()
    }

    /// Refuse keys other than some.
    pub fn require_keys(&self, accepted: &[&str]) -> Result<(), Fault> {
        let mut keys = self.value.as_object().into_iter().flat_map(Map::keys);
        match keys.find(|key| !accepted.contains(&key.as_str())) {
            None => Ok(()),
            Some(key) => Err(Fault::Unknown {
                key: self.path_of(key),
                accepted: accepted.join(", "),
            }),
        }
    }

    fn path_of(&self, key: &str) -> String {
        match self.path.is_empty() {
            true => key.to_owned(),
            false => format!("{}.{key}", self.path),
        }
    }

    /// The value of a key; nothing if it is absent or null.
    pub fn optional(&self, key: &str) -> Option<Self> {
        let value = self.value.get(key).filter(|value| !value.is_null())?;
        let path = self.path_of(key);
        Some(Self { value, path })
    }

    /// The value of a key that must be there.
    pub fn required(&self, key: &str, accepted: &str) -> Result<Self, Fault> {
        self.optional(key).ok_or_else(|| Fault::Missing {
            key: self.path_of(key),
            accepted: accepted.to_owned(),
        })
    }

    /// An error about this value.
    pub fn refuse(&self, accepted: impl Into<String>) -> Fault {
        let mut value = self.value.to_string();
        if value.chars().count() > LONGEST {
            value = value.chars().take(LONGEST).collect::<String>() + "...";
        }
        let key = match self.path.is_empty() {
            true => "it".to_owned(),
            false => self.path.clone(),
        };
        Fault::Value {
            key,
            value,
            accepted: accepted.into(),
        }
    }

    /// An error about the value of a key.
    pub fn refuse_key(&self, key: &str, accepted: impl Into<String>) -> Fault {
        match self.optional(key) {
            Some(value) => value.refuse(accepted),
            None => Fault::Missing {
                key: self.path_of(key),
                accepted: accepted.into(),
            },
        }
    }

    /// This value as a number.
    pub fn as_number(&self) -> Result<f64, Fault> {
        let number = self.value.as_f64().filter(|number| number.is_finite());
        number.ok_or_else(|| self.refuse("a number"))
    }

    /// This value as a list.
    pub fn as_list(&self) -> Result<Vec<Self>, Fault> {
        let Some(items) = self.value.as_array() else {
            return Err(self.refuse("a list"));
        };
        let item = |(k, value)| Self {
            value,
            path: format!("{}[{k}]", self.path),
        };
        Ok(items.iter().enumerate().map(item).collect())
    }

    /// This value as a list of numbers.
    pub fn as_numbers(&self) -> Result<Vec<f64>, Fault> {
        self.as_list()?.iter().map(Self::as_number).collect()
    }

    /// This value as a fixed number of numbers.
    pub fn as_array<const N: usize>(&self) -> Result<[f64; N], Fault> {
        let numbers = self.as_numbers()?;
        let refused = |_| self.refuse(format!("{N} numbers"));
        numbers.try_into().map_err(refused)
    }

    /// This value as a whole number below a limit.
    pub fn as_index(&self, limit: usize, accepted: &str) -> Result<usize, Fault> {
        let whole = |x: f64| (x >= 0.0 && x < limit as f64 && x == x.floor()).then_some(x as usize);
        let index = self.value.as_f64().and_then(whole);
        index.ok_or_else(|| self.refuse(accepted))
    }

    /// This value as two indices below a number of nodes.
    pub fn as_pair(&self, nodes: usize) -> Result<[usize; 2], Fault> {
        let node = |value: &Self| value.as_index(nodes, &format!("a node below {nodes}"));
        match self.as_list()?.as_slice() {
            [i, j] => Ok([node(i)?, node(j)?]),
            _ => Err(self.refuse("two nodes")),
        }
    }

    /// This value as a vector.
    pub fn as_vector(&self) -> Result<Vec2, Fault> {
        let [x, y] = self.as_array()?;
        Ok(Vec2::new(x, y))
    }

    /// The value of a key that holds more keys.
    pub fn inside(&self, key: &str) -> Result<Self, Fault> {
        let inside = self.required(key, "an object")?;
        match inside.value.is_object() {
            true => Ok(inside),
            false => Err(inside.refuse("an object")),
        }
    }

    /// A number.
    pub fn number(&self, key: &str) -> Result<f64, Fault> {
        self.required(key, "a number")?.as_number()
    }

    /// A number, or another one if the key is absent.
    pub fn number_or(&self, key: &str, default: f64) -> Result<f64, Fault> {
        self.optional(key)
            .map_or(Ok(default), |value| value.as_number())
    }

    /// This value as a positive number.
    pub fn as_positive(&self) -> Result<f64, Fault> {
        let number = self.as_number()?;
        match number > 0.0 {
            true => Ok(number),
            false => Err(self.refuse("a positive number")),
        }
    }

    /// A positive number.
    pub fn positive(&self, key: &str) -> Result<f64, Fault> {
        self.required(key, "a positive number")?.as_positive()
    }

    /// A positive number that is neither so small nor so large that what follows from it is no usable number.
    pub fn usable(&self, key: &str) -> Result<f64, Fault> {
        self.required(key, "a positive number")?.as_usable()
    }

    /// This value as such a number.
    pub fn as_usable(&self) -> Result<f64, Fault> {
        let [least, most] = USABLE;
        let number = self.as_positive()?;
        match (least..=most).contains(&number) {
            true => Ok(number),
            false => Err(self.refuse(format!("a number from {least:?} to {most:?}"))),
        }
    }

    /// A number that is not negative.
    pub fn not_negative(&self, key: &str) -> Result<f64, Fault> {
        let accepted = "a number that is not negative";
        let value = self.required(key, accepted)?;
        let number = value.as_number()?;
        match number >= 0.0 {
            true => Ok(number),
            false => Err(value.refuse(accepted)),
        }
    }

    /// A whole number from `least` to `most`.
    pub fn count(&self, key: &str, least: usize, most: usize) -> Result<usize, Fault> {
        let accepted = format!("a whole number from {least} to {most}");
        let value = self.required(key, &accepted)?;
        let count = value.as_index(most + 1, &accepted)?;
        match count >= least {
            true => Ok(count),
            false => Err(value.refuse(accepted)),
        }
    }

    /// An index of a list of the case.
    pub fn index(&self, key: &str, list: &str, length: usize) -> Result<usize, Fault> {
        let accepted = format!("an index of {list}, below {length}");
        self.required(key, &accepted)?.as_index(length, &accepted)
    }

    /// A text.
    pub fn text(&self, key: &str) -> Result<&'a str, Fault> {
        let value = self.required(key, "a text")?;
        value.value.as_str().ok_or_else(|| value.refuse("a text"))
    }

    /// True or false.
    pub fn flag(&self, key: &str) -> Result<bool, Fault> {
        let value = self.required(key, "true or false")?;
        let flag = value.value.as_bool();
        flag.ok_or_else(|| value.refuse("true or false"))
    }

    /// True or false, or 1 or 0; another value if the key is absent.
    pub fn switch_or(&self, key: &str, default: bool) -> Result<bool, Fault> {
        let Some(value) = self.optional(key) else {
            return Ok(default);
        };
        let number = value.value.as_f64();
        let number = number.filter(|&number| number == 0.0 || number == 1.0);
        let switch = value.value.as_bool().or(number.map(|number| number == 1.0));
        switch.ok_or_else(|| value.refuse("true or false, or 1 or 0"))
    }

    /// One of several words.
    pub fn word(&self, key: &str, accepted: &[&str]) -> Result<&'a str, Fault> {
        let words = format!("one of: {}", accepted.join(", "));
        let value = self.required(key, &words)?;
        let found = value.value.as_str().filter(|word| accepted.contains(word));
        found.ok_or_else(|| value.refuse(words))
    }

    /// A fixed number of numbers.
    pub fn array<const N: usize>(&self, key: &str) -> Result<[f64; N], Fault> {
        self.required(key, &format!("{N} numbers"))?.as_array()
    }

    /// A vector.
    pub fn vector(&self, key: &str) -> Result<Vec2, Fault> {
        self.required(key, "2 numbers")?.as_vector()
    }

    /// A list.
    pub fn list(&self, key: &str) -> Result<Vec<Self>, Fault> {
        self.required(key, "a list")?.as_list()
    }

    /// A list with at least one item.
    pub fn filled_list(&self, key: &str, item: &str) -> Result<Vec<Self>, Fault> {
        let accepted = format!("a list of at least one {item}");
        let list = self.required(key, &accepted)?;
        let items = list.as_list()?;
        match items.is_empty() {
            true => Err(list.refuse(accepted)),
            false => Ok(items),
        }
    }

    /// A list of numbers.
    pub fn numbers(&self, key: &str) -> Result<Vec<f64>, Fault> {
        self.required(key, "a list of numbers")?.as_numbers()
    }

    /// A list with a fixed number of items.
    pub fn list_of(&self, key: &str, length: usize) -> Result<Vec<Self>, Fault> {
        let list = self.required(key, "a list")?;
        let items = list.as_list()?;
        match items.len() == length {
            true => Ok(items),
            false => Err(list.refuse(format!("a list of {length} items"))),
        }
    }

    /// Vectors from two lists with a fixed number of components.
    pub fn vectors(&self, x: &str, y: &str, length: usize) -> Result<Vec<Vec2>, Fault> {
        let components = self
            .numbers_of(x, length)?
            .into_iter()
            .zip(self.numbers_of(y, length)?);
        Ok(components.map(|(x, y)| Vec2::new(x, y)).collect())
    }

    /// A list with a fixed number of numbers.
    pub fn numbers_of(&self, key: &str, length: usize) -> Result<Vec<f64>, Fault> {
        self.list_of(key, length)?
            .iter()
            .map(Self::as_number)
            .collect()
    }

    /// A list with a fixed number of positive numbers, as [`Fields::usable`] accepts them.
    pub fn usables_of(&self, key: &str, length: usize) -> Result<Vec<f64>, Fault> {
        self.list_of(key, length)?
            .iter()
            .map(Self::as_usable)
            .collect()
    }
}
