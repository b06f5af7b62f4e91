//! What becomes of a number when it is entered, left, dragged, undone, or no number.

use brdf_explorer::bxdf::param::Value;
use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::{OfKind as _, Options, VIEWS, sphere};
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Role, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::typing::{enter, key, press, said, type_into};
use super::{picture, session, window, window_of};

fn alpha(harness: &Harness<'_, App>) -> [f64; 2] {
    let params = harness.state().session.material().components()[0].params();
    ["alpha_x", "alpha_y"].map(|name| params.number(name))
}

fn is_undo_on(harness: &Harness<'_, App>) -> bool {
    !harness.get_by_label("Undo").accesskit_node().is_disabled()
}

#[test]
fn an_accepted_number_is_one_step_and_a_refused_one_is_none() {
    let mut harness = window("rough_conductor");
    enter(&mut harness, "Roughness along s (alpha)", "0.345");
    assert_eq!(alpha(&harness), [0.345; 2], "linked");
    enter(&mut harness, "Roughness along s (alpha)", "0.5");
    enter(&mut harness, "Roughness along s (alpha)", "7");
    assert_eq!(alpha(&harness), [0.5; 2]);
    press(&mut harness, Key::Escape);
    for before in [0.345, 0.3] {
        harness.get_by_label("Undo").click();
        harness.run();
        assert_eq!(alpha(&harness), [before; 2]);
    }
    assert!(!is_undo_on(&harness));
}

#[test]
fn a_locked_parameter_follows_what_is_typed() {
    let mut harness = window_of(&["rough_conductor", "ward"]);
    harness
        .get_by_label("Link Roughness along s (alpha)")
        .click();
    harness.run();
    enter(&mut harness, "Roughness along s (alpha)", "0,123456");
    let widths = harness.state().session.materials.iter().map(|entry| {
        let params = entry.material.components()[0].params();
        params.number("alpha_x")
    });
    assert_eq!(widths.collect::<Vec<_>>(), [0.123_456; 2]);
}

#[test]
fn leaving_the_field_stores_what_is_allowed_and_marks_the_rest() {
    let mut harness = window("rough_conductor");
    let elsewhere = harness.get_by_label("Your materials").rect().center();
    for leave in ["Tab", "click"] {
        let away = |harness: &mut Harness<'_, App>| {
            if leave == "Tab" {
                press(harness, Key::Tab);
            } else {
                harness.hover_at(elsewhere);
                harness.drag_at(elsewhere);
                harness.drop_at(elsewhere);
                harness.run();
            }
        };
        type_into(&mut harness, "Roughness along s (alpha)", "0.25");
        assert_eq!(
            alpha(&harness),
            [if leave == "Tab" { 0.3 } else { 0.125 }; 2]
        );
        away(&mut harness);
        assert_eq!(alpha(&harness), [0.25; 2], "{leave}");
        type_into(&mut harness, "Roughness along s (alpha)", "2.5");
        away(&mut harness);
        let (text, words) = said(&harness, "Roughness along s (alpha)");
        assert_eq!(
            (alpha(&harness), text.as_str()),
            ([0.25; 2], "2.5"),
            "{leave}"
        );
        assert_eq!(
            words.as_deref(),
            Some("2.5 is out of range; allowed is 0.0001 to 1"),
            "{leave}"
        );
        assert!(
            !harness
                .get_by_role_and_label(Role::SpinButton, "Roughness along s (alpha)")
                .is_focused()
        );
        // A correction is taken, and Escape gives the value back.
        enter(&mut harness, "Roughness along s (alpha)", "0.125");
        assert_eq!(
            (
                alpha(&harness),
                said(&harness, "Roughness along s (alpha)").1
            ),
            ([0.125; 2], None)
        );
        type_into(&mut harness, "Roughness along s (alpha)", "0.9");
        press(&mut harness, Key::Escape);
        assert_eq!(alpha(&harness), [0.125; 2]);
        assert_eq!(said(&harness, "Roughness along s (alpha)").0, "0.125");
    }
}

#[test]
fn what_is_typed_is_stored_when_another_material_is_chosen() {
    let mut harness = window_of(&["rough_conductor", "oren_nayar"]);
    type_into(&mut harness, "Roughness along s (alpha)", "0.25");
    harness.get_by_label("Select Oren-Nayar").click();
    harness.run();
    let first = harness.state().session.materials.iter().next().unwrap();
    assert_eq!(
        first.material.to_string(),
        "rough_conductor:alpha_x=0.25,alpha_y=0.25"
    );
}

#[test]
fn the_click_that_leaves_a_field_does_what_it_does_elsewhere() {
    let mut harness = window("rough_conductor");
    enter(&mut harness, "Roughness along t (alpha)", "0.5");
    harness.get_by_label("n and k of the metal").click();
    harness.run();
    type_into(&mut harness, "n B", "0.25");
    // It stands above, in a row of its own.
    harness
        .get_by_label("Reset Roughness along s (alpha)")
        .click();
    harness.run();
    let component = &harness.state().session.material().components()[0];
    let eta = component.params().get("eta").unwrap();
    assert!(
        matches!(eta, Value::Rgb([.., blue]) if blue == 0.25),
        "{component}"
    );
    assert!(!component.to_string().contains("alpha"), "{component}");
}

/// A slow frame holds several keys.
#[test]
fn keys_of_one_frame_stay_in_their_fields() {
    let mut harness = window("oren_nayar");
    type_into(&mut harness, "Reflectance R", "0.");
    for event in [
        Event::Text("25".to_owned()),
        key(Key::Tab, egui::Modifiers::NONE),
    ] {
        harness.input_mut().events.push(event);
    }
    harness.step();
    harness.step();
    let component = &harness.state().session.material().components()[0];
    assert_eq!(component.to_string(), "oren_nayar:reflectance=0.25/0.8/0.8");
    let (green, _) = said(&harness, "Reflectance G");
    assert_eq!(green, "0.8");
}

#[test]
fn a_field_is_dragged_stepped_and_reached_by_tab() {
    let mut harness = window("rough_conductor");
    let at = harness
        .get_by_role_and_label(Role::SpinButton, "θ from n")
        .rect()
        .center();
    harness.hover_at(at);
    harness.run();
    harness.drag_at(at);
    for step in 1..=5 {
        harness.hover_at(at + vec2(8.0 * step as f32, 0.0));
        harness.step();
    }
    harness.drop_at(at + vec2(40.0, 0.0));
    harness.run();
    let dragged = harness.state().session.theta_deg;
    assert!(dragged > 55.0 && dragged <= 90.0, "{dragged}");
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(
        harness.state().session.theta_deg,
        50.0,
        "a drag is one step"
    );
    harness
        .get_by_role_and_label(Role::Slider, "θ from n")
        .focus();
    harness.run();
    press(&mut harness, Key::Tab);
    assert!(
        harness
            .get_by_role_and_label(Role::SpinButton, "θ from n")
            .is_focused()
    );
    // All is selected: what is typed takes its place.
    harness.event(Event::Text("3".to_owned()));
    harness.event(Event::Text("3,25".to_owned()));
    harness.step();
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().session.theta_deg, 33.25);
    let field = harness.get_by_role_and_label(Role::SpinButton, "θ from n");
    field.click();
    harness.run();
    for _ in 0..3 {
        press(&mut harness, Key::ArrowUp);
    }
    assert!(harness.state().session.theta_deg > 33.25);
    press(&mut harness, Key::Enter);
    harness.get_by_label("Undo").click();
    harness.run();
    let theta = harness.state().session.theta_deg;
    assert_eq!(theta, 33.25, "keys in a row are one step");
}

#[test]
fn no_tool_and_no_gesture_stores_what_is_no_number() {
    let mut harness = window("rough_conductor");
    for (role, name) in [
        (Role::Slider, "θ from n"),
        (Role::SpinButton, "θ from n"),
        (Role::Slider, "Roughness along s (alpha)"),
        (Role::SpinButton, "Roughness along s (alpha)"),
        (Role::SpinButton, "φ from s"),
    ] {
        let before = harness.state().session.clone();
        for value in [f64::NAN, f64::INFINITY] {
            harness
                .get_by_role_and_label(role, name)
                .set_value_accesskit(value);
            harness.run();
            let now = &harness.state().session;
            let theta = now.theta_deg;
            assert!(theta.is_finite() && (0.0..=90.0).contains(&theta), "{name}");
            assert!(
                alpha(&harness).iter().all(|x| (1e-4..=1.0).contains(x)),
                "{name}"
            );
            if role == Role::SpinButton || value.is_nan() {
                assert_eq!(*now, before, "{name} {value}");
            }
            harness.state_mut().session = before.clone();
            harness.run();
        }
    }
    harness
        .get_by_role_and_label(Role::SpinButton, "θ from n")
        .set_text_value_accesskit("12,5°");
    harness.run();
    assert_eq!(harness.state().session.theta_deg, 12.5);
    let mut shown = session(&["rough_conductor"]);
    shown.views.show_alone(sphere::Options::KIND);
    let window = picture(shown.clone(), None, [1280, 800], Theme::Dark);
    let mut harness = window.harness().unwrap();
    let session = &mut harness.state_mut().session;
    session.theta_deg = f64::NAN;
    let set = |sphere: &mut sphere::Options| sphere.exposure = f64::INFINITY;
    session.views.each(set);
    harness.run();
    assert_eq!(harness.state().session, shown);
    assert!(!is_undo_on(&harness), "nothing was edited");
}

#[test]
fn a_light_below_opaque_materials_is_told_with_a_way_back() {
    for view in &VIEWS {
        let below = Session {
            theta_deg: 120.0,
            ..session(&["oren_nayar"])
        };
        let text = "The light is below the surface, and nothing shown lets light through: \
            all values above it are 0";
        let mut harness = picture(below.clone(), Some(view.id), [640, 480], Theme::Dark).controls();
        let is_told = harness.query_by_label(text).is_some();
        assert_eq!(is_told, Options::of(view).is_of_held(), "{}", view.id);
        assert_eq!(harness.state().session.theta_deg, 120.0, "{}", view.id);
        if is_told {
            harness.get_by_label("Bring the light above").click();
            harness.run();
            assert_eq!(harness.state().session.theta_deg, 60.0, "{}", view.id);
            assert!(harness.query_by_label(text).is_none(), "{}", view.id);
        }
        let clear = Session {
            materials: session(&["fresnel_specular"]).materials,
            ..below
        };
        let harness = picture(clear, Some(view.id), [640, 480], Theme::Dark).controls();
        assert!(harness.query_by_label(text).is_none(), "{}", view.id);
    }
}
