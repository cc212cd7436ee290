//! The only place that matches the choices of a model: once per pass, never inside a loop.
//!
//! Each function calls an operation with the types that the model selects. The operation is compiled for each of
//! them.

use super::choice::{NormalChoice, WithNormalLaw};
use super::simulation::Number;
use crate::forces::{BondPass, ContactPass};
use crate::geometry::{Arm, ContactDistance, FocalArm, MeanArm, RadiusArm};
use crate::integrators::{
    BeemanBegin, BeemanCorrect, BeemanPredict, Euler, HalfKick, HalfKickAndDrift, Integrator,
    Stage, SymplecticEuler, Taylor, VerletCorrect, VerletPredict,
};
use crate::laws::{
    AmbientLaw, BeamLaw, ExternalLaw, Frictionless, NoBending, NormalLaw, TangentialLaw,
    Unbreakable, YieldLaw, ZhangEckertTensile,
};
use crate::model::{
    Ambient, BondLaws, ContactLaws, ContactTangential, External, Model, Reading, Yielding,
};
use gouge_common::geometry::{Domain, Metric, WithMetric};

/// An operation on contacts.
pub(super) trait WithContactPass {
    type Output;
    fn call<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
        self,
        pass: ContactPass<M, A, N, T>,
    ) -> Self::Output;
}

/// An operation on bonds.
pub(super) trait WithBondPass {
    type Output;
    fn call<M: Metric, B: BeamLaw, Y: YieldLaw>(self, pass: BondPass<M, B, Y>) -> Self::Output;
}

/// An operation with the drag law.
pub(super) trait WithAmbientLaw {
    fn call<L: AmbientLaw>(self, law: L);
}

/// An operation with the law of the external potential.
pub(super) trait WithExternalLaw {
    type Output;
    fn call<L: ExternalLaw>(self, law: L) -> Self::Output;
}

/// An operation with the stages of an integration method.
pub(super) trait WithMethod: Sized {
    type Output;
    /// A method with one stage, after an evaluation.
    fn one_stage<T: Stage>(self) -> Self::Output;
    /// A method with two stages and an evaluation between them.
    fn two_stages<T: Stage, U: Stage>(self) -> Self::Output;
    /// As [`two_stages`](Self::two_stages), with a stage `B` before the first step.
    fn two_stages_with_start<B: Stage, T: Stage, U: Stage>(self) -> Self::Output;
}

/// Call an operation with the laws of contacts; `elapsed` is the time since the previous evaluation in s.
pub(super) fn with_contact_pass<S: Number, N: NormalChoice<S>, V: WithContactPass>(
    model: &Model<N>,
    laws: ContactLaws<N>,
    elapsed: f64,
    action: V,
) -> V::Output {
    laws.normal.with_law(ChooseMetric {
        domain: model.domain,
        others: ChooseContactLaws {
            distance: laws.distance,
            tangential: laws.tangential,
            reading: model.reading,
            elapsed,
            action,
        },
    })
}

/// Takes the normal law, and chooses the metric.
struct ChooseMetric<V> {
    domain: Domain,
    others: ChooseContactLaws<V>,
}

impl<V: WithContactPass> WithNormalLaw for ChooseMetric<V> {
    type Output = V::Output;
    fn call<N: NormalLaw>(self, normal: N) -> V::Output {
        let others = self.others;
        self.domain.with_metric(ChooseTangential { normal, others })
    }
}

/// Takes the metric, and chooses the tangential law.
struct ChooseTangential<N, V> {
    normal: N,
    others: ChooseContactLaws<V>,
}

impl<N: NormalLaw, V: WithContactPass> WithMetric for ChooseTangential<N, V> {
    type Output = V::Output;
    fn call<M: Metric>(self, metric: M) -> V::Output {
        let Self { normal, others } = self;
        match others.tangential {
            None => others.call(metric, RadiusArm, normal, Frictionless),
            Some(ContactTangential::HaffWerner(law)) => others.choose_arm(metric, normal, law),
            Some(ContactTangential::CundallStrack(law)) => others.choose_arm(metric, normal, law),
            Some(ContactTangential::CundallStrackTruncated(law)) => {
                others.choose_arm(metric, normal, law)
            }
        }
    }
}

struct ChooseContactLaws<V> {
    distance: ContactDistance,
    tangential: Option<ContactTangential>,
    reading: Reading,
    elapsed: f64,
    action: V,
}

impl<V: WithContactPass> ChooseContactLaws<V> {
    fn choose_arm<M: Metric, N: NormalLaw, T: TangentialLaw>(
        self,
        metric: M,
        normal: N,
        tangential: T,
    ) -> V::Output {
        match self.distance {
            ContactDistance::Radius => self.call(metric, RadiusArm, normal, tangential),
            ContactDistance::Focal => self.call(metric, FocalArm, normal, tangential),
            ContactDistance::Mean => self.call(metric, MeanArm, normal, tangential),
            ContactDistance::Mixed(arms) => self.call(metric, arms, normal, tangential),
        }
    }

    fn call<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
        self,
        metric: M,
        arm: A,
        normal: N,
        tangential: T,
    ) -> V::Output {
        self.action.call(ContactPass {
            metric,
            arm,
            normal,
            tangential,
            reading: self.reading,
            elapsed: self.elapsed,
        })
    }
}

/// Call an operation with the laws of bonds.
pub(super) fn with_bond_pass<N, V: WithBondPass>(
    model: &Model<N>,
    laws: BondLaws,
    action: V,
) -> V::Output {
    let wraps_angles = model.reading == Reading::Thesis;
    model.domain.with_metric(ChooseBondLaws {
        laws,
        wraps_angles,
        action,
    })
}

struct ChooseBondLaws<V> {
    laws: BondLaws,
    wraps_angles: bool,
    action: V,
}

impl<V: WithBondPass> WithMetric for ChooseBondLaws<V> {
    type Output = V::Output;
    fn call<M: Metric>(self, metric: M) -> V::Output {
        match self.laws.yielding {
            Some(Yielding {
                law: otherwise,
                tensile_strength: Some(tensile_strength),
                ..
            }) => self.choose_beam(
                metric,
                ZhangEckertTensile {
                    otherwise,
                    tensile_strength,
                },
            ),
            Some(Yielding { law, .. }) => self.choose_beam(metric, law),
            None => self.choose_beam(metric, Unbreakable),
        }
    }
}

impl<V: WithBondPass> ChooseBondLaws<V> {
    fn choose_beam<M: Metric, Y: YieldLaw>(self, metric: M, yielding: Y) -> V::Output {
        match self.laws.tangential {
            Some(beam) => self.call(metric, beam, yielding),
            None => self.call(metric, NoBending, yielding),
        }
    }

    fn call<M: Metric, B: BeamLaw, Y: YieldLaw>(
        self,
        metric: M,
        beam: B,
        yielding: Y,
    ) -> V::Output {
        self.action.call(BondPass {
            metric,
            normal: self.laws.normal,
            beam,
            yielding,
            wraps_angles: self.wraps_angles,
        })
    }
}

/// Call an operation with the drag law.
pub(super) fn with_ambient_law<V: WithAmbientLaw>(ambient: Ambient, action: V) {
    match ambient {
        Ambient::Creeping(law) => action.call(law),
        Ambient::Correlation(law) => action.call(law),
    }
}

/// Call an operation with the law of the external potential.
pub(super) fn with_external_law<V: WithExternalLaw>(external: External, action: V) -> V::Output {
    match external {
        External::Gravity(law) => action.call(law),
        External::HarmonicWell(law) => action.call(law),
    }
}

/// Call an operation with the stages of an integration method.
pub(super) fn with_method<V: WithMethod>(integrator: Integrator, action: V) -> V::Output {
    match integrator {
        Integrator::Euler => action.one_stage::<Euler>(),
        Integrator::SymplecticEuler => action.one_stage::<SymplecticEuler>(),
        Integrator::Taylor => action.one_stage::<Taylor>(),
        Integrator::VelocityVerlet => action.two_stages::<VerletPredict, VerletCorrect>(),
        Integrator::VelocityVerletHalfStep => action.two_stages::<HalfKickAndDrift, HalfKick>(),
        Integrator::Beeman => {
            action.two_stages_with_start::<BeemanBegin, BeemanPredict, BeemanCorrect>()
        }
    }
}
