//! Disorder of a packing: radial distribution and two-body excess entropy, thesis eqs. (69), (80)-(84).

use crate::geometry::{Domain, Vec2};
use core::f64::consts::{PI, TAU};
use gouge_equations::rendered;

/// Where a packing lies: a strip, periodic in x or cut off at both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// Width in m; points have x in [0, width].
    pub width: f64,
    /// Height in m; points have y in [0, height].
    pub height: f64,
    /// Whether x is periodic.
    pub periodic: bool,
}

/// Radial distribution of a packing, sampled at equal distances up to a quarter of the width.
#[derive(Clone, Debug, PartialEq)]
pub struct RadialDistribution {
    /// Distances in m.
    pub distance: Vec<f64>,
    /// Probability density of the distance of a pair in 1/m, thesis eqs. (81)-(82).
    pub density: Vec<f64>,
    /// Radial distribution function g, dimensionless, thesis eq. (83).
    pub g: Vec<f64>,
    /// Number of points over area in 1/m^2.
    pub number_density: f64,
}

impl Region {
    /// Whether a point lies inside or on the edge; any x does where x is periodic.
    pub fn contains(&self, point: Vec2) -> bool {
        let (x, y) = (0.0..=self.width, 0.0..=self.height);
        (self.periodic || x.contains(&point.x)) && y.contains(&point.y)
    }
}

/// Part of a circle around a point of the region that lies inside it, in (0, 1].
///
/// The reciprocal of the weight of thesis eq. (80). Arcs beyond the lower and upper edge, and beyond
/// both sides where x is not periodic, are subtracted; overlaps of such arcs at corners are added back.
pub fn visible_fraction(region: &Region, point: Vec2, distance: f64) -> f64 {
    // Half-angle of the arc beyond an edge at the given depth.
    let beyond = |depth: f64| {
        if depth < distance {
            libm::acos((depth / distance).max(0.0))
        } else {
            0.0
        }
    };
    let vertical = [beyond(point.y), beyond(region.height - point.y)];
    let horizontal = if region.periodic {
        [0.0; 2]
    } else {
        [beyond(point.x), beyond(region.width - point.x)]
    };
    let mut hidden = 2.0 * (vertical[0] + vertical[1] + horizontal[0] + horizontal[1]);
    for v in vertical {
        for h in horizontal {
            // The arcs centre on directions a right angle apart.
            hidden -= (v + h - 0.5 * PI).max(0.0);
        }
    }
    (TAU - hidden) / TAU
}

/// Epanechnikov kernel, which integrates to one over [-1, 1].
fn epanechnikov(u: f64) -> f64 {
    0.75 * (1.0 - u * u).max(0.0)
}

/// Radial distribution of points in a region.
///
/// $$ P(d) = \frac{Z}{B \sum w_{ij}} \sum_i \sum_{j \ne i} w_{ij}\, \Psi\left( \frac{d - d_{ij}}{B} \right), \qquad g = \frac{(l/4)^2}{2 d} P, \qquad \int_0^{l/4} P \,\mathrm d d = 1 $$
///
/// Thesis eqs. (80)-(83), with the Epanechnikov kernel for the statistical one, its bandwidth in m and
/// so many samples. Weights correct for the part of each circle outside the region, points outside are
/// left out; distances are those of the nearest image. Choose a bandwidth below the smallest distance:
/// otherwise the density leaks to zero distance, where g divides by it. The normalisation makes the mean
/// of g over the disc one, which biases g by about the inverse of the expected number of neighbours (erratum E49
/// of the thesis). Cost: a pass over all pairs.
#[rendered]
pub fn radial_distribution(
    points: &[Vec2],
    region: &Region,
    bandwidth: f64,
    samples: usize,
) -> RadialDistribution {
    let points: Vec<Vec2> = points
        .iter()
        .copied()
        .filter(|&x| region.contains(x))
        .collect();
    let domain = Domain {
        width: Some(region.width),
        height: Some(region.height),
        periodic: region.periodic,
    };
    let limit = 0.25 * region.width;
    let spacing = limit / samples as f64;
    let distance: Vec<f64> = (0..samples).map(|k| (k as f64 + 0.5) * spacing).collect();
    let mut density = vec![0.0; samples];
    for (i, &a) in points.iter().enumerate() {
        for (j, &b) in points.iter().enumerate() {
            let separation = domain.displacement(a, b).norm();
            if i == j || separation > limit + bandwidth {
                continue;
            }
            let weight = 1.0 / visible_fraction(region, a, separation);
            let first = ((separation - bandwidth) / spacing).max(0.0) as usize;
            let last = (((separation + bandwidth) / spacing) as usize + 1).min(samples);
            for k in first..last {
                density[k] += weight * epanechnikov((distance[k] - separation) / bandwidth);
            }
        }
    }
    let total: f64 = density.iter().sum::<f64>() * spacing;
    density.iter_mut().for_each(|p| *p /= total);
    let g = distance
        .iter()
        .zip(&density)
        .map(|(d, p)| limit * limit / (2.0 * d) * p)
        .collect();
    let number_density = points.len() as f64 / (region.width * region.height);
    RadialDistribution {
        distance,
        density,
        g,
        number_density,
    }
}

#[rendered]
impl RadialDistribution {
    /// Two-body excess entropy over the Boltzmann constant, dimensionless, at most zero.
    ///
    /// $$ \frac{S}{k^B} = -\frac n2 \int_0^{l/4} \left( g \log g - (g - 1) \right) 2 \pi d \,\mathrm d d $$
    ///
    /// Thesis eq. (69), with the measure of the plane that it lacks (erratum E25 of the thesis).
    pub fn excess_entropy(&self) -> f64 {
        self.integral(|d, g| TAU * d * (g_log_g(g) - (g - 1.0)))
    }

    /// The same as thesis eq. (84) prints it, without the measure, in 1/m.
    ///
    /// $$ -\frac n2 \left( \frac l4 + \int_0^{l/4} g (\log g - 1) \,\mathrm d d \right) $$
    pub fn excess_entropy_printed(&self) -> f64 {
        self.integral(|_, g| 1.0 + g_log_g(g) - g)
    }

    fn integral(&self, integrand: impl Fn(f64, f64) -> f64) -> f64 {
        let spacing = 2.0 * self.distance.first().copied().unwrap_or_default();
        let pairs = self.distance.iter().zip(&self.g);
        let sum: f64 = pairs.map(|(&d, &g)| integrand(d, g)).sum();
        -0.5 * self.number_density * spacing * sum
    }
}

/// g log g, continued to zero.
fn g_log_g(g: f64) -> f64 {
    if g > 0.0 { g * libm::log(g) } else { 0.0 }
}
