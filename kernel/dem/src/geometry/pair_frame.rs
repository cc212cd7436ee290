//! The frame of a pair of particles and the motion seen in it.

use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Squares of distances below this have lost their precision: the centres count as coincident.
const COINCIDENT: f64 = 1e-290;

/// Frame of a pair: distance of the centres and direction from the first to the second.
///
/// $$ \vec e^{\,n} = \frac{\vec x_j - \vec x_i}{\lvert \vec x_j - \vec x_i \rvert}, \qquad \vec e^{\,t} = \mathrm{per}\, \vec e^{\,n} $$
///
/// Thesis eq. (5). Coincident centres have no direction; the normal is then that of the x axis and
/// rates of turning are zero, so that every law stays finite (the thesis defines only the overlap
/// factor there).
#[rendered]
#[derive(Clone, Copy, Debug)]
pub struct PairFrame<S> {
    /// Distance of the centres in m.
    pub distance: S,
    /// Inverse of the distance in 1/m; zero for coincident centres.
    pub inverse_distance: S,
    /// Unit vector from i to j.
    pub normal: Vec2<S>,
}

impl<S: Real> PairFrame<S> {
    /// Frame of the pair with the given displacement from i to j.
    #[inline(always)]
    pub fn new(displacement: Vec2<S>) -> Self {
        let squared = displacement.norm_squared();
        let distance = squared.sqrt();
        let inverse_distance = S::from_f64(1.0) / distance;
        let frame = Self {
            distance,
            inverse_distance,
            normal: displacement * inverse_distance,
        };
        // Chosen at the end, so that many pairs are looked at together.
        if squared < S::from_f64(COINCIDENT) {
            Self {
                distance: S::zero(),
                inverse_distance: S::zero(),
                normal: Vec2::new(S::from_f64(1.0), S::zero()),
            }
        } else {
            frame
        }
    }

    /// Unit vector perpendicular to the normal, to its left.
    #[inline(always)]
    pub fn tangent(&self) -> Vec2<S> {
        self.normal.perpendicular()
    }

    /// The vector with the given components along normal and tangent.
    #[inline(always)]
    pub(crate) fn vector(&self, normal: S, tangential: S) -> Vec2<S> {
        self.normal * normal + self.tangent() * tangential
    }

    /// Normal displacement, positive where the spheres overlap.
    ///
    /// $$ \xi = (r_i + r_j) - \lvert \vec x_j - \vec x_i \rvert $$
    ///
    /// Thesis eq. (28), in m.
    #[doc(alias = "overlap")]
    #[doc(alias = "penetration")]
    #[inline(always)]
    pub fn normal_displacement(&self, radii: [S; 2]) -> S {
        (radii[0] + radii[1]) - self.distance
    }
}

/// Velocities of a pair resolved in its frame.
#[derive(Clone, Copy, Debug)]
pub struct PairMotion<S> {
    /// Rate of the normal displacement in m/s: positive while the particles approach.
    pub normal_velocity: S,
    /// Rate at which the frame turns, in rad/s.
    pub frame_rate: S,
    /// Velocity of j relative to i along the tangent, in m/s.
    pub shear_velocity: S,
}

impl<S: Real> PairMotion<S> {
    /// Motion in the frame, from the velocity of j relative to i.
    ///
    /// $$ \partial_t \xi = -(\vec v_j - \vec v_i) \cdot \vec e^{\,n}, \qquad \partial_t \lambda = \frac{(\vec v_j - \vec v_i) \cdot \vec e^{\,t}}{\lvert \vec x_j - \vec x_i \rvert} $$
    ///
    /// Thesis eq. (34).
    #[inline(always)]
    pub fn new(frame: &PairFrame<S>, relative_velocity: Vec2<S>) -> Self {
        let shear_velocity = relative_velocity.dot(frame.tangent());
        Self {
            normal_velocity: -relative_velocity.dot(frame.normal),
            frame_rate: shear_velocity * frame.inverse_distance,
            shear_velocity,
        }
    }
}

/// Overlap factor: where between the centres the focal point lies.
///
/// $$ b_{ij} = \frac12 \left( 1 - \frac{r_j^2 - r_i^2}{D^2} \right) = 1 - b_{ji}, \qquad b_{ij} = \tfrac12 \text{ for } D = 0 $$
///
/// Thesis eq. (4); dimensionless. The value one half at coincidence is a definition, not a limit: for
/// unequal radii the factor is unbounded as the centres approach (erratum E31 of the thesis).
#[rendered]
#[inline(always)]
pub fn overlap_factor<S: Real>(radii: [S; 2], distance: S) -> S {
    if distance > S::zero() {
        let asymmetry = ((radii[1] - radii[0]) / distance) * ((radii[1] + radii[0]) / distance);
        (S::from_f64(1.0) - asymmetry) * 0.5
    } else {
        S::from_f64(0.5)
    }
}

/// Focal point: where the line of centres meets the radical axis.
///
/// $$ \vec o_{ij} = \vec x_i + b_{ij} (\vec x_j - \vec x_i) = \vec o_{ji} $$
///
/// Thesis eq. (3). `displacement` leads from i to the image of j that i meets.
#[doc(alias = "contact point")]
#[rendered]
pub fn focal_point<S: Real>(position: Vec2<S>, displacement: Vec2<S>, factor: S) -> Vec2<S> {
    position + displacement * factor
}
