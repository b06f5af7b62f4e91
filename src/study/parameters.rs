//! What parameters are called at the screen, by what they mean.

use bxdf::Material;
use bxdf::param::{Kind, ParamSpec, Role};

/// The names of the channels.
pub const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// What a parameter is called: by its role, with the symbol of its model where that is another word.
#[must_use]
pub fn label(spec: &ParamSpec) -> String {
    let own = spec.label();
    let with_symbol = |word: &str| {
        let symbol = spec.name.split('_').next().unwrap_or_default();
        if word.to_lowercase().starts_with(symbol) {
            word.to_owned()
        } else {
            format!("{word} ({symbol})")
        }
    };
    match (spec.role, spec.kind) {
        (Role::WidthS, _) => with_symbol("Roughness along s"),
        (Role::WidthT, _) => with_symbol("Roughness along t"),
        (Role::Width, _) => with_symbol("Roughness"),
        (Role::Index, Kind::Number) => with_symbol("Index of refraction"),
        (Role::Index, _) => "n".to_owned(),
        (Role::Absorption, _) => "k".to_owned(),
        _ => own,
    }
}

/// What the fields of a parameter are called, one after the other.
#[must_use]
pub fn labels(spec: &ParamSpec) -> Vec<String> {
    match spec.kind {
        Kind::Number => vec![label(spec)],
        Kind::Rgb => CHANNELS
            .map(|letter| format!("{} {letter}", label(spec)))
            .to_vec(),
        Kind::Choice | Kind::Bool | Kind::Data => Vec::new(),
    }
}

/// The parameters that differ in two materials of the same models.
#[must_use]
pub fn changed(a: &Material, b: &Material) -> Vec<&'static ParamSpec> {
    let pairs = a.components().iter().zip(b.components());
    let of_pairs = pairs.filter(|(a, b)| a.model().id == b.model().id);
    of_pairs
        .flat_map(|(a, b)| {
            let is_other = move |spec: &&ParamSpec| {
                a.params().get(spec.name) != b.params().get(spec.name)
                    || a.params().resource(spec.name) != b.params().resource(spec.name)
            };
            a.model().parameters.iter().filter(is_other)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Catalogue;

    #[test]
    fn parameters_are_called_by_what_they_mean() {
        let of = |model: &str, name: &str| {
            let model = Catalogue::current().find(model).unwrap();
            let mut specs = model.parameters.iter();
            label(specs.find(|spec| spec.name == name).unwrap())
        };
        for (model, name, expected) in [
            ("rough_conductor", "alpha_x", "Roughness along s (alpha)"),
            ("cook_torrance", "m", "Roughness (m)"),
            ("principled", "roughness", "Roughness"),
            ("rough_conductor", "eta", "n"),
            ("rough_conductor", "k", "k"),
            ("rough_dielectric", "eta", "Index of refraction (eta)"),
            ("oren_nayar", "sigma", "Sigma"),
        ] {
            assert_eq!(of(model, name), expected, "{model} {name}");
        }
    }

    /// Two controls of one model never have the same name.
    #[test]
    fn no_two_parameters_of_a_model_are_called_the_same() {
        for model in Catalogue::current().models() {
            let mut all: Vec<String> = model.parameters.iter().map(label).collect();
            all.sort();
            assert!(all.windows(2).all(|pair| pair[0] != pair[1]), "{all:?}");
        }
    }
}
