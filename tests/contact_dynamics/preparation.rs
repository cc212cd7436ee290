//! Samples before they are sheared: sizes, deposition, compaction, glued layers.

use crate::cells::{compacted, random};
use core::f64::consts::FRAC_PI_4;
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::cell::{LOWER, UPPER};
use gouge_contact_dynamics::preparation::{DiameterRange, deposit, draw_diameters, glue};

/// The definition of the distribution, by the midpoint rule over its quantiles: the mean, and equal areas in equal
/// intervals of the diameter.
#[test]
fn diameters_are_uniform_by_volume() {
    for ratio in [1.0, 1.5, 4.0, 20.0] {
        let range = DiameterRange::with_mean(0.3, ratio).unwrap();
        assert!((range.maximum / range.minimum - ratio).abs() < 1e-12 * ratio);
        let number = 200_000;
        let all: Vec<f64> = (0..number)
            .map(|k| range.quantile((f64::from(k) + 0.5) / f64::from(number)))
            .collect();
        let mean = all.iter().sum::<f64>() / f64::from(number);
        assert!((mean / 0.3 - 1.0).abs() < 1e-8, "{ratio}: {mean}");
        assert!((range.mean() / mean - 1.0).abs() < 1e-8);
        let area = |from: f64, to: f64| -> f64 {
            let within = all.iter().filter(|&&d| d >= from && d < to);
            within.map(|d| d * d).sum()
        };
        if ratio > 1.0 {
            let width = (range.maximum - range.minimum) / 5.0;
            let from = |k: u8| range.minimum + f64::from(k) * width;
            let areas: Vec<f64> = (0..5).map(|k| area(from(k), from(k + 1))).collect();
            let fifth = areas.iter().sum::<f64>() / 5.0;
            assert!(
                areas.iter().all(|a| (a / fifth - 1.0).abs() < 1e-3),
                "{areas:?}"
            );
        }
    }
}

/// The printed range is 0.6 to 2.4, but the mean of its distribution is 1.109 and not 1.
#[test]
fn the_printed_range_does_not_have_the_printed_mean() {
    let range = DiameterRange::printed(1.0).unwrap();
    assert!((range.mean() - 0.8 * 4.0f64.ln()).abs() < 1e-12);
    let corrected = DiameterRange::with_mean(1.0, 4.0).unwrap();
    assert!((corrected.minimum - 0.75 / 4.0f64.ln()).abs() < 1e-12);
}

#[test]
fn impossible_samples_are_refused() {
    assert!(DiameterRange::with_mean(0.0, 4.0).is_err());
    assert!(DiameterRange::with_mean(1.0, 0.9).is_err());
    assert!(DiameterRange::with_mean(1.0, f64::NAN).is_err());
    assert!(DiameterRange::printed(-1.0).is_err());
    assert!(deposit(&[1.0, 1.0], 3.9).is_err());
    assert!(deposit(&[1.0, -1.0], 9.0).is_err());
    assert!(deposit(&[], 9.0).is_ok());
    let cell = compacted(Some(6), 60, 1);
    assert!(glue(&cell, -1.0, 1.0).is_err());
}

/// Distance of two circles in a box that is periodic in x.
fn gap(centres: &[Vec2], radii: &[f64], width: f64, i: usize, j: usize) -> f64 {
    let d = centres[j] - centres[i];
    let x = d.x - width * (d.x / width).round();
    x.hypot(d.y) - radii[i] - radii[j]
}

#[test]
fn deposited_discs_touch_two_others_and_overlap_none() {
    let (width, number) = (20.0, 600);
    let range = DiameterRange::with_mean(1.0, 4.0).unwrap();
    let diameters = draw_diameters(range, number, random(3));
    let deposited = deposit(&diameters, width).unwrap();
    let radii: Vec<f64> = diameters.iter().map(|d| 0.5 * d).collect();
    let centres = &deposited.centres;
    let mut top: f64 = 0.0;
    for i in 0..number {
        assert!((0.0..width).contains(&centres[i].x));
        let gaps: Vec<f64> = (0..i).map(|j| gap(centres, &radii, width, i, j)).collect();
        assert!(gaps.iter().all(|&g| g > -1e-8));
        let floor = centres[i].y - radii[i];
        assert!(floor > -1e-9);
        let touching = gaps.iter().chain([&floor]).filter(|g| g.abs() < 1e-8);
        assert!(i == 0 || touching.count() >= 2, "disc {i}");
        top = top.max(centres[i].y + radii[i]);
    }
    assert!((deposited.height - top).abs() < 1e-12);
    let area: f64 = diameters.iter().map(|d| FRAC_PI_4 * d * d).sum();
    let fraction = area / (width * top);
    assert!((0.79..0.83).contains(&fraction), "{fraction}");
}

/// Every free place that touches two earlier discs, or the floor and a disc, found by trying all pairs.
#[test]
fn no_free_place_is_lower() {
    let (width, number) = (10.0, 40);
    let range = DiameterRange::with_mean(1.0, 4.0).unwrap();
    let diameters = draw_diameters(range, number, random(8));
    let centres = deposit(&diameters, width).unwrap().centres;
    for last in 1..number {
        let radius = 0.5 * diameters[last];
        let reach = |i: usize| 0.5 * diameters[i] + radius;
        let is_free = |p: &Vec2| {
            let far = |k: usize| {
                let d = *p - centres[k];
                (d.x - width * (d.x / width).round()).hypot(d.y) > reach(k) - 1e-8
            };
            p.y > radius - 1e-9 && (0..last).all(far)
        };
        let on_floor = (0..last).flat_map(|i| {
            let rise = centres[i].y - radius;
            let half_chord = (reach(i).powi(2) - rise.powi(2)).sqrt();
            [-half_chord, half_chord].map(|x| Vec2::new(centres[i].x + x, radius))
        });
        let pairs = (0..last).flat_map(|i| (0..i).map(move |j| (i, j)));
        let on_two = pairs.flat_map(|(i, j)| {
            let images = [-width, 0.0, width].map(|x| centres[j] + Vec2::new(x, 0.0));
            let both = |side| {
                images.map(|image| touching_both(centres[i], reach(i), image, reach(j), side))
            };
            both(-1.0).into_iter().chain(both(1.0)).collect::<Vec<_>>()
        });
        let free = on_floor.chain(on_two).filter(is_free);
        let lowest = free.map(|p| p.y).fold(f64::INFINITY, f64::min);
        assert!((centres[last].y - lowest).abs() < 1e-7, "disc {last}");
    }
}

/// The corner of a triangle over two centres with given sides; not a number if there is none.
fn touching_both(one: Vec2, a: f64, other: Vec2, b: f64, side: f64) -> Vec2 {
    let d = other - one;
    let distance = d.norm();
    let cosine = (a * a + distance * distance - b * b) / (2.0 * a * distance);
    let angle = d.y.atan2(d.x) + side * cosine.acos();
    one + Vec2::new(a * angle.cos(), a * angle.sin())
}

#[test]
fn a_compacted_packing_bears_the_load() {
    for sides in [None, Some(3)] {
        let cell = compacted(sides, 150, 5);
        let area: f64 = (0..150).map(|body| cell.assembly.area(body)).sum();
        let fraction = area / (cell.width() * cell.height());
        assert!((0.75..0.88).contains(&fraction), "{sides:?}: {fraction}");
        let roof = cell.state.configuration.velocity[UPPER as usize].linear;
        assert!(roof.x == 0.0 && roof.y.abs() < 1e-3, "{roof:?}");
        let bodies = cell.assembly.shape.len() as u32;
        let force: f64 = cell
            .state
            .memory
            .iter()
            .filter(|(key, _)| key.pair.j == bodies + UPPER)
            .map(|(_, impulse)| impulse.n / 0.05)
            .sum();
        assert!((force / cell.width() - 1.0).abs() < 0.05, "{force}");
    }
}

#[test]
fn glued_bodies_are_those_near_a_wall() {
    let cell = compacted(Some(5), 150, 5);
    let glued = glue(&cell, 0.03, 2.0).unwrap();
    let (assembly, configuration) = (&glued.assembly, &glued.state.configuration);
    let mut mass_of_roof = 0.0;
    for body in 0..150 {
        let r = configuration.position[body];
        // The corners themselves.
        let corners = (0..5).map(|k| {
            let angle = configuration.angle[body] + f64::from(k) * core::f64::consts::TAU / 5.0;
            r.y + assembly.scale[body] * angle.sin()
        });
        let (low, high) = corners.fold((f64::MAX, f64::MIN), |(low, high), y| {
            (low.min(y), high.max(y))
        });
        let owner = assembly.unit[body];
        assert_eq!(owner == LOWER, low <= 0.03, "{low}");
        assert_eq!(owner == UPPER, high >= glued.height() - 0.03, "{high}");
        if owner == UPPER {
            let radius = assembly.scale[body];
            mass_of_roof += 2.0 * 2.5 * radius * radius * (0.4 * core::f64::consts::PI).sin();
        }
    }
    let inverse = assembly.inverse_mass[UPPER as usize];
    assert!((inverse.y * mass_of_roof - 1.0).abs() < 1e-12);
    assert!(inverse.x == 0.0 && inverse.rotation == 0.0);
    assert!(glued.state.memory.is_empty());
    assert!(glue(&cell, -0.5, 2.0).is_err(), "nothing is that near");
}
