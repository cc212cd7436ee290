//! The law of one bond: stretch, force, energy, breaking.

use crate::material::BondConstants;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Which stretches break a bond for good.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BreakingRule {
    /// $ s > s_0 $: only extension breaks bonds.
    #[default]
    TensionOnly,
    /// $ |s| > s_0 $, as section 3.1 of the source prints it: compression also breaks bonds (peridem P4).
    TwoSided,
}

/// Whether a bond still acts in the step in which it breaks, peridem Q6.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BreakOrder {
    /// Bonds are tested before forces are computed: a bond that breaks does not act in that step.
    #[default]
    BreakFirst,
    /// Forces are computed before bonds are tested: a bond that breaks acts once more.
    ForceFirst,
}

#[rendered]
impl BreakingRule {
    /// Whether a bond of stretch s breaks for a critical stretch $s_0$, both dimensionless.
    #[inline(always)]
    pub fn breaks(self, stretch: f64, critical_stretch: f64) -> bool {
        match self {
            Self::TensionOnly => stretch > critical_stretch,
            Self::TwoSided => stretch.abs() > critical_stretch,
        }
    }
}

/// A bond in the deformed grain.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BondState {
    /// Stretch s, dimensionless, positive in extension.
    pub stretch: f64,
    /// Unit vector e from the first to the second node; zero if both coincide.
    pub direction: Vec2,
    /// Reference length $|\xi|$ in m.
    pub length: f64,
}

#[rendered]
impl BondState {
    /// State of a bond $\xi = x' - x$ in m for the difference $\eta = u' - u$ of displacements in m, section 3 of peridem.
    ///
    /// $$ s = \frac{|\xi + \eta| - |\xi|}{|\xi|} = \frac{2 \xi \cdot \eta + \eta \cdot \eta}{|\xi| (|\xi + \eta| + |\xi|)} $$
    ///
    /// The right-hand side does not subtract nearly equal lengths, so that the stretch of a small displacement has a
    /// small relative error. $\xi$ must not be zero.
    #[inline(always)]
    pub fn new(bond: Vec2, displacement: Vec2) -> Self {
        let length = bond.norm();
        let current = bond + displacement;
        let current_length = current.norm();
        let squares = (bond * 2.0 + displacement).dot(displacement);
        let inverse = if current_length > 0.0 {
            1.0 / current_length
        } else {
            0.0
        };
        Self {
            stretch: squares / (length * (current_length + length)),
            direction: current * inverse,
            length,
        }
    }
}

#[rendered]
impl BondConstants {
    /// Force density of a pair, in N/m^5, on the first node; the second node has the opposite one.
    ///
    /// $$ f = c \, w(|\xi|) \, s \, e $$
    ///
    /// peridem (3.2). Times both areas it is a force per metre of depth. It attracts in extension. Bonds longer than the
    /// horizon do not exist, and are not tested for here.
    #[inline(always)]
    pub fn force_density(&self, bond: &BondState) -> Vec2 {
        bond.direction * (self.modulus(bond) * bond.stretch)
    }

    /// Energy of a bond in J per metre of depth, divided by both areas.
    ///
    /// $$ \frac{1}{2} c \, w(|\xi|) \, s^2 \, |\xi| $$
    ///
    /// Minus its gradient is [`BondConstants::force_density`].
    #[inline(always)]
    pub fn energy_density(&self, bond: &BondState) -> f64 {
        0.5 * self.modulus(bond) * bond.stretch * bond.stretch * bond.length
    }

    #[inline(always)]
    fn modulus(&self, bond: &BondState) -> f64 {
        self.stiffness * self.weight.at(bond.length, self.horizon)
    }
}
