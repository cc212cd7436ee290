//! Declarations of the kernel: types of fields and names of constants.

use std::collections::{HashMap, HashSet};
use syn::{Fields, GenericArgument, GenericParam, Generics, Item, PathArguments, Type, Visibility};

/// Name of arrays and slices.
const LIST: &str = "[]";

/// The part of a type that determines whether its values can be scaled.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Last segment of the path of the type; `[]` for arrays and slices.
    pub name: String,
    /// Type of the elements of a list.
    pub element: Option<Box<Shape>>,
}

impl Shape {
    /// A named type without elements.
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            element: None,
        }
    }

    /// The shape of a type as written.
    pub fn of(ty: &Type) -> Self {
        match ty {
            Type::Reference(inner) => Self::of(&inner.elem),
            Type::Array(array) => Self::list(&array.elem),
            Type::Slice(slice) => Self::list(&slice.elem),
            Type::Path(path) => match path.path.segments.last() {
                Some(last) => Self {
                    name: last.ident.to_string(),
                    element: first_argument(&last.arguments).map(|ty| Box::new(Self::of(ty))),
                },
                None => Self::named(""),
            },
            _ => Self::named(""),
        }
    }

    /// The shape with the defaults of generic parameters in place of these.
    fn with_defaults(mut self, generics: &Generics) -> Self {
        for parameter in &generics.params {
            if let GenericParam::Type(parameter) = parameter
                && let Some(default) = &parameter.default
                && parameter.ident == self.name
            {
                return Self::of(default);
            }
        }
        let element = self.element.take();
        self.element = element.map(|one| Box::new(one.with_defaults(generics)));
        self
    }

    fn list(element: &Type) -> Self {
        Self {
            name: LIST.to_owned(),
            element: Some(Box::new(Self::of(element))),
        }
    }

    /// Whether it is a plain double.
    pub fn is_double(&self) -> bool {
        self.name == "f64"
    }

    /// Whether it is a double that may be absent.
    pub fn is_optional_double(&self) -> bool {
        self.name == "Option" && self.element.as_ref().is_some_and(|one| one.is_double())
    }

    /// Whether it is a real number: a double or the generic scalar of the kernel.
    pub fn is_real(&self) -> bool {
        self.is_double() || self.name == "S"
    }
}

fn first_argument(arguments: &PathArguments) -> Option<&Type> {
    let PathArguments::AngleBracketed(list) = arguments else {
        return None;
    };
    list.args.iter().find_map(|argument| match argument {
        GenericArgument::Type(ty) => Some(ty),
        _ => None,
    })
}

/// Type of each field, by structure and name.
type Structures = HashMap<String, HashMap<String, Shape>>;

/// Fields and constants of all files.
#[derive(Debug, Default)]
pub struct Declared {
    /// Structures of the kernel.
    fields: Structures,
    /// Structures outside the kernel, with the default parameters of generic ones.
    foundations: Structures,
    /// Constants that are a number or a list of numbers.
    pub constants: HashSet<String>,
    /// Public constants that are numbers.
    pub exported: HashSet<String>,
    /// Whether reads of optional numbers are sites.
    pub counts_optional: bool,
}

/// Constants of the standard library that appear in formulas.
const STANDARD: [&str; 3] = ["PI", "TAU", "SQRT_2"];

impl Declared {
    /// All declarations of the files.
    pub fn in_files<'a>(files: impl Iterator<Item = &'a syn::File>) -> Self {
        let mut all = Self::default();
        all.constants.extend(STANDARD.map(str::to_owned));
        for item in files.flat_map(|file| &file.items) {
            all.add(item, true);
        }
        all
    }

    /// Add the declarations of files outside the kernel, whose generic types the kernel uses with their default
    /// parameters.
    pub fn add_foundations<'a>(&mut self, files: impl Iterator<Item = &'a syn::File>) {
        for item in files.flat_map(|file| &file.items) {
            self.add(item, false);
        }
    }

    fn add(&mut self, item: &Item, is_own: bool) {
        match item {
            Item::Struct(item) => {
                let name = item.ident.to_string();
                if let Fields::Named(fields) = &item.fields {
                    let of = |field: &syn::Field| {
                        let name = field.ident.as_ref()?.to_string();
                        let shape = Shape::of(&field.ty);
                        let shape = match is_own {
                            true => shape,
                            false => shape.with_defaults(&item.generics),
                        };
                        Some((name, shape))
                    };
                    let fields = fields.named.iter().filter_map(of).collect();
                    let all = match is_own {
                        true => &mut self.fields,
                        false => &mut self.foundations,
                    };
                    all.insert(name, fields);
                }
            }
            Item::Const(item) => self.add_constant(&item.vis, &item.ident, &item.ty),
            Item::Impl(item) => {
                for item in &item.items {
                    if let syn::ImplItem::Const(item) = item {
                        self.add_constant(&item.vis, &item.ident, &item.ty);
                    }
                }
            }
            _ => {}
        }
    }

    fn add_constant(&mut self, visibility: &Visibility, name: &syn::Ident, ty: &Type) {
        let shape = Shape::of(ty);
        let of_doubles = shape.element.as_ref().is_some_and(|one| one.is_double());
        let is_list = of_doubles && shape.name == LIST;
        if shape.is_double() || is_list {
            self.constants.insert(name.to_string());
        }
        if shape.is_double() && matches!(visibility, Visibility::Public(_)) {
            self.exported.insert(name.to_string());
        }
    }

    /// Type of a field. If the structure is not known: the type of the field of this name in all structures of the
    /// kernel, or else in all others, if these agree.
    pub fn field(&self, owner: Option<&Shape>, name: &str) -> Option<&Shape> {
        let known = owner.and_then(|owner| {
            let own = self.fields.get(&owner.name);
            own.or_else(|| self.foundations.get(&owner.name))
        });
        if let Some(fields) = known {
            return fields.get(name);
        }
        let is_own = self.fields.values().any(|fields| fields.contains_key(name));
        let all = if is_own {
            &self.fields
        } else {
            &self.foundations
        };
        let mut found = all.values().filter_map(|fields| fields.get(name));
        let first = found.next()?;
        found.all(|other| other == first).then_some(first)
    }

    /// Whether a field of this name can be a list of real numbers: one is, or none is declared.
    pub fn can_hold_reals(&self, name: &str) -> bool {
        let is_real = |shape: &Shape| shape.element.as_ref().is_some_and(|one| one.is_real());
        let mut found = self
            .fields
            .values()
            .filter_map(|fields| fields.get(name))
            .peekable();
        found.peek().is_none() || found.any(is_real)
    }
}
