//! The kernel of rigid discs and convex polygons by contact dynamics.
//!
//! Bodies are rigid; contacts are unilateral (Signorini) with Coulomb friction, and are solved as impulses of a whole
//! time step. Source: E. Azéma, N. Estrada and F. Radjai, *Nonlinear effects of particle shape angularity in sheared
//! granular media*, Phys. Rev. E 86, 041301 (2012), cited as azema (A18).
//!
//! In order of dependency, and each module uses only modules listed above it. All quantities are in SI units; masses
//! and forces are per metre of depth. The tangent is the normal turned by +90 degrees.

pub mod error;
pub mod shape;
pub mod detection;
pub mod local;
pub mod units;
pub mod delassus;
pub mod law;
pub mod sweep;
pub mod assembly;
pub mod warm_start;
pub mod step;
pub mod work;
pub mod cell;
pub mod preparation;
pub mod world;
pub mod record;
pub mod observables;
