//! Fewer points for figures, without a visible difference.

use std::collections::BTreeSet;
use std::ops::Range;

/// Number of points up to which a curve is drawn as it is.
const FEW: usize = 3000;
/// Places that can be told apart along each axis: about two per unit of a figure.
const PLACES: f64 = 2400.0;

/// The points of a curve, thinned out if there are many. A line keeps the first, the last, the lowest
/// and the highest of successive points at the same place of the horizontal axis; marks keep one point
/// per place.
pub fn thin(
    points: Vec<(f64, f64)>,
    (x, y): (&Range<f64>, &Range<f64>),
    is_line: bool,
) -> Vec<(f64, f64)> {
    if points.len() <= FEW {
        return points;
    }
    let along = |range: &Range<f64>, value: f64| {
        (PLACES * (value - range.start) / (range.end - range.start)) as i64
    };
    if is_line {
        let same = |a: &(f64, f64), b: &(f64, f64)| along(x, a.0) == along(x, b.0);
        return points.chunk_by(same).flat_map(outline).collect();
    }
    let mut taken = BTreeSet::new();
    let is_new = |point: &(f64, f64)| taken.insert((along(x, point.0), along(y, point.1)));
    points.into_iter().filter(is_new).collect()
}

/// First, last, lowest and highest of some points, each once, in their order.
fn outline(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let lowest = (0..points.len()).min_by(|&a, &b| points[a].1.total_cmp(&points[b].1));
    let highest = (0..points.len()).max_by(|&a, &b| points[a].1.total_cmp(&points[b].1));
    let kept = [Some(0), lowest, highest, points.len().checked_sub(1)];
    let kept: BTreeSet<usize> = kept.into_iter().flatten().collect();
    kept.into_iter().map(|place| points[place]).collect()
}

#[cfg(test)]
mod tests {
    use super::thin;

    #[test]
    fn few_points_are_kept_as_they_are() {
        let points: Vec<(f64, f64)> = (0..3000).map(|i| (f64::from(i), 1.0)).collect();
        let ranges = (&(0.0..1e6), &(0.0..1e6));
        assert_eq!(thin(points.clone(), ranges, true), points);
    }

    #[test]
    fn a_thinned_line_keeps_its_ends_and_its_narrow_peaks() {
        let mut points: Vec<(f64, f64)> = (0..1_000_000)
            .map(|i| (1e-6 * f64::from(i), (1e-3 * f64::from(i)).sin()))
            .collect();
        points[123_456].1 = 7.0;
        points[654_321].1 = -7.0;
        let thinned = thin(points.clone(), (&(0.0..1.0), &(-7.0..7.0)), true);
        assert!(thinned.len() < 10_000, "{}", thinned.len());
        for kept in [0, 123_456, 654_321, 999_999] {
            assert!(thinned.contains(&points[kept]), "{kept}");
        }
        assert!(thinned.windows(2).all(|two| two[0].0 < two[1].0));
    }

    #[test]
    fn thinned_marks_leave_no_place_empty() {
        let points: Vec<(f64, f64)> = (0..100_000)
            .map(|i| (f64::from(i % 100), f64::from(i % 7)))
            .collect();
        let thinned = thin(points, (&(0.0..100.0), &(0.0..7.0)), false);
        assert_eq!(thinned.len(), 700);
    }
}
