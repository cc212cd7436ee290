//! A discrete element model of shearing brittle surfaces: the kernel, and what is built around it.
//!
//! Where to find an equation:
//!
//! | what | module | thesis |
//! |---|---|---|
//! | overlap, focal point, lever arms, tangential displacement | [`geometry`] | (3)-(5), (28)-(34), (63)-(64), appendix |
//! | sums of forces and torques on a particle | [`forces`] | (6)-(7), (26)-(27), (32)-(33) |
//! | laws of contacts, bonds, drag, potentials and driving, yielding | [`laws`] | (8)-(25), (35)-(48) |
//! | masses and elastic constants | [`particles`], [`material`] | (39), (52), (59)-(60) |
//! | integration methods and stable time steps | [`integrators`] | (55)-(62) |
//! | packing, bonding and cutting the blocks | [`setup`] | (66), (70), (131) |
//! | distributions of strength | [`distributions`] | (65), (102)-(130) |
//! | energy balance | [`balance`] | (72)-(79) |
//! | friction and fragments | [`estimators`] | (68)-(69), (80)-(86) |
//! | calibration | [`calibration`] | (87)-(100) |
//! | neighbour search | [`common::neighbors`](../gouge_common/neighbors/index.html) | (98)-(99), (134)-(137) |
//!
//! A [`World`] is a [`model`] (laws and parameters) with a state; [`World::step`] advances it by a time step.
//! The front page of [`gouge_dem`] has a complete program.
//! `docs/thesis/equations.md` lists every equation with its function and its test.
//! Scene files become worlds, and runs write outputs, in [`runner`](../gouge_runner/index.html).

#[doc(inline)]
pub use gouge_dem::*;

pub use gouge_replay as replay;
pub use gouge_runner as runner;
pub use gouge_studies as studies;

mod command_line;
pub use command_line::{account, command_line};
