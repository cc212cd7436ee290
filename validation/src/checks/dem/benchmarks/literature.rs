//! Published data, read from figures: for comparison in the report, not for the checks.
//!
//! Chung and Ooi, Granular Matter 13 (2011) 643, and Kharaz, Gorham and Salman (2001), as digitised for
//! the test data of other programs; a reading is accurate to about one per cent of the range of its
//! figure.

/// Test 4, simulated: angle of impact in degrees, tangential restitution, angular velocity in rad/s,
/// rebound angle of the contact point in degrees.
pub const OBLIQUE: [[f64; 4]; 13] = [
    [5.0, 0.948, -19.3, 3.8],
    [10.0, 0.687, -213.0, -1.6],
    [15.0, 0.624, -377.8, -5.5],
    [20.0, 0.616, -510.6, -7.5],
    [25.0, 0.634, -599.4, -7.5],
    [30.0, 0.684, -616.5, -3.5],
    [35.0, 0.737, -582.3, 3.4],
    [40.0, 0.781, -544.8, 11.6],
    [50.0, 0.845, -457.0, 29.4],
    [60.0, 0.893, -357.5, 47.8],
    [70.0, 0.932, -246.2, 64.6],
    [80.0, 0.966, -126.3, 78.7],
    [85.0, 0.983, -63.1, 84.5],
];

/// Test 4, measured: angle of impact in degrees, tangential restitution.
pub const OBLIQUE_MEASURED: [[f64; 2]; 8] = [
    [2.03, 0.7938],
    [3.93, 0.7450],
    [9.63, 0.6728],
    [20.08, 0.5964],
    [30.22, 0.6883],
    [39.30, 0.7719],
    [49.55, 0.8469],
    [59.84, 0.9019],
];

/// Test 4, measured: angle of impact in degrees, magnitude of the angular velocity in rad/s.
pub const SPIN_MEASURED: [[f64; 2]; 7] = [
    [6.00, 135.57],
    [10.98, 264.55],
    [21.19, 577.01],
    [31.09, 612.65],
    [39.03, 595.48],
    [50.22, 452.94],
    [60.25, 381.32],
];

/// Test 5, finite elements: tangential speed over friction times normal speed, before and after.
pub const FINITE_ELEMENTS: [[f64; 2]; 15] = [
    [0.27, -0.03],
    [0.59, -0.03],
    [0.88, -0.08],
    [1.19, -0.21],
    [1.55, -0.37],
    [1.92, -0.63],
    [2.31, -0.95],
    [2.79, -1.25],
    [3.32, -1.52],
    [3.97, -1.72],
    [4.76, -1.71],
    [5.76, -1.20],
    [7.12, 0.13],
    [9.12, 2.15],
    [12.36, 5.43],
];

/// Test 5, finite elements: tangential speed before and surface speed after, over friction times normal
/// speed.
pub const FINITE_ELEMENTS_SPIN: [[f64; 2]; 8] = [
    [0.32, -0.19],
    [1.18, -0.98],
    [1.90, -1.79],
    [2.76, -2.86],
    [3.30, -3.44],
    [3.89, -4.04],
    [4.69, -4.57],
    [5.66, -4.94],
];

/// Tests 6 and 8, simulated: friction number x, restitution of the sliding velocity.
pub const SPINNING: [[f64; 2]; 17] = [
    [0.187, -0.815],
    [0.358, -0.626],
    [0.551, -0.439],
    [0.765, -0.238],
    [0.979, -0.017],
    [1.21, 0.096],
    [1.49, 0.111],
    [1.77, 0.090],
    [2.09, 0.058],
    [2.52, 0.006],
    [2.99, -0.049],
    [3.63, -0.103],
    [4.51, -0.139],
    [5.77, -0.162],
    [7.84, -0.204],
    [11.9, -0.259],
    [24.0, -0.339],
];
