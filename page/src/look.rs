//! How curves of a figure differ: by colour, by dashes and by the shape of marks.

use plotters::style::RGBColor;

/// Width of lines in units of the figure.
pub const LINE: u32 = 5;
/// Width of thin dashed lines in units of the figure.
pub const THIN: u32 = 3;
/// Radius of marks in units of the figure.
pub const MARK: f64 = 10.0;
/// Dash and gap of thin dashed lines, in units of the figure.
pub const DASHED: (u32, u32) = (14, 10);
/// Colour of axes and guides.
pub const GREY: RGBColor = RGBColor(90, 90, 90);

/// Colours that are distinguishable with colour blindness, after Okabe and Ito, with grey and brown
/// instead of their yellow and orange, which are too light for lines.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(120, 120, 120),
    RGBColor(86, 180, 233),
    RGBColor(150, 110, 0),
    RGBColor(0, 0, 0),
];

/// Dash and gap of lines in units of the figure; the first is solid.
const DASHES: [(u32, u32); 4] = [(1, 0), (40, 12), (5, 9), (20, 16)];

/// Corners of marks in units of their radius; without corners a mark is a disc.
const SHAPES: [&[(f64, f64)]; 6] = [
    &[],
    &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
    &[(0.0, -1.3), (1.15, 0.8), (-1.15, 0.8)],
    &[(0.0, -1.4), (1.1, 0.0), (0.0, 1.4), (-1.1, 0.0)],
    &[(0.0, 1.3), (1.15, -0.8), (-1.15, -0.8)],
    &[
        (-1.2, -0.4),
        (-0.4, -0.4),
        (-0.4, -1.2),
        (0.4, -1.2),
        (0.4, -0.4),
        (1.2, -0.4),
        (1.2, 0.4),
        (0.4, 0.4),
        (0.4, 1.2),
        (-0.4, 1.2),
        (-0.4, 0.4),
        (-1.2, 0.4),
    ],
];

/// How one curve looks.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Its colour.
    pub colour: RGBColor,
    /// Dash and gap of its line; a solid line has no gap.
    pub dashes: (u32, u32),
    /// Corners of its marks in units of their radius; a disc has none.
    pub corners: &'static [(f64, f64)],
}

impl Look {
    /// The look of the guide at a position in its figure.
    pub fn of_guide(position: usize) -> Self {
        Self {
            colour: GREY,
            dashes: DASHES[position % DASHES.len()],
            corners: &[],
        }
    }

    /// The look of the curve at a position in its figure.
    pub fn of(position: usize) -> Self {
        let round = position / COLOURS.len();
        Self {
            colour: COLOURS[position % COLOURS.len()],
            dashes: DASHES[(position + round) % DASHES.len()],
            corners: SHAPES[(position + round) % SHAPES.len()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Look;
    use std::collections::BTreeSet;

    #[test]
    fn neighbouring_curves_differ_without_their_colours() {
        for position in 0..30 {
            let (a, b) = (Look::of(position), Look::of(position + 1));
            assert!(a.dashes != b.dashes && a.corners != b.corners, "{position}");
        }
        let looks = (0..24).map(Look::of);
        let distinct: BTreeSet<_> = looks.map(|l| (l.colour.0, l.colour.1, l.dashes)).collect();
        assert_eq!(distinct.len(), 24);
    }
}
