//! The force-bearing contacts of a step.

use super::PointForce;
use crate::local::Components;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// How two bodies touch, by the forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// A simple contact: one force-bearing point.
    SideVertex,
    /// A double contact: two force-bearing points.
    SideSide,
}

/// A force-bearing contact of two bodies. It counts once, whatever the number of its points.
///
/// # Sign
/// The normal points from the first to the second body, and the tangent is the normal turned by +90 degrees. The force
/// acts on the second body, so that a compressed contact has a positive normal force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The body from which the normal points.
    pub first: u32,
    /// The body to which the normal points.
    pub second: u32,
    /// Unit normal.
    pub normal: Vec2,
    /// Sum of the forces at the points, on the second body, in N.
    pub force: Components,
    /// Branch vector from the centre of the first to that of the second body in m.
    pub branch: Components,
    /// Mean height of the points in m.
    pub height: f64,
    /// Whether one or two points bear force.
    pub kind: ContactKind,
    /// Whether the resultant is at the Coulomb limit.
    pub is_sliding: bool,
    /// Whether one of two points is at the Coulomb limit and the other is not.
    pub has_unequal_points: bool,
}

/// A force-bearing contact of a wall and a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallContact {
    /// Index of the wall; walls are counted after all bodies.
    pub wall: u32,
    /// The body.
    pub body: u32,
    /// Unit normal out of the wall.
    pub normal: Vec2,
    /// Sum of the forces at the points, on the body, in N.
    pub force: Components,
}

/// What counts as a force, and as sliding.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NetworkSettings {
    /// A point bears force if $f_n$ exceeds this times the mean of the positive normal forces.
    pub threshold: f64,
    /// Coefficient of friction $\mu$.
    pub friction: f64,
    /// A contact slides if $|f_t| \ge (1 - \epsilon) \mu f_n$, with this $\epsilon$.
    pub sliding_tolerance: f64,
}

impl NetworkSettings {
    /// The thresholds used throughout, 1e-6 each.
    pub fn for_friction(friction: f64) -> Self {
        Self {
            threshold: 1e-6,
            friction,
            sliding_tolerance: 1e-6,
        }
    }

    /// Whether a force is at the Coulomb limit.
    #[inline]
    pub fn is_sliding(&self, force: Components) -> bool {
        force.t.abs() >= (1.0 - self.sliding_tolerance) * self.friction * force.n
    }
}

/// All force-bearing contacts of a step. Its buffers are reused from step to step.
#[derive(Clone, Debug, Default)]
pub struct Network {
    contacts: Vec<Contact>,
    walls: Vec<WallContact>,
    counts: Vec<u32>,
}

impl Network {
    /// A network without contacts.
    pub fn new() -> Self {
        Self::default()
    }

    /// Contacts between bodies, in the order of the points.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Contacts between walls and bodies. They enter no stress, because a wall has no centre.
    pub fn walls(&self) -> &[WallContact] {
        &self.walls
    }

    /// Number of force-bearing contacts per body, those with walls among them.
    pub fn counts(&self) -> &[u32] {
        &self.counts
    }

    /// Take the points of a step. The points of a pair follow each other, and there are `bodies` bodies.
    pub fn update<I>(&mut self, points: I, bodies: usize, settings: &NetworkSettings)
    where
        I: Iterator<Item = PointForce> + Clone,
    {
        self.contacts.clear();
        self.walls.clear();
        self.counts.clear();
        self.counts.resize(bodies, 0);
        let (mut sum, mut positive) = (0.0, 0);
        for point in points.clone().filter(|point| point.force.n > 0.0) {
            sum += point.force.n;
            positive += 1;
        }
        let least = settings.threshold * sum / f64::from(positive.max(1));
        let mut sliding_first = false;
        for point in points.filter(|point| point.force.n > least) {
            if point.first as usize >= bodies {
                self.add_wall_point(&point);
            } else if let Some(contact) = same(self.contacts.last_mut(), &point) {
                contact.join(&point, sliding_first, settings);
            } else {
                sliding_first = settings.is_sliding(point.force);
                self.add_contact(&point, sliding_first);
            }
        }
    }

    fn add_contact(&mut self, point: &PointForce, is_sliding: bool) {
        let [one, other] = point.arms;
        self.contacts.push(Contact {
            first: point.first,
            second: point.second,
            normal: point.normal,
            force: point.force,
            // The point is at c1 from the first centre and at c2 from the second one.
            branch: Components {
                n: one.n - other.n,
                t: one.t - other.t,
            },
            height: point.height,
            kind: ContactKind::SideVertex,
            is_sliding,
            has_unequal_points: false,
        });
        self.count(point.first);
        self.count(point.second);
    }

    fn add_wall_point(&mut self, point: &PointForce) {
        let is_same = |c: &&mut WallContact| c.wall == point.first && c.body == point.second;
        if let Some(contact) = self.walls.last_mut().filter(is_same) {
            contact.force.n += point.force.n;
            contact.force.t += point.force.t;
            return;
        }
        self.walls.push(WallContact {
            wall: point.first,
            body: point.second,
            normal: point.normal,
            force: point.force,
        });
        self.count(point.second);
    }

    fn count(&mut self, body: u32) {
        if let Some(count) = self.counts.get_mut(body as usize) {
            *count += 1;
        }
    }
}

fn same<'a>(contact: Option<&'a mut Contact>, point: &PointForce) -> Option<&'a mut Contact> {
    contact.filter(|contact| contact.first == point.first && contact.second == point.second)
}

impl Contact {
    /// Add the second point of the contact.
    fn join(&mut self, point: &PointForce, sliding_first: bool, settings: &NetworkSettings) {
        self.force.n += point.force.n;
        self.force.t += point.force.t;
        self.height = 0.5 * (self.height + point.height);
        self.kind = ContactKind::SideSide;
        self.is_sliding = settings.is_sliding(self.force);
        self.has_unequal_points = settings.is_sliding(point.force) != sliding_first;
    }

    /// Twice the angle of the normal, as the unit vector (cos 2 theta, sin 2 theta).
    #[inline]
    pub fn axis(&self) -> Vec2 {
        let n = self.normal;
        Vec2::new(n.x * n.x - n.y * n.y, 2.0 * n.x * n.y)
    }

    /// A vector with the given components.
    #[inline]
    pub fn vector(&self, components: Components) -> Vec2 {
        self.normal * components.n + self.normal.perpendicular() * components.t
    }
}
