//! Force laws: pure functions of numbers, with the stored energy beside each force.
//!
//! A law knows no index, no array and no world. Parameters are plain `f64` fields; the functions are generic over
//! [`Real`](gouge_common::scalar::Real). Signs are those of the thesis: the force of an interaction is that of j on i,
//! along the normal or tangent of the pair. A negative normal force is repulsive.

mod ambient;
mod driving;
mod external;
mod normal;
mod rebound;
mod tangential;
mod yielding;

pub use ambient::{
    AmbientLaw, CorrelationDrag, CreepingDrag, Drag, drag_coefficient, reynolds_number,
};
pub use driving::{Controller, Driven, Driving, characteristic_length};
pub use external::{ExternalLaw, Gravity, HarmonicWell};
pub use normal::{
    AdjustedKelvinVoigt, Bshp, KelvinVoigt, NormalLaw, dissipative_constant,
    dissipative_constant_printed, typical_overlap,
};
pub use rebound::{ReboundingBshp, ReboundingKelvinVoigt};
pub use tangential::{
    BeamLaw, CundallStrack, CundallStrackTruncated, EulerBernoulli, Friction, Frictionless,
    HaffWerner, NoBending, TangentialLaw, TangentialMotion,
};
pub use yielding::{
    Unbreakable, YieldLaw, ZhangEckert, ZhangEckertTensile, strength_factor_for, weakest_section,
};
