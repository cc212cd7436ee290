//! Distances between nodes.

use gouge_common::geometry::Vec2;

/// Smallest distance between two points in m: the mesh size of peridem. None for fewer than two points.
///
/// Cost: sorting, and the pairs in strips as wide as the result, across the longer side of the bounding box.
pub fn smallest_distance(points: &[Vec2]) -> Option<f64> {
    let extent = |coordinate: fn(&Vec2) -> f64| {
        let values = points.iter().map(coordinate);
        let range = (f64::INFINITY, f64::NEG_INFINITY);
        let (least, most) = values.fold(range, |(a, b), value| (a.min(value), b.max(value)));
        most - least
    };
    let mut sorted = points.to_vec();
    if extent(|point| point.y) > extent(|point| point.x) {
        let exchange = |point: &mut Vec2| *point = Vec2::new(point.y, point.x);
        sorted.iter_mut().for_each(exchange);
    }
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut smallest: Option<f64> = None;
    for (k, &point) in sorted.iter().enumerate() {
        for &other in &sorted[k + 1..] {
            let limit = smallest.unwrap_or(f64::INFINITY);
            if other.x - point.x >= limit {
                break;
            }
            smallest = Some(limit.min((other - point).norm()));
        }
    }
    smallest
}
