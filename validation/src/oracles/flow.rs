//! Independent high-order integration of ordinary differential equations, with events.
//!
//! One step is the Gragg-Bulirsch-Stoer method: modified midpoint sums with 2, 4, ... 2 K substeps,
//! extrapolated to zero substep. It is generic over the number type, so that a result in double-double
//! shows the accuracy of the result in double.

use num_traits::Float;

/// Number of rows of the extrapolation: a step of length h has an error of order h^(2 K + 1).
const ROWS: usize = 8;

/// State at the end of one extrapolated step, and an estimate of its error.
fn step<F: Float, const N: usize>(
    rate: &impl Fn(F, &[F; N]) -> [F; N],
    time: F,
    state: &[F; N],
    length: F,
) -> ([F; N], F) {
    let mut table = [[[F::zero(); N]; ROWS]; ROWS];
    for row in 0..ROWS {
        table[row][0] = midpoint(rate, time, state, length, 2 * (row + 1));
        for column in 1..=row {
            let ratio = number::<F>(row + 1) / number(row + 1 - column);
            let weight = (ratio * ratio - F::one()).recip();
            let (fine, coarse) = (table[row][column - 1], table[row - 1][column - 1]);
            table[row][column] = std::array::from_fn(|n| fine[n] + (fine[n] - coarse[n]) * weight);
        }
    }
    let (best, next) = (table[ROWS - 1][ROWS - 1], table[ROWS - 1][ROWS - 2]);
    let slope = rate(time, state);
    let error = |n: usize| {
        let size = state[n].abs().max((slope[n] * length).abs());
        (best[n] - next[n]).abs() / size.max(F::min_positive_value())
    };
    let largest = (0..N).map(error).fold(F::zero(), F::max);
    (best, largest)
}

/// Gragg's modified midpoint rule with an even number of substeps.
fn midpoint<F: Float, const N: usize>(
    rate: &impl Fn(F, &[F; N]) -> [F; N],
    time: F,
    state: &[F; N],
    length: F,
    substeps: usize,
) -> [F; N] {
    let h = length / number(substeps);
    let ahead = |from: &[F; N], slope: &[F; N], by: F| {
        std::array::from_fn::<F, N, _>(|n| from[n] + slope[n] * by)
    };
    let (mut before, mut now) = (*state, ahead(state, &rate(time, state), h));
    for k in 1..substeps {
        let slope = rate(time + h * number(k), &now);
        (before, now) = (now, ahead(&before, &slope, h + h));
    }
    let slope = rate(time + length, &now);
    std::array::from_fn(|n| (now[n] + before[n] + slope[n] * h) * number::<F>(2).recip())
}

fn number<F: Float>(count: usize) -> F {
    // Whole numbers below 2^53 are exact in every type used here.
    F::from(count as f64).unwrap_or_else(F::nan)
}

/// A flow: a right-hand side with a tolerance of the relative error per step.
#[derive(Clone, Copy, Debug)]
pub struct Flow<R, F> {
    /// Rate of change of the state, as a function of time and state. Smooth between events.
    pub rate: R,
    /// Largest error of a component per step, relative to its size or to its change, whichever is
    /// larger; at least about ten units of rounding, below which no step can succeed.
    pub tolerance: F,
}

impl<R, F: Float> Flow<R, F> {
    /// State after a duration, with steps as long as the tolerance allows.
    pub fn advance<const N: usize>(&self, start: [F; N], duration: F) -> [F; N]
    where
        R: Fn(F, &[F; N]) -> [F; N],
    {
        self.until(start, duration, |_, _| F::one()).1
    }

    /// Time and state at which an event function first changes from positive to zero, or at the latest
    /// time. The function may be zero at the start but must be positive soon after.
    pub fn until<const N: usize>(
        &self,
        start: [F; N],
        latest: F,
        event: impl Fn(F, &[F; N]) -> F,
    ) -> (F, [F; N])
    where
        R: Fn(F, &[F; N]) -> [F; N],
    {
        let (mut time, mut state) = (F::zero(), start);
        let mut length = latest / number(64);
        while time < latest {
            length = length.min(latest - time);
            let (next, error) = step(&self.rate, time, &state, length);
            let half = number::<F>(2).recip();
            if error > self.tolerance && length > latest * F::epsilon() {
                length = length * half;
                continue;
            }
            if event(time + length, &next) <= F::zero() {
                return self.locate(time, &state, length, event);
            }
            (time, state) = (time + length, next);
            if error < self.tolerance * number::<F>(1024).recip() {
                length = length * number(2);
            }
        }
        (latest, state)
    }

    /// Locates the event within one step by bisection of the step length.
    fn locate<const N: usize>(
        &self,
        time: F,
        state: &[F; N],
        length: F,
        event: impl Fn(F, &[F; N]) -> F,
    ) -> (F, [F; N])
    where
        R: Fn(F, &[F; N]) -> [F; N],
    {
        let (mut low, mut high) = (F::zero(), length);
        let half = number::<F>(2).recip();
        while high - low > (time + high) * F::epsilon() {
            let middle = (low + high) * half;
            if middle <= low || middle >= high {
                break;
            }
            let (there, _) = step(&self.rate, time, state, middle);
            if event(time + middle, &there) > F::zero() {
                low = middle;
            } else {
                high = middle;
            }
        }
        (time + high, step(&self.rate, time, state, high).0)
    }
}

#[cfg(test)]
mod tests {
    use super::Flow;
    use approx::abs_diff_eq;
    use xprec::Df64;

    #[test]
    fn an_oscillator_comes_back_after_its_period() {
        let flow = Flow {
            rate: |_: f64, y: &[f64; 2]| [y[1], -y[0]],
            tolerance: 1e-14,
        };
        let end = flow.advance([1.0, 0.0], std::f64::consts::TAU);
        assert!(
            abs_diff_eq!(end[0], 1.0, epsilon = 1e-13)
                && abs_diff_eq!(end[1], 0.0, epsilon = 1e-13),
            "{end:?}"
        );
        let (time, _) = flow.until([1.0, 0.0], 3.0, |_, y| y[0]);
        assert!(
            abs_diff_eq!(time, std::f64::consts::FRAC_PI_2, epsilon = 4e-14),
            "{time}"
        );
    }

    #[test]
    fn double_double_gives_thirty_digits() {
        let one = Df64::from(1.0);
        let flow = Flow {
            rate: |_: Df64, y: &[Df64; 1]| [y[0]],
            tolerance: Df64::from(1e-31),
        };
        let end = flow.advance([one], one);
        let error = (end[0] - one.exp()).abs();
        assert!(f64::from(error) < 1e-29, "{error:?}");
    }
}
