//! Readings of the source, by name.

use crate::bond_law::{BreakOrder, BreakingRule};
use crate::contact_law::ContactReading;
use crate::wall_law::WallReading;
use crate::world::Beginning;

/// A reading of the source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Corrected; momentum is conserved.
    #[default]
    Corrected,
    /// As printed.
    Paper,
    /// What the program of the authors does.
    Authors,
    /// The same with two repairs: the centroid of the wall and friction that sticks.
    TwoFixes,
}

impl Mode {
    /// All modes with their names.
    pub const ALL: [(&'static str, Self); 4] = [
        ("corrected", Self::Corrected),
        ("paper", Self::Paper),
        ("authors", Self::Authors),
        ("two_fixes", Self::TwoFixes),
    ];

    /// Name of the mode.
    pub fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, mode)| *mode == self);
        found.map_or("", |(name, _)| name)
    }

    /// Whether it repeats the program of the authors, with its repairs or without.
    pub fn is_of_authors(self) -> bool {
        matches!(self, Self::Authors | Self::TwoFixes)
    }

    /// Which bonds break.
    pub fn breaking(self) -> BreakingRule {
        match self {
            Self::Paper => BreakingRule::TwoSided,
            _ => BreakingRule::TensionOnly,
        }
    }

    /// Whether bonds act in the step in which they break.
    pub fn break_order(self) -> BreakOrder {
        match self.is_of_authors() {
            true => BreakOrder::ForceFirst,
            false => BreakOrder::BreakFirst,
        }
    }

    /// The mass in damping and friction between nodes.
    pub fn contact(self) -> ContactReading {
        match self {
            Self::Corrected => ContactReading::Symmetric,
            Self::Paper => ContactReading::Printed,
            Self::TwoFixes => ContactReading::OneSided,
            Self::Authors => ContactReading::Authors,
        }
    }

    /// The force of walls.
    pub fn walls(self) -> WallReading {
        match self {
            Self::Corrected | Self::Paper => WallReading::Paper,
            Self::TwoFixes => WallReading::TwoFixes,
            Self::Authors => WallReading::Authors,
        }
    }

    /// Where the first accelerations come from.
    pub fn beginning(self) -> Beginning {
        match self.is_of_authors() {
            true => Beginning::Given,
            false => Beginning::Forces,
        }
    }
}
