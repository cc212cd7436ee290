//! Observables of few contacts: where bins, layers and slabs end, and sums that are known exactly.

use crate::generators::Uniform;
use crate::observables::{
    FRICTION, components, contact, fourier_network, near, network, point, points_of,
    random_contacts, sums,
};
use crate::systems::{System, law, moving};
use core::f64::consts::{FRAC_PI_4, PI, TAU};
use gouge_common::estimators::Tensor;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::observables::{
    AngularSums, Anisotropies, Connectivity, Contact, ContactKind, NetworkSettings, PointForce,
    Profile, Slab, Sums, add_body_moments, solid_area,
};
use gouge_contact_dynamics::units::Velocity;

const MORE: f64 = 1.0 + 1e-9;
const LESS: f64 = 1.0 - 1e-9;

/// Some of which slide, and some of which have unequal points.
fn marked_contacts() -> Vec<Contact> {
    let mut contacts = random_contacts(60, 4);
    for (k, contact) in contacts.iter_mut().enumerate() {
        contact.is_sliding = k % 3 == 0;
        contact.has_unequal_points = k % 4 == 0;
    }
    contacts
}

#[test]
fn numbers_of_sums_restore_them() {
    let whole = sums(&marked_contacts(), 3.0);
    assert_eq!(Sums::from_values(&whole.values()), Some(whole));
    assert_eq!(Sums::names().len(), whole.values().len());
    assert!(Sums::from_values(&whole.values()[1..]).is_none());
    let mut connectivity = Connectivity::new();
    connectivity.add(&[0, 1, 2, 3, 3, 5], |body| body != 4);
    let twice = Connectivity::from_values(&connectivity.values());
    assert_eq!(twice, Some(connectivity));
    assert_eq!(Connectivity::names().len(), connectivity.values().len());
}

#[test]
fn sums_of_halves_are_sums_of_the_whole() {
    let contacts = marked_contacts();
    let (first, second) = contacts.split_at(20);
    let mut halves = sums(first, 3.0);
    halves += sums(second, 3.0);
    let whole = sums(&contacts, 3.0);
    let steps = whole.values().len() - 1;
    for (k, (a, b)) in halves.values().into_iter().zip(whole.values()).enumerate() {
        let steps = if k == steps { 1.0 } else { 0.0 };
        near(a, b + steps, 1e-12);
    }
    let counts = [3, 1, 0, 2, 4, 2, 7];
    let of = |counts: &[u32]| {
        let mut connectivity = Connectivity::new();
        connectivity.add(counts, |_| true);
        connectivity
    };
    let mut halves = of(&counts[..3]);
    halves += of(&counts[3..]);
    assert_eq!(halves, of(&counts));
}

/// A bin holds the angles from its own multiple of 10 degrees to the next one.
#[test]
fn bins_of_normals_end_at_multiples_of_ten_degrees() {
    let degree = TAU / 360.0;
    for (angle, bin) in [(40.0 * LESS, 3), (40.0 * MORE, 4)] {
        let one = contact(
            angle * degree,
            ContactKind::SideVertex,
            [2.0, -0.3],
            [0.9, 0.2],
        );
        let mut sums = AngularSums::new();
        sums.add(&[one]);
        let full: Vec<_> = (0..AngularSums::BINS)
            .filter(|&k| sums.bins()[k].contacts != 0.0)
            .collect();
        assert_eq!(full, [bin, bin + 18]);
        for found in [sums.bins()[bin], sums.bins()[bin + 18]] {
            assert_eq!(found.contacts, 1.0);
            assert_eq!(found.means(), [2.0, -0.3, 0.9, 0.2]);
            sums.add(&[one]);
        }
        assert_eq!(
            sums.bins()[bin].means(),
            [2.0, -0.3, 0.9, 0.2].map(|x| 3.0 * x / 3.0)
        );
    }
    let angles: Vec<f64> = (0..AngularSums::BINS).map(AngularSums::angle).collect();
    near(angles.iter().sum::<f64>() / 36.0, PI, 1e-13);
    near(angles[0], 5.0 * degree, 1e-15);
    near(angles[20] - angles[19], 10.0 * degree, 1e-14);
}

/// With a single anisotropy, the relation of azema (8) is exact.
#[test]
fn a_single_anisotropy_explains_the_stress_ratio_exactly() {
    for k in 0..5 {
        let a: [f64; 5] = core::array::from_fn(|j| if j == k { 0.2 } else { 0.0 });
        let put_in = Anisotropies {
            contacts: a[0],
            normal_force: a[1],
            tangential_force: a[2],
            normal_branch: a[3],
            tangential_branch: a[4],
        };
        let sums = sums(&fourier_network(&put_in, 0.3, 720), 1.0);
        near(sums.stress_ratio(), 0.1, 1e-12);
        near(sums.anisotropies().half_sum(), sums.stress_ratio(), 1e-12);
    }
}

#[test]
fn contacts_slide_within_a_millionth_of_the_limit() {
    let usual = NetworkSettings::for_friction(FRICTION);
    let coarse = NetworkSettings {
        sliding_tolerance: 0.1,
        ..usual
    };
    for (settings, limit) in [(usual, 0.4 * (1.0 - 1e-6)), (coarse, 0.36)] {
        for normal in [1.0, 3.0] {
            for sign in [1.0, -1.0] {
                let slides = |t: f64| settings.is_sliding(components(normal, sign * normal * t));
                assert!(slides(limit * (1.0 + 1e-13)) && !slides(limit * (1.0 - 1e-13)));
            }
        }
    }
    // Of the forces 1 and f the mean is (1 + f)/2, of which f is a millionth.
    let force = 1e-6 / (2.0 - 1e-6);
    for (factor, counts) in [(MORE, 2), (LESS, 1)] {
        let of = |bodies, n: f64| point(bodies, 0.3, 1.0, [n, 0.0]);
        let points = [of([0, 1], 1.0), of([1, 2], force * factor)];
        assert_eq!(network(&points, 3).contacts().len(), counts);
    }
}

#[test]
fn points_of_a_body_at_a_wall_add_up() {
    let points = [
        point([5, 3], 0.5 * PI, 1.0, [1.0, 0.3]),
        point([5, 3], 0.5 * PI, 1.0, [2.0, -0.7]),
    ];
    let network = network(&points, 5);
    let force = network.walls()[0].force;
    near(force.n, 3.0, 1e-15);
    near(force.t, -0.4, 1e-15);
    // Another body, or another wall, makes another contact.
    let other = |bodies| point(bodies, 0.5 * PI, 1.0, [1.0, 0.3]);
    let points = [[5, 3], [5, 2], [5, 4], [6, 4]].map(other);
    let walls = crate::observables::network(&points, 5).walls().len();
    assert_eq!(walls, 4);
}

#[test]
fn a_block_on_an_incline_is_held_by_friction() {
    let angle: f64 = 0.2;
    let mut system = System::new(1e-3, law(FRICTION, 0.0, GapRule::Predicted));
    let at = (-0.5 * angle.sin(), 0.5 * angle.cos());
    system.body(4, 0.5f64.sqrt(), at, angle + FRAC_PI_4, Velocity::default());
    system.floor(angle);
    system.gravity(0.0, -10.0);
    system.steps(3);
    let points = points_of(&system);
    let sum = |part: fn(&PointForce) -> f64| points.iter().map(part).sum::<f64>();
    near(sum(|point| point.force.n), 10.0 * angle.cos(), 1e-9);
    near(sum(|point| point.force.t), -10.0 * angle.sin(), 1e-9);
}

/// The moments of both bodies add up to minus the stress, with friction and eccentric points.
#[test]
fn moments_of_bodies_hold_tangential_parts() {
    let mut random = Uniform::new(3);
    let points: Vec<_> = (0..20)
        .map(|k| {
            let mut number = || random.within(-1.0, 1.0);
            PointForce {
                arms: [components(0.5, number()), components(-0.6, number())],
                ..point(
                    [k, k + 1],
                    3.0 * number(),
                    1.0,
                    [1.0 + 0.1 * number(), 0.3 * number()],
                )
            }
        })
        .collect();
    let mut moments = [Tensor::default(); 21];
    add_body_moments(points.iter().copied(), &mut moments);
    let sum = moments
        .into_iter()
        .fold(Tensor::default(), |sum, one| sum + one);
    let stress = sums(network(&points, 21).contacts(), 1.0).stress();
    near(sum.xx, -stress.xx, 1e-12);
    near(sum.xy, -stress.xy, 1e-12);
    near(sum.yx, -stress.yx, 1e-12);
    near(sum.yy, -stress.yy, 1e-12);
}

fn discs(places: impl Iterator<Item = (f64, f64)>) -> System {
    let mut system = System::new(1e-3, law(0.0, 0.0, GapRule::Closed));
    for (y, velocity) in places {
        system.body(0, 0.5, (0.0, y), 0.0, moving(velocity, 0.0, 0.0));
    }
    system
}

#[test]
fn layers_are_tenths_of_the_height() {
    for (factor, layer) in [(LESS, 2), (MORE, 3)] {
        let system = discs([(12.0 * factor, 1.4)].into_iter());
        let mut profile = Profile::new();
        profile.add(&system.assembly, &system.state.configuration, 40.0, 2.0);
        let means: [f64; 10] = core::array::from_fn(|k| if k == layer { 0.7 } else { 0.0 });
        for (found, expected) in profile.means().into_iter().zip(means) {
            near(found, expected, 1e-15);
        }
    }
    let middle = |k: u32| 4.0 * f64::from(k) + 2.0;
    let system = discs((0..10).map(|k| (middle(k), middle(k) / 40.0)));
    let mut profile = Profile::new();
    profile.add(&system.assembly, &system.state.configuration, 40.0, 1.0);
    near(profile.deviation(), 0.0, 1e-15);
    let mut twice = profile;
    twice += profile;
    assert_eq!(twice.means(), profile.means());
    assert_eq!(
        twice.values(),
        profile.values().iter().map(|x| 2.0 * x).collect::<Vec<_>>()
    );
    // The lowest and the highest layer do not count.
    let still = |k: u32| {
        if k.is_multiple_of(9) {
            0.9
        } else {
            middle(k) / 40.0
        }
    };
    let system = discs((0..10).map(|k| (middle(k), still(k))));
    let mut profile = Profile::new();
    profile.add(&system.assembly, &system.state.configuration, 40.0, 1.0);
    near(profile.deviation(), 0.0, 1e-15);
}

#[test]
fn slabs_hold_their_lower_line() {
    let slab = Slab {
        bottom: 0.5,
        top: 1.5,
    };
    for (height, is_inside) in [
        (0.5 * LESS, false),
        (0.5, true),
        (1.5 * LESS, true),
        (1.5, false),
    ] {
        assert_eq!(slab.contains(height), is_inside);
        let one = Contact {
            height,
            ..contact(0.3, ContactKind::SideSide, [1.0, 0.1], [1.0, 0.0])
        };
        let mut sums = Sums::new();
        sums.add_contacts(&[one], Some(slab), 1.0);
        assert_eq!(sums.stress().mean() > 0.0, is_inside);
    }
}

/// A disc that a slab cuts by a ten millionth of its diameter: a flat segment has two thirds of its rectangle.
#[test]
fn slabs_cut_thin_segments() {
    let cut: f64 = 1e-7;
    let system = discs([(3.0, 0.0)].into_iter());
    let (assembly, configuration) = (&system.assembly, &system.state.configuration);
    let area = |bottom, top| solid_area(assembly, configuration, Slab { bottom, top });
    let segment = 4.0 / 3.0 * cut.powf(1.5);
    let whole = PI / 4.0;
    // The next term of the area is smaller by the ratio of the height to the radius.
    near(area(2.5 + cut, 9.0), whole - segment, 1e-14);
    near(area(1.0, 3.5 - cut), whole - segment, 1e-14);
    near(area(3.5 - cut, 9.0), segment, 1e-14);
    near(area(1.0, 2.5 + cut), segment, 1e-14);
    assert_eq!(area(3.5, 9.0), 0.0);
    assert_eq!(area(1.0, 2.5), 0.0);
}
