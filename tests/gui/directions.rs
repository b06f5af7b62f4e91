//! Light and viewer, by accessible labels.

use brdf_explorer::analysis::Hold;
use brdf_explorer::analysis::half_difference::Spherical;
use brdf_explorer::bxdf::math::frame;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::theme::Palette;
use egui::{Key, Modifiers, Role, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::files::work_in;
use super::interaction::drag_label;
use super::{Folder, picture, session, window};

#[test]
fn light_and_viewer_are_dragged_and_exchange_what_is_fixed() {
    let mut harness = window("lambertian_reflection:reflectance=0.5");
    let angles = |harness: &Harness<'_, App>| {
        let session = &harness.state().session;
        [session.held(), session.other()].map(|w| {
            let (theta, phi) = (frame::theta(w), frame::phi(w));
            // Half a turn either way is one azimuth.
            let phi_deg = phi.to_degrees().round().rem_euclid(360.0);
            (theta.to_degrees().round(), phi_deg)
        })
    };
    assert_eq!(angles(&harness), [(50.0, 180.0), (50.0, 0.0)]);
    // The viewer follows the light until it is put.
    for viewer in ["Viewer in the polar plot", "Viewer in the 3D lobe"] {
        let light = angles(&harness)[0];
        let before = angles(&harness)[1];
        drag_label(&mut harness, viewer, vec2(-8.0, -30.0));
        let [held, other] = angles(&harness);
        assert_eq!(held, light, "{viewer}: the light stays");
        assert_ne!(other, before, "{viewer}");
    }
    let [light, viewer] = angles(&harness);
    // Both are read: 0.5 / pi wherever they are.
    assert!(harness.query_by_label_contains("f 0.159 1/sr").is_some());
    let place = |harness: &Harness<'_, App>, name| harness.get_by_label(name).rect().center();
    let before =
        ["Light in the polar plot", "Viewer in the polar plot"].map(|of| place(&harness, of));
    harness.key_press(Key::H);
    harness.run();
    assert_eq!(harness.state().session.hold, Hold::Viewer);
    assert_eq!(angles(&harness), [viewer, light], "each is where it was");
    let after =
        ["Light in the polar plot", "Viewer in the polar plot"].map(|of| place(&harness, of));
    // The section is that of what is fixed: theta stays.
    assert!((after[0].y - before[0].y).abs() < 1.0 && (after[1].y - before[1].y).abs() < 1.0);
    harness.get_by_label("Light").click();
    harness.run();
    assert_eq!(angles(&harness), [light, viewer]);
    // One drag is one step.
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(harness.state().session.hold, Hold::Viewer);
}

/// Theta and phi of the light and of the viewer, to a tenth of a degree.
fn angles(harness: &Harness<'_, App>) -> [[f64; 2]; 2] {
    let session = &harness.state().session;
    [session.light(), session.viewer()].map(|w| {
        let place = Spherical::of(w);
        [place.theta_deg, place.phi_deg].map(|angle| (10.0 * angle).round() / 10.0)
    })
}

#[test]
fn arrow_keys_move_a_handle_that_has_the_focus_and_nothing_else() {
    for (view, light, viewer) in [
        ("lobe3d", "Light in the 3D lobe", "Viewer in the 3D lobe"),
        (
            "hemisphere",
            "Light in the hemisphere",
            "Viewer in the hemisphere",
        ),
        ("sphere", "Light of the sphere", "Viewer of the sphere"),
    ] {
        let mut start = session(&["gold"]);
        start.set_other(frame::direction_from_degrees(20.0, 30.0));
        (start.theta_deg, start.phi_deg) = (40.0, -120.0);
        let mut harness = picture(start, Some(view), [640, 480], Theme::Dark)
            .harness()
            .unwrap();
        let press = |harness: &mut Harness<'_, App>, modifiers, key| {
            harness.key_press_modifiers(modifiers, key);
            harness.run();
        };
        harness.get_by_label(light).focus();
        harness.run();
        press(&mut harness, Modifiers::NONE, Key::ArrowUp);
        press(&mut harness, Modifiers::NONE, Key::ArrowRight);
        assert_eq!(angles(&harness), [[39.0, -119.0], [20.0, 30.0]], "{view}");
        press(&mut harness, Modifiers::SHIFT, Key::ArrowDown);
        press(&mut harness, Modifiers::SHIFT, Key::ArrowLeft);
        assert_eq!(angles(&harness), [[39.1, -119.1], [20.0, 30.0]], "{view}");
        assert!(harness.get_by_label(light).is_focused(), "{view}");
        harness.get_by_label(viewer).focus();
        harness.run();
        press(&mut harness, Modifiers::NONE, Key::ArrowDown);
        assert_eq!(angles(&harness)[1], [21.0, 30.0], "{view}");
        let node = harness.get_by_label(viewer);
        assert_eq!(node.value().as_deref(), Some("θ 21°, φ 30°"), "{view}");
    }
}

#[test]
fn arrow_keys_move_along_the_circle_in_one_step_of_the_history() {
    let mut harness = window("gold");
    harness.get_by_label("Light in the polar plot").focus();
    harness.run();
    let start = angles(&harness);
    for _ in 0..3 {
        harness.key_press(Key::ArrowRight);
        harness.run();
    }
    // It stands at the left: to the right is towards n.
    assert_eq!(angles(&harness)[0], [47.0, 180.0]);
    harness.key_press(Key::ArrowUp);
    harness.run();
    assert_eq!(angles(&harness)[0], [46.0, 180.0]);
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(angles(&harness), start);
}

/// What is marked of the direction pointed at, as the strength of its ink.
fn crosses(harness: &Harness<'_, App>) -> Vec<u8> {
    let faint = Palette::of(Theme::Dark).faint_ink;
    let shapes = harness.output().shapes.iter();
    let arm = |clipped: &egui::epaint::ClippedShape| match &clipped.shape {
        egui::Shape::LineSegment { stroke, .. } if (stroke.width - 1.2).abs() < 1e-6 => {
            Some(stroke.color.a())
        }
        _ => None,
    };
    assert_eq!(faint.a(), 255);
    shapes.filter_map(arm).collect()
}

#[test]
fn the_direction_pointed_at_fades_and_then_nothing_is_drawn_any_more() {
    let mut harness = window("gold");
    let at = harness
        .get_by_label("Light in the polar plot")
        .rect()
        .center();
    harness.hover_at(at + vec2(60.0, 60.0));
    harness.run();
    assert!(crosses(&harness).iter().all(|strength| *strength == 255));
    let pointed = crosses(&harness).len();
    assert!(pointed > 0);
    harness.hover_at(egui::pos2(640.0, 12.0));
    // A frame lasts a quarter of a second here.
    harness.step();
    harness.step();
    let fading = crosses(&harness);
    assert!(
        !fading.is_empty() && fading.iter().all(|strength| *strength < 255),
        "{fading:?}"
    );
    harness.run();
    assert!(crosses(&harness).is_empty());
    harness.hover_at(egui::pos2(640.0, 12.0));
    harness.run();
    assert!(!harness.ctx.has_requested_repaint(), "it rests");
}

/// Where a text is painted that begins so.
fn painted(harness: &Harness<'_, App>, start: &str) -> Option<egui::Rect> {
    let mut shapes = harness.output().shapes.iter();
    shapes.find_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) if text.galley.text().starts_with(start) => {
            Some(text.visual_bounding_rect())
        }
        _ => None,
    })
}

#[test]
fn tooltips_stand_away_from_handles_and_go_when_something_is_taken() {
    let mut harness = window("gold");
    for (role, what, hint) in [
        (
            Role::GraphicsObject,
            "Light in the polar plot",
            "The light. Drag it",
        ),
        (Role::Slider, "θ from n", "θ: polar angle of the light"),
        (Role::SpinButton, "θ from n", "θ: polar angle of the light"),
    ] {
        let rect = harness.get_by_role_and_label(role, what).rect();
        harness.hover_at(rect.center());
        harness.run_steps(6);
        let tooltip = painted(&harness, hint).unwrap();
        if role == Role::GraphicsObject {
            assert!(!tooltip.intersects(rect.expand(40.0)), "{tooltip:?}");
        }
        harness.drag_at(rect.center());
        harness.run_steps(2);
        harness.hover_at(rect.center() + vec2(2.0, 0.0));
        harness.run_steps(6);
        assert_eq!(painted(&harness, hint), None, "{what}");
        harness.drop_at(rect.center() + vec2(2.0, 0.0));
        harness.hover_at(egui::pos2(640.0, 12.0));
        harness.run();
    }
}

/// Who reduces motion sees no mark fade and no camera glide, and so it is at the next start.
#[test]
fn nothing_moves_by_itself_where_motion_is_reduced() {
    let folder = Folder::new("motion");
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    for name in ["Theme", "Reduce motion"] {
        harness.get_by_label(name).click();
        harness.run();
    }
    let mut next = window("gold");
    work_in(&mut next, &folder);
    next.run();
    for mut harness in [harness, next] {
        harness.key_press(Key::Escape);
        harness.run();
        let at = harness
            .get_by_label("Light in the polar plot")
            .rect()
            .center();
        harness.hover_at(at + vec2(60.0, 60.0));
        harness.run();
        assert!(!crosses(&harness).is_empty());
        harness.hover_at(egui::pos2(640.0, 12.0));
        harness.step();
        harness.step();
        assert!(crosses(&harness).is_empty(), "a mark fades");
    }
}
