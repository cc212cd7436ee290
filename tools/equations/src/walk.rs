//! Searches a stream of tokens for documentation.

use crate::{fence::Fences, line};
use litrs::StringLit;
use proc_macro2::{Delimiter, Group, Literal, TokenStream, TokenTree};
use quote::quote_spanned;

/// Renders the formulas in all documentation of the stream; errors follow after the item.
pub fn render(item: TokenStream) -> TokenStream {
    let mut walk = Walk::default();
    let mut output = walk.stream(item);
    output.extend(walk.errors);
    output
}

#[derive(Default)]
struct Walk {
    errors: TokenStream,
    replaced: usize,
}

impl Walk {
    fn stream(&mut self, stream: TokenStream) -> TokenStream {
        let mut fences = Fences::default();
        let mut hash = false;
        let step = |token| {
            let attribute = hash && is_bracket(&token);
            hash = starts_attribute(&token, hash);
            if !attribute && !hash {
                fences = Fences::default();
            }
            match token {
                TokenTree::Group(group) if attribute => self.attribute(group, &mut fences),
                TokenTree::Group(group) => self.group(group),
                token => token,
            }
        };
        stream.into_iter().map(step).collect()
    }

    fn attribute(&mut self, group: Group, fences: &mut Fences) -> TokenTree {
        let tokens = flat(group.stream());
        if let [name, equals, TokenTree::Literal(text)] = tokens.as_slice()
            && name.to_string() == "doc"
            && let Some(text) = self.documentation(text, fences)
        {
            let stream = [name.clone(), equals.clone(), text.into()];
            return regroup(&group, stream.into_iter().collect());
        }
        self.group(group)
    }

    /// The documentation with its formulas rendered, if there are any.
    fn documentation(&mut self, literal: &Literal, fences: &mut Fences) -> Option<Literal> {
        let text = StringLit::try_from(literal).ok()?;
        let lines: Vec<String> = text
            .value()
            .split('\n')
            .map(|line| self.line(line, literal, fences))
            .collect();
        let output = lines.join("\n");
        if output == text.value() {
            return None;
        }
        self.replaced += 1;
        let mut output = Literal::string(&output);
        output.set_span(literal.span());
        Some(output)
    }

    fn line(&mut self, line: &str, literal: &Literal, fences: &mut Fences) -> String {
        if fences.covers(line) {
            return line.to_owned();
        }
        line::render(line).unwrap_or_else(|reason| {
            let error = quote_spanned!(literal.span()=> ::core::compile_error! { #reason });
            self.errors.extend(error);
            line.to_owned()
        })
    }

    /// Renders the documentation inside a group; a group without formulas is returned unchanged.
    fn group(&mut self, group: Group) -> TokenTree {
        let before = self.replaced;
        let stream = self.stream(group.stream());
        match self.replaced == before {
            true => group.into(),
            false => regroup(&group, stream),
        }
    }
}

/// The tokens without the invisible groups which come from the variables of declarative macros.
fn flat(stream: TokenStream) -> Vec<TokenTree> {
    let step = |token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::None => flat(group.stream()),
        token => vec![token],
    };
    stream.into_iter().flat_map(step).collect()
}

fn is_bracket(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket)
}

/// Whether an attribute follows a `#`, or the `!` after it.
fn starts_attribute(token: &TokenTree, after_hash: bool) -> bool {
    match token {
        TokenTree::Punct(mark) => mark.as_char() == '#' || after_hash && mark.as_char() == '!',
        _ => false,
    }
}

fn regroup(group: &Group, stream: TokenStream) -> TokenTree {
    let mut output = Group::new(group.delimiter(), stream);
    output.set_span(group.span());
    output.into()
}

#[cfg(test)]
mod tests {
    use super::render;
    use proc_macro2::{Delimiter, Group, TokenStream};
    use quote::quote;

    const X: &str = r#" <math style="padding:.35em 0"><mi>x</mi></math>"#;

    fn assert_renders(item: TokenStream, expected: TokenStream) {
        assert_eq!(render(item).to_string(), expected.to_string());
    }

    #[test]
    fn documentation_is_found_at_every_depth() {
        assert_renders(
            quote! {
                /// $x$
                struct A {
                    #![doc = " $x$"]
                    #[doc(hidden)]
                    /// $x$
                    a: [f64; 3],
                }
            },
            quote! {
                #[doc = #X]
                struct A {
                    #![doc = #X]
                    #[doc(hidden)]
                    #[doc = #X]
                    a: [f64; 3],
                }
            },
        );
    }

    #[test]
    fn everything_else_is_kept() {
        let item = quote! {
            #[doc = r#"no "formula""#]
            #[doc = include_str!("$x$")]
            #[deprecated = "$x$"]
            fn f() -> &'static str {
                r"$x$"
            }
        };
        assert_renders(item.clone(), item);
    }

    #[test]
    fn raw_and_escaped_literals_mean_the_same() {
        let raw = render(quote!(
            #[doc = r" $\alpha$"]
            struct A;
        ));
        assert!(raw.to_string().contains("<mi>α</mi>"));
        assert_renders(
            quote!(
                #[doc = " $\\alpha$"]
                struct A;
            ),
            raw,
        );
    }

    #[test]
    fn invisible_groups_are_looked_through() {
        let meta = Group::new(Delimiter::None, quote!(doc = " $x$"));
        assert_renders(quote!(#[#meta] struct A;), quote!(#[doc = #X] struct A;));
    }

    #[test]
    fn fences_last_until_the_item() {
        assert_renders(
            quote! {
                /// ```
                #[inline]
                /// $x$
                fn a() {}
                /// $x$
                fn b() {}
            },
            quote! {
                /// ```
                #[inline]
                /// $x$
                fn a() {}
                #[doc = #X]
                fn b() {}
            },
        );
    }

    #[test]
    fn lines_of_one_literal_are_separate() {
        let text = " $x$\n```\n$x$\n```\n $x$";
        let expected = format!("{X}\n```\n$x$\n```\n{X}");
        assert_renders(
            quote!(#[doc = #text] struct A;),
            quote!(#[doc = #expected] struct A;),
        );
    }

    #[test]
    fn bad_formulas_are_errors_beside_the_item() {
        let output = render(quote! {
            /// $x$ and
            /// $\nonsense$
            struct A;
        })
        .to_string();
        assert!(
            output.contains("struct A ;") && output.contains("<mi>x</mi>"),
            "{output}"
        );
        assert!(
            output.contains("compile_error") && output.contains("nonsense"),
            "{output}"
        );
    }
}
