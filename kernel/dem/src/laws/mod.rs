//! Force laws: pure values, numbers in, numbers out.
//!
//! A law knows no index, no array and no world. Parameters are plain `f64` fields; the functions serve
//! every [`Real`](gouge_common::scalar::Real). Signs are those of the thesis: a link force acts on i along the
//! normal (or tangent) from i to j, so that a negative normal force repels.

mod ambient;
mod driving;
mod external;
mod normal;
mod tangential;
mod yielding;

pub use ambient::{
    AmbientLaw, CorrelationDrag, CreepingDrag, Drag, drag_coefficient, reynolds_number,
};
pub use driving::{Controller, Driven, Driving, characteristic_length};
pub use external::{ExternalLaw, Gravity, HarmonicWell};
pub use normal::{
    AdjustedKelvinVoigt, Bshp, KelvinVoigt, NormalLaw, dissipative_constant,
    dissipative_constant_printed,
};
pub use tangential::{
    BeamLaw, CundallStrack, CundallStrackTruncated, EulerBernoulli, Friction, Frictionless,
    HaffWerner, NoBending, Slide, TangentialLaw,
};
pub use yielding::{Unbreakable, YieldLaw, ZhangEckert, weakest_section};
