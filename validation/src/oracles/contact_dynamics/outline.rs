//! Convex shapes as lists of vertices, and what follows from their Minkowski difference. Brute force.

use std::f64::consts::TAU;

type Vector = [f64; 2];

/// A convex polygon, or a single vertex with a radius: a disc.
#[derive(Clone, Debug)]
pub struct Outline {
    /// Vertices, anticlockwise.
    pub vertices: Vec<Vector>,
    /// Radius of the discs around all points.
    pub radius: f64,
}

/// How far two shapes are apart.
#[derive(Clone, Copy, Debug)]
pub struct Apart {
    /// Distance in m, negative in overlap.
    pub distance: f64,
    /// Unit vector from the first to the second shape along which it is measured.
    pub normal: Vector,
    /// By how much the second best side separates less, in m.
    pub lead: f64,
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

impl Outline {
    /// The regular polygon around a centre, with the radius of its circumscribed circle in m, or a disc for 0 sides.
    pub fn regular(sides: usize, radius: f64, angle: f64, centre: Vector) -> Self {
        if sides == 0 {
            return Self {
                vertices: vec![centre],
                radius,
            };
        }
        let vertex = |k: usize| {
            let direction = angle + TAU * k as f64 / sides as f64;
            [
                centre[0] + radius * direction.cos(),
                centre[1] + radius * direction.sin(),
            ]
        };
        Self {
            vertices: (0..sides).map(vertex).collect(),
            radius: 0.0,
        }
    }

    /// How far another shape is away, along the side of the Minkowski difference that separates most, or from the
    /// nearest vertex of it if one of the shapes is a disc.
    pub fn apart(&self, other: &Self) -> Apart {
        let differences = other.vertices.iter().flat_map(|&b| {
            let to_b = move |&a: &Vector| minus(b, a);
            self.vertices.iter().map(to_b)
        });
        let hull = hull(differences.collect());
        let radii = self.radius + other.radius;
        let found = match hull[..] {
            [only] => from_vertex(only),
            _ if radii > 0.0 => nearest(&hull),
            _ => by_sides(&hull),
        };
        Apart {
            distance: found.distance - radii,
            ..found
        }
    }

    /// Smallest and largest coordinate along a direction on the line where the coordinate along the direction turned
    /// by -90 degrees has a value, or at the nearest end of the shape.
    pub fn section(&self, normal: Vector, at: f64) -> Vector {
        let along = |v: Vector| cross(normal, v);
        let coordinates = self.vertices.iter().map(|&v| along(v));
        let low = coordinates.clone().fold(f64::INFINITY, f64::min);
        let high = coordinates.fold(f64::NEG_INFINITY, f64::max);
        if self.radius > 0.0 {
            let reach = (self.radius.powi(2) - (at - low).powi(2)).max(0.0).sqrt();
            let middle = dot(normal, self.vertices[0]);
            return [middle - reach, middle + reach];
        }
        let at = at.max(low).min(high);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for (k, &from) in self.vertices.iter().enumerate() {
            let to = self.vertices[(k + 1) % self.vertices.len()];
            let [begin, end] = [along(from), along(to)];
            if begin.min(end) > at || begin.max(end) < at {
                continue;
            }
            let part = if begin == end {
                0.0
            } else {
                (at - begin) / (end - begin)
            };
            let height = dot(normal, from) + part * dot(normal, minus(to, from));
            (least, most) = (least.min(height), most.max(height));
        }
        [least, most]
    }
}

/// The origin as seen from a point of the difference.
fn from_vertex(vertex: Vector) -> Apart {
    let distance = vertex[0].hypot(vertex[1]);
    Apart {
        distance,
        normal: vertex.map(|x| x / distance),
        lead: f64::INFINITY,
    }
}

/// The side of the difference beyond which the origin lies farthest, or under which it is least deep.
fn by_sides(hull: &[Vector]) -> Apart {
    let mut best = Apart {
        distance: f64::NEG_INFINITY,
        normal: [0.0; 2],
        lead: f64::INFINITY,
    };
    let mut second = f64::NEG_INFINITY;
    for (k, &from) in hull.iter().enumerate() {
        let along = minus(hull[(k + 1) % hull.len()], from);
        let length = along[0].hypot(along[1]);
        // Outward is to the right of the way around; the normal from the first to the second shape is opposite.
        let normal = [-along[1] / length, along[0] / length];
        let distance = dot(normal, from);
        if distance > best.distance {
            second = best.distance;
            (best.distance, best.normal) = (distance, normal);
        } else {
            second = second.max(distance);
        }
    }
    best.lead = best.distance - second;
    best
}

/// The nearest point of the difference, if the origin is outside, or else its nearest side.
fn nearest(hull: &[Vector]) -> Apart {
    let inside = by_sides(hull);
    if inside.distance <= 0.0 {
        return inside;
    }
    let mut best = [f64::INFINITY; 2];
    for (k, &from) in hull.iter().enumerate() {
        let along = minus(hull[(k + 1) % hull.len()], from);
        let part = (-dot(from, along) / dot(along, along)).clamp(0.0, 1.0);
        let point = [from[0] + part * along[0], from[1] + part * along[1]];
        if point[0].hypot(point[1]) < best[0].hypot(best[1]) {
            best = point;
        }
    }
    from_vertex(best)
}

/// The convex hull, anticlockwise.
fn hull(mut points: Vec<Vector>) -> Vec<Vector> {
    if points.len() == 1 {
        return points;
    }
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut hull: Vec<Vector> = Vec::new();
    for is_upper in [false, true] {
        let start = hull.len();
        let ordered: Box<dyn Iterator<Item = &Vector>> = match is_upper {
            false => Box::new(points.iter()),
            true => Box::new(points.iter().rev()),
        };
        for &point in ordered {
            while let [.., a, b] = hull[start..] {
                // Nearly collinear points would make sides without a direction.
                if cross(minus(b, a), minus(point, b)) > 1e-14 {
                    break;
                }
                hull.pop();
            }
            hull.push(point);
        }
        hull.pop();
    }
    hull
}
