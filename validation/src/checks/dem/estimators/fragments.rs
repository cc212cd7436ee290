//! Fragments.

use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Measurement, Origin, Outcome, thesis};
use crate::oracles::components::first_nodes;
use crate::scenes::{Bond, Draft, Grain};
use gouge_common::estimators::{Fragments, connected};
use gouge_dem::estimators::fragments;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, ZhangEckert};
use rand::RngExt;
use rand_pcg::Pcg64;

pub fn checks() -> Vec<Check> {
    vec![graphs(), broken()]
}

/// Number of nodes whose label differs from the oracle's, plus one if the number of fragments differs.
fn differences(found: &Fragments, edges: &[(usize, usize)]) -> usize {
    let first = first_nodes(found.label.len(), edges);
    let mut labels = Vec::new();
    for (node, &start) in first.iter().enumerate() {
        let next = first[..node]
            .iter()
            .enumerate()
            .filter(|(k, f)| k == *f)
            .count();
        labels.push(if start == node { next } else { labels[start] });
    }
    let number = first.iter().enumerate().filter(|(k, f)| k == *f).count();
    let wrong = labels.iter().zip(&found.label).filter(|(a, b)| a != b);
    wrong.count() + usize::from(number != found.number)
}

fn graphs() -> Check {
    Check {
        id: "estimators.fragments.graphs",
        claim: "Fragments are the connected components of a graph, numbered in the order of their first members.",
        equations: thesis("(46)"),
        scene: "300 random graphs of up to 60 nodes, with edges in random order, repeated edges and loops",
        oracle: "Flood fill from each node in turn",
        norm: "Number of nodes with another label, plus number of wrong fragment counts",
        origin: Origin::Exact,
        reason: "The count must be exact",
        effort: Effort::Quick,
        measure: measure_graphs,
    }
}

fn measure_graphs() -> Outcome {
    let mut random = Pcg64::new(3, 141);
    let mut wrong = 0;
    for round in 0..300 {
        let nodes = random.random_range(1..=60);
        let edges: Vec<(usize, usize)> = (0..random.random_range(0..=nodes))
            .map(|_| (random.random_range(0..nodes), random.random_range(0..nodes)))
            .collect();
        // In some rounds the graph has no edges.
        let edges = if round % 50 == 0 { &[][..] } else { &edges[..] };
        wrong += differences(&connected(nodes, edges.iter().copied()), edges);
    }
    Ok(Measurement::count(wrong).into())
}

fn broken() -> Check {
    Check {
        id: "estimators.fragments.broken",
        claim: "A chain whose overstretched bonds break splits into the pieces between them.",
        equations: thesis("(46)-(48)"),
        scene: "40 grains bonded in a row; bonds 7, 19, 20 and 33 are stretched beyond the strength of 280 MPa, the others are not; one step",
        oracle: "Flood fill of the chain without those four bonds",
        norm: "Number of grains in another fragment, plus number of wrong counts of fragments and of remaining bonds",
        origin: Origin::Exact,
        reason: "The count must be exact",
        effort: Effort::Quick,
        measure: measure_broken,
    }
}

fn measure_broken() -> Outcome {
    const BROKEN: [usize; 4] = [7, 19, 20, 33];
    // The strength allows an extension of 280 MPa times pi mm^2 over 1e7 kg/s^2, 88 um.
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .law(ZhangEckert {
            normal_strength: 280e6,
            tangential_strength: 168e6,
        });
    let mut x = 0.0;
    for i in 0..40 {
        draft = draft.grain(Grain::at([x, 0.0], 1e-3));
        x += if BROKEN.contains(&i) { 2.1e-3 } else { 2.05e-3 };
    }
    for i in 0..39 {
        draft = draft.bond(Bond::between(i, i + 1).of_length(2e-3));
    }
    let mut world = draft.world()?;
    advance(&mut world, 1)?;
    let edges: Vec<(usize, usize)> = (0..39)
        .filter(|i| !BROKEN.contains(i))
        .map(|i| (i, i + 1))
        .collect();
    let left = world.bonds().map_or(0, |strong| strong.len());
    let wrong = differences(&fragments(world.state()), &edges) + usize::from(left != edges.len());
    Ok(Measurement::count(wrong).into())
}
