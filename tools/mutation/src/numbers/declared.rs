//! Declarations of the kernel: types of fields and names of constants.

use std::collections::{HashMap, HashSet};
use syn::{Fields, GenericArgument, Item, PathArguments, Type, Visibility};

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

    fn list(element: &Type) -> Self {
        Self {
            name: "[]".to_owned(),
            element: Some(Box::new(Self::of(element))),
        }
    }

    /// Whether it is a plain double.
    pub fn is_double(&self) -> bool {
        self.name == "f64"
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

/// Fields and constants of all files.
#[derive(Debug, Default)]
pub struct Declared {
    /// Type of each field, by structure and name.
    fields: HashMap<String, HashMap<String, Shape>>,
    /// Constants that are a number or a list of numbers.
    pub constants: HashSet<String>,
    /// Public constants that are numbers.
    pub exported: HashSet<String>,
}

/// Constants of the standard library that appear in formulas.
const STANDARD: [&str; 3] = ["PI", "TAU", "SQRT_2"];

impl Declared {
    /// All declarations of the files.
    pub fn in_files<'a>(files: impl Iterator<Item = &'a syn::File>) -> Self {
        let mut all = Self::default();
        all.constants.extend(STANDARD.map(str::to_owned));
        for item in files.flat_map(|file| &file.items) {
            all.add(item);
        }
        all
    }

    fn add(&mut self, item: &Item) {
        match item {
            Item::Struct(item) => {
                let name = item.ident.to_string();
                if let Fields::Named(fields) = &item.fields {
                    let of = |field: &syn::Field| {
                        let name = field.ident.as_ref()?.to_string();
                        Some((name, Shape::of(&field.ty)))
                    };
                    let fields = fields.named.iter().filter_map(of).collect();
                    self.fields.insert(name, fields);
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
        let is_list = shape.element.as_ref().is_some_and(|one| one.is_double());
        if shape.is_double() || is_list {
            self.constants.insert(name.to_string());
        }
        if shape.is_double() && matches!(visibility, Visibility::Public(_)) {
            self.exported.insert(name.to_string());
        }
    }

    /// Type of a field. If the structure is not known: the type of the field of this name in all structures, if these
    /// agree.
    pub fn field(&self, owner: Option<&Shape>, name: &str) -> Option<&Shape> {
        if let Some(fields) = owner.and_then(|owner| self.fields.get(&owner.name)) {
            return fields.get(name);
        }
        let mut found = self.fields.values().filter_map(|fields| fields.get(name));
        let first = found.next()?;
        found.all(|other| other == first).then_some(first)
    }
}
