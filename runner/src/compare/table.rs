//! CSV files with a header.

use super::dump::Fault;
use super::read::{Data, Frame, Kind, When};

/// Read a table. The column `time` in s, or `step`, gives the time of each row; without them all rows are of the end of
/// the run. The column `id` gives its particle, counted from zero; without it each row describes the whole run.
///
/// # Errors
/// A row that cannot be read.
pub fn parse(file: &str, bytes: &[u8]) -> Result<Data, Fault> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let broken = |error: csv::Error| {
        let line = error
            .position()
            .map_or(0, |position| position.line() as usize);
        (line, format!("must be a CSV file with a header: {error}"))
    };
    let header = reader.headers().map_err(broken)?.clone();
    let place = |wanted: &str| header.iter().position(|name| name == wanted);
    let (time, step, id) = (place("time"), place("step"), place("id"));
    let keys = [time, step, id];
    let records: Vec<csv::StringRecord> =
        reader.records().collect::<Result<_, _>>().map_err(broken)?;
    if records.is_empty() {
        return Err((0, "must have a header and at least one row".to_owned()));
    }
    let is_number = |&column: &usize| records.iter().all(|row| row[column].parse::<f64>().is_ok());
    let (numbers, others): (Vec<usize>, Vec<usize>) = (0..header.len())
        .filter(|&column| !keys.contains(&Some(column)))
        .partition(is_number);
    let names = |columns: &[usize]| {
        columns
            .iter()
            .map(|&column| header[column].to_owned())
            .collect()
    };
    let mut data = Data {
        file: file.to_owned(),
        kind: id.map_or(Kind::Run, |_| Kind::Particles),
        names: names(&numbers),
        others: names(&others),
        frames: Vec::new(),
    };
    for row in &records {
        let when = match (time, step) {
            (Some(time), _) => When::Time(value(row, time, "time", "a number of seconds")?),
            (None, Some(step)) => When::Step(value(row, step, "step", "an integer from 0")?),
            (None, None) => When::End,
        };
        let id = match id {
            Some(id) => Some(value::<usize>(row, id, "id", "an integer from 0")?),
            None => None,
        };
        let cell = |&column: &usize| vec![row[column].parse().unwrap_or(f64::NAN)];
        data.frames.push(Frame {
            when,
            ids: id.map(|id| vec![id]),
            columns: numbers.iter().map(cell).collect(),
        });
    }
    Ok(data)
}

fn value<T: std::str::FromStr>(
    row: &csv::StringRecord,
    column: usize,
    name: &str,
    accepted: &str,
) -> Result<T, Fault> {
    let line = row
        .position()
        .map_or(0, |position| position.line() as usize);
    let cell = &row[column];
    cell.parse()
        .map_err(|_| (line, format!("{name} = {cell}: must be {accepted}")))
}
