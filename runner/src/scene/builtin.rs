//! The scenes that come with the program.

use crate::references;
use std::borrow::Cow;
use std::path::Path;

/// Name, purpose and text of every built-in scene.
pub const SCENES: [(&str, &str, &str); 21] = [
    (
        "granite-fault",
        "two blocks of granite, 100 mm, sheared under pressure for 50 ms (thesis section 4.2)",
        include_str!("../scenes/granite-fault.toml"),
    ),
    (
        "granite-fault-small",
        "the same protocol for 25 mm; takes a few seconds",
        include_str!("../scenes/granite-fault-small.toml"),
    ),
    (
        "head-on",
        "two spheres collide head on",
        include_str!("../scenes/head-on.toml"),
    ),
    (
        "oblique",
        "two spheres of different sizes collide off centre and begin to spin",
        include_str!("../scenes/oblique.toml"),
    ),
    (
        "rolling",
        "a spinning sphere slides, then rolls, along a row of fixed ones",
        include_str!("../scenes/rolling.toml"),
    ),
    (
        "pile",
        "a column of grains collapses to its angle of repose",
        include_str!("../scenes/pile.toml"),
    ),
    (
        "cantilever",
        "a beam of bonded grains sags under gravity",
        include_str!("../scenes/cantilever.toml"),
    ),
    (
        "three-point-bend",
        "a beam of bonded grains on two supports is pushed until it breaks",
        include_str!("../scenes/three-point-bend.toml"),
    ),
    (
        "packing",
        "grains settle in a harmonic well, as at the beginning of granite-fault",
        include_str!("../scenes/packing.toml"),
    ),
    (
        "unconfined-compression",
        "a bonded column is compressed until it breaks",
        include_str!("../scenes/unconfined-compression.toml"),
    ),
    (
        "direct-tension",
        "a bonded column is pulled apart",
        include_str!("../scenes/direct-tension.toml"),
    ),
    (
        "brazilian-disc",
        "a bonded disc is split between two platens",
        include_str!("../scenes/brazilian-disc.toml"),
    ),
    (
        "direct-shear",
        "a bonded block is sheared under a constant load",
        include_str!("../scenes/direct-shear.toml"),
    ),
    (
        "hexagonal-lattice-tension",
        "a lattice of equal grains is pulled apart; its elastic constants are known exactly",
        include_str!("../scenes/hexagonal-lattice-tension.toml"),
    ),
    (
        "sheared-polygons",
        "hexagons between rough walls are sheared, by contact dynamics; takes half a minute",
        include_str!("../scenes/sheared-polygons.toml"),
    ),
    (
        "square-on-incline",
        "a square slides down an incline, by contact dynamics",
        include_str!("../scenes/square-on-incline.toml"),
    ),
    (
        "two-grains",
        "two deformable, breakable grains collide, by peridynamics",
        include_str!("../scenes/two-grains.toml"),
    ),
    (
        "kalthoff-winkler",
        "cracks grow from two notches of a plate, by peridynamics; takes ten seconds",
        include_str!("../scenes/kalthoff-winkler.toml"),
    ),
    (
        "colliding-crosses",
        "an arm of a cross falls on that of another, by peridynamics",
        include_str!("../scenes/colliding-crosses.toml"),
    ),
    (
        "notched-square",
        "a notched square breaks between two planks, by peridynamics",
        include_str!("../scenes/notched-square.toml"),
    ),
    (
        "notched-square-printed",
        "the notched square with the printed sizes",
        include_str!("../scenes/notched-square-printed.toml"),
    ),
];

/// Text of a built-in scene.
pub fn text(name: &str) -> Option<&'static str> {
    SCENES
        .iter()
        .find(|(scene, _, _)| *scene == name)
        .map(|(_, _, text)| *text)
}

/// Text of a built-in scene or of the scene of a stored reference run.
pub fn named_text(name: &str) -> Option<Cow<'static, str>> {
    let stored = || references::scene_text(name).map(Cow::Owned);
    text(name).map(Cow::Borrowed).or_else(stored)
}

/// Name and text of the built-in scene or stored reference run that a path names.
pub fn of_path(path: &Path) -> Option<(&str, Cow<'static, str>)> {
    let name = path.to_str()?;
    named_text(name).map(|text| (name, text))
}

/// Names of the built-in scenes of the thesis's model.
pub fn names_of_dem() -> Vec<&'static str> {
    let is_dem = |(_, _, text): &&(&str, &str, &str)| !text.contains("\nmodel = ");
    SCENES
        .iter()
        .filter(is_dem)
        .map(|(name, _, _)| *name)
        .collect()
}

/// Names of all built-in scenes.
pub fn names() -> Vec<&'static str> {
    SCENES.iter().map(|(name, _, _)| *name).collect()
}
