//! Commands by key, by search, and their help.

use brdf_explorer::analysis::Hold;
use brdf_explorer::study::session::Curves;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::commands::COMMANDS;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{window, window_of};

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

fn search(harness: &mut Harness<'_, App>, wanted: &str) {
    press(harness, Modifiers::COMMAND, Key::K);
    harness
        .get_by_label("Search all commands")
        .type_text(wanted);
    harness.run();
}

#[test]
fn single_keys_change_how_things_are_shown() {
    let mut harness = window("gold");
    for (key, name) in [
        (Key::H, "held"),
        (Key::L, "scale"),
        (Key::C, "cosine"),
        (Key::R, "curves"),
        (Key::A, "angles"),
    ] {
        let before = harness.state().session.clone();
        press(&mut harness, Modifiers::NONE, key);
        assert_ne!(harness.state().session, before, "{name}");
    }
    let session = &harness.state().session;
    assert!(session.hold == Hold::Viewer && session.views.is_logarithmic());
    assert!(session.with_cosine && session.show_geometry && session.curves == Curves::Rgb);
}

/// Points of the text that is said: a line is higher by less than as much again.
const FONT_SIZE: f32 = 14.0;

#[test]
fn what_a_single_key_did_is_said_for_two_seconds() {
    let mut harness = window_of(&["gold", "phong"]);
    for (key, said) in [
        (Key::L, "Logarithmic radius: on"),
        (Key::L, "Logarithmic radius: off"),
        (Key::H, "Fixed: viewer"),
        (Key::C, "Times cos θ: on"),
        (Key::A, "Angles of the fixed direction: on"),
        (Key::S, "Shown alone: Gold"),
        (Key::R, "R, G and B: on"),
        (Key::S, "Shown again: every material with a tick"),
        (Key::R, "Not possible now: Luminance, or R, G and B"),
    ] {
        press(&mut harness, Modifiers::NONE, key);
        let line = harness.query_by_label(said);
        let height = line.unwrap_or_else(|| panic!("{said}")).rect().height();
        assert!(height < 2.0 * FONT_SIZE, "{said} is {height} high");
    }
    // A frame is a quarter of a second.
    let said = "Logarithmic radius: on";
    press(&mut harness, Modifiers::NONE, Key::L);
    harness.run_steps(2);
    assert!(harness.query_by_label(said).is_some());
    harness.run_steps(8);
    assert!(harness.query_by_label(said).is_none());
}

#[test]
fn keys_run_in_their_order_until_a_text_has_the_focus() {
    let mut harness = window("gold");
    let event = |key, modifiers| egui::Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    };
    let text = |text: &str| egui::Event::Text(text.to_owned());
    // All within one frame: C acts, L is typed.
    harness.input_mut().events = vec![
        event(Key::C, Modifiers::NONE),
        text("c"),
        event(Key::M, Modifiers::COMMAND),
        event(Key::L, Modifiers::NONE),
        text("l"),
    ];
    harness.step();
    harness.run();
    let session = &harness.state().session;
    assert!(session.with_cosine && !session.views.is_logarithmic());
    let typed = harness.get_by_label("Search materials").value();
    assert_eq!(typed.as_deref(), Some("l"));
}

#[test]
fn a_letter_that_is_held_acts_once() {
    let mut harness = window("gold");
    for _ in 0..4 {
        harness.event(egui::Event::Key {
            key: Key::C,
            physical_key: None,
            pressed: true,
            repeat: true,
            modifiers: Modifiers::NONE,
        });
        harness.run();
    }
    assert!(harness.state().session.with_cosine);
}

#[test]
fn keys_that_are_typed_into_a_field_run_nothing() {
    let mut harness = window("rough_conductor");
    let before = harness.state().session.clone();
    press(&mut harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::M);
    press(&mut harness, Modifiers::NONE, Key::H);
    harness.get_by_label("Search models").type_text("hl");
    harness.run();
    assert_eq!(harness.state().session, before);
}

#[test]
fn materials_are_handled_by_keys() {
    let mut harness = window_of(&["gold", "phong"]);
    let selected = |harness: &Harness<'_, App>| {
        let all = &harness.state().session.materials;
        all.title(all.selected())
    };
    press(&mut harness, Modifiers::COMMAND, Key::ArrowDown);
    assert_eq!(selected(&harness), "Phong");
    press(&mut harness, Modifiers::COMMAND, Key::D);
    assert_eq!(selected(&harness), "Phong 2");
    press(&mut harness, Modifiers::NONE, Key::S);
    assert_eq!(harness.state().session.materials.shown().count(), 1);
    press(&mut harness, Modifiers::NONE, Key::S);
    assert_eq!(harness.state().session.materials.shown().count(), 3);
    press(&mut harness, Modifiers::COMMAND, Key::Delete);
    assert_eq!(selected(&harness), "Phong");
    press(&mut harness, Modifiers::COMMAND, Key::ArrowUp);
    assert_eq!(selected(&harness), "Gold");
    press(&mut harness, Modifiers::COMMAND, Key::M);
    assert!(harness.query_by_label("Choose what to add").is_some());
}

#[test]
fn a_command_is_searched_and_run() {
    let mut harness = window("gold");
    search(&mut harness, "log radius");
    assert!(harness.query_by_label("File: Open…").is_none());
    press(&mut harness, Modifiers::NONE, Key::Enter);
    assert!(harness.state().session.views.is_logarithmic());
    assert!(harness.query_by_label("Search all commands").is_none());
    // Down goes to the next one found.
    search(&mut harness, "view");
    press(&mut harness, Modifiers::NONE, Key::ArrowDown);
    press(&mut harness, Modifiers::NONE, Key::ArrowDown);
    press(&mut harness, Modifiers::NONE, Key::ArrowUp);
    press(&mut harness, Modifiers::NONE, Key::Enter);
    assert_eq!(harness.state().session.views.ids().len(), 3);
    search(&mut harness, "duplicate");
    harness
        .get_by_label("Materials: Duplicate the selected material")
        .click();
    harness.run();
    assert_eq!(harness.state().session.materials.count(), 2);
    search(&mut harness, "xyzzy");
    assert!(
        harness
            .query_by_label_contains("No command matches")
            .is_some()
    );
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert!(harness.query_by_label("Search all commands").is_none());
}

#[test]
fn the_help_lists_every_command_with_its_keys() {
    let mut harness = window("gold");
    press(&mut harness, Modifiers::NONE, Key::F1);
    for command in COMMANDS {
        let keys = command.keys(&harness.ctx);
        assert!(!keys.is_empty());
        assert!(harness.query_all_by_label(&keys).next().is_some(), "{keys}");
    }
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert!(harness.query_by_label("At a slider").is_none());
    press(&mut harness, Modifiers::NONE, Key::Questionmark);
    harness.get_by_label("Close the list").click();
    harness.run();
    assert!(harness.query_by_label("At a slider").is_none());
}
