//! Files and functions are short, and functions are not deeply nested.
//!
//! The length of a function is the number of lines from `fn` to the closing brace, including comments and empty
//! lines. Its nesting is the largest number of nested blocks of control flow: branches of `if` and `let ... else`
//! (an `else if` is at the level of its `if`), arms of `match`, bodies of loops, and closures whose bodies are blocks.
//! A function inside another one is counted separately, and its lines count for both. Arguments of macros are not
//! parsed and not counted.

use crate::sources::{read, root, rust_files};
use proc_macro2::Span;
use std::path::PathBuf;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Folders with source files.
const FOLDERS: [&str; 12] = [
    "benches",
    "cli",
    "examples",
    "kernel",
    "page",
    "python",
    "replay",
    "runner",
    "studies",
    "tests",
    "tools",
    "validation",
];

/// Longest file in lines.
const LONGEST_FILE: usize = 500;

/// Longest function in lines.
const LONGEST_FUNCTION: usize = 60;

/// Largest number of nested blocks of control flow.
const DEEPEST: usize = 4;

/// Length and nesting of a function.
#[derive(Debug, PartialEq, Eq)]
struct Function {
    name: String,
    lines: usize,
    nesting: usize,
}

/// Functions of a file; inner functions come after the enclosing ones.
#[derive(Default)]
struct Functions(Vec<Function>);

impl Functions {
    fn add(&mut self, signature: &syn::Signature, body: &syn::Block) {
        let mut nesting = Nesting::default();
        nesting.visit_block(body);
        self.0.push(Function {
            name: signature.ident.to_string(),
            lines: lines(signature.fn_token.span(), body.brace_token.span.close()),
            nesting: nesting.deepest,
        });
    }
}

fn lines(first: Span, last: Span) -> usize {
    last.end().line - first.start().line + 1
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        self.add(&function.sig, &function.block);
        visit::visit_item_fn(self, function);
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        self.add(&function.sig, &function.block);
        visit::visit_impl_item_fn(self, function);
    }

    fn visit_trait_item_fn(&mut self, function: &'ast syn::TraitItemFn) {
        if let Some(body) = &function.default {
            self.add(&function.sig, body);
        }
        visit::visit_trait_item_fn(self, function);
    }
}

/// Number of blocks of control flow around the visited node.
#[derive(Default)]
struct Nesting {
    now: usize,
    deepest: usize,
}

impl Nesting {
    fn inside(&mut self, visit: impl FnOnce(&mut Self)) {
        self.now += 1;
        self.deepest = self.deepest.max(self.now);
        visit(self);
        self.now -= 1;
    }
}

impl<'ast> Visit<'ast> for Nesting {
    fn visit_expr_if(&mut self, branch: &'ast syn::ExprIf) {
        self.visit_expr(&branch.cond);
        self.inside(|nesting| nesting.visit_block(&branch.then_branch));
        match branch.else_branch.as_ref().map(|(_, other)| other.as_ref()) {
            Some(syn::Expr::If(other)) => self.visit_expr_if(other),
            Some(other) => self.inside(|nesting| nesting.visit_expr(other)),
            None => {}
        }
    }

    fn visit_local_init(&mut self, init: &'ast syn::LocalInit) {
        self.visit_expr(&init.expr);
        if let Some((_, other)) = &init.diverge {
            self.inside(|nesting| nesting.visit_expr(other));
        }
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        self.inside(|nesting| visit::visit_arm(nesting, arm));
    }

    fn visit_expr_for_loop(&mut self, one: &'ast syn::ExprForLoop) {
        self.visit_expr(&one.expr);
        self.inside(|nesting| nesting.visit_block(&one.body));
    }

    fn visit_expr_while(&mut self, one: &'ast syn::ExprWhile) {
        self.visit_expr(&one.cond);
        self.inside(|nesting| nesting.visit_block(&one.body));
    }

    fn visit_expr_loop(&mut self, one: &'ast syn::ExprLoop) {
        self.inside(|nesting| nesting.visit_block(&one.body));
    }

    fn visit_expr_closure(&mut self, closure: &'ast syn::ExprClosure) {
        match closure.body.as_ref() {
            syn::Expr::Block(body) => self.inside(|nesting| nesting.visit_block(&body.block)),
            body => self.visit_expr(body),
        }
    }

    fn visit_item_fn(&mut self, _: &'ast syn::ItemFn) {}
    fn visit_impl_item_fn(&mut self, _: &'ast syn::ImplItemFn) {}
    fn visit_trait_item_fn(&mut self, _: &'ast syn::TraitItemFn) {}
}

fn functions(text: &str) -> Vec<Function> {
    let mut functions = Functions::default();
    functions.visit_file(&syn::parse_file(text).expect("Rust"));
    functions.0
}

fn files() -> impl Iterator<Item = PathBuf> {
    FOLDERS
        .iter()
        .flat_map(|folder| rust_files(&root().join(folder)))
}

#[test]
fn lengths_and_nesting_are_counted_as_documented() {
    let text = "
        fn outer(x: u32) -> u32 {
            let Some(y) = next(x) else { return 0 };
            if x > y {
                for i in 0..x {
                    match i { 0 => {} _ => call(|| { done() }) }
                }
            } else if x == y {
                fn inner() { loop { while true {} } }
            }
            x
        }
        trait Law { fn none(&self) { (0..3).map(|i| i + 1); } fn required(&self); }
        impl Law for u8 { fn none(&self) { { { self } } } }";
    let function = |name: &str, lines, nesting| Function {
        name: name.to_owned(),
        lines,
        nesting,
    };
    let expected = [
        function("outer", 11, 4),
        function("inner", 1, 2),
        function("none", 1, 0),
        function("none", 1, 0),
    ];
    assert_eq!(functions(text), expected);
}

#[test]
fn files_are_short() {
    for file in files() {
        let lines = read(&file).lines().count();
        assert!(lines <= LONGEST_FILE, "{}: {lines} lines", file.display());
    }
}

#[test]
fn functions_are_short_and_flat() {
    let mut found = Vec::new();
    for file in files() {
        for Function {
            name,
            lines,
            nesting,
        } in functions(&read(&file))
        {
            if lines > LONGEST_FUNCTION || nesting > DEEPEST {
                let place = file.display();
                found.push(format!(
                    "{place}: {name} has {lines} lines, {nesting} blocks deep"
                ));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
