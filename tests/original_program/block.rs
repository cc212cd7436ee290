//! A sheared block.

use super::{BLOCK_GROWTH, BOX, EACH_RUBBING, RULES, STRENGTH, Twins, check, grain, replay};
use gouge_validation::oracles::original::{Driver, Duty, Original, Rubbing, Rules};
use rand::RngExt;
use rand_pcg::Pcg32;
use std::f64::consts::TAU;

/// Height of the lattice of the block in m: as many hexagonal rows as columns.
const HEIGHT: f64 = BOX * 0.866;

/// A small block of granite, cut by a jagged fault, pressed and sheared.
fn block(rubbing: Rubbing, viscosity: Option<f64>, seed: u64) -> Original {
    const ROWS: usize = 13;
    let mut random = Pcg32::new(seed, 1);
    let mut uniform = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let mut grains = Vec::new();
    for place in 0..ROWS * ROWS {
        let (column, row) = ((place % ROWS) as f64, (place / ROWS) as f64);
        let column = column + if row % 2.0 == 0.0 { 0.25 } else { 0.75 };
        let lattice = [
            BOX * column / ROWS as f64,
            HEIGHT * (row + 0.5) / ROWS as f64,
        ];
        let x = lattice.map(|x| x + uniform(-1e-4, 1e-4));
        let mut new = grain(x, uniform(0.82843e-3, 1.17157e-3));
        new.duty = match x[1] {
            y if y < 4e-3 => Duty::Fixed,
            y if y > HEIGHT - 4e-3 => Duty::Driven,
            _ => Duty::Free,
        };
        new.phi = uniform(-9.0, 9.0);
        if new.duty != Duty::Fixed {
            new.v = [uniform(-60.0, 60.0), uniform(-60.0, 60.0)];
            new.omega = uniform(-2e4, 2e4);
        }
        grains.push(new);
    }
    let driver = Some(Driver {
        speed: 2.0,
        load: 28e6 * BOX * 2e-3,
        rate: 1e8,
    });
    let (period, strength) = (Some(BOX), Some(STRENGTH));
    let mut block = Original::new(
        Rules {
            rubbing,
            viscosity,
            period,
            strength,
            driver,
            ..RULES
        },
        grains,
    );
    block.drive = [200.0, -1300.0];
    bond_halves(&mut block, || uniform(0.9, 1.1));
    block
}

fn bond_halves(block: &mut Original, mut factor: impl FnMut() -> f64) {
    let above = |[x, y]: [f64; 2]| y > 0.5 * HEIGHT + 1e-3 * (2.0 * TAU * x / BOX).sin();
    let number = block.grains.len();
    for (i, j) in (0..number).flat_map(|i| (i + 1..number).map(move |j| (i, j))) {
        let (a, b) = (block.grains[i], block.grains[j]);
        let apart = block.apart((i, j));
        let is_near = apart[0].hypot(apart[1]) <= 1.2247 * (a.r + b.r);
        if is_near && above(a.x) == above(b.x) {
            block.bond((i, j), factor());
        }
    }
}

#[test]
fn a_sheared_block_follows_the_original_program() {
    for rubbing in EACH_RUBBING {
        for viscosity in [None, Some(1.0)] {
            let twins = Twins::new(block(rubbing, viscosity, 7), viscosity.is_some());
            let bonds = twins.oracle.bonds.len();
            let run = replay(twins, 1000);
            let left = run.twins.oracle.bonds.len();
            let name = format!("block, {rubbing:?}, viscosity {viscosity:?}");
            assert!(
                left < bonds && left > bonds / 2,
                "{name}: {left} of {bonds} bonds left"
            );
            println!(
                "{bonds} bonds initially, {} became contacts",
                run.broken_into_contact
            );
            check(&name, &run, BLOCK_GROWTH);
        }
    }
}
