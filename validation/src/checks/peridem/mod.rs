//! The checks of peridynamic grains.

mod amplification;
mod breaking;
mod constants;
mod contact;
mod extremes;
mod grains;
mod lammps;
mod linear;
mod motion;
mod perigrain;
mod random_states;
mod walls;

use super::Topic;

/// The chapter.
pub fn topic() -> Topic {
    let checks = [
        constants::checks(),
        linear::checks(),
        amplification::checks(),
        motion::checks(),
        contact::checks(),
        walls::checks(),
        breaking::checks(),
        perigrain::checks(),
        lammps::checks(),
        extremes::checks(),
        random_states::checks(),
    ];
    Topic {
        id: "peridem",
        title: "Peridynamic grains",
        about: "Deformable, breakable grains of any shape by bond-based peridynamics, after Bhattacharya and Lipton (2023): constants of bonds, small vibrations and the critical step, momentum and energy, contact, walls, breaking, motions of other programs, and extreme values.",
        checks: checks.into_iter().flatten().collect(),
    }
}
