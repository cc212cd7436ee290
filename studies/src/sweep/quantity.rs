//! Quantities of finished runs.

use crate::columns::Columns;
use crate::decay::Decay;
use crate::final_state::FinalState;
use gouge_dem::laws::characteristic_length;
use gouge_runner::run::Summary;
use gouge_runner::scene::Scene;
use serde::Deserialize;
use std::path::Path;

/// A finished run.
pub struct Finished<'a> {
    /// Its folder.
    pub folder: &'a Path,
    /// Its summary.
    pub summary: &'a Summary,
    /// Reads its scene.
    pub scene: &'a dyn Fn() -> Option<Scene>,
}

/// Quantities of a run.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Coefficient of friction of the driven block.
    Friction,
    /// Half the width of its confidence interval.
    FrictionMargin,
    /// Slip in m over which that coefficient is averaged.
    Slip,
    /// Mean load over the second half of the run, in units of the pressure times the area.
    LoadHeld,
    /// Number of broken bonds.
    BondsBroken,
    /// Limit of friction in the fit of thesis (100).
    DecayLimit,
    /// Half the width of its confidence interval.
    DecayLimitMargin,
    /// Rate of the decay in 1/s.
    DecayRate,
    /// Largest friction.
    DecayPeak,
    /// Its time in s.
    DecayPeakTime,
    /// Standard deviation of the residuals.
    DecayDeviation,
    /// Correlation of neighbouring residuals.
    DecayCorrelation,
    /// Number of fragments in the debris: those that hold neither a driven nor a fixed grain.
    DebrisFragments,
    /// Mean number of grains of the debris that lie above each other.
    DebrisDepth,
    /// Length of the longest crack within a block, in mean diameters.
    LongestCrack,
    /// Least distance between the driven or fixed grains and a crack that begins at the debris, in mean diameters.
    CrackGap,
    /// Number of grains of the debris less than 1.5 mean diameters away from a driven or fixed grain.
    EdgeDebris,
    /// Coefficient of restitution of two grains that meet head on in the frame of their centre of mass: the root of
    /// the ratio of the last to the first kinetic energy.
    Restitution,
    /// Time in s during which the energy of contacts is positive, in whole intervals between samples.
    ContactDuration,
    /// Angle of repose in rad of the free grains, see `repose_angle`.
    ReposeAngle,
}

impl Quantity {
    /// Its name in files and tables.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Friction => "friction",
            Self::FrictionMargin => "friction-margin",
            Self::Slip => "slip",
            Self::LoadHeld => "load-held",
            Self::BondsBroken => "bonds-broken",
            Self::DecayLimit => "decay-limit",
            Self::DecayLimitMargin => "decay-limit-margin",
            Self::DecayRate => "decay-rate",
            Self::DecayPeak => "decay-peak",
            Self::DecayPeakTime => "decay-peak-time",
            Self::DecayDeviation => "decay-deviation",
            Self::DecayCorrelation => "decay-correlation",
            Self::DebrisFragments => "debris-fragments",
            Self::DebrisDepth => "debris-depth",
            Self::LongestCrack => "longest-crack",
            Self::CrackGap => "crack-gap",
            Self::EdgeDebris => "edge-debris",
            Self::Restitution => "restitution",
            Self::ContactDuration => "contact-duration",
            Self::ReposeAngle => "repose-angle",
        }
    }

    /// Its value in a finished run; none if the run does not have it.
    pub(super) fn value(self, run: &Finished) -> Option<f64> {
        let friction = run.summary.friction.as_ref();
        match self {
            Self::Slip => friction.map(|one| one.slip),
            Self::LoadHeld => load_held(run),
            Self::Friction => friction.map(|one| one.coefficient),
            Self::FrictionMargin => friction.map(|one| 0.5 * (one.interval[1] - one.interval[0])),
            Self::BondsBroken => Some(run.summary.bonds_broken as f64),
            Self::Restitution => restitution(run.folder),
            Self::ContactDuration => contact_duration(run.folder),
            Self::ReposeAngle => repose_angle(run.folder),
            Self::DebrisFragments
            | Self::DebrisDepth
            | Self::LongestCrack
            | Self::CrackGap
            | Self::EdgeDebris => {
                let width = (run.scene)()?.domain.period()?;
                Some(self.of_state(&FinalState::read(run.folder, width)?))
            }
            _ => self.of_decay(run.folder),
        }
    }

    fn of_state(self, state: &FinalState) -> f64 {
        match self {
            Self::DebrisFragments => state.debris_fragments() as f64,
            Self::DebrisDepth => state.debris_depth(),
            Self::LongestCrack => state.longest_crack(),
            Self::EdgeDebris => state.edge_debris() as f64,
            _ => state.crack_gap(),
        }
    }

    fn of_decay(self, folder: &Path) -> Option<f64> {
        let series = Columns::of_series(folder)?;
        let decay = Decay::fit(series.get("time")?, series.get("friction_load")?)?;
        Some(match self {
            Self::DecayLimitMargin => decay.limit_margin(),
            Self::DecayLimit => decay.limit,
            Self::DecayRate => decay.rate,
            Self::DecayPeak => decay.peak,
            Self::DecayPeakTime => decay.peak_time,
            Self::DecayDeviation => decay.deviation(),
            _ => decay.correlation(),
        })
    }
}

fn load_held(run: &Finished) -> Option<f64> {
    let scene = (run.scene)()?;
    let particles = Columns::read(&run.folder.join("particles.csv"))?;
    let driving = scene.driving?;
    let law = driving.law(
        scene.domain.width?,
        characteristic_length(particles.get("radius")?),
    );
    let series = Columns::of_series(run.folder)?;
    let force = series.after("drive_force_y", 0.5 * run.summary.time)?;
    let load = -force.iter().sum::<f64>() / force.len() as f64;
    Some(load / (law.pressure * law.area))
}

/// Root of the ratio of the last to the first kinetic energy; none if the grains still touch.
fn restitution(folder: &Path) -> Option<f64> {
    let series = Columns::of_series(folder)?;
    let kinetic = series.get("kinetic")?;
    let is_over = *series.get("contact")?.last()? == 0.0;
    is_over.then_some((kinetic.last()? / kinetic.first()?).sqrt())
}

/// Time between the samples before and after the contact; none if the grains never touch or still do.
fn contact_duration(folder: &Path) -> Option<f64> {
    let series = Columns::of_series(folder)?;
    let (time, contact) = (series.get("time")?, series.get("contact")?);
    let first = contact.iter().position(|&energy| energy > 0.0)?;
    let last = contact.iter().rposition(|&energy| energy > 0.0)?;
    let after = time.get(last + 1)?;
    // The contact began and ended half an interval from these samples, on average.
    Some(0.5 * (after + time[last]) - 0.5 * (time[first] + time[first.checked_sub(1)?]))
}

/// Angle in rad of the triangle whose centre of mass is as high above the highest fixed grain, and whose horizontal
/// variance is as large, as those of the free grains: a triangle of height H and base 2 B has its centre of mass at
/// H / 3, and its variance is B^2 / 6.
fn repose_angle(folder: &Path) -> Option<f64> {
    let mut reader = csv::Reader::from_path(folder.join("particles.csv")).ok()?;
    let (mut floor, mut free) = (f64::NEG_INFINITY, Vec::new());
    for grain in reader.deserialize::<Grain>() {
        let grain = grain.ok()?;
        match grain.role.as_str() {
            "fixed" => floor = floor.max(grain.y),
            _ => free.push([grain.x, grain.y]),
        }
    }
    let number = free.len() as f64;
    let mean = |k: usize| free.iter().map(|place| place[k]).sum::<f64>() / number;
    let (middle, height) = (mean(0), mean(1) - floor);
    let squares = free.iter().map(|place| (place[0] - middle).powi(2));
    let variance = squares.sum::<f64>() / number;
    Some((3.0 * height / (6.0 * variance).sqrt()).atan())
}

/// A row of the final particles.
#[derive(Deserialize)]
struct Grain {
    x: f64,
    y: f64,
    role: String,
}
