//! `[contact]`, `[solver]`: how a step goes.

use super::Result;
use crate::scene::table::{Range, Table};
use gouge_contact_dynamics::detection::{DetectionSettings, PointLine};
use gouge_contact_dynamics::law::{ContactLaw, GapRule};
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::step::{Scheme, StepSettings};
use gouge_contact_dynamics::sweep::{Rule, StopCriterion, SweepOrder, SweepSettings};

/// Longest distance over which an impulse is remembered, in mean diameters.
const WARM_START: f64 = 0.3;
/// Default of `tolerance`: changes of impulses in mean impulses.
const TOLERANCE: f64 = 1e-3;
/// Smallest denominator of the relative criterion in mean impulses.
const FLOOR: f64 = 1e-3;
/// Most sweeps of a step, unless the scene says otherwise.
const MOST_SWEEPS: u64 = 1000;

/// How a step goes, for bodies of a mean diameter in m.
pub(super) fn settings(
    root: &Table,
    time: &Table,
    step: f64,
    diameter: f64,
) -> Result<StepSettings> {
    let table = root.table("contact")?;
    table.allow(&[
        "friction",
        "normal_restitution",
        "tangential_restitution",
        "alert_distance",
        "merge_distance",
        "tie_distance",
        "warm_start_distance",
        "point_line",
        "gap",
    ])?;
    let schemes = [
        ("midpoint", Scheme::Midpoint),
        ("beginning", Scheme::Beginning),
    ];
    let scheme = time.optional_choice("scheme", &schemes)?;
    Ok(StepSettings {
        time_step: step,
        scheme: scheme.unwrap_or_default(),
        detection: detection(&table, diameter)?,
        law: ContactLaw {
            friction: table.number("friction", Range::NonNegative)?,
            restitution: Components {
                n: restitution(&table, "normal_restitution", 0.0)?,
                t: restitution(&table, "tangential_restitution", -1.0)?,
            },
            gap: gap(&table)?,
        },
        sweeps: sweeps(root)?,
        warm_start_distance: length(&table, "warm_start_distance", WARM_START * diameter)?,
    })
}

/// Lengths of detection, by default in parts of a mean diameter in m.
fn detection(table: &Table, diameter: f64) -> Result<DetectionSettings> {
    let usual = DetectionSettings::for_diameter(diameter);
    let lines = [
        ("common", PointLine::Common),
        ("half-way", PointLine::HalfWay),
    ];
    let line = table.optional_choice("point_line", &lines)?;
    Ok(DetectionSettings {
        alert_distance: length(table, "alert_distance", usual.alert_distance)?,
        merge_distance: length(table, "merge_distance", usual.merge_distance)?,
        tie_distance: length(table, "tie_distance", usual.tie_distance)?,
        line: line.unwrap_or_default(),
    })
}

fn length(table: &Table, key: &str, default: f64) -> Result<f64> {
    let given = table.optional_number(key, Range::NonNegative)?;
    Ok(given.unwrap_or(default))
}

/// A coefficient of restitution from a lowest value to 1; 0 by default.
fn restitution(table: &Table, key: &str, lowest: f64) -> Result<f64> {
    let given = table.optional_number(key, Range::Finite)?.unwrap_or(0.0);
    match (lowest..=1.0).contains(&given) {
        true => Ok(given),
        false => Err(table.error(key, &format!("must be a number from {lowest:?} to 1.0"))),
    }
}

/// `[contact.gap]`.
fn gap(contact: &Table) -> Result<GapRule> {
    let Some(table) = contact.optional_table("gap")? else {
        return Ok(GapRule::default());
    };
    let stabilized = GapRule::Stabilized {
        fraction: 0.0,
        allowed_overlap: 0.0,
    };
    let laws = [
        ("closed", GapRule::Closed),
        ("predicted", GapRule::Predicted),
        ("stabilized", stabilized),
    ];
    let law = table.choice("law", &laws)?;
    if law != stabilized {
        table.allow(&["law"])?;
        return Ok(law);
    }
    table.allow(&["law", "fraction", "allowed_overlap"])?;
    let fraction = table.number("fraction", Range::NonNegative)?;
    if fraction > 1.0 {
        return Err(table.error("fraction", "must be a number from 0.0 to 1.0"));
    }
    Ok(GapRule::Stabilized {
        fraction,
        allowed_overlap: table.number("allowed_overlap", Range::NonNegative)?,
    })
}

/// `[solver]`.
fn sweeps(root: &Table) -> Result<SweepSettings> {
    let Some(table) = root.optional_table("solver")? else {
        return Ok(SweepSettings::default());
    };
    table.allow(&[
        "criterion",
        "tolerance",
        "floor",
        "largest_residual",
        "max_sweeps",
        "momentum",
        "order",
        "rule",
    ])?;
    let orders = [
        ("alternating", SweepOrder::Alternating),
        ("forward", SweepOrder::Forward),
        ("strips", SweepOrder::Strips),
    ];
    let rules = [("exact", Rule::Exact), ("paper", Rule::Paper)];
    let momentum = table.optional_number("momentum", Range::NonNegative)?;
    if momentum.is_some_and(|momentum| momentum >= 1.0) {
        return Err(table.error("momentum", "must be at least 0 and less than 1"));
    }
    let most = table.optional_whole_within("max_sweeps", 1, u64::from(u32::MAX))?;
    Ok(SweepSettings {
        stop: criterion(&table)?,
        largest_residual: table.optional_number("largest_residual", Range::Positive)?,
        momentum: momentum.unwrap_or(0.0),
        max_sweeps: most.unwrap_or(MOST_SWEEPS) as usize,
        order: table.optional_choice("order", &orders)?.unwrap_or_default(),
        rule: table.optional_choice("rule", &rules)?.unwrap_or_default(),
    })
}

#[derive(Clone, Copy, PartialEq)]
enum Criterion {
    Increment,
    Relative,
    Residual,
}

fn criterion(table: &Table) -> Result<StopCriterion> {
    let names = [
        ("increment", Criterion::Increment),
        ("relative", Criterion::Relative),
        ("residual", Criterion::Residual),
    ];
    let kind = table.optional_choice("criterion", &names)?;
    let kind = kind.unwrap_or(Criterion::Increment);
    let floor = table.optional_number("floor", Range::NonNegative)?;
    if floor.is_some() && kind == Criterion::Residual {
        return Err(table.error("floor", "has no meaning for the criterion \"residual\""));
    }
    let tolerance = table.optional_number("tolerance", Range::Positive)?;
    if tolerance.is_none() && kind == Criterion::Residual {
        let accepted = "missing; the criterion \"residual\" needs a velocity in m/s";
        return Err(table.error("tolerance", accepted));
    }
    let tolerance = tolerance.unwrap_or(TOLERANCE);
    Ok(match kind {
        Criterion::Increment => StopCriterion::Increment {
            tolerance,
            floor: floor.unwrap_or(f64::MIN_POSITIVE),
        },
        Criterion::Relative => StopCriterion::Relative {
            tolerance,
            floor: floor.unwrap_or(FLOOR),
        },
        Criterion::Residual => StopCriterion::NaturalMap {
            velocity: tolerance,
        },
    })
}
