//! The state of any model as named columns of 64-bit words, for checkpoints.

/// A recorded state: the name of its model, and its columns in a fixed order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// Name of the model.
    pub model: String,
    /// The columns.
    pub columns: Vec<Column>,
}

/// A named column of a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name of the column.
    pub name: String,
    /// How the words are grouped.
    pub shape: Shape,
    /// The words; floating-point numbers are stored as their bits.
    pub words: Vec<u64>,
}

/// How the words of a column are grouped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A fixed number of words.
    Words(usize),
    /// Items of the given number of words each, at least one word.
    List(usize),
}

impl Column {
    /// Whether the number of words fits the shape.
    pub fn is_whole(&self) -> bool {
        match self.shape {
            Shape::Words(number) => self.words.len() == number,
            Shape::List(width) => width > 0 && self.words.len().is_multiple_of(width),
        }
    }
}

impl Record {
    /// All words in sequence; each list is preceded by its number of items.
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

    /// Rebuild a record from the words that [`words`](Self::words) returns and from the names and shapes of its
    /// columns. `None` if the words do not fill the columns exactly.
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
