//! Sheared packings of LMGC90, stored in `references/lmgc90`: start states and results.

use crate::stored::{Table, number, read, text};
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::assembly::{Assembly, Body};
use gouge_contact_dynamics::detection::HalfPlane;
use gouge_contact_dynamics::law::ContactLaw;
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::step::{Scheme, State, StepSettings, Workspace, step};
use gouge_contact_dynamics::units::{InverseMass, Velocity};

const FOLDER: &str = "lmgc90/shear";

/// A packing between a fixed lower wall and an upper wall, units 0 and 1.
pub struct Packing {
    pub assembly: Assembly,
    pub state: State,
    pub width: f64,
    pub height: f64,
}

impl Packing {
    /// The start state with a name of `result.json`; mean diameter, density and normal stress are one.
    pub fn read(name: &str) -> Self {
        let result = read(&format!("{FOLDER}/result.json"));
        let packing = &result["packings"][name];
        let (width, height) = (
            number(&result["settings"], "width"),
            number(packing, "height"),
        );
        let domain = Domain {
            width: Some(width),
            height: None,
            periodic: true,
        };
        let mut found = Self {
            assembly: Assembly::new(domain, Shapes::new()),
            state: State::default(),
            width,
            height,
        };
        found.add_walls(number(packing, "inverse_wall_mass"));
        let file = packing["file"].as_str().unwrap();
        for line in text(&format!("{FOLDER}/{file}")).lines().skip(1) {
            found.add_grain(line);
        }
        found
    }

    fn add_walls(&mut self, inverse_wall_mass: f64) {
        let driven = InverseMass {
            y: inverse_wall_mass,
            ..InverseMass::IMPOSED
        };
        let walls = [
            (InverseMass::IMPOSED, 0.0, 1.0),
            (driven, self.height, -1.0),
        ];
        let (assembly, configuration) = (&mut self.assembly, &mut self.state.configuration);
        for (mass, y, normal) in walls {
            let unit = assembly.add_unit(configuration, mass, Velocity::default());
            let wall = HalfPlane {
                position: Vec2::new(0.0, y),
                normal: Vec2::new(0.0, normal),
            };
            let unit = unit.unwrap();
            assembly.add_wall(configuration, wall, unit).unwrap();
        }
        assembly.load[1].force = Vec2::new(0.0, -self.width);
    }

    fn add_grain(&mut self, line: &str) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |place: usize| cells[place].parse::<f64>().unwrap();
        let (assembly, configuration) = (&mut self.assembly, &mut self.state.configuration);
        let shape = match cells[0] {
            "0" => assembly.shapes.add_disc(),
            sides => assembly.shapes.add_regular(sides.parse().unwrap()).unwrap(),
        };
        let body = Body {
            shape,
            scale: number(1),
            position: Vec2::new(number(2), number(3)),
            angle: number(4),
        };
        match cells[5] {
            "free" => assembly
                .add_free(configuration, body, 1.0, Velocity::default())
                .map(drop),
            "bottom" => assembly.add_body(configuration, body, 0).map(drop),
            _ => assembly.add_body(configuration, body, 1).map(drop),
        }
        .unwrap();
    }
}

/// The packings are compacted: grains touch without overlaps, and they carry the load at once, so that the first step
/// has about as many contact points as the engine had at the beginning.
#[test]
fn the_start_states_are_compacted() {
    let result = read(&format!("{FOLDER}/result.json"));
    for run in result["runs"].as_array().unwrap() {
        let name = run["name"].as_str().unwrap();
        let mut packing = Packing::read(name);
        let settings = StepSettings {
            time_step: number(run, "strain_per_step") / number(run, "inertial_number"),
            scheme: Scheme::Midpoint,
            detection: gouge_contact_dynamics::detection::DetectionSettings::for_diameter(1.0),
            law: ContactLaw::inelastic(number(&result["settings"], "friction")),
            sweeps: gouge_contact_dynamics::sweep::SweepSettings::default(),
            warm_start_distance: 0.3,
        };
        let mut workspace = Workspace::new(&packing.assembly, &packing.state, &settings);
        let report = step(
            &packing.assembly,
            &settings,
            &mut packing.state,
            &mut workspace,
        );
        assert!(
            report.largest_overlap < 0.002,
            "{name}: {}",
            report.largest_overlap
        );
        let series = Table::new(&run["series"]);
        let ratio = report.points as f64 / series.cell(0, "points");
        // The engine counted after some 40 steps, during which a tenth of the candidates come and go.
        assert!((0.8..1.25).contains(&ratio), "{name}: {ratio}");
        let fall = packing.height - packing.state.configuration.wall[1].position.y;
        assert!(fall.abs() < 1e-3, "{name}: {fall}");
    }
}

/// The parts of the stress ratio by contact type add up to the whole, and so do the contact numbers of grains.
#[test]
fn the_results_are_consistent() {
    let result = read(&format!("{FOLDER}/result.json"));
    for run in result["runs"].as_array().unwrap() {
        let averaged = &run["averaged"];
        let mean = |name| number(&averaged["means"], name);
        let parts = mean("q_over_p_side_side") + mean("q_over_p_side_vertex");
        assert!((parts - mean("q_over_p")).abs() < 1e-12);
        let fractions = averaged["fractions_by_contacts"].as_array().unwrap();
        let sum: f64 = fractions.iter().map(|x| x.as_f64().unwrap()).sum();
        assert!((sum - 1.0).abs() < 1e-9, "{sum}");
        let average: f64 = fractions
            .iter()
            .zip(2..)
            .map(|(x, contacts)| x.as_f64().unwrap() * f64::from(contacts))
            .sum();
        assert!((average - mean("coordination")).abs() < 1e-9, "{average}");
    }
}
