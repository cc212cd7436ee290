//! The programs of `examples/`, and normal laws that are not the kernel's.

#[path = "../examples/own_estimator.rs"]
#[allow(dead_code)]
mod own_estimator;
#[path = "../examples/own_law.rs"]
#[allow(dead_code)]
mod own_law;

use crate::worlds::{bits, sheared_with};
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    Bshp, KelvinVoigt, NormalLaw, ReboundingBshp, ReboundingKelvinVoigt, typical_overlap,
};
use gouge_dem::model::{ContactLaws, ContactNormal, Model};
use gouge_dem::particles::{Particle, Particles};
use gouge_dem::{NormalChoice, Start, World};
use gouge_scalars::Dual;
use own_estimator::anisotropy;
use own_law::{Tsuji, fallen};

/// A law of the kernel as if it were that of a program.
#[derive(Clone, Copy, Debug)]
struct Own<L>(L);

impl<L: NormalLaw> NormalLaw for Own<L> {
    #[inline(always)]
    fn force<S: Real>(self, radii: [S; 2], xi: S, d_xi: S) -> S {
        self.0.force(radii, xi, d_xi)
    }
    #[inline(always)]
    fn elastic_force<S: Real>(self, radii: [S; 2], xi: S) -> S {
        self.0.elastic_force(radii, xi)
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, radii: [S; 2], xi: S) -> S {
        self.0.stored_energy(radii, xi)
    }
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        self.0.linearised(radii, reduced_mass)
    }
}

/// Grains of 1 mm at places in m with horizontal velocities in m/s.
fn world_of<N: NormalChoice<f64>>(normal: N, step: f64, grains: &[[f64; 3]]) -> World<f64, N> {
    let model = Model {
        contact: Some(ContactLaws {
            distance: ContactDistance::Mean,
            normal,
            tangential: None,
        }),
        ..Model::new(Integrator::VelocityVerlet, step)
    };
    let grain = |&[x, y, speed]: &[f64; 3]| Particle {
        velocity: Vec2::new(speed, 0.0),
        ..Particle::sphere(Vec2::new(x, y), 1e-3, 2700.0)
    };
    let grains: Particles = grains.iter().map(grain).collect();
    World::new(model, grains, &Start::default()).expect("a world")
}

#[test]
fn an_own_law_has_the_bits_of_the_same_law_of_the_kernel() {
    let mut world = sheared_with(|draft| draft);
    let model = *world.model();
    let contact = model.contact.expect("contacts");
    let ContactNormal::KelvinVoigt(law) = contact.normal else {
        panic!("the fault has linear contacts");
    };
    let own = Model {
        reading: model.reading,
        domain: model.domain,
        contact: Some(ContactLaws {
            distance: contact.distance,
            normal: Own(law),
            tangential: contact.tangential,
        }),
        bond: model.bond,
        ambient: model.ambient,
        external: model.external,
        driving: model.driving,
        ledger: model.ledger,
        ..Model::new(model.integrator, model.time_step)
    };
    let mut copy = World::from_words(own, &world.to_words()).expect("the same columns");
    for _ in 0..2000 {
        world.step().expect("the state stays finite");
        copy.step().expect("the state stays finite");
    }
    assert!(world.number_of_contacts() > 0);
    assert_eq!(bits(&world), bits_of(&copy));
    assert_eq!(world.energy(), copy.energy());
    assert_eq!(world.interactions(), copy.interactions());
}

/// The bits of positions, velocities, angles and spins, in the order of `bits`.
fn bits_of<N: NormalChoice<f64>>(world: &World<f64, N>) -> Vec<u64> {
    let p = world.particles();
    let vectors = p.position.iter().chain(&p.velocity);
    let numbers = p.angle.iter().chain(&p.angular_velocity).copied();
    let numbers = vectors.flat_map(|v| [v.x, v.y]).chain(numbers);
    numbers.map(f64::to_bits).collect()
}

/// Check that a linearised law has the slopes of its force over overlap and over rate.
fn has_the_slopes_of_its_force(law: impl NormalLaw) {
    let (radii, mass) = ([1e-3, 3e-3], 2e-5);
    let duals = radii.map(Dual::from_f64);
    let (xi, factor) = (typical_overlap(radii), law.damping_factor(radii, mass));
    let along_overlap = law.elastic_force(duals, Dual::variable(xi));
    let along_rate = law.force(duals, Dual::from_f64(xi), Dual::variable(0.0));
    let [stiffness, damping] = law.linearised(radii, mass);
    assert!((stiffness / -along_overlap.slope() - 1.0).abs() < 1e-12);
    assert!((damping / (-along_rate.slope() * factor) - 1.0).abs() < 1e-12);
}

#[test]
fn linearised_laws_have_the_slopes_of_their_forces() {
    let linear = KelvinVoigt {
        stiffness: 1e6,
        damping: 20.0,
    };
    let spheres = Bshp {
        youngs_modulus: 50e9,
        poissons_ratio: 0.22,
        dissipative_constant: 1e-8,
    };
    has_the_slopes_of_its_force(linear);
    has_the_slopes_of_its_force(spheres);
    has_the_slopes_of_its_force(ReboundingKelvinVoigt {
        of_unit_mass: linear,
    });
    has_the_slopes_of_its_force(ReboundingBshp {
        of_unit_pair: spheres,
    });
    has_the_slopes_of_its_force(Tsuji {
        modulus: 1e9,
        alpha: 0.3,
    });
    assert_eq!(typical_overlap([3e-3, 1e-3]), 1e-4);
}

/// Restitution of two grains with the law of the example, from the ratio of their speeds.
fn restitution(alpha: f64, speed: f64) -> f64 {
    let law = Tsuji {
        modulus: 1e9,
        alpha,
    };
    let grains = [[-1.001e-3, 0.0, speed], [1.001e-3, 0.0, -speed]];
    // A collision lasts about 4e-5 s at 1 m/s, and longer by the fifth root of a lower speed.
    let mut world = world_of(law, 2e-9 * speed.powf(-0.2), &grains);
    let velocity = |world: &World<f64, Tsuji>| world.particles().velocity[1].x;
    let mut has_met = false;
    while !has_met || world.number_of_contacts() > 0 {
        world.step().expect("the state stays finite");
        has_met |= world.number_of_contacts() > 0;
    }
    velocity(&world) / speed
}

/// The same from x'' = -max(0, x^(3/2) + alpha x^(1/4) x'), integrated by the classical method of Runge and Kutta.
fn integrated_restitution(alpha: f64) -> f64 {
    let slope = |[x, v]: [f64; 2]| {
        let x = x.max(0.0);
        [v, -(x * x.sqrt() + alpha * x.sqrt().sqrt() * v).max(0.0)]
    };
    let moved = |[x, v]: [f64; 2], [a, b]: [f64; 2], h: f64| [x + h * a, v + h * b];
    let (mut state, h) = ([0.0, 1.0], 1e-5);
    while state[0] >= 0.0 {
        let k = slope(state);
        let l = slope(moved(state, k, 0.5 * h));
        let m = slope(moved(state, l, 0.5 * h));
        let n = slope(moved(state, m, h));
        let sum = [0, 1].map(|at| (k[at] + 2.0 * (l[at] + m[at]) + n[at]) / 6.0);
        state = moved(state, sum, h);
    }
    -state[1]
}

#[test]
fn grains_with_the_law_of_the_example_rebound_alike_at_all_speeds() {
    for alpha in [0.1, 0.8] {
        let expected = integrated_restitution(alpha);
        for speed in [0.01, 1.0] {
            let found = restitution(alpha, speed);
            assert!(
                (found - expected).abs() < 2e-4,
                "{alpha} {speed}: {found} {expected}"
            );
        }
    }
}

#[test]
fn the_pile_of_the_example_comes_to_rest_and_closes_its_balance() {
    let world = fallen().expect("the example runs");
    let energy = world.energy();
    assert!(energy.friction > 0.0);
    assert!(energy.kinetic < 1e-3 * energy.friction, "{energy:?}");
    assert!(energy.residual.abs() < 1e-3 * energy.friction, "{energy:?}");
}

#[test]
fn fabric_is_isotropic_in_a_hexagon_and_wholly_anisotropic_in_a_row() {
    let law = ContactNormal::KelvinVoigt(KelvinVoigt {
        stiffness: 1e6,
        damping: 0.0,
    });
    let height = 1.9e-3 * 0.75_f64.sqrt();
    let row = [[0.0, 0.0, 0.0], [1.9e-3, 0.0, 0.0]];
    let triangle = [row[0], row[1], [0.95e-3, height, 0.0]];
    let of = |grains: &[[f64; 3]]| anisotropy(&world_of(law, 1e-8, grains));
    assert!(of(&row[..1]).is_none());
    assert!((of(&row).expect("a contact") - 1.0).abs() < 1e-12);
    assert!(of(&triangle).expect("contacts") < 1e-12);
}
