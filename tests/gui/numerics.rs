//! What the hand does with the trade-off and the stability, and what they say first.

use brdf_explorer::analysis::hemisphere::Comparison;
use brdf_explorer::lab::tradeoff::Question;
use brdf_explorer::study::views::{hemisphere, stability, tradeoff};
use brdf_explorer::ui::app::App;
use egui::{Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::views::{alone, canvas, click_at, drag, options, paints};
use super::{choose, measure_tradeoff, session};

#[test]
fn the_tradeoff_is_measured_when_asked_for_and_its_tolerance_is_dragged() {
    let mut harness = alone(session(&["gold"]), "tradeoff");
    assert!(harness.query_by_label("The material as a whole").is_none());
    measure_tradeoff(&mut harness);
    assert!(harness.query_by_label("The material as a whole").is_some());
    let before = options::<tradeoff::Options>(&harness).tolerance;
    let handle = harness
        .get_by_label("Line of the tolerance")
        .rect()
        .center();
    let frame = canvas(&harness, "How to evaluate f");
    drag(
        &mut harness,
        "Line of the tolerance",
        handle + vec2(0.0, 0.2 * frame.height()),
    );
    let after = options::<tradeoff::Options>(&harness).tolerance;
    assert!(after < 0.5 * before, "{before} {after}");
}

#[test]
fn both_questions_of_the_tradeoff_are_answered_first_and_share_the_tolerance() {
    let mut shown = session(&["gold"]);
    shown.views.each(|tradeoff: &mut tradeoff::Options| {
        tradeoff
            .left_out
            .retain(|id| id != "mesh" && id != "tables");
    });
    let mut harness = alone(shown, "tradeoff");
    measure_tradeoff(&mut harness);
    for question in Question::ALL {
        let _ = canvas(&harness, question.title());
        let heading = format!("{}:", question.title());
        assert!(harness.query_by_label(&heading).is_some(), "{heading}");
    }
    let within = |harness: &Harness<'_, App>, tolerance: &str| {
        let text = format!("cheapest within {tolerance}: “");
        harness.query_all_by_label_contains(&text).count()
    };
    assert_eq!(within(&harness, "1\u{a0}%"), 2);
    let lines = [
        "Line of the tolerance",
        "Line of the tolerance of integrals",
    ];
    let at = harness.get_by_label(lines[1]).rect().center();
    let [first, _] = lines.map(|line| harness.get_by_label(line).rect().center());
    drag(&mut harness, lines[1], at + vec2(0.0, 12.0));
    let tolerance = options::<tradeoff::Options>(&harness).tolerance;
    assert!(tolerance < 0.005, "{tolerance}");
    assert_eq!(within(&harness, "1\u{a0}%"), 0);
    let [evaluated, integrated] = lines.map(|line| harness.get_by_label(line).rect().center());
    assert!(evaluated.y > first.y + 5.0 && integrated.y > at.y + 5.0);
}

#[test]
fn families_that_do_not_apply_are_neither_drawn_nor_offered() {
    // Light crosses it, and tables are of what is reflected.
    let mut shown = session(&["frosted_glass"]);
    shown.views.each(|tradeoff: &mut tradeoff::Options| {
        tradeoff.left_out.retain(|id| id != "tables");
    });
    let mut harness = alone(shown, "tradeoff");
    let offered = |harness: &mut Harness<'_, App>, family: &str| {
        harness.get_by_label("Choices").click();
        harness.run();
        let role = Role::CheckBox;
        let found = harness.query_by_role_and_label(role, family).is_some();
        harness.key_press(egui::Key::Escape);
        harness.run();
        found
    };
    assert!(offered(&mut harness, "Tables"));
    measure_tradeoff(&mut harness);
    assert!(harness.query_all_by_label("Precision").next().is_some());
    assert!(harness.query_all_by_label("Tables").next().is_none());
    assert!(offered(&mut harness, "Precision") && !offered(&mut harness, "Tables"));
    // Where nothing applies it is said why.
    let mut harness = alone(session(&["mirror"]), "tradeoff");
    measure_tradeoff(&mut harness);
    let why = "nothing to choose, because its light is all in Dirac deltas";
    assert!(harness.query_by_label_contains(why).is_some());
}

#[test]
fn the_stability_of_a_material_is_judged_first() {
    let harness = alone(session(&["gold"]), "stability");
    let verdict = harness.get_by_label_contains("f32 is safe: the worst error is ");
    let map = canvas(&harness, "Map of f32");
    assert!(verdict.rect().bottom() < map.top());
    let harness = alone(session(&["mirror"]), "stability");
    let nothing = "No digit is lost here: a Dirac delta has ";
    assert!(harness.query_by_label_contains(nothing).is_some());
}

#[test]
fn a_choice_of_the_tradeoff_becomes_a_material_that_is_compared() {
    let mut harness = alone(session(&["gold"]), "tradeoff");
    measure_tradeoff(&mut harness);
    let frame = canvas(&harness, "How to evaluate f");
    // The marks are found as by hand: where the pointer reads one out that loses something.
    let places = (0..).map(|i| frame.min + vec2(5.0 * (i / 60) as f32, 5.0 * (i % 60) as f32));
    let places = places.take_while(|place| place.x < frame.max.x);
    let mark = places.filter(|place| frame.contains(*place)).find(|place| {
        harness.hover_at(*place);
        harness.run();
        paints(&harness, "\nlost: ")
    });
    click_at(&mut harness, mark.unwrap());
    let session = &harness.state().session;
    let materials = &session.materials;
    assert_eq!(materials.iter().count(), 2);
    assert!(
        materials.title(materials.selected()).starts_with("Gold: "),
        "{}",
        materials.title(materials.selected())
    );
    assert_eq!(materials.title(materials.reference()), "Gold");
    let map: hemisphere::Options = session.views.options();
    assert_eq!(map.comparison, Comparison::Difference);
}

#[test]
fn the_advised_choice_is_used_and_then_offered_as_a_file() {
    let mut shown = session(&["gold"]);
    shown
        .views
        .each(|tradeoff: &mut tradeoff::Options| tradeoff.tolerance = 0.02);
    let mut harness = alone(shown, "tradeoff");
    measure_tradeoff(&mut harness);
    assert!(harness.query_all_by_label("Save it…").next().is_none());
    // The material as a whole comes first.
    harness.query_all_by_label("Use it").next().unwrap().click();
    harness.run();
    let material = harness.state().session.material().clone();
    assert!(material.name.starts_with("Gold: "), "{}", material.name);
    assert!(harness.query_all_by_label("Save it…").next().is_some());
}

#[test]
fn the_maps_of_errors_and_the_worst_points_lead_there() {
    let mut harness = alone(session(&["rough_conductor:fresnel=one"]), "stability");
    let before = harness.state().session.clone();
    choose(&mut harness, "Across", "alpha");
    choose(&mut harness, "Up", "90° − θo (°)");
    let shown: stability::Options = options(&harness);
    assert_eq!([&*shown.x, &*shown.y], ["alpha", "grazing_o"]);
    // A place of the map is a width and an angle.
    let map = canvas(&harness, "Map of f64");
    click_at(&mut harness, map.left_top() + vec2(0.25, 0.5) * map.size());
    let session = &harness.state().session;
    let material = session.material().to_string();
    let width = session.material().components()[0]
        .params()
        .number("alpha_x");
    assert!((width / 1e-3 - 1.0).abs() < 1e-4, "{material}");
    assert_ne!(*session.material(), *before.material());
    // A worst point is a pair.
    let held = session.held();
    let point = harness.query_all_by_label_contains(", f64: ").nth(1);
    point.unwrap().click();
    harness.run();
    assert_ne!(harness.state().session.held(), held);
}

#[test]
fn formulas_are_compared_in_a_tab_and_shown_as_maps_where_they_have_two_arguments() {
    let mut harness = alone(session(&["gold"]), "stability");
    harness.get_by_label("Formulas compared").click();
    harness.run();
    choose(&mut harness, "Formula", "GTR1 distribution of a clear coat");
    assert_eq!(options::<stability::Options>(&harness).trial, "gtr1");
    assert!(harness.query_by_label("Textbook").is_some());
    let frame = harness
        .get_by_role_and_label(Role::Canvas, "Formulas compared")
        .rect();
    harness.hover_at(frame.center());
    harness.run();
    assert!(paints(&harness, "textbook: "));
    let verdict =
        "in f32 the textbook's form gives no number (Width a, half a width off the normal: ";
    assert!(harness.query_by_label_contains(verdict).is_some());
    choose(&mut harness, "As", "Maps");
    let map = canvas(&harness, "Map of core, f64");
    harness.hover_at(map.center());
    harness.run();
    assert!(paints(&harness, "Sine off the normal, in widths: "));
    assert!(paints(&harness, "textbook: "));
    // Of one argument there is no map.
    choose(&mut harness, "Formula", "Energy lost by Fujii's Oren-Nayar");
    assert!(harness.query_by_label("Map of core, f64").is_none());
    assert!(
        harness
            .query_by_role_and_label(Role::Canvas, "Formulas compared")
            .is_some()
    );
}

#[test]
fn the_forms_under_a_coat_say_what_they_break() {
    let mut harness = alone(session(&["gold"]), "stability");
    harness.get_by_label("Under a coat").click();
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Canvas, "Diffuse part under a coat")
            .is_some()
    );
    for part in [
        "Reciprocal: 0.874 from 60° to 0°, and back; keeps energy",
        "Reciprocal: 0.958 from 60° to 0°, and back; breaks energy",
        "Not reciprocal: 0.911 from 60° to 0°, 0.96 back; keeps energy",
    ] {
        let found = harness.query_by_label_contains(part).is_some();
        assert!(found, "{part}");
    }
}

/// Errors need no clock: they are there before anything is measured.
#[test]
fn how_far_choices_are_off_is_seen_before_anything_is_measured() {
    let mut harness = alone(session(&["titanium"]), "tradeoff");
    harness.run();
    let seen =
        |harness: &Harness<'_, App>, text: &str| harness.query_all_by_label_contains(text).count();
    assert!(seen(&harness, "Press Measure") == 1 && seen(&harness, "Schlick") > 0);
    assert!(seen(&harness, "error 0 (exact)") > 0);
    assert_eq!(seen(&harness, " ns"), 0, "a time");
}
