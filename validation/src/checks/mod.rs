//! The register of checks: a claim, how it was measured, and why the tolerance is what it is.

mod closure;
mod collision;
mod integration;
mod links;

use gouge_kernel::World;
use serde::Serialize;

/// Where a tolerance comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// Rounding alone.
    Exact,
    /// The order of the method and a known constant.
    Convergent,
    /// A margin and a power fixed beforehand.
    Statistical,
}

/// A check, before it is run.
pub struct Check {
    /// Identifier.
    pub id: &'static str,
    /// The claim, one sentence.
    pub claim: &'static str,
    /// Equations of the thesis that it stands for.
    pub equations: &'static str,
    /// Where the tolerance comes from.
    pub origin: Origin,
    /// The measurement.
    pub measure: fn() -> Measurement,
}

/// What a check found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// What should come out.
    pub expected: f64,
    /// What came out.
    pub measured: f64,
    /// Their distance in the norm of the check.
    pub error: f64,
    /// The largest distance that passes.
    pub tolerance: f64,
}

impl Measurement {
    /// A comparison by relative error.
    pub fn relative(expected: f64, measured: f64, tolerance: f64) -> Self {
        Self {
            expected,
            measured,
            error: (measured / expected - 1.0).abs(),
            tolerance,
        }
    }
    /// A comparison by absolute error.
    pub fn absolute(expected: f64, measured: f64, tolerance: f64) -> Self {
        Self {
            expected,
            measured,
            error: (measured - expected).abs(),
            tolerance,
        }
    }
    /// Whether the error is within the tolerance; an undefined error is not.
    pub fn passes(&self) -> bool {
        self.error <= self.tolerance
    }
    /// Correct decimal digits, at most those of a double.
    pub fn digits(&self) -> f64 {
        (-self.error.max(1e-16).log10()).max(0.0)
    }
}

/// All checks, in the order of the report.
pub fn register() -> Vec<Check> {
    [
        collision::checks(),
        links::checks(),
        integration::checks(),
        closure::checks(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The world of a scene's text; checks use only scenes that are valid.
fn world(text: &str) -> Option<World> {
    let scene = crate::scene::Scene::parse("check", text.as_bytes(), std::path::Path::new("."));
    scene.ok()?.initial_world().ok()
}

/// Advance so many steps; false where the state became senseless.
fn advance(world: &mut World, steps: u64) -> bool {
    (0..steps).all(|_| world.step().is_ok())
}

/// A measurement that could not be made: it fails.
fn impossible() -> Measurement {
    Measurement::absolute(0.0, f64::NAN, 0.0)
}
