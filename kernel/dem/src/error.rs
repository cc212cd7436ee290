//! Errors of the kernel.

use thiserror::Error;

/// An invalid model or initial state.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ModelError {
    /// A parameter is outside its range.
    #[error("{name} is {value}, but must be {accepted}")]
    Parameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Which values are accepted.
        accepted: &'static str,
    },
    /// A contact or bond refers to a particle that does not exist.
    #[error("pair {index} refers to particle {particle}, but there are only {particles} particles")]
    NoSuchParticle {
        /// Index of the pair in its list.
        index: usize,
        /// Index of the missing particle.
        particle: usize,
        /// Number of particles.
        particles: usize,
    },
    /// A contact or bond connects a particle with itself.
    #[error("pair {index} connects particle {particle} with itself")]
    SelfPair {
        /// Index of the pair in its list.
        index: usize,
        /// The particle.
        particle: usize,
    },
    /// Two contacts or two bonds connect the same pair.
    #[error("pair {index} repeats particles {i} and {j}, which are already connected")]
    DuplicatePair {
        /// Index of the pair in its list.
        index: usize,
        /// First particle.
        i: usize,
        /// Second particle.
        j: usize,
    },
    /// An initial contact is given for particles that do not overlap.
    #[error(
        "contact {index} between particles {i} and {j} has an initial state, but they do not overlap"
    )]
    NoOverlap {
        /// Index of the contact in its list.
        index: usize,
        /// First particle.
        i: usize,
        /// Second particle.
        j: usize,
    },
    /// The periodic box is too narrow for its particles.
    #[error("the periodic width {width} m is less than two cells of {cell} m")]
    NarrowBox {
        /// Width in m.
        width: f64,
        /// Smallest side of a cell in m.
        cell: f64,
    },
    /// A bond is longer than half the periodic width, so that its nearest image is ambiguous.
    #[error(
        "bond {index} is {length} m long, but bonds must not exceed half the periodic width {width} m"
    )]
    LongBond {
        /// Index of the bond in its list.
        index: usize,
        /// Length in m.
        length: f64,
        /// Width in m.
        width: f64,
    },
    /// A set-up leaves no particle.
    #[error("no particle is left: clipping or cutting removed all that the set-up generated")]
    NothingLeft,
    /// The model has a driving law, but no particle is driven.
    #[error("there is a driving law, but no driven particle")]
    NothingDriven,
}

/// A step that failed.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// Position, velocity, angle or angular velocity of a particle is no longer finite.
    #[error(
        "the state of particle {particle} is not finite at {time:.6e} s, in the step after {steps}; \
         likely cause: {}{}",
        cause(*.time_step, *.bound, "forces or speeds are too large"),
        interaction_text(*.interaction)
    )]
    NotFinite {
        /// The particle.
        particle: usize,
        /// Pair of the particle's contact or bond with the largest force, if it has any.
        interaction: Option<[usize; 2]>,
        /// Time in s.
        time: f64,
        /// Number of completed steps.
        steps: u64,
        /// Time step in s.
        time_step: f64,
        /// Estimate of the largest stable time step in s.
        bound: f64,
    },
    /// A particle moves so far per step that it may pass others unseen.
    #[error(
        "particle {particle} moved {distance:.3e} m in one step at {time:.6e} s, more than the \
         {limit:.3e} m beyond which it may pass others unseen; likely cause: {}{}",
        cause(*.time_step, *.bound, "the speed is too high for this step"),
        interaction_text(*.interaction)
    )]
    TooFast {
        /// The particle.
        particle: usize,
        /// Pair of the particle's contact or bond with the largest force, if it has any.
        interaction: Option<[usize; 2]>,
        /// Displacement per step in m; with contacts, relative to the mean velocity of all particles.
        distance: f64,
        /// Largest displacement in m that is accepted: with contacts, the diameter of the particle.
        limit: f64,
        /// Time in s.
        time: f64,
        /// Time step in s.
        time_step: f64,
        /// Estimate of the largest stable time step in s.
        bound: f64,
    },
}

/// Why a step may have failed: it is above the bound, or something else.
fn cause(time_step: f64, bound: f64, otherwise: &str) -> String {
    if time_step > bound {
        format!("the time step {time_step:?} s is above the stability bound, about {bound:.3e} s")
    } else {
        format!(
            "{otherwise}; the time step {time_step:?} s is not above the stability bound of contacts and bonds"
        )
    }
}

fn interaction_text(interaction: Option<[usize; 2]>) -> String {
    interaction.map_or_else(String::new, |[i, j]| {
        format!("; its most strained contact or bond is {i}-{j}")
    })
}
