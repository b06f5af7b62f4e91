//! Presses and moves that come within one frame, as fast hands and slow machines make them.

use brdf_explorer::ui::app::App;
use eframe::App as _;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput, Role, Theme, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{measure_tradeoff, picture, session, window};

/// How far the pointer goes within the frame of the press, in points.
const FAR: [f32; 3] = [8.0, 20.0, 60.0];

/// The most frames that a gesture of a few events is spread over.
const MOST_FRAMES: usize = 20;

const RESET: &str = "Reset view";

/// A view, the name of its handle, a material, and which way the handle is dragged.
type Dragged = (&'static str, &'static str, &'static str, Vec2);

/// Every handle of every view.
const HANDLES: [Dragged; 6] = [
    (
        "polar",
        "Light in the polar plot",
        "gold",
        vec2(0.64, -0.77),
    ),
    ("lobe3d", "Light in the 3D lobe", "gold", vec2(0.8, 0.6)),
    (
        "hemisphere",
        "Light in the hemisphere",
        "gold",
        vec2(0.6, 0.8),
    ),
    ("sphere", "Light of the sphere", "gold", vec2(0.6, 0.8)),
    ("sphere", "Viewer of the sphere", "gold", vec2(0.6, 0.8)),
    ("tradeoff", "Line of the tolerance", "gold", vec2(0.0, 1.0)),
];

/// Lets all `events` come at once, as the window gets them, until the last of them is handled.
fn feed(harness: &mut Harness<'_, App>, events: Vec<Event>) {
    let mut input = RawInput {
        events,
        ..RawInput::default()
    };
    for _ in 0..MOST_FRAMES {
        let ctx = harness.ctx.clone();
        harness.state_mut().raw_input_hook(&ctx, &mut input);
        if input.events.is_empty() {
            harness.run();
            return;
        }
        harness.input_mut().events = std::mem::take(&mut input.events);
        harness.step();
    }
    panic!("events are left after {MOST_FRAMES} frames");
}

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

/// A press at `from`, a move by `by` and the release, with no time between.
fn swipe(from: Pos2, by: Vec2) -> Vec<Event> {
    vec![
        Event::PointerMoved(from),
        button(from, true),
        Event::PointerMoved(from + by),
        button(from + by, false),
    ]
}

fn typed(text: &str) -> Vec<Event> {
    let press = |letter: char| {
        let key = Key::from_name(&letter.to_uppercase().to_string()).unwrap();
        let key = Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        [key, Event::Text(letter.to_string())]
    };
    text.chars().flat_map(press).collect()
}

fn key(key: Key, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

fn alone(id: &str, material: &str) -> Harness<'static, App> {
    let shown = picture(session(&[material]), Some(id), [640, 480], Theme::Dark);
    let mut harness = shown.harness().unwrap();
    measure_tradeoff(&mut harness);
    harness
}

fn middle(harness: &Harness<'_, App>, label: &str) -> Pos2 {
    harness.get_by_label(label).rect().center()
}

fn canvas(harness: &Harness<'_, App>, name: &str) -> egui::Rect {
    harness.get_by_role_and_label(Role::Canvas, name).rect()
}

fn scroll(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.hover_at(at);
    harness.event(Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 60.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    harness.run_steps(12);
}

/// Every text that is painted, and where.
fn texts(harness: &Harness<'_, App>) -> Vec<(String, Pos2)> {
    let shapes = harness.output().shapes.iter();
    let text = |clipped: &egui::epaint::ClippedShape| match &clipped.shape {
        egui::Shape::Text(text) => Some((text.galley.text().to_owned(), text.pos)),
        _ => None,
    };
    shapes.filter_map(text).collect()
}

/// Whether the same texts stand at the same places, to half a point.
fn is_same(one: &[(String, Pos2)], other: &[(String, Pos2)]) -> bool {
    one.len() == other.len()
        && one
            .iter()
            .zip(other)
            .all(|(one, other)| one.0 == other.0 && one.1.distance(other.1) < 0.5)
}

#[test]
fn a_handle_is_dragged_however_fast() {
    for (view, label, material, along) in HANDLES {
        for far in FAR {
            for off in [Vec2::ZERO, vec2(-12.0, 15.0)] {
                let mut harness = alone(view, material);
                let from = middle(&harness, label);
                // In the next frame it stands where the pointer went, or as near as it can.
                feed(&mut harness, swipe(from + off, far * along));
                let went = middle(&harness, label) - from;
                let missed = (went - far * along).length();
                let what = format!("{view}, {far} points, from {off:?}: went {went:?}");
                assert!(missed <= 1.0 + 0.25 * far, "{what}");
                assert!(went.length() > 0.7 * far, "{what}");
                assert!(harness.query_by_label(RESET).is_none(), "{what}");
            }
        }
    }
}

#[test]
fn a_handle_that_is_taken_and_let_go_stays() {
    for (view, label, material, _) in HANDLES {
        let mut shown = session(&[material]);
        // Finer than a drag would set them.
        (shown.theta_deg, shown.phi_deg) = (33.123, -12.345);
        let shown = picture(shown, Some(view), [640, 480], Theme::Dark);
        let mut harness = shown.harness().unwrap();
        measure_tradeoff(&mut harness);
        let before = harness.state().session.clone();
        let at = middle(&harness, label) + vec2(9.0, -7.0);
        feed(&mut harness, swipe(at, Vec2::ZERO));
        assert_eq!(harness.state().session, before, "{view}");
    }
}

#[test]
fn beside_a_handle_a_fast_drag_moves_the_view_which_is_then_reset() {
    // What is no handle is judged by the same press: the view follows, and can be put back.
    let mut harness = alone("lobe3d", "gold");
    let home = harness.state().session.clone();
    let at = canvas(&harness, "3D lobe").left_bottom() + vec2(40.0, -90.0);
    feed(&mut harness, swipe(at, vec2(60.0, 0.0)));
    assert_ne!(harness.state().session.camera, home.camera);
    harness.get_by_label(RESET).click();
    harness.run();
    assert_eq!(harness.state().session, home);
    assert!(harness.query_by_label(RESET).is_none());
    // The views that were chosen by their names are home too.
    harness.get_by_label("Top").click();
    harness.run();
    assert!(harness.query_by_label(RESET).is_none());
}

#[test]
fn what_was_panned_or_zoomed_is_reset() {
    for (view, canvas_name, label) in [
        ("polar", None, "Light in the polar plot"),
        ("cartesian", Some("Cartesian plot"), "Cartesian plot"),
        (
            "tradeoff",
            Some("How to evaluate f"),
            "Line of the tolerance",
        ),
    ] {
        for is_zoomed in [false, true] {
            let mut harness = alone(view, "gold");
            let away = Pos2::ZERO;
            harness.hover_at(away);
            harness.run();
            let before = texts(&harness);
            assert!(harness.query_by_label(RESET).is_none(), "{view}");
            let at = match canvas_name {
                Some(name) => canvas(&harness, name).center(),
                None => middle(&harness, label) + vec2(60.0, 60.0),
            };
            if is_zoomed {
                scroll(&mut harness, at);
            } else {
                feed(&mut harness, swipe(at, vec2(60.0, 20.0)));
            }
            harness.hover_at(away);
            harness.run();
            assert!(!is_same(&texts(&harness), &before), "{view} {is_zoomed}");
            harness.get_by_label(RESET).click();
            harness.run();
            harness.hover_at(away);
            harness.run();
            assert!(harness.query_by_label(RESET).is_none(), "{view}");
            assert!(is_same(&texts(&harness), &before), "{view} {is_zoomed}");
        }
    }
}

#[test]
fn what_was_panned_stays_in_another_room() {
    // As where a notice opens below the views: it took the pan with it.
    for view in ["polar", "cartesian"] {
        let mut harness = alone(view, "gold");
        let at = match view {
            "polar" => middle(&harness, "Light in the polar plot") + vec2(60.0, 60.0),
            _ => canvas(&harness, "Cartesian plot").center(),
        };
        feed(&mut harness, swipe(at, vec2(60.0, 20.0)));
        let reset = |harness: &Harness<'_, App>| harness.query_by_label(RESET).is_some();
        assert!(reset(&harness), "{view}");
        let size = harness.ctx.content_rect().size();
        harness.set_size(size - vec2(0.0, 40.0));
        harness.run();
        assert!(reset(&harness), "{view}");
        // What was not panned fills the new room.
        harness.get_by_label(RESET).click();
        harness.run();
        harness.set_size(size);
        harness.run();
        assert!(!reset(&harness), "{view}");
    }
}

#[test]
fn pictures_have_nothing_to_click() {
    let mut shown = session(&["gold"]);
    shown.camera.orbit(vec2(40.0, 10.0));
    let moved = picture(shown, Some("lobe3d"), [640, 480], Theme::Dark);
    let harness = moved.shapes();
    assert!(harness.query_by_label(RESET).is_none());
}

#[test]
fn what_is_typed_right_behind_a_key_goes_to_the_search() {
    for (opener, field) in [(Key::M, "Search models"), (Key::K, "Search all commands")] {
        let mut harness = window("phong");
        let before = harness.state().session.clone();
        let all = [vec![key(opener, Modifiers::COMMAND)], typed("lch")].concat();
        feed(&mut harness, all);
        assert_eq!(harness.state().session, before);
        let text = harness.get_by_label(field).value();
        assert_eq!(text.as_deref(), Some("lch"));
    }
    // Behind a click, too.
    let mut harness = window("phong");
    let before = harness.state().session.clone();
    let at = middle(&harness, "Change…");
    feed(&mut harness, [swipe(at, Vec2::ZERO), typed("hal")].concat());
    assert_eq!(harness.state().session, before);
    let text = harness.get_by_label("Search models").value();
    assert_eq!(text.as_deref(), Some("hal"));
}

/// The tooltip of the light's handle in the polar plot.
fn has_tooltip(harness: &Harness<'_, App>) -> bool {
    let mut all = harness.query_all_by_label_contains("The light. Drag it");
    all.next().is_some()
}

/// Longer than a tooltip waits, in frames of a quarter of a second.
const REST: usize = 8;

#[test]
fn a_tooltip_waits_until_the_pointer_comes_again_after_a_drag() {
    let mut harness = window("gold");
    let light = |harness: &Harness<'_, App>| {
        let handle = harness.get_by_label("Light in the polar plot");
        handle.rect().center()
    };
    let from = light(&harness);
    harness.hover_at(from);
    harness.run_steps(REST);
    assert!(has_tooltip(&harness), "who rests there is told");
    harness.drag_at(from);
    harness.run_steps(2);
    let to = from + vec2(30.0, -20.0);
    harness.hover_at(to);
    harness.run_steps(REST);
    assert!(!has_tooltip(&harness), "it is dragged");
    harness.drop_at(to);
    harness.run_steps(REST);
    assert!(!has_tooltip(&harness), "the drag has ended there");
    harness.hover_at(to + vec2(60.0, 60.0));
    harness.run_steps(2);
    let at = light(&harness);
    harness.hover_at(at);
    harness.run_steps(REST);
    assert!(has_tooltip(&harness), "who comes again is told");
}

#[test]
fn plots_have_no_tooltips_while_they_are_presented() {
    let mut harness = window("gold");
    harness.key_press(Key::F5);
    harness.run();
    let at = harness.get_by_label("Light in the polar plot").rect();
    harness.hover_at(at.center());
    harness.run_steps(REST);
    assert!(!has_tooltip(&harness));
}
