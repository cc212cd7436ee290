//! Unusable input: every mistake is named with file, line, key, value and what is accepted.

use crate::program::{gouge, stderr};
use rand::RngExt;
use rand_pcg::Pcg64;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// Longest time in s that the program may take to refuse a scene.
const PATIENCE: u64 = 20;

/// A scene with every table, which is usable as it stands.
const FULL: &str = r#"title = "base"
reading = "corrected"

[time]
step = 1e-9
end = 1e-7
integrator = "velocity-verlet"

[box]
width = 20e-3
height = 10e-3
boundary = "periodic-x"

[material]
density = 2700.0

[contact]
distance = "radius"
[contact.normal]
law = "kelvin-voigt"
stiffness = 1e7
damping = 10.0
[contact.tangential]
law = "cundall-strack"
friction = 0.7
stiffness = 1e8

[bond.normal]
stiffness = 2e7
damping = 20.0
[bond.tangential]
law = "euler-bernoulli"
stiffness = 3e7
damping = 30.0
[bond.yielding]
law = "zhang-eckert"
normal_strength = 280e6
tangential_strength = 168e6
unbreakable_edges = true

[ambient]
law = "creeping"
viscosity = 18e-6

[external]
law = "gravity"
acceleration = 9.81

[driving]
controller = "rate-limited"
speed = 2.0
pressure = 28e6
area = 2e-4
force_rate = 1e8
initial_force = [0.0, 0.0]

[[particles]]
position = [4e-3, 5e-3]
velocity = [1.0, 0.0]
angle = 0.0
angular_velocity = 0.0
radius = 1.0e-3
density = 2600.0
role = "free"

[[particles]]
position = [6e-3, 5e-3]
radius = 1.1e-3
role = "driven"

[[particles]]
position = [8.05e-3, 5e-3]
velocity = [0.0, 0.0]
angular_velocity = 0
radius = 1.2e-3
role = "fixed"

[[bonds]]
between = [0, 1]
strength_factor = 1.0
initial_distance = 2e-3
initial_angles = [0.0, 3.14]

[[contacts]]
between = [1, 2]
initial_angles = [0.1, 0.2]

[output]
interval = 1e-8
trajectory = "none"
energy = true
"#;

/// A scene whose particles are made by a set-up, usable as it stands.
const MADE: &str = r#"title = "made"

[time]
step = 1e-8
end = 1e-6
integrator = "velocity-verlet"

[box]
width = 8e-3
height = 8e-3
boundary = "periodic-x"

[material]
density = 2700.0

[contact.normal]
law = "kelvin-voigt"
stiffness = 1e7
damping = 10.0

[bond.normal]
stiffness = 1e7
damping = 10.0

[driving]
controller = "exact"
speed = 1.0
pressure = 1e5

[setup]
seed = 7
clip = true
correct_density = true

[setup.sizes]
minimum = 0.5e-3
maximum = 0.6e-3

[setup.lattice]
arrangement = "square"
pitch = 1.2e-3
perturbation = 0.0
columns = 6
rows = 6

[[setup.settle]]
duration = 1e-6
step = 1e-8
ambient = { law = "creeping", viscosity = 1.0 }

[setup.bonding]
reach = 1.3
strength_spread = 0.1

[setup.fault]
level = 4e-3
height = 1e-3
jags = 2.0

[[setup.relax]]
duration = 1e-6
step = 1e-8

[setup.roles]
fixed_below = 1.5e-3
driven_above = 6.0e-3

[[setup.press]]
duration = 1e-6
step = 1e-8
speed = 0.0
"#;

/// A scene whose particles and links stand in files beside it, usable as it stands.
const BESIDE: &str = r#"particles_file = "p.csv"
bonds_file = "b.csv"
contacts_file = "c.csv"
[time]
step = 1e-9
end = 1e-8
integrator = "euler"
[material]
density = 2700.0
[contact.normal]
law = "kelvin-voigt"
stiffness = 1e7
damping = 10.0
[bond.normal]
stiffness = 1e7
damping = 10.0
"#;

/// The files beside it.
const TABLES: [(&str, &str); 3] = [
    ("p.csv", "x,y,radius,vx,role\n0.0,0.0,1e-3,0.0,free\n2e-3,0.0,1e-3,0.0,free\n3.9e-3,0.0,1e-3,0.0,fixed\n"),
    ("b.csv", "i,j,strength_factor\n0,1,1.0\n"),
    ("c.csv", "i,j,initial_angle_i,initial_angle_j\n1,2,0.1,0.2\n"),
];

/// What replaces what in a scene, and the key, the value and a part of what is accepted that the message
/// must state. The line is the one that ends with `# here`; without one it is the first of the file.
type Edit = (&'static str, &'static str, &'static str, &'static str, &'static str);

const POSITIVE: &str = "must be a finite number greater than zero";
const NOT_NEGATIVE: &str = "must be a finite number, zero or greater";
const FINITE: &str = "must be a finite number";
const MISSING: &str = "missing; must be a finite number";
const PAIR: &str = "must be an array of two finite numbers";
const INDICES: &str = "must be an array of two particle indices, counted from 0";
const WHOLE: &str = "must be a whole number, zero or greater";

/// Mistakes in the scene with every table.
const FULL_EDITS: &[Edit] = &[
    // Keys that nobody knows, at every level.
    ("title =", "titel = 'x' # here\ntitle =", "titel", "\"x\"", "unknown key; accepted here: title, reading, time"),
    ("[material]", "[gravity] # here\ng = 1\n[material]", "gravity", "{table}", "unknown key; accepted here: title"),
    ("end = 1e-7", "end = 1e-7\nduration = 2 # here", "time.duration", "2", "accepted here: step, end, integrator"),
    ("[box]", "[box]\ndepth = 1.5 # here", "box.depth", "1.5", "accepted here: width, height, boundary"),
    ("density = 2700.0", "density = 2700.0\nyoung = 1e9 # here", "material.young", "1e9", "accepted here: density"),
    ("[contact]", "[contact]\nkind = true # here", "contact.kind", "true", "accepted here: distance, normal, tangential"),
    ("stiffness = 1e7", "stiffness = 1e7\nrestitution = 0.5 # here", "contact.normal.restitution", "0.5", "accepted here: law, stiffness, damping"),
    ("friction = 0.7", "friction = 0.7\ndamping = 1.0 # here", "contact.tangential.damping", "1.0", "accepted here: law, friction, stiffness"),
    ("[bond.normal]", "[bond]\nstrength = 1 # here\n[bond.normal]", "bond.strength", "1", "accepted here: normal, tangential, yielding"),
    ("stiffness = 2e7", "stiffness = 2e7\nlaw = 'x' # here", "bond.normal.law", "\"x\"", "accepted here: stiffness, damping"),
    ("stiffness = 3e7", "stiffness = 3e7\nradius = 1 # here", "bond.tangential.radius", "1", "accepted here: law, stiffness, damping"),
    ("normal_strength = 280e6", "normal_strength = 280e6\nspread = 0 # here", "bond.yielding.spread", "0", "accepted here: law, normal_strength, tangential_strength, unbreakable_edges"),
    ("viscosity = 18e-6", "viscosity = 18e-6\ndensity = 1.2 # here", "ambient.density", "1.2", "accepted here: law, viscosity"),
    ("acceleration = 9.81", "acceleration = 9.81\nstiffness = 1 # here", "external.stiffness", "1", "accepted here: law, acceleration"),
    ("speed = 2.0", "speed = 2.0\nmass = 3 # here", "driving.mass", "3", "accepted here: controller, speed, pressure, area, initial_force, force_rate"),
    ("\"rate-limited\"", "\"exact\"", "driving.force_rate", "1e8", "unknown key; accepted here: controller, speed"),
    ("angle = 0.0", "spin = 0.0 # here", "particles[0].spin", "0.0", "accepted here: position, velocity, angle, angular_velocity, radius, density, role"),
    ("strength_factor = 1.0", "strength = 1.0 # here", "bonds[0].strength", "1.0", "accepted here: between, strength_factor, initial_distance, initial_angles"),
    ("initial_angles = [0.1, 0.2]", "initial_angles = [0.1, 0.2]\ninitial_distance = 2e-3 # here", "contacts[0].initial_distance", "2e-3", "accepted here: between, initial_angles"),
    ("interval = 1e-8", "every = 10 # here", "output.every", "10", "accepted here: interval, trajectory, energy"),
    // Keys that are missing.
    ("[time]\nstep = 1e-9", "[time] # here", "time.step", "", MISSING),
    ("[time]\nstep = 1e-9\nend = 1e-7", "[time] # here\nstep = 1e-9", "time.end", "", MISSING),
    ("[time]\nstep = 1e-9\nend = 1e-7\nintegrator = \"velocity-verlet\"", "[time] # here\nstep = 1e-9\nend = 1e-7", "time.integrator", "", "missing; must be one of: euler, symplectic-euler, taylor, velocity-verlet, beeman"),
    ("[time]\nstep = 1e-9\nend = 1e-7\nintegrator = \"velocity-verlet\"", "", "time", "", "missing; a table is needed here"),
    ("[box]\nwidth = 20e-3", "[box] # here", "box.width", "", "missing; a periodic box needs its width"),
    ("[material]\ndensity = 2700.0", "", "material", "", "missing; a table is needed here"),
    ("[material]\ndensity = 2700.0", "[material] # here", "material.density", "", MISSING),
    ("[contact]\ndistance = \"radius\"\n[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 10.0", "[contact] # here", "contact.normal", "", "missing; a table is needed here"),
    ("[contact.normal]\nlaw = \"kelvin-voigt\"", "[contact.normal] # here", "contact.normal.law", "", "missing; must be one of: kelvin-voigt, bshp"),
    ("[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7", "[contact.normal] # here\nlaw = \"kelvin-voigt\"", "contact.normal.stiffness", "", MISSING),
    ("stiffness = 1e7\ndamping = 10.0\n[contact.tangential]\nlaw = \"cundall-strack\"", "stiffness = 1e7\ndamping = 10.0\n[contact.tangential] # here", "contact.tangential.law", "", "missing; must be one of: haff-werner, cundall-strack, cundall-strack-truncated"),
    ("[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.7", "[contact.tangential] # here\nlaw = \"cundall-strack\"", "contact.tangential.friction", "", MISSING),
    ("[bond.normal]\nstiffness = 2e7", "[bond.normal] # here", "bond.normal.stiffness", "", MISSING),
    ("[bond.normal]\nstiffness = 2e7\ndamping = 20.0", "", "bond.normal", "", "missing; a table is needed here"),
    ("[bond.tangential]\nlaw = \"euler-bernoulli\"", "[bond.tangential] # here", "bond.tangential.law", "", "missing; must be one of: euler-bernoulli"),
    ("[bond.yielding]\nlaw = \"zhang-eckert\"", "[bond.yielding] # here", "bond.yielding.law", "", "missing; must be one of: zhang-eckert"),
    ("[bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = 280e6", "[bond.yielding] # here\nlaw = \"zhang-eckert\"", "bond.yielding.normal_strength", "", MISSING),
    ("[ambient]\nlaw = \"creeping\"", "[ambient] # here", "ambient.law", "", "missing; must be one of: creeping, correlation"),
    ("[ambient]\nlaw = \"creeping\"", "[ambient] # here\nlaw = \"correlation\"", "ambient.density", "", MISSING),
    ("[external]\nlaw = \"gravity\"", "[external] # here", "external.law", "", "missing; must be one of: gravity, harmonic-well"),
    ("[external]\nlaw = \"gravity\"\nacceleration = 9.81", "[external] # here\nlaw = \"gravity\"", "external.acceleration", "", MISSING),
    ("[driving]\ncontroller = \"rate-limited\"", "[driving] # here", "driving.controller", "", "missing; must be one of: rate-limited, exact"),
    ("[driving]\ncontroller = \"rate-limited\"\nspeed = 2.0", "[driving] # here\ncontroller = \"rate-limited\"", "driving.speed", "", MISSING),
    ("[[particles]]\nposition = [4e-3, 5e-3]", "[[particles]] # here", "particles[0].position", "", "missing; must be an array of two finite numbers"),
    ("[[particles]]\nposition = [6e-3, 5e-3]\nradius = 1.1e-3", "[[particles]] # here\nposition = [6e-3, 5e-3]", "particles[1].radius", "", MISSING),
    ("[[bonds]]\nbetween = [0, 1]", "[[bonds]] # here", "bonds[0].between", "", "missing; must be an array of two particle indices"),
    ("[[contacts]]\nbetween = [1, 2]", "[[contacts]] # here", "contacts[0].between", "", "missing; must be an array of two particle indices"),
    ("[[contacts]]\nbetween = [1, 2]\ninitial_angles = [0.1, 0.2]", "[[contacts]] # here\nbetween = [1, 2]", "contacts[0].initial_angles", "", "missing; must be an array of two finite numbers"),
    // Values of a wrong type.
    ("title = \"base\"", "title = 5 # here", "title", "5", "must be a text"),
    ("title = \"base\"", "title = 1979-05-27 # here", "title", "1979-05-27", "must be a text"),
    ("[material]\ndensity = 2700.0", "[material]\ndensity = \"2700\" # here", "material.density", "\"2700\"", POSITIVE),
    ("step = 1e-9", "step = true # here", "time.step", "true", POSITIVE),
    ("step = 1e-9", "step = [1e-9] # here", "time.step", "[array of 1]", POSITIVE),
    ("step = 1e-9", "step = { value = 1e-9 } # here", "time.step", "{table}", POSITIVE),
    ("reading = \"corrected\"", "reading = true # here", "reading", "true", "must be one of: corrected, thesis"),
    ("unbreakable_edges = true", "unbreakable_edges = \"yes\" # here", "bond.yielding.unbreakable_edges", "\"yes\"", "must be true or false"),
    ("unbreakable_edges = true", "unbreakable_edges = 1 # here", "bond.yielding.unbreakable_edges", "1", "must be true or false"),
    ("energy = true", "energy = \"all\" # here", "output.energy", "\"all\"", "must be true or false"),
    ("[ambient]\nlaw = \"creeping\"\nviscosity = 18e-6", "[[ambient]] # here\nlaw = \"creeping\"", "ambient", "[array of 1]", "must be a table"),
    ("[[contacts]]\nbetween = [1, 2]", "[contacts] # here\nbetween = [1, 2]", "contacts", "{table}", "must be an array of tables"),
    ("[[contacts]]\nbetween = [1, 2]\ninitial_angles = [0.1, 0.2]", "", "output", "", ""),
    ("position = [4e-3, 5e-3]", "position = 4e-3 # here", "particles[0].position", "4e-3", PAIR),
    ("position = [4e-3, 5e-3]", "position = [4e-3, 5e-3, 0.0] # here", "particles[0].position", "[4e-3, 5e-3, 0.0]", PAIR),
    ("position = [4e-3, 5e-3]", "position = [4e-3, \"y\"] # here", "particles[0].position", "[4e-3, \"y\"]", PAIR),
    ("position = [4e-3, 5e-3]", "position = [nan, 5e-3] # here", "particles[0].position", "[nan, 5e-3]", PAIR),
    ("position = [4e-3, 5e-3]", "position = [4e-3, -inf] # here", "particles[0].position", "[4e-3, -inf]", PAIR),
    ("velocity = [1.0, 0.0]", "velocity = [1.0] # here", "particles[0].velocity", "[1.0]", PAIR),
    ("initial_force = [0.0, 0.0]", "initial_force = [] # here", "driving.initial_force", "[]", PAIR),
    ("between = [0, 1]", "between = [0, 1.0] # here", "bonds[0].between", "[0, 1.0]", INDICES),
    ("between = [0, 1]", "between = [0, -1] # here", "bonds[0].between", "[0, -1]", INDICES),
    ("between = [0, 1]", "between = [0, 1, 2] # here", "bonds[0].between", "[0, 1, 2]", INDICES),
    ("between = [0, 1]", "between = \"0-1\" # here", "bonds[0].between", "\"0-1\"", INDICES),
    ("between = [0, 1]", "between = [0, 99999999999999999999] # here", "bonds[0].between", "[0, 99999999999999999999]", INDICES),
    // Values out of range.
    ("radius = 1.0e-3", "radius = -1.0e-3 # here", "particles[0].radius", "-1.0e-3", POSITIVE),
    ("radius = 1.0e-3", "radius = 0 # here", "particles[0].radius", "0", POSITIVE),
    ("radius = 1.0e-3", "radius = -0.0 # here", "particles[0].radius", "-0.0", POSITIVE),
    ("radius = 1.0e-3", "radius = nan # here", "particles[0].radius", "nan", POSITIVE),
    ("radius = 1.0e-3", "radius = +inf # here", "particles[0].radius", "inf", POSITIVE),
    ("radius = 1.0e-3", "radius = 1e999 # here", "particles[0].radius", "1e999", POSITIVE),
    ("radius = 1.0e-3", "radius = 99999999999999999999 # here", "particles[0].radius", "99999999999999999999", "64 bits"),
    ("radius = 1.0e-3", "radius = 1e-150 # here", "particles[0].radius", "1e-150", "mass"),
    ("radius = 1.0e-3", "radius = 1e150 # here", "particles[0].radius", "1e150", "mass"),
    ("density = 2600.0", "density = 0.0 # here", "particles[0].density", "0.0", POSITIVE),
    ("density = 2600.0", "density = -1 # here", "particles[0].density", "-1", POSITIVE),
    ("density = 2700.0", "density = 0 # here", "material.density", "0", POSITIVE),
    ("density = 2700.0", "density = inf # here", "material.density", "inf", POSITIVE),
    ("angle = 0.0", "angle = nan # here", "particles[0].angle", "nan", FINITE),
    ("angular_velocity = 0.0", "angular_velocity = inf # here", "particles[0].angular_velocity", "inf", FINITE),
    ("step = 1e-9", "step = 0 # here", "time.step", "0", POSITIVE),
    ("step = 1e-9", "step = -1e-9 # here", "time.step", "-1e-9", POSITIVE),
    ("step = 1e-9", "step = nan # here", "time.step", "nan", POSITIVE),
    ("step = 1e-9", "step = 1e-30 # here", "time.step", "1e-30", "must not be below the 1e-15th part of time.end"),
    ("end = 1e-7", "end = -1e-7 # here", "time.end", "-1e-7", NOT_NEGATIVE),
    ("end = 1e-7", "end = inf # here", "time.end", "inf", NOT_NEGATIVE),
    ("width = 20e-3", "width = 0.0 # here", "box.width", "0.0", POSITIVE),
    ("height = 10e-3", "height = -1 # here", "box.height", "-1", POSITIVE),
    ("width = 20e-3", "width = 4.7e-3 # here", "box.width", "4.7e-3", "must be at least two cells wide, 0.0048 m"),
    ("stiffness = 1e7", "stiffness = -1e7 # here", "contact.normal.stiffness", "-1e7", NOT_NEGATIVE),
    ("damping = 10.0", "damping = nan # here", "contact.normal.damping", "nan", NOT_NEGATIVE),
    ("friction = 0.7", "friction = -0.7 # here", "contact.tangential.friction", "-0.7", NOT_NEGATIVE),
    ("law = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 10.0", "law = \"bshp\"\nyoungs_modulus = 1e9\npoissons_ratio = 1.0 # here\ndissipative_constant = 0", "contact.normal.poissons_ratio", "1.0", "must be a number between -1 and 1"),
    ("damping = 20.0", "damping = -20.0 # here", "bond.normal.damping", "-20.0", NOT_NEGATIVE),
    ("stiffness = 3e7", "stiffness = inf # here", "bond.tangential.stiffness", "inf", NOT_NEGATIVE),
    ("normal_strength = 280e6", "normal_strength = 0 # here", "bond.yielding.normal_strength", "0", POSITIVE),
    ("tangential_strength = 168e6", "tangential_strength = -1 # here", "bond.yielding.tangential_strength", "-1", POSITIVE),
    ("viscosity = 18e-6", "viscosity = -18e-6 # here", "ambient.viscosity", "-18e-6", NOT_NEGATIVE),
    ("law = \"creeping\"\nviscosity = 18e-6", "law = \"correlation\"\nviscosity = 0.0 # here\ndensity = 1.2", "ambient.viscosity", "0.0", POSITIVE),
    ("acceleration = 9.81", "acceleration = inf # here", "external.acceleration", "inf", FINITE),
    ("speed = 2.0", "speed = nan # here", "driving.speed", "nan", FINITE),
    ("area = 2e-4", "area = 0.0 # here", "driving.area", "0.0", POSITIVE),
    ("force_rate = 1e8", "force_rate = -1 # here", "driving.force_rate", "-1", NOT_NEGATIVE),
    ("strength_factor = 1.0", "strength_factor = 0.0 # here", "bonds[0].strength_factor", "0.0", POSITIVE),
    ("initial_distance = 2e-3", "initial_distance = -2e-3 # here", "bonds[0].initial_distance", "-2e-3", POSITIVE),
    ("initial_distance = 2e-3", "initial_distance = 1e-320 # here", "bonds[0].initial_distance", "1e-320", ""),
    ("initial_angles = [0.0, 3.14]", "initial_angles = [0.0, inf] # here", "bonds[0].initial_angles", "[0.0, inf]", PAIR),
    ("interval = 1e-8", "interval = 0 # here", "output.interval", "0", POSITIVE),
    ("interval = 1e-8", "interval = -1 # here", "output.interval", "-1", POSITIVE),
    // Names that nobody knows.
    ("\"corrected\"", "\"printed\" # here", "reading", "\"printed\"", "must be one of: corrected, thesis"),
    ("\"corrected\"", "\"Thesis\" # here", "reading", "\"Thesis\"", "must be one of: corrected, thesis"),
    ("\"velocity-verlet\"", "\"rk4\" # here", "time.integrator", "\"rk4\"", "must be one of: euler, symplectic-euler, taylor, velocity-verlet, beeman"),
    ("\"periodic-x\"", "\"periodic\" # here", "box.boundary", "\"periodic\"", "must be one of: open, periodic-x"),
    ("\"radius\"", "\"far\" # here", "contact.distance", "\"far\"", "must be one of: radius, focal, mean"),
    ("\"kelvin-voigt\"", "\"hertz\" # here", "contact.normal.law", "\"hertz\"", "must be one of: kelvin-voigt, bshp"),
    ("\"cundall-strack\"", "\"coulomb\" # here", "contact.tangential.law", "\"coulomb\"", "must be one of: haff-werner, cundall-strack, cundall-strack-truncated"),
    ("\"euler-bernoulli\"", "\"timoshenko\" # here", "bond.tangential.law", "\"timoshenko\"", "must be one of: euler-bernoulli"),
    ("\"zhang-eckert\"", "\"mohr\" # here", "bond.yielding.law", "\"mohr\"", "must be one of: zhang-eckert"),
    ("\"creeping\"", "\"stokes\\u001b[31m\" # here", "ambient.law", "\"stokes\\u{1b}[31m\"", "must be one of: creeping, correlation"),
    ("\"gravity\"", "\"none\" # here", "external.law", "\"none\"", "must be one of: gravity, harmonic-well"),
    ("\"rate-limited\"", "\"pid\" # here", "driving.controller", "\"pid\"", "must be one of: rate-limited, exact"),
    ("\"driven\"", "\"wall\" # here", "particles[1].role", "\"wall\"", "must be one of: free, driven, fixed"),
    ("\"none\"", "\"xyz\" # here", "output.trajectory", "\"xyz\"", "must be one of: none, vtk, extxyz"),
    // What no key alone can tell.
    ("between = [0, 1]", "between = [0, 3] # here", "bonds[0].between", "[0, 3]", "indices go from 0 to 2"),
    ("between = [0, 1]", "between = [1, 1] # here", "bonds[0].between", "[1, 1]", "two different ones are needed"),
    ("[[contacts]]", "[[bonds]]\nbetween = [0, 1] # here\n[[contacts]]", "bonds[1].between", "[0, 1]", "each pair may be listed once"),
    ("[[contacts]]", "[[bonds]]\nbetween = [1, 0] # here\n[[contacts]]", "bonds[1].between", "[1, 0]", "each pair may be listed once"),
    ("[output]", "[[contacts]]\nbetween = [2, 1] # here\ninitial_angles = [0, 0]\n[output]", "contacts[1].between", "[2, 1]", "each pair may be listed once"),
    ("between = [1, 2]", "between = [1, 7] # here", "contacts[0].between", "[1, 7]", "indices go from 0 to 2"),
    ("between = [1, 2]", "between = [2, 0] # here", "contacts[0].between", "[2, 0]", "do not overlap"),
    ("between = [1, 2]", "between = [1, 0] # here", "contacts[0].between", "[1, 0]", "bonded"),
    ("initial_distance = 2e-3", "initial_distance = 10.1e-3 # here", "bonds[0].initial_distance", "10.1e-3", "half"),
    ("boundary = \"periodic-x\"", "", "", "", ""),
    ("role = \"driven\"", "role = \"free\"", "driving", "{table}", "needs a particle whose role is \"driven\""),
    ("velocity = [0.0, 0.0]", "velocity = [0.0, 1.0] # here", "particles[2].velocity", "[0.0, 1.0]", "a fixed particle never moves"),
    ("angular_velocity = 0\n", "angular_velocity = 0.5 # here\n", "particles[2].angular_velocity", "0.5", "a fixed particle never moves"),
    ("[[bonds]]\nbetween = [0, 1]\nstrength_factor = 1.0\ninitial_distance = 2e-3\ninitial_angles = [0.0, 3.14]", "", "bond.yielding", "{table}", "yielding needs bonds"),
    ("title =", "particles_file = \"p.csv\" # here\ntitle =", "particles_file", "\"p.csv\"", "only one of them may be given"),
    ("title =", "bonds_file = \"p.csv\" # here\ntitle =", "bonds_file", "\"p.csv\"", "only one of them may be given"),
    // What is no TOML.
    ("title = \"base\"", "title = \"base # here", "title", "\"base # here", "must be TOML"),
    ("end = 1e-7", "end = 1e-7\nstep = 2e-9 # here", "time.step", "2e-9 # here", "duplicate key"),
    ("radius = 1.1e-3", "radius = 1.1e-3\nradius = 1.3e-3 # here", "particles[1].radius", "1.3e-3 # here", "duplicate key"),
    ("[external]", "[time] # here\n[external]", "", "[time] # here", "must be TOML: duplicate key"),
    ("step = 1e-9", "step = 1e # here", "time.step", "1e # here", "must be TOML"),
    ("step = 1e-9", "step = # here", "time.step", "# here", "must be TOML"),
    ("step = 1e-9", "step 1e-9 # here", "time.step 1e-9 # here", "", "must be TOML"),
    ("step = 1e-9", "step = 0x1p-30 # here", "time.step", "0x1p-30 # here", "must be TOML"),
    ("[material]", "[material # here", "", "[material # here", "must be TOML"),
];

/// Mistakes in the scene with a set-up.
const MADE_EDITS: &[Edit] = &[
    ("seed = 7", "seed = 7\nspeed = 1 # here", "setup.speed", "1", "accepted here: seed, sizes, lattice"),
    ("[setup]\nseed = 7", "[setup] # here", "setup.seed", "", "missing; must be a whole number"),
    ("seed = 7", "seed = -7 # here", "setup.seed", "-7", WHOLE),
    ("seed = 7", "seed = 7.0 # here", "setup.seed", "7.0", WHOLE),
    ("seed = 7", "seed = 0xffffffffffffffffff # here", "setup.seed", "0xffffffffffffffffff", WHOLE),
    ("clip = true", "clip = 1 # here", "setup.clip", "1", "must be true or false"),
    ("[setup.sizes]\nminimum = 0.5e-3\nmaximum = 0.6e-3", "", "setup.sizes", "", "missing; a table is needed here"),
    ("minimum = 0.5e-3", "mean = 1e-3\nminimum = 0.5e-3", "setup.sizes.maximum", "0.6e-3", "accepted here: mean"),
    ("minimum = 0.5e-3", "minimum = 0.0 # here", "setup.sizes.minimum", "0.0", POSITIVE),
    ("maximum = 0.6e-3", "maximum = 0.4e-3 # here", "setup.sizes.maximum", "0.4e-3", "must not be below the minimum"),
    ("maximum = 0.6e-3", "maximum = 2.1e-3", "box.width", "8e-3", "must be at least two cells wide"),
    ("minimum = 0.5e-3", "minimum = 1e-150 # here", "setup.sizes.minimum", "1e-150", "mass"),
    ("minimum = 0.5e-3\nmaximum = 0.6e-3", "mean = 1e200 # here", "setup.sizes.mean", "1e200", "mass"),
    ("[setup.lattice]", "[setup.lattice]\nlayers = 3 # here", "setup.lattice.layers", "3", "accepted here: arrangement, pitch"),
    ("\"square\"", "\"random\" # here", "setup.lattice.arrangement", "\"random\"", "must be one of: square, hexagonal"),
    ("pitch = 1.2e-3", "pitch = -1.2e-3 # here", "setup.lattice.pitch", "-1.2e-3", POSITIVE),
    ("perturbation = 0.0", "perturbation = nan # here", "setup.lattice.perturbation", "nan", NOT_NEGATIVE),
    ("columns = 6", "columns = 0 # here", "setup.lattice.columns", "0", "must be a whole number from 1 to 1000000"),
    ("columns = 6", "columns = 6.5 # here", "setup.lattice.columns", "6.5", WHOLE),
    ("columns = 6", "columns = 99999999999999999999 # here", "setup.lattice.columns", "99999999999999999999", WHOLE),
    ("pitch = 1.2e-3\nperturbation = 0.0\ncolumns = 6", "pitch = 9e-3 # here", "setup.lattice.pitch", "9e-3", "box.width"),
    ("columns = 6\nrows = 6", "columns = 1000000\nrows = 1000000 # here", "setup.lattice.rows", "1000000", "particles"),
    ("rows = 6", "rows = 0 # here", "setup.lattice.rows", "0", "must be a whole number from 1 to 1000000"),
    ("rows = 6", "rows = 6 # here\nfilling = 0.5", "setup.lattice.rows", "6", "exactly one of rows and filling is needed"),
    ("[setup.lattice]\narrangement = \"square\"\npitch = 1.2e-3\nperturbation = 0.0\ncolumns = 6\nrows = 6", "[setup.lattice] # here", "setup.lattice.rows", "", "exactly one of rows and filling is needed"),
    ("rows = 6", "filling = 0.0 # here", "setup.lattice.filling", "0.0", "must be a number between 0 and 4"),
    ("rows = 6", "filling = 5 # here", "setup.lattice.filling", "5", "must be a number between 0 and 4"),
    ("minimum = 0.5e-3\nmaximum = 0.6e-3\n\n[setup.lattice]\narrangement = \"square\"\npitch = 1.2e-3\nperturbation = 0.0\ncolumns = 6\nrows = 6", "minimum = 1e-9\nmaximum = 1e-9\n\n[setup.lattice]\nfilling = 0.9 # here", "setup.lattice.filling", "0.9", "particles"),
    ("columns = 6", "columns = 6\norigin = [0.0] # here", "setup.lattice.origin", "[0.0]", PAIR),
    ("[[setup.settle]]\nduration = 1e-6", "[[setup.settle]]\nspeed = 1.0 # here\nduration = 1e-6", "setup.settle[0].speed", "1.0", "accepted here: duration, step, ambient, external"),
    ("[[setup.settle]]\nduration = 1e-6", "[[setup.settle]]\nduration = -1e-6 # here", "setup.settle[0].duration", "-1e-6", NOT_NEGATIVE),
    ("[[setup.settle]]\nduration = 1e-6", "[[setup.settle]] # here", "setup.settle[0].duration", "", MISSING),
    ("[[setup.settle]]\nduration = 1e-6\nstep = 1e-8", "[[setup.settle]]\nduration = 1e-6\nstep = 0 # here", "setup.settle[0].step", "0", POSITIVE),
    ("[[setup.settle]]\nduration = 1e-6\nstep = 1e-8", "[[setup.settle]]\nduration = 1e300\nstep = 1e-300 # here", "setup.settle[0].step", "1e-300", "must not be below the 1e-15th part of"),
    ("ambient = { law = \"creeping\", viscosity = 1.0 }", "ambient = { law = \"creeping\", viscosity = -1.0 } # here", "setup.settle[0].ambient.viscosity", "-1.0", NOT_NEGATIVE),
    ("ambient = { law = \"creeping\", viscosity = 1.0 }", "ambient = \"creeping\" # here", "setup.settle[0].ambient", "\"creeping\"", "must be a table"),
    ("[[setup.relax]]", "[setup.relax] # here", "setup.relax", "{table}", "must be an array of tables"),
    ("strength_spread = 0.1", "strength_spread = 1.0 # here", "setup.bonding.strength_spread", "1.0", "must be from 0 to below 1"),
    ("strength_spread = 0.1", "strength_spread = -0.1 # here", "setup.bonding.strength_spread", "-0.1", "zero or greater"),
    ("reach = 1.3", "reach = 0 # here", "setup.bonding.reach", "0", POSITIVE),
    ("reach = 1.3", "distance = 1 # here", "setup.bonding.distance", "1", "accepted here: reach, strength_spread"),
    ("[bond.normal]\nstiffness = 1e7\ndamping = 10.0", "", "bond", "", "missing; a scene with bonds needs the laws in [bond]"),
    ("[setup.bonding]\nreach = 1.3\nstrength_spread = 0.1", "", "", "", ""),
    ("jags = 2.0", "jags = -2 # here", "setup.fault.jags", "-2", NOT_NEGATIVE),
    ("jags = 2.0", "width = 2 # here", "setup.fault.width", "2", "accepted here: level, height, jags"),
    ("fixed_below = 1.5e-3", "fixed_below = inf # here", "setup.roles.fixed_below", "inf", FINITE),
    ("fixed_below = 1.5e-3", "free_below = 1.5e-3 # here", "setup.roles.free_below", "1.5e-3", "accepted here: fixed_below, fixed_left_of, driven_above"),
    ("driven_above = 6.0e-3", "", "driving", "{table}", "needs a particle whose role is \"driven\""),
    ("speed = 0.0", "speed = nan # here", "setup.press[0].speed", "nan", FINITE),
    ("[setup]\nseed = 7", "[[bonds]]\nbetween = [0, 1] # here\n[setup]\nseed = 7", "bonds[0].between", "[0, 1]", "cannot be listed in a scene with [setup]"),
    ("height = 8e-3\nboundary = \"periodic-x\"", "", "setup.clip", "true", "needs box.width and box.height"),
    ("width = 8e-3\nheight = 8e-3\nboundary = \"periodic-x\"", "height = 8e-3", "", "", ""),
    ("[driving]", "[external]\nlaw = \"harmonic-well\" # here\nstiffness = 1.0\n[driving]", "", "", ""),
];

/// Mistakes in the scene with files beside it: file, its text, the line, key, value and what is accepted.
type SideEdit = (&'static str, &'static str, usize, &'static str, &'static str, &'static str);

const SIDE_EDITS: &[SideEdit] = &[
    ("p.csv", "x,y\n0,0\n", 1, "radius", "", "missing column; the first line must name: x, y, radius"),
    ("p.csv", "", 1, "x", "", "missing column; the first line must name: x, y, radius"),
    ("p.csv", "x,y,radius,mass\n0,0,1e-3,1\n", 1, "column", "mass", "must be one of the columns: x, y, radius, vx"),
    ("p.csv", "x,y,radius,x\n0,0,1e-3,1\n", 1, "column", "x", "stands twice"),
    ("p.csv", "0.0,0.0,1e-3\n2e-3,0.0,1e-3\n", 1, "column", "0.0", "must be one of the columns"),
    ("p.csv", "x;y;radius\n0;0;1e-3\n", 1, "column", "x;y;radius", "must be one of the columns"),
    ("p.csv", "x,y,radius\n0,0,1e-3\n2e-3,0\n", 3, "", "", "equally long rows"),
    ("p.csv", "x,y,radius\n0,0,1e-3\n2e-3,0,1e-3,4\n", 3, "", "", "equally long rows"),
    ("p.csv", "x,y,radius\n0,0,1e-3\n2e-3,zero,1e-3\n", 3, "y", "zero", FINITE),
    ("p.csv", "x,y,radius\n0,0,1e-3\n\n\n2e-3,zero,1e-3\n", 5, "y", "zero", FINITE),
    ("p.csv", "x,y,radius\r\n0,0,1e-3\r\n2e-3,zero,1e-3\r\n", 3, "y", "zero", FINITE),
    ("p.csv", "x,y,radius\n0,0,1e-3\n2e-3,,1e-3\n", 3, "y", "", FINITE),
    ("p.csv", "x,y,radius\nNaN,0,1e-3\n", 2, "x", "NaN", FINITE),
    ("p.csv", "x,y,radius\n0,inf,1e-3\n", 2, "y", "inf", FINITE),
    ("p.csv", "x,y,radius\n0,0,0\n", 2, "radius", "0", POSITIVE),
    ("p.csv", "x,y,radius\n0,0,-1e-3\n", 2, "radius", "-1e-3", POSITIVE),
    ("p.csv", "x,y,radius\n0,0,1e-150\n", 2, "radius", "1e-150", "mass"),
    ("p.csv", "x,y,radius,density\n0,0,1e-3,0\n", 2, "density", "0", POSITIVE),
    ("p.csv", "x,y,radius,role\n0,0,1e-3,wall\n", 2, "role", "wall", "must be one of: free, driven, fixed"),
    ("p.csv", "x,y,radius,vx,role\n0,0,1e-3,1.0,fixed\n", 2, "vx", "1.0", "a fixed particle never moves"),
    ("b.csv", "i,j\n0,1\n1,0\n", 3, "i,j", "[1, 0]", "each pair may be listed once"),
    ("b.csv", "i,j\n0,3\n", 2, "i,j", "[0, 3]", "indices go from 0 to 2"),
    ("b.csv", "i,j\n0,-1\n", 2, "j", "-1", "must be a particle index, counted from 0"),
    ("b.csv", "i,j\n0,1.5\n", 2, "j", "1.5", "must be a particle index, counted from 0"),
    ("b.csv", "i,j,strength_factor\n0,1,0\n", 2, "strength_factor", "0", POSITIVE),
    ("b.csv", "i,j,initial_distance\n0,1,nan\n", 2, "initial_distance", "nan", POSITIVE),
    ("b.csv", "i,j,initial_angle_i\n0,1,0.1\n", 2, "initial_angle_j", "", FINITE),
    ("c.csv", "i,j\n1,2\n", 1, "initial_angle_i", "", "missing column; the first line must name: i, j, initial_angle_i"),
    ("c.csv", "i,j,initial_angle_i,initial_angle_j\n0,2,0,0\n", 2, "i,j", "[0, 2]", "do not overlap"),
    ("c.csv", "i,j,initial_angle_i,initial_angle_j\n1,2,0,x\n", 2, "initial_angle_j", "x", FINITE),
];

/// Mistakes in the scene with files beside it that are in the scene itself.
const BESIDE_EDITS: &[Edit] = &[
    ("\"p.csv\"", "\"q.csv\" # here", "particles_file", "\"q.csv\"", "must be the name of a readable CSV file"),
    ("\"b.csv\"", "\".\" # here", "bonds_file", "\".\"", "must be the name of a readable CSV file"),
    ("\"c.csv\"", "3 # here", "contacts_file", "3", "must be a text"),
    ("\"p.csv\"", "\"none.csv\" # here", "particles_file", "\"none.csv\"", "no particle"),
    ("particles_file = \"p.csv\"\nbonds_file = \"b.csv\"\ncontacts_file = \"c.csv\"", "", "particles", "", "missing; a scene needs [[particles]], particles_file or [setup]"),
    ("[bond.normal]\nstiffness = 1e7\ndamping = 10.0\n", "", "bond", "", "missing; a scene with bonds needs the laws in [bond]"),
    ("[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 10.0\n", "", "contact", "", "missing; [[contacts]] need the laws in [contact]"),
    ("[material]", "[external]\nlaw = \"harmonic-well\" # here\nstiffness = 1.0\n[material]", "external.law", "\"harmonic-well\"", "box.height is needed"),
    ("[material]", "[box]\nboundary = \"periodic-x\"\n[material]", "box.width", "", "a periodic box needs its width"),
];
