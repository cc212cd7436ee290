//! The law of a bond.

use crate::material::{BondConstants, Weight};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Which stretches break a bond for good.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BreakingRule {
    /// $ s > s_0 $: only extension breaks bonds.
    #[default]
    TensionOnly,
    /// $ |s| > s_0 $, as section 3.1 of peridem prints it: compression also breaks bonds (peridem P4).
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

/// A distance in m below which the force of a bond fades, so that it has a limit where the direction has none. Its product
/// with the square of any length of a bond does not underflow.
const TINIEST: f64 = 1e-150;

/// How a bond is stretched.
#[rendered]
#[derive(Clone, Copy, Debug)]
pub struct Elongation {
    /// $ \vec\xi + \vec\eta $ in m, from the earlier to the later node
    pub branch: Vec2,
    /// Its length d in m.
    pub distance: f64,
    /// Reference length r in m.
    pub length: f64,
    /// $ d^2 - r^2 $ in m^2
    pub excess: f64,
    /// $ r (d + r) $ in m^2
    pub scale: f64,
}

#[rendered]
impl Elongation {
    /// Elongation of a bond from its reference vector $\vec\xi$, the difference of displacements $\vec\eta$ and its
    /// reference length r, all in m.
    ///
    /// $$ d^2 - r^2 = 2 \vec\xi \cdot \vec\eta + \vec\eta \cdot \vec\eta $$
    ///
    /// has no cancellation, however small the stretch is.
    #[inline(always)]
    pub fn new(reference: Vec2, change: Vec2, length: f64) -> Self {
        let branch = reference + change;
        let distance = branch.norm();
        Self {
            branch,
            distance,
            length,
            excess: 2.0 * reference.dot(change) + change.norm_squared(),
            scale: length * (distance + length),
        }
    }

    /// Stretch, dimensionless: $ s = \frac{d - r}{r} = \frac{d^2 - r^2}{r (d + r)} $
    #[inline(always)]
    pub fn stretch(&self) -> f64 {
        self.excess / self.scale
    }

    /// Whether the stretch exceeds the critical one, in absolute value if both signs count.
    #[inline(always)]
    pub fn exceeds<const TWO_SIDED: bool>(&self, critical_stretch: f64) -> bool {
        let excess = if TWO_SIDED {
            self.excess.abs()
        } else {
            self.excess
        };
        excess > critical_stretch * self.scale
    }

    /// Pair force density (3.2) on the earlier node per stiffness, dimensionless: $ w s \vec e $. Positive stretch
    /// attracts. Zero if the nodes are at the same place.
    #[inline(always)]
    pub fn pull(&self, weight: Weight, horizon: f64) -> Vec2 {
        let distance = self.distance.max(TINIEST);
        self.branch * (weight.at(self.length, horizon) * self.excess / (self.scale * distance))
    }

    /// Energy in J/m per product of the two areas: $ \frac12 c w s^2 r $
    #[inline(always)]
    pub fn energy(&self, constants: &BondConstants) -> f64 {
        let stretch = self.stretch();
        let weight = constants.weight.at(self.length, constants.horizon);
        0.5 * constants.stiffness * weight * stretch * stretch * self.length
    }
}
