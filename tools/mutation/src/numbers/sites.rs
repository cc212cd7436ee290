//! Finds the places of a file where a number enters a formula.

use super::declared::{Declared, Shape};
use super::names::Names;
use super::site::{Findings, Kind, Side, Site};
use std::ops::Range;
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprLit, FnArg, Lit, Pat, Token};

/// Find the sites of a file.
pub fn find(name: &str, text: &str, file: &syn::File, declared: &Declared, side: Side) -> Findings {
    let mut finder = Finder {
        name,
        text,
        side,
        names: Names::new(declared, side),
        owner: None,
        function: String::new(),
        found: Findings::default(),
    };
    finder.visit_file(file);
    finder.found
}

struct Finder<'a> {
    name: &'a str,
    text: &'a str,
    side: Side,
    names: Names<'a>,
    owner: Option<Shape>,
    function: String,
    found: Findings,
}

impl Finder<'_> {
    fn add(&mut self, expr: &Expr, kind: Kind, shorthand: bool) {
        let range = expr.span().byte_range();
        self.found.sites.push(Site {
            id: 0,
            file: self.name.to_owned(),
            line: expr.span().start().line,
            function: self.function.clone(),
            expression: self.text[range.clone()].to_owned(),
            context: marked_line(self.text, &range),
            kind,
            range,
            shorthand,
            optional: self
                .names
                .shape(expr)
                .is_some_and(|shape| shape.is_optional_double()),
        });
    }

    /// Visit a place that is written to or borrowed; the place itself is not a site.
    fn visit_place(&mut self, place: &Expr) {
        match place {
            Expr::Field(_) | Expr::Index(_) | Expr::Path(_) => {}
            Expr::Paren(inner) => self.visit_place(&inner.expr),
            Expr::Unary(inner) if matches!(inner.op, syn::UnOp::Deref(_)) => {
                self.visit_place(&inner.expr);
            }
            other => self.visit_expr(other),
        }
    }

    fn within(&mut self, name: String, body: impl FnOnce(&mut Self)) {
        let outer = std::mem::replace(&mut self.function, name);
        self.names.open();
        body(self);
        self.names.close();
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
                        finder.names.declare("self".to_owned(), owner, false);
                    }
                    FnArg::Typed(typed) => {
                        let shape = Some(Shape::of(&typed.ty));
                        finder.names.declare_pattern(&typed.pat, shape, true);
                    }
                }
            }
            finder.visit_block(block);
        });
    }
}

/// The line on which a range begins, with marks around the part of the range on it.
fn marked_line(text: &str, range: &Range<usize>) -> String {
    let start = text[..range.start].rfind('\n').map_or(0, |at| at + 1);
    let end = text[range.start..]
        .find('\n')
        .map_or(text.len(), |at| range.start + at);
    let inner = range.end.min(end);
    let [before, marked, after] = [
        &text[start..range.start],
        &text[range.start..inner],
        &text[inner..end],
    ];
    format!("{}«{marked}»{after}", before.trim_start())
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
        self.names.open();
        visit::visit_block(self, block);
        self.names.close();
    }

    fn visit_local(&mut self, local: &'ast syn::Local) {
        let mut shape = None;
        if let Some(init) = &local.init {
            shape = self.names.shape(&init.expr);
            self.visit_expr(&init.expr);
            if let Some((_, other)) = &init.diverge {
                self.visit_expr(other);
            }
        }
        self.names.declare_pattern(&local.pat, shape, false);
    }

    fn visit_expr_for_loop(&mut self, item: &'ast syn::ExprForLoop) {
        self.visit_expr(&item.expr);
        self.names.open();
        let element = self.names.shape(&item.expr).and_then(|shape| shape.element);
        self.names
            .declare_pattern(&item.pat, element.map(|one| *one), false);
        self.visit_block(&item.body);
        self.names.close();
    }

    fn visit_expr_closure(&mut self, closure: &'ast syn::ExprClosure) {
        self.names.open();
        for input in &closure.inputs {
            self.names.declare_pattern(input, None, false);
        }
        self.visit_expr(&closure.body);
        self.names.close();
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        if let Some(kind) = self.names.kind(expr) {
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
                    if !(is_zero(other) && self.names.kind(side).is_some()) {
                        self.visit_expr(side);
                    }
                }
            }
            // Indices do not enter formulas.
            Expr::Index(index) => self.visit_expr(&index.expr),
            _ => visit::visit_expr(self, expr),
        }
    }

    fn visit_field_value(&mut self, value: &'ast syn::FieldValue) {
        if value.colon_token.is_some() {
            self.visit_expr(&value.expr);
        } else if let Some(kind) = self.names.kind(&value.expr) {
            self.add(&value.expr, kind, true);
        }
    }

    fn visit_macro(&mut self, item: &'ast syn::Macro) {
        let list = item
            .parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated)
            .or_else(|_| item.parse_body_with(repeated));
        // The numbers of the list outlive this visit as text only.
        if let Ok(list) = list {
            let mut inner = Finder {
                name: self.name,
                text: self.text,
                side: self.side,
                names: self.names.clone(),
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

/// The element of a list of equal elements, `[element; number]`.
fn repeated(input: ParseStream) -> syn::Result<Punctuated<Expr, Token![,]>> {
    let element = input.parse()?;
    input.parse::<Token![;]>()?;
    input.parse::<Expr>()?;
    Ok(std::iter::once::<Expr>(element).collect())
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

#[cfg(test)]
mod tests {
    use super::super::declared::Declared;
    use super::super::site::Side;
    use super::find;

    const SNIPPET: &str = r#"
        const LIMIT: f64 = 2.0;
        pub const SERIES: [f64; 2] = [1.0, 1.0 / 6.0];
        struct Spring { stiffness: f64, count: usize }
        struct Columns<S> { radius: Vec<S> }
        pub const STEEL: Spring = Spring { stiffness: 7.5, count: 3 };
        impl Spring {
            fn force<S: Real>(&self, columns: &Columns<S>, i: usize, x: S, step: f64) -> S {
                if step <= 0.0 || self.count == 2 {
                    return x * LIMIT;
                }
                let parts = vec![0.5, 0.0];
                columns.radius[i] * self.stiffness + x * (SERIES[1] * step)
            }
            const fn fixed() -> f64 { 9.0 }
        }
        #[cfg(test)]
        mod tests { fn nothing() -> f64 { 4.0 } }
    "#;

    #[test]
    fn numbers_of_formulas_are_found_and_nothing_else() -> syn::Result<()> {
        let file = syn::parse_file(SNIPPET)?;
        let declared = Declared::in_files(std::iter::once(&file));
        let found = find("snippet.rs", SNIPPET, &file, &declared, Side::Kernel);
        let expressions: Vec<&str> = found
            .sites
            .iter()
            .map(|site| site.expression.as_str())
            .collect();
        let expected = [
            "7.5",
            "LIMIT",
            "0.5",
            "columns.radius[i]",
            "self.stiffness",
            "SERIES[1]",
            "step",
        ];
        assert_eq!(expressions, expected);
        assert_eq!(found.sites[3].function, "Spring::force");
        assert_eq!(found.structures.len(), 1);
        let outside = find("snippet.rs", SNIPPET, &file, &declared, Side::User);
        assert!(outside.sites.is_empty());
        Ok(())
    }

    const FOUNDATION: &str =
        "pub struct Pair<S = f64> { first: S } pub struct Field { width: Option<f64> }";

    const USER: &str = r#"
        const RANGE: RangeInclusive<f64> = 0.0..=0.0;
        struct Arm { length: f64 }
        struct Lever { arms: [Arm; 2] }
        struct Cell { field: Field, height: Option<f64> }
        fn turn(cell: &Cell, pair: &Pair, target: &mut f64, angle: &f64) -> f64 {
            *target = if RANGE.is_empty() { 0.0 } else { *angle };
            let lever = lever();
            lever.arms[1].length + pair.first + cell.field.width.unwrap_or(vec![0.5; 2][0])
        }
    "#;

    #[test]
    fn a_site_is_a_number_whose_type_is_known_and_never_the_target_of_an_assignment()
    -> syn::Result<()> {
        let [file, foundation] = [syn::parse_file(USER)?, syn::parse_file(FOUNDATION)?];
        let mut declared = Declared::in_files(std::iter::once(&file));
        declared.add_foundations(std::iter::once(&foundation));
        for (counts_optional, width) in [(false, None), (true, Some("cell.field.width"))] {
            declared.counts_optional = counts_optional;
            let sites = find("user.rs", USER, &file, &declared, Side::Kernel).sites;
            let expressions: Vec<&str> = sites.iter().map(|site| &*site.expression).collect();
            let mut expected = vec!["*angle", "lever.arms[1].length", "pair.first"];
            expected.extend(width);
            expected.push("0.5");
            assert_eq!(expressions, expected);
            let optional = sites.iter().find(|site| site.optional);
            assert_eq!(optional.map(|site| &*site.expression), width);
        }
        Ok(())
    }
}
