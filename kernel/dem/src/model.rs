//! The model of a scene: chosen laws and their parameters, as plain data.

use crate::geometry::ContactDistance;
use crate::integrators::Integrator;
use crate::laws::{
    AdjustedKelvinVoigt, Bshp, CorrelationDrag, CreepingDrag, CundallStrack,
    CundallStrackTruncated, Driving, EulerBernoulli, Gravity, HaffWerner, HarmonicWell,
    KelvinVoigt, ZhangEckert,
};
use crate::particles::{COMPUTED_INERTIA_FACTOR, SPHERE_INERTIA_FACTOR};
use gouge_common::geometry::Domain;

/// Which form is used of what `docs/thesis/errata.md` lists as changing forces or motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// What the errata decide.
    Corrected,
    /// What the thesis prints or its author computed.
    Thesis,
}

impl Reading {
    /// Moment of inertia in units of mass times radius squared, where a scene gives none: 2/5, the
    /// sphere's, or 3/5, which the thesis's author computed with (erratum E64 of the thesis).
    pub fn inertia_factor(self) -> f64 {
        match self {
            Self::Corrected => SPHERE_INERTIA_FACTOR,
            Self::Thesis => COMPUTED_INERTIA_FACTOR,
        }
    }
}

/// Normal law of weak links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactNormal {
    /// Truncated Kelvin-Voigt.
    KelvinVoigt(KelvinVoigt),
    /// Viscoelastic spheres.
    Bshp(Bshp),
}

/// Tangential law of weak links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactTangential {
    /// Haff-Werner.
    HaffWerner(HaffWerner),
    /// Cundall-Strack as printed.
    CundallStrack(CundallStrack),
    /// Cundall-Strack with the spring cut back while sliding.
    CundallStrackTruncated(CundallStrackTruncated),
}

/// Overlap, in smaller radii, at which the slope of a non-linear normal law counts as its stiffness.
const TYPICAL_OVERLAP: f64 = 0.1;

impl ContactNormal {
    /// Stiffness in kg/s^2 and damping in kg/s for small motions of a pair with radii in m; for BSHP at an
    /// overlap of a tenth of the smaller radius.
    pub fn constants(&self, radii: [f64; 2]) -> [f64; 2] {
        match self {
            Self::KelvinVoigt(law) => [law.stiffness, law.damping],
            Self::Bshp(law) => {
                let xi = TYPICAL_OVERLAP * radii[0].min(radii[1]);
                let slope = 1.5 * law.prefactor(radii) * xi.sqrt();
                [slope, slope / 1.5 * law.dissipative_constant]
            }
        }
    }
}

impl ContactTangential {
    /// Stiffness in kg/s^2 and damping in kg/s below the Coulomb limit.
    pub fn constants(&self) -> [f64; 2] {
        match self {
            Self::HaffWerner(law) => [0.0, law.damping],
            Self::CundallStrack(law) => [law.stiffness, 0.0],
            Self::CundallStrackTruncated(law) => [law.stiffness, 0.0],
        }
    }
}

/// Laws of weak links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaws {
    /// Lever arms.
    pub distance: ContactDistance,
    /// Normal law.
    pub normal: ContactNormal,
    /// Tangential law; none without friction.
    pub tangential: Option<ContactTangential>,
}

impl ContactLaws {
    /// Whether a contact must remember its beginning.
    pub fn remembers(&self) -> bool {
        matches!(
            self.tangential,
            Some(
                ContactTangential::CundallStrack(_) | ContactTangential::CundallStrackTruncated(_)
            )
        )
    }
}

/// When strong links break.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielding {
    /// The criterion.
    pub law: ZhangEckert,
    /// Whether bonds of driven and fixed particles never break.
    pub unbreakable_edges: bool,
}

/// Laws of strong links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondLaws {
    /// Normal law.
    pub normal: AdjustedKelvinVoigt,
    /// Bending and shearing; none for a bar.
    pub tangential: Option<EulerBernoulli>,
    /// Breaking; none for unbreakable bonds.
    pub yielding: Option<Yielding>,
}

impl BondLaws {
    /// Whether bonds of driven and fixed particles never break, while others do.
    pub(crate) fn has_unbreakable_edges(&self) -> bool {
        self.yielding
            .is_some_and(|yielding| yielding.unbreakable_edges)
    }
}

/// Drag of the medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ambient {
    /// Creeping flow.
    Creeping(CreepingDrag),
    /// Correlation for all Reynolds numbers.
    Correlation(CorrelationDrag),
}

/// External potential.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum External {
    /// Gravity.
    Gravity(Gravity),
    /// Harmonic well.
    HarmonicWell(HarmonicWell),
}

/// Everything a scene chooses, except its particles. What is `None` is not there: no array, no pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// Form of the disputed equations.
    pub reading: Reading,
    /// Integration method.
    pub integrator: Integrator,
    /// Time step in s.
    pub time_step: f64,
    /// The box.
    pub domain: Domain,
    /// Weak links.
    pub contact: Option<ContactLaws>,
    /// Strong links.
    pub bond: Option<BondLaws>,
    /// Drag.
    pub ambient: Option<Ambient>,
    /// External potential.
    pub external: Option<External>,
    /// Driving force.
    pub driving: Option<Driving>,
    /// Whether dissipation and work are booked.
    pub ledger: bool,
}

impl Model {
    /// The periodic width in m, if x is periodic.
    pub fn period(&self) -> Option<f64> {
        self.domain.period()
    }
}
