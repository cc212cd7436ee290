//! Points of scrambled Sobol sequences, which fill the unit cube more evenly than random ones.

/// Most points of a sequence.
pub const MOST: u32 = 1 << 16;

/// The first points of a sequence in the unit cube; other seeds give independent sequences.
pub fn points(number: u32, dimensions: usize, seed: u32) -> impl Iterator<Item = Vec<f64>> {
    (0..number.min(MOST)).map(move |index| point(index, dimensions, seed))
}

/// A point of a sequence, inside the unit cube.
fn point(index: u32, dimensions: usize, seed: u32) -> Vec<f64> {
    // The library has 2^24 equidistant values in [0, 1); their middles exclude both ends.
    let half = 0.5_f64.powi(25);
    let coordinate = |dimension| f64::from(sobol_burley::sample(index, dimension, seed)) + half;
    (0..dimensions as u32).map(coordinate).collect()
}
