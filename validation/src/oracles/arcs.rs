//! The fraction of a circle inside a rectangle, from its intersections with the edges.

use std::f64::consts::TAU;

/// A rectangle with a corner at the origin; without a width it is a strip.
#[derive(Clone, Copy, Debug)]
pub struct Rectangle {
    /// Horizontal side; a strip has none.
    pub width: Option<f64>,
    /// Vertical side.
    pub height: f64,
}

impl Rectangle {
    fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let across = |width: f64| (0.0..=width).contains(&x);
        (0.0..=self.height).contains(&y) && self.width.is_none_or(across)
    }

    /// Fraction of the circle around a point that lies inside: the angles at which the circle
    /// intersects the lines of the edges divide it into arcs, and the midpoint of each arc decides
    /// whether it is inside.
    pub fn fraction_inside(&self, [x, y]: [f64; 2], radius: f64) -> f64 {
        let mut angles = vec![0.0, TAU];
        let mut cut = |angle: f64| angles.push(angle.rem_euclid(TAU));
        for offset in [-y, self.height - y] {
            if offset.abs() < radius {
                let angle = (offset / radius).asin();
                cut(angle);
                cut(TAU / 2.0 - angle);
            }
        }
        for offset in self.width.map_or(vec![], |width| vec![-x, width - x]) {
            if offset.abs() < radius {
                let angle = (offset / radius).acos();
                cut(angle);
                cut(-angle);
            }
        }
        angles.sort_by(f64::total_cmp);
        let arcs = angles.windows(2).filter(|ends| {
            let (sine, cosine) = (0.5 * (ends[0] + ends[1])).sin_cos();
            self.contains([x + radius * cosine, y + radius * sine])
        });
        arcs.map(|ends| ends[1] - ends[0]).sum::<f64>() / TAU
    }
}

#[cfg(test)]
mod tests {
    use super::Rectangle;
    use approx::assert_abs_diff_eq;

    #[test]
    fn a_corner_sees_a_quarter_and_an_edge_a_half() {
        let square = Rectangle {
            width: Some(2.0),
            height: 2.0,
        };
        assert_abs_diff_eq!(
            square.fraction_inside([0.0, 0.0], 1.0),
            0.25,
            epsilon = 1e-15
        );
        assert_abs_diff_eq!(
            square.fraction_inside([1.0, 0.0], 0.5),
            0.5,
            epsilon = 1e-15
        );
        assert_abs_diff_eq!(
            square.fraction_inside([1.0, 1.0], 0.5),
            1.0,
            epsilon = 1e-15
        );
    }
}
