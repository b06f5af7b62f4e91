//! What the hand does in each view.

use brdf_explorer::analysis::cartesian::Abscissa;
use brdf_explorer::analysis::hemisphere::Comparison;
use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::{
    Deltas, OfKind, ScaleChoice, VIEWS, cartesian, hemisphere, reflectance, sampling, sphere,
};
use brdf_explorer::ui::app::App;
use egui::{Pos2, Role, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{choose, picture, session};

const SIZE: [u32; 2] = [640, 480];

pub(super) fn alone(shown: Session, id: &str) -> Harness<'static, App> {
    picture(shown, Some(id), SIZE, Theme::Dark)
        .harness()
        .unwrap()
}

/// The options of the view of a kind.
pub(super) fn options<T: OfKind>(harness: &Harness<'_, App>) -> T {
    harness.state().session.views.options()
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

pub(super) fn canvas(harness: &Harness<'_, App>, name: &str) -> egui::Rect {
    harness.get_by_role_and_label(Role::Canvas, name).rect()
}

pub(super) fn drag(harness: &mut Harness<'_, App>, handle: &str, to: Pos2) {
    let from = harness.get_by_label(handle).rect().center();
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    harness.step();
    // While something is dragged every frame asks for the next one.
    harness.hover_at(to);
    harness.run_steps(2);
    harness.drop_at(to);
    harness.run();
}

pub(super) fn click_at(harness: &mut Harness<'_, App>, place: Pos2) {
    harness.hover_at(place);
    harness.run();
    harness.drag_at(place);
    harness.run();
    harness.drop_at(place);
    harness.run();
}

/// Whether a text with `part` in it is painted.
pub(super) fn paints(harness: &Harness<'_, App>, part: &str) -> bool {
    let shapes = harness.output().shapes.iter();
    shapes
        .map(|clipped| &clipped.shape)
        .any(|shape| matches!(shape, egui::Shape::Text(text) if text.galley.text().contains(part)))
}

#[test]
fn a_view_with_nothing_to_show_says_why() {
    for view in &VIEWS {
        let mut hidden = session(&["gold", "phong"]);
        hidden
            .materials
            .iter_mut()
            .for_each(|entry| entry.is_visible = false);
        let harness = alone(hidden, view.id);
        let is_said = harness.query_by_label("Every material is hidden").is_some();
        assert_eq!(is_said, view.says_hidden, "{}", view.id);
        let harness = alone(session(&["specular_reflection"]), view.id);
        let line = "All light is in Dirac deltas: f and the density are 0 everywhere";
        let is_said = harness.query_by_label(line).is_some();
        assert_eq!(is_said, view.deltas == Deltas::Told, "{}", view.id);
    }
}

#[test]
fn the_cartesian_plot_changes_its_angle_and_compares() {
    let mut harness = alone(session(&["gold", "plastic"]), "cartesian");
    choose(&mut harness, "Over", "Half angle");
    assert_eq!(
        options::<cartesian::Options>(&harness).abscissa,
        Abscissa::Half
    );
    let scale = "Scale of Cartesian plot";
    choose(&mut harness, scale, "Each to its peak");
    let chosen: cartesian::Options = options(&harness);
    assert_eq!(chosen.scale.choice(), ScaleChoice::EachToPeak);
    choose(&mut harness, scale, "Logarithmic");
    click(&mut harness, "To each peak");
    click(&mut harness, "Difference");
    let chosen: cartesian::Options = options(&harness);
    assert_eq!(chosen.scale.choice(), ScaleChoice::Logarithmic);
    assert!(chosen.scale.is_each_to_peak && chosen.is_residual);
    choose(&mut harness, "Reference", "Plastic");
    let materials = &harness.state().session.materials;
    assert_eq!(materials.title(materials.reference()), "Plastic");
}

#[test]
fn a_click_over_the_half_angle_holds_that_pair() {
    let mut shown = session(&["gold"]);
    shown.views.each(|plot: &mut cartesian::Options| {
        (plot.abscissa, plot.fixed_deg) = (Abscissa::Half, 20.0);
    });
    let mut harness = alone(shown, "cartesian");
    let frame = canvas(&harness, "Cartesian plot");
    click_at(&mut harness, frame.center());
    let theta = harness.state().session.theta_deg;
    // theta_h is somewhere in the middle, theta_d 20 degrees across: cos(theta) = cos(theta_h) cos(theta_d).
    assert!(theta > 30.0 && theta < 65.0, "{theta}");
}

#[test]
fn the_held_direction_is_dragged_on_the_hemisphere() {
    let mut harness = alone(session(&["gold"]), "hemisphere");
    let disc = canvas(&harness, "Gold");
    drag(
        &mut harness,
        "Light in the hemisphere",
        disc.center() + vec2(0.0, 0.2 * disc.height()),
    );
    let session = &harness.state().session;
    // Below the middle is -t; on the disc of equal areas .4 of the radius is 2 asin(.4 / sqrt 2).
    assert!((session.phi_deg + 90.0).abs() < 1.0, "{}", session.phi_deg);
    let half_sine = 0.4 / 2_f64.sqrt();
    let half = half_sine.atan2((1.0 - half_sine * half_sine).sqrt());
    let expected = 2.0 * half.to_degrees();
    assert!(
        (session.theta_deg - expected).abs() < 1.0,
        "{} {expected}",
        session.theta_deg
    );
}

#[test]
fn the_hemisphere_compares_with_the_reference() {
    let mut harness = alone(session(&["gold", "plastic", "phong"]), "hemisphere");
    choose(&mut harness, "Compared", "Difference");
    assert_eq!(
        options::<hemisphere::Options>(&harness).comparison,
        Comparison::Difference
    );
    let shows = |harness: &Harness<'_, App>, name: &str| {
        harness
            .query_by_role_and_label(Role::Canvas, name)
            .is_some()
    };
    assert!(!shows(&harness, "Gold") && shows(&harness, "Plastic") && shows(&harness, "Phong"));
    choose(&mut harness, "Reference", "Phong");
    assert!(shows(&harness, "Gold") && !shows(&harness, "Phong"));
}

#[test]
fn a_click_on_slice_and_sphere_holds_the_pair_there() {
    let mut harness = alone(session(&["gold"]), "slice");
    let rect = canvas(&harness, "Gold");
    // theta_h 45, theta_d 18: both directions lie equally far from n.
    click_at(&mut harness, rect.min + vec2(0.5, 0.8) * rect.size());
    let theta = harness.state().session.theta_deg;
    let cosine = 45_f64.to_radians().cos() * 18_f64.to_radians().cos();
    let expected = (1.0 - cosine * cosine).sqrt().atan2(cosine).to_degrees();
    assert!((theta - expected).abs() < 1.0, "{theta} {expected}");

    let mut harness = alone(session(&["gold"]), "sphere");
    let rect = canvas(&harness, "Sphere of Gold");
    // In the middle n points to the viewer: the light is as far from n as from the viewer.
    click_at(&mut harness, rect.center());
    let session = &harness.state().session;
    assert!(
        (session.theta_deg - options::<sphere::Options>(&harness).theta_deg).abs() < 1.5,
        "{}",
        session.theta_deg
    );
}

#[test]
fn the_light_of_the_sphere_is_dragged_even_behind_it() {
    let mut harness = alone(session(&["gold"]), "sphere");
    let rect = canvas(&harness, "Sphere of Gold");
    // The light of all views at first, which stays above the horizon.
    let right = rect.center() + vec2(0.25 * rect.width(), 0.0);
    drag(&mut harness, "Light of the sphere", right);
    let held = &harness.state().session;
    assert!((held.theta_deg - 31.4).abs() < 2.0 && held.phi_deg.abs() < 1.0);
    click(&mut harness, "Own light");
    drag(
        &mut harness,
        "Light of the sphere",
        rect.center() + vec2(0.25 * rect.width(), 0.0),
    );
    let shown: sphere::Options = options(&harness);
    assert!(
        shown.phi_deg.abs() < 1.0 && (shown.theta_deg - 31.4).abs() < 2.0,
        "{shown:?}"
    );
    drag(
        &mut harness,
        "Light of the sphere",
        rect.right_center() + vec2(20.0, 0.0),
    );
    assert!(options::<sphere::Options>(&harness).theta_deg > 90.0);
}

#[test]
fn parts_plots_and_factors_are_chosen() {
    let mut harness = alone(session(&["plastic"]), "reflectance");
    choose(&mut harness, "Parts", "Lobe");
    let shown: reflectance::Options = options(&harness);
    assert_eq!(shown.split, reflectance::Split::Lobe);
    let mut harness = alone(session(&["plastic"]), "sampling");
    for plot in sampling::Plot::ALL {
        choose(&mut harness, "Show", plot.title());
        assert_eq!(options::<sampling::Options>(&harness).plot, *plot);
    }
    let mut harness = alone(session(&["oren_nayar"]), "decomposition");
    choose(&mut harness, "Into", "D, G, F");
    let line = "No microfacet model among them: only those have D, G and F";
    assert!(harness.query_by_label(line).is_some());
}
