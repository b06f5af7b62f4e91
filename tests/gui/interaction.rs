//! Every gesture of the window, by accessible label.

use brdf_explorer::analysis::{Detail, Hold};
use brdf_explorer::study::platform;
use brdf_explorer::study::session::{Curves, Session};
use brdf_explorer::study::views::{Scale, ScaleChoice, lobe3d, polar};
use brdf_explorer::ui::app::App;
use egui::{Modifiers, Pos2, Role, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{choose, pick, window};

const IN_POLAR: &str = "Light in the polar plot";
const IN_LOBE: &str = "Light in the 3D lobe";

/// The text of the shares of light in the status line.
fn shares(harness: &Harness<'_, App>) -> String {
    harness
        .get_by_label_contains("reflected ")
        .value()
        .unwrap_or_default()
}

/// Drags what stands at `from` by `by`, in steps as a hand does.
fn drag(harness: &mut Harness<'_, App>, from: Pos2, by: Vec2) {
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    for step in 1..=4 {
        harness.hover_at(from + by * (step as f32 / 4.0));
        harness.step();
    }
    harness.drop_at(from + by);
    harness.run();
}

pub(super) fn drag_label(harness: &mut Harness<'_, App>, label: &str, by: Vec2) {
    let from = harness.get_by_label(label).rect().center();
    drag(harness, from, by);
}

#[test]
fn picking_a_model_changes_the_surface_and_its_sliders() {
    let mut harness = window("rough_conductor");
    assert!(harness.query_by_label("Sigma").is_none());
    let before = shares(&harness);
    pick(&mut harness, "Oren-Nayar  (R)");
    assert_eq!(harness.state().session.material().to_string(), "oren_nayar");
    // The pictures are gone: they lie over the views.
    assert!(harness.query_by_label("Search models").is_none());
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Sigma")
            .is_some()
    );
    assert!(
        harness
            .query_by_label("Roughness along s (alpha)")
            .is_none()
    );
    assert_ne!(shares(&harness), before);
}

#[test]
fn searching_narrows_the_list_and_edits_are_kept() {
    let mut harness = window("rough_conductor:alpha_x=0.1");
    harness.get_by_label("Change…").click();
    harness.run();
    harness.get_by_label("Search models").type_text("retro");
    harness.run();
    assert!(harness.query_by_label("Oren-Nayar  (R)").is_none());
    harness.get_by_label("Retro-reflector  (R)").click();
    harness.run();
    assert_eq!(
        harness.state().session.material().components()[0]
            .model()
            .id,
        "retro_reflector"
    );
    harness.get_by_label("Change…").click();
    harness.run();
    harness.get_by_label("Search models").type_text("zzz");
    harness.run();
    assert!(
        harness
            .query_by_label_contains("No model or material matches")
            .is_some()
    );
    for _ in 0..8 {
        harness.key_press(egui::Key::Backspace);
    }
    harness.run();
    harness.get_by_label("Rough conductor  (R)").click();
    harness.run();
    assert_eq!(
        harness.state().session.material().to_string(),
        "rough_conductor:alpha_x=0.1"
    );
}

#[test]
fn every_model_can_be_picked_and_shown() {
    let mut harness = window("rough_conductor");
    for model in brdf_explorer::bxdf::models::MODELS {
        let title = brdf_explorer::ui::widgets::picker::title(model);
        pick(&mut harness, &title);
        assert_eq!(
            harness.state().session.material().components()[0]
                .model()
                .id,
            model.id
        );
        let sum: f64 = shares(&harness)
            .split(' ')
            .filter_map(|word| word.parse::<f64>().ok())
            .sum();
        assert!(
            (sum - 1.0).abs() < 1e-9,
            "{}: {}",
            model.id,
            shares(&harness)
        );
    }
}

#[test]
fn a_slider_moves_its_parameter_and_the_read_out_follows() {
    let mut harness = window("rough_conductor");
    let before = shares(&harness);
    let slider = harness
        .get_by_role_and_label(Role::Slider, "Roughness along s (alpha)")
        .rect();
    drag(&mut harness, slider.center(), vec2(20.0, 0.0));
    let alpha = harness.state().session.material().components()[0]
        .params()
        .number("alpha_x");
    assert!(alpha > 0.1 && alpha != 0.3, "{alpha}");
    assert_ne!(shares(&harness), before);
    harness
        .get_by_label("Reset Roughness along s (alpha)")
        .click();
    harness.run();
    assert_eq!(
        harness.state().session.material().components()[0]
            .params()
            .number("alpha_x"),
        0.3
    );
    assert_eq!(shares(&harness), before);
}

#[test]
fn a_choice_brings_its_own_parameters() {
    let mut harness = window("rough_conductor");
    assert!(harness.query_by_label("Reset F0").is_none());
    assert!(harness.query_by_label("Reset Metal").is_some());
    harness
        .get_by_role_and_label(Role::ComboBox, "Fresnel")
        .click();
    harness.run();
    harness.get_by_label("Schlick").click();
    harness.run();
    assert_eq!(
        harness.state().session.material().components()[0]
            .params()
            .choice("fresnel"),
        "schlick"
    );
    assert!(
        harness.query_by_label("Reset F0").is_some()
            && harness.query_by_label("Reset Metal").is_none()
    );
}

#[test]
fn the_held_direction_is_dragged_in_the_polar_plot() {
    let mut harness = window("rough_conductor");
    drag_label(&mut harness, IN_POLAR, vec2(60.0, -40.0));
    let session = &harness.state().session;
    assert!(
        session.theta_deg < 40.0 && session.phi_deg == 180.0,
        "{} {}",
        session.theta_deg,
        session.phi_deg
    );
    // Across the normal, the light comes from the other side, and the section stays.
    drag_label(&mut harness, IN_POLAR, vec2(250.0, 20.0));
    let session = &harness.state().session;
    assert!(
        session.theta_deg > 10.0 && session.phi_deg == 0.0,
        "{} {}",
        session.theta_deg,
        session.phi_deg
    );
    assert_eq!(session.section().azimuth_deg, 0.0);
    // Not below the horizon: nothing would be left to see above it.
    drag_label(&mut harness, IN_POLAR, vec2(0.0, 300.0));
    assert_eq!(harness.state().session.theta_deg, 90.0);
    // Where light passes through, it may come from inside.
    let mut harness = window("fresnel_specular");
    drag_label(&mut harness, IN_POLAR, vec2(-100.0, 300.0));
    assert!(harness.state().session.theta_deg > 90.0);
}

#[test]
fn the_held_direction_is_dragged_on_the_dome() {
    let mut harness = window("rough_conductor");
    drag_label(&mut harness, IN_LOBE, vec2(60.0, 20.0));
    let session = &harness.state().session;
    assert!((session.theta_deg - 50.0).abs() > 2.0 || (session.phi_deg.abs() - 180.0).abs() > 2.0);
    let tip = harness.get_by_label(IN_LOBE).rect().center();
    drag_label(&mut harness, IN_LOBE, vec2(-30.0, 10.0));
    let moved = harness.get_by_label(IN_LOBE).rect().center() - tip;
    assert!(
        (moved - vec2(-30.0, 10.0)).length() < 3.0,
        "the handle follows the pointer: {moved:?}"
    );
}

#[test]
fn the_surface_turns_under_an_anisotropic_lobe_only() {
    for (material, turns) in [
        ("rough_conductor:alpha_x=0.1,alpha_y=0.5", true),
        ("rough_conductor", false),
    ] {
        let mut harness = window(material);
        let before = shares(&harness);
        harness
            .get_by_role_and_label(Role::Slider, "Rotate surface about n")
            .set_value_accesskit(60.0);
        harness.run();
        assert_eq!(harness.state().session.rotation_deg, 60.0);
        assert_eq!(shares(&harness) != before, turns, "{material}");
    }
}

#[test]
fn hovering_reads_out_direction_and_value() {
    let mut harness = window("lambertian_reflection");
    let horizon = harness.get_by_label(IN_POLAR).rect().center() + vec2(140.0, 0.0);
    harness.hover_at(horizon);
    harness.run();
    assert!(
        harness.query_by_label_contains("f 0.255 1/sr").is_some(),
        "0.8 / pi"
    );
    let dome = harness
        .get_by_role_and_label(Role::Canvas, "3D lobe")
        .rect()
        .center();
    harness.hover_at(dome);
    harness.run();
    assert!(
        harness.query_by_label_contains("f 0.255 1/sr").is_some(),
        "0.8 / pi"
    );
    choose(&mut harness, "Curves of Polar plot", "R, G, B");
    harness.hover_at(dome);
    harness.run();
    assert!(
        harness
            .query_by_label_contains("R 0.255  G 0.255  B 0.255")
            .is_some()
    );
}

#[test]
fn display_options_change_the_session() {
    let mut harness = window("rough_conductor");
    let click = |harness: &mut Harness<'_, App>, label: &str| {
        harness.get_by_label(label).click();
        harness.run();
    };
    let of = |what: &str| format!("{what} of Polar plot");
    choose(&mut harness, &of("Scale"), "Logarithmic");
    choose(&mut harness, &of("Curves"), "R, G, B");
    choose(&mut harness, &of("Section"), "At azimuth");
    for label in ["Times cos θ of 3D lobe", "Viewer", "Angles"] {
        click(&mut harness, label);
    }
    let session = &harness.state().session;
    let plot: polar::Options = session.views.options();
    let lobe: lobe3d::Options = session.views.options();
    assert_eq!(plot.scale.choice(), ScaleChoice::Logarithmic);
    assert_eq!(lobe.scale, Scale::default(), "each view has its own");
    assert!(session.with_cosine && session.show_geometry && session.hold == Hold::Viewer);
    assert!(session.section_phi_deg == Some(0.0) && session.curves == Curves::Rgb);
    choose(&mut harness, &of("Scale"), "Same scale");
    choose(&mut harness, &of("Curves"), "Luminance");
    choose(&mut harness, &of("Section"), "Plane of incidence");
    for label in ["Times cos θ of Polar plot", "Light", "Angles"] {
        click(&mut harness, label);
    }
    let mut session = harness.state().session.clone();
    session.camera = Session::default().camera;
    let before = super::session(&["rough_conductor"]);
    assert_eq!(session, before);
}

#[test]
fn the_camera_orbits_zooms_and_returns() {
    let mut harness = window("rough_conductor");
    let home = harness.state().session.camera.clone();
    let corner = harness
        .get_by_role_and_label(Role::Canvas, "3D lobe")
        .rect()
        .center()
        + vec2(-120.0, 200.0);
    drag(&mut harness, corner, vec2(80.0, 10.0));
    let orbited = harness.state().session.camera.clone();
    assert_ne!(orbited.yaw(), home.yaw());
    harness.hover_at(corner);
    harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 120.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    harness.run_steps(12);
    assert!(harness.state().session.camera.distance() < orbited.distance());
    harness.get_by_label("Side").click();
    harness.run();
    assert_eq!(harness.state().session.camera.pitch(), 0.0);
    // Within one frame, since the harness lets a quarter of a second pass between frames.
    for pressed in [true, false, true, false] {
        harness.input_mut().events.push(egui::Event::PointerButton {
            pos: corner,
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
    }
    harness.run();
    assert_eq!(
        harness.state().session.camera,
        home,
        "a double click resets"
    );
}

#[test]
fn the_window_rests_when_nothing_happens() {
    let mut harness = window("rough_conductor");
    harness.run();
    let delay = harness
        .output()
        .viewport_output
        .values()
        .next()
        .unwrap()
        .repaint_delay;
    assert!(
        delay > std::time::Duration::from_hours(1),
        "a repaint is due in {delay:?}"
    );
}

#[test]
fn no_time_is_shown() {
    let mut harness = window("rough_conductor");
    harness.get_by_label("Up to date").hover();
    harness.run_steps(8);
    assert!(harness.query_by_label_contains(" ms").is_none());
}

#[test]
fn how_long_an_update_took_is_told_to_who_points_there() {
    let mut harness = Harness::builder()
        .with_size(vec2(1280.0, 800.0))
        .with_max_steps(32)
        .build_eframe(|cc| App::new(cc, Session::default(), None, Some(platform::seconds)));
    let begin = std::time::Instant::now();
    while harness.state().shown() != Some(Detail::Full)
        || harness.query_by_label("Up to date").is_none()
    {
        assert!(begin.elapsed().as_secs() < 60, "the answers never come");
        std::thread::sleep(std::time::Duration::from_millis(5));
        harness.step();
    }
    assert!(harness.query_by_label_contains(" ms").is_none());
    harness.get_by_label("Up to date").hover();
    harness.run_steps(8);
    assert!(
        harness
            .query_by_label_contains("the last change took")
            .is_some()
    );
}
