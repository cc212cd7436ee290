//! Ledger of heat and work: sums over the history, thesis eqs. (74), (78)-(79).

use super::Energy;
use crate::forces::Bookings;
use gouge_common::scalar::Real;

/// The terms of the energy balance that depend on the history, in J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ledger<S> {
    pub(crate) initial: S,
    pub(crate) ambient: S,
    pub(crate) friction: S,
    pub(crate) breaking: S,
    pub(crate) bonding: S,
    pub(crate) driving: S,
    /// Work of the horizontal driving force.
    pub(crate) shearing: S,
    /// Integral of the load over the slip of the driven particles.
    pub(crate) sliding: S,
}

impl<S: Real> Ledger<S> {
    /// An empty ledger; the balance is measured from the given energy.
    pub(crate) fn starting_from(energy: &Energy<S>) -> Self {
        Self {
            initial: energy.mechanical(),
            ..Self::default()
        }
    }

    /// Add the heat and work that appeared instantaneously in an evaluation.
    pub(crate) fn book(&mut self, bookings: &Bookings<S>) {
        self.friction += bookings.friction;
        self.breaking += bookings.breaking;
        self.bonding += bookings.bonding;
    }

    /// Integrate heat and work rates over one step, by the trapezoidal rule.
    ///
    /// Methods that do not evaluate forces at the end of a step pass the rates at its beginning twice (erratum E53
    /// of the thesis).
    pub(crate) fn advance(&mut self, before: &Bookings<S>, after: &Bookings<S>, step: f64) {
        let work = |before: S, after: S| (before + after) * (0.5 * step);
        self.friction += work(before.friction_rate, after.friction_rate);
        self.ambient += work(before.ambient_rate, after.ambient_rate);
        self.driving += work(before.driving_rate, after.driving_rate);
        self.shearing += work(before.shearing_rate, after.shearing_rate);
        self.sliding += work(before.sliding_rate, after.sliding_rate);
    }

    /// All terms of the balance, from the terms of the state and the ledger.
    pub(crate) fn balance(&self, state: Energy<S>) -> Energy<S> {
        let left = state.mechanical() - self.initial + self.ambient + self.friction + self.breaking;
        Energy {
            ambient: self.ambient,
            friction: self.friction,
            breaking: self.breaking,
            bonding: self.bonding,
            driving: self.driving,
            residual: left - self.bonding - self.driving,
            ..state
        }
    }
}

impl Ledger<f64> {
    /// All entries, for a record.
    pub(crate) fn numbers(&self) -> [f64; 8] {
        [
            self.initial,
            self.ambient,
            self.friction,
            self.breaking,
            self.bonding,
            self.driving,
            self.shearing,
            self.sliding,
        ]
    }
    /// The ledger with the recorded entries.
    pub(crate) fn from_numbers(numbers: [f64; 8]) -> Self {
        let [
            initial,
            ambient,
            friction,
            breaking,
            bonding,
            driving,
            shearing,
            sliding,
        ] = numbers;
        Self {
            initial,
            ambient,
            friction,
            breaking,
            bonding,
            driving,
            shearing,
            sliding,
        }
    }
}
