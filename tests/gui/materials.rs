//! The gestures on named materials and their lobes, by accessible label.

use brdf_explorer::bxdf::Material;
use brdf_explorer::ui::app::App;
use egui::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{material, window};

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

/// Adds a glossy lobe of the model with this title.
fn add_lobe(harness: &mut Harness<'_, App>, title: &str) {
    click(harness, "Add a lobe…");
    for label in ["Glossy specular", title] {
        harness.get_by_role_and_label(Role::Button, label).click();
        harness.run();
    }
}

fn shown<'a>(harness: &'a Harness<'_, App>) -> &'a Material {
    &harness.state().session.material
}

#[test]
fn a_named_material_is_searched_and_chosen() {
    let mut harness = window("rough_conductor");
    assert!(harness.query_by_label("Brass").is_none());
    click(&mut harness, "Materials");
    harness.get_by_label("Search materials").click();
    harness
        .get_by_label("Search materials")
        .type_text("swallows blue");
    harness.run();
    assert!(harness.query_by_label("Brass").is_none());
    click(&mut harness, "Gold");
    assert_eq!(*shown(&harness), material("gold"));
    // Its parameters are on the screen, and the model is one of the other list.
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Alpha x")
            .is_some()
    );
    click(&mut harness, "Models");
    assert!(
        harness
            .query_by_label_contains("No model has this name")
            .is_some()
    );
}

#[test]
fn search_covers_name_category_and_model() {
    for (wanted, expected, other) in [
        ("brass", "Brass", "Gold"),
        ("retro", "Road sign", "Gold"),
        ("rough_conductor", "Gold", "Road sign"),
    ] {
        let mut harness = window("gold");
        harness.get_by_label("Search materials").click();
        harness.get_by_label("Search materials").type_text(wanted);
        harness.run();
        let listed = |label| {
            harness
                .query_all_by_role_and_label(Role::Button, label)
                .count()
        };
        assert_eq!((listed(expected), listed(other)), (1, 0), "{wanted}");
    }
}

#[test]
fn the_edits_of_a_named_material_are_kept_and_reset() {
    let mut harness = window("gold");
    let alpha =
        |harness: &Harness<'_, App>| shown(harness).components()[0].params().number("alpha_x");
    harness
        .get_by_role_and_label(Role::Slider, "Alpha x")
        .set_value_accesskit(0.5);
    harness.run();
    assert_eq!(
        (alpha(&harness), shown(&harness).name.as_str()),
        (0.5, "Gold")
    );
    click(&mut harness, "Glossy red plastic");
    assert_eq!(*shown(&harness), material("plastic_glossy_red"));
    harness.get_by_role_and_label(Role::Button, "Gold").click();
    harness.run();
    assert_eq!(alpha(&harness), 0.5);
    click(&mut harness, "Reset Gold");
    assert_eq!(*shown(&harness), material("gold"));
}

#[test]
fn every_named_material_can_be_picked_and_shown() {
    let mut harness = window("rough_conductor");
    click(&mut harness, "Materials");
    for named in brdf_explorer::bxdf::material::library::all() {
        let name = named.material.name.as_str();
        let row = |harness: &Harness<'_, App>| {
            harness
                .get_by_role_and_label(Role::Button, name)
                .scroll_to_me();
        };
        row(&harness);
        harness.run();
        harness.get_by_role_and_label(Role::Button, name).click();
        harness.run();
        assert_eq!(*shown(&harness), named.material);
    }
}

#[test]
fn lobes_are_added_weighed_and_removed() {
    let mut harness = window("lambertian_reflection");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Weight")
            .is_none()
    );
    add_lobe(&mut harness, "Phong");
    assert_eq!(
        shown(&harness).to_string(),
        "lambertian_reflection + 0.25 * phong"
    );
    let weights: Vec<_> = harness
        .query_all_by_role_and_label(Role::Slider, "Weight")
        .collect();
    assert_eq!(weights.len(), 2);
    weights[1].set_value_accesskit(0.5);
    harness.run();
    assert_eq!(shown(&harness).components()[1].weight(), 0.5);
    // Its parameters fold away.
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Exponent")
            .is_some()
    );
    click(&mut harness, "Parameters of Phong");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Exponent")
            .is_none()
    );
    click(&mut harness, "Remove Lambertian reflection");
    assert_eq!(shown(&harness).to_string(), "0.5 * phong");
    // A single lobe shows a weight that is not 1.
    click(&mut harness, "Reset Weight");
    assert_eq!(shown(&harness).to_string(), "phong");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Weight")
            .is_none()
    );
}

#[test]
fn a_second_index_of_refraction_is_refused_with_the_reason() {
    let mut harness = window("fresnel_specular:eta=1.33");
    add_lobe(&mut harness, "Rough dielectric");
    let before = shown(&harness).clone();
    assert_eq!(before.components().len(), 2);
    let disagree = "disagree on the index of refraction";
    assert!(harness.query_by_label_contains(disagree).is_none());
    let etas: Vec<_> = harness
        .query_all_by_role_and_label(Role::Slider, "Eta")
        .collect();
    etas[0].set_value_accesskit(1.6);
    harness.run();
    assert_eq!(*shown(&harness), before);
    assert!(harness.query_by_label_contains(disagree).is_some());
    click(&mut harness, "Remove Rough dielectric");
    assert!(harness.query_by_label_contains(disagree).is_none());
}

#[test]
fn the_bar_of_shares_lists_them_as_text() {
    let mut harness = window("rough_dielectric");
    assert!(
        harness
            .query_by_label("Glossy specular, reflected")
            .is_none()
    );
    harness.get_by_label("Shares of light").hover();
    harness.run();
    for label in [
        "Glossy specular, reflected",
        "Glossy specular, transmitted",
        "Absorbed",
    ] {
        assert!(harness.query_by_label(label).is_some(), "{label}");
    }
    assert!(
        harness
            .query_by_label_contains("Error of the integration")
            .is_some()
    );
}

#[test]
fn a_mixture_that_creates_energy_is_warned_of() {
    let mut harness = window("lambertian_reflection");
    let warning = "creates energy";
    assert!(harness.query_by_label(warning).is_none());
    add_lobe(&mut harness, "Phong");
    let weight = harness
        .get_all_by_role_and_label(Role::Slider, "Weight")
        .next_back()
        .unwrap();
    weight.set_value_accesskit(1.0);
    harness.run();
    assert!(harness.query_by_label(warning).is_some());
    harness.get_by_label(warning).hover();
    harness.run();
    assert!(
        harness
            .query_by_label_contains("More light leaves than arrives")
            .is_some()
    );
}
