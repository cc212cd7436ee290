//! Random models and states over the whole range of numbers.

use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::bonds::BondStart;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Bshp, Controller, CorrelationDrag, CreepingDrag, CundallStrack,
    CundallStrackTruncated, Driving, EulerBernoulli, Gravity, HaffWerner, HarmonicWell,
    KelvinVoigt, ZhangEckert,
};
use gouge_dem::model::{
    Ambient, BondLaws, ContactLaws, ContactNormal, ContactTangential, External, Model, Reading,
    Yielding,
};
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::{ModelError, Start, World};
use rand::RngExt;
use rand_pcg::Pcg64;
use std::f64::consts::TAU;

/// The range from which numbers are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Range {
    /// Zero and magnitudes from 1e-12 to 1e12: an evaluation cannot overflow.
    Ordinary,
    /// Also subnormal numbers and magnitudes from 1e-307 to 1e308.
    Whole,
}

/// A source of random cases.
pub struct Draw {
    random: Pcg64,
    /// How often a number is not ordinary.
    extremes: f64,
}

impl Draw {
    /// The source of one case.
    pub fn new(case: u64, range: Range) -> Self {
        let mut random = Pcg64::new(u128::from(case), range as u128);
        let extremes = match range {
            Range::Ordinary => 0.0,
            Range::Whole => [0.02, 0.05, 0.3][random.random_range(0..3)],
        };
        Self { random, extremes }
    }
    fn unit(&mut self) -> f64 {
        self.random.random::<f64>()
    }
    fn below(&mut self, number: usize) -> usize {
        self.random.random_range(0..number)
    }
    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
    fn happens(&mut self) -> bool {
        self.below(2) == 0
    }
    /// A positive number.
    fn positive(&mut self) -> f64 {
        let decades = |low: f64, high: f64, at: f64| 10.0_f64.powf(low + (high - low) * at);
        let is_extreme = self.unit() < self.extremes;
        let kind = if is_extreme { self.below(3) } else { 3 };
        let at = self.unit();
        match kind {
            0 => f64::from_bits(self.random.random_range(1..1_u64 << 52)),
            1 => decades(-307.0, 308.0, at),
            2 => self.pick(&[f64::MIN_POSITIVE, f64::MAX, f64::from_bits(1), 1.0]),
            _ => decades(-12.0, 12.0, at),
        }
    }
    /// A number that may be zero.
    fn amount(&mut self) -> f64 {
        if self.below(8) == 0 {
            0.0
        } else {
            self.positive()
        }
    }
    /// A number of either sign.
    fn number(&mut self) -> f64 {
        if self.happens() {
            self.amount()
        } else {
            -self.amount()
        }
    }
    fn vector(&mut self) -> Vec2 {
        Vec2::new(self.number(), self.number())
    }

    fn contact(&mut self, reading: Reading) -> ContactLaws {
        let normal = if self.happens() {
            ContactNormal::KelvinVoigt(KelvinVoigt {
                stiffness: self.positive(),
                damping: self.amount(),
            })
        } else {
            ContactNormal::Bshp(Bshp {
                youngs_modulus: self.positive(),
                poissons_ratio: 1.5 * self.unit() - 1.0,
                dissipative_constant: self.amount(),
            })
        };
        let (friction, parameter) = (self.amount(), self.positive());
        let tangential = match self.below(4) {
            0 => None,
            1 => Some(ContactTangential::HaffWerner(HaffWerner {
                friction,
                damping: parameter,
            })),
            2 => Some(ContactTangential::CundallStrack(CundallStrack {
                friction,
                stiffness: parameter,
                grips_at_rest: reading == Reading::Thesis,
            })),
            _ => Some(ContactTangential::CundallStrackTruncated(
                CundallStrackTruncated {
                    friction,
                    stiffness: parameter,
                },
            )),
        };
        let distances = [
            ContactDistance::Radius,
            ContactDistance::Focal,
            ContactDistance::Mean,
        ];
        ContactLaws {
            distance: self.pick(&distances),
            normal,
            tangential,
        }
    }

    fn bond(&mut self) -> BondLaws {
        let normal = AdjustedKelvinVoigt {
            stiffness: self.positive(),
            damping: self.amount(),
        };
        let tangential = self.happens().then(|| EulerBernoulli {
            stiffness: self.positive(),
            damping: self.amount(),
        });
        let yielding = self.happens().then(|| Yielding {
            law: ZhangEckert {
                normal_strength: self.positive(),
                tangential_strength: self.positive(),
            },
            tensile_strength: None,
            unbreakable_edges: self.happens(),
        });
        BondLaws {
            normal,
            tangential,
            yielding,
        }
    }

    fn fields(&mut self) -> (Option<Ambient>, Option<External>) {
        let viscosity = self.positive();
        let ambient = match self.below(3) {
            0 => None,
            1 => Some(Ambient::Creeping(CreepingDrag { viscosity })),
            _ => Some(Ambient::Correlation(CorrelationDrag {
                viscosity,
                density: self.positive(),
                constant: self.positive(),
            })),
        };
        let external = match self.below(3) {
            0 => None,
            1 => Some(External::Gravity(Gravity {
                acceleration: self.number(),
            })),
            _ => Some(External::HarmonicWell(HarmonicWell {
                stiffness: self.amount(),
                centre: self.number(),
            })),
        };
        (ambient, external)
    }

    fn driving(&mut self) -> Driving {
        let controller = if self.happens() {
            Controller::Exact
        } else {
            Controller::RateLimited {
                force_rate: self.amount(),
            }
        };
        Driving {
            controller,
            speed: self.number(),
            pressure: self.number(),
            area: self.positive(),
        }
    }

    /// A time step that keeps translations and rotations per step small, or any time step.
    fn step(&mut self, particles: &Particles) -> f64 {
        if self.below(32) == 0 {
            return self.positive();
        }
        let of = |i: usize| {
            let speed = particles.velocity[i].x.abs() + particles.velocity[i].y.abs();
            (particles.radius[i] / speed).min(1.0 / particles.angular_velocity[i].abs())
        };
        let longest = of(0).min(of(1)).clamp(f64::MIN_POSITIVE, f64::MAX);
        longest * 10.0_f64.powf(-1.0 - 9.0 * self.unit())
    }

    /// A random model, with interactions only or with everything.
    fn model(&mut self) -> Model {
        let width = self.happens().then(|| {
            let power = if self.below(4) == 0 { 0.0 } else { 13.0 };
            self.positive() * 10.0_f64.powf(power)
        });
        let reading = self.pick(&[Reading::Corrected, Reading::Thesis]);
        let alone = self.happens();
        let fields = if alone { (None, None) } else { self.fields() };
        let bonded = self.happens();
        Model {
            reading,
            integrator: self.pick(&Integrator::ALL),
            time_step: 0.0,
            domain: Domain {
                width,
                height: self.happens().then(|| self.positive()),
                periodic: self.happens(),
            },
            contact: (!bonded || self.happens()).then(|| self.contact(reading)),
            bond: bonded.then(|| self.bond()),
            ambient: fields.0,
            external: fields.1,
            driving: (!alone && self.happens()).then(|| self.driving()),
            ledger: self.happens(),
        }
    }

    fn particle(&mut self, position: Vec2, radius: f64, role: Role) -> Particle {
        Particle {
            position,
            velocity: self.vector(),
            angle: self.number(),
            angular_velocity: self.number(),
            radius,
            density: self.positive(),
            inertia_factor: SPHERE_INERTIA_FACTOR,
            role,
        }
    }

    /// A pair that overlaps, touches, coincides or lies anywhere.
    fn pair(&mut self, driven: bool) -> Particles {
        let radius = self.positive();
        let other = if self.happens() {
            radius * (0.1 + self.unit())
        } else {
            self.positive()
        };
        let place = if self.happens() {
            Vec2::zero()
        } else {
            self.vector()
        };
        let reach = match self.below(8) {
            0 => 0.0,
            1 => radius + other,
            _ => (radius + other) * 1.1 * self.unit(),
        };
        let turn = TAU * self.unit();
        let offset = match self.below(8) {
            0 => self.vector(),
            _ => Vec2::new(reach * libm::cos(turn), reach * libm::sin(turn)),
        };
        let roles = [Role::Free, if driven { Role::Driven } else { Role::Fixed }];
        let second = if driven {
            Role::Driven
        } else {
            self.pick(&roles)
        };
        let first = self.particle(place, radius, Role::Free);
        [first, self.particle(place + offset, other, second)]
            .into_iter()
            .collect()
    }

    /// A random world of two particles.
    pub fn world(&mut self) -> Result<World, ModelError> {
        let mut model = self.model();
        let particles = self.pair(model.driving.is_some());
        model.time_step = self.step(&particles);
        let bond = BondStart {
            between: [0, 1],
            strength_factor: 1.0,
            initial_distance: self.happens().then(|| self.positive()),
            initial_angles: self.happens().then(|| [self.number(), self.number()]),
        };
        let start = Start {
            bonds: model.bond.iter().map(|_| bond).collect(),
            contacts: Vec::new(),
            drive_force: self.vector(),
        };
        World::new(model, particles, &start)
    }
}
