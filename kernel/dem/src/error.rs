//! What can go wrong.

use thiserror::Error;

/// A model or an initial state that makes no sense.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ModelError {
    /// A parameter is out of its range.
    #[error("{name} is {value}, but must be {accepted}")]
    Parameter {
        /// Which parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// A link names a particle that does not exist.
    #[error("link {link} names particle {particle}, but there are only {particles} particles")]
    NoSuchParticle {
        /// Position of the link in its list.
        link: usize,
        /// The particle named.
        particle: usize,
        /// How many there are.
        particles: usize,
    },
    /// A link connects a particle with itself.
    #[error("link {link} connects particle {particle} with itself")]
    SelfLink {
        /// Position of the link in its list.
        link: usize,
        /// The particle.
        particle: usize,
    },
    /// Two links connect the same pair.
    #[error("link {link} connects particles {i} and {j}, which another link connects already")]
    DuplicateLink {
        /// Position of the link in its list.
        link: usize,
        /// First particle.
        i: usize,
        /// Second particle.
        j: usize,
    },
    /// A contact memory is given for a pair that does not touch.
    #[error(
        "contact {link} between particles {i} and {j} has a memory, but the two do not overlap"
    )]
    NoOverlap {
        /// Position of the contact in its list.
        link: usize,
        /// First particle.
        i: usize,
        /// Second particle.
        j: usize,
    },
    /// The periodic box is too narrow for its particles.
    #[error("the periodic width {width} m is below two cells of {cell} m")]
    NarrowBox {
        /// Width in m.
        width: f64,
        /// Smallest side of a cell in m.
        cell: f64,
    },
    /// A bond is longer than half the periodic width, so that its image is ambiguous.
    #[error(
        "bond {link} is {length} m long, but the periodic width {width} m allows only half of it"
    )]
    LongBond {
        /// Position of the bond in its list.
        link: usize,
        /// Length in m.
        length: f64,
        /// Width in m.
        width: f64,
    },
    /// A driving law, but no driven particle.
    #[error("there is a driving law, but no driven particle")]
    NothingDriven,
}

/// A step that could not be taken.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// The state of a particle is no longer finite.
    #[error(
        "the state of particle {particle} is not finite at {time} s, in the step after {steps}; \
         likely cause: the time step {time_step} s is above the stability bound, \
         about {bound:.3e} s{}",
        link_text(*.link)
    )]
    NotFinite {
        /// The particle.
        particle: usize,
        /// The link of that particle which is most strained, if any.
        link: Option<[usize; 2]>,
        /// Time in s.
        time: f64,
        /// Steps completed.
        steps: u64,
        /// Time step in s.
        time_step: f64,
        /// Estimate of the largest stable step in s.
        bound: f64,
    },
    /// A particle moved more than a cell in one step.
    #[error(
        "particle {particle} moved {distance:.3e} m in one step at {time} s, more than the cell of \
         {cell:.3e} m in which contacts are sought; likely cause: the time step {time_step} s is \
         above the stability bound, about {bound:.3e} s, or the speed is \
         too high for it{}",
        link_text(*.link)
    )]
    TooFast {
        /// The particle.
        particle: usize,
        /// A link of that particle, if any.
        link: Option<[usize; 2]>,
        /// How far it moved in m.
        distance: f64,
        /// Side of a cell in m.
        cell: f64,
        /// Time in s.
        time: f64,
        /// Time step in s.
        time_step: f64,
        /// Estimate of the largest stable step in s.
        bound: f64,
    },
}

fn link_text(link: Option<[usize; 2]>) -> String {
    link.map_or_else(String::new, |[i, j]| {
        format!("; its most strained link is {i}-{j}")
    })
}
