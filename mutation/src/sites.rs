//! Where the kernel's formulas hold a number: literals, constants and coefficients.

use proc_macro2::Span;
use std::collections::BTreeSet;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, BinOp, Expr, ExprField, Item, Lit, Member, Meta};

/// Parameters of laws, of distributions and of set-ups, as fields of `self` or of another value.
const COEFFICIENTS: &[&str] = &[
    "acceleration",
    "area",
    "centre",
    "constant",
    "damping",
    "density",
    "dissipative_constant",
    "exponent",
    "force_rate",
    "friction",
    "height",
    "high",
    "jags",
    "length",
    "level",
    "location",
    "low",
    "maximum",
    "minimum",
    "normal_strength",
    "peak",
    "peak_time",
    "pitch",
    "poissons_ratio",
    "pressure",
    "rate",
    "residual",
    "scale",
    "shape",
    "speed",
    "stiffness",
    "tangential_strength",
    "viscosity",
    "width",
    "youngs_modulus",
];

/// Columns of particle data that enter laws and integrators.
const COLUMNS: &[&str] = &[
    "inverse_inertia",
    "inverse_mass",
    "mass",
    "moment_of_inertia",
    "radius",
];

/// Constants of the standard library that stand in formulas.
const STANDARD: &[&str] = &["PI", "SQRT_2", "TAU"];

/// A number in a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// Line, counted from one.
    pub line: usize,
    /// Bytes of the expression in its file.
    pub bytes: Range<usize>,
    /// The expression.
    pub text: String,
}

/// Names of the `f64` constants, and arrays of them, that a file declares.
pub fn constants(file: &syn::File) -> BTreeSet<String> {
    let mut found = Constants::default();
    found.visit_file(file);
    found.0
}

#[derive(Default)]
struct Constants(BTreeSet<String>);

impl Constants {
    fn add(&mut self, name: &syn::Ident, kind: &syn::Type) {
        let element = match kind {
            syn::Type::Array(array) => &array.elem,
            kind => kind,
        };
        if matches!(element, syn::Type::Path(path) if path.path.is_ident("f64")) {
            self.0.insert(name.to_string());
        }
    }
}

impl<'ast> Visit<'ast> for Constants {
    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        self.add(&item.ident, &item.ty);
    }
    fn visit_impl_item_const(&mut self, item: &'ast syn::ImplItemConst) {
        self.add(&item.ident, &item.ty);
    }
}

/// All sites of a file outside of its tests, in order; `constants` are those of the whole crate.
pub fn sites(source: &str, file: &syn::File, constants: &BTreeSet<String>) -> Vec<Site> {
    let mut finder = Finder {
        source,
        constants,
        found: Vec::new(),
    };
    finder.visit_file(file);
    finder.found.sort_by_key(|site| site.bytes.start);
    finder.found
}

struct Finder<'a> {
    source: &'a str,
    constants: &'a BTreeSet<String>,
    found: Vec<Site>,
}

impl Finder<'_> {
    fn add(&mut self, span: Span) {
        let bytes = span.byte_range();
        self.found.push(Site {
            line: span.start().line,
            text: self.source[bytes.clone()].to_owned(),
            bytes,
        });
    }

    fn is_constant(&self, path: &syn::Path) -> bool {
        path.segments.last().is_some_and(|last| {
            let name = last.ident.to_string();
            self.constants.contains(&name) || STANDARD.contains(&name.as_str())
        })
    }

    /// Visit what is only named, not read: the base of a field, the target of an assignment.
    fn visit_place(&mut self, place: &Expr) {
        match place {
            Expr::Field(field) => self.visit_place(&field.base),
            Expr::Index(index) => {
                self.visit_place(&index.expr);
                self.visit_expr(&index.index);
            }
            Expr::Path(_) => {}
            other => self.visit_expr(other),
        }
    }
}

/// The name of a field, if it has one.
fn name_of(field: &ExprField) -> String {
    match &field.member {
        Member::Named(name) => name.to_string(),
        Member::Unnamed(_) => String::new(),
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let Meta::List(list) = &attribute.meta else {
            return false;
        };
        list.path.is_ident("cfg") && list.tokens.to_string() == "test"
    })
}

/// Whether fields of a value may be absent: the sides of the box.
fn is_optional(base: &Expr) -> bool {
    matches!(base, Expr::Path(path) if path.path.is_ident("domain"))
}

/// Methods that read a number; others may need the place itself.
const READS: &[&str] = &["abs", "clamp", "max", "min", "sqrt", "to_f64"];

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            Item::Const(_) | Item::Macro(_) | Item::Use(_) => {}
            Item::Mod(module) if is_test(&module.attrs) => {}
            item => visit::visit_item(self, item),
        }
    }
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}

    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::Lit(literal) => {
                if let Lit::Float(number) = &literal.lit
                    && number
                        .base10_parse::<f64>()
                        .is_ok_and(|number| number != 0.0)
                {
                    self.add(literal.span());
                }
            }
            Expr::Path(path) if self.is_constant(&path.path) || path.path.is_ident("step") => {
                self.add(path.span());
            }
            Expr::Field(field) => {
                if COEFFICIENTS.contains(&name_of(field).as_str()) && !is_optional(&field.base) {
                    self.add(field.span());
                } else {
                    self.visit_place(&field.base);
                }
            }
            Expr::Index(index) => match &*index.expr {
                Expr::Field(field) if COLUMNS.contains(&name_of(field).as_str()) => {
                    self.add(index.span());
                }
                Expr::Path(path) if self.is_constant(&path.path) => self.add(index.span()),
                _ => self.visit_place(expression),
            },
            Expr::Assign(assignment) => {
                self.visit_place(&assignment.left);
                self.visit_expr(&assignment.right);
            }
            Expr::Binary(binary) if is_assignment(&binary.op) => {
                self.visit_place(&binary.left);
                self.visit_expr(&binary.right);
            }
            Expr::Reference(reference) => self.visit_place(&reference.expr),
            Expr::MethodCall(call) => {
                if READS.contains(&call.method.to_string().as_str()) {
                    self.visit_expr(&call.receiver);
                } else {
                    self.visit_place(&call.receiver);
                }
                call.args
                    .iter()
                    .for_each(|argument| self.visit_expr(argument));
            }
            other => visit::visit_expr(self, other),
        }
    }

    /// A shorthand field cannot be wrapped in place.
    fn visit_field_value(&mut self, field: &'ast syn::FieldValue) {
        if field.colon_token.is_some() {
            self.visit_expr(&field.expr);
        }
    }
}

fn is_assignment(operator: &BinOp) -> bool {
    matches!(
        operator,
        BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_constants_and_coefficients_are_found_and_places_are_not() -> syn::Result<()> {
        let source = "const HALF: f64 = 0.5;\n\
            fn energy(&mut self, step: f64) -> f64 {\n\
                self.mass[0] = 2.0 * PI + 0.0;\n\
                self.stiffness += HALF * step;\n\
                self.radius.iter().sum::<f64>() + p.radius[1].abs()\n\
            }\n\
            #[cfg(test)]\nmod tests { const X: f64 = 7.0; fn y() -> f64 { 3.5 } }\n";
        let file = syn::parse_file(source)?;
        let found = sites(source, &file, &constants(&file));
        let texts: Vec<&str> = found.iter().map(|site| site.text.as_str()).collect();
        assert_eq!(texts, ["2.0", "PI", "HALF", "step", "p.radius[1]"]);
        assert_eq!(found[0].line, 3);
        Ok(())
    }
}
