//! Exemptions: numbers that control an algorithm but appear in no formula. Changing one by a millionth changes no
//! result.

mod contact_dynamics;
mod dem;
mod peridem;

use super::site::Site;
use crate::kernel::Kernel;

/// Sites that are exempt, with the reason.
struct Exemption {
    file: &'static str,
    /// The enclosing function, or a part of the line in which «» mark the expression; any if empty.
    place: &'static str,
    /// The expression; any if empty.
    expression: &'static str,
    reason: &'static str,
}

const fn exempt(
    file: &'static str,
    place: &'static str,
    expression: &'static str,
    reason: &'static str,
) -> Exemption {
    Exemption {
        file,
        place,
        expression,
        reason,
    }
}

/// The exemptions of all kernels.
fn all() -> impl Iterator<Item = &'static Exemption> {
    let others = contact_dynamics::EXEMPTIONS.iter();
    dem::EXEMPTIONS
        .iter()
        .chain(others)
        .chain(peridem::EXEMPTIONS)
}

impl Exemption {
    fn fits(&self, site: &Site) -> bool {
        self.file == site.file
            && (self.place == site.function || site.context.contains(self.place))
            && (self.expression.is_empty() || self.expression == site.expression)
    }
}

/// The reason why a site is exempt, if it is.
pub fn reason(site: &Site) -> Option<&'static str> {
    let found = all().find(|one| one.fits(site));
    found.map(|one| one.reason)
}

/// Exemptions for a kernel that match no site, because the code has changed.
pub fn stale(sites: &[Site], kernel: Kernel) -> Vec<String> {
    let folders = || kernel.folders().iter().chain(kernel.users());
    let is_of = |one: &&Exemption| folders().any(|folder| one.file.starts_with(folder));
    let unused = all()
        .filter(is_of)
        .filter(|one| !sites.iter().any(|site| one.fits(site)));
    unused
        .map(|one| format!("{} {} {}", one.file, one.place, one.expression))
        .collect()
}
