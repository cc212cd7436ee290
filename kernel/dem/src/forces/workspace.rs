//! Buffers of a part. They hold no state between evaluations.

use super::block::Block;
use super::bookings::Bookings;
use super::cross_part::CrossPartForces;
use gouge_common::lanes::Lanes;

/// Buffers that a part needs to compute its contacts and bonds.
#[derive(Clone, Debug, Default)]
pub(crate) struct PartWorkspace<S: Lanes> {
    /// The block of pairs that is computed.
    pub block: Block<S>,
    /// Heat and work of the part; unused without a ledger.
    pub bookings: Bookings<S>,
    /// Indices of the bonds that broke.
    pub broken: Vec<u32>,
    /// Forces of bonds on particles of earlier parts.
    pub bonds: CrossPartForces<S>,
    /// Forces of contacts on particles of earlier parts.
    pub contacts: CrossPartForces<S>,
}
