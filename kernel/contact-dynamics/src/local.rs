//! The local problem: one contact point, with all other impulses frozen.

use gouge_equations::rendered;

/// The problem of one contact point, azema (A19)-(A20), written with impulses.
///
/// $$ W_{nn} P_n + W_{nt} P_t - a_n = u_n, \qquad W_{nt} P_n + W_{tt} P_t - a_t = u_t $$
///
/// | letter | field | meaning | unit |
/// |---|---|---|---|
/// | $W$ | `w_nn`, `w_tt`, `w_nt` | Delassus operator of the point, positive semi-definite | 1/kg |
/// | $a$ | `a_n`, `a_t` | minus the velocity that enters the laws, without this point's impulse | m/s |
/// | $\mu$ | `friction` | coefficient of friction | 1 |
/// | $P$ | result | impulse on the second body, repulsion positive | kg m/s |
/// | $u$ | result | velocity that enters the laws, separation positive | m/s |
///
/// # Errata and departures
/// (A21)-(A22) print the opposite sign of the frozen part of a: azema E4.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalProblem {
    /// Normal response to a normal impulse in 1/kg.
    pub w_nn: f64,
    /// Tangential response to a tangential impulse in 1/kg.
    pub w_tt: f64,
    /// Response of one direction to an impulse in the other in 1/kg.
    pub w_nt: f64,
    /// Normal approach velocity to be stopped in m/s.
    pub a_n: f64,
    /// Tangential velocity to be stopped in m/s, with reversed sign.
    pub a_t: f64,
    /// Coefficient of friction, non-negative.
    pub friction: f64,
}

/// Normal and tangential component.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Components {
    /// Normal component.
    pub n: f64,
    /// Tangential component.
    pub t: f64,
}

/// How a local problem was solved.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LocalStatus {
    /// No impulse; the bodies separate.
    #[default]
    Separated,
    /// Neither component of the velocity remains.
    Sticking,
    /// The tangential impulse is at the Coulomb limit, opposite to the sliding velocity.
    Sliding,
    /// No impulse satisfies the laws; the impulse is zero. Only if $\mu |W_{nt}| \ge W_{nn}$.
    NoSolution,
    /// Several impulses satisfy the laws; the first in the order of this list is taken, and of two sliding ones the one
    /// with positive tangential impulse. Only if $\mu |W_{nt}| \ge W_{nn}$.
    SeveralSolutions,
}

impl LocalStatus {
    /// Whether the laws have exactly one solution.
    pub fn is_unique(self) -> bool {
        !matches!(self, Self::NoSolution | Self::SeveralSolutions)
    }
}

/// An impulse and how it was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LocalSolution {
    /// Impulse on the second body in kg m/s.
    pub impulse: Components,
    /// Status of the contact point.
    pub status: LocalStatus,
}

/// Which impulse answers a local problem.
pub trait LocalRule: Copy + Send + Sync {
    /// The impulse of a contact point.
    fn solve(self, problem: &LocalProblem) -> LocalSolution;
}

/// The laws of Signorini and Coulomb, azema (A1)-(A3), solved exactly by enumeration of the statuses.
///
/// $$ u_n \ge 0,\quad P_n \ge 0,\quad u_n P_n = 0,\qquad |P_t| \le \mu P_n,\quad P_t u_t = -\mu P_n |u_t| $$
///
/// For $\mu |W_{nt}| < W_{nn}$ there is exactly one solution. Beyond, there may be none, one, two or three, which the
/// status reports.
///
/// # Domain and numerics
/// All finite inputs with $W_{nn} \ge 0$. If W is singular and sticking therefore undetermined, the point sticks
/// without a tangential impulse where that is a solution, and slides otherwise.
///
/// # Errata and departures
/// The text after (A20) infers a unique solution from W being positive, which $W_{nt}$ is not: azema E16.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExactRule;

/// The rule printed in the text after azema (A26), for comparison only.
///
/// The contact breaks if the normal impulse for sticking is negative; otherwise that impulse is kept, and the
/// tangential one is cut to the Coulomb limit.
///
/// # Errata and departures
/// A sliding point so obtained violates the law of Signorini unless $W_{nt} = 0$: azema E7.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PaperRule;

impl LocalRule for ExactRule {
    #[inline]
    fn solve(self, problem: &LocalProblem) -> LocalSolution {
        if problem.friction * problem.w_nt.abs() < problem.w_nn {
            problem.unique_solution()
        } else {
            problem.enumerate()
        }
    }
}

impl LocalRule for PaperRule {
    #[inline]
    fn solve(self, problem: &LocalProblem) -> LocalSolution {
        let stick = problem.sticking_impulse();
        if stick.n.is_nan() || stick.n < 0.0 {
            return LocalSolution::default();
        }
        let limit = problem.friction * stick.n;
        let status = match stick.t.abs() <= limit {
            true => LocalStatus::Sticking,
            false => LocalStatus::Sliding,
        };
        let impulse = Components {
            n: stick.n,
            t: stick.t.max(-limit).min(limit),
        };
        LocalSolution { impulse, status }
    }
}

impl LocalProblem {
    /// Velocity that enters the laws, in m/s, under an impulse.
    #[inline]
    pub fn velocity(&self, impulse: Components) -> Components {
        Components {
            n: self.w_nn * impulse.n + self.w_nt * impulse.t - self.a_n,
            t: self.w_nt * impulse.n + self.w_tt * impulse.t - self.a_t,
        }
    }

    /// The impulse that leaves no velocity, azema (A25)-(A26), or the normal one alone if W is singular.
    ///
    /// The second terms of both numerators are printed with the wrong components: azema E6.
    #[inline]
    pub fn sticking_impulse(&self) -> Components {
        let determinant = self.w_nn * self.w_tt - self.w_nt * self.w_nt;
        if determinant > 0.0 {
            let inverse = 1.0 / determinant;
            return Components {
                n: (self.w_tt * self.a_n - self.w_nt * self.a_t) * inverse,
                t: (self.w_nn * self.a_t - self.w_nt * self.a_n) * inverse,
            };
        }
        Components {
            n: self.a_n / self.w_nn,
            t: 0.0,
        }
    }

    /// Whether an impulse that was computed for sticking leaves no tangential velocity. With a regular W it does.
    #[inline]
    fn can_stick(&self, impulse: Components) -> bool {
        let is_regular = self.w_nn * self.w_tt - self.w_nt * self.w_nt > 0.0;
        let is_inside = impulse.t.abs() <= self.friction * impulse.n;
        is_inside && (is_regular || self.velocity(impulse).t == 0.0)
    }

    /// The impulse for sliding with the tangential impulse in the direction of `sign`.
    #[inline]
    fn sliding_impulse(&self, sign: f64) -> Components {
        let ratio = sign * self.friction;
        let n = self.a_n / (self.w_nn + ratio * self.w_nt);
        Components { n, t: ratio * n }
    }

    /// Whether the sliding velocity under an impulse for sliding opposes it.
    #[inline]
    fn can_slide(&self, impulse: Components, sign: f64) -> bool {
        impulse.n >= 0.0 && self.velocity(impulse).t * sign <= 0.0
    }

    #[inline]
    fn unique_solution(&self) -> LocalSolution {
        if self.a_n <= 0.0 {
            return LocalSolution::default();
        }
        let stick = self.sticking_impulse();
        if self.can_stick(stick) {
            return LocalSolution {
                impulse: stick,
                status: LocalStatus::Sticking,
            };
        }
        let likely = if stick.n >= 0.0 && stick.t != 0.0 {
            stick.t
        } else {
            self.a_t
        };
        let sign = if likely < 0.0 { -1.0 } else { 1.0 };
        let mut impulse = self.sliding_impulse(sign);
        if !self.can_slide(impulse, sign) {
            // At the boundary to sticking, rounding may refuse both directions; they differ by rounding there.
            let other = self.sliding_impulse(-sign);
            if self.can_slide(other, -sign) {
                impulse = other;
            }
        }
        LocalSolution {
            impulse,
            status: LocalStatus::Sliding,
        }
    }

    /// All statuses, where the laws may have no solution or several.
    #[cold]
    fn enumerate(&self) -> LocalSolution {
        let stick = self.sticking_impulse();
        let slide = [1.0, -1.0].map(|sign| (self.sliding_impulse(sign), sign));
        let is_slide =
            slide.map(|(impulse, sign)| impulse.n > 0.0 && self.can_slide(impulse, sign));
        let candidates = [
            (
                self.a_n <= 0.0,
                Components::default(),
                LocalStatus::Separated,
            ),
            (
                stick.n > 0.0 && self.can_stick(stick),
                stick,
                LocalStatus::Sticking,
            ),
            (is_slide[0], slide[0].0, LocalStatus::Sliding),
            (is_slide[1], slide[1].0, LocalStatus::Sliding),
        ];
        let mut solutions = candidates.iter().filter(|(holds, ..)| *holds);
        let Some(&(_, impulse, status)) = solutions.next() else {
            return LocalSolution {
                impulse: Components::default(),
                status: LocalStatus::NoSolution,
            };
        };
        let status = match solutions.next() {
            Some(_) => LocalStatus::SeveralSolutions,
            None => status,
        };
        LocalSolution { impulse, status }
    }
}
