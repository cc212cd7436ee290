//! Mean deformation of points.

use crate::geometry::Vec2;
use gouge_equations::rendered;

/// Least part of the squared size of a set of points that it must extend across its longest line.
const FLATTEST: f64 = 1e-14;

/// Displacement gradient of points, dimensionless: `[[xx, xy], [yx, yy]]`.
///
/// $$ H_{ab} = \frac{\partial u_a}{\partial X_b}: \quad \sum_i \left| u_i - \bar u - H (X_i - \bar X) \right|^2 \text{ is least} $$
///
/// X are the points and u their displacements, both in m; bars are means over all points. Its symmetric part is the
/// strain, positive in extension; half the difference yx - xy is the mean rotation in rad, if all is small. Exact if the
/// deformation is homogeneous. NaN for fewer than three points and for points on a line, which do not determine it.
#[rendered]
pub fn displacement_gradient(points: &[Vec2], displacements: &[Vec2]) -> [[f64; 2]; 2] {
    let (center, shift) = (mean(points), mean(displacements));
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    let mut products = [[0.0; 2]; 2];
    for (&point, &displacement) in points.iter().zip(displacements) {
        let (x, u) = (point - center, displacement - shift);
        (xx, xy, yy) = (xx + x.x * x.x, xy + x.x * x.y, yy + x.y * x.y);
        for (row, u) in products.iter_mut().zip([u.x, u.y]) {
            row[0] += u * x.x;
            row[1] += u * x.y;
        }
    }
    let determinant = xx * yy - xy * xy;
    let is_spread = determinant > FLATTEST * (xx + yy) * (xx + yy);
    let scale = if is_spread {
        1.0 / determinant
    } else {
        f64::NAN
    };
    products.map(|[x, y]| [scale * (x * yy - y * xy), scale * (y * xx - x * xy)])
}

fn mean(vectors: &[Vec2]) -> Vec2 {
    let sum = vectors
        .iter()
        .fold(Vec2::zero(), |sum, &vector| sum + vector);
    sum * (1.0 / vectors.len() as f64)
}
