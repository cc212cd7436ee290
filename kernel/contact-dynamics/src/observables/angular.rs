//! Angular functions in bins.

use super::Contact;
use super::sums::ratio;
use core::f64::consts::TAU;
use gouge_equations::rendered;

/// Sums over the contacts whose normals lie in a range of angles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bin {
    /// Number of contacts.
    pub contacts: f64,
    /// Normal forces in N.
    pub normal_force: f64,
    /// Tangential forces in N.
    pub tangential_force: f64,
    /// Normal components of branch vectors in m.
    pub normal_branch: f64,
    /// Tangential components of branch vectors in m.
    pub tangential_branch: f64,
}

/// The angular functions of azema (7) in [`AngularSums::BINS`] bins of the direction of the normal, over one or more
/// steps.
///
/// Bin k holds angles from k times 10 degrees. A contact has no first and second body by itself, so it enters at
/// $\theta$ and at $\theta + \pi$, with the same components.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngularSums {
    bins: [Bin; Self::BINS],
}

impl Default for AngularSums {
    fn default() -> Self {
        Self {
            bins: [Bin::default(); Self::BINS],
        }
    }
}

#[rendered]
impl AngularSums {
    /// Number of bins.
    pub const BINS: usize = 36;

    /// Nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sums of known bins.
    pub(super) fn of_bins(bins: [Bin; Self::BINS]) -> Self {
        Self { bins }
    }

    /// Add contacts.
    pub fn add<'a>(&mut self, contacts: impl IntoIterator<Item = &'a Contact>) {
        for contact in contacts {
            let turns = libm::atan2(contact.normal.y, contact.normal.x) / TAU;
            let bin = (turns * Self::BINS as f64 + Self::BINS as f64) as usize % Self::BINS;
            for bin in [bin, (bin + Self::BINS / 2) % Self::BINS] {
                self.bins[bin].add(contact);
            }
        }
    }

    /// The sums per bin.
    pub fn bins(&self) -> &[Bin; Self::BINS] {
        &self.bins
    }

    /// Angle in the middle of a bin in rad.
    pub fn angle(bin: usize) -> f64 {
        (bin as f64 + 0.5) * TAU / Self::BINS as f64
    }

    /// Probability density $P(\theta)$ of normals per bin in 1/rad; its integral is one.
    pub fn density(&self) -> [f64; Self::BINS] {
        let all: f64 = self.bins.iter().map(|bin| bin.contacts).sum();
        let width = TAU / Self::BINS as f64;
        self.bins.map(|bin| ratio(bin.contacts, all * width))
    }
}

impl Bin {
    /// Names of the fields, in their order.
    pub const NAMES: [&str; 5] = [
        "contacts",
        "normal_force",
        "tangential_force",
        "normal_branch",
        "tangential_branch",
    ];

    fn add(&mut self, contact: &Contact) {
        self.contacts += 1.0;
        self.normal_force += contact.force.n;
        self.tangential_force += contact.force.t;
        self.normal_branch += contact.branch.n;
        self.tangential_branch += contact.branch.t;
    }

    /// The means over the contacts of the bin, in the order of the fields; zero without contacts.
    pub fn means(&self) -> [f64; 4] {
        let sums = [
            self.normal_force,
            self.tangential_force,
            self.normal_branch,
            self.tangential_branch,
        ];
        sums.map(|sum| ratio(sum, self.contacts))
    }
}
