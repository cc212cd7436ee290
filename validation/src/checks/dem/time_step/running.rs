//! Whether the amplitude of a run grows.

use crate::checks::Failure;

/// Steps before the first comparison: decaying modes vanish, and growing ones emerge.
const FIRST: usize = 512;
/// Longest block of steps that is compared with the next one.
const LONGEST: usize = 16_384;
/// Logarithm of the ratio of two blocks' peaks above which the run is decided.
const MARGIN: f64 = 0.02;
/// Amplitude above which the run certainly grows.
const BEYOND_DOUBT: f64 = 1e60;

/// Amplitude, relative to the first, below which only rounding is left.
const DEAD: f64 = 1e-12;

/// Whether an amplitude of initially about one grows over the steps. The peak of a block of steps is
/// compared with that of the block before; block lengths double until the two differ. An amplitude that
/// neither grows nor decays in thirty thousand steps counts as not growing.
///
/// # Errors
/// Those of the run.
pub fn grows(mut amplitude: impl FnMut() -> Result<f64, Failure>) -> Result<bool, Failure> {
    let mut peak = |steps: usize| -> Result<f64, Failure> {
        let mut peak: f64 = 0.0;
        for _ in 0..steps {
            peak = peak.max(amplitude()?.abs());
            if peak > BEYOND_DOUBT {
                break;
            }
        }
        Ok(peak)
    };
    let mut steps = FIRST;
    // The first block may contain decaying modes and is not compared.
    if peak(FIRST)? > BEYOND_DOUBT {
        return Ok(true);
    }
    while steps <= LONGEST {
        let (before, after) = (peak(steps)?, peak(steps)?);
        if after > BEYOND_DOUBT {
            return Ok(true);
        }
        if after < DEAD {
            return Ok(false);
        }
        let ratio = (after / before).ln();
        if ratio.abs() > MARGIN {
            return Ok(ratio > 0.0);
        }
        steps *= 2;
    }
    Ok(false)
}
