//! The pictures to choose from: by keys, by their search, beside the panel and over the views.

use brdf_explorer::study::session::Session;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::theme;
use egui::{Event, Key, Modifiers, Role, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{pick, picture, session, window, window_of};

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(Event::Text(text.to_owned()));
    harness.run();
}

fn titles(harness: &Harness<'_, App>) -> Vec<String> {
    let all = &harness.state().session.materials;
    all.iter().map(|entry| all.title(entry)).collect()
}

fn is_said(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

/// Whether the pictures are shown.
fn is_open(harness: &Harness<'_, App>) -> bool {
    is_said(harness, "Search m")
}

#[test]
fn a_material_is_added_by_keys_alone() {
    let mut harness = window("rough_conductor");
    let add = |harness: &mut Harness<'_, App>, text: &str| {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::M);
        harness.run();
        type_text(harness, text);
    };
    // The names come first; one hit is enough for Enter.
    add(&mut harness, "lamb");
    press(&mut harness, Key::Enter);
    add(&mut harness, "glossy red");
    press(&mut harness, Key::Enter);
    add(&mut harness, "lamb");
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowLeft);
    press(&mut harness, Key::Enter);
    let added = [
        "Rough conductor",
        "Lambertian reflection",
        "Glossy red plastic",
        "Lambertian transmission",
    ];
    assert_eq!(titles(&harness), added);
    assert!(!is_said(&harness, "Choose what to add"));
    // Letters are commands again, and nothing is left of the search.
    press(&mut harness, Key::C);
    assert!(harness.state().session.with_cosine);
    assert!(harness.query_by_label("Clear the search").is_none());
    // Escape leaves.
    add(&mut harness, "gold");
    press(&mut harness, Key::Escape);
    assert!(!is_said(&harness, "Choose what to add"));
    assert!(harness.query_by_label("Clear the search").is_none());
    press(&mut harness, Key::Enter);
    assert_eq!(titles(&harness), added);
}

#[test]
fn several_are_added_with_shift_and_the_pictures_stay() {
    let mut harness = window("gold");
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::M);
    harness.run();
    assert!(is_said(&harness, "In place of Gold"));
    let add_next = |harness: &mut Harness<'_, App>| {
        press(harness, Key::ArrowRight);
        harness.key_press_modifiers(Modifiers::SHIFT, Key::Enter);
        harness.run();
        assert!(is_open(harness));
    };
    for _ in 0..3 {
        add_next(&mut harness);
    }
    assert_eq!(titles(&harness).len(), 4);
    assert_eq!(titles(&harness)[0], "Gold");
    // What is typed goes on being searched for.
    type_text(&mut harness, "chalk");
    press(&mut harness, Key::Enter);
    assert!(!is_open(&harness));
    // Enter alone replaces the one selected, which is the last that was added.
    assert_eq!(titles(&harness).len(), 4);
    assert_eq!(titles(&harness)[3], "Chalk");
}

#[test]
fn arrows_go_along_rows_and_columns_of_the_grid() {
    let mut harness = window("chalk");
    click(&mut harness, "Change…");
    let columns = {
        let top = |label: &str| {
            let cell = harness.get_by_role_and_label(Role::Button, label);
            cell.rect().top()
        };
        let names = brdf_explorer::bxdf::material::library::all();
        let names = names.iter().map(|named| named.material.name.as_str());
        let first = names.clone().next().unwrap();
        names.take_while(|name| top(name) == top(first)).count()
    };
    assert!(columns >= 4, "{columns}");
    let before = titles(&harness);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::Enter);
    assert_eq!(titles(&harness), before, "there and back");
    click(&mut harness, "Change…");
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    let names: Vec<&str> = brdf_explorer::bxdf::material::library::all()
        .iter()
        .map(|named| named.material.name.as_str())
        .collect();
    let place = |title: &str| names.iter().position(|name| *name == title).unwrap();
    let moved = place(&titles(&harness)[0]) - place("Chalk");
    assert_eq!(moved, columns);
}

#[test]
fn a_search_hides_nothing_for_good() {
    let mut harness = window("rough_conductor");
    click(&mut harness, "Change…");
    type_text(&mut harness, "road");
    assert!(is_said(&harness, "Road sign"));
    assert!(!is_said(&harness, "Black rubber"));
    click(&mut harness, "Clear the search");
    assert!(!is_said(&harness, "Road sign") && is_said(&harness, "Oren-Nayar  (R)"));
    harness.get_by_label("Search models").click();
    harness.run();
    type_text(&mut harness, "phong");
    press(&mut harness, Key::Escape);
    assert!(!is_open(&harness));
    click(&mut harness, "Change…");
    assert!(is_said(&harness, "Oren-Nayar  (R)"));
    type_text(&mut harness, "phong");
    click(&mut harness, "Phong  (R)");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    harness.run();
    assert!(!is_open(&harness));
    click(&mut harness, "Change…");
    assert!(is_said(&harness, "Oren-Nayar  (R)"));
}

#[test]
fn it_opens_beside_the_panel_and_a_click_elsewhere_closes_it() {
    for size in [[1280, 800], [920, 600]] {
        let shown = picture(session(&["gold"]), None, size, Theme::Dark);
        let mut harness = shown.harness().unwrap();
        harness.key_press_modifiers(Modifiers::COMMAND, Key::M);
        harness.run();
        let whole = harness.ctx.content_rect();
        let field = harness.get_by_label("Search materials").rect();
        assert!(field.left() > theme::FOLDED_WIDTH && field.right() < whole.right());
        assert!(field.width() > 4.0 * theme::CELL.x, "four columns");
        let before = harness.state().session.clone();
        let elsewhere = whole.right_center() - vec2(30.0, 0.0);
        harness.hover_at(elsewhere);
        harness.run();
        harness.drag_at(elsewhere);
        harness.drop_at(elsewhere);
        harness.run();
        assert!(!is_open(&harness), "{size:?}");
        let materials = |session: &Session| session.materials.clone();
        assert_eq!(materials(&harness.state().session), materials(&before));
    }
    // The button that opened it closes it.
    let mut harness = window("gold");
    click(&mut harness, "Change…");
    assert!(is_open(&harness));
    click(&mut harness, "Change…");
    assert!(!is_open(&harness));
}

#[test]
fn the_parameters_stay_where_they_are_when_a_material_is_added() {
    let mut harness = window("gold");
    let top = |harness: &Harness<'_, App>| harness.get_by_label("Change…").rect().top();
    let before = top(&harness);
    // Four rows are there from the first on.
    for _ in 0..3 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::D);
        harness.run();
        assert_eq!(top(&harness), before);
    }
    pick(&mut harness, "Chalk");
    assert_eq!(top(&harness), before);
}

#[test]
fn the_panel_folds_to_icons_by_a_key_and_unfolds() {
    let mut harness = window_of(&["gold", "chalk"]);
    let slider = |harness: &Harness<'_, App>| {
        let label = "Roughness along s (alpha)";
        harness
            .query_by_role_and_label(Role::Slider, label)
            .is_some()
    };
    let left = |harness: &Harness<'_, App>| {
        let view = harness.get_by_role_and_label(Role::Canvas, "3D lobe");
        view.rect().left()
    };
    let unfolded = left(&harness);
    assert!(slider(&harness));
    for is_folded in [true, false, true] {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::B);
        harness.run();
        assert_eq!(slider(&harness), !is_folded);
        assert_eq!(left(&harness) < unfolded, is_folded);
    }
    // What is folded still selects, adds and changes.
    click(&mut harness, "Select Chalk");
    let selected = harness.state().session.materials.selected().title();
    assert_eq!(selected, "Chalk");
    click(&mut harness, "Change…");
    type_text(&mut harness, "brass");
    press(&mut harness, Key::Enter);
    assert_eq!(titles(&harness), ["Gold", "Brass"]);
    click(&mut harness, "Fold the side panel");
    assert!(slider(&harness));
}

/// Where the window is narrow it is folded unless it is wanted.
#[test]
fn a_narrow_window_begins_with_icons() {
    let shown = picture(session(&["gold"]), None, [1024, 640], Theme::Dark);
    let mut harness = shown.harness().unwrap();
    let is_folded = |harness: &Harness<'_, App>| !is_said(harness, "Your materials");
    assert!(is_folded(&harness));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::B);
    harness.run();
    assert!(!is_folded(&harness));
}

#[test]
fn a_metal_is_chosen_by_its_name() {
    let mut harness = window("gold");
    let metal = |harness: &Harness<'_, App>| {
        let combo = harness.get_by_role_and_label(Role::ComboBox, "Metal");
        combo.value().unwrap_or_default()
    };
    assert_eq!(metal(&harness), "Gold");
    harness
        .get_by_role_and_label(Role::ComboBox, "Metal")
        .click();
    harness.run();
    click(&mut harness, "Copper");
    assert_eq!(metal(&harness), "Copper");
    let params = |harness: &Harness<'_, App>| {
        let material = harness.state().session.material().clone();
        let params = material.components()[0].params();
        ["eta", "k"].map(|name| params.rgb(name))
    };
    let copper = super::material("copper");
    let expected = ["eta", "k"].map(|name| copper.components()[0].params().rgb(name));
    assert_eq!(params(&harness), expected);
    // It is one step.
    click(&mut harness, "Undo");
    assert_eq!(metal(&harness), "Gold");
    // Its numbers are behind it, and other numbers are no metal's.
    assert!(harness.query_by_label("Reset n").is_none());
    click(&mut harness, "n and k of the metal");
    let slider = harness.get_by_role_and_label(Role::Slider, "k G");
    slider.set_value_accesskit(3.0);
    harness.run();
    assert_eq!(metal(&harness), "Custom");
}

#[test]
fn what_is_asked_for_less_often_is_folded_and_tells_what_was_changed() {
    let mut harness = window("rough_conductor:masking=separable");
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "Masking")
            .is_none()
    );
    assert!(is_said(&harness, "More (1 changed)"));
    click(&mut harness, "More parameters");
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "Masking")
            .is_some()
    );
    // It stays so for the next one.
    pick(&mut harness, "Principled (Disney)  (R)");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Clearcoat")
            .is_some()
    );
}
