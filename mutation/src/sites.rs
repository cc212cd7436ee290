//! Finds the places of a file where a number enters a formula.

use crate::declared::{Declared, Shape};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::ops::Range;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprLit, FnArg, Lit, Member, Pat, Token};

/// What kind of number enters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A literal.
    Literal,
    /// A named constant.
    Constant,
    /// A parameter of a law or the like, or a property of a particle or a link.
    Coefficient,
    /// A number given to a function.
    Input,
}

/// A place where a number enters a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Site {
    /// Number of the site, by which it is switched on.
    pub id: usize,
    /// File, from the root of the workspace.
    pub file: String,
    /// Line, from one.
    pub line: usize,
    /// The function around it.
    pub function: String,
    /// The expression.
    pub expression: String,
    /// The line on which it begins.
    pub context: String,
    /// What kind of number it is.
    pub kind: Kind,
    /// Where it stands, in bytes.
    #[serde(skip)]
    pub range: Range<usize>,
    /// Name to be repeated where a structure is filled by shorthand.
    #[serde(skip)]
    pub shorthand: bool,
}

/// What has to be done to a file.
#[derive(Debug, Default)]
pub struct Findings {
    /// The sites, in order of their beginning; outer ones before inner ones.
    pub sites: Vec<Site>,
    /// Constants of structures with numbers, to be made values that are computed when first used: type
    /// and value.
    pub structures: Vec<[Range<usize>; 3]>,
    /// Macros that hold literals but cannot be read.
    pub opaque: Vec<String>,
}

/// Generic numbers that are coefficients all the same.
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

/// Structures that only tell what was found or went wrong.
const TIDINGS: [&str; 3] = ["LinkState", "ModelError", "StepError"];

/// Which code a file belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The kernel: all kinds of sites count.
    Kernel,
    /// A user of the kernel: only constants that the kernel exports count.
    User,
}

/// Find the sites of a file.
pub fn find(name: &str, text: &str, file: &syn::File, declared: &Declared, side: Side) -> Findings {
    let mut finder = Finder {
        name,
        text,
        declared,
        side,
        scopes: vec![HashMap::new()],
        owner: None,
        function: String::new(),
        found: Findings::default(),
    };
    finder.visit_file(file);
    finder.found
}

#[derive(Clone)]
struct Variable {
    shape: Option<Shape>,
    is_input: bool,
}

struct Finder<'a> {
    name: &'a str,
    text: &'a str,
    declared: &'a Declared,
    side: Side,
    scopes: Vec<HashMap<String, Variable>>,
    owner: Option<Shape>,
    function: String,
    found: Findings,
}

impl Finder<'_> {
    fn variable(&self, name: &str) -> Option<&Variable> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name))
    }

    fn declare(&mut self, name: String, shape: Option<Shape>, is_input: bool) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(name, Variable { shape, is_input });
        }
    }

    /// Declare the names of a pattern.
    fn declare_pattern(&mut self, pattern: &Pat, shape: Option<Shape>, is_input: bool) {
        match pattern {
            Pat::Ident(name) => self.declare(name.ident.to_string(), shape, is_input),
            Pat::Type(typed) => {
                self.declare_pattern(&typed.pat, Some(Shape::of(&typed.ty)), is_input);
            }
            Pat::Slice(slice) => {
                // Parts of a list or of a structure are what was given, under another name.
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

    /// Type of an expression, as far as names tell.
    fn shape(&self, expr: &Expr) -> Option<Shape> {
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

    /// What kind of site an expression is, if any.
    fn kind(&self, expr: &Expr) -> Option<Kind> {
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
                let tells = owner.is_some_and(|owner| TIDINGS.contains(&owner.name.as_str()));
                let counts = shape.is_double()
                    || shape.is_real() && PROPERTIES.contains(&name.to_string().as_str());
                (counts && !tells).then_some(Kind::Coefficient)
            }
            Expr::Index(index) => {
                let list = innermost_name(&index.expr)?;
                if self.declared.constants.contains(&list) {
                    return Some(Kind::Constant);
                }
                let counts = self.shape(expr).is_none_or(|shape| shape.is_real())
                    && PROPERTIES.contains(&list.as_str());
                counts.then_some(Kind::Coefficient)
            }
            _ => None,
        }
    }

    fn add(&mut self, expr: &Expr, kind: Kind, shorthand: bool) {
        let range = expr.span().byte_range();
        self.found.sites.push(Site {
            id: 0,
            file: self.name.to_owned(),
            line: expr.span().start().line,
            function: self.function.clone(),
            expression: self.text[range.clone()].to_owned(),
            context: line_around(self.text, &range).to_owned(),
            kind,
            range,
            shorthand,
        });
    }

    /// Visit a place that is written to or borrowed: it is no site itself.
    fn visit_place(&mut self, place: &Expr) {
        match place {
            Expr::Field(_) | Expr::Index(_) | Expr::Path(_) => {}
            other => self.visit_expr(other),
        }
    }

    fn within(&mut self, name: String, body: impl FnOnce(&mut Self)) {
        let outer = std::mem::replace(&mut self.function, name);
        self.scopes.push(HashMap::new());
        body(self);
        self.scopes.pop();
        self.function = outer;
    }

    fn visit_function(&mut self, signature: &syn::Signature, block: &syn::Block) {
        if signature.constness.is_some() {
            return;
        }
        let name = match &self.owner {
            Some(owner) => format!("{}::{}", owner.name, signature.ident),
            None => signature.ident.to_string(),
        };
        self.within(name, |finder| {
            for input in &signature.inputs {
                match input {
                    FnArg::Receiver(_) => {
                        let owner = finder.owner.clone();
                        finder.declare("self".to_owned(), owner, false);
                    }
                    FnArg::Typed(typed) => {
                        let shape = Some(Shape::of(&typed.ty));
                        finder.declare_pattern(&typed.pat, shape, true);
                    }
                }
            }
            finder.visit_block(block);
        });
    }
}

/// The line on which a range begins.
fn line_around<'a>(text: &'a str, range: &Range<usize>) -> &'a str {
    let start = text[..range.start].rfind('\n').map_or(0, |at| at + 1);
    let end = text[range.start..]
        .find('\n')
        .map_or(text.len(), |at| range.start + at);
    text[start..end].trim()
}

/// The name of what is indexed: the last one of a path or of fields.
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

fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    let tests = |attribute: &syn::Attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .parse_args::<syn::Ident>()
                .is_ok_and(|word| word == "test")
    };
    attributes.iter().any(tests)
}

/// Whether an expression is zero as written.
fn is_zero(expr: &Expr) -> bool {
    match expr {
        Expr::Lit(ExprLit {
            lit: Lit::Float(number),
            ..
        }) => number.base10_parse().is_ok_and(|x: f64| x == 0.0),
        Expr::Call(call) => match &*call.func {
            Expr::Path(path) => path.path.segments.last().is_some_and(|s| s.ident == "zero"),
            _ => false,
        },
        _ => false,
    }
}

fn is_assignment(op: &BinOp) -> bool {
    matches!(
        op,
        BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_)
    )
}

fn is_comparison(op: &BinOp) -> bool {
    use BinOp::{Eq, Ge, Gt, Le, Lt, Ne};
    matches!(op, Eq(_) | Ne(_) | Lt(_) | Le(_) | Gt(_) | Ge(_))
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
    fn visit_pat(&mut self, _: &'ast Pat) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        if let (Expr::Struct(_), Side::Kernel) = (&*item.expr, self.side) {
            self.found.structures.push([
                item.const_token.span.byte_range(),
                item.ty.span().byte_range(),
                item.expr.span().byte_range(),
            ]);
            self.within(item.ident.to_string(), |finder| {
                finder.visit_expr(&item.expr);
            });
        }
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let outer = self.owner.replace(Shape::of(&item.self_ty));
        visit::visit_item_impl(self, item);
        self.owner = outer;
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        let outer = self.owner.replace(Shape::named(&item.ident.to_string()));
        visit::visit_item_trait(self, item);
        self.owner = outer;
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.visit_function(&item.sig, &item.block);
    }
    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.visit_function(&item.sig, &item.block);
    }
    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let Some(block) = &item.default {
            self.visit_function(&item.sig, block);
        }
    }

    fn visit_block(&mut self, block: &'ast syn::Block) {
        self.scopes.push(HashMap::new());
        visit::visit_block(self, block);
        self.scopes.pop();
    }

    fn visit_local(&mut self, local: &'ast syn::Local) {
        let mut shape = None;
        if let Some(init) = &local.init {
            shape = self.shape(&init.expr);
            self.visit_expr(&init.expr);
            if let Some((_, other)) = &init.diverge {
                self.visit_expr(other);
            }
        }
        self.declare_pattern(&local.pat, shape, false);
    }

    fn visit_expr_for_loop(&mut self, item: &'ast syn::ExprForLoop) {
        self.visit_expr(&item.expr);
        self.scopes.push(HashMap::new());
        let element = self.shape(&item.expr).and_then(|shape| shape.element);
        self.declare_pattern(&item.pat, element.map(|one| *one), false);
        self.visit_block(&item.body);
        self.scopes.pop();
    }

    fn visit_expr_closure(&mut self, closure: &'ast syn::ExprClosure) {
        self.scopes.push(HashMap::new());
        for input in &closure.inputs {
            self.declare_pattern(input, None, false);
        }
        self.visit_expr(&closure.body);
        self.scopes.pop();
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        if let Some(kind) = self.kind(expr) {
            self.add(expr, kind, false);
            return;
        }
        match expr {
            Expr::Reference(inner) => self.visit_place(&inner.expr),
            Expr::Assign(assignment) => {
                self.visit_place(&assignment.left);
                self.visit_expr(&assignment.right);
            }
            Expr::Binary(binary) if is_assignment(&binary.op) => {
                self.visit_place(&binary.left);
                self.visit_expr(&binary.right);
            }
            Expr::Binary(binary) if is_comparison(&binary.op) => {
                for (side, other) in [(&binary.left, &binary.right), (&binary.right, &binary.left)]
                {
                    // A factor changes no comparison with zero.
                    if !(is_zero(other) && self.kind(side).is_some()) {
                        self.visit_expr(side);
                    }
                }
            }
            // Indices are no numbers of a formula.
            Expr::Index(index) => self.visit_expr(&index.expr),
            _ => visit::visit_expr(self, expr),
        }
    }

    fn visit_field_value(&mut self, value: &'ast syn::FieldValue) {
        if value.colon_token.is_some() {
            self.visit_expr(&value.expr);
        } else if let Some(kind) = self.kind(&value.expr) {
            self.add(&value.expr, kind, true);
        }
    }

    fn visit_macro(&mut self, item: &'ast syn::Macro) {
        let list = item.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated);
        // The numbers of the list outlive this visit as text only.
        if let Ok(list) = list {
            let mut inner = Finder {
                name: self.name,
                text: self.text,
                declared: self.declared,
                side: self.side,
                scopes: self.scopes.clone(),
                owner: self.owner.clone(),
                function: self.function.clone(),
                found: Findings::default(),
            };
            list.iter().for_each(|expr| inner.visit_expr(expr));
            self.found.sites.append(&mut inner.found.sites);
        } else if self.side == Side::Kernel && holds_number(item.tokens.clone()) {
            self.found.opaque.push(item.tokens.to_string());
        }
    }
}

/// Whether tokens hold the literal of a number that is not zero nor an integer.
fn holds_number(tokens: proc_macro2::TokenStream) -> bool {
    use proc_macro2::TokenTree;
    tokens.into_iter().any(|token| match token {
        TokenTree::Group(group) => holds_number(group.stream()),
        TokenTree::Literal(literal) => match syn::parse_str::<Lit>(&literal.to_string()) {
            Ok(Lit::Float(number)) => number.base10_parse().is_ok_and(|x: f64| x != 0.0),
            _ => false,
        },
        _ => false,
    })
}
