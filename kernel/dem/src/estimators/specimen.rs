//! The free particles of a state as a specimen that the others hold and load.

use crate::forces::{Forces, Interaction, InteractionKind};
use crate::particles::{Particles, Role};
use crate::world::{NormalChoice, World};
use gouge_common::estimators::{ContactNetwork, NetworkContact, packing_fraction};
use gouge_equations::rendered;

/// Width and height in m of the specimen: of the smallest upright rectangle around the discs of all free particles. In
/// a periodic box it is as wide as the period, unless a strip without discs is left that is wider than the largest of
/// them; then it ends there. Not finite without free particles.
pub fn specimen_size<N: NormalChoice<f64>>(world: &World<f64, N>) -> [f64; 2] {
    let p = world.particles();
    let spans = |at: fn(&Particles, usize) -> f64| {
        let free = p.with_role(Role::Free);
        free.map(move |i| [at(p, i) - p.radius[i], at(p, i) + p.radius[i]])
    };
    let across = spans(|p, i| p.position[i].x);
    let width = match world.model().domain.period() {
        None => extent(across),
        Some(period) => extent_on_circle(across.collect(), period),
    };
    [width, extent(spans(|p, i| p.position[i].y))]
}

/// Length of the smallest interval around some intervals.
fn extent(intervals: impl Iterator<Item = [f64; 2]>) -> f64 {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = intervals.fold(none, |all, one| [all[0].min(one[0]), all[1].max(one[1])]);
    high - low
}

/// Length of the smallest arc around some intervals on a circle: the circumference, unless a gap is left that is longer
/// than every interval.
fn extent_on_circle(intervals: Vec<[f64; 2]>, circumference: f64) -> f64 {
    let lengths = intervals.iter().map(|[low, high]| high - low);
    let longest = lengths.fold(0.0, f64::max);
    // On three turns, every gap lies between two intervals.
    let turns = [-circumference, 0.0, circumference];
    let shifted = |turn| {
        intervals
            .iter()
            .map(move |[low, high]| [low + turn, high + turn])
    };
    let mut laid: Vec<[f64; 2]> = turns.into_iter().flat_map(shifted).collect();
    laid.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut widest, mut reached) = (0.0_f64, f64::INFINITY);
    for [low, high] in laid {
        widest = widest.max(low - reached);
        reached = if reached.is_finite() {
            reached.max(high)
        } else {
            high
        };
    }
    if widest > longest {
        circumference - widest
    } else {
        circumference
    }
}

/// Mean stress in the specimen in Pa, positive in tension: `[[xx, xy], [yx, yy]]`.
///
/// $$ \sigma_{ab} = \frac{1}{V} \sum_{ij} F_{ij,a}\, b_{ij,b} $$
///
/// $F_{ij}$ in N is the force of j on i, over all contacts and bonds with a free particle. $b_{ij}$ in m points from the
/// centre of i to that of j; where one of them is not free, it begins or ends at the contact point instead, which is
/// where the force enters the specimen. So the sum is that of the forces on the boundary times their places if the
/// specimen is at rest and nothing else acts on it. V in m^3 is the area of the rectangle of [`specimen_size`] times
/// `thickness`. NaN without free particles.
#[rendered]
pub fn specimen_stress<N: NormalChoice<f64>>(
    world: &World<f64, N>,
    interactions: &[Interaction],
    thickness: f64,
) -> [[f64; 2]; 2] {
    let roles = &world.particles().role;
    let contact = |one: &Interaction| {
        let (i, j) = one.pair.indices();
        let part = match [i, j].map(|end| roles[end] == Role::Free) {
            [true, true] => 1.0,
            [true, false] => one.overlap_factor,
            [false, true] => 1.0 - one.overlap_factor,
            [false, false] => return None,
        };
        let whole = NetworkContact::from(one);
        Some(NetworkContact {
            branch: whole.branch * part,
            ..whole
        })
    };
    let network = ContactNetwork {
        particles: roles.len(),
        contacts: interactions.iter().filter_map(contact).collect(),
    };
    let [width, height] = specimen_size(world);
    match height.is_finite() {
        true => network.mean_stress(width * height * thickness),
        false => [[f64::NAN; 2]; 2],
    }
}

/// Packing fraction of the specimen, dimensionless: [`packing_fraction`] of the free particles in the rectangle of
/// [`specimen_size`].
pub fn specimen_packing<N: NormalChoice<f64>>(world: &World<f64, N>) -> f64 {
    let p = world.particles();
    let radii: Vec<f64> = p.with_role(Role::Free).map(|i| p.radius[i]).collect();
    let [width, height] = specimen_size(world);
    packing_fraction(&radii, width * height)
}

/// Unbalanced force, dimensionless: how far the free particles are from equilibrium.
///
/// $$ u = \frac{\left\langle |F_i| \right\rangle_{\text{free } i}}{\left\langle |F_{ij}| \right\rangle_{ij}} $$
///
/// The mean magnitude of the resultant force on free particles over the mean magnitude of the forces of all contacts and
/// bonds, both in N. Zero in equilibrium. NaN without contacts and bonds and without free particles.
#[rendered]
pub fn unbalanced_force(
    particles: &Particles,
    resultant: &Forces<f64>,
    interactions: &[Interaction],
) -> f64 {
    let free = particles.with_role(Role::Free);
    let resultants = mean(free.map(|i| resultant.force[i].norm()));
    resultants / mean(interactions.iter().map(|one| one.force().norm()))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, number) = values.fold((0.0, 0.0), |(sum, number), value| {
        (sum + value, number + 1.0)
    });
    sum / number
}

/// The largest overlap of a contact over the smaller radius of its two particles, dimensionless; zero without contacts.
pub fn largest_overlap<N: NormalChoice<f64>>(
    world: &World<f64, N>,
    interactions: &[Interaction],
) -> f64 {
    let radius = &world.particles().radius;
    let relative = |one: &Interaction| {
        let (i, j) = one.pair.indices();
        one.normal_displacement / radius[i].min(radius[j])
    };
    let contacts = interactions.iter();
    let contacts = contacts.filter(|one| one.kind == InteractionKind::Contact);
    contacts.map(relative).fold(0.0, f64::max)
}
