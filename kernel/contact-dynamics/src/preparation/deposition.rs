//! Geometric deposition of circumscribed discs, one by one.

use super::front::{Disc, Front};
use crate::error::{SetupError, require};
use gouge_common::geometry::Vec2;

/// A deposit of discs on the floor y = 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deposited {
    /// Centres in m, in the order of the diameters.
    pub centres: Vec<Vec2>,
    /// Height in m of the highest point.
    pub height: f64,
}

/// How far below the surface a disc may come to lie, in largest diameters. Deeper holes stay empty, as if discs could
/// not pass the ones above.
const DEPTH: f64 = 6.0;
/// Overlap that is taken for contact, in largest diameters.
const TOLERANCE: f64 = 1e-9;

/// Deposit discs of given diameters in m into a box of a width in m that is periodic in x.
///
/// Each disc goes to the lowest place where it touches two earlier discs, or the floor and one disc, without overlap;
/// of two equally low places to the left one. The first lies at x = 0.
///
/// # Errors
/// [`SetupError::Parameter`] if a diameter is not positive, or the box is narrower than four of the largest.
pub fn deposit(diameters: &[f64], width: f64) -> Result<Deposited, SetupError> {
    for &diameter in diameters {
        require("diameter", diameter, "positive", diameter > 0.0)?;
    }
    let largest = diameters.iter().copied().fold(0.0, f64::max);
    let accepted = "at least four largest diameters";
    require("width", width, accepted, width >= 4.0 * largest)?;
    let mut front = Front::new(width, largest);
    let mut deposited = Deposited::default();
    for &diameter in diameters {
        let radius = 0.5 * diameter;
        let centre = match deposited.centres.is_empty() {
            true => Vec2::new(0.0, radius),
            false => lowest(&front, radius, deposited.height, largest),
        };
        front.add(Disc { centre, radius });
        deposited.centres.push(centre);
        deposited.height = deposited.height.max(centre.y + radius);
    }
    Ok(deposited)
}

/// The lowest free place of a disc on a deposit that is not empty.
fn lowest(front: &Front, radius: f64, top: f64, largest: f64) -> Vec2 {
    let floor = (top - DEPTH * largest).max(0.0);
    let mut places = Vec::new();
    for one in front.above(floor) {
        if radius >= floor {
            places.extend(on_floor(one, radius));
        }
        // Both discs are touched by a third one, so that their centres are at most two largest diameters apart.
        for other in front.near(one.centre, 2) {
            places.extend(on_both(front, one, other, radius));
        }
    }
    places.retain(|place| place.y >= floor);
    places.iter_mut().for_each(|p| p.x = front.wrapped(p.x));
    places.sort_unstable_by(|a, b| a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x)));
    let is_free = |&centre: &Vec2| front.is_free(Disc { centre, radius }, TOLERANCE * largest);
    // Above everything there is always a place; should rounding refuse all, the disc lies on top.
    let highest = Vec2::new(0.0, top + radius);
    places.into_iter().find(is_free).unwrap_or(highest)
}

/// Places to the left and to the right of a disc, on the floor.
fn on_floor(disc: &Disc, radius: f64) -> impl Iterator<Item = Vec2> + use<> {
    let reach = disc.radius + radius;
    let rise = disc.centre.y - radius;
    let x = disc.centre.x;
    let square = reach * reach - rise * rise;
    let across = libm::sqrt(square.max(0.0));
    let places = [x - across, x + across].map(|x| Vec2::new(x, radius));
    places.into_iter().filter(move |_| square >= 0.0)
}

/// The place to the left of the line from one disc to another where a third one touches both.
fn on_both(front: &Front, one: &Disc, other: &Disc, radius: f64) -> Option<Vec2> {
    let d = front.displacement(one.centre, other.centre);
    let distance = d.norm();
    let (a, b) = (one.radius + radius, other.radius + radius);
    if distance == 0.0 || distance > a + b {
        return None;
    }
    let along = 0.5 * (distance + (a - b) * (a + b) / distance);
    let square = a * a - along * along;
    let direction = d * (1.0 / distance);
    let across = libm::sqrt(square.max(0.0));
    let place = one.centre + direction * along + direction.perpendicular() * across;
    (square >= 0.0 && place.y >= radius).then_some(place)
}
