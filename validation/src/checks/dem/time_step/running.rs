//! Whether a run grows, and how fast.

use crate::checks::Failure;

/// Steps before anything is compared: modes that die out are gone, one that grows has shown itself.
const FIRST: usize = 512;
/// Longest block of steps that is compared with the next.
const LONGEST: usize = 16_384;
/// Logarithm of the ratio of the peaks of two blocks that decides.
const MARGIN: f64 = 0.02;
/// Factor from which on there is no doubt.
const BEYOND_DOUBT: f64 = 1e60;

/// Part of the first amplitude below which only rounding is left.
const DEAD: f64 = 1e-12;

/// Whether an amplitude that is given step by step, from about one, grows: the peak of a block of steps
/// against that of the block before, in blocks twice as long until the two differ. What neither grows nor
/// dies in thirty thousand steps does not grow.
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
    // The first block may hold what dies out: it is not compared.
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
