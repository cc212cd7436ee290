//! Scenes for checks, tests and measurements, put together as tables instead of text.
//!
//! A [`Draft`] is a scene under construction: laws, grains and bonds are added by methods that know the
//! keys of the scene format, and any other key by its dotted name. Events that several files use are
//! functions of [`events`], [`packing`] and [`fault`].
//!
//! ```
//! use gouge_dem::integrators::Integrator;
//! use gouge_dem::laws::KelvinVoigt;
//! use gouge_validation::scenes::{Draft, Grain};
//!
//! let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
//!     .law(KelvinVoigt { stiffness: 1e7, damping: 10.0 })
//!     .grain(Grain::at([-1e-3, 0.0], 1e-3).moving([0.5, 0.0]))
//!     .grain(Grain::at([1e-3, 0.0], 1e-3).moving([-0.5, 0.0]));
//! let world = draft.world()?;
//! assert_eq!(world.particles().len(), 2);
//! assert!(draft.replacing("time.stop", 1.0).scene().is_err());
//! # Ok::<(), gouge_validation::scenes::Mistake>(())
//! ```

mod draft;
pub mod events;
pub mod fault;
mod grain;
mod keys;
mod laws;
pub mod packing;

pub use draft::{Draft, Method, Mistake};
pub use grain::{Bond, Grain};
pub use laws::Law;
