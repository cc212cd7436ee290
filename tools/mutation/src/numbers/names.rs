//! Types of the names in scope, which determine which expressions are numbers in a formula.

use super::declared::{Declared, Shape};
use super::site::{Kind, Side};
use std::collections::HashMap;
use syn::{Expr, ExprLit, Lit, Member, Pat};

/// Generic numbers that are coefficients nevertheless.
const PROPERTIES: [&str; 10] = [
    "radius",
    "radii",
    "mass",
    "moment_of_inertia",
    "inverse_mass",
    "inverse_inertia",
    "rest_distance",
    "strength_factor",
    "arms",
    "depth",
];

/// Structures that only report results or errors.
const REPORTS: [&str; 3] = ["Interaction", "ModelError", "StepError"];

#[derive(Clone)]
struct Variable {
    shape: Option<Shape>,
    is_input: bool,
}

/// The names in scope.
#[derive(Clone)]
pub struct Names<'a> {
    declared: &'a Declared,
    side: Side,
    scopes: Vec<HashMap<String, Variable>>,
}

impl<'a> Names<'a> {
    /// Only the names declared at the top level.
    pub fn new(declared: &'a Declared, side: Side) -> Self {
        Self {
            declared,
            side,
            scopes: vec![HashMap::new()],
        }
    }

    /// Begin a scope.
    pub fn open(&mut self) {
        self.scopes.push(HashMap::new());
    }

    /// End the innermost scope.
    pub fn close(&mut self) {
        self.scopes.pop();
    }

    fn variable(&self, name: &str) -> Option<&Variable> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name))
    }

    /// Declare a name.
    pub fn declare(&mut self, name: String, shape: Option<Shape>, is_input: bool) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(name, Variable { shape, is_input });
        }
    }

    /// Declare the names of a pattern.
    pub fn declare_pattern(&mut self, pattern: &Pat, shape: Option<Shape>, is_input: bool) {
        match pattern {
            Pat::Ident(name) => self.declare(name.ident.to_string(), shape, is_input),
            Pat::Type(typed) => {
                self.declare_pattern(&typed.pat, Some(Shape::of(&typed.ty)), is_input);
            }
            Pat::Slice(slice) => {
                // Parts of a destructured list or structure count as inputs.
                let element = shape.and_then(|shape| shape.element).map(|one| *one);
                for part in &slice.elems {
                    self.declare_pattern(part, element.clone(), true);
                }
            }
            Pat::Struct(structure) => {
                let name = structure.path.segments.last().map(|s| s.ident.to_string());
                let owner = name.map(|name| Shape::named(&name));
                for part in &structure.fields {
                    if let Member::Named(name) = &part.member {
                        let shape = self.declared.field(owner.as_ref(), &name.to_string());
                        let shape = shape.cloned();
                        self.declare_pattern(&part.pat, shape, true);
                    }
                }
            }
            Pat::Tuple(tuple) => {
                for part in &tuple.elems {
                    self.declare_pattern(part, None, false);
                }
            }
            Pat::Reference(inner) => self.declare_pattern(&inner.pat, shape, is_input),
            _ => {}
        }
    }

    /// Type of an expression, if its names determine it.
    pub fn shape(&self, expr: &Expr) -> Option<Shape> {
        match expr {
            Expr::Path(path) => self
                .variable(&path.path.get_ident()?.to_string())?
                .shape
                .clone(),
            Expr::Field(field) => {
                let Member::Named(name) = &field.member else {
                    return None;
                };
                let owner = self.shape(&field.base);
                self.declared
                    .field(owner.as_ref(), &name.to_string())
                    .cloned()
            }
            Expr::Index(index) => self.shape(&index.expr)?.element.map(|one| *one),
            Expr::Try(inner) => self.shape(&inner.expr)?.element.map(|one| *one),
            Expr::Paren(inner) => self.shape(&inner.expr),
            Expr::Reference(inner) => self.shape(&inner.expr),
            Expr::Unary(inner) if matches!(inner.op, syn::UnOp::Deref(_)) => {
                self.shape(&inner.expr)
            }
            _ => None,
        }
    }

    /// Kind of the site that an expression is, if it is one.
    pub fn kind(&self, expr: &Expr) -> Option<Kind> {
        if self.side == Side::User {
            let exported = |name: String| self.declared.exported.contains(&name);
            let is_path = matches!(expr, Expr::Path(_));
            return (is_path && exported(innermost_name(expr)?)).then_some(Kind::Constant);
        }
        match expr {
            Expr::Lit(ExprLit {
                lit: Lit::Float(number),
                ..
            }) => {
                let value: f64 = number.base10_parse().ok()?;
                (value != 0.0).then_some(Kind::Literal)
            }
            Expr::Path(path) => {
                let last = path.path.segments.last()?.ident.to_string();
                if self.declared.constants.contains(&last) && self.variable(&last).is_none() {
                    return Some(Kind::Constant);
                }
                let name = path.path.get_ident()?.to_string();
                let variable = self.variable(&name)?;
                let shape = variable.shape.as_ref()?;
                let counts =
                    shape.is_double() || shape.is_real() && PROPERTIES.contains(&name.as_str());
                (variable.is_input && counts).then_some(Kind::Input)
            }
            Expr::Field(field) => {
                let shape = self.shape(expr)?;
                let Member::Named(name) = &field.member else {
                    return None;
                };
                let owner = self.shape(&field.base);
                let is_report = owner.is_some_and(|owner| REPORTS.contains(&owner.name.as_str()));
                let counts = shape.is_double()
                    || shape.is_optional_double() && self.declared.counts_optional
                    || shape.is_real() && PROPERTIES.contains(&name.to_string().as_str());
                (counts && !is_report).then_some(Kind::Coefficient)
            }
            Expr::Index(index) => {
                let list = innermost_name(&index.expr)?;
                if self.declared.constants.contains(&list) {
                    return Some(Kind::Constant);
                }
                let is_real = match self.shape(expr) {
                    Some(shape) => shape.is_real(),
                    None => self.declared.can_hold_reals(&list),
                };
                let counts = is_real && PROPERTIES.contains(&list.as_str());
                counts.then_some(Kind::Coefficient)
            }
            // The number behind a reference is scaled, not the reference.
            Expr::Unary(inner) if matches!(inner.op, syn::UnOp::Deref(_)) => self.kind(&inner.expr),
            _ => None,
        }
    }
}

/// The name of an indexed expression: the last name of its path or fields.
fn innermost_name(expr: &Expr) -> Option<String> {
    match expr {
        Expr::Path(path) => Some(path.path.segments.last()?.ident.to_string()),
        Expr::Field(field) => match &field.member {
            Member::Named(name) => Some(name.to_string()),
            Member::Unnamed(_) => None,
        },
        _ => None,
    }
}
