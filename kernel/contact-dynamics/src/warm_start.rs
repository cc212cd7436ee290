//! First guesses of the impulses, from the previous step.

use crate::detection::Feature;
use crate::local::Components;
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;

/// What identifies a contact point in the next step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointKey {
    /// The two bodies. Walls are counted after all bodies.
    pub pair: Pair,
    /// The vertex that makes the point.
    pub feature: Feature,
    /// Vector from the centre of the body `pair.i` to the point in m.
    pub place: Vec2,
}

/// The contact points of the latest step and their impulses, in order of pairs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Memory {
    keys: Vec<PointKey>,
    impulses: Vec<Components>,
    is_taken: Vec<bool>,
}

impl Memory {
    /// No contact points.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.keys.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty()
    }

    /// Forget all points.
    pub fn clear(&mut self) {
        self.keys.clear();
        self.impulses.clear();
    }

    /// Remember a point. Points come in order of pairs.
    pub fn push(&mut self, key: PointKey, impulse: Components) {
        self.keys.push(key);
        self.impulses.push(impulse);
    }

    /// The points with their impulses.
    pub fn iter(&self) -> impl Iterator<Item = (&PointKey, &Components)> {
        self.keys.iter().zip(&self.impulses)
    }

    /// The impulses of the same points in the previous step, or zero, one per key.
    ///
    /// Of the points of the same pair, the one with the same feature is the same; without it, the nearest within a
    /// distance in m (the lower index on a tie). No impulse is used twice.
    pub fn guess(&mut self, new: &[PointKey], distance: f64, guesses: &mut Vec<Components>) {
        guesses.clear();
        guesses.resize(new.len(), Components::default());
        self.is_taken.clear();
        self.is_taken.resize(self.keys.len(), false);
        let (mut old_start, mut start) = (0, 0);
        while start < new.len() {
            let pair = new[start].pair;
            let end = start
                + new[start..]
                    .iter()
                    .take_while(|key| key.pair == pair)
                    .count();
            while old_start < self.keys.len() && self.keys[old_start].pair < pair {
                old_start += 1;
            }
            let is_same = |key: &&PointKey| key.pair == pair;
            let old_end = old_start + self.keys[old_start..].iter().take_while(is_same).count();
            let old = old_start..old_end;
            self.guess_pair(old, &new[start..end], distance, &mut guesses[start..end]);
            (old_start, start) = (old_end, end);
        }
    }

    fn guess_pair(
        &mut self,
        old: core::ops::Range<usize>,
        new: &[PointKey],
        distance: f64,
        guesses: &mut [Components],
    ) {
        for (key, guess) in new.iter().zip(&mut *guesses) {
            let same = old.clone().find(|&k| self.keys[k].feature == key.feature);
            if let Some(k) = same {
                *guess = self.impulses[k];
                self.is_taken[k] = true;
            }
        }
        for (key, guess) in new.iter().zip(guesses) {
            if old.clone().any(|k| self.keys[k].feature == key.feature) {
                continue;
            }
            let mut nearest = (distance, None);
            for k in old.clone().filter(|&k| !self.is_taken[k]) {
                let apart = (self.keys[k].place - key.place).norm();
                if apart < nearest.0 {
                    nearest = (apart, Some(k));
                }
            }
            if let Some(k) = nearest.1 {
                *guess = self.impulses[k];
                self.is_taken[k] = true;
            }
        }
    }
}
