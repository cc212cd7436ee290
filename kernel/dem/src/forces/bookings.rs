//! Heat and work of an evaluation.

/// Heat and work that an evaluation contributes to the energy balance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bookings<S> {
    /// Continuous heat production of contacts and bonds, in W.
    pub friction_rate: S,
    /// Heat of contacts and bonds released instantaneously, in J.
    pub friction: S,
    /// Heat production by the drag of the medium, in W.
    pub ambient_rate: S,
    /// Power of the driving force, in W.
    pub driving_rate: S,
    /// Power of its horizontal component, in W.
    pub shearing_rate: S,
    /// Load, minus its vertical component, times the mean horizontal velocity of the driven particles, in W.
    pub sliding_rate: S,
    /// Stored energy lost with bonds that broke, in J.
    pub breaking: S,
    /// Stored energy of contacts that replace broken bonds, in J.
    pub bonding: S,
}

impl Bookings<f64> {
    /// All entries, for a record.
    pub(crate) fn numbers(&self) -> [f64; 8] {
        [
            self.friction_rate,
            self.friction,
            self.ambient_rate,
            self.driving_rate,
            self.shearing_rate,
            self.sliding_rate,
            self.breaking,
            self.bonding,
        ]
    }
    /// The bookings with the recorded entries.
    pub(crate) fn from_numbers(numbers: [f64; 8]) -> Self {
        let [
            friction_rate,
            friction,
            ambient_rate,
            driving_rate,
            shearing_rate,
            sliding_rate,
            breaking,
            bonding,
        ] = numbers;
        Self {
            friction_rate,
            friction,
            ambient_rate,
            driving_rate,
            shearing_rate,
            sliding_rate,
            breaking,
            bonding,
        }
    }
}
