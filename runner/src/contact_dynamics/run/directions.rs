//! How contacts, forces and branch vectors depend on the direction of the normal: a table and polar diagrams, as in figure 11
//! of azema.

use super::super::Means;
use crate::run::picture::rounded;
use crate::run::table::{Table, Values};
use gouge_contact_dynamics::observables::{AngularSums, Anisotropies, Bin};
use std::f64::consts::TAU;
use svg::Document;
use svg::node::element::{Circle, Group, Polygon, Text};

/// Size in pixels of a diagram.
const SIDE: f64 = 190.0;
/// Height in pixels of its title.
const TITLE: f64 = 26.0;
/// Radius in pixels of the largest value.
const RADIUS: f64 = 80.0;
/// Directions at which an expansion is drawn.
const DIRECTIONS: usize = 180;
/// Colours of what was measured and of the expansion.
const COLOURS: [&str; 2] = ["#0072b2", "#d55e00"];

/// A function of the direction: its name, its values per bin, and its expansion to first order.
struct Function {
    name: &'static str,
    values: Vec<f64>,
    expansion: Expansion,
}

/// $ 1 + a \cos 2(\theta - \theta_s) $, or $ -a \sin 2(\theta - \theta_s) $ if it is odd.
struct Expansion {
    amplitude: f64,
    is_odd: bool,
    principal: f64,
}

impl Expansion {
    fn at(&self, angle: f64) -> f64 {
        let (sin, cos) = (2.0 * (angle - self.principal)).sin_cos();
        match self.is_odd {
            true => -self.amplitude * sin,
            false => 1.0 + self.amplitude * cos,
        }
    }
}

/// The five functions of azema (7), relative to the means over all directions of the density, of the normal force and of the
/// normal branch.
fn functions(means: &Means) -> [Function; 5] {
    let fitted = means.slab.anisotropies().fourier();
    let [force, branch] = units(means, &fitted);
    let bins = means.directions.bins();
    let column = |k: usize, unit: f64| bins.iter().map(|bin| bin.means()[k] / unit).collect();
    let density = means.directions.density().map(|density| TAU * density);
    let amplitudes = [
        fitted.contacts,
        fitted.normal_force,
        fitted.tangential_force,
        fitted.normal_branch,
        fitted.tangential_branch,
    ];
    let mut values = [
        density.to_vec(),
        column(0, force),
        column(1, force),
        column(2, branch),
        column(3, branch),
    ];
    let principal = means.slab.stress().principal_angle();
    std::array::from_fn(|k| Function {
        name: Bin::NAMES[k],
        values: std::mem::take(&mut values[k]),
        expansion: Expansion {
            amplitude: amplitudes[k],
            is_odd: Bin::NAMES[k].starts_with("tangential"),
            principal,
        },
    })
}

/// Means over all directions of the normal force in N and of the normal branch in m. Means over contacts are others, because
/// there are more contacts in some directions.
fn units(means: &Means, fitted: &Anisotropies) -> [f64; 2] {
    let total = means.slab.total();
    let mean = |sum: f64, amplitude: f64| {
        sum / total.contacts.sum / (1.0 + 0.5 * fitted.contacts * amplitude)
    };
    [
        mean(total.normal_force.sum, fitted.normal_force),
        mean(total.normal_branch.sum, fitted.normal_branch),
    ]
}

/// All functions with their expansions, one row per direction in degrees.
pub fn table(means: &Means) -> Table {
    let angles = (0..AngularSums::BINS).map(AngularSums::angle);
    let angles: Vec<f64> = angles.collect();
    let degrees = angles.iter().map(|angle| angle.to_degrees()).collect();
    let mut columns = vec![("direction", Values::Numbers(degrees))];
    for (function, expanded) in functions(means).into_iter().zip(EXPANDED) {
        let expansion = angles.iter().map(|&angle| function.expansion.at(angle));
        columns.push((expanded, Values::Numbers(expansion.collect())));
        columns.push((function.name, Values::Numbers(function.values)));
    }
    Table { columns }
}

/// Columns of the expansions.
const EXPANDED: [&str; 5] = [
    "contacts_expanded",
    "normal_force_expanded",
    "tangential_force_expanded",
    "normal_branch_expanded",
    "tangential_branch_expanded",
];

/// Polar diagrams of all functions beside each other; negative values count with their magnitude.
pub fn draw(means: &Means) -> Document {
    let functions = functions(means);
    let width = SIDE * functions.len() as f64;
    let mut document = Document::new().set("viewBox", format!("0 0 {width} {}", SIDE + TITLE));
    for (place, function) in functions.iter().enumerate() {
        let shift = format!("translate({},0)", rounded(place as f64 * SIDE));
        document = document.add(diagram(function).set("transform", shift));
    }
    document
}

fn diagram(function: &Function) -> Group {
    let most = function
        .values
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    let unit = RADIUS / most.max(f64::MIN_POSITIVE);
    let bins = function.values.iter().enumerate();
    let measured: Vec<[f64; 2]> = bins
        .flat_map(|(bin, value)| {
            let half = 0.5 * TAU / AngularSums::BINS as f64;
            let middle = AngularSums::angle(bin);
            [middle - half, middle + half].map(|angle| polar(angle, unit * value.abs()))
        })
        .collect();
    let expanded: Vec<[f64; 2]> = (0..DIRECTIONS)
        .map(|k| {
            let angle = k as f64 * TAU / DIRECTIONS as f64;
            polar(angle, unit * function.expansion.at(angle).abs())
        })
        .collect();
    let text = |content: String, y: f64| {
        Text::new(content)
            .set("x", 0.5 * SIDE)
            .set("y", rounded(y))
            .set("text-anchor", "middle")
            .set("font-family", "sans-serif")
            .set("font-size", 14)
            .set("fill", "#222")
    };
    let rim = Circle::new()
        .set("cx", 0.5 * SIDE)
        .set("cy", TITLE + 0.5 * SIDE)
        .set("r", RADIUS)
        .set("fill", "none")
        .set("stroke", "#bbb");
    Group::new()
        .add(rim)
        .add(line(&measured, COLOURS[0]).set("fill", "#0072b233"))
        .add(line(&expanded, COLOURS[1]).set("stroke-width", 2))
        .add(text(function.name.replace('_', " "), 16.0))
        .add(text(format!("rim: {most:.2}"), TITLE + SIDE - 2.0))
}

/// A place in a diagram.
fn polar(angle: f64, radius: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [0.5 * SIDE + radius * cos, TITLE + 0.5 * SIDE - radius * sin]
}

fn line(points: &[[f64; 2]], colour: &str) -> Polygon {
    let place = |[x, y]: &[f64; 2]| format!("{},{}", rounded(*x), rounded(*y));
    let points: Vec<String> = points.iter().map(place).collect();
    Polygon::new()
        .set("points", points.join(" "))
        .set("fill", "none")
        .set("stroke", colour)
}
