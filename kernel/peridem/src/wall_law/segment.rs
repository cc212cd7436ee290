//! Integrals over the part of a disc of radius one that lies beyond a straight wall.

use core::f64::consts::{FRAC_PI_2, PI, SQRT_2};
use gouge_equations::rendered;

/// Segments up to this height are integrated by a power series; closed forms cancel there.
const SERIES_HEIGHT: f64 = 0.5;
/// Number of terms of the power series: the ratio of terms is at most 1/4.
const SERIES_TERMS: u32 = 24;
/// Half chords up to this length are integrated by a power series in their square, for the exact law.
const SERIES_HALF_CHORD: f64 = 0.6;
/// Number of terms of that series: the ratio of terms is at most 0.36.
const CHORD_TERMS: u32 = 34;

/// A circular segment of the disc of radius one.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Distance t of the chord from the centre, in [-1, 1]; negative if the centre lies in the segment.
    pub distance: f64,
    /// Height $1 - t$.
    height: f64,
    /// Half the chord, $ s = \sqrt{1 - t^2} $.
    pub half_chord: f64,
    /// Half the angle of the arc, $ \theta = \arccos t $.
    pub half_angle: f64,
}

#[rendered]
impl Segment {
    /// Segment of a disc of a radius in m beyond a chord at a signed distance in m from its centre.
    pub fn new(distance: f64, radius: f64) -> Self {
        let height = ((radius - distance) / radius).clamp(0.0, 2.0);
        Self::from_heights(height, ((radius + distance) / radius).clamp(0.0, 2.0))
    }

    /// Segment of a height; the rest of the diameter is given too, since neither is exact as a difference.
    fn from_heights(height: f64, rest: f64) -> Self {
        let distance = 0.5 * (rest - height);
        let half_angle = if height < SERIES_HEIGHT {
            2.0 * libm::asin((0.5 * height).sqrt())
        } else {
            libm::acos(distance)
        };
        Self {
            distance,
            height,
            half_chord: (height * rest).sqrt(),
            half_angle,
        }
    }

    /// Whether the chord does not reach the disc.
    pub fn is_empty(&self) -> bool {
        self.height <= 0.0
    }

    /// $ 2 \sqrt 2 h^{3/2} \sum_n a_n (h/2)^n b(n) $ with $ \sqrt{1 - v} = \sum_n a_n v^n $: the integral over the height of
    /// the width $ 2 \sqrt{u (2 - u)} $ times a weight, where b(n) is that integral for $ u^{n + 1/2} $.
    fn series(&self, integral: impl Fn(f64) -> f64) -> f64 {
        let mut coefficient = 1.0;
        let mut sum = 0.0;
        for n in 0..SERIES_TERMS {
            let n = f64::from(n);
            sum += coefficient * integral(n);
            coefficient *= 0.5 * self.height * (n - 0.5) / (n + 1.0);
        }
        2.0 * SQRT_2 * self.height * self.height.sqrt() * sum
    }

    fn has_series(&self) -> bool {
        self.height < SERIES_HEIGHT
    }

    /// Area $ \theta - s t $.
    pub fn area(&self) -> f64 {
        if self.has_series() {
            return self.series(|n| 1.0 / (n + 1.5));
        }
        self.half_angle - self.half_chord * self.distance
    }

    /// First moment $ \frac{2}{3} s^3 $ about the diameter along the chord.
    pub fn moment(&self) -> f64 {
        self.half_chord.powi(3) / 1.5
    }

    /// Integral of one minus the distance from that diameter: the area minus the first moment.
    pub fn depth_integral(&self) -> f64 {
        if self.has_series() {
            return self.height * self.series(|n| 1.0 / (n + 2.5));
        }
        self.area() - self.moment()
    }

    /// Integral of [`Segment::area`] over the distance from here to 1: $ \frac{2}{3} s^3 - t (\theta - s t) $.
    pub fn area_integral(&self) -> f64 {
        if self.has_series() {
            return self.height * self.series(|n| 1.0 / ((n + 1.5) * (n + 2.5)));
        }
        self.moment() - self.distance * self.area()
    }

    /// Integral of [`Segment::depth_integral`] over the distance from here to 1.
    ///
    /// $$ \frac{2}{3} (1 + t) s^3 - \frac{\theta}{4} + \frac{s t (1 - 2 s^2)}{4} - t (\theta - s t) $$
    pub fn double_depth_integral(&self) -> f64 {
        if self.has_series() {
            let square = self.height * self.height;
            return square * self.series(|n| 1.0 / ((n + 2.5) * (n + 3.5)));
        }
        let (t, s) = (self.distance, self.half_chord);
        let angle = 0.25 * (s * t * (1.0 - 2.0 * s * s) - self.half_angle);
        (1.0 + t) * self.moment() + angle - t * self.area()
    }

    /// Integral of $ (1 - r) \cos \alpha $, with r the distance from the centre and $\alpha$ the angle from the axis.
    ///
    /// $$ \frac{s}{3} + \frac{2}{3} s t^2 - t^2 \ln \frac{1 + s}{|t|} = 2 \sum_{k \ge 2} \frac{s^{2 k + 1}}{4 k^2 - 1} $$
    pub fn exact(&self) -> f64 {
        let s = self.half_chord;
        if s < SERIES_HALF_CHORD {
            return self.exact_series();
        }
        2.0 * Line::of(self.distance).force(s)
    }

    fn exact_series(&self) -> f64 {
        let square = self.half_chord * self.half_chord;
        let mut power = 2.0 * square * square * self.half_chord;
        let mut sum = 0.0;
        for k in 2..CHORD_TERMS {
            let k = f64::from(k);
            sum += power / (4.0 * k * k - 1.0);
            power *= square;
        }
        sum
    }

    /// Minus the derivative of [`Segment::exact`] by the distance: $ 2 t (\ln ((1 + s)/|t|) - s) $.
    pub fn exact_slope(&self) -> f64 {
        let (t, s) = (self.distance, self.half_chord);
        if t == 0.0 {
            return 0.0;
        }
        2.0 * t * (libm::asinh(s / t.abs()) - s)
    }

    /// Integral of $ (1 - r)^2/2 $, which is that of [`Segment::exact`] over the distance from here to 1.
    pub fn exact_energy(&self) -> f64 {
        let line = Line::of(self.distance);
        self.half_angle / 12.0 - 2.0 * self.distance * line.energy(self.half_chord)
    }
}

/// Antiderivatives along the line x = t, zero at y = 0 and odd in y; r is the distance from the origin.
struct Line {
    square: f64,
    distance: f64,
}

#[rendered]
impl Line {
    fn of(distance: f64) -> Self {
        Self {
            square: distance * distance,
            distance: distance.abs(),
        }
    }

    /// Antiderivative of 2 r.
    fn twice_radius(&self, y: f64) -> f64 {
        let radius = (self.square + y * y).sqrt();
        let logarithm = if self.square > 0.0 {
            self.square * libm::asinh(y / self.distance)
        } else {
            0.0
        };
        y * radius + logarithm
    }

    /// Antiderivative of $ (1 - r)^2/2 $, the flux of the force $ (1 - r) \hat r = -\nabla (1 - r)^2/2 $.
    fn force(&self, y: f64) -> f64 {
        0.5 * (y + self.square * y + y * y * y / 3.0 - self.twice_radius(y))
    }

    /// Antiderivative of $ \frac{1}{4} - \frac{r}{3} + \frac{r^2}{8} $: this times the vector r has the divergence $ (1 - r)^2/2 $.
    fn energy(&self, y: f64) -> f64 {
        0.25 * y - self.twice_radius(y) / 6.0 + (self.square * y + y * y * y / 3.0) / 8.0
    }
}

/// How the disc overlaps both of two perpendicular walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shared {
    /// No point of the disc lies beyond both.
    Nothing,
    /// The segment beyond the first wall lies beyond the second.
    First,
    /// The segment beyond the second wall lies beyond the first.
    Second,
    /// All of the disc but two separate segments lies beyond both.
    AllButTwo,
    /// The corner lies in the disc.
    Corner,
}

/// Area and first moments of the part of the disc beyond both walls.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overlap {
    /// Area.
    pub area: f64,
    /// First moments across the first and the second wall.
    pub moments: [f64; 2],
}

/// The disc of radius one at two perpendicular walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    first: Segment,
    second: Segment,
}

#[rendered]
impl Corner {
    /// The corner of two walls that cut off these segments.
    pub fn new(first: Segment, second: Segment) -> Self {
        Self { first, second }
    }

    /// The corner lies in the disc if $ a^2 + b^2 < 1 $; otherwise the signs of the distances decide (peridem Q1).
    fn shared(&self) -> Shared {
        let (a, b) = (self.first.distance, self.second.distance);
        if self.first.is_empty() || self.second.is_empty() {
            return Shared::Nothing;
        }
        if a * a + b * b < 1.0 {
            return Shared::Corner;
        }
        match (a < 0.0, b < 0.0) {
            (false, false) => Shared::Nothing,
            (true, false) => Shared::Second,
            (false, true) => Shared::First,
            (true, true) => Shared::AllButTwo,
        }
    }

    /// Area and first moments of the part beyond both walls.
    pub fn overlap(&self) -> Overlap {
        let (first, second) = (&self.first, &self.second);
        match self.shared() {
            Shared::Nothing => Overlap::default(),
            Shared::First => Overlap {
                area: first.area(),
                moments: [first.moment(), 0.0],
            },
            Shared::Second => Overlap {
                area: second.area(),
                moments: [0.0, second.moment()],
            },
            Shared::AllButTwo => Overlap {
                area: first.area() + second.area() - PI,
                moments: [first.moment(), second.moment()],
            },
            Shared::Corner => self.around_corner(),
        }
    }

    /// A right triangle with legs p, q at the corner, and the segment over its hypotenuse; no difference of large terms.
    ///
    /// $$ S = \frac{p q}{2} + S_1, \quad I_a = \frac{p^2 (b + 2 s_a)}{6}, \quad I_b = \frac{q^2 (a + 2 s_b)}{6} $$
    ///
    /// with $ p = s_a - b $ and $ q = s_b - a $. The area is the printed one with arccos in place of the arcsin of a root, and
    /// the moments are the printed ones in factors.
    fn around_corner(&self) -> Overlap {
        let (a, b) = (&self.first, &self.second);
        let up = a.half_chord - b.distance;
        let along = b.half_chord - a.distance;
        let square = 0.25 * (up * up + along * along);
        let root = (1.0 - square).max(0.0).sqrt();
        let cap = Segment::from_heights(square / (1.0 + root), 1.0 + root);
        Overlap {
            area: 0.5 * up * along + cap.area(),
            moments: [
                up * up * (b.distance + 2.0 * a.half_chord) / 6.0,
                along * along * (a.distance + 2.0 * b.half_chord) / 6.0,
            ],
        }
    }

    /// Integral of $ (1 - r) \hat r $ over the part of the disc beyond either wall: components across both walls.
    ///
    /// By the divergence theorem it is the flux of $ (1 - r)^2/2 $ through the exposed part of either wall.
    pub fn exact(&self) -> [f64; 2] {
        [
            Self::exposed_force(&self.first, self.second.distance),
            Self::exposed_force(&self.second, self.first.distance),
        ]
    }

    /// The end of the part of a wall in the disc that does not lie beyond the other wall, if there is one.
    fn exposed_end(wall: &Segment, other: f64) -> Option<f64> {
        (other > -wall.half_chord).then_some(other.min(wall.half_chord))
    }

    fn exposed_force(wall: &Segment, other: f64) -> f64 {
        let line = Line::of(wall.distance);
        match Self::exposed_end(wall, other) {
            Some(end) if end < wall.half_chord => line.force(end) + line.force(wall.half_chord),
            Some(_) => wall.exact(),
            None => 0.0,
        }
    }

    /// Integral of $ (1 - r)^2/2 $ over the part of the disc beyond either wall.
    pub fn exact_energy(&self) -> f64 {
        let edges = Self::exposed_energy(&self.first, self.second.distance)
            + Self::exposed_energy(&self.second, self.first.distance);
        self.arc() / 24.0 - edges
    }

    fn exposed_energy(wall: &Segment, other: f64) -> f64 {
        let line = Line::of(wall.distance);
        Self::exposed_end(wall, other).map_or(0.0, |end| {
            wall.distance * (line.energy(end) + line.energy(wall.half_chord))
        })
    }

    /// Angle of the arc beyond either wall.
    fn arc(&self) -> f64 {
        let (first, second) = (self.first.half_angle, self.second.half_angle);
        match self.shared() {
            Shared::Nothing => 2.0 * (first + second),
            Shared::First => 2.0 * second,
            Shared::Second => 2.0 * first,
            Shared::AllButTwo => 2.0 * PI,
            Shared::Corner => first + second + FRAC_PI_2,
        }
    }
}
