//! The laws of Signorini and Coulomb at one point, as complementarity problems.

use xprec::Df64;

/// A contact point: impulses (n, t) change its velocity by W, and the velocity -a remains without them.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Normal, tangential and mixed response in 1/kg.
    pub response: [f64; 3],
    /// Minus the velocity without an impulse in m/s.
    pub approach: [f64; 2],
    /// Coefficient of friction.
    pub friction: f64,
}

impl Point {
    /// How far an impulse is from satisfying the laws, in m/s, computed in double-double precision.
    ///
    /// The laws are three complementarities: of the normal velocity and the normal impulse, and of sliding in either
    /// direction and the distance of the tangential impulse from the limit that belongs to it. The residual is the
    /// largest size of the smaller factors, with impulses multiplied by the larger response.
    pub fn residual(&self, impulse: [f64; 2]) -> f64 {
        let [nn, tt, nt] = self.response.map(Df64::from);
        let [p_n, p_t] = impulse.map(Df64::from);
        let [a_n, a_t] = self.approach.map(Df64::from);
        let u_n = nn * p_n + nt * p_t - a_n;
        let u_t = nt * p_n + tt * p_t - a_t;
        let limit = Df64::from(self.friction) * p_n;
        let scale = Df64::from(self.response[0].max(self.response[1]));
        let pairs = [
            (u_n, scale * p_n),
            (positive(u_t), scale * (limit + p_t)),
            (positive(-u_t), scale * (limit - p_t)),
        ];
        let smaller = |(a, b): (Df64, Df64)| if a.hi() < b.hi() { a } else { b };
        let sizes = pairs.map(|pair| smaller(pair).hi().abs());
        sizes.into_iter().fold(0.0, f64::max)
    }

    /// All impulses that satisfy the laws, up to a relative margin at their limits; with a negative margin, those that
    /// satisfy them by as much where they do not have to be equal to the limit.
    ///
    /// With the distance s from the limit in one direction and the sliding velocity v in that direction, the laws are a
    /// linear complementarity problem in (P_n, s, v), whose eight choices of zeros are solved one after the other.
    pub fn solutions_within(&self, margin: f64) -> Vec<[f64; 2]> {
        let [nn, tt, nt] = self.response;
        let mu = self.friction;
        let matrix = [
            [nn - mu * nt, nt, 0.0],
            [nt - mu * tt, tt, 1.0],
            [2.0 * mu, -1.0, 0.0],
        ];
        let vector = [-self.approach[0], -self.approach[1], 0.0];
        let mut found: Vec<[f64; 2]> = Vec::new();
        for choice in 0..8_u32 {
            let is_free = [0, 1, 2].map(|k| choice >> k & 1 == 1);
            let Some(z) = complementary(&matrix, vector, is_free, margin) else {
                continue;
            };
            let impulse = [z[0], z[1] - mu * z[0]];
            let size = impulse[0].abs() + impulse[1].abs();
            let is_same = |old: &[f64; 2]| {
                let distance = (old[0] - impulse[0]).abs() + (old[1] - impulse[1]).abs();
                distance <= 1e-4 * size
            };
            if !found.iter().any(is_same) {
                found.push(impulse);
            }
        }
        found
    }

    /// Factor by which rounding of the data may grow in the solution: that of the response matrix, and that of the
    /// response in sliding.
    pub fn condition(&self) -> f64 {
        let [nn, tt, nt] = self.response;
        let mean = 0.5 * (nn + tt);
        let radius = (0.5 * (nn - tt)).hypot(nt);
        let matrix = (mean + radius) / (mean - radius);
        let coupling = self.friction * nt.abs();
        let sliding = (nn + coupling) / (nn - coupling).abs();
        matrix.max(sliding)
    }

    /// Size of the velocity without an impulse in m/s.
    pub fn speed(&self) -> f64 {
        self.approach[0].hypot(self.approach[1])
    }
}

fn positive(x: Df64) -> Df64 {
    if x.hi() > 0.0 { x } else { Df64::from(0.0) }
}

/// The solution z of w = M z + q with w = 0 where z is free and z = 0 elsewhere, if neither is negative.
fn complementary(
    matrix: &[[f64; 3]; 3],
    vector: [f64; 3],
    is_free: [bool; 3],
    margin: f64,
) -> Option<[f64; 3]> {
    // Rows of fixed components are replaced by those of the unit matrix.
    let mut rows = [[0.0; 4]; 3];
    for k in 0..3 {
        match is_free[k] {
            true => {
                rows[k][..3].copy_from_slice(&matrix[k]);
                rows[k][3] = -vector[k];
            }
            false => rows[k][k] = 1.0,
        }
    }
    let z = eliminated(rows)?;
    let size: f64 = z.iter().map(|x| x.abs()).sum();
    let is_positive = (0..3).all(|k| !is_free[k] || z[k] >= -margin * size);
    let is_admissible = (0..3).filter(|&k| !is_free[k]).all(|k| {
        let terms = [0, 1, 2].map(|j| matrix[k][j] * z[j]);
        let w = terms.iter().sum::<f64>() + vector[k];
        let scale = terms.iter().map(|x| x.abs()).sum::<f64>() + vector[k].abs();
        w >= -margin * scale
    });
    (is_positive && is_admissible).then_some(z)
}

/// Gauss elimination with pivots of three equations.
fn eliminated(mut rows: [[f64; 4]; 3]) -> Option<[f64; 3]> {
    for column in 0..3 {
        let by_size = |&a: &usize, &b: &usize| {
            let [one, other] = [a, b].map(|row| rows[row][column].abs());
            one.total_cmp(&other)
        };
        let pivot = (column..3).max_by(by_size)?;
        rows.swap(column, pivot);
        if rows[column][column] == 0.0 {
            return None;
        }
        let base = rows[column];
        for row in (0..3).filter(|&row| row != column) {
            let factor = rows[row][column] / base[column];
            for (x, y) in rows[row].iter_mut().zip(base) {
                *x -= factor * y;
            }
        }
    }
    Some([0, 1, 2].map(|k| rows[k][3] / rows[k][k]))
}
