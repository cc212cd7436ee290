//! The state of any model as named columns of words, for checkpoints.

/// A state: the model that it belongs to, and its columns in a fixed order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// Name of the model.
    pub model: String,
    /// The columns.
    pub columns: Vec<Column>,
}

/// A named part of a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// How its words are grouped.
    pub shape: Shape,
    /// Its words; doubles as their bits.
    pub words: Vec<u64>,
}

/// How the words of a column are grouped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A fixed number of words.
    Words(usize),
    /// A list of items of so many words each, at least one.
    List(usize),
}

impl Column {
    /// Whether the words fill the shape.
    pub fn is_whole(&self) -> bool {
        match self.shape {
            Shape::Words(number) => self.words.len() == number,
            Shape::List(width) => width > 0 && self.words.len().is_multiple_of(width),
        }
    }
}

impl Record {
    /// All words one after the other; a list is preceded by the number of its items.
    pub fn words(&self) -> Vec<u64> {
        let mut all = Vec::new();
        for column in &self.columns {
            if let Shape::List(width) = column.shape {
                all.push((column.words.len() / width.max(1)) as u64);
            }
            all.extend(&column.words);
        }
        all
    }

    /// The record of words as [`words`](Self::words) writes them, with the given names and shapes of columns;
    /// none if the words do not fill them exactly.
    pub fn from_words(model: &str, layout: &[(&str, Shape)], mut words: &[u64]) -> Option<Self> {
        let mut columns = Vec::with_capacity(layout.len());
        for &(name, shape) in layout {
            let number = match shape {
                Shape::Words(number) => number,
                Shape::List(width) => {
                    let (&items, rest) = words.split_first()?;
                    words = rest;
                    usize::try_from(items).ok()?.checked_mul(width)?
                }
            };
            let (own, rest) = words.split_at_checked(number)?;
            words = rest;
            columns.push(Column {
                name: name.to_owned(),
                shape,
                words: own.to_vec(),
            });
        }
        words.is_empty().then_some(Self {
            model: model.to_owned(),
            columns,
        })
    }
}
