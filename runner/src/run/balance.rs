//! Watches the energy balance of a run.

use gouge_dem::estimators::Energy;

/// Largest residual that is trusted, in units of the largest term of the balance.
const TRUSTED: f64 = 0.02;
/// Residual that rounding may cause, in units of the largest energy.
const ROUNDING: f64 = 1e-9;

/// What the samples so far say about the balance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// Potential energy at t = 0 in J.
    external: f64,
    /// The largest term so far in J; the potential energy counts by its change.
    pub largest: f64,
    /// The largest absolute energy so far in J.
    magnitude: f64,
    /// Whether any sample was beyond trust.
    pub is_off: bool,
}

impl Balance {
    /// The watch with which a run begins.
    pub fn new(beginning: &Energy) -> Self {
        Self {
            external: beginning.external,
            ..Self::default()
        }
    }

    /// Look at a sample; whether this is the first one beyond trust.
    pub fn watch(&mut self, energy: &Energy) -> bool {
        let terms = [
            energy.kinetic,
            energy.contact,
            energy.external - self.external,
            energy.ambient,
            energy.friction,
            energy.breaking,
            energy.bonding,
            energy.driving,
        ];
        self.largest = terms
            .iter()
            .fold(self.largest, |all, term| all.max(term.abs()));
        self.magnitude = self.magnitude.max(self.largest).max(energy.external.abs());
        let residual = energy.residual.abs();
        let is_off = residual > TRUSTED * self.largest && residual > ROUNDING * self.magnitude;
        let is_first = is_off && !self.is_off;
        self.is_off |= is_off;
        is_first
    }

    /// The watch as numbers, for a checkpoint.
    pub fn words(&self) -> [u64; 4] {
        [
            self.external.to_bits(),
            self.largest.to_bits(),
            self.magnitude.to_bits(),
            u64::from(self.is_off),
        ]
    }

    /// The watch that [`Balance::words`] stored.
    pub fn of_words([external, largest, magnitude, is_off]: [u64; 4]) -> Self {
        Self {
            external: f64::from_bits(external),
            largest: f64::from_bits(largest),
            magnitude: f64::from_bits(magnitude),
            is_off: is_off != 0,
        }
    }
}
