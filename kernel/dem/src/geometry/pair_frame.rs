//! The pair frame, and the motion of a pair in it.

use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Squared distance in m^2 below which centres count as coincident, because the direction has lost its precision.
const COINCIDENT: f64 = 1e-290;

/// Pair frame: distance of the centres, and direction from i to j.
///
/// $$ \vec e^{\,n} = \frac{\vec x_j - \vec x_i}{\lvert \vec x_j - \vec x_i \rvert}, \qquad \vec e^{\,t} = \mathrm{per}\, \vec e^{\,n} $$
///
/// Thesis eq. (5). Coincident centres have no direction: the normal is then the x axis and the rate of rotation is
/// zero, so that every law stays finite. The thesis defines only the overlap factor for this case.
#[rendered]
#[derive(Clone, Copy, Debug)]
pub struct PairFrame<S> {
    /// Distance of the centres in m.
    pub distance: S,
    /// Inverse of the distance in 1/m; zero if the centres coincide.
    pub inverse_distance: S,
    /// Unit vector from i to j.
    pub normal: Vec2<S>,
}

impl<S: Real> PairFrame<S> {
    /// Frame of a pair, from the displacement from i to j in m.
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
        // Selected at the end, so that loops over pairs are vectorised.
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

    /// Unit tangent: the normal rotated by +90 degrees.
    #[inline(always)]
    pub fn tangent(&self) -> Vec2<S> {
        self.normal.perpendicular()
    }

    /// The vector with the given normal and tangential components.
    #[inline(always)]
    pub(crate) fn vector(&self, normal: S, tangential: S) -> Vec2<S> {
        self.normal * normal + self.tangent() * tangential
    }

    /// Normal displacement, positive if the spheres overlap.
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

/// Relative velocity of a pair, resolved in its frame.
#[derive(Clone, Copy, Debug)]
pub struct PairMotion<S> {
    /// Rate of the normal displacement in m/s; positive while the particles approach each other.
    pub normal_velocity: S,
    /// Angular velocity of the pair frame in rad/s.
    pub frame_rate: S,
    /// Velocity of j relative to i along the tangent, in m/s.
    pub shear_velocity: S,
}

impl<S: Real> PairMotion<S> {
    /// Motion of a pair, from the velocity of j relative to i in m/s.
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

/// Overlap factor: position of the focal point on the line from i to j, as a fraction of the distance.
///
/// $$ b_{ij} = \frac12 \left( 1 - \frac{r_j^2 - r_i^2}{D^2} \right) = 1 - b_{ji}, \qquad b_{ij} = \tfrac12 \text{ for } D = 0 $$
///
/// Thesis eq. (4), dimensionless. The value 1/2 at coincidence is a definition and not a limit: for unequal radii the
/// factor is unbounded as the centres approach each other (erratum E31 of the thesis).
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

/// Focal point: intersection of the line of centres with the radical axis.
///
/// $$ \vec o_{ij} = \vec x_i + b_{ij} (\vec x_j - \vec x_i) = \vec o_{ji} $$
///
/// Thesis eq. (3). `position` is that of i in m, `displacement` that from i to the nearest image of j in m, and
/// `factor` the [`overlap_factor`].
#[doc(alias = "contact point")]
#[rendered]
pub fn focal_point<S: Real>(position: Vec2<S>, displacement: Vec2<S>, factor: S) -> Vec2<S> {
    position + displacement * factor
}
