//! The picker by keys, and its search.

use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::window;

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn titles(harness: &Harness<'_, App>) -> Vec<String> {
    let all = &harness.state().session.materials;
    all.iter().map(|entry| all.title(entry)).collect()
}

fn is_said(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_by_label_contains(text).is_some()
}

#[test]
fn a_material_is_added_by_keys_alone() {
    let mut harness = window("rough_conductor");
    let press = |harness: &mut Harness<'_, App>, key| {
        harness.key_press(key);
        harness.run();
    };
    let add = |harness: &mut Harness<'_, App>, text: &str| {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::M);
        harness.run();
        harness.event(Event::Text(text.to_owned()));
        harness.run();
    };
    // The names come first; one hit is enough for Enter.
    add(&mut harness, "lamb");
    press(&mut harness, Key::Enter);
    add(&mut harness, "glossy red");
    press(&mut harness, Key::Enter);
    add(&mut harness, "lamb");
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowUp);
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
fn a_search_hides_nothing_for_good() {
    let mut harness = window("rough_conductor");
    let search = |harness: &mut Harness<'_, App>, text: &str| {
        harness.get_by_label_contains("Search m").click();
        harness.run();
        harness.event(Event::Text(text.to_owned()));
        harness.run();
    };
    let hidden = "Selected, but not found by this search: Rough conductor";
    search(&mut harness, "road");
    assert!(is_said(&harness, "Road sign") && is_said(&harness, hidden));
    assert!(!is_said(&harness, "Black rubber"));
    click(&mut harness, "Clear the search");
    assert!(!is_said(&harness, hidden) && !is_said(&harness, "Road sign"));
    search(&mut harness, "phong");
    harness.key_press(Key::Escape);
    harness.run();
    assert!(is_said(&harness, "Rough conductor  (R)"));
    search(&mut harness, "phong");
    click(&mut harness, "Phong  (R)");
    assert!(!is_said(&harness, "Selected, but"));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    harness.run();
    assert!(harness.query_by_label("Clear the search").is_none());
    assert!(is_said(&harness, "Rough conductor  (R)"));
}
