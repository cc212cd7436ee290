//! Random numbers.

use rand::RngExt;
use rand_pcg::Pcg64;

/// The stream of random numbers for one purpose. Streams are independent, so that no result depends on how many
/// numbers another purpose uses.
pub fn random(seed: u64, purpose: u128) -> impl FnMut() -> f64 {
    let mut source = Pcg64::new(u128::from(seed), purpose);
    move || source.random::<f64>()
}
