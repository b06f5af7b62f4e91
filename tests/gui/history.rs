//! Undo and redo, by buttons and keys.

use brdf_explorer::study::session::{MaterialEntry, Session};
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers, Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::{show_decades, window, window_of};

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

/// The session, seen as at the start: where one looks from and what is selected is no part of an edit.
fn edits(harness: &Harness<'_, App>) -> Session {
    let mut session = harness.state().session.clone();
    session.camera = Session::default().camera;
    let first = session.materials.iter().map(MaterialEntry::id).min();
    session.materials.select(first.unwrap());
    session
}

/// Presses keys, and lets one frame pass.
fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.event_modifiers(
        Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        },
        modifiers,
    );
    harness.step();
}

fn is_disabled(harness: &Harness<'_, App>, label: &str) -> bool {
    harness.get_by_label(label).accesskit_node().is_disabled()
}

/// Drags a slider to the right and lets it go.
fn drag(harness: &mut Harness<'_, App>, label: &str) {
    let from = harness
        .get_by_role_and_label(Role::Slider, label)
        .rect()
        .center();
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    for step in 1..=4 {
        harness.hover_at(from + vec2(3.0 * step as f32, 0.0));
        harness.step();
    }
    harness.drop_at(from + vec2(12.0, 0.0));
    harness.run();
}

#[test]
fn every_edit_is_undone_and_done_again_within_a_frame() {
    let mut harness = window_of(&["rough_conductor", "plastic", "rough_conductor"]);
    let mut states = vec![edits(&harness)];
    for gesture in [
        "Scale of Polar plot",
        "Logarithmic",
        "Viewer",
        "Surface of 3D lobe",
        "Wire",
        "Times cos θ of Polar plot",
        "Link Roughness along s (alpha)",
        "Same along s and t",
        "Show Plastic",
        "Oren-Nayar  (R)",
        "Add…",
        "Phong  (R)",
        "Menu of Phong",
        "Duplicate",
        "Menu of Phong 2",
        "Show alone",
        "Menu of Plastic",
        "Move up",
        "Menu of Plastic",
        "Remove",
    ] {
        if harness.query_by_label(gesture).is_none() {
            click(&mut harness, "Change…");
        }
        // Rows of the list may be out of its sight.
        let is_row = gesture.starts_with("Menu of");
        if is_row || harness.get_by_label(gesture).rect().bottom() > 760.0 {
            harness.get_by_label(gesture).scroll_to_me();
            harness.run();
        }
        click(&mut harness, gesture);
        let state = edits(&harness);
        if state != *states.last().unwrap() {
            states.push(state);
        }
    }
    assert_eq!(
        states.len(),
        14,
        "menus and the button that starts adding change nothing"
    );
    assert!(is_disabled(&harness, "Redo"));
    for state in states.iter().rev().skip(1) {
        press(&mut harness, Modifiers::COMMAND, Key::Z);
        assert_eq!(edits(&harness), *state);
    }
    harness.run();
    assert!(is_disabled(&harness, "Undo"));
    for (step, state) in states.iter().skip(1).enumerate() {
        if step % 2 == 0 {
            press(&mut harness, Modifiers::COMMAND, Key::Y);
        } else {
            press(&mut harness, CTRL_SHIFT, Key::Z);
        }
        assert_eq!(edits(&harness), *state);
    }
}

#[test]
fn drags_of_one_control_in_a_row_are_one_step() {
    let mut harness = window("rough_conductor");
    let start = edits(&harness);
    drag(&mut harness, "θ from n");
    drag(&mut harness, "θ from n");
    let turned = edits(&harness);
    drag(&mut harness, "Roughness along s (alpha)");
    click(&mut harness, "Undo");
    assert_eq!(edits(&harness), turned);
    click(&mut harness, "Undo");
    assert_eq!(edits(&harness), start);
    click(&mut harness, "Redo");
    assert_eq!(edits(&harness), turned);
}

#[test]
fn a_hundred_edits_are_undone() {
    let mut harness = window("rough_conductor");
    for step in 0..100 {
        harness.state_mut().session.theta_deg = 0.5 * f64::from(step);
        harness.step();
    }
    for _ in 0..100 {
        press(&mut harness, Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(edits(&harness), edits(&window("rough_conductor")));
}

#[test]
fn a_text_field_has_its_own_undo() {
    let mut harness = window("rough_conductor");
    show_decades(&mut harness);
    click(&mut harness, "Change…");
    harness.get_by_label("Search models").type_text("phong");
    harness.run();
    let before = edits(&harness);
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(edits(&harness), before);
}

#[test]
fn keys_that_move_one_control_in_a_row_are_one_step() {
    let mut harness = window("rough_conductor");
    let start = edits(&harness);
    harness
        .get_by_role_and_label(Role::Slider, "Roughness along s (alpha)")
        .focus();
    harness.run();
    for _ in 0..5 {
        press(&mut harness, Modifiers::NONE, Key::ArrowRight);
    }
    let moved = edits(&harness);
    assert_ne!(moved, start);
    click(&mut harness, "Undo");
    assert_eq!(edits(&harness), start);
    assert!(is_disabled(&harness, "Undo"));
}

#[test]
fn the_menu_says_what_is_undone_and_keeps_the_arrangement_apart() {
    let mut harness = window("rough_conductor");
    let undo = |harness: &mut Harness<'_, App>| {
        click(harness, "Edit");
        let shown = harness.output().shapes.iter();
        let text = |clipped: &egui::epaint::ClippedShape| match &clipped.shape {
            egui::Shape::Text(text) => Some(text.galley.text().to_owned()),
            _ => None,
        };
        let found = shown.filter_map(text).find(|text| text.starts_with("Undo"));
        press(harness, Modifiers::NONE, Key::Escape);
        harness.run();
        found.unwrap()
    };
    assert_eq!(undo(&mut harness), "Undo");
    drag(&mut harness, "Roughness along s (alpha)");
    assert_eq!(undo(&mut harness), "Undo: roughness of Rough conductor");
    let close = harness.query_all_by_label("Close").last().unwrap();
    close.click();
    harness.run();
    assert_eq!(undo(&mut harness), "Undo layout: close Polar plot");
    let lobe = harness
        .get_by_role_and_label(Role::Canvas, "3D lobe")
        .rect();
    // Two drags are two moves, and what is scrolled without a pause is one.
    let home = harness.state().session.camera.clone();
    for _ in 0..2 {
        harness.hover_at(lobe.left_bottom() + vec2(60.0, -60.0));
        harness.run();
        harness.drag_at(lobe.left_bottom() + vec2(60.0, -60.0));
        for step in 1..=4 {
            harness.hover_at(lobe.left_bottom() + vec2(60.0 + 5.0 * step as f32, -60.0));
            harness.step();
        }
        harness.drop_at(lobe.left_bottom() + vec2(80.0, -60.0));
        harness.run();
    }
    let turned = harness.state().session.camera.clone();
    assert_eq!(undo(&mut harness), "Undo camera: orbit");
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_ne!(harness.state().session.camera, turned);
    assert_ne!(harness.state().session.camera, home);
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(harness.state().session.camera, home);
    assert_eq!(undo(&mut harness), "Undo layout: close Polar plot");
}
