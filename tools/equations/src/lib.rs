//! Typeset formulas for rustdoc, prepared at compile time.
//!
//! The attribute [`macro@rendered`] looks for TeX in the documentation comments of an item and of
//! everything inside it, and replaces it by MathML. Browsers draw MathML by themselves, so the
//! pages need neither scripts nor a network.
//!
//! | Source                    | Result                                   |
//! |---------------------------|------------------------------------------|
//! | one dollar on each side   | a formula within the sentence            |
//! | two dollars on each side  | a formula on a line of its own           |
//! | `\$`                      | a dollar sign                            |
//! | dollars in code           | unchanged, in spans and in fenced blocks |
//!
//! A formula begins and ends on the same line of the comment.
//!
//! ```
//! /// The weight $ w = m g $ of a body, with
//! /// $$ g \approx 9.81 \, \tfrac{\mathrm{m}}{\mathrm{s}^2} $$
//! #[gouge_equations::rendered]
//! pub struct Weight {
//!     /// The mass $ m > 0 $
//!     pub mass: f64,
//! }
//! ```

mod fence;
mod line;
mod mathml;
mod walk;

use proc_macro::TokenStream;
use quote::quote;

/// Replaces the formulas in all documentation of the annotated item.
///
/// Fields, variants, methods and items of an inline module are reached from the outermost item, so
/// one attribute suffices. Everything except the documentation stays as written. A formula that
/// cannot be converted, or that is never closed, is a compile error at its comment.
#[proc_macro_attribute]
pub fn rendered(arguments: TokenStream, item: TokenStream) -> TokenStream {
    if arguments.is_empty() {
        return walk::render(item.into()).into();
    }
    let refusal = TokenStream::from(quote!(
        ::core::compile_error! { "`rendered` has no arguments" }
    ));
    [item, refusal].into_iter().collect()
}
