//! Search for a maximum in the unit cube.

/// First and smallest step.
const STEPS: [f64; 2] = [0.125, 1e-4];

/// Climb from a place to a maximum, along one coordinate at a time, with steps that are halved where none helps; the
/// height that is reached and its place.
pub fn climb(start: Vec<f64>, height: &dyn Fn(&[f64]) -> f64) -> (f64, Vec<f64>) {
    let (mut best, mut place) = (height(&start), start);
    let [mut step, smallest] = STEPS;
    while step > smallest {
        let mut is_higher = false;
        for (k, change) in (0..place.len()).flat_map(|k| [(k, step), (k, -step)]) {
            let mut trial = place.clone();
            trial[k] = (trial[k] + change).clamp(0.0, 1.0);
            let height = height(&trial);
            if height > best {
                (best, place, is_higher) = (height, trial, true);
            }
        }
        if !is_higher {
            step *= 0.5;
        }
    }
    (best, place)
}
