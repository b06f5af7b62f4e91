//! In which order the parameters of a model stand, and which of them are folded away.

use bxdf::param::{Kind, ParamSet, ParamSpec, Role};

/// How many rows stand there always, and how many rows need no fold.
const ROWS: [usize; 2] = [5, 6];

/// A row of the panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Row {
    /// A parameter.
    One(&'static ParamSpec),
    /// The two parts of the index of refraction of a metal, three channels each.
    Metal([&'static ParamSpec; 2]),
}

impl Row {
    /// The parameters in it.
    pub(super) fn specs(self) -> Vec<&'static ParamSpec> {
        match self {
            Self::One(spec) => vec![spec],
            Self::Metal(both) => both.to_vec(),
        }
    }

    /// Its place: the form of the lobe and its colour first, what it is made of next, how it is computed last.
    fn rank(self) -> u8 {
        let Self::One(spec) = self else { return 3 };
        match (spec.role, spec.kind) {
            (_, Kind::Data) => 0,
            (Role::WidthS | Role::WidthT | Role::Width, _) => 1,
            (Role::Colour, _) => 2,
            (Role::Index | Role::Absorption, _) => 3,
            (Role::Fresnel, _) => 4,
            (Role::Plain, Kind::Number | Kind::Rgb) => 5,
            (Role::Distribution | Role::Plain, _) => 6,
        }
    }
}

/// The rows that stand there always, and those that a fold hides: all parameters that have an effect at present.
pub(super) fn rows(params: &ParamSet) -> [Vec<Row>; 2] {
    let relevant = params.iter().map(|(spec, _)| spec);
    let relevant: Vec<_> = relevant.filter(|spec| params.is_relevant(spec)).collect();
    let of_channels = |role: Role| {
        let mut all = relevant.iter().copied();
        all.find(|spec| spec.role == role && spec.kind == Kind::Rgb)
    };
    let metal = of_channels(Role::Index).zip(of_channels(Role::Absorption));
    let metal = metal.map(|(index, absorption)| [index, absorption]);
    let is_of_metal = |spec: &&ParamSpec| metal.is_some_and(|both| both.contains(spec));
    let mut rows: Vec<Row> = relevant
        .iter()
        .copied()
        .filter(|spec| !is_of_metal(spec))
        .map(Row::One)
        .chain(metal.map(Row::Metal))
        .collect();
    rows.sort_by_key(|row| row.rank());
    let [always, all] = ROWS;
    let more = if rows.len() > all {
        rows.split_off(always)
    } else {
        Vec::new()
    };
    [rows, more]
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::{Catalogue, Component};

    fn names(text: &str) -> [Vec<&'static str>; 2] {
        let component: Component = text.parse().unwrap();
        rows(component.params()).map(|rows| {
            let specs = rows.into_iter().flat_map(Row::specs);
            specs.map(|spec| spec.name).collect()
        })
    }

    #[test]
    fn roughness_and_colour_stand_first_and_what_is_rare_is_folded() {
        let [first, more] = names("rough_conductor");
        let expected = ["alpha_x", "alpha_y", "eta", "k", "fresnel", "distribution"];
        assert_eq!(first, expected);
        assert_eq!(more, ["masking", "compensation"]);
        let [first, more] = names("principled");
        assert_eq!(first[..2], ["roughness", "base_color"]);
        assert!(more.len() > 3 && more.contains(&"clearcoat"));
        let [first, more] = names("plastic");
        assert_eq!(first[..4], ["alpha_x", "alpha_y", "diffuse", "eta"]);
        assert!(more.contains(&"nonlinear"));
    }

    #[test]
    fn every_parameter_of_effect_has_its_row_and_no_fold_hides_one_alone() {
        for model in Catalogue::current().models() {
            let component = Component::of(model);
            let params = component.params();
            let [first, more] = rows(params);
            assert!(more.len() != 1 && first.len() <= ROWS[1], "{}", model.id);
            let shown = first.into_iter().chain(more).flat_map(Row::specs);
            let mut shown: Vec<&str> = shown.map(|spec| spec.name).collect();
            let relevant = params.iter().filter(|(spec, _)| params.is_relevant(spec));
            let mut expected: Vec<&str> = relevant.map(|(spec, _)| spec.name).collect();
            shown.sort_unstable();
            expected.sort_unstable();
            assert_eq!(shown, expected, "{}", model.id);
        }
    }
}
