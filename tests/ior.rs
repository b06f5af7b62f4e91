//! The indices of refraction of the named materials against the tables that they name.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test stops at what it did not expect"
)]

use brdf_explorer::bxdf::Component;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::math::frame::direction_from_degrees;
use brdf_explorer::bxdf::models;
use brdf_explorer::bxdf::param::Value;
use brdf_explorer::lab::spectral::{
    self, Constants, FINEST, MATCHED_DEG, agrees, colour, rgb_weights,
};

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

/// The relevant parameter `name` of `component`.
fn value(component: &Component, name: &str) -> Option<Value> {
    let params = component.params();
    let mut named = params.iter();
    named
        .find(|(spec, _)| spec.name == name && params.is_relevant(spec))
        .map(|(_, value)| value)
}

/// n and k of the channels of a metal.
fn metal(component: &Component) -> Option<[[f64; 3]; 2]> {
    match (value(component, "eta")?, value(component, "k")?) {
        (Value::Rgb(eta), Value::Rgb(k)) => Some([eta, k]),
        _ => None,
    }
}

/// Whether the indices of `component` are those of `table`; `None` where it has none.
fn follows(component: &Component, table: &Constants) -> Option<bool> {
    if let Some([eta, k]) = metal(component) {
        return Some(table.gives(eta, k));
    }
    match value(component, "eta")? {
        Value::Number(eta) => {
            let [n, _] = table.at(SODIUM_NM);
            Some(agrees(eta, n))
        }
        _ => None,
    }
}

/// The indices that a file should have for the channels of `table`, as its lines.
fn lines(table: &Constants) -> String {
    let channels = table.channels();
    let line = |name: &str, part: usize| {
        let digits = channels.map(|index| format!("{:.3e}", index[part]).parse::<f64>().unwrap());
        format!("{name} = {digits:?}")
    };
    format!("{}\n{}", line("eta", 0), line("k", 1))
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
            let expected: Vec<String> = tables.iter().map(|table| lines(table)).collect();
            assert!(
                found.is_empty() || found.contains(&true),
                "{}: {component}, of a metal\n{}",
                named.id,
                expected.join("\nor\n")
            );
        }
        assert!(has_index, "{} names a table and has no index", named.id);
        checked += 1;
    }
    assert!(checked > 0, "no material names a table");
}

/// What a smooth surface with these indices reflects, by the model of a mirror.
fn reflected([eta, k]: [[f64; 3]; 2], theta_deg: f64) -> [f64; 3] {
    let text = |[r, g, b]: [f64; 3]| format!("{r}/{g}/{b}");
    let mirror: Component = format!(
        "specular_reflection:fresnel=conductor,eta={},k={}",
        text(eta),
        text(k)
    )
    .parse()
    .unwrap();
    let w = direction_from_degrees(theta_deg, 0.0);
    let [delta, _] = mirror.build::<f64>().deltas(w.into());
    delta.unwrap().flux.0
}

/// The colour of `table`'s spectrum, by that mirror at three wavelengths after three.
fn seen(table: &Constants, theta_deg: f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (nm, weights) in rgb_weights(FINEST) {
        let [n, k] = table.at(nm);
        let [flux, ..] = reflected([[n; 3], [k; 3]], theta_deg);
        for (sum, weight) in sum.iter_mut().zip(weights) {
            *sum += flux * weight;
        }
    }
    sum
}

#[test]
fn named_metals_look_like_their_spectra() {
    let mut checked = Vec::new();
    for named in library::all() {
        for table in tables(&named.material.source) {
            let Some(indices) = named.material.components().iter().find_map(metal) else {
                continue;
            };
            let mut is_held = false;
            for theta_deg in MATCHED_DEG {
                let wanted = seen(table, theta_deg);
                let computed = colour(table, theta_deg);
                let found = reflected(indices, theta_deg);
                for (channel, wanted) in wanted.into_iter().enumerate() {
                    assert!((wanted - computed[channel]).abs() < 1e-12, "{}", named.id);
                    is_held |= wanted > 1.0;
                    // Where all is reflected at 0 degrees, it is at 82.
                    let held = if is_held && channel == 0 { 1.0 } else { wanted };
                    // Four digits of n and k, and the silicon that dips a hair less than any index of its colour.
                    assert!(
                        (found[channel] - held).abs() < 5e-4,
                        "{} at {theta_deg} degrees, channel {channel}: {} for {held}",
                        named.id,
                        found[channel]
                    );
                }
            }
            let says_so = named.material.source.contains("held at 1");
            assert_eq!(says_so, is_held, "{}", named.id);
            checked.push(table.id);
        }
    }
    for id in ["gold", "copper", "brass", "silver", "aluminium", "iron"] {
        assert!(checked.contains(&id), "{id}");
    }
}

#[test]
fn a_metal_is_gold_by_default() {
    let gold = spectral::find("gold").unwrap();
    for model in models::MODELS {
        let component = Component::of(model);
        if model.parameters.iter().any(|spec| spec.name == "k")
            && let Some([eta, k]) = metal(&component)
        {
            assert!(gold.gives(eta, k), "{}: {}", model.id, lines(gold));
        }
    }
}
