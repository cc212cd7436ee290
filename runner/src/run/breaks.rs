//! Writes the file `breaks.csv`: a row per bond that broke.

use super::scene_run::SceneRun;
use crate::error::Error;
use gouge_dem::Break;

/// Columns of `breaks.csv`.
pub const COLUMNS: [&str; 9] = [
    "time",
    "i",
    "j",
    "x",
    "y",
    "normal_force",
    "tangential_force",
    "cause",
    "share",
];

/// The row of a break. The cause is the greater term of the yield criterion, with its share in the sum of both.
fn row(broken: &Break, time_step: f64) -> Vec<String> {
    let time = broken.steps as f64 * time_step;
    let normal = broken.normal_share;
    let (cause, share) = match normal >= 0.5 {
        true => ("normal", normal),
        false => ("tangential", 1.0 - normal),
    };
    let number = |number: f64| format!("{number:?}");
    vec![
        number(time),
        broken.pair.i.to_string(),
        broken.pair.j.to_string(),
        number(broken.focal_point.x),
        number(broken.focal_point.y),
        number(broken.normal_force),
        number(broken.tangential_force),
        cause.to_owned(),
        number(share),
    ]
}

impl SceneRun<'_> {
    /// Whether bonds can break in the scene proper.
    pub(super) fn can_break(&self) -> bool {
        let bond = self.scene.bond;
        self.context.is_main() && bond.is_some_and(|laws| laws.yielding.is_some())
    }

    /// Append the bonds that broke since the last call.
    pub(super) fn write_breaks(&mut self) -> Result<(), Error> {
        let table = self.files.as_mut().and_then(|files| files.table.as_mut());
        let Some(file) = table else {
            return Ok(());
        };
        let time_step = self.world.model().time_step;
        for broken in self.world.breaks() {
            file.append_row(&row(broken, time_step))?;
        }
        self.world.forget_breaks();
        Ok(())
    }
}
