//! Dotted keys of a table, with indices of arrays as names of digits: `particles.0.position.1`.

use toml::{Table, Value};

/// The value of a key.
fn value<'a>(table: &'a mut Table, key: &str) -> Option<&'a mut Value> {
    let (first, rest) = split_first(key);
    rest.into_iter()
        .flat_map(|rest| rest.split('.'))
        .try_fold(table.get_mut(first)?, inner)
}

/// What a table or an array has under a name or an index.
fn inner<'a>(node: &'a mut Value, name: &str) -> Option<&'a mut Value> {
    match node {
        Value::Table(table) => table.get_mut(name),
        Value::Array(array) => array.get_mut(name.parse::<usize>().ok()?),
        _ => None,
    }
}

fn split_first(key: &str) -> (&str, Option<&str>) {
    match key.split_once('.') {
        Some((first, rest)) => (first, Some(rest)),
        None => (key, None),
    }
}

/// Whether there is a key.
pub fn has(table: &Table, key: &str) -> bool {
    let (first, rest) = split_first(key);
    match (table.get(first), rest) {
        (Some(Value::Table(inner)), Some(rest)) => has(inner, rest),
        (found, None) => found.is_some(),
        _ => false,
    }
}

/// Set or add a key and the tables on the way to it; false where something else stands in the way.
pub fn set(table: &mut Table, key: &str, new: Value) -> bool {
    if let Some(value) = value(table, key) {
        *value = new;
        return true;
    }
    let (first, rest) = split_first(key);
    let Some(rest) = rest else {
        table.insert(first.to_owned(), new);
        return true;
    };
    let next = table
        .entry(first)
        .or_insert_with(|| Value::Table(Table::new()));
    set_inside(next, rest, new)
}

fn set_inside(node: &mut Value, key: &str, new: Value) -> bool {
    match node {
        Value::Table(table) => set(table, key, new),
        Value::Array(array) => {
            let (first, rest) = split_first(key);
            let item = first.parse().ok().and_then(|at: usize| array.get_mut(at));
            match (item, rest) {
                (Some(item), Some(rest)) => set_inside(item, rest, new),
                _ => false,
            }
        }
        _ => false,
    }
}

/// Add an item to an array, which begins with it if there is none; false where something else stands.
pub fn push(table: &mut Table, key: &str, item: Value) -> bool {
    match value(table, key) {
        Some(Value::Array(items)) => {
            items.push(item);
            true
        }
        Some(_) => false,
        None => set(table, key, Value::Array(vec![item])),
    }
}

/// Replace the value of a key; false if there is no such key.
pub fn replace(table: &mut Table, key: &str, new: Value) -> bool {
    value(table, key).is_some_and(|value| {
        *value = new;
        true
    })
}

/// Remove a key of a table; false if there is no such key.
pub fn remove(table: &mut Table, key: &str) -> bool {
    let Some((parent, name)) = key.rsplit_once('.') else {
        return table.remove(key).is_some();
    };
    match value(table, parent) {
        Some(Value::Table(inner)) => inner.remove(name).is_some(),
        _ => false,
    }
}

/// Add all keys of another table, and the items of its arrays after those that there are; the name of a key
/// that both have is the error.
pub fn join(table: &mut Table, other: &Table) -> Result<(), String> {
    for (key, new) in other {
        match (table.get_mut(key), new) {
            (None, new) => {
                table.insert(key.clone(), new.clone());
            }
            (Some(Value::Table(inner)), Value::Table(new)) => {
                join(inner, new).map_err(|rest| format!("{key}.{rest}"))?;
            }
            (Some(Value::Array(array)), Value::Array(new))
                if array.iter().chain(new).all(Value::is_table) =>
            {
                array.extend(new.iter().cloned());
            }
            _ => return Err(key.clone()),
        }
    }
    Ok(())
}
