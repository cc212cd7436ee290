//! Two equal spheres joined by a damped beam, free in the plane, in polar coordinates.
//!
//! With the centre of mass at rest, two coordinates give the positions: the distance D and the angle l
//! of the line from the first to the second. The angles p and q of the spheres are the other two.
//! Lengths are in radii, masses in units of a sphere's mass, and times such that the stretching
//! stiffness k is one. Lagrange's equations follow from the energies
//!
//! T = (D'^2 + D^2 l'^2)/4 + (p'^2 + q'^2)/5, V = ((D - R)^2 + s ((p - l)^2 + (q - l)^2))/2
//!
//! and the dissipation (c D'^2 + b ((p' - l')^2 + (q' - l')^2))/2.

/// Constants of the beam.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Length R at rest, in radii.
    pub rest: f64,
    /// Bending stiffness s of an end, in units of k.
    pub bending: f64,
    /// Damping c of stretching, in units of sqrt(k m).
    pub damping: f64,
    /// Bending damping b of an end, in the same units.
    pub bending_damping: f64,
}

/// Distance, angle of the line, angles of the spheres, and the rates of these four.
pub type State = [f64; 8];

impl Beam {
    /// Rate of change of the state.
    pub fn rate(&self, state: &State) -> State {
        let [
            distance,
            line,
            first,
            second,
            stretching,
            turning,
            spin,
            other,
        ] = *state;
        let bend = |angle: f64, rate: f64| {
            self.bending * (angle - line) + self.bending_damping * (rate - turning)
        };
        let bends = [bend(first, spin), bend(second, other)];
        let pull = (distance - self.rest) + self.damping * stretching;
        let swing = 2.0 * (bends[0] + bends[1]) / distance - 2.0 * stretching * turning;
        [
            stretching,
            turning,
            spin,
            other,
            distance * turning * turning - 2.0 * pull,
            swing / distance,
            -2.5 * bends[0],
            -2.5 * bends[1],
        ]
    }
}
