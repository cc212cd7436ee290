//! The forces at the contact points of a step.

use crate::assembly::{Assembly, Configuration};
use crate::local::Components;
use crate::step::Workspace;
use gouge_common::estimators::Tensor;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// A contact point with the mean force of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// The body or wall from which the normal points; walls are counted after all bodies.
    pub first: u32,
    /// The body to which the normal points.
    pub second: u32,
    /// Unit normal from the first to the second.
    pub normal: Vec2,
    /// Vectors from the centres of both to the point in m, as normal and tangential components.
    pub arms: [Components; 2],
    /// Height of the point in m.
    pub height: f64,
    /// Force on the second in N: impulse over time step.
    pub force: Components,
}

/// The forces at the points of the latest step: impulses over the time step, in the order of pairs.
///
/// Heights refer to the bodies where they are now, which is half a step after detection.
pub fn point_forces<'a>(
    assembly: &Assembly,
    configuration: &'a Configuration,
    workspace: &'a Workspace,
    time_step: f64,
) -> impl Iterator<Item = PointForce> + Clone + use<'a> {
    let bodies = assembly.unit.len() as u32;
    let points = workspace.keys().iter().zip(workspace.solver().rows());
    points.map(move |(key, row)| {
        // A wall is the first of a touch, and the second of a key.
        let (first, second) = match key.pair.j < bodies {
            true => (key.pair.i, key.pair.j),
            false => (key.pair.j, key.pair.i),
        };
        let (kinematics, impulse) = (row.kinematics(), row.impulse());
        let (n, arm) = (kinematics.normal, kinematics.arms[1]);
        let height = configuration.position[second as usize].y + n.y * arm.n + n.x * arm.t;
        PointForce {
            first,
            second,
            normal: n,
            arms: kinematics.arms,
            height,
            force: Components {
                n: impulse.n / time_step,
                t: impulse.t / time_step,
            },
        }
    })
}

/// Add the internal moment of every body to `moments`, azema (3).
///
/// $$ M_{ij} = \sum_c f_i\, r_j $$
///
/// with the force f on the body at its contact point c, in N, and the vector r from its centre to the point, in m. M is
/// in J, and its trace is negative for a compressed body. Symmetric if the contact forces exert no torque. The sum
/// over all bodies is minus the sum of $f_i \ell_j$ over all contacts, azema (4), whatever the balance.
///
/// # Errata and departures
/// The printed sum (4) of M has the sign of tension: azema E15.
#[rendered]
pub fn add_body_moments(points: impl Iterator<Item = PointForce>, moments: &mut [Tensor]) {
    for point in points {
        let n = point.normal;
        let vector = |c: Components| n * c.n + n.perpendicular() * c.t;
        let force = vector(point.force);
        let ends = [(point.first, -force), (point.second, force)];
        for ((body, force), arm) in ends.into_iter().zip(point.arms) {
            if let Some(moment) = moments.get_mut(body as usize) {
                *moment += Tensor::outer(force, vector(arm));
            }
        }
    }
}
