//! The checks of contact dynamics: rigid discs and polygons.

mod cells;
mod geometry;
mod lmgc90;
mod local;
mod system;

use super::Topic;

/// The chapter.
pub fn topic() -> Topic {
    let checks = [local::checks(), geometry::checks(), lmgc90::checks()];
    Topic {
        id: "contact-dynamics",
        title: "Contact dynamics",
        about: "Rigid discs and convex polygons whose contacts are solved as impulses of whole steps, after Azéma, Estrada and Radjai (2012): the local laws, geometry, motion and energy, other programs, the convergence of the sweeps, and the limit of stiff contacts of the thesis's model.",
        checks: checks.into_iter().flatten().collect(),
    }
}
