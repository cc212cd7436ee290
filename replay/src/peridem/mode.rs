//! Readings of the source, by name.

use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::contact_law::ContactReading;
use gouge_peridem::wall_law::WallReading;
use gouge_peridem::world::Beginning;

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

    pub(super) fn breaking(self) -> BreakingRule {
        match self {
            Self::Paper => BreakingRule::TwoSided,
            _ => BreakingRule::TensionOnly,
        }
    }

    pub(super) fn break_order(self) -> BreakOrder {
        match self.is_of_authors() {
            true => BreakOrder::ForceFirst,
            false => BreakOrder::BreakFirst,
        }
    }

    pub(super) fn contact(self) -> ContactReading {
        match self {
            Self::Corrected => ContactReading::Symmetric,
            Self::Paper => ContactReading::Printed,
            Self::TwoFixes => ContactReading::OneSided,
            Self::Authors => ContactReading::Authors,
        }
    }

    pub(super) fn walls(self) -> WallReading {
        match self {
            Self::Corrected | Self::Paper => WallReading::Paper,
            Self::TwoFixes => WallReading::TwoFixes,
            Self::Authors => WallReading::Authors,
        }
    }

    pub(super) fn beginning(self) -> Beginning {
        match self.is_of_authors() {
            true => Beginning::Given,
            false => Beginning::Forces,
        }
    }
}
