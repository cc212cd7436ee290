//! Dissipation: collisions of viscoelastic spheres, and bodies in a resisting medium.

use super::flow::Flow;

/// Restitution of viscoelastic spheres.
///
/// In units of the time kappa^(-2/5) v^(-1/5) and the length v^(4/5) kappa^(-2/5) the overlap obeys
/// x'' = -sqrt(x) (x + b x') from x = 0, x' = 1 until x + b x' vanishes; b is the dissipative constant in
/// units of the time, kappa the prefactor of the force over the reduced mass.
pub fn viscoelastic_restitution(b: f64) -> f64 {
    let flow = Flow {
        rate: |_: f64, y: &[f64; 2]| [y[1], -y[0].max(0.0).sqrt() * (y[0] + b * y[1])],
        tolerance: 1e-13,
    };
    let (_, end) = flow.until([0.0, 1.0], 20.0, |_, y| y[0] + b * y[1]);
    -end[1]
}

/// Speed after a time with the deceleration a v + b v^(3/2) + c v^2.
pub fn slowed(speed: f64, time: f64, [a, b, c]: [f64; 3]) -> f64 {
    let flow = Flow {
        rate: |_: f64, y: &[f64; 1]| [-y[0] * (a + b * y[0].sqrt() + c * y[0])],
        tolerance: 1e-14,
    };
    flow.advance([speed], time)[0]
}
