//! Chung and Ooi's tests 7 and 8: two spheres with spin.

use super::literature;
use super::plane::{Material, linear, material, tangential};
use super::sweep::{Laws, SPINNING_SOLIDS, spins, step_errors};
use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::impact::{
    Impact, Moment, Motion, Normal, Tangential, damping_ratio, dissipative_constant,
};
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.chung-ooi.7",
            claim: "Test 7: equal spheres with opposite spins collide and roll on each other, so that their spins and their path do not change at all.",
            equations: thesis("(6)-(7), (34), (41)-(42)"),
            scene: "Two spheres of aluminium alloy or copper at 0.2 m/s each, spins of 0.17 to 22.9 rad/s; both normal laws with each of the three tangential laws, 150 steps",
            oracle: "Symmetry: the contact does not slide",
            norm: "Number of collisions, of 204, in which a bit of a spin changes, a sphere leaves the line of centres, or the final speeds are unequal",
            origin: Origin::Exact,
            reason: "Terms cancel exactly, not only up to rounding: r w + r (-w) = 0",
            effort: Effort::Quick,
            measure: opposite_spins,
        },
        Check {
            id: "benchmarks.chung-ooi.8-momentum",
            claim: "Test 8: two unequal spheres conserve their total momentum and angular momentum, and the friction impulse acts on both in proportion to their lever arms.",
            equations: thesis("(6)-(7), (26)-(27), (51)"),
            scene: "A spinning sphere of 0.1 m collides with a sphere of 0.5 m that is 1000 times as dense; aluminium alloy and nylon, 17 spins, three pairs of laws, 200 steps",
            oracle: "Conservation of momentum and angular momentum; J dw / r is the same impulse for both",
            norm: "Largest change over the sum of the absolute values exchanged",
            origin: Origin::Exact,
            reason: "200 steps, each with a rounding of 1.1e-16; the terms of the heavy sphere are at most 1e5 times as large as the amount exchanged",
            effort: Effort::Quick,
            measure: momentum,
        },
        Check {
            id: "benchmarks.chung-ooi.8",
            claim: "Test 8, a spinning sphere hits a larger one: the whole curve of the slip after the collision follows from the laws.",
            equations: thesis("(5)-(7), (28)-(42), (51)-(53)"),
            scene: "The collisions of test 8 with 1500 steps",
            oracle: "High-order integration in the rotating frame of the pair, between located events",
            norm: "Error of relative speed, angular momentum of the centres over the sum of the radii, and both surface speeds, in units of the initial normal speed; the one closest to its tolerance",
            origin: Origin::Convergent,
            reason: "As in test 6. The lever arms are the radii, so that the friction on both centres is larger, by the sum of the radii over the distance, than in models with shorter arms",
            effort: Effort::Thorough,
            measure: unequal,
        },
    ]
}

const COPPER: Material = material("copper", [1.2e11, 0.35], 8900.0);

fn opposite_spins() -> Outcome {
    let laws = [
        ("haff-werner", 1e6),
        ("cundall-strack", 1e8),
        ("cundall-strack-truncated", 1e8),
    ];
    let mut changed = 0;
    for solid in [SPINNING_SOLIDS[0], COPPER] {
        let mass = solid.mass(0.1);
        let normal = Normal::Hertzian([solid.factor_on_plane(0.1) / 8.0_f64.sqrt(), 0.0]);
        let [duration, _] = normal.elastic(0.5 * mass, 0.4);
        let stiffness = 0.5 * mass * (PI / duration).powi(2);
        let normals = [
            solid.hertzian(1.0, 0.1 * duration),
            linear(stiffness, 0.2 * (stiffness * mass).sqrt()),
        ];
        for (_, spin) in spins(0.2, 0.1) {
            for normal in &normals {
                for (law, constant) in laws {
                    let draft = Draft::open_box(Integrator::VelocityVerlet, duration / 100.0)
                        .grain(sphere(solid, -1.0, spin))
                        .grain(sphere(solid, 1.0, spin))
                        .and(normal)
                        .friction(law, 0.4, constant);
                    let mut world = draft.world()?;
                    advance(&mut world, 150)?;
                    changed += usize::from(!rolls(&world, spin));
                }
            }
        }
    }
    Ok(Measurement::count(changed).into())
}

/// A sphere of test 7 on one side, in contact and approaching.
fn sphere(solid: Material, side: f64, spin: f64) -> Grain {
    let motion = [-0.2 * side, 0.0];
    Grain::at([0.1 * side, 0.0], 0.1)
        .moving(motion)
        .spinning(-side * spin)
        .of_density(solid.density)
}

/// Whether the spins are unchanged, the velocities lie on the line of centres and are opposite, and the
/// spheres separate.
fn rolls(world: &World, spin: f64) -> bool {
    let p = world.particles();
    let velocities = [p.velocity[0], p.velocity[1]];
    p.angular_velocity == [spin, -spin]
        && velocities.iter().all(|v| v.y == 0.0)
        && p.position.iter().all(|x| x.y == 0.0)
        && velocities[0].x == -velocities[1].x
        && velocities[0].x < -0.02
}

/// Radii of test 8 in m.
const RADII: [f64; 2] = [0.1, 0.5];
/// Ratio of the densities and of the moduli, larger sphere to smaller.
const HEAVIER: f64 = 1000.0;
const SPEED: f64 = 0.2;
const FRICTION: f64 = 0.4;
const RESTITUTION: f64 = 0.5;

/// A collision of test 8.
struct Unequal {
    solid: Material,
    masses: [f64; 2],
    impact: Impact,
}

impl Unequal {
    fn new(solid: Material, laws: Laws, dissipation: f64) -> Self {
        let masses = [solid.mass(RADII[0]), HEAVIER * solid.mass(RADII[1])];
        let mass = 1.0 / (1.0 / masses[0] + 1.0 / masses[1]);
        let reach = RADII[0] + RADII[1];
        let reduced_radius = RADII[0] * RADII[1] / reach;
        let factor = solid.factor_on_plane(reduced_radius) / (1.0 + 1.0 / HEAVIER);
        let [duration, _] = Normal::Hertzian([factor, 0.0]).elastic(mass, SPEED);
        let stiffness = mass * (PI / duration).powi(2);
        let damping = 2.0 * damping_ratio(RESTITUTION) * (stiffness * mass).sqrt();
        let nu = solid.poissons_ratio;
        let spring = Tangential::Spring([FRICTION, 2.0 * (1.0 - nu) / (2.0 - nu) * stiffness]);
        let hertzian = Normal::Hertzian([factor, dissipation * duration]);
        let (normal, tangential) = match laws {
            Laws::HertzViscous => (
                hertzian,
                Tangential::Viscous([FRICTION, 20.0 * mass / duration]),
            ),
            Laws::HertzSpring => (hertzian, spring),
            Laws::LinearSpring => (Normal::Linear([stiffness, damping]), spring),
        };
        let impact = Impact {
            normal,
            tangential,
            mass,
            compliance: masses.map(|mass| 2.5 / mass),
            inverse_reach: 1.0 / reach,
        };
        Self {
            solid,
            masses,
            impact,
        }
    }

    fn step(&self, steps: u64) -> f64 {
        self.impact.normal.elastic(self.impact.mass, SPEED)[0] / steps as f64
    }

    fn world(&self, spin: f64, steps: u64) -> Result<World, Failure> {
        let law = match self.impact.normal {
            Normal::Linear([stiffness, damping]) => linear(stiffness, damping),
            // Twice the reduced modulus of a solid and of one a thousand times as stiff.
            Normal::Hertzian([_, dissipation]) => self
                .solid
                .hertzian(2.0 / (1.0 + 1.0 / HEAVIER), dissipation),
        };
        let density = self.solid.density;
        let height = (RADII[0] + RADII[1]).next_down();
        let draft = Draft::open_box(Integrator::VelocityVerlet, self.step(steps))
            .grain(
                Grain::at([0.0, height], RADII[0])
                    .moving([0.0, -SPEED])
                    .spinning(spin)
                    .of_density(density),
            )
            .grain(Grain::at([0.0, 0.0], RADII[1]).of_density(HEAVIER * density))
            .and(&law)
            .and(&tangential(self.impact.tangential));
        Ok(draft.world()?)
    }

    /// The world after the collision.
    fn after(&self, spin: f64, steps: u64) -> Result<World, Failure> {
        let mut world = self.world(spin, steps)?;
        for _ in 0..20 * steps {
            world.step()?;
            let p = world.particles();
            let d = p.position[1] - p.position[0];
            if d.norm_squared() > (RADII[0] + RADII[1]).powi(2) {
                return Ok(world);
            }
        }
        Err(Failure::Oracle("the spheres do not part".to_owned()))
    }

    fn expected(&self, spin: f64) -> Result<Moment, Failure> {
        let start = Motion {
            approach: SPEED,
            shear: 0.0,
            surface: [RADII[0] * spin, 0.0],
        };
        let moments = self.impact.run(start, 3);
        let last = moments.and_then(|moments| moments.last().copied());
        last.ok_or_else(|| Failure::Oracle("the collision does not end".to_owned()))
    }

    /// Total momentum along x and y and total angular momentum, in units of the amounts exchanged.
    fn totals(&self, world: &World, spin: f64) -> [f64; 3] {
        let p = world.particles();
        let mut sums = [0.0; 3];
        for (i, radius) in RADII.iter().enumerate() {
            let (m, v) = (self.masses[i], p.velocity[i]);
            sums[0] += m * v.x;
            sums[1] += m * v.y;
            let inertia = 0.4 * m * radius * radius;
            sums[2] += m * p.position[i].cross(v) + inertia * p.angular_velocity[i];
        }
        let linear = self.masses[0] * SPEED;
        let angular = 0.4 * self.masses[0] * RADII[0] * RADII[0] * spin + linear * RADII[0];
        [sums[0] / linear, sums[1] / linear, sums[2] / angular]
    }
}

/// Every collision of test 8: angle in degrees, spin, collision and its laws.
fn collisions() -> Result<Vec<(f64, f64, Unequal, Laws)>, Failure> {
    let dissipation = dissipative_constant(RESTITUTION)
        .ok_or_else(|| Failure::Oracle("no dissipative constant".to_owned()))?;
    let mut all = Vec::new();
    for solid in SPINNING_SOLIDS {
        for laws in Laws::ALL {
            for (degrees, spin) in spins(SPEED, RADII[0]) {
                all.push((degrees, spin, Unequal::new(solid, laws, dissipation), laws));
            }
        }
    }
    Ok(all)
}

fn momentum() -> Outcome {
    let mut all = Vec::new();
    for (_, spin, pair, _) in collisions()? {
        let before = pair.totals(&pair.world(spin, 200)?, spin);
        let world = pair.after(spin, 200)?;
        let after = pair.totals(&world, spin);
        for (before, after) in before.iter().zip(after) {
            all.push(Measurement::absolute(*before, after, 1e-13));
        }
        let spins = &world.particles().angular_velocity;
        let impulse = |i: usize, change: f64| 0.4 * pair.masses[i] * RADII[i] * change;
        let [small, large] = [impulse(0, spins[0] - spin), impulse(1, spins[1])];
        let scale = impulse(0, spin) + pair.masses[0] * SPEED;
        all.push(Measurement::scaled(small, large, scale, 1e-13));
    }
    Ok(Measurement::worst(all).into())
}

fn unequal() -> Outcome {
    const STEPS: u64 = 1500;
    let mut all = Vec::new();
    let mut curves: Vec<[Vec<[f64; 2]>; 2]> = vec![Default::default(); Laws::ALL.len()];
    for (degrees, spin, pair, laws) in collisions()? {
        let expected = pair.expected(spin)?;
        let world = pair.after(spin, STEPS)?;
        let (compared, slip) = compare(&pair, spin, &expected, &world, pair.step(STEPS));
        all.extend(compared);
        let at = Laws::ALL.iter().position(|&one| one == laws);
        if let Some(curve) = at.and_then(|at| curves.get_mut(at))
            && pair.solid.name == SPINNING_SOLIDS[0].name
        {
            let x = 2.1 / degrees.to_radians().tan();
            let before = RADII[0] * spin;
            let [p, q] = expected.motion.surface;
            let stretch = 1.0 / (1.0 - expected.overlap * pair.impact.inverse_reach);
            let oracle = p + q - expected.motion.shear * stretch * stretch;
            curve[0].push([x, -oracle / before]);
            curve[1].push([x, -slip / before]);
        }
    }
    let mut drawn = Vec::new();
    for (laws, [oracle, kernel]) in Laws::ALL.iter().zip(curves) {
        drawn.push(Curve::line(&format!("oracle: {}", laws.name()), oracle));
        drawn.push(Curve::marks(&format!("kernel: {}", laws.name()), kernel));
    }
    let label = "literature: Chung and Ooi, Hertz-Mindlin, sphere on plane, digitised";
    drawn.push(Curve::marks(label, literature::SPINNING));
    let plot = Figure::new(
        "Against a heavy sphere of five times the radius the slip rebounds as from a plane",
        Axis::linear("(7/2) mu (1 + e) V_n over the slip before", ""),
        Axis::linear("minus slip after over slip before", ""),
        drawn,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

/// Conserved quantities after the collision, kernel against oracle, and the kernel's slip.
fn compare(
    pair: &Unequal,
    spin: f64,
    expected: &Moment,
    world: &World,
    step: f64,
) -> ([Measurement; 4], f64) {
    let p = world.particles();
    let reach = RADII[0] + RADII[1];
    let d = p.position[1] - p.position[0];
    let v = p.velocity[1] - p.velocity[0];
    let shear = d.cross(v) / reach;
    let surface = [0, 1].map(|i| RADII[i] * p.angular_velocity[i]);
    let slip = surface[0] + surface[1] - shear * reach * reach / d.norm_squared();
    let motion = expected.motion;
    let along = motion.shear * reach / (reach - expected.overlap);
    let [normal_bound, along_bound] = step_errors(&pair.impact, SPEED, RADII[0] * spin, step);
    let compared = |a, b, bound| Measurement::scaled(a, b, SPEED, bound);
    let share = pair
        .impact
        .compliance
        .map(|compliance| compliance * pair.impact.mass);
    let speed = v.norm_squared().sqrt();
    (
        [
            compared(
                motion.approach.hypot(along),
                speed,
                normal_bound + along_bound,
            ),
            compared(motion.shear, shear, along_bound),
            compared(motion.surface[0], surface[0], share[0] * along_bound),
            compared(motion.surface[1], surface[1], share[1] * along_bound),
        ],
        slip,
    )
}
