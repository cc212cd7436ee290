//! Regions of the unit cube that are searched closely.

use super::sobol;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// What is added to each side of a region, in units of its length.
const MARGIN: f64 = 0.1;
/// So many of the highest points shape a region in any case.
const FEWEST: usize = 100;

/// A box with its own axes.
#[derive(Clone, Debug)]
pub struct Region {
    /// The axes, as columns.
    axes: DMatrix<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
}

impl Region {
    /// The whole cube.
    pub fn cube(dimensions: usize) -> Self {
        Self {
            axes: DMatrix::identity(dimensions, dimensions),
            low: vec![0.0; dimensions],
            high: vec![1.0; dimensions],
        }
    }

    /// The box, with some margin, around the points whose height is at most `depth` below the largest one, along their
    /// principal axes.
    pub fn around(points: &[Vec<f64>], heights: &[f64], depth: f64) -> Self {
        let mut sorted = heights.to_vec();
        sorted.sort_by(|a, b| b.total_cmp(a));
        let top = sorted.first().copied().unwrap_or_default();
        let many = sorted.get(FEWEST).copied().unwrap_or(f64::NEG_INFINITY);
        let lowest = many.min(top - depth);
        let pairs = points.iter().zip(heights);
        let high = pairs.filter(|(_, height)| **height >= lowest);
        let high: Vec<DVector<f64>> = high
            .map(|(point, _)| DVector::from_column_slice(point))
            .collect();
        let axes = SymmetricEigen::new(covariance(&high)).eigenvectors;
        let mut region = Self {
            low: vec![f64::INFINITY; axes.ncols()],
            high: vec![f64::NEG_INFINITY; axes.ncols()],
            axes,
        };
        for place in high.iter().map(|point| region.axes.tr_mul(point)) {
            for (k, &x) in place.iter().enumerate() {
                region.low[k] = region.low[k].min(x);
                region.high[k] = region.high[k].max(x);
            }
        }
        for (low, high) in region.low.iter_mut().zip(&mut region.high) {
            let margin = MARGIN * (*high - *low);
            (*low, *high) = (*low - margin, *high + margin);
        }
        region
    }

    /// Points that fill the part of the box inside the unit cube evenly.
    pub fn points(&self, number: u32, seed: u32) -> Vec<Vec<f64>> {
        let inside = |point: &Vec<f64>| point.iter().all(|x| (0.0..=1.0).contains(x));
        let places = sobol::points(number, self.low.len(), seed);
        places.map(|place| self.at(&place)).filter(inside).collect()
    }

    /// The point at a place of the box, from 0 to 1 along each axis.
    fn at(&self, place: &[f64]) -> Vec<f64> {
        let sides = self.low.iter().zip(&self.high).zip(place);
        let along = sides.map(|((low, high), x)| low + (high - low) * x);
        let along = DVector::from_iterator(place.len(), along);
        (&self.axes * along).iter().copied().collect()
    }
}

fn covariance(points: &[DVector<f64>]) -> DMatrix<f64> {
    let dimensions = points.first().map_or(0, DVector::len);
    let number = points.len() as f64;
    let mean = points.iter().sum::<DVector<f64>>() / number;
    let deviations = points.iter().map(|point| point - &mean);
    let zero = DMatrix::zeros(dimensions, dimensions);
    deviations.fold(zero, |sum, one| sum + &one * one.transpose()) / number
}
