//! The kernels whose faults can be switched on.

use crate::workspace::COMMON;
use clap::ValueEnum;

/// A kernel with its gate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kernel {
    /// The thesis's model, with what all kernels share.
    Dem,
    /// Contact dynamics.
    ContactDynamics,
    /// Peridynamic grains.
    Peridem,
}

impl Kernel {
    /// Folders of its sources.
    pub fn folders(self) -> &'static [&'static str] {
        match self {
            Self::Dem => &[COMMON, "kernel/dem/src"],
            Self::ContactDynamics => &["kernel/contact-dynamics/src"],
            Self::Peridem => &["kernel/peridem/src"],
        }
    }

    /// Folders outside the kernel whose types and constants it uses.
    pub fn foundations(self) -> &'static [&'static str] {
        match self {
            Self::Dem => &[],
            Self::ContactDynamics | Self::Peridem => &[COMMON],
        }
    }

    /// Whether reads of optional numbers are sites.
    pub fn counts_optional(self) -> bool {
        self != Self::Dem
    }

    /// The packages in which its sources are.
    pub fn packages(self) -> &'static [&'static str] {
        match self {
            Self::Dem => &["gouge-common", "gouge-dem"],
            Self::ContactDynamics => &["gouge-contact-dynamics"],
            Self::Peridem => &["gouge-peridem"],
        }
    }

    /// Folders outside the kernel in which uses of its constants are sites.
    pub fn users(self) -> &'static [&'static str] {
        match self {
            Self::Dem => &["runner/src", "validation/src"],
            Self::ContactDynamics | Self::Peridem => &[],
        }
    }

    /// The package and the name of its test program, and the folder in which that runs.
    pub fn gate(self) -> [&'static str; 3] {
        match self {
            Self::Dem => ["gouge", "gate", "cli"],
            Self::ContactDynamics => [
                "gouge-contact-dynamics",
                "contact_dynamics",
                "kernel/contact-dynamics",
            ],
            Self::Peridem => ["gouge-peridem", "peridem", "kernel/peridem"],
        }
    }

    /// Name of the folder for copy and results of a kind of faults.
    pub fn folder(self, kind: &str) -> String {
        match self {
            Self::Dem => format!("gouge-{kind}"),
            Self::ContactDynamics => format!("gouge-{kind}-contact-dynamics"),
            Self::Peridem => format!("gouge-{kind}-peridem"),
        }
    }
}
