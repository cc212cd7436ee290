//! Contact points of pairs of shapes.

use super::system::{System, exact_steps, law, moving};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, azema};
use crate::oracles::contact_dynamics::outline::{Apart, Outline};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::detection::{
    DetectionSettings, Placed, PointLine, Separation, Touch, detect,
};
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use gouge_contact_dynamics::sweep::ContactInput;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.geometry.pairs",
            claim: "Distance, normal, gaps and places of contact points are those of the shapes themselves.",
            equations: azema("section 2, E8"),
            scene: "2000 pairs of discs and regular polygons of 3 to 60 sides, radii 0.3 to 2 m, random directions, from deep overlap to open gaps",
            oracle: "Convex hull of all differences of vertices (Minkowski difference), and sections of both shapes along the normal through each point, by brute force",
            norm: "Largest error in m, of a component for normals",
            origin: Origin::Exact,
            reason: "Lengths of up to 4 m have rounding errors of 4e-16 m; a section beside a steep side enlarges them by its slope, whose largest of 1e4 random ones is about 1e4",
            effort: Effort::Quick,
            measure: pairs,
        },
        Check {
            id: "contact-dynamics.geometry.invariance",
            claim: "Contact points turn with the pair, change sides with the bodies, and are mirrored with the shapes.",
            equations: azema("section 2, C1"),
            scene: "The same pairs, turned by a random angle, exchanged, and mirrored at the x axis",
            oracle: "The points of the original pair, turned, exchanged or mirrored",
            norm: "Largest difference of a gap, of a normal or of a place, in m",
            origin: Origin::Exact,
            reason: "Lengths of up to 4 m have rounding errors of 4e-16 m; clipping at the end of a side enlarges them by the ratio of the lengths of the sides, at most about 1e2, and by the inclination of a disc's normal at a corner, the smallest distance over which is 1e-4 m",
            effort: Effort::Quick,
            measure: invariance,
        },
        Check {
            id: "contact-dynamics.geometry.period",
            claim: "A pair that touches across a periodic boundary has the contact points of the same pair inside.",
            equations: azema("section 2"),
            scene: "200 pairs in a box of period 10 m, on either side of its boundary, against the same pair in an open box",
            oracle: "The pair in the open box",
            norm: "Largest difference of a gap, a normal or an arm in m",
            origin: Origin::Exact,
            reason: "A displacement across a period of 10 m has a rounding error of 2e-15 m; clipping at the end of a side enlarges it by the ratio of the lengths of the sides, at most about 1e2",
            effort: Effort::Quick,
            measure: period,
        },
    ]
}

const PAIRS: usize = 2000;
/// Largest error in m.
const BOUND: f64 = 1e-11;
const ALERT: f64 = 0.05;

/// Two shapes and the displacement of their centres.
#[derive(Clone, Copy)]
struct Pair {
    sides: [usize; 2],
    radii: [f64; 2],
    angles: [f64; 2],
    d: [f64; 2],
}

/// All shapes that occur.
struct Library {
    shapes: Shapes,
    ids: Vec<ShapeId>,
}

impl Library {
    fn new() -> Result<Self, Failure> {
        let mut shapes = Shapes::new();
        let mut ids = Vec::new();
        for sides in 0..=60 {
            ids.push(match sides {
                // Neither 1 nor 2 sides occur.
                0..3 => shapes.add_disc(),
                _ => shapes.add_regular(sides)?,
            });
        }
        Ok(Self { shapes, ids })
    }

    fn detect(&self, pair: &Pair, line: PointLine) -> (Separation, Vec<Touch>) {
        let placed = |k: usize| {
            let outline = self.shapes.outline(self.ids[pair.sides[k]]);
            Placed::new(outline, pair.radii[k], pair.angles[k])
        };
        let settings = DetectionSettings {
            alert_distance: ALERT,
            merge_distance: 0.0,
            tie_distance: 0.0,
            line,
        };
        let mut touches = Vec::new();
        let d = Vec2::new(pair.d[0], pair.d[1]);
        let separation = detect(&placed(0), &placed(1), d, &settings, &mut touches);
        (separation, touches)
    }
}

fn rotated(v: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl Pair {
    fn draw(random: &mut Random) -> Self {
        let mut sides = [(); 2].map(|()| match random.below(5) {
            0 => 0,
            1 => 3 + random.below(58),
            _ => 3 + random.below(8),
        });
        if random.below(20) == 0 {
            sides = [0, 0];
        }
        let radii = [random.between(0.3, 2.0), random.between(0.3, 2.0)];
        let angles = [random.between(-4.0, 4.0), random.between(-4.0, 4.0)];
        let mut pair = Self {
            sides,
            radii,
            angles,
            d: [0.0; 2],
        };
        let direction = rotated([1.0, 0.0], random.between(-4.0, 4.0));
        let [first, second] = pair.outlines();
        let farthest = |one: &Outline, sign: f64| {
            let along = one.vertices.iter().map(|&v| sign * dot(v, direction));
            along.fold(f64::NEG_INFINITY, f64::max) + one.radius
        };
        let touching = farthest(&first, 1.0) + farthest(&second, -1.0);
        let distance = touching + random.between(-0.2, 0.04);
        pair.d = direction.map(|x| x * distance);
        pair
    }

    fn outlines(&self) -> [Outline; 2] {
        let of = |k: usize, centre| {
            Outline::regular(self.sides[k], self.radii[k], self.angles[k], centre)
        };
        [of(0, [0.0; 2]), of(1, self.d)]
    }
}

fn near(a: f64, b: f64) -> Measurement {
    Measurement::absolute(a, b, BOUND)
}

fn pairs() -> Outcome {
    let library = Library::new()?;
    let mut random = Random::new(211);
    let (mut all, mut points) = (Vec::new(), 0);
    for _ in 0..PAIRS {
        let pair = Pair::draw(&mut random);
        let outlines = pair.outlines();
        let apart = outlines[0].apart(&outlines[1]);
        // Beyond the alert distance, detection ends at the first side that separates more.
        if apart.distance > ALERT || apart.lead < 1e-9 {
            continue;
        }
        for line in [PointLine::HalfWay, PointLine::Common] {
            let (separation, touches) = library.detect(&pair, line);
            points += touches.len();
            all.push(near(apart.distance, separation.distance));
            all.push(near(apart.normal[0], separation.normal.x));
            all.push(near(apart.normal[1], separation.normal.y));
            places(&outlines, &apart, &touches, line, &mut all);
        }
    }
    if points < 2 * PAIRS {
        return Err(Failure::Oracle(format!("only {points} points were found")));
    }
    Ok(Measurement::worst(all).into())
}

/// Gaps and places of the points against sections of both shapes along the normal.
fn places(
    outlines: &[Outline; 2],
    apart: &Apart,
    touches: &[Touch],
    line: PointLine,
    all: &mut Vec<Measurement>,
) {
    let normal = apart.normal;
    let mut half_way = 0.0;
    let mut smallest = f64::INFINITY;
    for touch in touches {
        let place = [touch.arms[0].x, touch.arms[0].y];
        let at = normal[0] * place[1] - normal[1] * place[0];
        let surface = outlines[0].section(normal, at)[1];
        let other = outlines[1].section(normal, at)[0];
        all.push(near(other - surface, touch.gap));
        smallest = smallest.min(touch.gap);
        half_way += 0.5 * (surface + other) / touches.len() as f64;
        if line == PointLine::HalfWay {
            all.push(near(0.5 * (surface + other), dot(normal, place)));
        }
        let between = touch.arms[0] - touch.arms[1];
        let centre = outlines[1].vertices.iter().fold([0.0; 2], |sum, v| {
            let count = outlines[1].vertices.len() as f64;
            [sum[0] + v[0] / count, sum[1] + v[1] / count]
        });
        all.push(near(centre[0], between.x));
        all.push(near(centre[1], between.y));
    }
    if line == PointLine::Common {
        let heights = touches.iter().map(|touch| {
            let place = [touch.arms[0].x, touch.arms[0].y];
            dot(normal, place)
        });
        all.extend(heights.map(|height| near(half_way, height)));
    }
    // Overlapping shapes touch at the deepest vertex.
    if apart.distance <= 0.0 {
        all.push(near(apart.distance, smallest));
    }
}

/// A point as numbers: gap, normal, arm of the first body.
fn numbers(touch: &Touch) -> [f64; 5] {
    let (n, arm) = (touch.normal, touch.arms[0]);
    [touch.gap, n.x, n.y, arm.x, arm.y]
}

fn invariance() -> Outcome {
    let library = Library::new()?;
    let mut random = Random::new(212);
    let mut all = Vec::new();
    for _ in 0..PAIRS {
        let pair = Pair::draw(&mut random);
        let [first, second] = pair.outlines();
        let apart = first.apart(&second);
        if apart.distance > ALERT || apart.lead < 1e-9 {
            continue;
        }
        let angle = random.between(-3.0, 3.0);
        let turned = Pair {
            angles: pair.angles.map(|a| a + angle),
            d: rotated(pair.d, angle),
            ..pair
        };
        let exchanged = Pair {
            sides: [pair.sides[1], pair.sides[0]],
            radii: [pair.radii[1], pair.radii[0]],
            angles: [pair.angles[1], pair.angles[0]],
            d: pair.d.map(|x| -x),
        };
        let mirrored = Pair {
            angles: pair.angles.map(|a| -a),
            d: [pair.d[0], -pair.d[1]],
            ..pair
        };
        let original = points(&library, &pair, |numbers| numbers);
        let images = [
            points(&library, &turned, |[gap, nx, ny, x, y]| {
                let [n, p] = [[nx, ny], [x, y]].map(|v| rotated(v, -angle));
                [gap, n[0], n[1], p[0], p[1]]
            }),
            points(&library, &exchanged, |[gap, nx, ny, x, y]| {
                [gap, -nx, -ny, x + pair.d[0], y + pair.d[1]]
            }),
            points(&library, &mirrored, |[gap, nx, ny, x, y]| {
                [gap, nx, -ny, x, -y]
            }),
        ];
        all.extend(images.iter().map(|image| different(&original, image)));
    }
    Ok(Measurement::worst(all).into())
}

/// The points of a pair after a transformation, in the order of their places along the contact.
fn points(
    library: &Library,
    pair: &Pair,
    transform: impl Fn([f64; 5]) -> [f64; 5],
) -> Vec<[f64; 5]> {
    let (_, touches) = library.detect(pair, PointLine::Common);
    let mut found: Vec<[f64; 5]> = touches.iter().map(|t| transform(numbers(t))).collect();
    let along = |[_, nx, ny, x, y]: &[f64; 5]| nx * y - ny * x;
    found.sort_by(|a, b| along(a).total_cmp(&along(b)));
    found
}

fn different(one: &[[f64; 5]], other: &[[f64; 5]]) -> Measurement {
    if one.len() != other.len() {
        return near(one.len() as f64, other.len() as f64);
    }
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    Measurement::worst(pairs.map(|(&a, &b)| near(a, b)).chain([near(0.0, 0.0)]))
}

fn period() -> Outcome {
    let mut random = Random::new(213);
    let mut all = Vec::new();
    for _ in 0..200 {
        let pair = Pair::draw(&mut random);
        let [first, second] = pair.outlines();
        if first.apart(&second).distance > 0.0 {
            continue;
        }
        all.push(different(
            &in_box(&pair, None)?,
            &in_box(&pair, Some(10.0))?,
        ));
    }
    Ok(Measurement::worst(all).into())
}

/// The points of a pair around the place x = 10 m, in a box with a period or an open one.
fn in_box(pair: &Pair, width: Option<f64>) -> Result<Vec<[f64; 5]>, Failure> {
    let settings = exact_steps(1e-3, law(0.4, 0.0, GapRule::Predicted));
    let mut system = System::new(settings);
    system.assembly.domain.width = width;
    system.assembly.domain.periodic = width.is_some();
    let rest = moving(0.0, 0.0, 0.0);
    let inside = |x: f64| width.map_or(x, |width| x.rem_euclid(width));
    let x = 10.0 - 0.5 * pair.d[0];
    for k in 0..2 {
        let at = [inside(x + k as f64 * pair.d[0]), k as f64 * pair.d[1]];
        system.body(pair.sides[k], pair.radii[k], at, pair.angles[k], rest)?;
    }
    system.step();
    let points = system.workspace().map_or(&[][..], |found| found.points());
    let number = |point: &ContactInput| {
        let (n, arm) = (point.kinematics.normal, point.kinematics.arms[0]);
        [point.gap, n.x, n.y, arm.n, arm.t]
    };
    Ok(points.iter().map(number).collect())
}
