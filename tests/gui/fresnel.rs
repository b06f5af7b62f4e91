//! The view of an interface: which one, from where, and what stands at its angles.

use brdf_explorer::bxdf::Material;
use brdf_explorer::study::export::Format;
use brdf_explorer::study::session::Session;
use brdf_explorer::study::views::{OfKind as _, fresnel};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::export;
use egui::{Pos2, Rect, Role, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::typing::{enter, said};
use super::{choose, material, picture, session};

const VIEW: &str = "fresnel";

fn alone(shown: Session, size: [u32; 2]) -> Harness<'static, App> {
    picture(shown, Some(VIEW), size, Theme::Dark).controls()
}

fn options(harness: &Harness<'_, App>) -> fresnel::Options {
    harness.state().session.views.options()
}

/// All that is painted, with where it stands.
fn texts(harness: &Harness<'_, App>) -> Vec<(String, Rect)> {
    let shapes = harness.output().shapes.iter();
    let texts = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) => Some((
            text.galley.text().to_owned(),
            text.visual_bounding_rect().intersect(clipped.clip_rect),
        )),
        _ => None,
    });
    texts.collect()
}

fn paints(harness: &Harness<'_, App>, part: &str) -> bool {
    texts(harness).iter().any(|(text, _)| text.contains(part))
}

const GLASS: &str = "fresnel_specular:eta=1.5";

#[test]
fn brewster_s_and_the_critical_angle_are_marked() {
    let mut harness = alone(session(&[GLASS]), [800, 500]);
    assert!(paints(&harness, "Brewster 56.31°") && !paints(&harness, "critical 4"));
    choose(&mut harness, "From", "Below");
    assert_eq!(options(&harness).seen_from, fresnel::SeenFrom::Below);
    assert!(paints(&harness, "Brewster 33.69°") && paints(&harness, "critical 41.81°"));
    // Held at 45 degrees the light is beyond it.
    harness.state_mut().session.set_theta_deg(45.0);
    harness.run();
    assert!(paints(&harness, "no real angle"));
    harness.state_mut().session.set_theta_deg(30.0);
    harness.run();
    assert!(paints(&harness, "θt 48.59°") && paints(&harness, "= 0.75"));
}

#[test]
fn the_held_direction_says_from_where_and_a_click_holds_an_angle() {
    let mut shown = session(&[GLASS]);
    shown.set_theta_deg(160.0);
    let mut harness = alone(shown, [800, 500]);
    assert!(paints(&harness, "θ from below (degrees)"));
    let frame = harness
        .get_by_role_and_label(Role::Canvas, "Fresnel specular")
        .rect();
    let place = Pos2::new(frame.left() + 0.5 * frame.width(), frame.center().y);
    harness.hover_at(place);
    harness.run();
    assert!(paints(&harness, "\nmean  "));
    harness.drag_at(place);
    harness.run();
    harness.drop_at(place);
    harness.run();
    let theta = harness.state().session.theta_deg;
    assert!((theta - 135.0).abs() < 0.6, "{theta}");
    // Metals are seen from above only.
    let mut below = session(&["gold"]);
    below.set_theta_deg(150.0);
    let harness = alone(below, [800, 500]);
    assert!(paints(&harness, "θ from above (degrees)") && paints(&harness, "no real angle"));
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "From")
            .is_none()
    );
}

#[test]
fn a_metal_has_the_minimum_of_each_channel_or_is_shown_over_the_wavelength() {
    let mut harness = alone(session(&["gold"]), [1000, 600]);
    for channel in ["R", "G", "B"] {
        let is_marked = paints(&harness, &format!("{channel} least p "));
        // Its red reflects all, whatever the angle.
        assert_eq!(is_marked, channel != "R", "{channel}");
    }
    choose(&mut harness, "Over", "Wavelength");
    assert_eq!(options(&harness).over, fresnel::Over::Wavelength);
    assert!(paints(&harness, "wavelength (nm), at θ "));
    // No table is known of an invented one.
    let invented = "rough_conductor:eta=0.3,k=2.9";
    let harness = alone(session(&[invented]), [1000, 600]);
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "Over")
            .is_none()
    );
}

#[test]
fn the_lobe_of_a_mixture_is_chosen() {
    let half = |text: &str| {
        let mut component = material(text).components()[0].clone();
        component.set_weight(0.5).unwrap();
        component
    };
    let lobes = ["plastic:eta=1.5", "rough_conductor:eta=0.3,k=2.9"].map(half);
    let shown = Session::of(Material::new(lobes.to_vec()).unwrap());
    let mut harness = alone(shown, [1000, 600]);
    assert!(paints(&harness, "Brewster 56.31°"));
    choose(&mut harness, "Lobe", "2: Rough conductor");
    assert_eq!(options(&harness).lobe, 1);
    assert!(paints(&harness, "least p ") && !paints(&harness, "Brewster"));
}

#[test]
fn without_an_interface_an_index_is_typed() {
    for id in ["lambertian_reflection", "specular_reflection"] {
        let mut harness = alone(session(&[id]), [800, 500]);
        assert!(paints(&harness, "has an index of refraction"));
        enter(&mut harness, "Own n", "2,42");
        harness.run();
        assert_eq!(options(&harness).own_n, 2.42);
        assert!(paints(&harness, "Brewster 67.55°"));
        enter(&mut harness, "Own n", "0");
        assert!(
            said(&harness, "Own n")
                .1
                .unwrap()
                .contains("allowed is 0.01 to 10000")
        );
        assert_eq!(options(&harness).own_n, 2.42);
        enter(&mut harness, "Own n", "1");
        harness.run();
        assert!(!paints(&harness, "Brewster") && !paints(&harness, "critical 4"));
        assert!(paints(&harness, "nothing is reflected"));
        enter(&mut harness, "Own k", "3");
        harness.run();
        assert!(paints(&harness, "least p "));
    }
    // Beside one that has an interface there is no need for it.
    let both = alone(session(&["lambertian_reflection", GLASS]), [800, 500]);
    assert!(!paints(&both, "has an index of refraction"));
    assert_eq!(fresnel::Options::KIND.id, VIEW);
}

#[test]
fn no_text_overlaps_another() {
    let materials: [&[&str]; 8] = [
        &[GLASS],
        &["gold"],
        &["car_paint"],
        &["chalk"],
        &["diamond"],
        &["fresnel_specular:eta=1"],
        &["fresnel_specular:eta=1000"],
        &["specular_reflection:fresnel=dielectric,eta=1.2/1.5/1.9"],
    ];
    for shown in materials {
        for size in [[480, 360], [640, 480], [1280, 800]] {
            let mut shown_session = session(shown);
            shown_session.views.each(|view: &mut fresnel::Options| {
                view.curves.lazanyi = true;
            });
            let mut harness = alone(shown_session, size);
            for theta in [0.0, 45.0, 56.0, 89.0, 135.0, 180.0] {
                harness.state_mut().session.set_theta_deg(theta);
                harness.run();
                let mut all = texts(&harness);
                all.retain(|(text, _)| !text.is_empty());
                for (index, (text, rect)) in all.iter().enumerate() {
                    for (other, place) in all.iter().skip(index + 1) {
                        let both = rect.shrink(1.0).intersect(place.shrink(1.0));
                        assert!(
                            !both.is_positive(),
                            "{shown:?} {size:?} {theta}: {text:?} and {other:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn the_table_has_both_angles_and_every_curve() {
    let file = |shown: Session| {
        let view = picture(shown, Some(VIEW), [480, 360], Theme::Light);
        String::from_utf8(export::bytes(view, Format::Csv).unwrap()).unwrap()
    };
    let text = file(session(&[GLASS]));
    let mut lines = text.lines();
    assert_eq!(
        lines.next().unwrap(),
        "material,channel,from,theta_i (degrees),theta_t (degrees),s,p,mean,schlick,lazanyi"
    );
    let normal: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(normal[..5], ["Fresnel specular", "", "above", "0", "0"]);
    for cell in &normal[5..] {
        let share: f64 = cell.parse().unwrap();
        assert!((share - 0.04).abs() < 1e-12);
    }
    let mut metal = session(&["gold"]);
    metal.views.each(|view: &mut fresnel::Options| {
        view.over = fresnel::Over::Wavelength;
    });
    let text = file(metal);
    assert!(text.starts_with("material,wavelength (nm),n,k,theta_i (degrees),s,p"));
    assert!(text.lines().count() > 100);
}
