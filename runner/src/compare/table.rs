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
        .comment(Some(b'#'))
        .from_reader(bytes);
    let broken = |error: csv::Error| {
        let line = error
            .position()
            .map_or(0, |position| position.line() as usize);
        (line, format!("must be a CSV file with a header: {error}"))
    };
    let header = reader.headers().map_err(broken)?.clone();
    let mut seen = std::collections::HashSet::new();
    if let Some(name) = header.iter().find(|name| !seen.insert(*name)) {
        return Err((1, format!("{name}: this column is given twice")));
    }
    let place = |wanted: &str| header.iter().position(|name| name == wanted);
    let (time, step, id) = (place("time"), place("step"), place("id"));
    let keys = [time, step, id];
    if time.is_some() && step.is_some() {
        return Err((
            1,
            "only one of the columns time and step may be given".to_owned(),
        ));
    }
    let records: Vec<csv::StringRecord> =
        reader.records().collect::<Result<_, _>>().map_err(broken)?;
    if records.is_empty() {
        return Err((0, "must have a header and at least one row".to_owned()));
    }
    if header.len() == 1 && header[0].contains([';', '\t']) {
        return Err((1, "the columns must be separated by commas".to_owned()));
    }
    let (numbers, others) = numbers_and_others(&header, &records, &keys)?;
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
        first_id: 0,
        frames: Vec::new(),
    };
    for row in &records {
        data.frames.push(frame(row, [time, step, id], &numbers)?);
    }
    Ok(data)
}

/// The frame of a single row, with the columns of its time, its step and its particle.
fn frame(
    row: &csv::StringRecord,
    [time, step, id]: [Option<usize>; 3],
    numbers: &[usize],
) -> Result<Frame, Fault> {
    let when = match (time, step) {
        (Some(time), _) => When::Time(value(row, time, "time", "a number of seconds")?),
        (None, Some(step)) => When::Step(value(row, step, "step", "an integer from 0")?),
        (None, None) => When::End,
    };
    let particle = |id: usize| value::<usize>(row, id, "id", "an integer from 0");
    let number = |&column: &usize| vec![row[column].parse().unwrap_or(f64::NAN)];
    Ok(Frame {
        when,
        ids: id.map(particle).transpose()?.map(|id| vec![id]),
        columns: numbers.iter().map(number).collect(),
    })
}

/// The columns of numbers and those of other things, without the keys.
fn numbers_and_others(
    header: &csv::StringRecord,
    records: &[csv::StringRecord],
    keys: &[Option<usize>],
) -> Result<(Vec<usize>, Vec<usize>), Fault> {
    let (mut numbers, mut others) = (Vec::new(), Vec::new());
    for column in (0..header.len()).filter(|&column| !keys.contains(&Some(column))) {
        let is_number = |row: &&csv::StringRecord| row[column].parse::<f64>().is_ok();
        match records.iter().filter(is_number).count() {
            0 => others.push(column),
            all if all == records.len() => numbers.push(column),
            _ => {
                let odd = records.iter().find(|row| !is_number(row));
                let row = odd.unwrap_or(&records[0]);
                return Err((
                    line_of(row),
                    format!(
                        "{} = {:?}: must be a number, as in other rows",
                        &header[column], &row[column]
                    ),
                ));
            }
        }
    }
    Ok((numbers, others))
}

fn line_of(row: &csv::StringRecord) -> usize {
    row.position()
        .map_or(0, |position| position.line() as usize)
}

fn value<T: std::str::FromStr>(
    row: &csv::StringRecord,
    column: usize,
    name: &str,
    accepted: &str,
) -> Result<T, Fault> {
    let line = line_of(row);
    let cell = &row[column];
    cell.parse()
        .map_err(|_| (line, format!("{name} = {cell}: must be {accepted}")))
}
