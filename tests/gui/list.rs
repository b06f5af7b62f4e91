//! The gestures of the list of materials, by accessible label.

use brdf_explorer::study::session::{MaterialEntry, Materials};
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers, OutputCommand, Role, ViewportCommand, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{pick, window, window_of};

const THREE: [&str; 3] = ["rough_conductor", "plastic", "oren_nayar"];

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

/// [`click`] on what may have to be scrolled to.
fn reach(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).scroll_to_me();
    harness.run();
    click(harness, label);
}

fn materials<'a>(harness: &'a Harness<'_, App>) -> &'a Materials {
    &harness.state().session.materials
}

fn titles(harness: &Harness<'_, App>) -> Vec<String> {
    let all = materials(harness);
    all.iter().map(|entry| all.title(entry)).collect()
}

fn shown(harness: &Harness<'_, App>) -> Vec<String> {
    materials(harness)
        .shown()
        .map(MaterialEntry::title)
        .collect()
}

/// Chooses from the menu of a material.
fn menu(harness: &mut Harness<'_, App>, title: &str, item: &str) {
    click(harness, &format!("Menu of {title}"));
    click(harness, item);
}

fn paste(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(Event::Paste(text.to_owned()));
    harness.run();
}

fn is_said(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_by_label_contains(text).is_some()
}

#[test]
fn a_material_is_added_through_the_picker() {
    let mut harness = window("rough_conductor");
    click(&mut harness, "Add…");
    assert!(is_said(&harness, "Choose what to add"));
    click(&mut harness, "Oren-Nayar  (R)");
    assert_eq!(titles(&harness), ["Rough conductor", "Oren-Nayar"]);
    assert!(!is_said(&harness, "Choose what to add"));
    // The picker acts on the one that was added.
    pick(&mut harness, "Phong  (R)");
    assert_eq!(titles(&harness), ["Rough conductor", "Phong"]);
    click(&mut harness, "Add…");
    click(&mut harness, "Materials");
    harness.get_by_label("Search materials").click();
    harness.get_by_label("Search materials").type_text("chalk");
    harness.run();
    click(&mut harness, "Chalk");
    assert_eq!(titles(&harness), ["Rough conductor", "Phong", "Chalk"]);
    for end in ["Cancel", "Escape"] {
        click(&mut harness, "Add…");
        if end == "Cancel" {
            click(&mut harness, end);
        } else {
            harness.key_press(Key::Escape);
            harness.run();
        }
        assert!(!is_said(&harness, "Choose what to add"), "{end}");
    }
    assert_eq!(titles(&harness).len(), 3);
}

#[test]
fn the_same_model_can_be_added_again() {
    let mut harness = window("rough_conductor");
    click(&mut harness, "Add…");
    click(&mut harness, "Rough conductor  (R)");
    assert_eq!(titles(&harness), ["Rough conductor", "Rough conductor 2"]);
}

#[test]
fn selecting_changes_what_the_panels_edit() {
    let mut harness = window_of(&THREE);
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Sigma")
            .is_none()
    );
    click(&mut harness, "Select Oren-Nayar");
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Sigma")
            .is_some()
    );
    assert_eq!(materials(&harness).selected().title(), "Oren-Nayar");
}

#[test]
fn materials_are_duplicated_and_removed() {
    let mut harness = window_of(&THREE);
    menu(&mut harness, "Plastic", "Duplicate");
    let expected = ["Rough conductor", "Plastic", "Plastic 2", "Oren-Nayar"];
    assert_eq!(titles(&harness), expected);
    let slots: Vec<u8> = materials(&harness)
        .iter()
        .map(|entry| entry.slot().0)
        .collect();
    assert_eq!(slots, [0, 1, 3, 2], "the copy has a colour of its own");
    menu(&mut harness, "Plastic", "Remove");
    assert_eq!(
        titles(&harness),
        ["Rough conductor", "Plastic", "Oren-Nayar"]
    );
    // By keyboard, while the focus is on the row.
    for (title, left) in [("Rough conductor", 2), ("Plastic", 1), ("Oren-Nayar", 1)] {
        harness.get_by_label(&format!("Select {title}")).focus();
        harness.run();
        harness.key_press(Key::Delete);
        harness.run();
        assert_eq!(titles(&harness).len(), left, "one is always left");
    }
}

#[test]
fn a_material_is_renamed_in_its_row() {
    let mut harness = window_of(&THREE);
    menu(&mut harness, "Plastic", "Rename");
    let field = "Name of Plastic";
    assert!(harness.get_by_label(field).is_focused());
    // The whole name is marked: what is typed replaces it.
    harness.get_by_label(field).type_text("Left wall");
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(titles(&harness)[1], "Left wall");
    harness.get_by_label("Select Left wall").focus();
    harness.run();
    harness.key_press(Key::F2);
    harness.run();
    harness
        .get_by_label("Name of Left wall")
        .type_text("Nonsense");
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(titles(&harness)[1], "Left wall");
    // An empty name is that of the material.
    menu(&mut harness, "Left wall", "Rename");
    harness.key_press(Key::Backspace);
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(titles(&harness)[1], "Plastic");
}

#[test]
fn rows_are_dragged_into_another_order() {
    let mut harness = window_of(&THREE);
    let from = harness.get_by_label("Move Rough conductor").rect().center();
    let to = harness.get_by_label("Move Oren-Nayar").rect().center();
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    for step in 1..=5 {
        harness.hover_at(from + (to - from) * (step as f32 / 5.0));
        harness.step();
    }
    assert_eq!(
        titles(&harness),
        ["Plastic", "Oren-Nayar", "Rough conductor"]
    );
    harness.hover_at(to - vec2(0.0, 25.0));
    harness.step();
    assert_eq!(
        titles(&harness),
        ["Plastic", "Rough conductor", "Oren-Nayar"]
    );
    harness.drop_at(to - vec2(0.0, 25.0));
    harness.run();
    assert_eq!(
        titles(&harness),
        ["Plastic", "Rough conductor", "Oren-Nayar"]
    );
    let slots: Vec<u8> = materials(&harness)
        .iter()
        .map(|entry| entry.slot().0)
        .collect();
    assert_eq!(slots, [1, 0, 2], "each keeps its colour");
}

#[test]
fn rows_are_moved_by_menu_and_keys() {
    let mut harness = window_of(&THREE);
    menu(&mut harness, "Oren-Nayar", "Move up");
    assert_eq!(
        titles(&harness),
        ["Rough conductor", "Oren-Nayar", "Plastic"]
    );
    menu(&mut harness, "Rough conductor", "Move down");
    assert_eq!(
        titles(&harness),
        ["Oren-Nayar", "Rough conductor", "Plastic"]
    );
    harness.get_by_label("Select Plastic").focus();
    harness.run();
    for _ in 0..3 {
        harness.key_press_modifiers(Modifiers::ALT, Key::ArrowUp);
        harness.run();
    }
    assert_eq!(
        titles(&harness),
        ["Plastic", "Oren-Nayar", "Rough conductor"]
    );
    harness.get_by_label("Move Plastic").focus();
    harness.run();
    harness.key_press_modifiers(Modifiers::ALT, Key::ArrowDown);
    harness.run();
    assert_eq!(
        titles(&harness),
        ["Oren-Nayar", "Plastic", "Rough conductor"]
    );
}

#[test]
fn materials_are_hidden_and_shown_alone() {
    let mut harness = window_of(&THREE);
    click(&mut harness, "Show Plastic");
    assert_eq!(shown(&harness), ["Rough conductor", "Oren-Nayar"]);
    assert!(!is_said(&harness, "Legend: Plastic"));
    menu(&mut harness, "Plastic", "Show alone");
    assert_eq!(shown(&harness), ["Plastic"]);
    click(&mut harness, "Alone");
    assert_eq!(shown(&harness), ["Rough conductor", "Oren-Nayar"]);
    menu(&mut harness, "Oren-Nayar", "Show alone");
    menu(&mut harness, "Oren-Nayar", "Show with the others");
    click(&mut harness, "Show Plastic");
    assert_eq!(shown(&harness).len(), 3);
}

#[test]
fn a_material_is_copied_and_pasted() {
    let mut harness = window_of(&["gold", "phong:exponent=12"]);
    for title in ["Gold", "Phong"] {
        click(&mut harness, &format!("Menu of {title}"));
        harness.get_by_label("Copy as text").click();
        harness.step();
        let mut copied = None;
        for _ in 0..4 {
            for command in &harness.output().platform_output.commands {
                if let OutputCommand::CopyText(text) = command {
                    copied = Some(text.clone());
                }
            }
            harness.step();
        }
        let before = materials(&harness).count();
        paste(&mut harness, &copied.unwrap());
        assert_eq!(materials(&harness).count(), before + 1);
        assert_eq!(materials(&harness).selected().title(), title);
    }
    let all = materials(&harness);
    let pairs = all.iter().zip(all.iter().skip(2));
    for (original, copy) in pairs.take(2) {
        assert_eq!(original.material, copy.material);
    }
}

#[test]
fn the_paste_button_asks_for_the_clipboard() {
    let mut harness = window("rough_conductor");
    harness.get_by_label("Paste").click();
    let mut is_asked = false;
    for _ in 0..4 {
        harness.step();
        let viewport = harness.output().viewport_output.values().next().unwrap();
        is_asked |= viewport.commands.contains(&ViewportCommand::RequestPaste);
    }
    assert!(is_asked);
}

#[test]
fn rubbish_in_the_clipboard_is_refused_and_nothing_is_lost() {
    let mut harness = window("rough_conductor");
    let before = harness.state().session.clone();
    for (text, said) in [
        ("gold,silver", "unknown material 'gold,silver'"),
        ("Dear all,\nsee below.", "clipboard: line 1"),
        ("", "there is nothing in it"),
        ("phong:exponent=-1", "phong: exponent = -1: allowed is"),
        (&"spam ".repeat(2_000_000), "unknown material 'spam spam"),
        (
            &"spam ".repeat(7_000_000),
            "33.4 MiB of text; the limit is 32 MiB",
        ),
    ] {
        paste(&mut harness, text);
        assert!(is_said(&harness, said), "{said}");
        assert_eq!(harness.state().session, before);
        click(&mut harness, "Dismiss");
        assert!(!is_said(&harness, said), "{said}");
    }
    let picture = egui::ColorImage::filled([2, 2], egui::Color32::WHITE);
    harness.event(Event::PasteImage(std::sync::Arc::new(picture)));
    harness.run();
    assert!(is_said(&harness, "clipboard: a picture, no text"));
    // A text field takes what is pasted into it.
    click(&mut harness, "Change…");
    paste(&mut harness, "phong");
    assert_eq!(harness.state().session, before);
}

#[test]
fn a_session_has_only_so_many_materials() {
    let mut harness = window("phong");
    for _ in 1..32 {
        paste(&mut harness, "phong:exponent=5");
    }
    assert_eq!(materials(&harness).count(), 32);
    paste(&mut harness, "gold");
    assert!(is_said(&harness, "the number of materials"));
    assert_eq!(materials(&harness).count(), 32);
}

#[test]
fn linked_widths_move_together() {
    let mut harness = window("rough_conductor");
    let widths = |harness: &Harness<'_, App>| {
        let params = materials(harness).selected().material.components()[0].params();
        ["alpha_x", "alpha_y"].map(|name| params.number(name))
    };
    let slide = |harness: &mut Harness<'_, App>, label: &str, value: f64| {
        let slider = harness.get_by_role_and_label(Role::Slider, label);
        slider.set_value_accesskit(value);
        harness.run();
    };
    slide(&mut harness, "Roughness along s (alpha)", 0.5);
    assert_eq!(widths(&harness), [0.5, 0.5]);
    reach(&mut harness, "Same along s and t");
    slide(&mut harness, "Roughness along t (alpha)", 0.1);
    assert_eq!(widths(&harness), [0.5, 0.1]);
    reach(&mut harness, "Same along s and t");
    assert_eq!(widths(&harness), [0.5, 0.5]);
    reach(&mut harness, "Reset all of Rough conductor");
    assert_eq!(widths(&harness), [0.3, 0.3]);
}

#[test]
fn a_locked_parameter_moves_all_that_have_it() {
    let mut harness = window_of(&["rough_conductor", "ward", "oren_nayar"]);
    assert!(
        harness.query_by_label("Link Fresnel").is_none(),
        "no other has it"
    );
    reach(&mut harness, "Link Roughness along s (alpha)");
    assert!(harness.state().session.locked.contains("alpha_x"));
    harness
        .get_by_role_and_label(Role::Slider, "Roughness along s (alpha)")
        .set_value_accesskit(0.5);
    harness.run();
    let alpha = |harness: &Harness<'_, App>, index: usize| {
        let entry = materials(harness).iter().nth(index).unwrap();
        entry.material.components()[0].params().number("alpha_x")
    };
    assert_eq!([alpha(&harness, 0), alpha(&harness, 1)], [0.5; 2]);
    reach(&mut harness, "Link Roughness along s (alpha)");
    reach(&mut harness, "Reset Roughness along s (alpha)");
    assert_eq!([alpha(&harness, 0), alpha(&harness, 1)], [0.3, 0.5]);
}
