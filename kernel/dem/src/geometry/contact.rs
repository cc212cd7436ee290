//! Contact geometry of two spheres: distances, half-length, area and volume (thesis appendix D).

use super::{MixedArms, PairFrame, PairMotion, overlap_factor};
use core::f64::consts::PI;
use gouge_common::pair::map_ends;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Lever arm of a contact: which distance of the centre from the contact is used (d in thesis eq. (7)).
///
/// Only the radius is constant. The others change with the distance of the centres, which thesis eq. (34) neglects:
/// with a tangential spring the energy balance then does not close (erratum E11 of the thesis).
#[doc(alias = "lever arm")]
#[doc(alias = "branch length")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactDistance {
    /// The radius.
    Radius,
    /// The distance from the focal point, [`focal_distance`].
    Focal,
    /// The mean distance from the contact, [`mean_distance`].
    Mean,
    /// Different lever arms for different purposes, as in other programs; for comparisons only.
    Mixed(MixedArms),
}

/// Lever arms of both ends of an interaction, in m.
#[rendered]
pub trait Arm: Copy + Send + Sync {
    /// Whether tangential displacements are summed over steps, instead of being functions of state.
    const ACCUMULATES: bool = false;
    /// Whether the lever arms are the radii, for every distance of the centres.
    const CONSTANT: bool = false;
    /// Lever arms of i and j in m, for radii and distance of the centres in m.
    fn distances<S: Real>(self, radii: [S; 2], distance: S) -> [S; 2];
    /// Tangential velocities of both ends in m/s; `spins` are the angular velocities in rad/s.
    ///
    /// $$ \partial_t \zeta_{ij} = d_{ij} (\omega_i - \partial_t \lambda) $$
    ///
    /// Thesis eq. (34).
    #[inline(always)]
    fn velocities<S: Real>(
        self,
        radii: [S; 2],
        frame: &PairFrame<S>,
        motion: &PairMotion<S>,
        spins: [S; 2],
    ) -> [S; 2] {
        let arms = self.distances(radii, frame.distance);
        map_ends([0, 1], |end| arms[end] * (spins[end] - motion.frame_rate))
    }
}

/// Lever arm: the radius.
#[derive(Clone, Copy, Debug)]
pub struct RadiusArm;
/// Lever arm: the distance from the focal point.
#[derive(Clone, Copy, Debug)]
pub struct FocalArm;
/// Lever arm: the mean distance from the contact.
#[derive(Clone, Copy, Debug)]
pub struct MeanArm;

impl Arm for RadiusArm {
    const CONSTANT: bool = true;
    #[inline(always)]
    fn distances<S: Real>(self, radii: [S; 2], _: S) -> [S; 2] {
        radii
    }
}
impl Arm for FocalArm {
    #[inline(always)]
    fn distances<S: Real>(self, radii: [S; 2], distance: S) -> [S; 2] {
        let y = focal_distance(radii, distance);
        [y, distance - y]
    }
}
impl Arm for MeanArm {
    #[inline(always)]
    fn distances<S: Real>(self, radii: [S; 2], distance: S) -> [S; 2] {
        let y = FocalArm.distances(radii, distance);
        [mean_distance(radii[0], y[0]), mean_distance(radii[1], y[1])]
    }
}

/// Distance of the centre of i from the focal point; negative if the focal point lies on the far side of the centre.
///
/// $$ y_{ij} = b_{ij} \lvert \vec x_j - \vec x_i \rvert, \qquad y_{ij} + y_{ji} = \lvert \vec x_j - \vec x_i \rvert $$
///
/// Thesis eq. (112), in m. Unbounded as the centres of unequal spheres approach each other.
#[rendered]
#[inline(always)]
pub fn focal_distance<S: Real>(radii: [S; 2], distance: S) -> S {
    overlap_factor(radii, distance) * distance
}

/// Half-length of the contact; zero unless the surfaces of the spheres intersect.
///
/// $$ z_{ij} = \sqrt{r_i^2 - y_{ij}^2} = z_{ji} $$
///
/// Thesis eq. (113), in m. If one sphere contains the other or they are apart, the square root would be imaginary,
/// and the half-length is zero.
#[rendered]
pub fn contact_half_length<S: Real>(radius: S, focal_distance: S) -> S {
    let squared = (radius - focal_distance) * (radius + focal_distance);
    squared.max(S::zero()).sqrt()
}

/// Mean distance of the centre of i from the contact.
///
/// $$ u = \frac{1}{2z} \int_{-z}^{z} \sqrt{s^2 + y^2} \, \mathrm d s = \frac12 \left( r + \lvert y \rvert \frac{\mathrm{arsinh}\, q}{q} \right), \qquad q^2 = (r/y)^2 - 1 $$
///
/// Thesis eq. (114), in m, with the absolute value of y, which is needed if the centre lies beyond the contact plane
/// (erratum E30 of the thesis). For separate or contained spheres q is imaginary; the analytic continuation, with
/// arcsin instead of arsinh, keeps the function smooth in y.
#[rendered]
pub fn mean_distance<S: Real>(radius: S, focal_distance: S) -> S {
    let y = focal_distance.abs();
    if y <= S::zero() {
        return radius * 0.5;
    }
    let ratio = radius / y;
    let q_squared = (ratio - S::from_f64(1.0)) * (ratio + S::from_f64(1.0));
    let q = q_squared.abs().sqrt();
    let bent = if q < S::from_f64(1e-4) {
        S::from_f64(1.0) - q_squared * (1.0 / 6.0)
    } else if q_squared > S::zero() {
        q.asinh() / q
    } else {
        q.asin() / q
    };
    (radius + y * bent) * 0.5
}

/// Mean of the smallest and the largest distance: the thesis's approximation of [`mean_distance`].
///
/// $$ u \approx \frac{r + y}{2} $$
///
/// Thesis eq. (115), in m. Near touch it overestimates u - y by 50 %; the second-order expansion is (r + 2 y) / 3
/// (erratum E29 of the thesis).
#[rendered]
pub fn mean_distance_of_extremities<S: Real>(radius: S, focal_distance: S) -> S {
    (radius + focal_distance) * 0.5
}

/// Contact area of two spheres, pi z^2, in m^2, thesis eq. (116).
pub fn contact_area<S: Real>(half_length: S) -> S {
    half_length * half_length * PI
}

/// The overlap of two circles if it is a circle: its radius is zero if they are apart, and the smaller radius if one
/// contains the other. `None` if they intersect.
fn whole_in_overlap<S: Real>(radii: [S; 2], distance: S) -> Option<S> {
    if distance >= radii[0] + radii[1] {
        Some(S::zero())
    } else if distance <= (radii[0] - radii[1]).abs() {
        Some(radii[0].min(radii[1]))
    } else {
        None
    }
}

/// Overlap volume of two spheres, in m^3.
///
/// $$ V = \frac{\pi}{3} (2 r_i + y_{ij}) (r_i - y_{ij})^2 + \frac{\pi}{3} (2 r_j + y_{ji}) (r_j - y_{ji})^2 $$
///
/// Thesis eq. (117): two caps. Zero if the spheres are apart. If one contains the other, the caps do not describe the
/// overlap, and the result is the volume of the smaller sphere.
#[rendered]
pub fn displaced_volume<S: Real>(radii: [S; 2], distance: S) -> S {
    if let Some(r) = whole_in_overlap(radii, distance) {
        return r * r * r * (4.0 / 3.0 * PI);
    }
    let y = FocalArm.distances(radii, distance);
    let cap = |r: S, y: S| (r * 2.0 + y) * (r - y) * (r - y) * (PI / 3.0);
    cap(radii[0], y[0]) + cap(radii[1], y[1])
}

/// Contact area of two cylinders, 2 L z, in m^2, thesis eq. (118); `depth` is their length L in m.
pub fn cylinder_contact_area<S: Real>(depth: S, half_length: S) -> S {
    depth * half_length * 2.0
}

/// Overlap volume of two cylinders, in m^3; `depth` is their length L in m.
///
/// $$ V = \tfrac12 L (\theta_{ij} r_i^2 - 2 y_{ij} z) + \tfrac12 L (\theta_{ji} r_j^2 - 2 y_{ji} z), \qquad \theta = 2 \arccos (y / r) $$
///
/// Thesis eqs. (119)-(120), for intersecting circles. Zero if the cylinders are apart, and the volume of the smaller
/// one if one contains the other.
#[rendered]
pub fn cylinder_displaced_volume<S: Real>(depth: S, radii: [S; 2], distance: S) -> S {
    if let Some(r) = whole_in_overlap(radii, distance) {
        return depth * r * r * PI;
    }
    let y = FocalArm.distances(radii, distance);
    let z = contact_half_length(radii[0], y[0]);
    // Rounding may put the chord of circles that just touch outside one of them.
    let one = S::from_f64(1.0);
    let segment = |r: S, y: S| (y / r).min(one).max(-one).acos() * r * r - y * z;
    depth * (segment(radii[0], y[0]) + segment(radii[1], y[1]))
}
