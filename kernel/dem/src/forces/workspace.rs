//! Buffers of a part, which can be thrown away.

use super::block::Block;
use super::bookings::Bookings;
use super::cross_part::CrossPartForces;
use gouge_common::lanes::Lanes;

/// What a part needs to compute its contacts and bonds.
#[derive(Clone, Debug, Default)]
pub(crate) struct PartWorkspace<S: Lanes> {
    /// The pairs that are computed together.
    pub block: Block<S>,
    /// What the part books; without a ledger nothing.
    pub bookings: Bookings<S>,
    /// Positions of the bonds that broke.
    pub broken: Vec<u32>,
    /// Forces of bonds on particles of earlier parts.
    pub bonds: CrossPartForces<S>,
    /// Forces of contacts on particles of earlier parts.
    pub contacts: CrossPartForces<S>,
}
