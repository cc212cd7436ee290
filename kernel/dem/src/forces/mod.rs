//! The only place that writes forces: one pass per type of interaction, thesis eqs. (26)-(27).
//!
//! A pass is generic over its laws, which are chosen once per pass, outside its loop.

mod ambient;
mod block;
mod bond_forces;
mod bond_pass;
mod bookings;
mod contact_forces;
mod contact_pass;
mod cross_part;
mod driving;
mod ends;
mod external;
mod inspection;
mod pair_loop;
mod prefetch;
mod scatter;
mod sums;
mod rotations;
mod workspace;

pub use inspection::{Interaction, InteractionKind};
pub use sums::Forces;

pub(crate) use ambient::ambient;
pub(crate) use bond_forces::BondForces;
pub(crate) use bond_pass::BondPass;
pub(crate) use bookings::Bookings;
pub(crate) use contact_forces::ContactForces;
pub(crate) use contact_pass::ContactPass;
pub(crate) use driving::{driving, measure_driven};
pub(crate) use ends::{Bodies, reduced_mass};
pub(crate) use external::external;
pub(crate) use inspection::{bond_states, contact_states};
pub(crate) use pair_loop::PairLoop;
pub(crate) use workspace::PartWorkspace;
