//! How worlds use the machine: nothing here changes a bit of a result.

use crate::error::Error;
use gouge_kernel::scalar::Real;
use gouge_kernel::{Instructions, World};
use std::sync::LazyLock;

/// The environment variable that names the instructions to use instead of the widest ones.
pub const INSTRUCTIONS: &str = "GOUGE_INSTRUCTIONS";

static CHOSEN: LazyLock<Result<Instructions, String>> = LazyLock::new(choose);

fn choose() -> Result<Instructions, String> {
    let Some(name) = std::env::var_os(INSTRUCTIONS) else {
        return Ok(Instructions::widest());
    };
    let available = Instructions::available();
    let found = available
        .iter()
        .find(|set| name.to_str() == Some(set.name()));
    found.copied().ok_or_else(|| {
        let names: Vec<&str> = available.iter().map(|set| set.name()).collect();
        format!(
            "{INSTRUCTIONS} = {}: this machine has {}",
            name.to_string_lossy(),
            names.join(", ")
        )
    })
}

/// The instructions that worlds use.
///
/// # Errors
/// An environment variable that names none of this machine.
pub fn instructions() -> Result<Instructions, Error> {
    CHOSEN.clone().map_err(Error::Argument)
}

/// A world that uses the chosen instructions; the widest ones where the choice is an error.
pub(crate) fn equipped<S: Real>(world: World<S>) -> World<S> {
    world.with_instructions(CHOSEN.clone().unwrap_or_default())
}
