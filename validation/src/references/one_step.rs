//! Steps of many bodies that Siconos solved, in `references/siconos/one-step`.

use gouge_runner::references::file_text;
use serde_json::Value;
use std::path::Path;

const CASE: &str = "siconos/one-step";
/// Residual of a solution that counts, in units of the scale.
const CERTIFIED: f64 = 1e-11;

/// A rigid unit.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Inverse masses in x and y in 1/kg, and inverse moment of inertia in 1/(kg m^2).
    pub inverse: [f64; 3],
    /// Velocity before the step in m/s and rad/s.
    pub before: [f64; 3],
    /// Force in N and torque in N m.
    pub load: [f64; 3],
    /// Velocity after the step by Siconos.
    pub after: [f64; 3],
}

/// A contact point.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// The two units.
    pub units: [u32; 2],
    /// Direction of the normal from the first to the second in rad.
    pub normal: f64,
    /// Normal and tangential components of the arms of both in m.
    pub arms: [[f64; 2]; 2],
    /// Gap in m.
    pub gap: f64,
    /// Normal and tangential impulse by Siconos in kg m/s.
    pub impulse: [f64; 2],
    /// Whether all solves of Siconos agree about the impulse.
    pub is_unique: bool,
}

/// A step of many bodies with its solution.
#[derive(Clone, Debug)]
pub struct OneStep {
    /// Its name.
    pub name: String,
    /// Coefficient of friction.
    pub friction: f64,
    /// Normal and tangential restitution.
    pub restitution: [f64; 2],
    /// Time step in s.
    pub time_step: f64,
    /// Largest velocity to which the laws apply without impulses in m/s.
    pub scale: f64,
    /// Largest difference of velocities between certified solves from nothing, in units of the scale.
    pub spread: f64,
    /// The units.
    pub units: Vec<Unit>,
    /// The contact points.
    pub points: Vec<Point>,
}

impl OneStep {
    /// All stored steps, from the fewest points to the most.
    ///
    /// # Errors
    /// A file that cannot be parsed.
    pub fn all() -> Result<Vec<Self>, String> {
        let result = read(&Path::new(CASE).join("result.json"))?;
        let runs = result["runs"].as_array().ok_or("there are no runs")?;
        let mut steps = runs.iter().map(Self::of).collect::<Result<Vec<_>, _>>()?;
        steps.sort_by_key(|step| step.points.len());
        Ok(steps)
    }

    fn of(run: &Value) -> Result<Self, String> {
        let name = run["name"].as_str().ok_or("a run has no name")?;
        let path = Path::new(CASE).join("problems");
        let data = read(&path.join(format!("{name}.json")))?;
        let units = numbers(
            &data["units"],
            &[
                "inverse_mass_x",
                "inverse_mass_y",
                "inverse_moment",
                "vx",
                "vy",
                "omega",
                "fx",
                "fy",
                "torque",
            ],
        )?;
        let after = numbers(&run["velocities"], &["vx", "vy", "omega"])?;
        let points = numbers(
            &data["points"],
            &[
                "first", "second", "normal", "first_n", "first_t", "second_n", "second_t", "gap",
            ],
        )?;
        let impulses = numbers(&run["impulses"], &["normal", "tangential", "unique"])?;
        let number = |object: &Value, key: &str| {
            let found = object[key].as_f64();
            found.ok_or_else(|| format!("{name}: {key} is not a number"))
        };
        Ok(Self {
            name: name.to_owned(),
            friction: number(&data, "friction")?,
            restitution: [
                number(&data, "normal_restitution")?,
                number(&data, "tangential_restitution")?,
            ],
            time_step: number(&data, "time_step")?,
            scale: number(run, "scale")?,
            spread: spread(&run["solves"])?,
            units: units.iter().zip(&after).map(unit).collect(),
            points: points.iter().zip(&impulses).map(point).collect(),
        })
    }
}

fn unit((row, after): (&Vec<f64>, &Vec<f64>)) -> Unit {
    let three = |from: usize| [row[from], row[from + 1], row[from + 2]];
    Unit {
        inverse: three(0),
        before: three(3),
        load: three(6),
        after: [after[0], after[1], after[2]],
    }
}

fn point((row, impulse): (&Vec<f64>, &Vec<f64>)) -> Point {
    Point {
        units: [row[0] as u32, row[1] as u32],
        normal: row[2],
        arms: [[row[3], row[4]], [row[5], row[6]]],
        gap: row[7],
        impulse: [impulse[0], impulse[1]],
        is_unique: impulse[2] == 1.0,
    }
}

/// Largest difference between certified solves from nothing.
fn spread(solves: &Value) -> Result<f64, String> {
    let columns = names(solves);
    let start = columns.iter().position(|&name| name == "start");
    let rows = solves["rows"].as_array().map_or(&[][..], Vec::as_slice);
    let found = numbers(solves, &["residual", "velocity_difference"])?;
    let from_nothing = |row: &Value| start.is_some_and(|place| row[place] == "zero");
    let kept = rows.iter().zip(&found).filter(|(row, _)| from_nothing(row));
    let certified = kept.filter(|(_, found)| found[0] < CERTIFIED);
    Ok(certified.map(|(_, found)| found[1]).fold(0.0, f64::max))
}

fn read(path: &Path) -> Result<Value, String> {
    let folder = path.parent().unwrap_or(path);
    let name = path.file_name().map(|name| name.to_string_lossy());
    let text = file_text(folder, &name.unwrap_or_default())?;
    serde_json::from_str(text).map_err(|error| format!("{}: {error}", path.display()))
}

fn names(table: &Value) -> Vec<&str> {
    let columns = table["columns"].as_array().map_or(&[][..], Vec::as_slice);
    columns.iter().filter_map(Value::as_str).collect()
}

/// Some columns of a table of numbers, by rows.
fn numbers(table: &Value, wanted: &[&str]) -> Result<Vec<Vec<f64>>, String> {
    let columns = names(table);
    let place = |name: &&str| {
        let found = columns.iter().position(|column| column == name);
        found.ok_or_else(|| format!("{CASE}: there is no column {name}"))
    };
    let places: Vec<usize> = wanted.iter().map(place).collect::<Result<_, _>>()?;
    let rows = table["rows"].as_array().map_or(&[][..], Vec::as_slice);
    let row = |row: &Value| {
        let cells = places.iter().map(|&place| row[place].as_f64());
        let cells: Option<Vec<f64>> = cells.collect();
        cells.ok_or_else(|| format!("{CASE}: a cell is not a number"))
    };
    rows.iter().map(row).collect()
}
