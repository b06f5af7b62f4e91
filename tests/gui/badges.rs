//! The physical check badges, by accessible label.

use brdf_explorer::analysis::Hold;
use brdf_explorer::bxdf::{Component, Material};
use brdf_explorer::lab::contract::{LawId, check_physical};
use brdf_explorer::study::session::Session;
use brdf_explorer::ui::app::App;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{material, picture, session, window, window_of};

/// Breaks reciprocity, as declared.
const TURQUIN: &str = "rough_conductor:alpha=1,fresnel=one,compensation=turquin";

/// Creates energy, as declared.
pub const BRIGHT: &str = "phong:diffuse=1,specular=1";

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn witness(text: &str, law: LawId) -> brdf_explorer::lab::contract::Witness {
    let reports = check_physical(&material(text), &|| true).unwrap();
    let report = reports.into_iter().find(|report| report.law == law);
    report.unwrap().witness
}

#[test]
fn a_material_that_keeps_the_laws_says_so() {
    let harness = window_of(&["plastic", "rough_conductor:alpha_x=0.1,alpha_y=0.5"]);
    for name in [
        "Laws of Plastic: kept",
        "Laws of Rough conductor: kept",
        "Reciprocity of Plastic: kept",
        "Energy of Plastic: kept",
        "Non-negativity of Plastic: kept",
        "Isotropy of Plastic: isotropic",
    ] {
        assert!(harness.query_by_label(name).is_some(), "{name}");
    }
}

#[test]
fn a_broken_law_is_told_apart_and_followed_by_edits() {
    let mut harness = window_of(&["rough_conductor:alpha_x=0.1,alpha_y=0.5", BRIGHT]);
    let is_said = |harness: &Harness<'_, App>, name: &str| harness.query_by_label(name).is_some();
    assert!(is_said(
        &harness,
        "Isotropy of Rough conductor: anisotropic"
    ));
    assert!(is_said(
        &harness,
        "Laws of Phong: Energy broken as published"
    ));
    click(&mut harness, "Select Phong");
    assert!(is_said(&harness, "Energy of Phong: broken as published"));
    assert!(is_said(&harness, "Reciprocity of Phong: kept"));
    click(&mut harness, "Reset all of Phong");
    assert!(is_said(&harness, "Energy of Phong: kept"));
    assert!(is_said(&harness, "Laws of Phong: kept"));
}

#[test]
fn a_click_holds_the_worst_direction() {
    for hold in [Hold::Light, Hold::Viewer] {
        let mut shown = session(&[TURQUIN]);
        (shown.hold, shown.rotation_deg) = (hold, 30.0);
        let mut harness = picture(shown, None, [1280, 800], egui::Theme::Dark)
            .harness()
            .unwrap();
        let before = harness.state().session.held();
        let at = witness(TURQUIN, LawId::Reciprocity);
        click(
            &mut harness,
            "Reciprocity of Rough conductor: broken as published",
        );
        let session = &harness.state().session;
        assert_eq!(session.hold, hold);
        let worst = match hold {
            Hold::Light => at.wi,
            Hold::Viewer => at.wo,
        };
        let worst = session.on_surface(worst.unwrap());
        assert!(session.held().distance(worst) < 1e-9, "{hold:?}");
        assert!(session.held().distance(before) > 1e-3, "{hold:?}");
        // The cursor is at the other direction of the pair: the status line reads its value there.
        assert!(
            harness
                .query_by_label("Point at a view to read its value")
                .is_none()
        );
    }
}

#[test]
fn the_symbol_in_the_list_selects_and_jumps() {
    let mut harness = window_of(&["plastic", BRIGHT]);
    harness.state_mut().session.hold = Hold::Viewer;
    harness.run();
    click(&mut harness, "Laws of Phong: Energy broken as published");
    let session = &harness.state().session;
    assert_eq!(session.materials.selected().title(), "Phong");
    // Energy is of the light alone.
    assert_eq!(session.hold, Hold::Light);
    let worst = witness(BRIGHT, LawId::Energy).wi.unwrap();
    assert!(session.held().distance(worst) < 1e-9);
    // It is a step that can be undone.
    click(&mut harness, "Undo");
    assert_eq!(harness.state().session.theta_deg, 50.0);
}

#[test]
fn kept_laws_in_the_list_do_not_move_the_light() {
    let mut harness = window("plastic");
    let before = harness.state().session.held();
    click(&mut harness, "Laws of Plastic: kept");
    assert_eq!(harness.state().session.held(), before);
}

/// At the smallest usual window nothing of a row lies outside the panel, and no long name pushes the badge away.
#[test]
fn rows_hold_their_badges() {
    let shown = session(&["plastic", "rough_conductor", "oren_nayar"]);
    let harness = picture(shown, None, [1100, 640], egui::Theme::Dark)
        .harness()
        .unwrap();
    let rect = |label: &str| harness.get_by_label(label).rect();
    for title in ["Plastic", "Rough conductor", "Oren-Nayar"] {
        let badge = rect(&format!("Laws of {title}: kept"));
        let menu = rect(&format!("Menu of {title}"));
        let name = rect(&format!("Select {title}"));
        assert!(
            name.right() <= badge.left() && badge.right() <= menu.left(),
            "{title}"
        );
        assert!(
            menu.right() < brdf_explorer::ui::theme::SIDE_WIDTH,
            "{title}"
        );
    }
}

/// The laws of the selected material stand in one line, the longest word among them too.
#[test]
fn the_laws_stand_in_one_line() {
    let shown = session(&["rough_conductor:alpha_x=0.1,alpha_y=0.5", BRIGHT, TURQUIN]);
    let harness = picture(shown, None, [1100, 640], egui::Theme::Dark)
        .harness()
        .unwrap();
    let rect = |label: &str| harness.get_by_label(label).rect();
    let first = rect("Reciprocity of Rough conductor: kept");
    let [second, last] =
        ["Energy", "Non-negativity"].map(|law| rect(&format!("{law} of Rough conductor: kept")));
    assert_eq!([second.top(), last.top()], [first.top(); 2]);
    let kind = rect("Isotropy of Rough conductor: anisotropic");
    assert!(kind.top() >= first.bottom() && kind.left() == first.left());
    assert!(last.right() < brdf_explorer::ui::theme::SIDE_WIDTH);
}

/// Two lobes that add up to more than one.
fn bright() -> Material {
    let lobes = ["lambertian_reflection:reflectance=.9", "rough_conductor"];
    let lobes = lobes.map(|text| text.parse().unwrap()).to_vec();
    Material::new(lobes).unwrap()
}

#[test]
fn lobes_that_add_up_say_so_and_are_scaled_in_one_step() {
    let before = bright();
    let mut harness = picture(
        Session::of(before.clone()),
        None,
        [1280, 800],
        egui::Theme::Dark,
    )
    .harness()
    .unwrap();
    let reports = check_physical(&before, &|| true).unwrap();
    let energy = reports.into_iter().find(|one| one.law == LawId::Energy);
    let energy = energy.unwrap();
    let sentence = energy.sentence().unwrap();
    assert!(sentence.ends_with("more leaves than arrives, because the lobes add up"));
    assert!(harness.query_by_label(&sentence).is_some(), "{sentence}");
    click(&mut harness, "Go there");
    let session = &harness.state().session;
    assert!(session.held().distance(energy.witness.wi.unwrap()) < 1e-9);
    click(&mut harness, "Scale the weights");
    let title = before.title();
    let kept = format!("Energy of {title}: kept");
    assert!(harness.query_by_label(&kept).is_some());
    assert!(harness.query_by_label("Scale the weights").is_none());
    let after = harness.state().session.material().clone();
    let weights: Vec<f64> = after.components().iter().map(Component::weight).collect();
    let [first, second] = weights[..] else {
        panic!("{weights:?}");
    };
    assert!(first == second && first < 1.0 / (1.0 + energy.worst) && first > 0.4);
    click(&mut harness, "Undo");
    assert_eq!(*harness.state().session.material(), before);
}

#[test]
fn what_keeps_energy_needs_no_remedy() {
    let harness = window("gold");
    assert!(harness.query_by_label("Energy of Gold: kept").is_some());
    assert!(harness.query_by_label("Scale the weights").is_none());
}
