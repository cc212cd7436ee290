//! The friction of a whole run and its confidence interval.

use crate::worlds::world;
use gouge_dem::integrators::Integrator;
use gouge_runner::run::{DriveSample, Friction};
use gouge_validation::scenes::{Draft, Grain};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Samples of a block that slides at 2 m/s under 10 N, with a coefficient of friction for each interval between samples.
fn sliding(coefficients: &[f64]) -> Vec<DriveSample> {
    let (load, speed, step) = (10.0, 2.0, 1e-3);
    let mut sample = DriveSample {
        time: 0.0,
        shearing: 0.0,
        sliding: 0.0,
        velocity: speed,
        coefficient: 0.4,
    };
    let mut samples = vec![sample];
    for coefficient in coefficients {
        sample.time += step;
        sample.shearing += coefficient * load * speed * step;
        sample.sliding += load * speed * step;
        samples.push(sample);
    }
    samples
}

#[test]
fn friction_is_the_work_of_the_horizontal_force_over_load_times_slip() {
    let found = Friction::of(&sliding(&[0.3; 100]), 1e-3).expect("friction");
    let errors = [
        found.coefficient - 0.3,
        found.interval[0] - 0.3,
        found.interval[1] - 0.3,
        found.since - 0.05,
        found.slip - 0.1,
        found.samples_mean - 0.4,
    ];
    assert!(errors.iter().all(|error| error.abs() < 1e-12), "{found:?}");
}

#[test]
fn only_the_second_half_counts() {
    let coefficients: Vec<f64> = (0..100).map(|n| if n < 50 { 9.0 } else { 0.3 }).collect();
    let found = Friction::of(&sliding(&coefficients), 1e-3).expect("friction");
    assert!((found.coefficient - 0.3).abs() < 1e-12, "{found:?}");
}

#[test]
fn a_block_that_does_not_slide_under_load_has_no_friction() {
    assert_eq!(Friction::of(&[], 1e-3), None);
    assert_eq!(
        Friction::of(&sliding(&[0.3; 38]), 1e-3),
        None,
        "too few samples"
    );
    let mut resting = sliding(&[0.3; 100]);
    resting.iter_mut().for_each(|one| one.sliding = 0.0);
    assert_eq!(Friction::of(&resting, 1e-3), None);
    let mut creeping = sliding(&[0.3; 100]);
    creeping.iter_mut().for_each(|one| one.velocity = 1e-9);
    assert_eq!(Friction::of(&creeping, 1e-3), None);
    let mut back = sliding(&[0.3; 100]);
    for one in &mut back {
        (one.velocity, one.sliding, one.shearing) = (-one.velocity, -one.sliding, -one.shearing);
    }
    let found = Friction::of(&back, 1e-3).expect("friction of a block that slides back");
    assert!(
        (found.coefficient - 0.3).abs() < 1e-12 && found.slip < 0.0,
        "{found:?}"
    );
    let mut pulled = sliding(&[0.3; 100]);
    pulled.iter_mut().for_each(|one| one.sliding *= -1.0);
    assert_eq!(Friction::of(&pulled, 1e-3), None);
}

/// A driven grain in a viscous medium: the horizontal force is the Stokes drag, the load is given, and so are both
/// integrals.
#[test]
fn the_kernel_integrates_work_and_load_over_the_slip() {
    let (speed, pressure, area, viscosity, radius) = (2.0, 10.0, 1e-6, 1.0, 1e-3);
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-6)
        .with("driving.controller", "exact")
        .with("driving.speed", speed)
        .with("driving.pressure", pressure)
        .with("driving.area", area)
        .creeping_drag(viscosity)
        .grain(Grain::at([0.0, 0.0], radius).moving([speed, 0.0]).driven());
    let mut world = world(&draft);
    for _ in 0..1000 {
        world.step().expect("a step");
    }
    let [shearing, sliding] = world.shearing_and_sliding().expect("a ledger");
    let slip = speed * world.time();
    let drag = 6.0 * std::f64::consts::PI * viscosity * radius * speed;
    // The first step has no driving force yet, and in the next ones the controller finds its way.
    assert!(
        (shearing / (drag * slip) - 1.0).abs() < 5e-3,
        "{shearing}, {}",
        drag * slip
    );
    let load = pressure * area;
    assert!(
        (sliding / (load * slip) - 1.0).abs() < 5e-3,
        "{sliding}, {}",
        load * slip
    );
}

/// Coefficients around 0.3 whose deviations forget their past within about `memory` samples.
fn scattered(random: &mut Pcg64, memory: f64, number: usize) -> Vec<f64> {
    let keep = (-1.0 / memory).exp();
    let mut deviation = 0.0;
    let mut next = || {
        // The sum of twelve uniform numbers is almost normal.
        let normal = (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
        deviation = keep * deviation + (1.0 - keep * keep).sqrt() * normal;
        0.3 + 0.1 * deviation
    };
    (0..100).for_each(|_| {
        next();
    });
    (0..number).map(|_| next()).collect()
}

/// Of 1000 intervals, 95 % contain the coefficient; four standard deviations of that number are 2.8 %.
#[test]
fn intervals_contain_the_coefficient_as_often_as_they_say() {
    let mut random = Pcg64::seed_from_u64(7);
    for memory in [0.1, 5.0] {
        let is_covered = |_: &i32| {
            let samples = sliding(&scattered(&mut random, memory, 2000));
            let [low, high] = Friction::of(&samples, 1e-3).expect("friction").interval;
            (low..high).contains(&0.3)
        };
        let covered = (0..1000).filter(is_covered).count();
        assert!((922..=978).contains(&covered), "{memory}: {covered}");
    }
}

#[test]
fn blocks_shorter_than_the_memory_are_told() {
    let mut random = Pcg64::seed_from_u64(8);
    let mut correlated = |memory: f64| {
        let is_told = |_: &i32| {
            let samples = sliding(&scattered(&mut random, memory, 400));
            Friction::of(&samples, 1e-3)
                .expect("friction")
                .is_correlated()
        };
        (0..200).filter(is_told).count()
    };
    assert!(correlated(0.1) <= 10, "independent blocks");
    assert!(correlated(60.0) >= 60, "blocks of twenty samples");
}
