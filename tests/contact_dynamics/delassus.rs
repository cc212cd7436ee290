//! Kinematics and response of contact points.

use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::units::{InverseMass, Velocity};
use proptest::prelude::*;

fn vector() -> impl Strategy<Value = Vec2> {
    (-2.0..2.0, -2.0..2.0).prop_map(|(x, y)| Vec2::new(x, y))
}

fn mass() -> impl Strategy<Value = InverseMass> {
    let part = || prop_oneof![1 => Just(0.0), 4 => 0.1..5.0];
    (part(), part(), part()).prop_map(|(x, y, rotation)| InverseMass { x, y, rotation })
}

fn velocity() -> impl Strategy<Value = Velocity> {
    (vector(), -3.0..3.0).prop_map(|(linear, angular)| Velocity { linear, angular })
}

/// Velocity of a point of a turning body, component by component.
fn point_velocity(v: Velocity, arm: Vec2) -> Vec2 {
    Vec2::new(
        v.linear.x - v.angular * arm.y,
        v.linear.y + v.angular * arm.x,
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_relative_velocity_is_that_of_the_material_points(
        angle in -4.0f64..4.0, arms in [vector(), vector()], v in [velocity(), velocity()],
    ) {
        let normal = Vec2::new(angle.cos(), angle.sin());
        let point = PointKinematics::new([0, 1], normal, arms);
        let u = point.relative_velocity(&v);
        let relative = point_velocity(v[1], arms[1]) - point_velocity(v[0], arms[0]);
        prop_assert!((u.n - (normal.x * relative.x + normal.y * relative.y)).abs() < 1e-13);
        prop_assert!((u.t - (-normal.y * relative.x + normal.x * relative.y)).abs() < 1e-13);
    }

    /// W is what an impulse does to the relative velocity, with the sign of its mixed term; it is symmetric, and the
    /// power of an impulse is the same for the bodies and for the point.
    #[test]
    fn the_operator_is_the_response_to_an_impulse(
        angle in -4.0f64..4.0, arms in [vector(), vector()], masses in [mass(), mass()], v in [velocity(), velocity()],
    ) {
        let normal = Vec2::new(angle.cos(), angle.sin());
        let point = PointKinematics::new([0, 1], normal, arms);
        let w = point.delassus(&masses);
        let response = |n: f64, t: f64| {
            let mut rest = [Velocity::default(); 2];
            point.apply(Components { n, t }, &masses, &mut rest);
            point.relative_velocity(&rest)
        };
        let (to_n, to_t) = (response(1.0, 0.0), response(0.0, 1.0));
        let size = 1e-13 * (w.nn + w.tt + 1.0);
        prop_assert!((to_n.n - w.nn).abs() < size && (to_t.t - w.tt).abs() < size);
        prop_assert!((to_n.t - w.nt).abs() < size && (to_t.n - w.nt).abs() < size);
        prop_assert!(w.nn >= 0.0 && w.tt >= 0.0 && w.nn * w.tt - w.nt * w.nt >= -size * (w.nn + w.tt));
        let unit_masses = [InverseMass { x: 1.0, y: 1.0, rotation: 1.0 }; 2];
        let impulse = Components { n: 0.7, t: -1.3 };
        let mut generalized = [Velocity::default(); 2];
        point.apply(impulse, &unit_masses, &mut generalized);
        let power: f64 = generalized.iter().zip(&v).map(|(f, v)| f.linear.dot(v.linear) + f.angular * v.angular).sum();
        let u = point.relative_velocity(&v);
        prop_assert!((power - (impulse.n * u.n + impulse.t * u.t)).abs() < 1e-12);
    }

    /// Momentum and angular momentum do not change.
    #[test]
    fn impulses_are_exchanged(
        angle in -4.0f64..4.0, place in vector(), centres in [vector(), vector()], m in [0.1..5.0, 0.1..5.0],
        i in [0.1..5.0, 0.1..5.0], n in -3.0..3.0, t in -3.0..3.0,
    ) {
        let masses = [0, 1].map(|k| InverseMass { x: 1.0 / m[k], y: 1.0 / m[k], rotation: 1.0 / i[k] });
        let arms = centres.map(|centre| place - centre);
        let point = PointKinematics::new([0, 1], Vec2::new(angle.cos(), angle.sin()), arms);
        let mut v = [Velocity::default(); 2];
        point.apply(Components { n, t }, &masses, &mut v);
        let momentum = v[0].linear * m[0] + v[1].linear * m[1];
        let spin: f64 = (0..2).map(|k| m[k] * centres[k].cross(v[k].linear) + i[k] * v[k].angular).sum();
        prop_assert!(momentum.norm() < 1e-13 && spin.abs() < 1e-12);
    }
}
