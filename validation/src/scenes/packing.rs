//! Packings, made as the built-in granite fault makes them.

use super::draft::Draft;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;

/// Grains of a mean radius of 1 mm that settle in a harmonic well, in a periodic square box of a side in m: the
/// protocol of the small granite fault up to its bonds, with a seed.
pub fn settled(side: f64, seed: u64) -> Draft {
    let settling = |stiffness: f64| {
        Draft::empty()
            .with("duration", 1e-3)
            .with("step", 100e-9)
            .creeping_drag(10.0)
            .harmonic_well(stiffness)
    };
    Draft::open_box(Integrator::VelocityVerlet, 1e-8)
        .with("box.width", side)
        .with("box.height", side)
        .with("box.boundary", "periodic-x")
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .with("setup.seed", seed as i64)
        .with("setup.clip", true)
        .with("setup.sizes.mean", 1e-3)
        .with("setup.lattice.perturbation", 0.05e-3)
        .with("setup.lattice.filling", 0.9069)
        .adding("setup.settle", &settling(4e3))
        .adding("setup.settle", &settling(4e2))
}
