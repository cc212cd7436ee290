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

/// Divisions of a local problem that do not depend on velocities, so that sweeps need none.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LocalInverses {
    /// $1/(W_{nn} W_{tt} - W_{nt}^2)$ in kg², or zero unless W is regular and the solution unique.
    pub determinant: f64,
    /// $1/(W_{nn} \pm \mu W_{nt})$ in kg, for sliding with positive and with negative tangential impulse.
    pub sliding: [f64; 2],
}

/// Which impulse answers a local problem.
pub trait LocalRule: Copy + Send + Sync {
    /// Whether tangential impulses are all zero, so that the tangential components of the problem are not needed.
    const IS_NORMAL: bool = false;
    /// The impulse of a contact point.
    fn solve(self, problem: &LocalProblem) -> LocalSolution;
    /// The same impulse with fewer operations.
    #[inline(always)]
    fn solve_prepared(self, problem: &LocalProblem, _: &LocalInverses) -> LocalSolution {
        self.solve(problem)
    }
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

/// The laws without friction: [`ExactRule`] with $\mu = 0$, to the bit, whatever the coefficient of friction.
///
/// $$ P_n = \max(a_n, 0)/W_{nn}, \qquad P_t = 0 $$
///
/// The status of a point with an impulse is [`LocalStatus::Sliding`].
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrictionlessRule;

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
        if problem.friction == 0.0 {
            return FrictionlessRule.solve(problem);
        }
        self.solve_prepared(problem, &problem.inverses())
    }

    #[inline(always)]
    fn solve_prepared(self, problem: &LocalProblem, inverses: &LocalInverses) -> LocalSolution {
        if inverses.determinant > 0.0 {
            problem.unique_solution(inverses)
        } else {
            let (problem, inverses) = (*problem, *inverses);
            problem.doubtful_solution(&inverses)
        }
    }
}

impl LocalRule for FrictionlessRule {
    const IS_NORMAL: bool = true;

    #[inline]
    fn solve(self, problem: &LocalProblem) -> LocalSolution {
        let inverses = LocalProblem {
            friction: 0.0,
            ..*problem
        }
        .inverses();
        self.solve_prepared(problem, &inverses)
    }

    #[inline(always)]
    fn solve_prepared(self, problem: &LocalProblem, inverses: &LocalInverses) -> LocalSolution {
        if problem.a_n <= 0.0 {
            return LocalSolution::default();
        }
        if problem.w_nn <= 0.0 {
            return LocalSolution {
                impulse: Components::default(),
                status: LocalStatus::NoSolution,
            };
        }
        LocalSolution {
            impulse: Components {
                n: problem.a_n * inverses.sliding[0],
                t: 0.0,
            },
            status: LocalStatus::Sliding,
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
    /// The divisions that the exact rule needs.
    #[inline]
    pub fn inverses(&self) -> LocalInverses {
        let determinant = self.w_nn * self.w_tt - self.w_nt * self.w_nt;
        let is_unique = self.friction * self.w_nt.abs() < self.w_nn;
        LocalInverses {
            determinant: if determinant > 0.0 && is_unique {
                1.0 / determinant
            } else {
                0.0
            },
            sliding: [
                1.0 / (self.w_nn + self.friction * self.w_nt),
                1.0 / (self.w_nn - self.friction * self.w_nt),
            ],
        }
    }

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
    fn sliding_impulse(&self, sign: f64, inverses: &LocalInverses) -> Components {
        let [positive, negative] = inverses.sliding;
        let n = self.a_n * if sign < 0.0 { negative } else { positive };
        Components {
            n,
            t: sign * self.friction * n,
        }
    }

    /// Whether the sliding velocity under an impulse for sliding opposes it.
    #[inline]
    fn can_slide(&self, impulse: Components, sign: f64) -> bool {
        impulse.n >= 0.0 && self.velocity(impulse).t * sign <= 0.0
    }

    /// The solution where W is regular and the solution unique.
    ///
    /// On the line $u_n = 0$ of the plane of impulses, $u_t$ grows with $P_t$ and vanishes at the sticking impulse, and
    /// the line enters the Coulomb cone at negative and leaves it at positive $P_t$. A sliding impulse therefore has
    /// the direction of the sticking one.
    ///
    /// Both are computed and one of them is selected: in a dense packing, a branch between them would often be
    /// predicted wrongly.
    #[inline(always)]
    fn unique_solution(&self, inverses: &LocalInverses) -> LocalSolution {
        if self.a_n <= 0.0 {
            return LocalSolution::default();
        }
        let stick = Components {
            n: (self.w_tt * self.a_n - self.w_nt * self.a_t) * inverses.determinant,
            t: (self.w_nn * self.a_t - self.w_nt * self.a_n) * inverses.determinant,
        };
        let [positive, negative] = inverses.sliding;
        let n = self.a_n * if stick.t < 0.0 { negative } else { positive };
        let slide = Components {
            n,
            t: self.friction.copysign(stick.t) * n,
        };
        let is_sticking = stick.t.abs() <= self.friction * stick.n;
        LocalSolution {
            impulse: Components {
                n: if is_sticking { stick.n } else { slide.n },
                t: if is_sticking { stick.t } else { slide.t },
            },
            status: if is_sticking {
                LocalStatus::Sticking
            } else {
                LocalStatus::Sliding
            },
        }
    }

    /// The sliding solution, where W is singular and there is exactly one solution.
    fn singular_sliding(&self, inverses: &LocalInverses) -> LocalSolution {
        let sign = if self.a_t < 0.0 { -1.0 } else { 1.0 };
        let mut impulse = self.sliding_impulse(sign, inverses);
        if !self.can_slide(impulse, sign) {
            // At the boundary to sticking, rounding may refuse both directions; they differ by rounding there.
            let other = self.sliding_impulse(-sign, inverses);
            if self.can_slide(other, -sign) {
                impulse = other;
            }
        }
        LocalSolution {
            impulse,
            status: LocalStatus::Sliding,
        }
    }

    /// The solution where W is singular, or the laws may have no solution or several.
    #[cold]
    fn doubtful_solution(&self, inverses: &LocalInverses) -> LocalSolution {
        if self.friction * self.w_nt.abs() >= self.w_nn {
            return self.enumerate(inverses);
        }
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
        self.singular_sliding(inverses)
    }

    /// All statuses, where the laws may have no solution or several.
    fn enumerate(&self, inverses: &LocalInverses) -> LocalSolution {
        let stick = self.sticking_impulse();
        let slide = [1.0, -1.0].map(|sign| (self.sliding_impulse(sign, inverses), sign));
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
