//! Bounds of the time step: stability of every method, waves and cracks, thesis (59)-(62).

use super::method::Integrator;
use crate::material::Elastic;
use gouge_equations::rendered;

/// A damped oscillator, to which every mode of linked particles reduces.
///
/// $$ \ddot x = -\omega^2 x - 2 \zeta \omega\, \dot x $$
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    /// Stiffness over inertia, the squared angular frequency, in 1/s^2.
    pub stiffness: f64,
    /// Damping coefficient over inertia, twice the damping ratio times the frequency, in 1/s.
    pub damping: f64,
}

/// Coefficients, from the highest power, of the polynomial whose roots are the factors by which one
/// step multiplies the modes of an oscillator, with k = w^2 dt^2 and c = 2 zeta w dt.
///
/// They follow from writing one step of each method as a linear map of position and velocity (velocity
/// Verlet: and the acceleration; Beeman: and two of them) and expanding the determinant. Velocity Verlet
/// with velocities of half a step is symplectic Euler on these velocities.
pub fn characteristic_polynomial(integrator: Integrator, k: f64, c: f64) -> Vec<f64> {
    match integrator {
        Integrator::Euler => vec![1.0, c - 2.0, 1.0 - c + k],
        Integrator::SymplecticEuler | Integrator::VelocityVerletHalfStep => {
            vec![1.0, c + k - 2.0, 1.0 - c]
        }
        Integrator::Taylor => vec![1.0, c + 0.5 * k - 2.0, 1.0 - c + 0.5 * k],
        Integrator::VelocityVerlet => vec![1.0, k + 1.5 * c - 2.0, 1.0 - 2.0 * c, 0.5 * c],
        Integrator::Beeman => vec![
            1.0,
            7.0 * k / 6.0 + 11.0 * c / 6.0 - 2.0,
            1.0 - 0.5 * k - 3.0 * c,
            0.5 * k + 1.5 * c,
            -k / 6.0 - c / 3.0,
        ],
    }
}

/// How much a mode may grow in one step and still count as stable, to admit methods that conserve
/// undamped amplitudes exactly.
const GROWTH: f64 = 1e-9;

/// Whether no mode of the oscillator grows with the given step in s.
pub fn is_stable(integrator: Integrator, oscillator: Oscillator, step: f64) -> bool {
    let mut polynomial = characteristic_polynomial(
        integrator,
        oscillator.stiffness * step * step,
        oscillator.damping * step,
    );
    // Substituting (1 + growth) times the root admits roots up to that modulus.
    let mut scale = 1.0;
    for coefficient in polynomial.iter_mut() {
        *coefficient *= scale;
        scale /= 1.0 + GROWTH;
    }
    all_roots_inside(polynomial)
}

/// Schur-Cohn test: whether all roots lie strictly inside the unit circle.
fn all_roots_inside(mut polynomial: Vec<f64>) -> bool {
    while polynomial.len() > 1 {
        let (first, last) = (polynomial[0], polynomial[polynomial.len() - 1]);
        if last.abs() >= first.abs() {
            return false;
        }
        let ratio = last / first;
        let reversed: Vec<f64> = polynomial.iter().rev().copied().collect();
        for (coefficient, mirror) in polynomial.iter_mut().zip(reversed) {
            *coefficient -= ratio * mirror;
        }
        polynomial.pop();
    }
    true
}

/// Largest step in s up to which the method is stable for the oscillator; infinite without forces.
///
/// The first step at which a mode begins to grow, found by a scan and bisection.
pub fn critical_step(integrator: Integrator, oscillator: Oscillator) -> f64 {
    let rate = oscillator.stiffness.sqrt().max(oscillator.damping);
    if rate <= 0.0 {
        return f64::INFINITY;
    }
    const SCAN: u32 = 4000;
    let step_at = |i: f64| i * 4.0 / (f64::from(SCAN) * rate);
    let first = (1..=SCAN).find(|&i| !is_stable(integrator, oscillator, step_at(f64::from(i))));
    let Some(first) = first else {
        return step_at(f64::from(SCAN));
    };
    let (mut low, mut high) = (step_at(f64::from(first - 1)), step_at(f64::from(first)));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if is_stable(integrator, oscillator, middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Step in s that lets a primary wave cross a particle of the given radius in m.
///
/// $$ \Delta t < \frac{2 R}{c^P} $$
///
/// Thesis eq. (61), for a density in kg/m^3.
#[rendered]
pub fn wave_bound(elastic: Elastic, density: f64, radius: f64) -> f64 {
    2.0 * radius / elastic.primary_wave_speed(density)
}

/// Step in s that lets a crack of the given Mach number cross a particle.
///
/// $$ \Delta t < \frac{2 R}{Ma\, c^P} $$
///
/// Thesis eq. (62).
#[rendered]
pub fn crack_bound(elastic: Elastic, density: f64, radius: f64, mach_number: f64) -> f64 {
    wave_bound(elastic, density, radius) / mach_number
}
