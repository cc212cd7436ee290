//! The checks of peridynamic grains.

mod breaking;
mod constants;
mod contact;
mod grains;
mod linear;
mod motion;
mod walls;

use super::Topic;

/// The chapter.
pub fn topic() -> Topic {
    let checks = [
        constants::checks(),
        linear::checks(),
        motion::checks(),
        contact::checks(),
        walls::checks(),
        breaking::checks(),
    ];
    Topic {
        id: "peridem",
        title: "Peridynamic grains",
        about: "Deformable, breakable grains of any shape by bond-based peridynamics, after Bhattacharya and Lipton (2023): constants of bonds, small vibrations and the critical step, momentum and energy, contact, walls, and breaking.",
        checks: checks.into_iter().flatten().collect(),
    }
}
