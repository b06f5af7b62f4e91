//! The bar at the bottom: one line, whatever the window; what does not fit is behind its last button.

use brdf_explorer::study::answers::{Answers, Progress};
use brdf_explorer::study::session::{READY_LAYOUTS, SHARES, Session, Views};
use brdf_explorer::study::views::Options;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::theme::{self, Palette};
use brdf_explorer::ui::widgets::bottom::Bar;
use brdf_explorer::ui::widgets::shares::Energy;
use egui::{Key, Rect, Role, Theme, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::typing::{enter, press, said, type_into};
use super::{picture, session};

fn window_of(material: &str, size: [u32; 2]) -> Harness<'static, App> {
    picture(session(&[material]), None, size, Theme::Dark).shapes()
}

/// The bar alone, in so wide a window, with the light of this material.
fn bar_of(material: &str, width: f32) -> Harness<'static, Session> {
    let shown = session(&[material]);
    let mut answers = Answers::at_once();
    let shares = answers.ask(&shown, shown.materials.selected(), SHARES);
    let palette = Palette::of(Theme::Dark);
    let show = move |ui: &mut Ui, session: &mut Session| {
        let bar = Bar {
            cursor: None,
            energy: Energy::of(session.held(), shares.as_deref(), &palette),
            progress: Progress::Complete(None),
        };
        bar.show(ui, session);
    };
    let is_small = width < theme::SMALL_WINDOW.x;
    let lines = if is_small { 2.0 } else { 1.0 };
    Harness::builder()
        .with_size(vec2(width, lines * theme::BAR_HEIGHT))
        .build_ui_state(show, shown)
}

/// Where the controls stand, from left to right.
fn controls(harness: &Harness<'_, Session>) -> Vec<Rect> {
    let all = [Role::SpinButton, Role::Slider, Role::Button, Role::Label];
    let all = all
        .into_iter()
        .flat_map(|role| harness.query_all_by_role(role));
    let mut all: Vec<Rect> = all.map(|node| node.rect()).collect();
    all.sort_by(|a, b| a.left().total_cmp(&b.left()));
    all
}

const BAR_NUMBERS: [&str; 3] = ["θ from n", "φ from s", "Rotate surface about n"];

#[test]
fn nothing_of_the_bar_overlaps_or_leaves_the_window_at_any_width() {
    for material in ["gold", "frosted_glass", super::badges::BRIGHT] {
        // The last of them are 1280 and 1024 points at three times the size.
        for width in [1920.0, 1280.0, 1024.0, 920.0, 640.0, 427.0, 341.0] {
            let harness = bar_of(material, width);
            let all = controls(&harness);
            assert!(all.len() > 4, "{width}: {all:?}");
            for (index, one) in all.iter().enumerate() {
                let is_over = |other: &&Rect| one.shrink(0.5).intersects(**other);
                let over = all[index + 1..].iter().find(is_over);
                assert!(over.is_none(), "{material} {width}: {one} {over:?}");
            }
            let whole = harness.ctx.content_rect();
            let is_inside = |rect: &Rect| whole.contains_rect(*rect);
            assert!(all.iter().all(is_inside), "{material} {width}: {all:?}");
        }
    }
}

#[test]
fn what_does_not_fit_is_behind_the_last_button() {
    let rest = "Rest of the bar";
    for width in [1920, 1280, 1024, 700, 427] {
        let mut harness = window_of("gold", [width, 640]);
        let here = |harness: &Harness<'_, App>, name: &str| {
            harness
                .query_by_role_and_label(Role::SpinButton, name)
                .is_some()
        };
        let gone: Vec<&str> = BAR_NUMBERS
            .into_iter()
            .filter(|name| !here(&harness, name))
            .collect();
        let is_whole = harness.query_by_label_contains("reflected ").is_some() && gone.is_empty();
        if width >= 1280 {
            assert!(is_whole, "{width}: {gone:?}");
        }
        if width == 1920 {
            assert!(harness.query_by_label(rest).is_none());
            assert!(
                harness
                    .query_by_label("Shown: where the light goes")
                    .is_some()
            );
            continue;
        }
        harness.get_by_label(rest).click();
        harness.run();
        assert!(
            harness
                .query_by_label("Shown: where the light goes")
                .is_some()
        );
        assert!(harness.query_by_label_contains("reflected ").is_some());
        for name in BAR_NUMBERS {
            assert!(here(&harness, name), "{width}: {name}");
        }
        // A number that is typed there counts as it does in the bar, which is reached when the menu is closed.
        if !gone.contains(&"Rotate surface about n") {
            press(&mut harness, Key::Escape);
        }
        enter(&mut harness, "Rotate surface about n", "12,5");
        assert_eq!(harness.state().session.rotation_deg, 12.5, "{width}");
    }
}

#[test]
fn a_refused_angle_is_said_above_the_bar() {
    let mut harness = window_of("gold", [1280, 800]);
    type_into(&mut harness, "θ from n", "91");
    press(&mut harness, Key::Enter);
    let (text, words) = said(&harness, "θ from n");
    assert_eq!(text, "91");
    let words = harness.get_by_label(&words.unwrap()).rect();
    let field = harness.get_by_role_and_label(Role::SpinButton, "θ from n");
    assert!(words.bottom() < field.rect().top());
}

#[test]
fn at_the_horizon_nothing_arrives_and_no_share_is_made_up() {
    for material in ["gold", "glass", "lambertian_reflection"] {
        let mut shown = session(&[material]);
        for layout in &READY_LAYOUTS {
            shown.views = Views::ready(layout);
            let of_held = shown.views.ids().iter().any(|id| {
                let options = shown.views.get(*id);
                options.is_some_and(Options::is_of_held)
            });
            shown.theta_deg = 90.0;
            let mut harness = picture(shown.clone(), None, [1920, 1080], Theme::Dark).shapes();
            let said = |harness: &Harness<'_, App>, text: &str| {
                harness.query_all_by_label_contains(text).count()
            };
            assert_eq!(said(&harness, "reflected "), 0, "{material}");
            assert_eq!(said(&harness, "– no light arrives at θ = 90°"), 1);
            assert_eq!(said(&harness, "is in the surface plane") > 0, of_held);
            // The next angle that can be typed has its numbers again, and 90 stays what was typed.
            enter(&mut harness, "θ from n", "89.999");
            assert_eq!(said(&harness, "reflected "), 1, "{material}");
            enter(&mut harness, "θ from n", "90");
            assert_eq!(harness.state().session.theta_deg, 90.0);
            assert_eq!(said(&harness, "– no light arrives"), 1);
        }
    }
}

#[test]
fn the_words_follow_what_is_fixed() {
    let mut shown = session(&["brushed_steel"]);
    shown.theta_deg = 30.0;
    let mut harness = picture(shown, None, [1920, 1080], Theme::Dark).shapes();
    let is_said = |harness: &Harness<'_, App>, text: &str| harness.query_by_label(text).is_some();
    assert!(is_said(&harness, "Shown: where the light goes"));
    assert!(is_said(&harness, "Anisotropic: its lobe turns with it"));
    harness.get_by_label("Viewer").click();
    harness.run();
    assert!(is_said(&harness, "Shown: where the light comes from"));
    harness.state_mut().session = Session::default();
    harness.run();
    assert!(is_said(&harness, "Isotropic: turning it changes nothing"));
}
