//! Materials written as TOML text.

use super::{Component, Material, WEIGHT};
use crate::param::{self, Kind};
use crate::resource::Resource;

/// The keys that describe a material and do not change it, in the order in which they are printed.
pub(super) const DESCRIPTIONS: [&str; 3] = ["name", "note", "source"];

/// `material` as TOML text, which [`parse`](super::file::parse) reads back as the same.
#[must_use]
pub fn print(material: &Material) -> String {
    table(material).to_string()
}

/// `material` as a TOML table; parameters that have their default are left out.
pub(super) fn table(material: &Material) -> toml::Table {
    let mut table = toml::Table::new();
    let descriptions = [&material.name, &material.note, &material.source];
    for (key, text) in DESCRIPTIONS.into_iter().zip(descriptions) {
        if !text.is_empty() {
            table.insert(key.to_owned(), text.clone().into());
        }
    }
    let lobes = material.components().iter().map(lobe_table);
    table.insert("lobes".to_owned(), toml::Value::Array(lobes.collect()));
    table
}

fn lobe_table(component: &Component) -> toml::Value {
    let mut table = toml::Table::new();
    table.insert("model".to_owned(), component.model().id.into());
    if component.weight() != 1.0 {
        table.insert(WEIGHT.name.to_owned(), component.weight().into());
    }
    for (spec, value) in component.params().iter() {
        if value != spec.default {
            let resource = component.params().resource(spec.name);
            let value = resource.map_or_else(|| toml_value(spec.kind, value), Resource::to_toml);
            table.insert(spec.name.to_owned(), value);
        }
    }
    table.into()
}

fn toml_value(kind: Kind, value: param::Value) -> toml::Value {
    match value {
        param::Value::Number(number) => number.into(),
        param::Value::Rgb([r, g, b]) if kind == Kind::Rgb && r == g && g == b => r.into(),
        param::Value::Rgb(rgb) => rgb.to_vec().into(),
        param::Value::Choice(word) => word.into(),
        param::Value::Bool(flag) | param::Value::Data(flag) => flag.into(),
    }
}
