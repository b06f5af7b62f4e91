//! The focus: what Tab reaches and shows, and the keys that take hold of the light and the viewer.

use std::collections::HashSet;

use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Role, Shape};
use egui_kittest::Harness;
use egui_kittest::kittest::{By, NodeT as _, Queryable};

use super::{window, window_of};

fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

/// A click at this place, whatever lies there.
fn click_at(harness: &mut Harness<'_, App>, at: Pos2) {
    for event in [true, false].map(|pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }) {
        harness.event(Event::PointerMoved(at));
        harness.event(event);
        harness.run();
    }
}

#[test]
fn letters_take_hold_of_the_light_and_the_viewer() {
    let mut harness = window("gold");
    press(&mut harness, Key::I);
    assert!(harness.get_by_label("Light in the 3D lobe").is_focused());
    press(&mut harness, Key::ArrowUp);
    assert_eq!(harness.state().session.theta_deg, 49.0);
    press(&mut harness, Key::O);
    assert!(harness.get_by_label("Viewer in the 3D lobe").is_focused());
    let before = harness.state().session.other();
    press(&mut harness, Key::ArrowUp);
    assert!(harness.state().session.other().z > before.z);
    // In the view that was clicked last; where that has no handle, in another one.
    let plot = harness.get_by_label("Light in the polar plot").rect();
    click_at(&mut harness, plot.center() + egui::vec2(0.0, 60.0));
    press(&mut harness, Key::I);
    assert!(harness.get_by_label("Light in the polar plot").is_focused());
    harness.get_by_label("Reflectance").click();
    harness.run();
    press(&mut harness, Key::I);
    harness.run();
    assert!(harness.get_by_label("Light of the sphere").is_focused());
}

#[test]
fn a_press_on_a_handle_gives_it_the_focus() {
    let mut harness = window("gold");
    let at = harness.get_by_label("Light in the polar plot").rect();
    click_at(&mut harness, at.center());
    assert!(harness.get_by_label("Light in the polar plot").is_focused());
    press(&mut harness, Key::ArrowDown);
    assert_eq!(harness.state().session.theta_deg, 51.0);
}

/// What has the focus: its name, and where it is.
fn focused(harness: &Harness<'_, App>) -> Option<(String, Rect)> {
    let node =
        harness.query_all(By::new().predicate(|node| node.is_focused() && !node.is_hidden()));
    let mut node = node.map(|node| {
        (
            node.accesskit_node().label().unwrap_or_default(),
            node.rect(),
        )
    });
    node.next()
}

/// Whether a line in the colour of the focus goes round this place.
fn has_ring(harness: &Harness<'_, App>, place: Rect) -> bool {
    let ring = harness.ctx.global_style().visuals.selection.stroke.color;
    let is_near = |rect: Rect| rect.intersects(place) && rect.width() > 4.0;
    harness
        .output()
        .shapes
        .iter()
        .any(|clipped| match &clipped.shape {
            Shape::Rect(rect) => rect.stroke.color == ring && is_near(rect.rect),
            Shape::Circle(circle) => {
                circle.stroke.color == ring && is_near(clipped.shape.visual_bounding_rect())
            }
            _ => false,
        })
}

#[test]
fn every_stop_of_the_focus_shows_a_ring() {
    let mut harness = window_of(&["gold", "plastic"]);
    let mut stops = HashSet::new();
    for _ in 0..160 {
        press(&mut harness, Key::Tab);
        let Some((name, place)) = focused(&harness) else {
            continue;
        };
        assert!(has_ring(&harness, place), "{name} {place}");
        stops.insert((name, place.min.to_string()));
    }
    assert!(stops.len() > 40, "{}", stops.len());
}

#[test]
fn tab_goes_through_the_bars_from_left_to_right() {
    let harness = window("gold");
    let names = ["Add…", "Paste", "Fold the side panel"];
    let left = |name: &str| harness.get_by_label(name).rect().left();
    assert!(names.map(left).is_sorted());
    let mut harness = harness;
    harness
        .get_by_role_and_label(Role::Button, "Search and commands")
        .focus();
    harness.run();
    let mut places = Vec::new();
    for name in ["Shortcuts", "Present", "Theme"] {
        press(&mut harness, Key::Tab);
        let (found, place) = focused(&harness).unwrap();
        assert_eq!(found, name);
        places.push(place.left());
    }
    assert!(places.is_sorted(), "{places:?}");
    harness.get_by_label("Add…").focus();
    harness.run();
    for name in &names[1..] {
        press(&mut harness, Key::Tab);
        assert_eq!(focused(&harness).unwrap().0, *name);
    }
}

#[test]
fn a_click_that_closes_a_menu_does_nothing_else() {
    let mut harness = window_of(&["gold", "plastic"]);
    let before = harness.state().session.clone();
    let layout = harness.get_by_label("Reflectance").rect().center();
    harness.get_by_label("Views").click();
    harness.run();
    assert!(harness.query_by_label("Add Slice").is_some());
    click_at(&mut harness, layout);
    assert!(
        harness.query_by_label("Add Slice").is_none(),
        "it is closed"
    );
    assert!(harness.state().session == before);
    click_at(&mut harness, layout);
    assert!(harness.state().session != before, "the next click acts");
}
