//! Words, texts and records as bytes. All numbers are words of eight bytes, the least significant byte first.

use gouge_common::record::{Column, Record, Shape};

/// Append words.
pub fn put_words(bytes: &mut Vec<u8>, words: &[u64]) {
    bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
}

/// Append a string: its length, then its bytes.
pub fn put_text(bytes: &mut Vec<u8>, text: &str) {
    put_words(bytes, &[text.len() as u64]);
    bytes.extend(text.as_bytes());
}

/// Append a record: its model, the number of columns, then each column with name, shape, number of words and words.
pub fn put_record(bytes: &mut Vec<u8>, record: &Record) {
    put_text(bytes, &record.model);
    put_words(bytes, &[record.columns.len() as u64]);
    for column in &record.columns {
        put_text(bytes, &column.name);
        let (is_list, width) = match column.shape {
            Shape::Words(number) => (0, number),
            Shape::List(width) => (1, width),
        };
        put_words(bytes, &[is_list, width as u64, column.words.len() as u64]);
        put_words(bytes, &column.words);
    }
}

/// The bytes that are not read yet. Every function returns none if they do not suffice.
pub struct Reader<'a>(pub &'a [u8]);

impl<'a> Reader<'a> {
    fn bytes(&mut self, number: u64) -> Option<&'a [u8]> {
        let (read, rest) = self.0.split_at_checked(usize::try_from(number).ok()?)?;
        self.0 = rest;
        Some(read)
    }

    /// The next words.
    pub fn words(&mut self, number: u64) -> Option<Vec<u64>> {
        Some(words_of_bytes(self.bytes(number.checked_mul(8)?)?))
    }

    /// The next word.
    pub fn word(&mut self) -> Option<u64> {
        self.words(1)?.first().copied()
    }

    /// The next N words.
    pub fn array<const N: usize>(&mut self) -> Option<[u64; N]> {
        self.words(N as u64)?.try_into().ok()
    }

    /// The next string.
    pub fn text(&mut self) -> Option<String> {
        let length = self.word()?;
        String::from_utf8(self.bytes(length)?.to_vec()).ok()
    }

    /// The next record.
    pub fn record(&mut self) -> Option<Record> {
        let model = self.text()?;
        let number = self.word()?;
        let columns = (0..number).map(|_| self.column()).collect::<Option<_>>()?;
        Some(Record { model, columns })
    }

    fn column(&mut self) -> Option<Column> {
        let name = self.text()?;
        let (kind, width) = (self.word()?, usize::try_from(self.word()?).ok()?);
        let shape = match kind {
            0 => Shape::Words(width),
            1 => Shape::List(width),
            _ => return None,
        };
        let number = self.word()?;
        let words = self.words(number)?;
        Some(Column { name, shape, words })
    }
}

/// Bytes as words, the least significant byte of each word first; trailing bytes that do not fill a word are ignored.
pub fn words_of_bytes(bytes: &[u8]) -> Vec<u64> {
    let (words, _) = bytes.as_chunks();
    words.iter().copied().map(u64::from_le_bytes).collect()
}
