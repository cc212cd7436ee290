//! The model of a scene: the chosen laws and their parameters, as plain data.

use crate::geometry::ContactDistance;
use crate::integrators::Integrator;
use crate::laws::{
    AdjustedKelvinVoigt, Bshp, CorrelationDrag, CreepingDrag, CundallStrack,
    CundallStrackTruncated, Driving, EulerBernoulli, Gravity, HaffWerner, HarmonicWell,
    KelvinVoigt, NormalLaw, ReboundingBshp, ReboundingKelvinVoigt, ZhangEckert,
};
use crate::particles::{COMPUTED_INERTIA_FACTOR, SPHERE_INERTIA_FACTOR};
use gouge_common::geometry::Domain;

/// Which form of the equations is used, where `docs/thesis/errata.md` corrects forces or motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// The corrected form.
    Corrected,
    /// The form that the thesis prints, or that its author's program computes.
    Thesis,
}

impl Reading {
    /// Moment of inertia in units of mass times radius squared, where a scene gives none: 2/5, the
    /// sphere's, or 3/5, which the thesis's author computed with (thesis E64).
    pub fn inertia_factor(self) -> f64 {
        match self {
            Self::Corrected => SPHERE_INERTIA_FACTOR,
            Self::Thesis => COMPUTED_INERTIA_FACTOR,
        }
    }
}

/// Normal law of contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactNormal {
    /// Truncated Kelvin-Voigt.
    KelvinVoigt(KelvinVoigt),
    /// BSHP: viscoelastic spheres.
    Bshp(Bshp),
    /// Truncated Kelvin-Voigt with the same restitution for every pair.
    ReboundingKelvinVoigt(ReboundingKelvinVoigt),
    /// BSHP with the same restitution for every pair.
    ReboundingBshp(ReboundingBshp),
}

/// Tangential law of contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactTangential {
    /// Haff-Werner.
    HaffWerner(HaffWerner),
    /// Cundall-Strack as printed in the thesis.
    CundallStrack(CundallStrack),
    /// Cundall-Strack with the spring truncated at the Coulomb limit.
    CundallStrackTruncated(CundallStrackTruncated),
}

impl ContactNormal {
    /// Stiffness in kg/s^2 and damping in kg/s, see [`NormalLaw::linearised`].
    pub fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        match self {
            Self::KelvinVoigt(law) => law.linearised(radii, reduced_mass),
            Self::Bshp(law) => law.linearised(radii, reduced_mass),
            Self::ReboundingKelvinVoigt(law) => law.linearised(radii, reduced_mass),
            Self::ReboundingBshp(law) => law.linearised(radii, reduced_mass),
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

/// Laws of contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaws<N = ContactNormal> {
    /// Choice of the lever arms.
    pub distance: ContactDistance,
    /// Normal law.
    pub normal: N,
    /// Tangential law; `None` for frictionless contacts.
    pub tangential: Option<ContactTangential>,
}

impl<N> ContactLaws<N> {
    /// Whether contacts have memory.
    pub fn remembers(&self) -> bool {
        matches!(
            self.tangential,
            Some(
                ContactTangential::CundallStrack(_) | ContactTangential::CundallStrackTruncated(_)
            )
        )
    }
}

/// When bonds break.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielding {
    /// The yield criterion.
    pub law: ZhangEckert,
    /// Ultimate tensile strength in Pa; `None` if it is the normal strength.
    pub tensile_strength: Option<f64>,
    /// Whether bonds with a driven or fixed particle never break.
    pub unbreakable_edges: bool,
}

impl Yielding {
    /// Stress in Pa at which a bond that is only pulled breaks.
    pub fn tensile_strength(&self) -> f64 {
        self.tensile_strength.unwrap_or(self.law.normal_strength)
    }
}

/// Laws of bonds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondLaws {
    /// Normal law.
    pub normal: AdjustedKelvinVoigt,
    /// Bending and shearing law; `None` for bonds with a normal force only.
    pub tangential: Option<EulerBernoulli>,
    /// Yielding; `None` for unbreakable bonds.
    pub yielding: Option<Yielding>,
}

impl BondLaws {
    /// Whether bonds with a driven or fixed particle never break, while others may.
    pub(crate) fn has_unbreakable_edges(&self) -> bool {
        self.yielding
            .is_some_and(|yielding| yielding.unbreakable_edges)
    }
}

/// Drag law of the surrounding medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ambient {
    /// Drag in creeping flow.
    Creeping(CreepingDrag),
    /// Drag correlation for all subcritical Reynolds numbers.
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

/// All choices of a scene, except its particles. Whatever is `None` costs nothing: no array, no pass.
///
/// `N` is the choice of a normal law, or a [`NormalLaw`] of your own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model<N = ContactNormal> {
    /// Which form of the equations is used.
    pub reading: Reading,
    /// Integration method.
    pub integrator: Integrator,
    /// Time step in s.
    pub time_step: f64,
    /// The box.
    pub domain: Domain,
    /// Laws of contacts.
    pub contact: Option<ContactLaws<N>>,
    /// Laws of bonds.
    pub bond: Option<BondLaws>,
    /// Drag of the surrounding medium.
    pub ambient: Option<Ambient>,
    /// External potential.
    pub external: Option<External>,
    /// Driving force.
    pub driving: Option<Driving>,
    /// Whether heat and work are recorded for the energy balance.
    pub ledger: bool,
}

impl<N> Model<N> {
    /// A model in an open box, with the corrected equations and without contacts, bonds, fields, driving and ledger.
    /// The time step is in s.
    pub fn new(integrator: Integrator, time_step: f64) -> Self {
        Self {
            reading: Reading::Corrected,
            integrator,
            time_step,
            domain: Domain {
                width: None,
                height: None,
                periodic: false,
            },
            contact: None,
            bond: None,
            ambient: None,
            external: None,
            driving: None,
            ledger: false,
        }
    }

    /// Period in x in m, if x is periodic.
    pub fn period(&self) -> Option<f64> {
        self.domain.period()
    }
}
