//! An estimator of this program's own: the anisotropy of the fabric of a packing while it is sheared.
//!
//! The fabric tensor of the contacts, Phi, is the mean of n n over their unit normals n. Its anisotropy is the difference of
//! its two eigenvalues, a = 2 sqrt(((Phi_xx - Phi_yy) / 2)^2 + Phi_xy^2): 0 if all directions are equally frequent, 1 if
//! all normals are parallel.

use gouge_dem::World;
use gouge_runner::run::{begin_phase, phases};
use gouge_runner::scene::{Overrides, Scene};

/// Anisotropy of the fabric of contacts and bonds, dimensionless; none without contacts.
pub fn anisotropy(world: &World) -> Option<f64> {
    let normals: Vec<_> = world.interactions().iter().map(|one| one.normal).collect();
    let mean = |of: &dyn Fn(f64, f64) -> f64| {
        let sum: f64 = normals.iter().map(|n| of(n.x, n.y)).sum();
        sum / normals.len() as f64
    };
    let difference = mean(&|x, y| x * x - y * y);
    let shear = mean(&|x, y| x * y);
    (!normals.is_empty()).then(|| (difference * difference + 4.0 * shear * shear).sqrt())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let overrides = Overrides::parse(&["setup.seed=7".to_owned()])?;
    let scene = Scene::load_with("pile", &overrides)?;
    // The first phase, which needs no world of an earlier one; the pile has no other.
    let mut world = begin_phase(&scene, &phases(&scene), 0, None)?;
    println!("time in s   contacts   anisotropy");
    for _ in 0..10 {
        for _ in 0..scene.steps() / 10 {
            world.step()?;
        }
        if let Some(anisotropy) = anisotropy(&world) {
            let (time, contacts) = (world.time(), world.number_of_contacts());
            println!("{time:9.2}{contacts:11}{anisotropy:13.3}");
        }
    }
    Ok(())
}
