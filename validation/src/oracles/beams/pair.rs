//! Normal modes of two spheres with a beam between them.

use super::{Sphere, Springs};

/// Squared angular frequencies over stiffness of the three modes that are not rigid, in 1/kg:
/// stretching over k_n, then the two rotational modes over k_t, the lower one first.
///
/// With a = phi_i - lambda, b = phi_j - lambda, the reduced mass m* and J = 2/5 m r^2,
///
/// ```text
/// a'' = -k_t [ (5 / (2 m_i) + r_i^2 / (m* D^2)) a + r_j^2 / (m* D^2) b ]
/// b'' = -k_t [ r_i^2 / (m* D^2) a + (5 / (2 m_j) + r_j^2 / (m* D^2)) b ]
/// ```
///
/// For equal spheres in touch these are 2/m, 5/(2 m) and 7/(2 m).
pub fn modes(ends: [Sphere; 2], distance: f64) -> [f64; 3] {
    let [m, n] = ends.map(Sphere::mass);
    let reduced = m * n / (m + n);
    let [p, q] = ends.map(|end| end.radius * end.radius / (reduced * distance * distance));
    let (a, b) = (2.5 / m + p, 2.5 / n + q);
    let (mean, half) = (0.5 * (a + b), 0.5 * (a - b));
    let spread = (half * half + p * q).sqrt();
    [1.0 / reduced, mean - spread, mean + spread]
}

/// Decay rate in 1/s and angular frequency in rad/s of each underdamped mode: stretching and rotation
/// have dashpots in parallel with their springs.
pub fn damped(
    ends: [Sphere; 2],
    distance: f64,
    springs: Springs,
    dashpots: Springs,
) -> [[f64; 2]; 3] {
    let modes = modes(ends, distance);
    let constants = [
        (springs.normal, dashpots.normal),
        (springs.tangential, dashpots.tangential),
        (springs.tangential, dashpots.tangential),
    ];
    std::array::from_fn(|n| {
        let (k, c) = constants[n];
        let decay = 0.5 * c * modes[n];
        [decay, (k * modes[n] - decay * decay).sqrt()]
    })
}

#[cfg(test)]
mod tests {
    use super::{Sphere, modes};
    use approx::abs_diff_eq;

    #[test]
    fn equal_spheres_in_touch_have_two_five_halves_and_seven_halves() {
        let one = Sphere {
            radius: 0.3,
            density: 2.0,
        };
        let scaled = modes([one, one], 0.6).map(|mode| mode * one.mass());
        for (mode, exact) in scaled.iter().zip([2.0, 2.5, 3.5]) {
            assert!(abs_diff_eq!(*mode, exact, epsilon = 1e-14), "{scaled:?}");
        }
    }
}
