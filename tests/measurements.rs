//! Statistics of stored measurements.

use approx::assert_relative_eq;
use gouge_validation::measurements::{Paired, friction_runs};

#[test]
fn paired_statistics_are_those_of_the_textbook() {
    // Student's sleep data (Biometrika 6, 1908), with the results of R: t = 4.0621 with 9 degrees of freedom,
    // p = 0.002833, interval 0.7001142 to 2.4598858. All nine signs are equal: p = 2 / 2^9.
    let sleep = [1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4];
    let paired = Paired::new(sleep.to_vec());
    assert_eq!(paired.number(), 10);
    assert_relative_eq!(paired.mean(), 1.58, max_relative = 1e-14);
    let [low, high] = paired.interval(0.95);
    assert_relative_eq!(low, 0.700_114_2, max_relative = 1e-7);
    assert_relative_eq!(high, 2.459_885_8, max_relative = 1e-7);
    assert_relative_eq!(paired.p_by_t(), 0.002_833, max_relative = 2e-4);
    assert_relative_eq!(paired.p_by_signs(), 2.0 / 512.0, max_relative = 1e-12);
}

#[test]
fn every_seed_of_the_fault_was_run_with_both_moments_of_inertia() {
    let (_, runs) = friction_runs().expect("the stored runs can be read");
    assert!(runs.len() >= 32, "{} runs", runs.len());
    for (seed, pair) in runs.chunks(2).enumerate() {
        let factors: Vec<f64> = pair.iter().map(|run| run.inertia_factor).collect();
        assert_eq!(factors, [0.4, 0.6]);
        for run in pair {
            assert_eq!(run.seed, seed as u64);
            let numbers = [run.friction_load, run.friction_feedback, run.bonds_broken];
            assert!(numbers.iter().all(|number| number.is_finite()), "{run:?}");
        }
    }
}
