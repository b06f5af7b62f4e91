//! The indices of refraction of the named materials against the tables that they name.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test stops at what it did not expect"
)]

use std::fs;
use std::path::Path;

use brdf_explorer::bxdf::Component;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::param::Value;

/// Dominant wavelengths of the BT.709 primaries in nm: where a metal's R, G and B are read.
const CHANNELS_NM: [f64; 3] = [611.4, 549.1, 464.2];

/// The sodium line in nm: where the single index of a dielectric is read.
const SODIUM_NM: f64 = 589.3;

/// A table of `assets/ior`: rows of wavelength in nm, n, k, by wavelength.
struct Table(Vec<[f64; 3]>);

impl Table {
    fn read(path: &str) -> Self {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
        let text = fs::read_to_string(&file).unwrap();
        let lines = text
            .lines()
            .filter(|line| !line.starts_with('#') && !line.starts_with("wavelength_nm"));
        let row = |line: &str| {
            let numbers: Vec<f64> = line.split(',').map(|x| x.trim().parse().unwrap()).collect();
            numbers.try_into().unwrap()
        };
        Self(lines.map(row).collect())
    }

    /// n and k at a wavelength, interpolated linearly.
    fn at(&self, nm: f64) -> [f64; 2] {
        let next = self.0.iter().position(|[x, ..]| *x >= nm).unwrap();
        let (Some([x0, n0, k0]), Some([x1, n1, k1])) =
            (self.0.get(next.saturating_sub(1)), self.0.get(next))
        else {
            panic!("{nm} nm lies outside the table");
        };
        let t = if x1 > x0 { (nm - x0) / (x1 - x0) } else { 0.0 };
        [n0 + t * (n1 - n0), k0 + t * (k1 - k0)]
    }
}

/// Whether `given` is `exact` in four significant digits.
fn agrees(given: f64, exact: f64) -> bool {
    let unit = 10_f64.powf(exact.abs().log10().floor() - 3.0);
    // Half a unit of the last digit; the rest is for rounding in this comparison.
    (given - exact).abs() <= 0.5001 * unit
}

/// The tables that `source` names.
fn tables(source: &str) -> Vec<Table> {
    let words = source.split([' ', '(', ')', ',', ';']);
    words
        .filter(|word| word.starts_with("assets/ior/"))
        .map(Table::read)
        .collect()
}

/// Whether the indices of `component` are those of `table`; `None` where it has none.
fn follows(component: &Component, table: &Table) -> Option<bool> {
    let value = |name: &str| {
        let mut named = component.params().iter();
        named
            .find(|(spec, _)| spec.name == name && component.params().is_relevant(spec))
            .map(|(_, value)| value)
    };
    match (value("eta")?, value("k")) {
        (Value::Rgb(eta), Some(Value::Rgb(k))) => {
            let expected = CHANNELS_NM.map(|nm| table.at(nm));
            let given: Vec<[f64; 2]> = eta.into_iter().zip(k).map(|(n, k)| [n, k]).collect();
            let mut pairs = given.iter().flatten().zip(expected.iter().flatten());
            Some(pairs.all(|(given, exact)| agrees(*given, *exact)))
        }
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

#[test]
fn interpolation_meets_its_table() {
    let gold = Table::read("assets/ior/gold.csv");
    let [first, second] = [gold.0[0], gold.0[1]];
    let middle = gold.at(0.5 * (first[0] + second[0]));
    assert!(agrees(middle[0], 0.5 * (first[1] + second[1])));
    assert_eq!(gold.at(second[0]), [second[1], second[2]]);
    assert!(agrees(0.2224, 0.222_449) && !agrees(0.2224, 0.222_46));
}
