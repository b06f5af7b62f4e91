//! Where the laws are checked: a curated sweep of parameters, and the directions.

use glam::DVec3;

use bxdf::ModelSpec;
use bxdf::math::frame::direction_from_degrees;
use bxdf::param::{Kind, ParamSet, ParamSpec, Role, Value};

/// Widths along s and t: 0, for models that take it for smooth, both ends of the range, the end of the slider, two blades.
const ALPHA_PAIRS: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [1e-4, 1e-4],
    [0.01, 0.01],
    [1.0, 1.0],
    [0.05, 0.5],
    [1e-4, 1.0],
];

/// The given directions of the statistical laws: normal, oblique, 85 and 89.9 degrees, and two below the surface; the
/// azimuths are no multiples of a symmetry.
#[must_use]
pub fn directions() -> Vec<DVec3> {
    [
        (0.0, 0.0),
        (35.0, 20.0),
        (60.0, 130.0),
        (85.0, -75.0),
        (89.9, 200.0),
        (150.0, 45.0),
        (95.0, -160.0),
    ]
    .map(|(theta_deg, phi_deg)| direction_from_degrees(theta_deg, phi_deg))
    .to_vec()
}

/// The parameters a model is checked at: its defaults; all colours 0; all colours 1 with every word of every choice; and
/// with each of those words the ends of every number's ranges and the widths of `ALPHA_PAIRS`.
///
/// Combinations that the model refuses are left out, and those that differ only in a parameter without effect.
#[must_use]
pub fn parameter_sets(model: &ModelSpec) -> Vec<ParamSet> {
    let mut sets = Sets::of(model);
    let defaults = model.defaults();
    sets.add(Some(defaults.clone()));
    sets.add(with_colours(&defaults, 0.0));
    for base in bases(model) {
        for spec in model.parameters {
            for value in ends(spec) {
                if base.is_relevant(spec) {
                    sets.add(base.with(&[(spec.name, value)]));
                }
            }
        }
        for [alpha_x, alpha_y] in ALPHA_PAIRS {
            sets.add(with_widths(&base, alpha_x, alpha_y));
        }
        sets.add(Some(base));
    }
    sets.found
}

/// The defaults with all colours 1, and that with every word of every choice.
pub(crate) fn bases(model: &ModelSpec) -> Vec<ParamSet> {
    let Some(white) = with_colours(&model.defaults(), 1.0) else {
        return Vec::new();
    };
    let mut bases = vec![white.clone()];
    for spec in model.parameters {
        let words = spec.choices.iter().map(|word| Value::Choice(word));
        let flags = [false, true].map(Value::Bool);
        let values: Vec<Value> = match spec.kind {
            Kind::Choice => words.collect(),
            Kind::Bool => flags.to_vec(),
            Kind::Number | Kind::Rgb | Kind::Data => continue,
        };
        let with_value = |value| white.with(&[(spec.name, value)]);
        bases.extend(values.into_iter().filter_map(with_value));
    }
    bases
}

/// Different sets of one model's parameters, all of them allowed.
pub(crate) struct Sets<'a> {
    model: &'a ModelSpec,
    found: Vec<ParamSet>,
}

impl<'a> Sets<'a> {
    /// None yet.
    pub(crate) fn of(model: &'a ModelSpec) -> Self {
        Self {
            model,
            found: Vec::new(),
        }
    }

    /// Adds `set`, unless there is none, the model refuses it, or one that differs only without effect is there already.
    /// Returns what was added.
    pub(crate) fn add(&mut self, set: Option<ParamSet>) -> Option<&ParamSet> {
        let mut set = set?;
        let without_effect: Vec<&ParamSpec> = set
            .iter()
            .map(|(spec, _)| spec)
            .filter(|spec| !set.is_relevant(spec))
            .collect();
        for spec in without_effect {
            set.set(spec.name, spec.default).ok()?;
        }
        if (self.model.validate)(&set).is_err() || self.found.contains(&set) {
            return None;
        }
        self.found.push(set);
        self.found.last()
    }
}

/// The ends of the ranges of a number or an index; none for colours (which are 0 and 1 in the bases) and for widths.
pub(crate) fn ends(spec: &ParamSpec) -> Vec<Value> {
    if spec.is_colour() || matches!(spec.role, Role::WidthS | Role::WidthT) {
        return Vec::new();
    }
    let values = [spec.hard, spec.soft].into_iter().flatten();
    match spec.kind {
        Kind::Number => values.map(Value::Number).collect(),
        Kind::Rgb => values.map(|x| Value::Rgb([x; 3])).collect(),
        Kind::Choice | Kind::Bool | Kind::Data => Vec::new(),
    }
}

/// `set` with these widths along s and t; `None` where it has none.
pub(crate) fn with_widths(set: &ParamSet, along_s: f64, along_t: f64) -> Option<ParamSet> {
    let [s, t] = set.widths()?;
    set.with(&[(s, Value::Number(along_s)), (t, Value::Number(along_t))])
}

/// `set` with every colour at `level`.
pub(crate) fn with_colours(set: &ParamSet, level: f64) -> Option<ParamSet> {
    let mut changed = set.clone();
    for (spec, _) in set.iter().filter(|(spec, _)| spec.is_colour()) {
        changed.set(spec.name, Value::Rgb([level; 3])).ok()?;
    }
    Some(changed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Catalogue;

    #[test]
    fn the_sweep_reaches_every_word_and_both_ends() {
        for model in Catalogue::current().models() {
            let sets = parameter_sets(model);
            for spec in model.parameters {
                for word in spec.choices {
                    assert!(
                        sets.iter()
                            .any(|set| set.get(spec.name) == Some(Value::Choice(word))),
                        "{} {word}",
                        model.id
                    );
                }
                if spec.kind == Kind::Number {
                    for end in spec.hard {
                        assert!(
                            sets.iter()
                                .any(|set| set.get(spec.name) == Some(Value::Number(end))),
                            "{} {} {end}",
                            model.id,
                            spec.name
                        );
                    }
                }
            }
        }
        let metal = parameter_sets(Catalogue::current().find("rough_conductor").unwrap());
        assert!(metal.iter().any(|set| set.choice("fresnel") == "one"
            && set.number("alpha_x") == 1e-4
            && set.number("alpha_y") == 1.0));
    }
}
