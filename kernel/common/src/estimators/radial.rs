//! Structure of a packing: radial distribution and two-body excess entropy, thesis eqs. (69), (80)-(84).

use crate::geometry::{Domain, Vec2};
use core::f64::consts::{PI, TAU};
use gouge_equations::rendered;

/// Rectangle that contains a packing, with periodic or open sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// Width in m; points have x in [0, width].
    pub width: f64,
    /// Height in m; points have y in [0, height].
    pub height: f64,
    /// Whether x is periodic.
    pub periodic: bool,
}

/// Radial distribution of a packing, sampled at equidistant distances up to a quarter of the width.
#[derive(Clone, Debug, PartialEq)]
pub struct RadialDistribution {
    /// Distances in m.
    pub distance: Vec<f64>,
    /// Probability density of the pair distance in 1/m, thesis eqs. (81)-(82).
    pub density: Vec<f64>,
    /// Radial distribution function g, dimensionless, thesis eq. (83).
    pub g: Vec<f64>,
    /// Number of points per area in 1/m^2.
    pub number_density: f64,
}

impl Region {
    /// Whether a point lies inside the region or on its edge. If x is periodic, only y is tested.
    pub fn contains(&self, point: Vec2) -> bool {
        let (x, y) = (0.0..=self.width, 0.0..=self.height);
        (self.periodic || x.contains(&point.x)) && y.contains(&point.y)
    }
}

/// Fraction of a circle around a point of the region that lies inside the region, in (0, 1].
///
/// The reciprocal of the weight in thesis eq. (80). Arcs beyond the lower and upper edge, and beyond both
/// sides unless x is periodic, are subtracted. Where two such arcs overlap at a corner, the overlap is added
/// back.
pub fn visible_fraction(region: &Region, point: Vec2, distance: f64) -> f64 {
    // Half-angle of the arc beyond an edge at the given distance from the point.
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
            // The two arcs are centred on perpendicular directions.
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
/// Thesis eqs. (80)-(83), with the Epanechnikov kernel as $\Psi$.
///
/// # Symbols
/// $B$ is `bandwidth` in m, $d_{ij}$ the distance of the nearest images in m, $l$ the width of the region in m,
/// $w_{ij}$ the inverse of [`visible_fraction`] and $Z$ the normalisation. `samples` is the number of distances.
///
/// # Domain
/// Points outside the region are left out. Choose a bandwidth below the smallest distance: otherwise the density
/// leaks to zero distance, where g divides by the distance.
///
/// The normalisation sets the mean of g over the disc to one, which biases g by about the inverse of the
/// expected number of neighbours (erratum E49 of the thesis). Cost: one pass over all pairs.
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
        height: None,
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
    /// Two-body excess entropy divided by the Boltzmann constant, dimensionless, never positive.
    ///
    /// $$ \frac{S}{k^B} = -\frac n2 \int_0^{l/4} \left( g \log g - (g - 1) \right) 2 \pi d \,\mathrm d d $$
    ///
    /// Thesis eq. (69), including the measure 2 pi d of the plane, which the thesis omits (erratum E25 of the
    /// thesis).
    pub fn excess_entropy(&self) -> f64 {
        self.integral(|d, g| TAU * d * (g_log_g(g) - (g - 1.0)))
    }

    /// Thesis eq. (84) as printed, without the measure of the plane, in 1/m.
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

/// g log g, zero at g = 0.
fn g_log_g(g: f64) -> f64 {
    if g > 0.0 { g * libm::log(g) } else { 0.0 }
}
