//! How much of a grain is damaged, and into how many pieces it fell.

use crate::bonds::Bonds;
use crate::grain::Grains;
use gouge_common::estimators::connected;

/// Damage of a grain: the mean over its nodes of [`Bonds::damage`], section 7.4 of peridem.
pub fn grain_damage(grains: &Grains, bonds: &Bonds, grain: usize) -> f64 {
    let nodes = grains.rows[grain].nodes.clone();
    let number = nodes.len() as f64;
    nodes.map(|node| bonds.damage(node)).sum::<f64>() / number
}

/// Bulk damage: the mean damage of all grains, whatever their sizes are, section 7.4 of peridem; zero without grains.
pub fn bulk_damage(grains: &Grains, bonds: &Bonds) -> f64 {
    let number = grains.rows.len();
    let sum: f64 = (0..number)
        .map(|grain| grain_damage(grains, bonds, grain))
        .sum();
    sum / number.max(1) as f64
}

/// Area in m^2 of the nodes of a grain that lost a bond, section 6.3 of peridem.
pub fn softened_area(grains: &Grains, bonds: &Bonds, grain: usize) -> f64 {
    let nodes = grains.rows[grain].nodes.clone();
    let softened = nodes.filter(|&node| bonds.damage(node) > 0.0);
    softened.fold(0.0, |sum, node| sum + grains.area[node])
}

/// Number of pieces of a grain: sets of nodes connected by bonds, with more than the given fraction of its nodes.
pub fn pieces(grains: &Grains, bonds: &Bonds, grain: usize, fraction: f64) -> usize {
    let nodes = grains.rows[grain].nodes.clone();
    let first = nodes.start;
    let own = |later: usize| {
        let row = bonds.with_earlier(later);
        row.map(move |(earlier, _)| (earlier - first, later - first))
    };
    let parts = connected(nodes.len(), nodes.clone().flat_map(own));
    let mut sizes = vec![0_usize; parts.number];
    for part in parts.label {
        sizes[part] += 1;
    }
    let least = fraction * nodes.len() as f64;
    sizes.iter().filter(|&&size| size as f64 > least).count()
}
