//! The part of a circle that lies in a rectangle, from the points where it crosses the edges.

use std::f64::consts::TAU;

/// Fraction of the circle around a point that lies in [0, width] x [0, height]; any x where the width is
/// infinite.
pub fn fraction_inside([x, y]: [f64; 2], radius: f64, [width, height]: [f64; 2]) -> f64 {
    let mut cuts = vec![0.0, TAU];
    let mut crossing = |sine: f64, quarter: f64| {
        if sine.abs() < 1.0 {
            let angle = sine.asin();
            cuts.extend(
                [angle + quarter, std::f64::consts::PI - angle + quarter]
                    .map(|cut| cut.rem_euclid(TAU)),
            );
        }
    };
    crossing(-y / radius, 0.0);
    crossing((height - y) / radius, 0.0);
    if width.is_finite() {
        crossing(-x / radius, -std::f64::consts::FRAC_PI_2);
        crossing((width - x) / radius, -std::f64::consts::FRAC_PI_2);
    }
    cuts.sort_by(f64::total_cmp);
    let inside = |angle: f64| {
        let (dx, dy) = (radius * angle.cos(), radius * angle.sin());
        let across = !width.is_finite() || (0.0..=width).contains(&(x + dx));
        across && (0.0..=height).contains(&(y + dy))
    };
    let arcs = cuts
        .windows(2)
        .filter(|arc| inside(0.5 * (arc[0] + arc[1])));
    arcs.map(|arc| arc[1] - arc[0]).sum::<f64>() / TAU
}

/// Number of connected components of a graph, by walking it.
pub fn components(nodes: usize, edges: &[(usize, usize)]) -> usize {
    let mut neighbours = vec![Vec::new(); nodes];
    for &(a, b) in edges {
        neighbours[a].push(b);
        neighbours[b].push(a);
    }
    let mut seen = vec![false; nodes];
    let mut number = 0;
    for first in 0..nodes {
        if seen[first] {
            continue;
        }
        number += 1;
        let mut open = vec![first];
        while let Some(node) = open.pop() {
            if !std::mem::replace(&mut seen[node], true) {
                open.extend(&neighbours[node]);
            }
        }
    }
    number
}
