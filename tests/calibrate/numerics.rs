//! Emulators, posteriors and recoveries of models whose answers are known.

use gouge_studies::calibrate::{
    Emulator, Form, GaussianProcess, Measured, Observed, Posterior, Prediction, Recovery,
    Repetition, Sample,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// A smooth function of two variables in the unit cube.
fn smooth(x: &[f64]) -> f64 {
    (3.0 * x[0]).sin() + x[1] * x[1] * (1.0 + x[0])
}

/// A standard normal number, by Box and Muller.
fn normal(random: &mut Pcg64) -> f64 {
    let (u, v): (f64, f64) = (1.0 - random.random::<f64>(), random.random());
    (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
}

fn random_points(random: &mut Pcg64, number: usize) -> Vec<Vec<f64>> {
    let mut point = || vec![random.random::<f64>(), random.random()];
    (0..number).map(|_| point()).collect()
}

/// Samples of the function, each value with normal scatter.
fn samples(random: &mut Pcg64, number: usize, seeds: usize, scatter: f64) -> Vec<Sample> {
    let points = random_points(random, number);
    let sample = |point: Vec<f64>| Sample {
        values: (0..seeds)
            .map(|_| smooth(&point) + scatter * normal(random))
            .collect(),
        point,
    };
    points.into_iter().map(sample).collect()
}

#[test]
fn a_process_interpolates_a_smooth_function_within_its_stated_errors() {
    let mut random = Pcg64::seed_from_u64(1);
    let known = random_points(&mut random, 40).into_iter();
    let observed = known.filter_map(|point| Observed::of(&point, &[smooth(&point)]));
    let process = GaussianProcess::fit(observed.collect()).expect("forty points");
    let (mut inside, mut worst) = (0, 0.0_f64);
    for point in random_points(&mut random, 400) {
        let found = process.at(&point);
        let error = (found.mean - smooth(&point)).abs();
        inside += usize::from(error < 1.645 * found.variance.sqrt());
        worst = worst.max(error);
    }
    // Errors at neighbouring points are alike, so the share varies more than that of independent ones.
    assert!(inside >= 320, "{inside} of 400");
    assert!(worst < 0.05, "{worst}");
}

#[test]
fn scatter_of_seeds_is_told_from_the_error_of_the_emulator() {
    let mut random = Pcg64::seed_from_u64(2);
    let emulator = Emulator::fit(&samples(&mut random, 50, 4, 0.1), Form::Linear, None);
    let emulator = emulator.expect("fifty points");
    let scatter = emulator.at(&[0.5, 0.5]).scatter.sqrt();
    // 150 degrees of freedom: the standard deviation is known to 6 %.
    assert!((scatter / 0.1 - 1.0).abs() < 0.18, "{scatter}");
    let points = random_points(&mut random, 400);
    let covered = points.iter().filter(|point| {
        let found = emulator.at(point);
        (found.mean - smooth(point)).abs() < 1.645 * found.variance.sqrt()
    });
    let covered = covered.count();
    assert!((300..=400).contains(&covered), "{covered} of 400");
    // The mean of 200 values over two dimensions is known better than any of them.
    assert!(emulator.at(&[0.5, 0.5]).variance.sqrt() < 0.04);
    let left_out = emulator.leave_one_out();
    let inside = left_out.iter().filter(|one| one.standardised.abs() < 1.645);
    let inside = inside.count();
    // Between the 0.1 % and the 99.9 % quantile of a binomial distribution of 50 and 0.9.
    assert!((37..=50).contains(&inside), "{inside} of 50");
}

#[test]
fn logarithms_and_closed_forms_leave_nothing_to_a_process_that_they_explain() {
    let mut random = Pcg64::seed_from_u64(3);
    let law = |x: &[f64]| 1e9 * (4.0 * x[0] - 2.0 * x[1]).exp();
    let samples: Vec<Sample> = random_points(&mut random, 12)
        .into_iter()
        .map(|point| Sample {
            values: vec![law(&point)],
            point,
        })
        .collect();
    let exact = Emulator::fit(&samples, Form::Linear, Some(std::sync::Arc::new(law)));
    let exact = exact.expect("twelve points").at(&[0.9, 0.1]);
    let truth = law(&[0.9, 0.1]);
    assert!((exact.mean / truth - 1.0).abs() < 1e-12 && exact.variance.sqrt() < 1e-9 * truth);
    let learned = Emulator::fit(&samples, Form::Log, None).expect("twelve points");
    let learned = learned.at(&[0.9, 0.1]);
    let error = (learned.mean - truth).abs();
    assert!(
        error < 0.05 * truth && error < 4.0 * learned.variance.sqrt(),
        "{learned:?}"
    );
    let negative = [Sample {
        point: vec![0.5, 0.5],
        values: vec![-1.0],
    }];
    assert!(Emulator::fit(&negative, Form::Log, None).is_err());
}

#[test]
fn the_posterior_of_a_normal_likelihood_is_that_normal_distribution() {
    // A narrow ridge across the cube: x - y is known to 0.001, x + y to 0.05.
    let (middle, narrow, wide) = ([0.4, 0.6], 1e-3, 5e-2);
    let along = |point: &[f64]| (point[0] - middle[0]) + (point[1] - middle[1]);
    let across = |point: &[f64]| (point[0] - middle[0]) - (point[1] - middle[1]);
    let height =
        |point: &[f64]| -0.5 * ((along(point) / wide).powi(2) + (across(point) / narrow).powi(2));
    let posterior = Posterior::of(2, &height);
    assert!(posterior.effective_number() > 1000.0);
    for (function, deviation) in [(&along as &dyn Fn(&[f64]) -> f64, wide), (&across, narrow)] {
        assert!(posterior.mean(function).abs() < 0.02 * deviation);
        let found = posterior.deviation(function);
        assert!(
            (found / deviation - 1.0).abs() < 0.02,
            "{found} {deviation}"
        );
        let [low, high] = posterior.quantiles(function, [0.05, 0.95]);
        assert!((low / deviation + 1.645).abs() < 0.05, "{low}");
        assert!((high / deviation - 1.645).abs() < 0.05, "{high}");
    }
    let equal = posterior.resampled(1000);
    let mean = equal.iter().map(|point| along(point)).sum::<f64>() / 1000.0;
    assert!(mean.abs() < 0.1 * wide, "{mean}");
    assert_eq!(posterior, Posterior::of(2, &height));
}

/// Truths from the cube, each measured on a packing of its own with an error.
fn repetitions(number: usize, scatter: f64, error: f64, stated: f64) -> Vec<Repetition> {
    let mut random = Pcg64::seed_from_u64(4);
    let mut values = |truth: &[f64]| {
        let first = smooth(truth) + scatter * normal(&mut random) + error * normal(&mut random);
        let second = truth[0] + truth[1] + error * normal(&mut random);
        [first, second].map(|value| Measured {
            value,
            deviation: stated,
            specimens: 1.0,
        })
    };
    let truths = random_points(&mut Pcg64::seed_from_u64(5), number);
    truths
        .into_iter()
        .map(|truth| Repetition {
            measured: values(&truth).to_vec(),
            truth,
        })
        .collect()
}

/// Recover truths with an emulator of scattered runs for the first quantity, and exactly for the second.
fn recovered(repetitions: &[Repetition], scatter: f64, is_scatter_known: bool) -> Recovery {
    let mut random = Pcg64::seed_from_u64(6);
    let emulator = Emulator::fit(&samples(&mut random, 40, 4, scatter), Form::Linear, None);
    let emulator = emulator.expect("forty points");
    let predict = |point: &[f64]| {
        let mut first = emulator.at(point);
        if !is_scatter_known {
            first.scatter = 0.0;
        }
        let second = Prediction {
            mean: point[0] + point[1],
            variance: 0.0,
            scatter: 0.0,
        };
        vec![first, second]
    };
    Recovery::of(&predict, repetitions)
}

#[test]
fn known_truths_are_recovered_and_ranks_are_uniform() {
    let recovery = recovered(&repetitions(1000, 0.1, 0.05, 0.05), 0.1, true);
    for one in &recovery.parameters {
        // Three standard deviations of a share of 1000.
        assert!(
            (one.coverage(0.9) - 0.9).abs() < 0.0285,
            "{}",
            one.coverage(0.9)
        );
        assert!(
            (one.coverage(0.5) - 0.5).abs() < 0.0475,
            "{}",
            one.coverage(0.5)
        );
        assert!(one.evenness() > 0.01, "{}", one.evenness());
    }
    assert!(recovery.passes() && recovery.effective_number > 100.0);
}

#[test]
fn a_recovery_notices_a_wrong_likelihood() {
    // The error of the measurement is twice what is stated.
    assert!(!recovered(&repetitions(300, 0.0, 0.1, 0.05), 0.0, true).passes());
    // The scatter of packings is forgotten.
    assert!(!recovered(&repetitions(300, 0.1, 0.05, 0.05), 0.1, false).passes());
    // The error is half of what is stated.
    assert!(!recovered(&repetitions(300, 0.0, 0.05, 0.1), 0.0, true).passes());
}
