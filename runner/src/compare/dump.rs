//! LAMMPS dumps in text form, as `dump custom` writes them.

use super::read::{Data, Frame, Kind, When};

/// A line, zero for the whole file, and what is wrong there.
pub type Fault = (usize, String);

/// The lines of a file and their numbers.
struct Lines<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    number: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<&'a str> {
        let (place, line) = self.lines.next()?;
        self.number = place + 1;
        Some(line.trim_end())
    }

    fn expect(&mut self, what: &str) -> Result<&'a str, Fault> {
        self.next()
            .ok_or_else(|| (self.number, format!("the file ends here; expected {what}")))
    }

    fn number_of<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, Fault> {
        let line = self.expect(what)?;
        line.trim()
            .parse()
            .map_err(|_| (self.number, format!("{line:?}: must be {what}")))
    }
}

/// Read all frames. Identifiers count from 1 there and from 0 here.
///
/// # Errors
/// A line that does not belong into a dump, or frames with different columns.
pub fn parse(file: &str, bytes: &[u8]) -> Result<Data, Fault> {
    let text = std::str::from_utf8(bytes)
        .map_err(|_| (0, "must be a LAMMPS dump in text form".to_owned()))?;
    let mut lines = Lines {
        lines: text.lines().enumerate(),
        number: 0,
    };
    let mut data = Data {
        file: file.to_owned(),
        kind: Kind::Particles,
        names: Vec::new(),
        others: Vec::new(),
        first_id: 1,
        frames: Vec::new(),
    };
    let (mut step, mut number) = (None, 0);
    while let Some(line) = lines.next() {
        match line.strip_prefix("ITEM: ").map(str::trim) {
            Some("TIMESTEP") => step = Some(lines.number_of::<u64>("a number of steps")?),
            Some("NUMBER OF ATOMS") => number = lines.number_of::<usize>("a number of atoms")?,
            Some(item) if item.starts_with("BOX BOUNDS") => {
                for _ in 0..3 {
                    lines.expect("the bounds of the box")?;
                }
            }
            Some(item) if item.starts_with("ATOMS") => {
                let step = step.take().ok_or_else(|| {
                    (
                        lines.number,
                        "ITEM: ATOMS without ITEM: TIMESTEP".to_owned(),
                    )
                })?;
                let names: Vec<&str> = item.split_whitespace().skip(1).collect();
                let frame = atoms(&mut lines, &mut data, &names, number)?;
                data.frames.push(Frame {
                    when: When::Step(step),
                    ..frame
                });
            }
            Some("UNITS" | "TIME") => {
                lines.expect("a value")?;
            }
            _ if line.is_empty() => {}
            _ => return Err((lines.number, format!("{line:?}: must be an ITEM of a dump"))),
        }
    }
    match data.frames.is_empty() {
        true => Err((0, "must hold at least one frame".to_owned())),
        false => Ok(data),
    }
}

/// The rows of a frame.
fn atoms(
    lines: &mut Lines,
    data: &mut Data,
    names: &[&str],
    number: usize,
) -> Result<Frame, Fault> {
    let own: Vec<&str> = names.iter().copied().filter(|name| *name != "id").collect();
    if number == 0 {
        return Err((lines.number, "the frame holds no atoms".to_owned()));
    }
    let place = names.iter().position(|name| *name == "id");
    let place = place.ok_or_else(|| (lines.number, "the column id is missing".to_owned()))?;
    match data.frames.is_empty() {
        true => data.names = own.iter().map(|name| (*name).to_owned()).collect(),
        false if data.names == own => {}
        false => {
            return Err((
                lines.number,
                "the columns differ from those before".to_owned(),
            ));
        }
    }
    let mut columns = vec![Vec::new(); own.len()];
    let mut ids = Vec::new();
    for _ in 0..number {
        let line = lines.expect("an atom")?;
        let cells: Vec<&str> = line.split_whitespace().collect();
        if cells.len() != names.len() {
            let reason = format!("{} values for {} columns", cells.len(), names.len());
            return Err((lines.number, reason));
        }
        let id: usize = cells[place]
            .parse()
            .ok()
            .filter(|&id| id > 0)
            .ok_or_else(|| {
                (
                    lines.number,
                    format!("id {}: must be an integer from 1", cells[place]),
                )
            })?;
        ids.push(id - 1);
        let others = (0..cells.len()).filter(|&cell| cell != place);
        for (column, cell) in columns.iter_mut().zip(others) {
            // Columns of other things than numbers, such as element names, cannot be compared.
            column.push(cells[cell].parse().unwrap_or(f64::NAN));
        }
    }
    Ok(Frame {
        when: When::End,
        ids: Some(ids),
        columns,
    })
}
