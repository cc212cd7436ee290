//! Bonds as lists of pairs of nodes.

use crate::error::Fault;
use crate::fields::Fields;
use gouge_common::geometry::Vec2;
use std::collections::HashMap;

/// Pairs of nodes at some positions: two nodes at different places each, and no pair twice.
pub(super) fn read(list: &[Fields], position: &[Vec2]) -> Result<Vec<[usize; 2]>, Fault> {
    let mut known = HashMap::new();
    let mut pairs = Vec::with_capacity(list.len());
    for (place, item) in list.iter().enumerate() {
        let [i, j] = item.as_pair(position.len())?;
        if i == j {
            return Err(item.refuse("two different nodes"));
        }
        let distance = (position[j] - position[i]).norm();
        if !(distance > 0.0 && distance.is_finite()) {
            return Err(item.refuse("two nodes at a positive, finite distance"));
        }
        if let Some(before) = known.insert([i.min(j), i.max(j)], place) {
            let accepted =
                format!("a pair that is not listed twice, but item {before} is the same");
            return Err(item.refuse(accepted));
        }
        pairs.push([i, j]);
    }
    Ok(pairs)
}
