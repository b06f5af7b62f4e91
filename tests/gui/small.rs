//! The window as small as a phone: one view at a time, and the panel at the side over it.

use brdf_explorer::study::lessons::lessons;
use brdf_explorer::study::session::{READY_LAYOUTS, Session};
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Role, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::{By, NodeT as _, Queryable};

use super::files::work_in;
use super::{Folder, picture, session};

/// Phones, upright and lying, in points.
const PHONES: [[u32; 2]; 4] = [[390, 844], [360, 640], [844, 390], [640, 360]];

/// What a finger hits, in points.
const TOUCHED: f32 = 32.0;

/// The window of this size with two views that a wide one has side by side.
fn phone(size: [u32; 2]) -> Harness<'static, App> {
    let mut shown = session(&["gold"]);
    shown.views.show_ready(&READY_LAYOUTS[0], [1280.0, 800.0]);
    picture(shown, None, size, Theme::Dark).controls()
}

fn click(harness: &mut Harness<'_, App>, name: &str) {
    harness.get_by_label(name).scroll_to_me();
    harness.run();
    harness.get_by_label(name).click();
    harness.run();
}

fn is_there(harness: &Harness<'_, App>, name: &str) -> bool {
    harness.query_by_label(name).is_some()
}

fn press_at(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.event(Event::PointerMoved(at));
    for pressed in [true, false] {
        harness.event(Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        harness.run();
    }
}

/// The places of all that can be pressed, with the names.
fn pressed(harness: &Harness<'_, App>) -> Vec<(String, Rect)> {
    let is_pressed = |role| {
        let roles = [
            Role::Button,
            Role::ComboBox,
            Role::CheckBox,
            Role::RadioButton,
        ];
        roles.contains(&role)
    };
    let all = harness.query_all(By::new().predicate(move |node| is_pressed(node.role())));
    let named = |node: egui_kittest::Node<'_>| {
        let name = node.accesskit_node().label().unwrap_or_default();
        (name, node.rect())
    };
    all.map(named).collect()
}

#[test]
fn a_phone_shows_one_view_with_a_tab_for_each() {
    for size in PHONES {
        let mut harness = phone(size);
        let whole = harness.ctx.content_rect();
        assert!(is_there(&harness, "Light in the 3D lobe"), "{size:?}");
        assert!(!is_there(&harness, "Light in the polar plot"), "{size:?}");
        let before = harness.state().session.clone();
        click(&mut harness, "Polar plot");
        let light = harness.get_by_label("Light in the polar plot").rect();
        assert!(whole.contains_rect(light), "{size:?}: {light}");
        assert!(!is_there(&harness, "Light in the 3D lobe"), "{size:?}");
        assert!(
            harness.state().session == before,
            "a tab changes nothing else"
        );
        // One that is added is seen, and one that is closed leaves its place to another.
        click(&mut harness, "Menu");
        harness.get_by_label("Views").scroll_to_me();
        harness.run();
        let views = harness.get_by_label("Views").rect().center();
        press_at(&mut harness, views);
        click(&mut harness, "Add Slice");
        assert!(is_there(&harness, "Close Slice"), "{size:?}");
        click(&mut harness, "Close Slice");
        assert!(is_there(&harness, "Light in the 3D lobe"), "{size:?}");
    }
}

#[test]
fn the_panel_lies_over_the_view_until_one_presses_beside_it() {
    for size in PHONES {
        let mut harness = phone(size);
        let whole = harness.ctx.content_rect();
        assert!(!is_there(&harness, "Your materials"), "{size:?}");
        let before = harness.state().session.clone();
        click(&mut harness, "Materials");
        assert!(is_there(&harness, "Your materials"), "{size:?}");
        press_at(&mut harness, whole.right_center() - egui::vec2(8.0, 0.0));
        assert!(!is_there(&harness, "Your materials"), "{size:?}");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::B);
        harness.run();
        assert!(is_there(&harness, "Your materials"), "{size:?}");
        // Escape closes a menu first.
        click(&mut harness, "Change…");
        harness.key_press(Key::Escape);
        harness.run();
        assert!(is_there(&harness, "Your materials"), "{size:?}");
        harness.key_press(Key::Escape);
        harness.run();
        assert!(!is_there(&harness, "Your materials"), "{size:?}");
        assert!(harness.state().session == before, "{size:?}");
    }
}

#[test]
fn what_a_finger_presses_is_large_enough_and_on_the_screen() {
    for size in PHONES {
        let mut harness = phone(size);
        let whole = harness.ctx.content_rect();
        let mut places = pressed(&harness);
        for opened in ["Menu", "Materials"] {
            click(&mut harness, opened);
            places.extend(pressed(&harness));
            harness.key_press(Key::Escape);
            harness.run();
        }
        assert!(places.len() > 20, "{size:?}: {places:?}");
        for (name, place) in places {
            // What is scrolled to is beyond the edge until then.
            if !place.is_positive() || !whole.intersects(place) || place.height() < 1.0 {
                continue;
            }
            assert!(place.height() >= TOUCHED - 0.5, "{size:?}: {name} {place}");
        }
    }
}

#[test]
fn the_bar_of_a_phone_has_the_value_and_the_angles() {
    for size in PHONES {
        let harness = phone(size);
        let whole = harness.ctx.content_rect();
        for name in ["θ from n", "φ from s"] {
            let field = harness.get_by_role_and_label(Role::SpinButton, name);
            assert!(whole.contains_rect(field.rect()), "{size:?}: {name}");
        }
        let value = harness.get_by_label_contains("1/sr").rect();
        assert!(whole.contains_rect(value), "{size:?}: {value}");
    }
}

#[test]
fn a_lesson_stands_below_the_view_of_an_upright_phone() {
    for size in PHONES {
        let mut harness = picture(Session::default(), None, size, Theme::Dark).controls();
        harness.state_mut().open_lesson(&lessons()[0], 1);
        harness.run();
        let whole = harness.ctx.content_rect();
        let all = harness.get_by_label("☰ All").rect();
        let tab = harness.get_by_label("Materials").rect();
        assert!(whole.contains_rect(all) && all.top() > tab.bottom());
        let is_upright = size[0] < size[1];
        let share = (whole.bottom() - all.top()) / whole.height();
        if is_upright {
            assert!(
                all.left() < 20.0 && (0.33..0.55).contains(&share),
                "{size:?}: {share}"
            );
        } else {
            assert!(share > 0.55 || all.left() < 20.0, "{size:?}: {all}");
        }
    }
}

#[test]
fn every_dialog_fits_into_a_phone() {
    let (ctrl, none) = (Modifiers::COMMAND, Modifiers::NONE);
    let dialogs = [(none, Key::F1), (ctrl, Key::K), (ctrl, Key::E)];
    for size in PHONES {
        for (modifiers, key) in dialogs {
            let folder = Folder::new("small-dialogs");
            let mut harness = phone(size);
            work_in(&mut harness, &folder);
            harness.run();
            let before = pressed(&harness).len();
            harness.key_press_modifiers(modifiers, key);
            harness.run();
            let whole = harness.ctx.content_rect();
            let all = harness.query_all(By::new().predicate(|node| {
                matches!(node.role(), Role::Button | Role::Label | Role::RadioButton)
            }));
            let mut shown = 0;
            for node in all {
                let (rect, name) = (node.rect(), node.accesskit_node().label());
                // What is scrolled to stands below until then; tabs are scrolled across.
                if whole.y_range().contains(rect.center().y) && rect.top() > 80.0 {
                    let is_inside = rect.left() >= 0.0 && rect.right() <= whole.right();
                    assert!(is_inside, "{size:?} {key:?}: {name:?} {rect}");
                    shown += 1;
                }
            }
            assert!(
                shown > 4 && pressed(&harness).len() > before,
                "{size:?} {key:?}"
            );
        }
    }
}

/// What a wide window shows is not changed by the rules of a small one.
#[test]
fn a_window_that_grows_has_its_panels_again() {
    let mut harness = phone([390, 844]);
    click(&mut harness, "Polar plot");
    harness.set_size(egui::vec2(1280.0, 800.0));
    harness.run();
    for name in [
        "Light in the 3D lobe",
        "Light in the polar plot",
        "Your materials",
    ] {
        assert!(is_there(&harness, name), "{name}");
    }
    assert_eq!(harness.ctx.global_style().spacing.interact_size.y, 20.0);
}
