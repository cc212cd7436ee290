//! Numbers that are no part of a formula: scaling them changes how a result is found, not the result.

/// File, expression and reason.
pub const EXEMPT: &[(&str, &str, &str)] = &[
    (
        "geometry/pair_frame.rs",
        "COINCIDENT",
        "below this squared distances have lost their precision; any number of that order does",
    ),
    (
        "geometry/angle.rs",
        "SMALL_SINE",
        "where the polynomial takes over from the arctangent; both agree to rounding on either side",
    ),
    (
        "geometry/contact.rs",
        "1e-4",
        "where a series takes over; both agree to rounding on either side",
    ),
    (
        "links/neighbors.rs",
        "MARGIN",
        "a wider list costs time and changes no pair that touches",
    ),
];
