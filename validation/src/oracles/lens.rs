//! The lens of two intersecting circles or spheres, in double-double.

use std::f64::consts::PI;
use xprec::Df64;

/// Two intersecting circles or spheres.
#[derive(Clone, Copy, Debug)]
pub struct Lens {
    radii: [Df64; 2],
    distance: Df64,
    /// Distances of the centres from the chord, negative beyond it.
    chord: [Df64; 2],
    half_chord: Df64,
}

/// Average distance from a point to a segment of half-length z at height y, whose ends are both at
/// distance r.
pub fn mean_distance(r: f64, y: f64) -> Df64 {
    let (r, y) = (Df64::from(r), Df64::from(y.abs()));
    let z = ((r - y) * (r + y)).sqrt();
    if f64::from(z) == 0.0 {
        return r;
    }
    if f64::from(y) == 0.0 {
        return r * 0.5;
    }
    (r + y * y / z * ((r + z) / y).ln()) * 0.5
}

impl Lens {
    /// The lens of two circles with the given radii and distance of their centres.
    pub fn new(radii: [f64; 2], distance: f64) -> Self {
        let [a, b] = radii.map(Df64::from);
        let d = Df64::from(distance);
        let first = (d * d + (a - b) * (a + b)) / (d * 2.0);
        // Heron's formula: half the chord is the height of the triangle of the two centres and an
        // intersection.
        let heron = (d + a + b) * (d + a - b) * (d - a + b) * (a + b - d);
        Self {
            radii: [a, b],
            distance: d,
            chord: [first, d - first],
            half_chord: if f64::from(heron) > 0.0 {
                heron.sqrt() / (d * 2.0)
            } else {
                Df64::from(0.0)
            },
        }
    }

    /// Volume common to two spheres.
    pub fn volume(&self) -> Df64 {
        let ([a, b], d) = (self.radii, self.distance);
        let depth = a + b - d;
        depth * depth * (d * d + d * (a + b) * 2.0 - (a - b) * (a - b) * 3.0) / (d * 12.0) * PI
    }

    /// Scale of the terms of which the volume is a sum: caps, the wall between them times the larger
    /// distance of a centre, and the volume enclosed by spheres that overlap by one rounding of their
    /// distance.
    pub fn volume_scale(&self) -> f64 {
        let cap = |end: usize| {
            let (r, y) = (f64::from(self.radii[end]), f64::from(self.chord[end]));
            PI / 3.0 * (2.0 * r + y) * (r - y) * (r - y)
        };
        let z = f64::from(self.half_chord);
        let rounding = f64::EPSILON * self.farther();
        let enclosed = PI * f64::from(self.distance) * rounding * rounding;
        cap(0).abs() + cap(1).abs() + PI * z * z * self.farther() + enclosed / f64::EPSILON
    }

    /// Area common to two circles.
    pub fn area(&self) -> Df64 {
        let segment = |end: usize| {
            let (r, y) = (self.radii[end], self.chord[end]);
            self.half_chord.atan2(y) * r * r - y * self.half_chord
        };
        segment(0) + segment(1)
    }

    /// Scale of the terms of which the area is a sum, with the amplification of an inverse cosine.
    pub fn area_scale(&self) -> f64 {
        let z = f64::from(self.half_chord);
        let sector = |end: usize| {
            let (r, y) = (f64::from(self.radii[end]), f64::from(self.chord[end]));
            let angle = z.atan2(y);
            r * r * (angle + y.abs() / z) + y.abs() * z
        };
        let rounding = f64::EPSILON * self.farther();
        let enclosed = (2.0 * self.smaller() * rounding).sqrt() * rounding;
        sector(0) + sector(1) + 2.0 * z * self.farther() + enclosed / f64::EPSILON
    }

    fn smaller(&self) -> f64 {
        f64::from(self.radii[0]).min(f64::from(self.radii[1]))
    }

    fn farther(&self) -> f64 {
        f64::from(self.chord[0])
            .abs()
            .max(f64::from(self.chord[1]).abs())
    }
}
