//! Means over sheared packings against those of LMGC90.

use super::cells::{settings, sheared};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    azema,
};
use crate::references::Packing;
use gouge_contact_dynamics::cell::roof_height;
use gouge_contact_dynamics::observables::{
    Connectivity, ContactKind, Network, NetworkSettings, Slab, Sums, point_forces, solid_area,
};
use gouge_contact_dynamics::world::World;

const EQUATIONS: &str = "(4)-(5), (7), (9)-(10)";
const NORM: &str = "Largest difference of a mean over the strain from 1 to 2, at least 1.5 largest diameters away from the walls: q/p, the part of it that side-side contacts carry, solid fraction, contacts per connected body, shares of connected bodies, of side-side and of sliding contacts, and three anisotropies; in units of the standard error of the difference";
const REASON: &str = "Three standard errors, fixed before our runs: if all means are equal, one of ten independent ones is beyond with probability 0.03. Ours are the largest from 20, 10 and 5 blocks, because means of short blocks are correlated. LMGC90's is stored for q/p, follows in the same way from its 50 stored states for the solid fraction, and is taken to be as large as ours for the others, because system and strain are the same";

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.lmgc90.discs",
            claim: "A sheared packing of discs has the mean stress ratio, density, connectivity and anisotropies that LMGC90 finds from the same start state.",
            equations: azema(EQUATIONS),
            scene: "400 discs between rough walls, friction 0.4, inertial number 1e-3, 5e-5 of strain per step up to 2; sweeps end at 3e-3 of the mean impulse, a twentieth of the overlap beyond 0.002 diameters is removed per step",
            oracle: "LMGC90, stored in references/lmgc90/shear",
            norm: NORM,
            origin: Origin::Statistical,
            reason: REASON,
            effort: Effort::Report,
            measure: || compare("discs"),
        },
        Check {
            id: "contact-dynamics.lmgc90.hexagons",
            claim: "A sheared packing of hexagons has the mean stress ratio, density, connectivity and anisotropies that LMGC90 finds from the same start state.",
            equations: azema(EQUATIONS),
            scene: "As for discs, with 400 regular hexagons",
            oracle: "LMGC90, stored in references/lmgc90/shear",
            norm: NORM,
            origin: Origin::Statistical,
            reason: REASON,
            effort: Effort::Report,
            measure: || compare("hexagons"),
        },
    ]
}

/// Number of samples per unit of strain.
const SAMPLES: u64 = 500;
/// Number of blocks of the unit of strain over which means are taken.
const BLOCKS: usize = 20;
/// The largest difference in standard errors.
const MARGIN: f64 = 3.0;

/// Names of the means in the file of LMGC90, in the order of [`Sampled::means`].
const NAMES: [(&str, &str); 10] = [
    ("q_over_p", "q/p"),
    ("q_over_p_side_side", "part of side-side contacts in q/p"),
    ("solid_fraction", "solid fraction"),
    ("coordination", "contacts per connected body"),
    ("fraction_in_network", "share of connected bodies"),
    ("fraction_side_side", "share of side-side contacts"),
    ("fraction_sliding", "share of sliding contacts"),
    ("a_c", "anisotropy of contacts"),
    ("a_fn", "anisotropy of normal forces"),
    ("a_ft", "anisotropy of tangential forces"),
];

/// Sums over some samples.
#[derive(Clone, Copy, Debug, Default)]
struct Sampled {
    sums: Sums,
    connectivity: Connectivity,
    solid: f64,
    area: f64,
}

impl Sampled {
    fn of(world: &World, margin: f64, network: &mut Network) -> Self {
        let (assembly, configuration) = (world.assembly(), &world.state().configuration);
        let settings = world.settings();
        let points = point_forces(
            assembly,
            configuration,
            world.workspace(),
            settings.time_step,
        );
        let bodies = assembly.unit.len();
        network.update(
            points,
            bodies,
            &NetworkSettings::for_friction(settings.law.friction),
        );
        let slab = Slab {
            bottom: margin,
            top: roof_height(world.state()) - margin,
        };
        let area = assembly.domain.width.unwrap_or(0.0) * (slab.top - slab.bottom);
        let mut found = Self {
            solid: solid_area(assembly, configuration, slab),
            area,
            ..Self::default()
        };
        found.sums.add(network, Some(slab), area);
        let is_free = |body: usize| {
            let unit = assembly.unit[body] as usize;
            let is_inside = slab.contains(configuration.position[body].y);
            is_inside && assembly.inverse_mass[unit].rotation > 0.0
        };
        found.connectivity.add(network.counts(), is_free);
        found
    }

    fn add(&mut self, other: &Self) {
        self.sums += other.sums;
        self.connectivity += other.connectivity;
        self.solid += other.solid;
        self.area += other.area;
    }

    fn means(&self) -> [f64; 10] {
        let anisotropies = self.sums.anisotropies();
        [
            self.sums.stress_ratio(),
            self.sums.stress_ratio_of(ContactKind::SideSide),
            self.solid / self.area,
            self.connectivity.coordination(),
            self.connectivity.connected_share(),
            self.sums.share(ContactKind::SideSide),
            self.sums.sliding_share(),
            anisotropies.contacts,
            anisotropies.normal_force,
            anisotropies.tangential_force,
        ]
    }
}

/// What a shear to strain 2 gives: the whole second half, its blocks, and q/p with the strain.
struct Sheared {
    whole: Sampled,
    blocks: Vec<Sampled>,
    curve: Vec<[f64; 2]>,
    largest_overlap: f64,
    sweeps: f64,
}

fn shear(packing: &Packing) -> Result<Sheared, Failure> {
    let mut world = sheared(packing, settings(packing, packing.strain_per_step, 3e-3))?;
    let radii = packing.grains.iter().map(|grain| grain.radius);
    let margin = 1.5 * 2.0 * radii.fold(0.0, f64::max);
    let per_strain = (1.0 / packing.strain_per_step).round() as u64;
    let every = per_strain / SAMPLES;
    let (per_block, per_point) = (SAMPLES as usize / BLOCKS, 20);
    let mut network = Network::new();
    let mut found = Sheared {
        whole: Sampled::default(),
        blocks: vec![Sampled::default(); BLOCKS],
        curve: Vec::new(),
        largest_overlap: 0.0,
        sweeps: 0.0,
    };
    let mut recent = Sampled::default();
    for sample in 1..=2 * SAMPLES as usize {
        for _ in 0..every {
            let report = world.step()?;
            found.largest_overlap = found.largest_overlap.max(report.largest_overlap);
            found.sweeps += report.sweeps.sweeps as f64 / (2 * per_strain) as f64;
        }
        let now = Sampled::of(&world, margin, &mut network);
        recent.add(&now);
        if sample.is_multiple_of(per_point) {
            let strain = (sample as f64 - 0.5 * per_point as f64) / SAMPLES as f64;
            found.curve.push([strain, recent.sums.stress_ratio()]);
            recent = Sampled::default();
        }
        if let Some(after) = sample.checked_sub(SAMPLES as usize + 1) {
            found.blocks[after / per_block].add(&now);
            found.whole.add(&now);
        }
    }
    Ok(found)
}

/// Largest standard error of each mean from 20 blocks, and from the 10 and the 5 blocks that two and four of them make.
fn standard_errors(blocks: &[Sampled]) -> [f64; 10] {
    let mut largest = [0.0_f64; 10];
    for joined in [1, 2, 4] {
        let sum = |some: &[Sampled]| {
            let mut sum = Sampled::default();
            some.iter().for_each(|one| sum.add(one));
            sum.means()
        };
        let means: Vec<[f64; 10]> = blocks.chunks(joined).map(sum).collect();
        for (place, error) in largest.iter_mut().enumerate() {
            *error = error.max(standard_error(means.iter().map(|mean| mean[place])));
        }
    }
    largest
}

/// The same for 50 single states.
fn standard_error_of_states(states: &[f64]) -> f64 {
    let errors = [2, 5, 10].map(|joined| {
        let blocks = states.chunks_exact(joined);
        standard_error(blocks.map(|some| some.iter().sum::<f64>() / joined as f64))
    });
    errors.into_iter().fold(0.0, f64::max)
}

/// Standard error of the mean of independent values.
fn standard_error(values: impl ExactSizeIterator<Item = f64> + Clone) -> f64 {
    let count = values.len() as f64;
    let mean = values.clone().sum::<f64>() / count;
    let squares: f64 = values.map(|value| (value - mean).powi(2)).sum();
    (squares / (count - 1.0) / count).sqrt()
}

fn compare(name: &str) -> Outcome {
    let packing = Packing::read(name).map_err(Failure::Oracle)?;
    let found = shear(&packing)?;
    let (ours, errors) = (found.whole.means(), standard_errors(&found.blocks));
    let mut table = Table::new(
        "Means over the strain from 1 to 2, with their standard errors",
        &[
            "quantity",
            &packing.engine,
            "standard error",
            "this program",
            "standard error",
            "difference in standard errors",
        ],
    );
    let mut all = Vec::new();
    for (place, (key, label)) in NAMES.into_iter().enumerate() {
        let theirs = packing.mean(key).map_err(Failure::Oracle)?;
        let own = errors[place];
        let other = match place {
            0 => packing.standard_error().map_err(Failure::Oracle)?,
            2 => standard_error_of_states(&packing.solid_fractions),
            _ => own,
        };
        let scale = own.hypot(other);
        if scale > 0.0 {
            all.push(Measurement::scaled(theirs, ours[place], scale, MARGIN));
        } else {
            all.push(Measurement::absolute(theirs, ours[place], 0.0));
        }
        let difference = (ours[place] - theirs) / scale.max(f64::MIN_POSITIVE);
        let stored = if [0, 2].contains(&place) {
            ""
        } else {
            " (as ours)"
        };
        table.push([
            label.to_owned(),
            format!("{theirs:.4}"),
            format!("{other:.4}{stored}"),
            format!("{:.4}", ours[place]),
            format!("{own:.4}"),
            format!("{difference:.2}"),
        ]);
    }
    let text = format!(
        "Largest overlap {:.4} mean diameters; {:.1} sweeps per step on average.",
        found.largest_overlap, found.sweeps
    );
    let exhibits = [
        Exhibit::Figure(figure(&packing, &found, name)?),
        Exhibit::Table(table),
        Exhibit::Text(text),
    ];
    Ok(Measurement::worst(all).showing(exhibits))
}

fn figure(packing: &Packing, found: &Sheared, name: &str) -> Result<Figure, Failure> {
    let mean = packing.mean("q_over_p").map_err(Failure::Oracle)?;
    let error = packing.standard_error().map_err(Failure::Oracle)?;
    let band = Curve::line(&packing.engine, [[1.0, mean], [2.0, mean]]);
    let band = band.with_intervals([[mean - MARGIN * error, mean + MARGIN * error]; 2]);
    let stored = packing.series.iter().copied();
    Ok(Figure::new(
        format!(
            "Sheared {name}: q/p of 40 samples each, and the mean of {} with three of its standard errors",
            packing.engine
        ),
        Axis::linear("strain", ""),
        Axis::linear("q/p", ""),
        vec![
            Curve::line(&format!("{}, single states", packing.engine), stored),
            band,
            Curve::marks("this program", found.curve.iter().copied()),
        ],
    ))
}
