//! Shapes: discs and convex polygons, shared by all bodies that differ only in size.

use crate::error::{SetupError, require};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Index of a shape in [`Shapes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ShapeId(u32);

impl ShapeId {
    /// Position of the shape among the shapes.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One side of a polygon, from vertex k to vertex k + 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Outward unit normal.
    pub normal: Vec2,
    /// Distance from the centroid to the line of the side in m, positive.
    pub offset: f64,
    /// Length in m.
    pub length: f64,
    /// A number in [0, 4] that grows with the angle from the normal of side 0.
    turn: f64,
}

/// Measures of a shape of unit scale.
///
/// A body of scale $s$ and density $\rho$ has mass $\rho s^2 A$ and moment of inertia $\rho s^4 J$.
///
/// | letter | field | meaning | unit |
/// |---|---|---|---|
/// | $A$ | `area` | area | m² |
/// | $J$ | `second_moment` | $\int r^2 \, dA$ about the centroid | m⁴ |
/// | $R$ | `circumradius` | largest distance from the centroid | m |
/// | $h$ | `inradius` | smallest distance from the centroid to a side | m |
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Area in m².
    pub area: f64,
    /// Polar second moment of area about the centroid in m⁴.
    pub second_moment: f64,
    /// Radius of the smallest circle around the centroid that contains the shape, in m.
    pub circumradius: f64,
    /// Radius of the largest circle around the centroid inside the shape, in m.
    pub inradius: f64,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    first: usize,
    count: usize,
    measures: Measures,
}

/// All shapes of a system. Vertices and sides of all polygons lie in two flat columns.
#[derive(Clone, Debug, Default)]
pub struct Shapes {
    entries: Vec<Entry>,
    vertices: Vec<Vec2>,
    sides: Vec<Side>,
}

/// A shape of unit scale in its own frame, with the centroid at the origin. A disc has no vertices.
#[derive(Clone, Copy, Debug)]
pub struct Outline<'a> {
    /// Vertices in m, anticlockwise; none for a disc.
    pub vertices: &'a [Vec2],
    /// Sides; side k begins at vertex k.
    pub sides: &'a [Side],
    /// Area, second moment and radii.
    pub measures: Measures,
}

impl Shapes {
    /// No shapes.
    pub fn new() -> Self {
        Self::default()
    }

    /// Add the disc of radius 1 m.
    pub fn add_disc(&mut self) -> ShapeId {
        let area = core::f64::consts::PI;
        let measures = Measures {
            area,
            second_moment: 0.5 * area,
            circumradius: 1.0,
            inradius: 1.0,
        };
        self.add_entry(0, measures)
    }

    /// Add the regular polygon with circumradius 1 m.
    ///
    /// Vertex k lies at the angle $2 \pi k / n$ from the x axis of the body; a body of angle $\theta$ has it at
    /// $\theta + 2 \pi k / n$. The exterior angle $2 \pi / n$ is the angularity of the source.
    ///
    /// # Errors
    /// [`SetupError::TooFewVertices`] below 3 sides.
    pub fn add_regular(&mut self, sides: usize) -> Result<ShapeId, SetupError> {
        let vertex = |k: usize| {
            let angle = core::f64::consts::TAU * k as f64 / sides as f64;
            Vec2::new(libm::cos(angle), libm::sin(angle))
        };
        let vertices: Vec<_> = (0..sides).map(vertex).collect();
        self.add_centred(&vertices, Vec2::zero())
    }

    /// Add a convex polygon with the given vertices, anticlockwise.
    ///
    /// Vertices are stored relative to the centroid, which is the position of a body.
    ///
    /// # Errors
    /// [`SetupError::TooFewVertices`] below 3 vertices, [`SetupError::NotConvex`] if the polygon does not turn left
    /// at every vertex, or winds around more than once.
    pub fn add_polygon(&mut self, vertices: &[Vec2]) -> Result<ShapeId, SetupError> {
        self.add_centred(vertices, centroid(vertices))
    }

    fn add_centred(&mut self, vertices: &[Vec2], centre: Vec2) -> Result<ShapeId, SetupError> {
        let count = vertices.len();
        if count < 3 {
            return Err(SetupError::TooFewVertices { vertices: count });
        }
        let centred: Vec<_> = vertices.iter().map(|&v| v - centre).collect();
        let sides = sides(&centred)?;
        let measures = measures(&centred, &sides);
        require("area", measures.area, "positive", measures.area > 0.0)?;
        let id = self.add_entry(count, measures);
        self.vertices.extend(centred);
        self.sides.extend(sides);
        Ok(id)
    }

    fn add_entry(&mut self, count: usize, measures: Measures) -> ShapeId {
        let first = self.vertices.len();
        self.entries.push(Entry {
            first,
            count,
            measures,
        });
        ShapeId(self.entries.len() as u32 - 1)
    }

    /// Number of shapes.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there is no shape.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Whether a shape belongs to this set.
    pub fn contains(&self, id: ShapeId) -> bool {
        (id.0 as usize) < self.entries.len()
    }

    /// Outline of a shape of this set.
    pub fn outline(&self, id: ShapeId) -> Outline<'_> {
        let entry = self.entries[id.0 as usize];
        let range = entry.first..entry.first + entry.count;
        Outline {
            vertices: &self.vertices[range.clone()],
            sides: &self.sides[range],
            measures: entry.measures,
        }
    }
}

impl Outline<'_> {
    /// Whether the shape is a disc.
    #[inline]
    pub fn is_disc(&self) -> bool {
        self.vertices.is_empty()
    }

    /// Index of the next vertex or side, anticlockwise.
    #[inline]
    pub fn next(&self, k: usize) -> usize {
        if k + 1 == self.vertices.len() {
            0
        } else {
            k + 1
        }
    }

    /// Index of the previous vertex or side.
    #[inline]
    pub fn previous(&self, k: usize) -> usize {
        if k == 0 {
            self.vertices.len() - 1
        } else {
            k - 1
        }
    }

    /// The last side whose normal is not beyond a direction, anticlockwise. Cost: the logarithm of the number of sides.
    #[inline]
    pub fn side_facing(&self, direction: Vec2) -> usize {
        let turn = turn(self.sides[0].normal, direction);
        let after = self.sides.partition_point(|side| side.turn <= turn);
        after.saturating_sub(1)
    }

    /// The vertex that is farthest in a direction, and its coordinate along the direction.
    #[inline]
    pub fn support(&self, direction: Vec2) -> (usize, f64) {
        let start = self.next(self.side_facing(direction));
        self.climb(direction, start)
    }

    /// The vertex that is farthest in a direction, found by walking from a vertex nearby.
    #[inline]
    pub fn climb(&self, direction: Vec2, start: usize) -> (usize, f64) {
        let mut best = start;
        let mut farthest = self.vertices[start].dot(direction);
        for step in [Outline::next, Outline::previous] {
            for _ in 1..self.vertices.len() {
                let candidate = step(self, best);
                let coordinate = self.vertices[candidate].dot(direction);
                if coordinate <= farthest || coordinate.is_nan() {
                    break;
                }
                (best, farthest) = (candidate, coordinate);
            }
        }
        (best, farthest)
    }
}

/// Pseudo-angle from `base` to `v` in [0, 4]: it grows with the angle, and needs no trigonometry.
#[inline]
fn turn(base: Vec2, v: Vec2) -> f64 {
    let (x, y) = (base.dot(v), base.cross(v));
    let sum = x.abs() + y.abs();
    if sum == 0.0 {
        return 0.0;
    }
    match (y >= 0.0, x >= 0.0) {
        (true, true) => y / sum,
        (true, false) => 1.0 - x / sum,
        (false, false) => 2.0 - y / sum,
        (false, true) => 3.0 + x / sum,
    }
}

fn centroid(vertices: &[Vec2]) -> Vec2 {
    let Some(&origin) = vertices.first() else {
        return Vec2::zero();
    };
    let mut twice_area = 0.0;
    let mut sum = Vec2::zero();
    for pair in vertices.windows(2) {
        let (a, b) = (pair[0] - origin, pair[1] - origin);
        let cross = a.cross(b);
        twice_area += cross;
        sum += (a + b) * cross;
    }
    origin + sum * (1.0 / (3.0 * twice_area))
}

fn sides(vertices: &[Vec2]) -> Result<Vec<Side>, SetupError> {
    let count = vertices.len();
    let mut sides: Vec<Side> = Vec::with_capacity(count);
    for k in 0..count {
        let along = vertices[(k + 1) % count] - vertices[k];
        let length = along.norm();
        let normal = -along.perpendicular() * (1.0 / length);
        let before = vertices[k] - vertices[(k + count - 1) % count];
        let turn = sides.first().map_or(0.0, |side| turn(side.normal, normal));
        let turns_on = sides.last().is_none_or(|side| turn > side.turn);
        let offset = normal.dot(vertices[k]);
        let is_convex = before.cross(along) > 0.0 && turns_on && offset > 0.0;
        if !is_convex || !offset.is_finite() {
            return Err(SetupError::NotConvex { vertex: k });
        }
        sides.push(Side {
            normal,
            offset,
            length,
            turn,
        });
    }
    Ok(sides)
}

fn measures(vertices: &[Vec2], sides: &[Side]) -> Measures {
    let mut measures = Measures {
        area: 0.0,
        second_moment: 0.0,
        circumradius: 0.0,
        inradius: f64::INFINITY,
    };
    for (k, side) in sides.iter().enumerate() {
        let (a, b) = (vertices[k], vertices[(k + 1) % vertices.len()]);
        let cross = a.cross(b);
        let squares = a.norm_squared() + a.dot(b) + b.norm_squared();
        measures.area += 0.5 * cross;
        measures.second_moment += cross * squares / 12.0;
        measures.circumradius = measures.circumradius.max(a.norm());
        measures.inradius = measures.inradius.min(side.offset);
    }
    measures
}
