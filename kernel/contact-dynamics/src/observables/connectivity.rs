//! How many contacts bodies have.

use super::sums::ratio;
use core::ops::AddAssign;
use gouge_equations::rendered;

/// Largest number of contacts that is counted separately.
pub const MOST_CONTACTS: usize = 8;

/// Numbers of bodies by their numbers of force-bearing contacts, over one or more steps.
///
/// A body with fewer than two contacts floats. All ratios are dimensionless.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Connectivity {
    /// Number of bodies.
    pub bodies: f64,
    /// Number of bodies with at least two contacts.
    pub connected: f64,
    /// Number of contacts of these bodies.
    pub contacts: f64,
    /// Number of these bodies with a given number of contacts; more than [`MOST_CONTACTS`] are not listed.
    pub by_contacts: [f64; MOST_CONTACTS + 1],
}

impl AddAssign for Connectivity {
    fn add_assign(&mut self, other: Self) {
        self.bodies += other.bodies;
        self.connected += other.connected;
        self.contacts += other.contacts;
        let counts = self.by_contacts.iter_mut().zip(other.by_contacts);
        counts.for_each(|(sum, count)| *sum += count);
    }
}

#[rendered]
impl Connectivity {
    /// Nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Add a step: numbers of contacts per body, and which bodies are free. Only free bodies are counted, but their
    /// contacts with others count.
    pub fn add(&mut self, counts: &[u32], is_free: impl Fn(usize) -> bool) {
        let free = counts.iter().enumerate().filter(|(body, _)| is_free(*body));
        for (_, &count) in free {
            self.bodies += 1.0;
            if count < 2 {
                continue;
            }
            self.connected += 1.0;
            self.contacts += f64::from(count);
            if let Some(number) = self.by_contacts.get_mut(count as usize) {
                *number += 1.0;
            }
        }
    }

    /// The share of bodies that do not float, $\kappa$.
    pub fn connected_share(&self) -> f64 {
        ratio(self.connected, self.bodies)
    }

    /// The mean number of contacts of bodies that do not float, z.
    pub fn coordination(&self) -> f64 {
        ratio(self.contacts, self.connected)
    }

    /// The share of bodies with the given number of contacts among those that do not float, $P_c$.
    ///
    /// Zero for fewer than two contacts and for more than [`MOST_CONTACTS`].
    pub fn share_with(&self, contacts: usize) -> f64 {
        let number = self.by_contacts.get(contacts).copied();
        ratio(number.unwrap_or_default(), self.connected)
    }
}
