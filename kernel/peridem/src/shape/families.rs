//! The shapes of section 7.2 of peridem, inscribed in a disc around the origin.

use super::Outline;
use crate::error::{SetupError, require};
use core::f64::consts::{FRAC_1_SQRT_2, TAU};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

#[rendered]
impl Outline {
    /// Regular polygon with a circumradius R in m, as a disc.
    ///
    /// $$ x_k = R \, (\cos 2 \pi k/N, \ \sin 2 \pi k/N) $$
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius that is not positive, [`SetupError::TooFewVertices`] below 3 sides.
    pub fn disc(radius: f64, sides: usize) -> Result<Self, SetupError> {
        Self::new(regular(radius, sides)?, Vec::new(), Vec::new())
    }

    /// Square with sides of $\sqrt 2 R$ along the axes, for a circumradius R in m.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius that is not positive.
    pub fn square(radius: f64) -> Result<Self, SetupError> {
        require("radius", radius, "positive", radius > 0.0)?;
        let half = radius * FRAC_1_SQRT_2;
        Self::new(
            quarter_turns(&[Vec2::new(half, -half)]),
            Vec::new(),
            Vec::new(),
        )
    }

    /// Plus with arms along the axes, for a circumradius R in m.
    ///
    /// $$ a = \frac{c R}{\sqrt 2}, \qquad b = \sqrt{R^2 - a^2} $$
    ///
    /// are half the width and the length of an arm: the four re-entrant vertices $(\pm a, \pm a)$ have the distance
    /// $c R$ from the centre, and the eight outer ones $(\pm b, \pm a)$, $(\pm a, \pm b)$ the distance R. The area is
    /// $ c^2 R^2 (4 \sqrt{2/c^2 - 1} - 2) $ (erratum P7 of peridem). The ratio c of radii is dimensionless.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius that is not positive or a ratio that is not between 0 and 1.
    pub fn plus(radius: f64, ratio: f64) -> Result<Self, SetupError> {
        require("radius", radius, "positive", radius > 0.0)?;
        let accepted = ratio > 0.0 && ratio < 1.0;
        require("ratio", ratio, "above 0 and below 1", accepted)?;
        let half_width = ratio * radius * FRAC_1_SQRT_2;
        let length = (radius * radius - half_width * half_width).sqrt();
        let arm = [
            Vec2::new(length, -half_width),
            Vec2::new(length, half_width),
            Vec2::new(half_width, half_width),
        ];
        Self::new(quarter_turns(&arm), Vec::new(), Vec::new())
    }

    /// Ring between two regular polygons with parallel sides, for a circumradius R in m.
    ///
    /// The ratio $\tau$ of inner and outer radius is dimensionless.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius that is not positive or a ratio that is not between 0 and 1,
    /// [`SetupError::TooFewVertices`] below 3 sides.
    #[doc(alias = "ring")]
    pub fn annulus(radius: f64, ratio: f64, sides: usize) -> Result<Self, SetupError> {
        let accepted = ratio > 0.0 && ratio < 1.0;
        require("ratio", ratio, "above 0 and below 1", accepted)?;
        let hole = regular(ratio * radius, sides)?;
        Self::new(regular(radius, sides)?, vec![hole], Vec::new())
    }

    /// Disc whose radius is reduced at random, for a circumradius of at most R in m.
    ///
    /// $$ r_k = R \, (1 - X_k), \qquad X_k = (1 - \varphi) \, U_k, \qquad k = 0 \ldots N - 1 $$
    ///
    /// at equal angles, with numbers $U_k$ in [0, 1] from the caller. The source uses 20 vertices and a roundness
    /// $\varphi = 0.6$ (dimensionless). The mean area for uniform numbers is
    /// $ \frac{N}{2} \sin \frac{2 \pi}{N} R^2 \left(\frac{1 + \varphi}{2}\right)^2 $ (erratum P7 of peridem).
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius that is not positive, a roundness that is not above 0 and at most 1, or a
    /// number outside [0, 1]; [`SetupError::TooFewVertices`] below 3 numbers; [`SetupError::SelfIntersection`] is
    /// impossible but for rounding.
    pub fn perturbed_disc(
        radius: f64,
        roundness: f64,
        uniform: &[f64],
    ) -> Result<Self, SetupError> {
        let accepted = roundness > 0.0 && roundness <= 1.0;
        require("roundness", roundness, "above 0 and at most 1", accepted)?;
        for &number in uniform {
            let accepted = (0.0..=1.0).contains(&number);
            require("uniform number", number, "from 0 to 1", accepted)?;
        }
        let vertices = regular(radius, uniform.len())?;
        let moved = vertices.iter().zip(uniform);
        let outer = moved.map(|(&vertex, &number)| vertex * (1.0 - (1.0 - roundness) * number));
        Self::new(outer.collect(), Vec::new(), Vec::new())
    }
}

/// Vertices of a regular polygon, the first on the x axis.
fn regular(radius: f64, sides: usize) -> Result<Vec<Vec2>, SetupError> {
    require("radius", radius, "positive", radius > 0.0)?;
    let vertex = |k: usize| {
        let (sin, cos) = libm::sincos(TAU * k as f64 / sides as f64);
        Vec2::new(cos, sin) * radius
    };
    Ok((0..sides).map(vertex).collect())
}

/// Points turned by 0, 90, 180 and 270 degrees.
fn quarter_turns(points: &[Vec2]) -> Vec<Vec2> {
    let turned = |turns: usize| {
        let turn = move |point: Vec2| (0..turns).fold(point, |point, _| point.perpendicular());
        points.iter().map(move |&point| turn(point))
    };
    (0..4).flat_map(turned).collect()
}
