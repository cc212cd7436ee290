//! Exemptions of contact dynamics.

use super::{Exemption, exempt};

const SEARCH: &str = "a search for candidates, whose gaps are then compared with the exact bound";
const SIGN: &str = "only its sign counts";
const UNIQUE: &str =
    "where all statuses are tried instead of one; both ways find the only solution";
const CUT: &str = "which shapes are cut at a line; a line at the rim cuts nothing off";
const BINS: &str = "in which bins discs are sought; all that may touch are within the bins visited";
const IMAGE: &str = "which of the images of a place in a periodic box is taken";
const STRIPS: &str =
    "where the order of sweeps is divided into strips; the solution does not depend on it";
const MOMENTUM: &str =
    "how far impulses are extrapolated between sweeps; the solution does not depend on it";
const OVERLAP: &str = "overlap that is taken for contact";
const FALLBACK: &str = "a place that is taken only if rounding refuses all others";
const ORDER: &str = "the incident side runs against the reference side, so that the order of its ends is never in doubt";
const PSEUDO: &str = "a pseudo-angle, of which only the order counts";
const ROUNDING: &str = "clamps a level that is outside by rounding";

/// Exemptions of contact dynamics.
pub const EXEMPTIONS: &[Exemption] = &[
    exempt(
        "kernel/contact-dynamics/src/assembly.rs",
        "Assembly::add_wall",
        "1e-12",
        "a tolerance for rounding",
    ),
    exempt(
        "kernel/contact-dynamics/src/detection/axis.rs",
        "best.separation > «enough»",
        "enough",
        "when a search may end early, because any side that separates so much will do",
    ),
    exempt(
        "kernel/contact-dynamics/src/detection/clip.rs",
        "if «begin.along»",
        "begin.along",
        ORDER,
    ),
    exempt(
        "kernel/contact-dynamics/src/detection/clip.rs",
        "<= «end.along»",
        "end.along",
        ORDER,
    ),
    exempt(
        "kernel/contact-dynamics/src/detection/placed.rs",
        "Placed::circumradius",
        "",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "if «stick.n».is_nan()",
        "stick.n",
        "whether it is a number does not depend on a factor",
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "let is_unique = «",
        "self.friction",
        UNIQUE,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "let is_unique = self.friction * «",
        "self.w_nt",
        UNIQUE,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "if «self.friction» *",
        "self.friction",
        UNIQUE,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "if self.friction * «self.w_nt».abs()",
        "self.w_nt",
        UNIQUE,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "LocalProblem::can_slide",
        "self.velocity(impulse).t",
        SIGN,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "LocalProblem::can_slide",
        "sign",
        SIGN,
    ),
    exempt(
        "kernel/contact-dynamics/src/local.rs",
        "copysign(«stick.t»)",
        "stick.t",
        SIGN,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "if «height» + reach",
        "height",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "- reach >= «slab.top»",
        "slab.top",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "match «height» + reach",
        "height",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "match height - reach >= «",
        "slab.bottom",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "let reach = scale *",
        "outline.measures.circumradius",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "position.y - reach >= «",
        "slab.bottom",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "&& «position.y» + reach",
        "position.y",
        CUT,
    ),
    exempt(
        "kernel/contact-dynamics/src/observables/solid_fraction.rs",
        "let level = level.max",
        "radius",
        ROUNDING,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/deposition.rs",
        "let is_free = ",
        "TOLERANCE",
        OVERLAP,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/deposition.rs",
        "let is_free = ",
        "largest",
        OVERLAP,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/deposition.rs",
        "let highest = ",
        "",
        FALLBACK,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/deposition.rs",
        "place.y >= «radius»)",
        "radius",
        "a place that is so near to the floor is not lower than the one on it",
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "Front::new",
        "",
        BINS,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "Front::place",
        "",
        BINS,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "Front::above",
        "",
        BINS,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "(«x» / self.width).floor()",
        "x",
        IMAGE,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "(x / «self.width»).floor()",
        "self.width",
        IMAGE,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "if within < «",
        "self.width",
        IMAGE,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "(d.x / «self.width»).round()",
        "self.width",
        IMAGE,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/front.rs",
        "Front::is_free",
        "tolerance",
        OVERLAP,
    ),
    exempt(
        "kernel/contact-dynamics/src/preparation/sizes.rs",
        "match ratio > «",
        "1.0",
        "where a limit replaces a quotient that tends to it",
    ),
    exempt(
        "kernel/contact-dynamics/src/shape.rs",
        "turn",
        "1.0",
        PSEUDO,
    ),
    exempt(
        "kernel/contact-dynamics/src/shape.rs",
        "turn",
        "2.0",
        PSEUDO,
    ),
    exempt(
        "kernel/contact-dynamics/src/shape.rs",
        "turn",
        "3.0",
        PSEUDO,
    ),
    exempt(
        "kernel/contact-dynamics/src/step.rs",
        "Workspace::new",
        "",
        SEARCH,
    ),
    exempt(
        "kernel/contact-dynamics/src/step.rs",
        "let is_far = ",
        "lengths.alert_distance",
        SEARCH,
    ),
    exempt(
        "kernel/contact-dynamics/src/step.rs",
        "Workspace::exchange_impulses",
        "position[body as usize].x",
        STRIPS,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/division.rs",
        "Division::divide",
        "places.period",
        "only whether there is a period counts",
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/iteration.rs",
        "system.extrapolate",
        "settings.momentum",
        MOMENTUM,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/momentum.rs",
        "Momentum::product",
        "",
        MOMENTUM,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/momentum.rs",
        "Sequence::default",
        "",
        MOMENTUM,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/momentum.rs",
        "Sequence::next",
        "",
        MOMENTUM,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/places.rs",
        "",
        "",
        STRIPS,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/plain.rs",
        "Plain::extrapolate",
        "largest",
        MOMENTUM,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/strips.rs",
        "Leader::extrapolate",
        "largest",
        MOMENTUM,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/row.rs",
        "is_closed(«input.gap»)",
        "input.gap",
        SIGN,
    ),
    exempt(
        "kernel/contact-dynamics/src/sweep/visit.rs",
        "match («self.floor»",
        "self.floor",
        "only whether there is a floor counts",
    ),
    exempt(
        "kernel/contact-dynamics/src/work.rs",
        "is_free",
        "",
        "only whether it is zero counts",
    ),
];
