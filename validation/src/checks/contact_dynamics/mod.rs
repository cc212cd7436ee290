//! The checks of contact dynamics: rigid discs and polygons.

mod cells;
mod convergence;
mod energy;
mod geometry;
mod hard_limit;
mod lmgc90;
mod local;
mod motion;
mod one_step;
mod siconos;
mod stability;
mod system;

use super::Topic;

/// The chapter.
pub fn topic() -> Topic {
    let checks = [
        local::checks(),
        geometry::checks(),
        motion::checks(),
        energy::checks(),
        siconos::checks(),
        lmgc90::checks(),
        convergence::checks(),
        hard_limit::checks(),
        stability::checks(),
    ];
    Topic {
        id: "contact-dynamics",
        title: "Contact dynamics",
        about: "Rigid discs and convex polygons whose contacts are solved as impulses of whole steps, after Azéma, Estrada and Radjai (2012): the local laws, geometry, motion and energy, other programs, the convergence of the sweeps, and the limit of stiff contacts of the thesis's model.",
        checks: checks.into_iter().flatten().collect(),
    }
}
