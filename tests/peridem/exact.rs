//! Geometry in exact rational arithmetic, by methods other than those of the kernel: parameters and midpoints.

use gouge_common::geometry::Vec2;
use gouge_peridem::shape::Outline;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// A point with rational coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub x: BigRational,
    pub y: BigRational,
}

impl Point {
    pub fn new(point: Vec2) -> Self {
        Self {
            x: BigRational::from_float(point.x).unwrap(),
            y: BigRational::from_float(point.y).unwrap(),
        }
    }

    fn minus(&self, other: &Self) -> Self {
        Self {
            x: &self.x - &other.x,
            y: &self.y - &other.y,
        }
    }

    fn cross(&self, other: &Self) -> BigRational {
        &self.x * &other.y - &self.y * &other.x
    }

    fn dot(&self, other: &Self) -> BigRational {
        &self.x * &other.x + &self.y * &other.y
    }

    /// The point at a fraction of the way from this point to another one.
    fn towards(&self, other: &Self, fraction: &BigRational) -> Self {
        let way = other.minus(self);
        Self {
            x: &self.x + way.x * fraction,
            y: &self.y + way.y * fraction,
        }
    }
}

fn in_unit(value: &BigRational) -> bool {
    !value.is_negative() && *value <= BigRational::one()
}

/// Whether a point lies on a closed segment.
pub fn on_segment(point: &Point, [a, b]: &[Point; 2]) -> bool {
    let way = b.minus(a);
    let offset = point.minus(a);
    way.cross(&offset).is_zero() && in_unit(&(way.dot(&offset) / way.dot(&way)))
}

/// Fractions of the way from p to q at which a segment meets another one; both ends of a common part.
pub fn meetings(p: &Point, q: &Point, edge: &[Point; 2]) -> Vec<BigRational> {
    let way = q.minus(p);
    if way.x.is_zero() && way.y.is_zero() {
        let meets = on_segment(p, edge);
        return meets.then(BigRational::zero).into_iter().collect();
    }
    let [a, b] = edge;
    let side = b.minus(a);
    let offset = a.minus(p);
    let determinant = way.cross(&side);
    if determinant.is_zero() {
        let aligned = offset.cross(&way).is_zero();
        let length = way.dot(&way);
        let of_end = |end: &Point| way.dot(&end.minus(p)) / &length;
        let mut ends = vec![of_end(a), of_end(b)];
        let covered = [(p, 0), (q, 1)]
            .into_iter()
            .filter(|(end, _)| on_segment(end, edge));
        ends.extend(covered.map(|(_, at)| BigRational::from_integer(at.into())));
        ends.retain(|t| aligned && in_unit(t));
        return ends;
    }
    let along = offset.cross(&side) / &determinant;
    let across = offset.cross(&way) / &determinant;
    (in_unit(&along) && in_unit(&across))
        .then_some(along)
        .into_iter()
        .collect()
}

/// A shape with rational vertices.
pub struct Domain {
    edges: Vec<[Point; 2]>,
    cuts: Vec<[Point; 2]>,
}

/// Edges of a ring.
pub fn edges(ring: &[Vec2]) -> Vec<[Point; 2]> {
    let next = |k: usize| ring[(k + 1) % ring.len()];
    let edge = |k: usize| [Point::new(ring[k]), Point::new(next(k))];
    (0..ring.len()).map(edge).collect()
}

/// Twice the signed area of a ring.
pub fn doubled_area(ring: &[Vec2]) -> BigRational {
    edges(ring).iter().map(|[a, b]| a.cross(b)).sum()
}

impl Domain {
    pub fn new(outline: &Outline) -> Self {
        Self {
            edges: outline.rings().flat_map(edges).collect(),
            cuts: outline
                .cuts()
                .iter()
                .map(|cut| cut.map(Point::new))
                .collect(),
        }
    }

    /// Whether a point is inside or on the boundary: by the numbers of edges above and below it.
    pub fn contains(&self, point: &Point) -> bool {
        if self.edges.iter().any(|edge| on_segment(point, edge)) {
            return true;
        }
        let above = |[a, b]: &&[Point; 2]| {
            if (a.x <= point.x) == (b.x <= point.x) {
                return false;
            }
            let fraction = (&point.x - &a.x) / (&b.x - &a.x);
            a.towards(b, &fraction).y > point.y
        };
        self.edges.iter().filter(above).count() % 2 == 1
    }

    /// Whether a closed segment lies in the closed domain and does not cross a cut inside both.
    ///
    /// Between two consecutive points of the boundary it lies inside as a whole or outside as a whole.
    pub fn admits(&self, from: Vec2, to: Vec2) -> bool {
        let (p, q) = (Point::new(from), Point::new(to));
        let all = self.edges.iter().flat_map(|edge| meetings(&p, &q, edge));
        let mut fractions: Vec<_> = all.collect();
        fractions.extend([BigRational::zero(), BigRational::one()]);
        fractions.sort();
        fractions.dedup();
        let half = BigRational::new(1.into(), 2.into());
        let inside = fractions.windows(2).all(|pair| {
            let middle = (&pair[0] + &pair[1]) * &half;
            self.contains(&p.towards(&q, &middle))
        });
        inside && !self.cuts.iter().any(|cut| crosses(&p, &q, cut))
    }
}

/// Whether two segments cross at one point inside both.
fn crosses(p: &Point, q: &Point, cut: &[Point; 2]) -> bool {
    let inner = |all: Vec<BigRational>| match all.as_slice() {
        [t] => t.is_positive() && *t < BigRational::one(),
        _ => false,
    };
    inner(meetings(p, q, cut)) && inner(meetings(&cut[0], &cut[1], &[p.clone(), q.clone()]))
}
