//! The formula card in the window: what it leads to, whose it is, and where there is no light.

use brdf_explorer::study::views::formula_card;
use egui_kittest::kittest::Queryable;

use super::views::{alone, options, paints};
use super::{choose, session};

#[test]
fn the_card_leads_to_f_or_to_the_reflectance_factor() {
    let mut harness = alone(
        session(&["lambertian_reflection:reflectance=.5"]),
        "formula_card",
    );
    assert!(paints(&harness, "= 0.159 1/sr"));
    choose(&mut harness, "Leads to", "π f");
    let chosen: formula_card::Options = options(&harness);
    assert_eq!(chosen.unit, formula_card::Unit::PiF);
    assert!(paints(&harness, "= 0.5") && !paints(&harness, "= 0.159 1/sr = "));
    // What others have stays as they have it.
    let whole = harness.query_all_by_label_contains("= 0.159 1/sr").count();
    assert_eq!(whole, 3, "f, f with exchanged directions, f without 1/e²");
}

#[test]
fn each_lobe_of_a_material_has_its_card() {
    let mut harness = alone(session(&["car_paint"]), "formula_card");
    let title = |harness: &egui_kittest::Harness<'_, _>| -> String {
        let state: &brdf_explorer::ui::app::App = harness.state();
        let options: formula_card::Options = state.session.views.options();
        let component = options.component(&state.session).unwrap();
        component.model().title.to_owned()
    };
    let first = title(&harness);
    assert!(paints(&harness, &first));
    let components = harness
        .state()
        .session
        .materials
        .selected()
        .material
        .components();
    let second = components[1].model().title.to_owned();
    choose(&mut harness, "Formula of", &format!("2: {second}"));
    assert_eq!(title(&harness), second);
    assert!(paints(&harness, &second));
}

#[test]
fn where_no_light_goes_the_card_says_so() {
    let mut shown = session(&["gold"]);
    shown.put_other(-shown.other());
    let harness = alone(shown, "formula_card");
    let line = "No light goes from this light to this viewer: the value is 0";
    assert!(harness.query_by_label(line).is_some());
    // The formula and its origin stand there all the same.
    assert!(harness.query_by_label("Where it comes from").is_some());
    // Of a mirror it is the weight.
    let harness = alone(
        session(&["specular_reflection:reflectance=.9"]),
        "formula_card",
    );
    assert!(paints(&harness, "= 0.9"));
}

#[test]
fn laws_that_a_model_breaks_are_told() {
    let harness = alone(session(&["burley_diffuse"]), "formula_card");
    assert!(
        harness
            .query_by_label("Laws that it breaks as published")
            .is_some()
    );
    let harness = alone(session(&["lambertian_reflection"]), "formula_card");
    assert!(
        harness
            .query_by_label("Laws that it breaks as published")
            .is_none()
    );
}
