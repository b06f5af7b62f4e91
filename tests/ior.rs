//! The indices of refraction of the named materials against the tables that they name.

#![allow(clippy::unwrap_used, reason = "a test stops at what it did not expect")]

use brdf_explorer::bxdf::Component;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::param::Value;
use brdf_explorer::lab::spectral::{self, Constants, agrees};

/// The sodium line in nm: where the single index of a dielectric is read.
const SODIUM_NM: f64 = 589.3;

/// The tables that `source` names.
fn tables(source: &str) -> Vec<&'static Constants> {
    let words = source.split([' ', '(', ')', ',', ';']);
    let paths = words.filter_map(|word| word.strip_prefix("assets/ior/"));
    paths
        .map(|path| spectral::find(path.strip_suffix(".csv").unwrap()).unwrap())
        .collect()
}

/// Whether the indices of `component` are those of `table`; `None` where it has none.
fn follows(component: &Component, table: &Constants) -> Option<bool> {
    let value = |name: &str| {
        let mut named = component.params().iter();
        named
            .find(|(spec, _)| spec.name == name && component.params().is_relevant(spec))
            .map(|(_, value)| value)
    };
    match (value("eta")?, value("k")) {
        (Value::Rgb(eta), Some(Value::Rgb(k))) => Some(table.gives(eta, k)),
        (Value::Number(eta), _) => {
            let [n, _] = table.at(SODIUM_NM);
            Some(agrees(eta, n))
        }
        _ => None,
    }
}

#[test]
fn indices_are_those_of_the_table_named() {
    let mut checked = 0;
    for named in library::all() {
        let tables = tables(&named.material.source);
        if tables.is_empty() {
            continue;
        }
        let mut has_index = false;
        for component in named.material.components() {
            let found: Vec<bool> = tables
                .iter()
                .filter_map(|table| follows(component, table))
                .collect();
            has_index |= !found.is_empty();
            assert!(
                found.is_empty() || found.contains(&true),
                "{}: {component}",
                named.id
            );
        }
        assert!(has_index, "{} names a table and has no index", named.id);
        checked += 1;
    }
    assert!(checked > 0, "no material names a table");
}
