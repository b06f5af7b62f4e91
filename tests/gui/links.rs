//! Links: copied in one window, pasted in another, and what becomes of data that does not travel.

use std::fs;

use brdf_explorer::study::link;
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers, OutputCommand};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::data::{says, table};
use super::files::{drop_file, press, titles, work_in};
use super::{Folder, window, window_of};

/// What a key copies, within a few frames.
fn copied_by(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) -> String {
    // In one frame: those between are not seen.
    harness.input_mut().events.push(Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    });
    for _ in 0..4 {
        harness.step();
        let commands = harness.output().platform_output.commands.iter();
        let mut texts = commands.filter_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
        if let Some(text) = texts.next() {
            return text;
        }
    }
    panic!("no text is copied");
}

fn copy_link(harness: &mut Harness<'_, App>) -> String {
    copied_by(harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::K)
}

fn paste(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(Event::Paste(text.to_owned()));
    harness.run();
}

#[test]
fn a_link_shows_the_same_session_elsewhere_and_undo_brings_the_own_one_back() {
    let mut harness = window_of(&["gold", "phong:exponent=20"]);
    let shown = harness.state().session.clone();
    harness
        .state_mut()
        .is_linked_from(Some("https://a.example/explorer/".to_owned()));
    let copied = copy_link(&mut harness);
    assert!(
        copied.starts_with("https://a.example/explorer/#s="),
        "{copied}"
    );
    harness.run();
    assert!(
        harness
            .query_by_label_contains("The link is in the clipboard")
            .is_some()
    );
    let mut other = window("lambertian_reflection");
    let before = other.state().session.clone();
    paste(&mut other, &copied);
    assert_eq!(other.state().session, shown);
    press(&mut other, Modifiers::COMMAND, Key::Z);
    assert_eq!(other.state().session, before);
    // What leads nowhere changes nothing, and says so in a line.
    for broken in [
        &copied[..copied.len() - 9],
        "#s=rubbish",
        "https://a.example/#lesson=99",
    ] {
        paste(&mut other, broken);
        assert_eq!(other.state().session, before, "{broken}");
    }
    assert!(
        other
            .query_by_label_contains("unknown lesson '99'")
            .is_some()
    );
    paste(&mut other, &link::to_step("06-lambert.2"));
    assert_eq!(other.state().step_link().as_deref(), Some("06-lambert.2"));
    other
        .state_mut()
        .is_linked_from(Some("https://a.example/".to_owned()));
    let step = copied_by(&mut other, Modifiers::COMMAND | Modifiers::ALT, Key::L);
    assert_eq!(step, "https://a.example/#lesson=06-lambert.2");
}

/// A file that a link could not take along is dropped where the link is followed.
#[test]
fn missing_data_is_dropped_on_the_window() {
    let folder = Folder::new("links-missing");
    let file = folder.file("secret.table");
    fs::write(&file, table("chalk").1.to_string()).unwrap();
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    drop_file(&mut harness, &file);
    harness.run_steps(3);
    let copied = copy_link(&mut harness);
    harness.run();
    assert!(says(&harness, "Not in the link: secret.table"));

    let mut other = window("phong");
    work_in(&mut other, &folder);
    paste(&mut other, &copied);
    // It lies where it lay, and yet nobody looks for it: a link names no place.
    other.run_steps(4);
    assert_eq!(titles(&other), ["Gold", "secret"]);
    assert!(says(&other, "secret.table is missing: it does not travel"));
    drop_file(&mut other, &file);
    other.run_steps(4);
    assert_eq!(titles(&other), ["Gold", "secret"]);
    assert_eq!(other.state().session.materials.shown().count(), 2);
    assert!(!says(&other, "secret is not shown"));
}
