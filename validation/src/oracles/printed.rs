//! The printed estimators of the energy balance, thesis eqs. (76), (78) and (79), taken literally.

/// The quantities of a contact or bond that the estimators use.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// First and second particle, in the order of the list.
    pub pair: [usize; 2],
    /// Normal force in N.
    pub normal_force: f64,
    /// Rate of the normal displacement in m/s.
    pub normal_rate: f64,
    /// Tangential force in N.
    pub tangential_force: f64,
    /// Rates of the tangential displacements of both ends in m/s.
    pub tangential_rates: [f64; 2],
    /// Torques on both ends in N m.
    pub torques: [f64; 2],
    /// Rates of the angles of both ends in the frame of the pair, in rad/s.
    pub turning: [f64; 2],
}

impl Link {
    /// Power of the forces of a contact or bond as printed in (78), in W: with the displacement of the
    /// first end only.
    pub fn printed_power(&self) -> f64 {
        self.normal_force * self.normal_rate + self.tangential_force * self.tangential_rates[0]
    }
    /// Power that closes the balance, in W: torques of both ends times their angular rates.
    pub fn power(&self) -> f64 {
        let turned = self.torques[0] * self.turning[0] + self.torques[1] * self.turning[1];
        self.normal_force * self.normal_rate + turned
    }
}

/// Powers of one contact or bond, summed over time by the trapezoidal rule.
#[derive(Clone, Copy, Debug)]
struct Account {
    pair: [usize; 2],
    seen: u64,
    latest: [f64; 2],
    work: [f64; 2],
}

/// Work of contacts and bonds and of the driving force along a run.
#[derive(Clone, Debug, Default)]
pub struct Printed {
    accounts: Vec<Account>,
    looks: u64,
    driven: Vec<f64>,
    latest: Vec<f64>,
}

impl Printed {
    /// Adds the state after a step: its contacts and bonds, in the order of their pairs, and the powers
    /// of the driving force on the driven particles, in W.
    pub fn look(&mut self, links: impl Iterator<Item = Link>, driving: Vec<f64>, step: f64) {
        self.looks += 1;
        for link in links {
            let now = [link.printed_power(), link.power()];
            match self
                .accounts
                .binary_search_by_key(&link.pair, |one| one.pair)
            {
                Ok(at) => self.accounts[at].add(now, self.looks, step),
                Err(at) => self.accounts.insert(
                    at,
                    Account {
                        pair: link.pair,
                        seen: self.looks,
                        latest: now,
                        work: [0.0; 2],
                    },
                ),
            }
        }
        self.driven.resize(driving.len(), 0.0);
        self.latest.resize(driving.len(), 0.0);
        for (n, power) in driving.iter().enumerate() {
            if self.looks > 1 {
                self.driven[n] += 0.5 * step * (self.latest[n] + power);
            }
        }
        self.latest = driving;
    }

    /// Stored energy and heat of contacts and bonds together as in (78), in J: absolute values of the
    /// work, with the displacement of the first end only.
    pub fn links_as_printed(&self) -> f64 {
        self.accounts.iter().map(|one| one.work[0].abs()).sum()
    }
    /// The same, signed and with both ends: minus the work of contacts and bonds.
    pub fn links(&self) -> f64 {
        -self.accounts.iter().map(|one| one.work[1]).sum::<f64>()
    }
    /// Work of driving as in (79), in J: absolute values of the work on single particles.
    pub fn driving_as_printed(&self) -> f64 {
        self.driven.iter().map(|work| work.abs()).sum()
    }
    /// The same, signed.
    pub fn driving(&self) -> f64 {
        self.driven.iter().sum()
    }
}

impl Account {
    /// Adds the powers of a step, unless the contact was absent in between.
    fn add(&mut self, now: [f64; 2], look: u64, step: f64) {
        if self.seen + 1 == look {
            let powers = self.latest.iter().zip(&now);
            for (work, (before, after)) in self.work.iter_mut().zip(powers) {
                *work += 0.5 * step * (before + after);
            }
        }
        (self.seen, self.latest) = (look, now);
    }
}
