//! Figures of the series.

use crate::run::columns::Columns;
use crate::run::outcome::Summary;
use crate::run::stress_strain::stress_strain;
use crate::scene::Scene;
use gouge_page::{Axis, Curve, Figure, Guide};
use maud::{Markup, html};

/// A figure: its title, the quantity and its unit, and the columns with their labels.
pub type Plan = (
    &'static str,
    [&'static str; 2],
    &'static [(&'static str, &'static str)],
);

/// The quantity that only a block that slides has.
const FRICTION: &str = "coefficient of friction";

/// The figures of every series, as far as it has their columns.
const PLANS: [Plan; 14] = [
    (
        "Energies of the grains.",
        ["energy", "J"],
        &[
            ("kinetic", "kinetic"),
            ("contacts and bonds", "contact"),
            ("external field", "external"),
        ],
    ),
    (
        "Heat and work since t = 0.",
        ["energy", "J"],
        &[
            ("heat of contacts and bonds", "friction"),
            ("heat of the medium", "ambient"),
            ("lost with broken bonds", "breaking"),
            ("work of the drive", "driving"),
        ],
    ),
    (
        "Residual of the energy balance.",
        ["energy", "J"],
        &[("residual", "residual")],
    ),
    (
        "Coefficient of friction.",
        [FRICTION, ""],
        &[
            ("from the applied force", "friction_load"),
            ("from the reaction", "friction_feedback"),
        ],
    ),
    (
        "Driving force.",
        ["force", "N"],
        &[("along x", "drive_force_x"), ("along y", "drive_force_y")],
    ),
    ("Intact bonds.", ["number", ""], &[("bonds", "bonds")]),
    (
        "Fragments, single grains among them.",
        ["number", ""],
        &[("fragments", "fragments")],
    ),
    (
        "Mean stress in the specimen, positive in tension.",
        ["stress", "Pa"],
        &[
            ("xx", "stress_xx"),
            ("xy", "stress_xy"),
            ("yx", "stress_yx"),
            ("yy", "stress_yy"),
        ],
    ),
    (
        "Strain of the free grains since t = 0.",
        ["strain", ""],
        &[
            ("xx", "strain_xx"),
            ("yy", "strain_yy"),
            ("xy", "strain_xy"),
        ],
    ),
    (
        "Mean number of contacts and bonds per grain.",
        ["coordination", ""],
        &[("coordination", "coordination")],
    ),
    (
        "Packing fraction of the specimen.",
        ["packing fraction", ""],
        &[("packing fraction", "packing_fraction")],
    ),
    (
        "Unbalanced force over mean force.",
        ["unbalanced force", ""],
        &[("unbalanced force", "unbalanced_force")],
    ),
    (
        "Largest overlap over the smaller radius.",
        ["overlap", ""],
        &[("largest overlap", "largest_overlap")],
    ),
    (
        "Rolling and slip in the debris.",
        ["speed", "m/s"],
        &[("rolling", "rolling_speed"), ("slip", "slip_speed")],
    ),
];

/// All figures that show something.
pub fn chapter(scene: &Scene, summary: &Summary, series: &Columns) -> Markup {
    let slides = scene.driving.is_some_and(|driving| driving.speed != 0.0);
    let plans = PLANS
        .iter()
        .filter(|(_, [quantity, _], _)| slides || *quantity != FRICTION);
    let over_time = plans.filter_map(|plan| figure(plan, series));
    let figures: Vec<Figure> = over_time.chain(stress_strain(series)).collect();
    html! {
        @if !figures.is_empty() {
            h2 { "Series" }
            div.figures {
                @for figure in &figures { (with_friction(figure, scene, summary).html()) }
            }
        }
    }
}

/// A figure of the columns that are there and not zero throughout; none if there are no such columns.
pub fn figure((title, [quantity, unit], columns): &Plan, series: &Columns) -> Option<Figure> {
    let shows = |curve: &Curve| {
        curve
            .points
            .iter()
            .any(|point| point[1] != 0.0 && point[1].is_finite())
    };
    let curves = columns
        .iter()
        .filter_map(|(label, name)| series.curve(label, ["time", name]));
    let curves: Vec<Curve> = curves.filter(shows).collect();
    let axes = (Axis::linear("time", "s"), Axis::linear(quantity, unit));
    (!curves.is_empty()).then(|| Figure::new(*title, axes.0, axes.1, curves))
}

/// The figure of friction with the mean and its interval.
fn with_friction(figure: &Figure, scene: &Scene, summary: &Summary) -> Figure {
    let mut figure = figure.clone();
    if let (Some(friction), FRICTION) = (&summary.friction, figure.y.quantity.as_str()) {
        let (mean, interval) = (friction.coefficient, friction.interval);
        let ends = [friction.since, scene.end.min(summary.time)];
        let band = Curve::line(
            "from work and slip, with 95 % interval",
            ends.map(|t| [t, mean]),
        );
        figure.curves.push(band.with_intervals([interval; 2]));
    }
    if figure.title.starts_with("Residual") {
        figure.guides.push(Guide::horizontal("closed balance", 0.0));
    }
    figure
}
