//! Visits of points one after the other.

use super::changes::Changes;
use super::unit::Units;
use super::{Row, Rule};
use crate::local::{ExactRule, FrictionlessRule, LocalRule, PaperRule};

/// What all visits of a sweep share.
#[derive(Clone, Copy, Debug)]
pub(super) struct Visit {
    pub rule: Rule,
    pub friction: f64,
    /// Smallest denominator of relative changes in kg m/s; `None` if only absolute changes are of interest.
    pub floor: Option<f64>,
    pub is_backward: bool,
}

impl Visit {
    /// Visit points.
    pub fn run(self, rows: &mut [Row], units: impl Units) -> Changes {
        match self.rule {
            Rule::Exact if self.friction == 0.0 => self.run_with(FrictionlessRule, rows, units),
            Rule::Exact => self.run_with(ExactRule, rows, units),
            Rule::Paper => self.run_with(PaperRule, rows, units),
        }
    }

    fn run_with(self, rule: impl LocalRule, rows: &mut [Row], units: impl Units) -> Changes {
        match (self.floor, self.is_backward) {
            (None, false) => self.visit::<_, _, false>(rule, rows.iter_mut(), units),
            (None, true) => self.visit::<_, _, false>(rule, rows.iter_mut().rev(), units),
            (Some(_), false) => self.visit::<_, _, true>(rule, rows.iter_mut(), units),
            (Some(_), true) => self.visit::<_, _, true>(rule, rows.iter_mut().rev(), units),
        }
    }

    #[inline(never)]
    fn visit<'a, R: LocalRule, U: Units, const IS_RELATIVE: bool>(
        self,
        rule: R,
        rows: impl Iterator<Item = &'a mut Row>,
        mut units: U,
    ) -> Changes {
        let mut changes = Changes::default();
        let (friction, floor) = (self.friction, self.floor.unwrap_or_default());
        for row in rows {
            let change = row.update(rule, friction, &mut units);
            changes.add::<IS_RELATIVE>(change, row.impulse(), floor);
        }
        changes
    }
}
