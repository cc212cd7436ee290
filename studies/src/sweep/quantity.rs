//! Quantities of finished runs.

use super::finished::Finished;
use super::specimen::{contact_duration, isotropic, repose_angle, restitution};
use crate::columns::Columns;
use crate::decay::Decay;
use crate::final_state::FinalState;
use gouge_dem::laws::characteristic_length;
use gouge_dem::particles::Role;
use gouge_runner::scene::{Measure, Scene};
use serde::Deserialize;

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
    /// Time in s during which the energy of contacts is positive, see `contact_duration`.
    ContactDuration,
    /// Young's modulus in Pa, see `isotropic`.
    YoungsModulus,
    /// Poisson's ratio, see `isotropic`.
    PoissonsRatio,
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
            Self::YoungsModulus => "youngs-modulus",
            Self::PoissonsRatio => "poissons-ratio",
            Self::ReposeAngle => "repose-angle",
        }
    }

    /// Its unit; empty if it is a number.
    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Slip => "m",
            Self::DecayRate => "1/s",
            Self::DecayPeakTime | Self::ContactDuration => "s",
            Self::YoungsModulus => "Pa",
            Self::ReposeAngle => "rad",
            _ => "",
        }
    }

    /// What a scene needs for it and does not have; none if runs of the scene can have a value.
    pub(super) fn lacks(self, scene: &Scene) -> Option<&'static str> {
        let (driving, energy) = (scene.driving, scene.output.energy);
        let measures = |measure: Measure| scene.output.measure.contains(&measure);
        let can_break = scene.bond.is_some_and(|bond| bond.yielding.is_some());
        let (is_there, needed) = match self {
            Self::BondsBroken => (true, ""),
            Self::Friction | Self::FrictionMargin | Self::Slip => (
                driving.is_some() && energy,
                "[driving], and output.energy = true",
            ),
            Self::LoadHeld => (
                driving.is_some_and(|one| one.pressure != 0.0) && scene.domain.width.is_some(),
                "driving.pressure and box.width",
            ),
            Self::Restitution => (energy, "output.energy = true"),
            Self::ContactDuration => (
                scene.contact.is_some() && energy,
                "[contact], and output.energy = true",
            ),
            Self::YoungsModulus | Self::PoissonsRatio => (
                measures(Measure::Stress) && measures(Measure::Strain),
                "output.measure = [\"stress\", \"strain\"]",
            ),
            Self::ReposeAngle => (has_floor(scene), "fixed grains, on which the others lie"),
            Self::DebrisFragments
            | Self::DebrisDepth
            | Self::LongestCrack
            | Self::CrackGap
            | Self::EdgeDebris => (
                scene.domain.period().is_some() && can_break,
                "[bond.yielding], and box.boundary = \"periodic-x\"",
            ),
            _ => (driving.is_some(), "[driving]"),
        };
        (!is_there).then_some(needed)
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
            Self::Restitution => restitution(run.series()?),
            Self::ContactDuration => contact_duration(run.series()?),
            Self::YoungsModulus => Some(isotropic(run.series()?)?[0]),
            Self::PoissonsRatio => Some(isotropic(run.series()?)?[1]),
            Self::ReposeAngle => repose_angle(run.folder),
            Self::DebrisFragments
            | Self::DebrisDepth
            | Self::LongestCrack
            | Self::CrackGap
            | Self::EdgeDebris => Some(self.of_state(run.final_state()?)),
            _ => Some(self.of_decay(run.decay()?)),
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

    fn of_decay(self, decay: &Decay) -> f64 {
        match self {
            Self::DecayLimitMargin => decay.limit_margin(),
            Self::DecayLimit => decay.limit,
            Self::DecayRate => decay.rate,
            Self::DecayPeak => decay.peak,
            Self::DecayPeakTime => decay.peak_time,
            Self::DecayDeviation => decay.deviation(),
            _ => decay.correlation(),
        }
    }
}

/// Whether grains of a scene are fixed, as far as it tells: one that begins from another run may have any.
fn has_floor(scene: &Scene) -> bool {
    let roles = scene.setup.as_ref().and_then(|setup| setup.roles);
    scene.start.is_some()
        || scene.particles.iter().any(|one| one.role == Role::Fixed)
        || roles.is_some_and(|one| one.fixed_below.or(one.fixed_left_of).is_some())
}

fn load_held(run: &Finished) -> Option<f64> {
    let scene = run.scene()?;
    let particles = Columns::read(&run.folder.join("particles.csv"))?;
    let driving = scene.driving?;
    let law = driving.law(
        scene.domain.width?,
        characteristic_length(particles.get("radius")?),
    );
    let force = run
        .series()?
        .after("drive_force_y", 0.5 * run.summary.time)?;
    let load = -force.iter().sum::<f64>() / force.len() as f64;
    Some(load / (law.pressure * law.area))
}
