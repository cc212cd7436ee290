//! Networks of forces: stress, anisotropies, coordination and solid fraction.

use super::Case;
use super::geometry::{add, centre, domain};
use super::onestep::normal;
use crate::error::Fault;
use crate::fields::Fields;
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::detection::Placed;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::observables::{
    Anisotropies, Connectivity, Contact, ContactKind, MOST_CONTACTS, Network, NetworkSettings,
    PointForce, Slab, Sums, area_in_slab,
};
use gouge_contact_dynamics::shape::Shapes;
use serde_json::{Map, Value, json};

const SV: ContactKind = ContactKind::SideVertex;
const SS: ContactKind = ContactKind::SideSide;

/// The friction of the source, for networks that state none.
const FRICTION: f64 = 0.4;

/// Observables of a network, which is given by `pairs` or by the solution of the problem of its name in `onestep.json`.
pub fn solve(case: &Case) -> Result<Value, Fault> {
    let diameter = case.fields.number_or("mean_diameter", 1.0)?;
    let results = match case.fields.optional("pairs") {
        Some(_) => of_contacts(
            &given(&case.fields)?,
            case.fields.positive("volume")?,
            diameter,
        ),
        None => of_problem(case, &problem(case)?, diameter)?,
    };
    Ok(results.into())
}

/// The problem to which a network refers.
fn problem<'a>(case: &Case<'a>) -> Result<Fields<'a>, Fault> {
    let missing = || Fault::Value {
        key: "network".to_owned(),
        value: format!("{:?}", case.id),
        accepted: "the id of a problem of onestep.json beside it, unless the network has pairs"
            .to_owned(),
    };
    let file = case.others.get("onestep").ok_or_else(missing)?;
    let mut problems = file["problems"].as_array().into_iter().flatten();
    let found = problems.find(|problem| problem["id"] == case.id);
    found.map(Fields::root).ok_or_else(missing)
}

/// Contacts whose normals, components of forces and branch vectors are given.
fn given(fields: &Fields) -> Result<Vec<Contact>, Fault> {
    let friction = match fields.optional("mu") {
        Some(_) => fields.not_negative("mu")?,
        None => FRICTION,
    };
    let settings = NetworkSettings::for_friction(friction);
    let contact = |pair: &Fields| -> Result<Contact, Fault> {
        let (normal, branch) = (normal(pair)?, pair.vector("l")?);
        let [n, t] = pair.array("f")?;
        let force = Components { n, t };
        Ok(Contact {
            first: 0,
            second: 1,
            normal,
            force,
            branch: Components {
                n: normal.dot(branch),
                t: normal.cross(branch),
            },
            height: 0.0,
            kind: if pair.flag("ss")? { SS } else { SV },
            is_sliding: settings.is_sliding(force),
            has_unequal_points: false,
        })
    };
    fields.list("pairs")?.iter().map(contact).collect()
}

fn of_contacts(contacts: &[Contact], volume: f64, diameter: f64) -> Map<String, Value> {
    let mut sums = Sums::new();
    sums.add_contacts(contacts, None, volume);
    let (stress, pressure) = (sums.stress(), sums.stress().mean());
    let results = json!({
        "sigma": [[stress.xx, stress.xy], [stress.yx, stress.yy]],
        "p": pressure,
        "q_over_p": sums.stress_ratio(),
        "theta_s_deg": stress.principal_angle().to_degrees(),
        "antisymmetric_over_p": stress.antisymmetric() / pressure,
        "contacts": contacts.len(),
        "k_ss": sums.share(SS),
        "k_slide": sums.sliding_share(),
        "mean_fn_over_pd": sums.relative_normal_force(diameter),
        "mean_abs_ft_over_pd": sums.relative_friction(diameter),
        "anisotropies": listed(sums.anisotropies()),
        "closure_half_sum": sums.anisotropies().half_sum(),
        "anisotropies_sv": listed(sums.anisotropies_of(SV)),
        "anisotropies_ss": listed(sums.anisotropies_of(SS)),
        "q_sv_over_p": sums.stress_ratio_of(SV),
        "q_ss_over_p": sums.stress_ratio_of(SS),
    });
    match results {
        Value::Object(results) => results,
        _ => Map::new(),
    }
}

fn listed(a: Anisotropies) -> Value {
    json!({
        "a_c": a.contacts,
        "a_fn": a.normal_force,
        "a_ft": a.tangential_force,
        "a_ln": a.normal_branch,
        "a_lt": a.tangential_branch,
    })
}

/// A body of a problem.
struct Grain<'a> {
    fields: Fields<'a>,
    centre: Vec2,
    is_free: bool,
}

fn grains<'a>(problem: &Fields<'a>) -> Result<Vec<Grain<'a>>, Fault> {
    let dofs = problem.list("dofs")?;
    let grain = |body: Fields<'a>| -> Result<Grain<'a>, Fault> {
        let dof = &dofs[body.index("dof", "dofs", dofs.len())?];
        let is_glued = dof.optional("composite").is_some() && dof.flag("composite")?;
        let is_fixed = body.optional("fixed").is_some() && body.flag("fixed")?;
        Ok(Grain {
            centre: centre(&body)?,
            is_free: !is_glued && !is_fixed,
            fields: body,
        })
    };
    problem.list("bodies")?.into_iter().map(grain).collect()
}

fn of_problem(case: &Case, problem: &Fields, diameter: f64) -> Result<Map<String, Value>, Fault> {
    let domain = domain(problem)?;
    let width = problem.positive("period_x")?;
    let grains = grains(problem)?;
    let points = points(problem, &grains, domain)?;
    let mut network = Network::new();
    let settings = NetworkSettings::for_friction(problem.not_negative("mu")?);
    network.update(points.iter().copied(), grains.len(), &settings);
    let glued = grains.iter().filter(|grain| !grain.is_free);
    let top = glued.fold(f64::NEG_INFINITY, |top, grain| top.max(grain.centre.y));
    let volume = match case.fields.optional("volume") {
        Some(volume) => volume.as_number()?,
        None => width * top,
    };
    if !(volume > 0.0 && volume.is_finite()) {
        return Err(problem.refuse("an object with glued bodies, the highest above y = 0"));
    }
    let mut results = of_contacts(network.contacts(), volume, diameter);
    let mut connectivity = Connectivity::new();
    connectivity.add(network.counts(), |body| grains[body].is_free);
    let shares = (2..=MOST_CONTACTS).map(|c| (c.to_string(), connectivity.share_with(c).into()));
    let slab = match case.fields.optional("slab") {
        Some(slab) => slab.as_array()?,
        None => [0.25 * top, 0.75 * top],
    };
    let area = solid_area(
        &grains,
        Slab {
            bottom: slab[0],
            top: slab[1],
        },
    )?;
    let others = [
        ("volume", volume.into()),
        ("kappa", connectivity.connected_share().into()),
        ("z", connectivity.coordination().into()),
        ("P_c", Value::Object(shares.collect())),
        ("sum_point_pairs", points.len().into()),
        ("slab", json!(slab)),
        ("nu_slab", (area / (width * (slab[1] - slab[0]))).into()),
    ];
    results.extend(others.map(|(key, value)| (key.to_owned(), value)));
    Ok(results)
}

/// The points of a problem with the forces of its solution, by pairs.
fn points(problem: &Fields, grains: &[Grain], domain: Domain) -> Result<Vec<PointForce>, Fault> {
    let time_step = problem.positive("dt")?;
    let contacts = problem.list("contacts")?;
    let solution = problem.inside("solution")?;
    let impulses = solution.list_of("impulses", contacts.len())?;
    let mut points = Vec::with_capacity(contacts.len());
    for (contact, impulse) in contacts.iter().zip(&impulses) {
        let body = |key: &str| contact.index(key, "bodies", grains.len());
        let (a, b) = (body("a")?, body("b")?);
        let (place, normal) = (contact.vector("p")?, normal(contact)?);
        let impulse = impulse.as_array::<2>()?;
        let arm = |body: usize| {
            let arm = domain.displacement(grains[body].centre, place);
            Components {
                n: normal.dot(arm),
                t: normal.cross(arm),
            }
        };
        points.push(PointForce {
            first: a as u32,
            second: b as u32,
            normal,
            arms: [arm(a), arm(b)],
            height: place.y,
            force: Components {
                n: impulse[0] / time_step,
                t: impulse[1] / time_step,
            },
        });
    }
    points.sort_by_key(|point| (point.first, point.second));
    Ok(points)
}

fn solid_area(grains: &[Grain], slab: Slab) -> Result<f64, Fault> {
    let mut area = 0.0;
    for grain in grains {
        let mut shapes = Shapes::new();
        let shape = add(&mut shapes, &grain.fields)?;
        let (size, angle) = (grain.fields.positive("R")?, grain.fields.number("th")?);
        let placed = Placed::new(shapes.outline(shape), size, angle);
        area += area_in_slab(&placed, grain.centre.y, slab);
    }
    Ok(area)
}
