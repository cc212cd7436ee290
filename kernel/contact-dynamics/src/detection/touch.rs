//! What detection finds: contact points of one pair.

use gouge_common::geometry::Vec2;

/// What identifies a contact point of a pair from step to step: the vertex that makes it.
///
/// The ends of the common part of two sides are vertices of either shape, whichever of the two is the reference, so
/// that the identity survives a change of the reference side. A pair of smooth or single-point shapes has one point,
/// [`Feature::SINGLE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Feature(u32);

const OF_SECOND: u32 = 1 << 31;

impl Feature {
    /// The only point of a pair.
    pub const SINGLE: Self = Self(0);

    /// A vertex of the first shape of the pair.
    pub fn of_first(vertex: usize) -> Self {
        Self(vertex as u32)
    }

    /// A vertex of the second shape of the pair.
    pub fn of_second(vertex: usize) -> Self {
        Self(vertex as u32 | OF_SECOND)
    }

    /// The number behind the identity.
    pub(crate) fn to_word(self) -> u32 {
        self.0
    }

    /// The identity behind a number.
    pub(crate) fn from_word(word: u32) -> Self {
        Self(word)
    }

    /// A vertex of the first or the second shape.
    pub(crate) fn of(is_second: bool, vertex: usize) -> Self {
        match is_second {
            false => Self::of_first(vertex),
            true => Self::of_second(vertex),
        }
    }
}

/// A point where two shapes touch or nearly touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Unit normal, from the first to the second shape.
    pub normal: Vec2,
    /// Vectors from the centres of the first and of the second shape to the point, in m.
    pub arms: [Vec2; 2],
    /// Distance of the surfaces along the normal in m; negative in overlap.
    pub gap: f64,
    /// The vertex that makes the point.
    pub feature: Feature,
}

/// How far two shapes are apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation {
    /// Distance along the normal in m; negative in overlap. For polygons it is that of the best separating side, which
    /// is their distance unless two vertices face each other; beyond the alert distance it is a lower bound.
    pub distance: f64,
    /// Unit normal, from the first to the second shape.
    pub normal: Vec2,
}

/// Where the points of a pair of polygons lie between the two surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PointLine {
    /// All points of the pair on one line parallel to the reference side, at half the mean of their gaps. Points of
    /// a double contact then have equal tangential velocities.
    #[default]
    Common,
    /// Each point half-way between the reference side and the vertex that makes it.
    HalfWay,
}

/// Lengths that detection compares with, and where points lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetectionSettings {
    /// Largest gap of a reported point in m; 0 reports closed points only.
    pub alert_distance: f64,
    /// Of two points of a pair that are nearer than this to each other, the deeper one is kept; in m.
    pub merge_distance: f64,
    /// The first shape provides the reference side unless the second one separates by more than this; in m.
    pub tie_distance: f64,
    /// Where points lie between the surfaces.
    pub line: PointLine,
}

impl DetectionSettings {
    /// The values used for bodies of the mean diameter `diameter` in m: gaps up to 0.02, merging below 1e-4, ties
    /// within 1e-6 diameters.
    pub fn for_diameter(diameter: f64) -> Self {
        Self {
            alert_distance: 0.02 * diameter,
            merge_distance: 1e-4 * diameter,
            tie_distance: 1e-6 * diameter,
            line: PointLine::Common,
        }
    }
}
