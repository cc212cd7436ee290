//! Shapes of grains, in a frame of their own.

use super::Result;
use crate::random::random;
use crate::scene::table::{Range, Table};
use gouge_common::geometry::Vec2;
use gouge_peridem::error::SetupError;
use gouge_peridem::shape::Outline;

/// Sides of a disc, unless the scene gives another number.
const SIDES: u64 = 20;
/// Most sides of a shape.
const MOST_SIDES: u64 = 10_000;
/// Ratio of the inner to the outer radius of a plus, and of an annulus.
const PLUS: f64 = 0.2;
const ANNULUS: f64 = 0.6;
/// Smallest radius of a perturbed disc in parts of the circumscribed one.
const ROUNDNESS: f64 = 0.6;
/// The purpose of the random numbers of a perturbed disc.
const RADII: u128 = 1;

/// The shape families.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    Disc,
    Square,
    Rectangle,
    Plus,
    Annulus,
    PerturbedDisc,
    Polygon,
}

const FAMILIES: [(&str, Family); 7] = [
    ("disc", Family::Disc),
    ("square", Family::Square),
    ("rectangle", Family::Rectangle),
    ("plus", Family::Plus),
    ("annulus", Family::Annulus),
    ("perturbed-disc", Family::PerturbedDisc),
    ("polygon", Family::Polygon),
];

/// The key that gives the size of a grain: that of its nodes, vertices or sides, or its radius.
pub(super) fn shape_key(table: &Table) -> &'static str {
    let keys = ["nodes_file", "vertices", "size", "radius"];
    let found = keys.into_iter().find(|key| table.has(key));
    found.unwrap_or("shape")
}

/// The key that gives what an error about an outline is about.
fn key_of(error: &SetupError, table: &Table) -> &'static str {
    let is_of_hole = match error {
        SetupError::HoleOutside { .. } | SetupError::HolesMeet { .. } => true,
        SetupError::TooFewVertices { ring, .. }
        | SetupError::InvalidVertex { ring, .. }
        | SetupError::ZeroArea { ring }
        | SetupError::SelfIntersection { ring, .. } => *ring > 0,
        _ => false,
    };
    if is_of_hole && table.has("holes") {
        return "holes";
    }
    shape_key(table)
}

/// What a list of cuts must be.
const CUTS: &str = "must be an array of segments, each [x0, y0, x1, y1]";

impl Family {
    /// Read the key `shape`.
    pub(super) fn read(table: &Table) -> Result<Self> {
        table.choice("shape", &FAMILIES)
    }

    /// The keys that describe a shape of this family.
    pub(super) fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Disc => &["radius", "sides", "cuts"],
            Self::Square => &["radius", "cuts"],
            Self::Rectangle => &["size", "cuts"],
            Self::Plus => &["radius", "inner_ratio", "cuts"],
            Self::Annulus => &["radius", "inner_ratio", "sides", "cuts"],
            Self::PerturbedDisc => &["radius", "roundness", "sides", "seed", "cuts"],
            Self::Polygon => &["vertices", "holes", "cuts"],
        }
    }

    /// The shape that a grain describes.
    pub(super) fn outline(self, table: &Table) -> Result<Outline> {
        let refused = |error: SetupError| table.error(key_of(&error, table), &error.to_string());
        let shape = self.without_cuts(table)?.map_err(refused)?;
        let cuts = table.optional_rows("cuts", CUTS)?;
        let cuts = cuts.into_iter().map(|[x0, y0, x1, y1]| {
            let ends: [Vec2; 2] = [Vec2::new(x0, y0), Vec2::new(x1, y1)];
            ends
        });
        let (outer, holes) = (shape.outer().to_vec(), shape.holes().to_vec());
        let cut = Outline::new(outer, holes, cuts.collect());
        cut.map_err(|error| table.error("cuts", &error.to_string()))
    }

    fn without_cuts(self, table: &Table) -> Result<std::result::Result<Outline, SetupError>> {
        if self == Self::Polygon {
            return polygon(table);
        }
        if self == Self::Rectangle {
            return rectangle(table);
        }
        let radius = table.number("radius", Range::Positive)?;
        Ok(match self {
            Self::Disc => Outline::disc(radius, sides(table)?),
            Self::Plus => Outline::plus(radius, inner_ratio(table, PLUS)?),
            Self::Annulus => Outline::annulus(radius, inner_ratio(table, ANNULUS)?, sides(table)?),
            Self::PerturbedDisc => perturbed_disc(table, radius)?,
            _ => Outline::square(radius),
        })
    }
}

fn sides(table: &Table) -> Result<usize> {
    let given = table.optional_whole_within("sides", 3, MOST_SIDES)?;
    Ok(given.unwrap_or(SIDES) as usize)
}

fn inner_ratio(table: &Table, default: f64) -> Result<f64> {
    let given = table.optional_number("inner_ratio", Range::Between(0.0, 1.0))?;
    Ok(given.unwrap_or(default))
}

fn perturbed_disc(table: &Table, radius: f64) -> Result<std::result::Result<Outline, SetupError>> {
    let roundness = table.optional_number("roundness", Range::Positive)?;
    let roundness = roundness.unwrap_or(ROUNDNESS);
    if roundness > 1.0 {
        return Err(table.error("roundness", "must be a number above 0 and at most 1"));
    }
    let seed = table.optional_whole("seed")?.unwrap_or(0);
    let mut uniform = random(seed, RADII);
    let numbers: Vec<f64> = (0..sides(table)?).map(|_| uniform()).collect();
    Ok(Outline::perturbed_disc(radius, roundness, &numbers))
}

fn rectangle(table: &Table) -> Result<std::result::Result<Outline, SetupError>> {
    let [width, height] = table.pair("size")?;
    if width <= 0.0 || height <= 0.0 {
        return Err(table.error("size", "must be a width and a height in m, both positive"));
    }
    let (x, y) = (0.5 * width, 0.5 * height);
    let corners = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Vec2::new(x, y));
    Ok(Outline::new(corners.to_vec(), Vec::new(), Vec::new()))
}

fn polygon(table: &Table) -> Result<std::result::Result<Outline, SetupError>> {
    let ring = |ring: Vec<[f64; 2]>| ring.into_iter().map(|[x, y]| Vec2::new(x, y)).collect();
    let outer = ring(table.pairs("vertices")?);
    let holes = table.rings("holes")?.into_iter().map(ring).collect();
    Ok(Outline::new(outer, holes, Vec::new()))
}
