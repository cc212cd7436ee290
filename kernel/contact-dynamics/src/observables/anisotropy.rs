//! Anisotropies of contacts, forces and branch vectors.

use super::KindSums;
use super::sums::ratio;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Anisotropies with respect to the principal direction of the stress, azema (7), dimensionless.
///
/// $$ a_c = \frac2N \sum \cos 2\Delta $$
/// $$ a_{fn} = \frac{2 \sum f_n \cos 2\Delta}{\sum f_n} - a_c, \qquad a_{ft} = -\frac{2 \sum f_t \sin 2\Delta}{\sum f_n} $$
///
/// with $\Delta = \theta - \theta_s$; $a_{ln}$ and $a_{lt}$ are made in the same way of the branch vector.
///
/// # Sign
/// With the tangent turned by +90 degrees from the normal and the force on the second body, contacts that are compressed
/// along $\theta_s$ resist by $f_t = -a_{ft} f_n \sin 2\Delta$ with $a_{ft} \ge 0$. (7) prints no minus sign.
///
/// # Errata and departures
/// These moments are not the coefficients of (7), which [`Self::fourier`] gives: azema C10.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Anisotropies {
    /// Of the directions of contacts.
    pub contacts: f64,
    /// Of normal forces.
    pub normal_force: f64,
    /// Of tangential forces.
    pub tangential_force: f64,
    /// Of the normal components of branch vectors.
    pub normal_branch: f64,
    /// Of the tangential components of branch vectors.
    pub tangential_branch: f64,
}

#[rendered]
impl Anisotropies {
    /// Sums over some contacts, divided by sums over all contacts; `axis` is $(\cos 2\theta_s, \sin 2\theta_s)$.
    pub(super) fn by_moments(part: &KindSums, whole: &KindSums, axis: Vec2) -> Self {
        let contacts = 2.0 * ratio(part.contacts.even(axis), whole.contacts.sum);
        let (force, branch) = (whole.normal_force.sum, whole.normal_branch.sum);
        Self {
            contacts,
            normal_force: 2.0 * ratio(part.normal_force.even(axis), force) - contacts,
            tangential_force: -2.0 * ratio(part.tangential_force.odd(axis), force),
            normal_branch: 2.0 * ratio(part.normal_branch.even(axis), branch) - contacts,
            tangential_branch: -2.0 * ratio(part.tangential_branch.odd(axis), branch),
        }
    }

    /// The stress ratio that the anisotropies explain to first order, azema (8).
    ///
    /// $$ \frac qp \approx \frac12 (a_c + a_{ln} + a_{lt} + a_{fn} + a_{ft}) $$
    pub fn half_sum(&self) -> f64 {
        0.5 * (self.contacts
            + self.normal_force
            + self.tangential_force
            + self.normal_branch
            + self.tangential_branch)
    }

    /// The coefficients of azema (7), if the angular functions have exactly this form.
    ///
    /// $$ a'_{fn} = \frac{a_{fn}}{1 - a_c (a_{fn} + a_c)/2}, \qquad a'_{ft} = a_{ft} \left( 1 + \tfrac12 a_c a'_{fn} \right) $$
    ///
    /// and the same for the branch vector; $a_c$ is already the coefficient. For anisotropies of all contacts, not of
    /// one kind.
    pub fn fourier(&self) -> Self {
        let a_c = self.contacts;
        let normal = |moment: f64| moment / (1.0 - 0.5 * a_c * (moment + a_c));
        let (force, branch) = (normal(self.normal_force), normal(self.normal_branch));
        Self {
            contacts: a_c,
            normal_force: force,
            tangential_force: self.tangential_force * (1.0 + 0.5 * a_c * force),
            normal_branch: branch,
            tangential_branch: self.tangential_branch * (1.0 + 0.5 * a_c * branch),
        }
    }
}
