//! Where something stands in the text of a session: refusals name the line.

use std::collections::BTreeSet;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::number::Refused;

/// Where the text has a number that is refused, as a byte: by its name, with the tables around it, and its value.
pub(super) fn start_of(text: &str, number: &Refused) -> Option<usize> {
    let document = DeTable::parse(text).ok()?;
    let name: Vec<&str> = number.name.split('.').collect();
    let find = |name: &[&str]| in_table(document.get_ref(), &mut Vec::new(), (name, number.value));
    // The table of a view in the layout has the name of its kind within.
    let within_a_view = name.split_first().filter(|(_, rest)| !rest.is_empty());
    find(&name).or_else(|| find(within_a_view?.1))
}

/// The same in a table whose keys are `path`.
fn in_table<'a>(
    table: &'a DeTable<'_>,
    path: &mut Vec<&'a str>,
    sought: (&[&str], f64),
) -> Option<usize> {
    table.iter().find_map(|(key, value)| {
        path.push(key.get_ref());
        let found = in_value(value, path, sought);
        path.pop();
        found
    })
}

fn in_value<'a>(
    value: &'a Spanned<DeValue<'_>>,
    path: &mut Vec<&'a str>,
    (name, number): (&[&str], f64),
) -> Option<usize> {
    let written = match value.get_ref() {
        DeValue::Table(table) => return in_table(table, path, (name, number)),
        DeValue::Array(values) => {
            let mut values = values.iter();
            return values.find_map(|value| in_value(value, path, (name, number)));
        }
        DeValue::Integer(written) => written.as_str(),
        DeValue::Float(written) => written.as_str(),
        _ => return None,
    };
    let read: f64 = written.parse().ok()?;
    let is_it = read == number || read.is_nan() && number.is_nan();
    (path.ends_with(name) && is_it).then(|| value.span().start)
}

/// The keys of a material that no other one may have the value of.
const UNIQUE: [&str; 2] = ["id", "slot"];

/// The first of the materials that claims what one before it has: where the text says so, as a byte, and what.
pub(super) fn repeated(document: &DeTable<'_>) -> Option<(usize, String)> {
    let DeValue::Array(materials) = document.get("materials")?.get_ref() else {
        return None;
    };
    let mut claimed = BTreeSet::new();
    materials.iter().find_map(|material| {
        let DeValue::Table(material) = material.get_ref() else {
            return None;
        };
        UNIQUE.iter().find_map(|key| {
            let value = material.get(*key)?;
            let DeValue::Integer(number) = value.get_ref() else {
                return None;
            };
            let is_new = claimed.insert((*key, number.as_str().to_owned()));
            let problem = || {
                format!(
                    "{key} = {}: a material before it has the same",
                    number.as_str()
                )
            };
            (!is_new).then(|| (value.span().start, problem()))
        })
    })
}
