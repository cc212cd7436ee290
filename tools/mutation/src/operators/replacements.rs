//! Replacements of operators and of results of functions.

use super::mutant::Kind;
use syn::spanned::Spanned;
use syn::{BinOp, GenericArgument, PathArguments, ReturnType, Type};

const ARITHMETIC: &[&str] = &["+", "-", "*", "/", "%"];
const BITS: &[&str] = &["&", "|", "^"];
const SHIFTS: &[&str] = &["<<", ">>"];
const COMPARISONS: &[&str] = &["==", "!=", "<", "<=", ">", ">="];
const LOGIC: &[&str] = &["&&", "||"];
const ASSIGNMENTS: &[&str] = &["+=", "-=", "*=", "/=", "%="];
const BIT_ASSIGNMENTS: &[&str] = &["&=", "|=", "^="];
const SHIFT_ASSIGNMENTS: &[&str] = &["<<=", ">>="];

/// The kind of an operator, and the operators that can replace it.
pub fn operators(op: &BinOp) -> (Kind, &'static [&'static str]) {
    match op {
        BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_) => {
            (Kind::Arithmetic, ARITHMETIC)
        }
        BinOp::BitAnd(_) | BinOp::BitOr(_) | BinOp::BitXor(_) => (Kind::Arithmetic, BITS),
        BinOp::Shl(_) | BinOp::Shr(_) => (Kind::Arithmetic, SHIFTS),
        BinOp::And(_) | BinOp::Or(_) => (Kind::Logic, LOGIC),
        BinOp::AddAssign(_)
        | BinOp::SubAssign(_)
        | BinOp::MulAssign(_)
        | BinOp::DivAssign(_)
        | BinOp::RemAssign(_) => (Kind::Assignment, ASSIGNMENTS),
        BinOp::BitAndAssign(_) | BinOp::BitOrAssign(_) | BinOp::BitXorAssign(_) => {
            (Kind::Assignment, BIT_ASSIGNMENTS)
        }
        BinOp::ShlAssign(_) | BinOp::ShrAssign(_) => (Kind::Assignment, SHIFT_ASSIGNMENTS),
        _ => (Kind::Comparison, COMPARISONS),
    }
}

/// Values of the return type of a function, if the type is understood. `text` is the source, `owner` the type that
/// `Self` stands for.
pub fn results(output: &ReturnType, text: &str, owner: Option<&Type>) -> Vec<String> {
    match output {
        ReturnType::Default => vec!["()".to_owned()],
        ReturnType::Type(_, ty) => values(ty, text, owner),
    }
}

fn values(ty: &Type, text: &str, owner: Option<&Type>) -> Vec<String> {
    match ty {
        Type::Tuple(tuple) if tuple.elems.is_empty() => vec!["()".to_owned()],
        Type::Tuple(tuple) => {
            let parts: Vec<_> = tuple
                .elems
                .iter()
                .map(|one| values(one, text, owner))
                .collect();
            let most = match parts.iter().any(Vec::is_empty) {
                true => 0,
                false => parts.iter().map(Vec::len).max().unwrap_or(0),
            };
            let nth = |n: usize| {
                let values = parts
                    .iter()
                    .map(|part| part[n.min(part.len() - 1)].as_str());
                format!("({})", values.collect::<Vec<_>>().join(", "))
            };
            (0..most).map(nth).collect()
        }
        Type::Array(array) => {
            let length = &text[array.len.span().byte_range()];
            let of = |value: String| format!("[{value}; {length}]");
            let elements = values(&array.elem, text, owner);
            elements.into_iter().map(of).collect()
        }
        Type::Path(path) => match path.path.segments.last() {
            Some(last) => named(&last.ident.to_string(), &last.arguments, text, owner),
            None => Vec::new(),
        },
        _ => Vec::new(),
    }
}

fn named(name: &str, given: &PathArguments, text: &str, owner: Option<&Type>) -> Vec<String> {
    let all = |list: &[&str]| list.iter().map(|one| (*one).to_owned()).collect();
    let inner = || match first_type(given) {
        Some(ty) => values(ty, text, owner),
        None => Vec::new(),
    };
    match name {
        "bool" => all(&["true", "false"]),
        "f64" | "f32" => all(&["0.0", "1.0"]),
        "S" => all(&["S::zero()", "S::from_f64(1.0)"]),
        "u8" | "u16" | "u32" | "u64" | "u128" | "usize" | "i8" | "i16" | "i32" | "i64" | "i128"
        | "isize" => all(&["0", "1"]),
        "Self" => match owner {
            Some(Type::Path(path)) if path.path.is_ident("f64") => all(&["0.0", "1.0"]),
            _ => all(&["Default::default()"]),
        },
        "Option" => {
            let some = inner().into_iter().map(|value| format!("Some({value})"));
            std::iter::once("None".to_owned()).chain(some).collect()
        }
        "Result" => {
            let ok = inner().into_iter().map(|value| format!("Ok({value})"));
            ok.collect()
        }
        "Vec" => {
            let one = inner().into_iter().map(|value| format!("vec![{value}]"));
            std::iter::once("Vec::new()".to_owned())
                .chain(one)
                .collect()
        }
        _ => all(&["Default::default()"]),
    }
}

fn first_type(given: &PathArguments) -> Option<&Type> {
    let PathArguments::AngleBracketed(list) = given else {
        return None;
    };
    list.args.iter().find_map(|argument| match argument {
        GenericArgument::Type(ty) => Some(ty),
        _ => None,
    })
}
