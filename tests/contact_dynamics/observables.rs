//! Contacts, stress, anisotropies and coordination: closed forms, symmetries, and parts that add up.

use crate::generators::Uniform;
use crate::systems::{System, law};
use core::f64::consts::{FRAC_PI_4, PI, TAU};
use gouge_common::estimators::{ContactNetwork, NetworkContact, Tensor};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::observables::{
    AngularSums, Anisotropies, Connectivity, Contact, ContactKind, Network, NetworkSettings,
    PointForce, Slab, Sums, add_body_moments, point_forces,
};
use gouge_contact_dynamics::units::Velocity;

pub const FRICTION: f64 = 0.4;
const KINDS: [ContactKind; 2] = [ContactKind::SideVertex, ContactKind::SideSide];

pub fn components(n: f64, t: f64) -> Components {
    Components { n, t }
}

pub fn near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} instead of {expected}"
    );
}

/// A point between bodies whose centres are a branch apart along the normal.
pub fn point(bodies: [u32; 2], angle: f64, distance: f64, force: [f64; 2]) -> PointForce {
    PointForce {
        first: bodies[0],
        second: bodies[1],
        normal: Vec2::new(angle.cos(), angle.sin()),
        arms: [
            components(0.5 * distance, 0.0),
            components(-0.5 * distance, 0.0),
        ],
        height: 0.0,
        force: components(force[0], force[1]),
    }
}

pub fn network(points: &[PointForce], bodies: usize) -> Network {
    let mut network = Network::new();
    let settings = NetworkSettings::for_friction(FRICTION);
    network.update(points.iter().copied(), bodies, &settings);
    network
}

pub fn sums(contacts: &[Contact], volume: f64) -> Sums {
    let mut sums = Sums::new();
    sums.add_contacts(contacts, None, volume);
    sums
}

pub fn contact(angle: f64, kind: ContactKind, force: [f64; 2], branch: [f64; 2]) -> Contact {
    let force = components(force[0], force[1]);
    Contact {
        first: 0,
        second: 1,
        normal: Vec2::new(angle.cos(), angle.sin()),
        force,
        branch: components(branch[0], branch[1]),
        height: 0.0,
        kind,
        is_sliding: NetworkSettings::for_friction(FRICTION).is_sliding(force),
        has_unequal_points: false,
    }
}

/// Contacts with arbitrary forces and branches.
pub fn random_contacts(count: usize, seed: u64) -> Vec<Contact> {
    let mut random = Uniform::new(seed);
    let one = |_| {
        let kind = KINDS[usize::from(random.next() < 0.3)];
        let angle = random.within(0.0, TAU);
        let n = random.within(0.5, 1.5) + (2.0 * angle).cos();
        let t = FRICTION * n * random.within(-1.0, 1.0);
        let branch = [random.within(0.6, 1.4), random.within(-0.3, 0.3)];
        contact(angle, kind, [n, t], branch)
    };
    (0..count).map(one).collect()
}

const SIDE: u32 = 12;

/// Discs of diameter 0.5 on a periodic square lattice, with one force per direction.
fn lattice(along_x: [f64; 2], along_y: [f64; 2]) -> Vec<PointForce> {
    let index = |column: u32, row: u32| (row % SIDE) * SIDE + column % SIDE;
    let sites = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (column, row)));
    let contacts = sites.flat_map(|(column, row)| {
        let own = index(column, row);
        let right = point([own, index(column + 1, row)], 0.0, 0.5, along_x);
        let above = point([own, index(column, row + 1)], 0.5 * PI, 0.5, along_y);
        [right, above]
    });
    contacts.collect()
}

#[test]
fn a_square_lattice_has_the_stress_of_its_forces() {
    // Every cell of side d has one contact in each direction, so that the stress is the force over d.
    let network = network(&lattice([3.0, 0.3], [1.0, -0.3]), (SIDE * SIDE) as usize);
    let sums = sums(network.contacts(), f64::from(SIDE * SIDE) * 0.25);
    let stress = sums.stress();
    near(stress.xx, 6.0, 1e-12);
    near(stress.yy, 2.0, 1e-12);
    // The tangent is +y on contacts along x, and -x on those along y.
    near(stress.yx, 0.6, 1e-12);
    near(stress.xy, 0.6, 1e-12);
    near(stress.mean(), 4.0, 1e-12);
    near(stress.deviator(), 4.36f64.sqrt(), 1e-12);
    near(stress.principal_angle(), 0.5 * (0.6f64 / 2.0).atan(), 1e-12);
    near(stress.antisymmetric(), 0.0, 1e-12);
    near(sums.stress_ratio(), 4.36f64.sqrt() / 4.0, 1e-12);
    near(sums.relative_normal_force(0.5), 1.0, 1e-12);
    near(sums.relative_friction(0.5), 0.15, 1e-12);
    near(sums.share(ContactKind::SideVertex), 1.0, 0.0);
    let mut connectivity = Connectivity::new();
    connectivity.add(network.counts(), |_| true);
    near(connectivity.coordination(), 4.0, 1e-12);
    near(connectivity.connected_share(), 1.0, 0.0);
    near(connectivity.share_with(4), 1.0, 0.0);
}

#[test]
fn an_unbalanced_torque_is_the_antisymmetric_part() {
    // Both friction forces of a cell turn its disc the same way.
    let network = network(&lattice([3.0, 0.3], [1.0, 0.3]), (SIDE * SIDE) as usize);
    let stress = sums(network.contacts(), f64::from(SIDE * SIDE) * 0.25).stress();
    near(stress.antisymmetric(), -0.6, 1e-12);
}

/// Contacts whose angular functions are those of azema (7), with equal weights.
pub fn fourier_network(put_in: &Anisotropies, direction: f64, count: usize) -> Vec<Contact> {
    let a = put_in;
    let cumulated = |delta: f64| (delta + 0.5 * a.contacts * (2.0 * delta).sin()) / TAU;
    let one = |k: usize| {
        let wanted = (k as f64 + 0.5) / count as f64;
        let (mut low, mut high) = (0.0, TAU);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if cumulated(middle) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        let (cos, sin) = ((2.0 * low).cos(), (2.0 * low).sin());
        let part = |mean: f64, even: f64, odd: f64| [mean * (1.0 + even * cos), -mean * odd * sin];
        let forces = part(2.0, a.normal_force, a.tangential_force);
        let branches = part(0.7, a.normal_branch, a.tangential_branch);
        let kind = KINDS[usize::from(k.is_multiple_of(4))];
        contact(low + direction, kind, forces, branches)
    };
    (0..count).map(one).collect()
}

const PUT_IN: Anisotropies = Anisotropies {
    contacts: 0.3,
    normal_force: 0.25,
    tangential_force: 0.08,
    normal_branch: 0.02,
    tangential_branch: 0.01,
};

fn listed(a: Anisotropies) -> [f64; 5] {
    [
        a.contacts,
        a.normal_force,
        a.tangential_force,
        a.normal_branch,
        a.tangential_branch,
    ]
}

#[test]
fn coefficients_of_the_angular_functions_come_back() {
    // Midpoints of equal probabilities integrate smooth periodic functions: the error falls with the square of the
    // number of contacts, or faster.
    let error = |count: usize| {
        let sums = sums(&fourier_network(&PUT_IN, 0.6, count), 100.0);
        near(sums.stress().principal_angle(), 0.6, 1.0 / count as f64);
        let found = listed(sums.anisotropies().fourier());
        let pairs = found.into_iter().zip(listed(PUT_IN));
        pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    let errors = [50, 200, 800, 3200].map(error);
    assert!(errors[0] < 5e-3, "{errors:?}");
    for pair in errors.windows(2) {
        assert!(pair[1] < 0.1 * pair[0] || pair[1] < 1e-13, "{errors:?}");
    }
}

#[test]
fn moments_are_not_the_coefficients() {
    // X = (2 a_c + 2 a_fn)/(2 + a_c a_fn) for these functions, by integration.
    let a = PUT_IN;
    let moments = sums(&fourier_network(&a, 0.6, 4000), 100.0).anisotropies();
    let normal = |x: f64| (2.0 * a.contacts + 2.0 * x) / (2.0 + a.contacts * x) - a.contacts;
    near(moments.contacts, a.contacts, 1e-6);
    near(moments.normal_force, normal(a.normal_force), 1e-6);
    near(moments.normal_branch, normal(a.normal_branch), 1e-6);
    let tangential = a.tangential_force / (1.0 + 0.5 * a.contacts * a.normal_force);
    near(moments.tangential_force, tangential, 1e-6);
}

#[test]
fn the_half_sum_explains_the_stress_ratio_to_first_order() {
    // Halving all anisotropies divides what (8) neglects by four.
    let gap = |factor: f64| {
        let a = listed(PUT_IN).map(|x| factor * x);
        let put_in = Anisotropies {
            contacts: a[0],
            normal_force: a[1],
            tangential_force: a[2],
            normal_branch: a[3],
            tangential_branch: a[4],
        };
        let sums = sums(&fourier_network(&put_in, 0.2, 4000), 1.0);
        (sums.anisotropies().fourier().half_sum() - sums.stress_ratio()).abs()
    };
    let gaps = [1.0, 0.5, 0.25].map(gap);
    assert!(gaps[0] < 0.02 && gaps[0] > 1e-3, "{gaps:?}");
    for pair in gaps.windows(2) {
        assert!(pair[1] < 0.3 * pair[0], "{gaps:?}");
    }
}

fn turned(contacts: &[Contact], angle: f64) -> Vec<Contact> {
    let (cos, sin) = (angle.cos(), angle.sin());
    let turn = |contact: &Contact| {
        let n = contact.normal;
        Contact {
            normal: Vec2::new(cos * n.x - sin * n.y, sin * n.x + cos * n.y),
            ..*contact
        }
    };
    contacts.iter().map(turn).collect()
}

#[test]
fn turning_the_network_turns_only_the_principal_direction() {
    let contacts = random_contacts(300, 5);
    let before = sums(&contacts, 7.0);
    let after = sums(&turned(&contacts, 0.4), 7.0);
    let turn = after.stress().principal_angle() - before.stress().principal_angle();
    near(
        (turn - 0.4 + 0.5 * PI).rem_euclid(PI) - 0.5 * PI,
        0.0,
        1e-12,
    );
    near(after.stress().mean(), before.stress().mean(), 1e-12);
    near(after.stress_ratio(), before.stress_ratio(), 1e-12);
    let antisymmetric = before.stress().antisymmetric();
    near(after.stress().antisymmetric(), antisymmetric, 1e-12);
    for (x, y) in listed(after.anisotropies())
        .into_iter()
        .zip(listed(before.anisotropies()))
    {
        near(x, y, 1e-12);
    }
}

#[test]
fn exchanging_the_bodies_of_contacts_changes_nothing() {
    let contacts = random_contacts(100, 8);
    let exchange = |contact: &Contact| Contact {
        normal: -contact.normal,
        ..*contact
    };
    let exchanged: Vec<_> = contacts.iter().map(exchange).collect();
    assert_eq!(sums(&contacts, 2.0), sums(&exchanged, 2.0));
    let bins = [contacts, exchanged].map(|contacts| {
        let mut sums = AngularSums::new();
        sums.add(&contacts);
        sums
    });
    for (one, other) in bins[0].bins().iter().zip(bins[1].bins()) {
        near(one.normal_force, other.normal_force, 1e-12);
        near(one.tangential_branch, other.tangential_branch, 1e-12);
    }
}

#[test]
fn parts_add_up_to_the_whole() {
    let sums = sums(&random_contacts(400, 3), 11.0);
    let add =
        |part: fn(&Sums, ContactKind) -> f64| KINDS.map(|kind| part(&sums, kind)).iter().sum();
    near(add(Sums::stress_ratio_of), sums.stress_ratio(), 1e-12);
    near(add(Sums::share), 1.0, 1e-12);
    let parts = KINDS.map(|kind| listed(sums.anisotropies_of(kind)));
    for (k, whole) in listed(sums.anisotropies()).into_iter().enumerate() {
        near(parts[0][k] + parts[1][k], whole, 1e-12);
        assert!(parts.iter().all(|part| part[k].abs() > 1e-4));
    }
}

#[test]
fn ratios_are_taken_of_means() {
    // Two steps whose principal directions are perpendicular: the mean stress is isotropic.
    let one = network(&lattice([3.0, 0.0], [1.0, 0.0]), (SIDE * SIDE) as usize);
    let other = network(&lattice([1.0, 0.0], [3.0, 0.0]), (SIDE * SIDE) as usize);
    let mut both = sums(one.contacts(), 36.0);
    near(both.stress_ratio(), 0.5, 1e-12);
    both += sums(other.contacts(), 36.0);
    near(both.stress_ratio(), 0.0, 1e-12);
    near(both.stress().mean(), 4.0, 1e-12);
    near(both.relative_normal_force(0.5), 1.0, 1e-12);
}

#[test]
fn only_points_that_bear_force_count() {
    let side = [1.0, 0.0];
    let points = [
        point([0, 1], 0.1, 1.0, [1.0, 0.4]),
        point([0, 1], 0.1, 1.0, [3.0, 0.2]),
        point([0, 2], 1.0, 1.0, [2.0, 0.0]),
        point([0, 2], 1.0, 1.0, [2e-7, 0.0]),
        point([1, 2], 2.0, 1.0, [0.0, 0.0]),
        point([2, 3], 2.0, 1.0, [2.0, -0.8]),
        point([5, 3], 0.5 * PI, 1.0, side),
        point([5, 3], 0.5 * PI, 1.0, side),
    ];
    let network = network(&points, 5);
    let kinds: Vec<_> = network.contacts().iter().map(|c| c.kind).collect();
    assert_eq!(kinds, [KINDS[1], KINDS[0], KINDS[0]]);
    let double = network.contacts()[0];
    assert_eq!(double.force, components(4.0, 0.6000000000000001));
    assert!(!double.is_sliding && double.has_unequal_points);
    assert!(network.contacts()[2].is_sliding);
    assert_eq!(network.counts(), [2, 1, 2, 2, 0]);
    let wall = network.walls();
    assert_eq!((wall.len(), wall[0].wall, wall[0].body), (1, 5, 3));
    assert_eq!(wall[0].force, components(2.0, 0.0));
    let sums = sums(network.contacts(), 1.0);
    near(sums.share(ContactKind::SideSide), 1.0 / 3.0, 1e-15);
    near(sums.sliding_share(), 1.0 / 3.0, 1e-15);
    near(sums.unequal_share(), 1.0, 0.0);
    let mut connectivity = Connectivity::new();
    connectivity.add(network.counts(), |body| body != 2);
    near(connectivity.connected_share(), 0.5, 0.0);
    near(connectivity.coordination(), 2.0, 0.0);
    near(connectivity.share_with(2), 1.0, 0.0);
}

/// Two squares on top of each other on a floor, after a step under gravity.
fn column() -> System {
    let mut system = System::new(1e-3, law(FRICTION, 0.0, GapRule::Predicted));
    for k in 0..2 {
        let at = (0.0, 0.5 + f64::from(k));
        system.body(4, 0.5f64.sqrt(), at, FRAC_PI_4, Velocity::default());
    }
    system.floor(0.0);
    system.gravity(0.0, -10.0);
    system.steps(3);
    system
}

pub fn points_of(system: &System) -> Vec<PointForce> {
    let configuration = &system.state.configuration;
    point_forces(&system.assembly, configuration, system.workspace(), 1e-3).collect()
}

#[test]
fn a_column_shows_its_weight() {
    let system = column();
    let points = points_of(&system);
    let network = network(&points, 2);
    let (contact, wall) = (network.contacts()[0], network.walls()[0]);
    assert_eq!(contact.kind, ContactKind::SideSide);
    near(contact.force.n, 10.0, 1e-9);
    near(contact.branch.n, 1.0, 1e-9);
    near(contact.height, 1.0, 1e-9);
    near(wall.force.n, 20.0, 1e-9);
    near(wall.normal.y, 1.0, 1e-12);
    assert_eq!(network.counts(), [2, 1]);
    let slab = |bottom, top| Some(Slab { bottom, top });
    for (slab, pressure) in [(slab(0.5, 1.5), 10.0), (slab(1.1, 2.0), 0.0)] {
        let mut sums = Sums::new();
        sums.add(&network, slab, 1.0);
        near(sums.stress().yy, pressure, 1e-9);
    }
}

#[test]
fn points_on_an_incline_have_their_heights() {
    let angle: f64 = 0.2;
    let mut system = System::new(1e-3, law(FRICTION, 0.0, GapRule::Predicted));
    let at = (-0.5 * angle.sin(), 0.5 * angle.cos());
    system.body(4, 0.5f64.sqrt(), at, angle + FRAC_PI_4, Velocity::default());
    system.floor(angle);
    system.gravity(0.0, -10.0);
    system.steps(1);
    // The side of length 1 has its middle at the origin; the tangent points down.
    let points = points_of(&system);
    assert_eq!(points.len(), 2);
    for point in points {
        near(point.arms[1].t.abs(), 0.5, 1e-12);
        near(point.height, -point.arms[1].t * angle.sin(), 1e-12);
    }
}

#[test]
fn moments_of_bodies_are_those_of_contacts() {
    let points = points_of(&column());
    let mut moments = [Tensor::default(); 2];
    add_body_moments(points.iter().copied(), &mut moments);
    // Lower square: 20 N from below and 10 N from above, each 0.5 m from the centre.
    near(moments[0].yy, -15.0, 1e-9);
    near(moments[1].yy, -5.0, 1e-9);
    near(moments[0].antisymmetric(), 0.0, 1e-9);
    let inner: Vec<_> = points.into_iter().filter(|p| p.first < 2).collect();
    let mut moments = [Tensor::default(); 2];
    add_body_moments(inner.iter().copied(), &mut moments);
    let stress = sums(network(&inner, 2).contacts(), 1.0).stress();
    let sum = (moments[0] + moments[1]) * -1.0;
    near(sum.yy, stress.yy, 1e-12);
    near(sum.xy, stress.xy, 1e-12);
    near(sum.yx, stress.yx, 1e-12);
}

#[test]
fn the_stress_of_the_common_estimator_has_the_opposite_sign() {
    let contacts = random_contacts(50, 2);
    let other = ContactNetwork {
        particles: 2,
        contacts: contacts
            .iter()
            .map(|contact| NetworkContact {
                pair: Pair::new(0, 1),
                branch: contact.vector(contact.branch),
                force: -contact.vector(contact.force),
            })
            .collect(),
    };
    let (ours, theirs) = (sums(&contacts, 3.0).stress(), other.mean_stress(3.0));
    near(ours.xx, -theirs[0][0], 1e-12);
    near(ours.xy, -theirs[0][1], 1e-12);
    near(ours.yx, -theirs[1][0], 1e-12);
    near(ours.yy, -theirs[1][1], 1e-12);
}

#[test]
fn bins_hold_the_angular_functions() {
    let contacts = fourier_network(&PUT_IN, 0.6, 7200);
    let mut sums = AngularSums::new();
    sums.add(&contacts);
    let width = TAU / AngularSums::BINS as f64;
    near(sums.density().iter().sum::<f64>() * width, 1.0, 1e-12);
    for (bin, density) in sums.density().into_iter().enumerate() {
        // The mean over a bin of half-width h is the value at its centre times sin(2h)/(2h), to this accuracy.
        let delta = 2.0 * (AngularSums::angle(bin) - 0.6);
        let shrink = width.sin() / width;
        let expected = (1.0 + PUT_IN.contacts * shrink * delta.cos()) / TAU;
        near(density, expected, 2e-3);
        let [force, friction, branch, _] = sums.bins()[bin].means();
        near(force, 2.0 * (1.0 + PUT_IN.normal_force * delta.cos()), 2e-2);
        near(friction, -2.0 * PUT_IN.tangential_force * delta.sin(), 1e-2);
        near(
            branch,
            0.7 * (1.0 + PUT_IN.normal_branch * delta.cos()),
            1e-2,
        );
    }
}

#[test]
fn measuring_again_allocates_nothing() {
    let system = column();
    let settings = NetworkSettings::for_friction(FRICTION);
    let mut network = Network::new();
    let mut measure = || {
        let configuration = &system.state.configuration;
        let points = point_forces(&system.assembly, configuration, system.workspace(), 1e-3);
        network.update(points, 2, &settings);
        let mut sums = Sums::new();
        sums.add(&network, None, 1.0);
        sums.stress()
    };
    let first = measure();
    let mut second = Tensor::default();
    let counted = allocation_counter::measure(|| second = measure());
    assert_eq!((counted.count_total, first), (0, second));
}
