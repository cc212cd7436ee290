//! Finds the places of a file where an operator, a condition or a result can be replaced.

use super::mutant::{Form, Kind, Place};
use super::replacements::{operators, results};
use std::ops::Range;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, Token, Type, UnOp};

/// Longest expression that is shown in full, in characters.
const SHOWN: usize = 70;

/// The places of a file, ordered by their beginning; outer places come before inner ones.
pub fn find(text: &str, file: &syn::File) -> Vec<Place> {
    let mut finder = Finder {
        text,
        owner: None,
        function: String::new(),
        found: Vec::new(),
    };
    finder.visit_file(file);
    finder.found
}

struct Finder<'a> {
    text: &'a str,
    owner: Option<Type>,
    function: String,
    found: Vec<Place>,
}

impl Finder<'_> {
    fn add(&mut self, node: &impl Spanned, kind: Kind, form: Form, others: Vec<String>) {
        let span = node.span();
        let range = match &form {
            Form::Body => {
                let begin = span.byte_range().start + 1;
                begin..begin
            }
            _ => span.byte_range(),
        };
        let column = span.start().column + 1;
        self.found.push(Place {
            kind,
            form,
            line: span.start().line,
            column,
            function: self.function.clone(),
            operator: String::new(),
            expression: shortened(&self.text[range.clone()]),
            others,
            range,
        });
    }

    fn add_operator(&mut self, node: &Expr, operator: Range<usize>, kind: Kind, form: Form) {
        self.add(node, kind, form, Vec::new());
        if let Some(place) = self.found.last_mut() {
            place.operator = self.text[operator].to_owned();
        }
    }

    fn add_binary(&mut self, node: &Expr, binary: &syn::ExprBinary) {
        let (kind, family) = operators(&binary.op);
        if kind == Kind::Logic && (binds(&binary.left) || binds(&binary.right)) {
            return;
        }
        let [left, right] = [&binary.left, &binary.right].map(|side| side.span().byte_range());
        let form = match kind {
            Kind::Comparison => Form::Comparison(left, right),
            Kind::Logic => Form::Logic(left, right),
            Kind::Assignment => Form::Assignment(left, right),
            _ => Form::Arithmetic(left, right),
        };
        self.add_operator(node, binary.op.span().byte_range(), kind, form);
        if let Some(place) = self.found.last_mut() {
            let others = family.iter().filter(|other| **other != place.operator);
            place.others = others.map(|other| (*other).to_owned()).collect();
        }
    }

    fn add_unary(&mut self, node: &Expr, unary: &syn::ExprUnary) {
        if matches!(unary.op, UnOp::Neg(_) | UnOp::Not(_)) {
            let form = Form::Sign(unary.expr.span().byte_range());
            let operator = unary.op.span().byte_range();
            self.add_operator(node, operator, Kind::Sign, form);
            if let Some(place) = self.found.last_mut() {
                place.others.push(String::new());
            }
        }
    }

    fn add_truth(&mut self, truth: &Expr, kind: Kind) {
        if !binds(truth) {
            let both = ["true", "false"].map(str::to_owned);
            self.add(truth, kind, Form::Truth, both.to_vec());
        }
    }

    fn visit_function(&mut self, signature: &syn::Signature, block: &syn::Block) {
        if signature.constness.is_some() {
            return;
        }
        let name = match self.owner.as_ref().and_then(last_name) {
            Some(owner) => format!("{owner}::{}", signature.ident),
            None => signature.ident.to_string(),
        };
        let outer = std::mem::replace(&mut self.function, name);
        let mut values = results(&signature.output, self.text, self.owner.as_ref());
        values.retain(|value| !is_body(value, self.text, block));
        if !values.is_empty() {
            self.add(block, Kind::Result, Form::Body, values);
        }
        self.visit_block(block);
        self.function = outer;
    }

    fn visit_all(&mut self, list: &Punctuated<Expr, Token![,]>) {
        list.iter().for_each(|expr| self.visit_expr(expr));
    }
}

/// An expression on one line, shortened if it is long.
fn shortened(expression: &str) -> String {
    let line = expression.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}...", &line[..end]),
        None => line,
    }
}

/// Whether a condition binds names, so that it cannot be moved.
fn binds(condition: &Expr) -> bool {
    match condition {
        Expr::Let(_) => true,
        Expr::Binary(binary) if matches!(binary.op, BinOp::And(_)) => {
            binds(&binary.left) || binds(&binary.right)
        }
        _ => false,
    }
}

/// Whether the body of a function already is the value, so that replacing the body changes nothing.
fn is_body(value: &str, text: &str, block: &syn::Block) -> bool {
    let body = match &block.stmts[..] {
        [] => "()",
        [syn::Stmt::Expr(expr, None)] => &text[expr.span().byte_range()],
        _ => return false,
    };
    let is_default = value == "Default::default()";
    body == value || is_default && ["Self::default()", "Vec2::default()"].contains(&body)
}

fn last_name(ty: &Type) -> Option<String> {
    match ty {
        Type::Path(path) => Some(path.path.segments.last()?.ident.to_string()),
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

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_type(&mut self, _: &'ast Type) {}
    fn visit_path(&mut self, _: &'ast syn::Path) {}
    fn visit_angle_bracketed_generic_arguments(
        &mut self,
        _: &'ast syn::AngleBracketedGenericArguments,
    ) {
    }
    fn visit_generics(&mut self, _: &'ast syn::Generics) {}
    fn visit_expr_const(&mut self, _: &'ast syn::ExprConst) {}
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_item_enum(&mut self, _: &'ast syn::ItemEnum) {}
    fn visit_item_macro(&mut self, _: &'ast syn::ItemMacro) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let outer = self.owner.replace((*item.self_ty).clone());
        visit::visit_item_impl(self, item);
        self.owner = outer;
    }
    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        let name = &item.ident;
        let outer = self.owner.replace(syn::parse_quote!(#name));
        visit::visit_item_trait(self, item);
        self.owner = outer;
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        let outer = self.owner.take();
        self.visit_function(&item.sig, &item.block);
        self.owner = outer;
    }
    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.visit_function(&item.sig, &item.block);
    }
    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let Some(block) = &item.default {
            self.visit_function(&item.sig, block);
        }
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        if let Some((_, guard)) = &arm.guard {
            self.add_truth(guard, Kind::Guard);
        }
        visit::visit_arm(self, arm);
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        match expr {
            Expr::Binary(binary) => self.add_binary(expr, binary),
            Expr::Unary(unary) => self.add_unary(expr, unary),
            Expr::If(branch) => self.add_truth(&branch.cond, Kind::Condition),
            // The length is computed by the compiler.
            Expr::Repeat(list) => return self.visit_expr(&list.expr),
            _ => {}
        }
        visit::visit_expr(self, expr);
    }

    fn visit_macro(&mut self, item: &'ast syn::Macro) {
        // What looks like an expression in a macro may be a pattern.
        if item.path.is_ident("matches") {
            return;
        }
        if let Ok(list) = item.parse_body_with(Punctuated::parse_terminated) {
            self.visit_all(&list);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::find;

    const SNIPPET: &str = r#"
        const LIMIT: f64 = 2.0 * 3.0;
        trait Law { fn force(&self, x: f64) -> f64; }
        impl Law for Spring {
            fn force(&self, x: f64) -> f64 {
                const WHOLE: usize = 1 << 3;
                let list = [x + 1.0; 2 + WHOLE];
                if let Some(y) = self.rest && x < y {
                    return -x;
                }
                match x { y if y == 0.0 => 0.0, _ => list[0] }
            }
        }
        fn count(n: usize) -> usize { 0 }
        fn matters(x: &Kind) -> bool { matches!(x, Kind::A | Kind::B) }
        fn note(sum: &mut u64, a: bool, b: bool) { *sum |= (a && !b) as u64; }
        const fn fixed() -> f64 { 4.0 - 1.0 }
        #[cfg(test)]
        mod tests { fn nothing() -> f64 { 4.0 + 1.0 } }
    "#;

    #[test]
    fn places_are_found_outside_of_constants_patterns_and_tests() -> syn::Result<()> {
        let found = find(SNIPPET, &syn::parse_file(SNIPPET)?);
        let words: Vec<String> = found
            .iter()
            .map(|place| {
                let (operator, others) = (&place.operator, place.others.join(" "));
                format!("{} {operator}: {others}", place.expression)
            })
            .collect();
        let expected = [
            " : 0.0 1.0",
            "x + 1.0 +: - * / %",
            "x < y <: == != <= > >=",
            "-x -: ",
            "y == 0.0 : true false",
            "y == 0.0 ==: != < <= > >=",
            " : 1",
            " : true false",
            " : ()",
            "*sum |= (a && !b) as u64 |=: &= ^=",
            "a && !b &&: ||",
            "!b !: ",
        ];
        assert_eq!(words, expected);
        assert_eq!(found[1].function, "Spring::force");
        Ok(())
    }
}
