//! What the programs were built from.

/// The first twelve digits of the commit, with the ending `-dirty` if the sources differed from it; `unknown` if the
/// programs were built outside a git checkout or without the profile `release`.
pub const COMMIT: &str = env!("GOUGE_COMMIT");

/// Version and commit, for `--version`.
pub const VERSION: &str = concat!(
    env!("CARGO_PKG_VERSION"),
    " (commit ",
    env!("GOUGE_COMMIT"),
    ")"
);
