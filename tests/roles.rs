//! What a parameter means is said by its role, not by its name.

#![allow(clippy::unwrap_used, reason = "a test stops at what it did not expect")]

use std::collections::BTreeSet;

use brdf_explorer::bxdf::internals::beyond_range;
use brdf_explorer::bxdf::param::Role;
use brdf_explorer::bxdf::{
    Catalogue, Category, Component, Lobe, Material, ModelSpec, ParamSet, ParamSpec, Precision,
    Properties, Scatterer, Value, builders,
};
use brdf_explorer::lab::stability::map::Axis;
use brdf_explorer::lab::stability::{ExtremeKind, examine};
use brdf_explorer::study::session::Materials;

const fn spread(name: &'static str, role: Role) -> ParamSpec {
    ParamSpec::number(name, 0.3, "How far it spreads")
        .hard(1e-4, 1.0)
        .role(role)
}

const DENSER: ParamSpec = ParamSpec::number("denser", 1.5, "Index of refraction")
    .hard(0.25, 1000.0)
    .role(Role::Index);

/// A rough dielectric whose parameters have other names than anywhere else.
static RIPPLED: ModelSpec = ModelSpec {
    id: "rippled",
    title: "Rippled",
    source: "this test",
    summary: "None",
    lobes: &[
        Lobe::reflection(Category::GlossySpecular),
        Lobe::transmission(Category::GlossySpecular),
    ],
    parameters: &[
        spread("sigma_u", Role::WidthS),
        spread("sigma_v", Role::WidthT),
        DENSER,
    ],
    properties: Properties {
        relative_index: |params| params.number("denser"),
        ..Properties::TWO_WIDTHS
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[],
};

fn build<R: Precision>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let usual = Catalogue::current().find("rough_dielectric").unwrap();
    let names = [
        ("alpha_x", "sigma_u"),
        ("alpha_y", "sigma_v"),
        ("eta", "denser"),
    ];
    let inner = names
        .into_iter()
        .fold(usual.defaults(), |set, (name, own)| {
            // Extremes go beyond the range of widths.
            beyond_range(&set, name, params.number(own)).unwrap()
        });
    usual.build(&inner)
}

/// Extremes looked at in a model, one in so many of its sets of parameters.
fn extremes(model: &ModelSpec) -> BTreeSet<ExtremeKind> {
    let all = examine(model, 1, 0);
    all.into_iter().map(|extreme| extreme.case).collect()
}

#[test]
fn a_model_with_unusual_names_has_the_extremes_of_its_kind() {
    let found = extremes(&RIPPLED);
    for case in [
        ExtremeKind::Narrow,
        ExtremeKind::Anisotropic,
        ExtremeKind::IndexNearOne,
        ExtremeKind::LargeIndex,
        ExtremeKind::Core,
    ] {
        assert!(found.contains(&case), "{case:?}");
    }
    // It is their roles that tell, not that they are numbers.
    let plain = ModelSpec {
        parameters: const {
            &[
                spread("sigma_u", Role::Plain),
                spread("sigma_v", Role::Plain),
                DENSER.role(Role::Plain),
            ]
        },
        ..RIPPLED
    };
    let found = extremes(&plain);
    for kind in [
        ExtremeKind::Narrow,
        ExtremeKind::Anisotropic,
        ExtremeKind::IndexNearOne,
    ] {
        assert!(!found.contains(&kind), "{kind:?}");
    }
}

#[test]
fn a_model_with_unusual_names_has_the_axes_of_its_kind() {
    let ids = |material: &Material| -> Vec<String> {
        let axes = Axis::all(material);
        axes.iter()
            .map(Axis::id)
            .filter(|id| !id.contains("alpha_"))
            .collect()
    };
    let own = ids(&Material::of(&RIPPLED));
    for id in ["alpha", "anisotropy", "eta less 1"] {
        assert!(own.iter().any(|own| own == id), "{own:?}");
    }
}

#[test]
fn unusual_widths_are_linked_and_set_together() {
    let mut materials = Materials::new(vec![Material::of(&RIPPLED)]).unwrap();
    assert!(materials.selected().has_linked_widths);
    let before = materials.selected().clone();
    let mut component = Component::of(&RIPPLED);
    component.set("sigma_v", Value::Number(0.7)).unwrap();
    materials.selected_mut().material = Material::new(vec![component.clone()]).unwrap();
    materials.follow(&before, &BTreeSet::new());
    let text = materials.selected().material.to_string();
    assert_eq!(text, "rippled:sigma_u=0.7,sigma_v=0.7");
    assert!(!component.is_isotropic());
    // Both go by what their names begin with.
    component.set_text("sigma", "0.2").unwrap();
    assert_eq!(component.params().number("sigma_u"), 0.2);
    assert!(component.is_isotropic());
}
