//! The gestures on named materials and their lobes, by accessible label.

use brdf_explorer::bxdf::{Component, Material};
use brdf_explorer::ui::app::App;
use egui::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{material, pick, window};

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

/// Scrolls to what may lie below the fold, and clicks it.
fn reach(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).scroll_to_me();
    harness.run();
    click(harness, label);
}

/// Adds a lobe of the model with this title, found in this category.
fn add_lobe(harness: &mut Harness<'_, App>, [category, title]: [&str; 2]) {
    harness.get_by_label("Add a lobe…").scroll_to_me();
    harness.run();
    click(harness, "Add a lobe…");
    for label in [category, title] {
        harness.get_by_role_and_label(Role::Button, label).click();
        harness.run();
    }
}

/// The category and the title of a model.
const PHONG: [&str; 2] = ["Glossy specular", "Phong"];

/// Sets the slider with this label.
fn slide(harness: &mut Harness<'_, App>, label: &str, value: f64) {
    harness
        .get_by_role_and_label(Role::Slider, label)
        .set_value_accesskit(value);
    harness.run();
}

fn shown<'a>(harness: &'a Harness<'_, App>) -> &'a Material {
    harness.state().session.material()
}

#[test]
fn a_named_material_is_searched_and_chosen() {
    let mut harness = window("rough_conductor");
    assert!(harness.query_by_label("Brass").is_none());
    click(&mut harness, "Change…");
    click(&mut harness, "Materials");
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
            .query_by_role_and_label(Role::Slider, "Roughness along s (alpha)")
            .is_some()
    );
    // Both lists are searched, whichever is shown.
    click(&mut harness, "Change…");
    click(&mut harness, "Models");
    harness.get_by_label("Search models").type_text("gold");
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Button, "Gold")
            .is_some()
    );
    click(&mut harness, "Clear the search");
    assert!(harness.query_by_label("Clear the search").is_none());
    // What it opens with is the list in which the chosen one stands.
    harness.key_press(egui::Key::Escape);
    harness.run();
    click(&mut harness, "Change…");
    assert!(harness.query_by_label("Search materials").is_some());
}

#[test]
fn search_covers_name_category_and_model() {
    for (wanted, expected, other) in [
        ("brass", "Brass", "Gold"),
        ("retro", "Road sign", "Gold"),
        ("rough_conductor", "Gold", "Road sign"),
    ] {
        let mut harness = window("gold");
        click(&mut harness, "Change…");
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
        .get_by_role_and_label(Role::Slider, "Roughness along s (alpha)")
        .set_value_accesskit(0.5);
    harness.run();
    assert_eq!(
        (alpha(&harness), shown(&harness).name.as_str()),
        (0.5, "Gold")
    );
    pick(&mut harness, "Glossy red plastic");
    assert_eq!(*shown(&harness), material("plastic_glossy_red"));
    pick(&mut harness, "Gold");
    assert_eq!(alpha(&harness), 0.5);
    click(&mut harness, "Reset Gold");
    assert_eq!(*shown(&harness), material("gold"));
}

#[test]
fn every_named_material_can_be_picked_and_shown() {
    let mut harness = window("rough_conductor");
    click(&mut harness, "Change…");
    click(&mut harness, "Materials");
    click(&mut harness, "Chalk");
    for named in brdf_explorer::bxdf::material::library::all() {
        pick(&mut harness, &named.material.name);
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
    add_lobe(&mut harness, PHONG);
    assert_eq!(
        shown(&harness).to_string(),
        "lambertian_reflection + 0.2 * phong"
    );
    // There is no more room beside a reflectance of 0.8, and it is said.
    let said = "Phong starts with weight 0.2: with more, more light would leave than arrives";
    assert!(harness.query_by_label(said).is_some());
    slide(&mut harness, "Weight of lobe 2", 0.5);
    assert!(harness.query_by_label(said).is_none());
    assert_eq!(shown(&harness).components()[1].weight(), 0.5);
    // Its parameters fold away.
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Exponent of lobe 2")
            .is_some()
    );
    reach(&mut harness, "Parameters of lobe 2, Phong");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Exponent of lobe 2")
            .is_none()
    );
    reach(&mut harness, "Remove lobe 1, Lambertian reflection");
    assert_eq!(shown(&harness).to_string(), "0.5 * phong");
    // A single lobe shows a weight that is not 1.
    reach(&mut harness, "Reset Weight");
    assert_eq!(shown(&harness).to_string(), "phong");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Weight")
            .is_none()
    );
}

#[test]
fn lobes_that_light_crosses_share_the_index() {
    let mut harness = window("fresnel_specular:eta=1.33");
    add_lobe(&mut harness, ["Glossy specular", "Rough dielectric"]);
    for (label, index) in [
        ("Index of refraction (eta) of lobe 1", 1.6),
        ("Index of refraction (eta) of lobe 2", 1.4),
    ] {
        slide(&mut harness, label, index);
        let components = shown(&harness).components();
        let indices: Vec<f64> = components.iter().map(Component::relative_index).collect();
        assert_eq!(indices, [index; 2]);
    }
    // A model without an index of its own cannot take it over.
    let before = shown(&harness).clone();
    let disagree = "disagree on the index of refraction";
    assert!(harness.query_by_label_contains(disagree).is_none());
    add_lobe(&mut harness, ["Diffuse", "Lambertian transmission"]);
    assert_eq!(*shown(&harness), before);
    assert!(harness.query_by_label_contains(disagree).is_some());
    reach(&mut harness, "Remove lobe 2, Rough dielectric");
    assert!(harness.query_by_label_contains(disagree).is_none());
}

#[test]
fn the_controls_of_several_lobes_have_names_of_their_own() {
    let mut harness = window("rough_conductor");
    add_lobe(&mut harness, ["Glossy specular", "Rough conductor"]);
    reach(&mut harness, "n and k of the metal of lobe 1");
    for ordinal in [1, 2] {
        for (role, label) in [
            (Role::Slider, "Weight"),
            (Role::Slider, "Roughness along s (alpha)"),
            (Role::Slider, "n G"),
            (Role::ComboBox, "Metal"),
            (Role::ComboBox, "Fresnel"),
            (Role::Button, "Reset Roughness along s (alpha)"),
        ] {
            let label = format!("{label} of lobe {ordinal}");
            let found = harness.query_all_by_role_and_label(role, &label).count();
            assert_eq!(found, 1, "{label}");
        }
    }
    slide(&mut harness, "Roughness along s (alpha) of lobe 2", 0.5);
    let widths: Vec<f64> = shown(&harness)
        .components()
        .iter()
        .map(|component| component.params().number("alpha_x"))
        .collect();
    assert_eq!(widths[1], 0.5);
    assert_ne!(widths[0], 0.5);
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
    add_lobe(&mut harness, PHONG);
    slide(&mut harness, "Weight of lobe 2", 1.0);
    assert!(harness.query_by_label(warning).is_some());
    harness.get_by_label(warning).hover();
    harness.run();
    assert!(
        harness
            .query_by_label_contains("More light leaves than arrives")
            .is_some()
    );
}
