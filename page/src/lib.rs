//! Figures as SVG and self-contained HTML pages.
//!
//! A [`Figure`] has two [`Axis`] and some [`Curve`]s. It becomes part of a page ([`Figure::html`]) or
//! a file of its own ([`Figure::write_svg`]). [`page`] puts the body of a page between head and style
//! sheet. A page needs no other file and no script.
//!
//! Curves of one figure differ in colour and also in dashes or shape of mark, so that they can be told
//! apart in print and with colour blindness.
//!
//! ```
//! use gouge_page::{Axis, Curve, Figure, Guide};
//!
//! let wave = (0..100).map(|i| [1e-5 * f64::from(i), (0.1 * f64::from(i)).sin()]);
//! let figure = Figure::new(
//!     "The velocity changes its sign.",
//!     Axis::linear("time", "s"),
//!     Axis::linear("velocity", "m/s"),
//!     vec![Curve::line("grain 0", wave)],
//! )
//! .with_guide(Guide::horizontal("rest", 0.0));
//! let page = gouge_page::page("A wave", figure.html()).into_string();
//! assert!(page.contains("time (10⁻³ s)"));
//! ```

mod axis;
mod curve;
mod draw;
mod figure;
mod legend;
mod look;
mod scale;
mod skeleton;
mod strokes;
mod thin;

pub use axis::Axis;
pub use curve::{Curve, Style};
pub use figure::{Figure, Guide};
pub use skeleton::{page, styled_page, table};
