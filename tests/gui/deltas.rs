//! Dirac deltas in every view that shows values: a stem or a mark with its share, never plain zero.

use brdf_explorer::analysis::cartesian::Abscissa;
use brdf_explorer::analysis::deltas::Arrows;
use brdf_explorer::analysis::hemisphere::{Comparison, Quantity};
use brdf_explorer::bxdf::material::file;
use brdf_explorer::study::answers::Answers;
use brdf_explorer::study::session::{Materials, Session};
use brdf_explorer::study::views::{Deltas, VIEWS, ViewKind, cartesian, hemisphere, sampling};
use egui::{Color32, Rect, Shape, Theme};

use super::{picture, session};

const MIRROR: &str = "specular_reflection:reflectance=0.9";
const GLASS: &str = "fresnel_specular:eta=1.5";

/// A mirror that lies on a diffuse surface, half of each.
fn mixture() -> Session {
    let text = "name = \"Half a mirror\"\n[[lobes]]\nmodel = \"specular_reflection\"\nweight = 0.5\nreflectance = 0.9\n\
        [[lobes]]\nmodel = \"lambertian_reflection\"\nweight = 0.5\nreflectance = 1.0\n";
    let material = file::parse(text, "mixture").unwrap();
    let mut shown = session(&[MIRROR]);
    shown.materials = Materials::new(vec![material]).unwrap();
    shown
}

/// All shapes that a view paints, one by one.
fn shapes(shown: &Session, view: &str) -> Vec<Shape> {
    fn each(shape: &Shape, all: &mut Vec<Shape>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| each(shape, all)),
            shape => all.push(shape.clone()),
        }
    }
    let mut shown = shown.clone();
    shown
        .views
        .each(|shown: &mut sampling::Options| shown.plot = sampling::Plot::Curves);
    let harness = picture(shown, Some(view), [640, 480], Theme::Dark).shapes();
    let mut all = Vec::new();
    for clipped in &harness.output().shapes {
        each(&clipped.shape, &mut all);
    }
    all
}

/// The texts that a view paints, with their places.
fn texts(shown: &Session, view: &str) -> Vec<(String, Rect)> {
    let text = |shape: Shape| match shape {
        Shape::Text(text) => Some((text.galley.text().to_owned(), text.visual_bounding_rect())),
        _ => None,
    };
    shapes(shown, view).into_iter().filter_map(text).collect()
}

fn has(shown: &Session, view: &str, part: &str) -> bool {
    let texts = texts(shown, view);
    texts.iter().any(|(text, _)| text.contains(part))
}

#[test]
fn every_view_shows_a_delta_with_its_share() {
    let marks = |view: &&ViewKind| view.deltas == Deltas::Marked;
    for view in VIEWS.iter().filter(marks).map(|view| view.id) {
        // The chance of the mirror is that of its light among all.
        let [whole, half] = match view {
            "sampling" => ["1.000", "0.474"],
            _ => ["0.900", "0.450"],
        };
        assert!(has(&session(&[MIRROR]), view, whole), "{view}: a mirror");
        assert!(has(&mixture(), view, half), "{view}: half a mirror");
        let glass = session(&[GLASS]);
        let entry = glass.materials.selected();
        let arrows = Answers::at_once().ask(&glass, entry, Arrows);
        assert_eq!(arrows.len(), 2);
        for arrow in arrows.iter() {
            // The sphere has its own angles; what crosses the surface has no half vector in the slice.
            let is_elsewhere = view == "slice" && arrow.direction.z < 0.0;
            if view != "sphere" && !is_elsewhere {
                let share = format!("{:.3}", arrow.flux[1]);
                assert!(has(&glass, view, &share), "{view}: {share}");
            }
        }
        let nothing = session(&["lambertian_reflection"]);
        assert!(!has(&nothing, view, "delta"), "{view}: no delta");
    }
}

#[test]
fn stems_and_rings_have_the_colour_of_their_material() {
    for view in ["cartesian", "hemisphere", "slice", "polar"] {
        let shown = session(&["lambertian_reflection", MIRROR]);
        let mirror = shown.materials.iter().nth(1).unwrap();
        let palette = brdf_explorer::ui::theme::Palette::of(Theme::Dark);
        let color: Color32 = palette.material(mirror.slot());
        let is_mark = |shape: &Shape| match shape {
            // The head of a stem has three corners.
            Shape::Path(path) => path.closed && path.points.len() == 3 && path.fill == color,
            Shape::Circle(circle) => circle.stroke.color == color && circle.radius > 6.0,
            _ => false,
        };
        let count = |shown| shapes(shown, view).iter().filter(|s| is_mark(s)).count();
        assert_eq!(count(&shown), 1, "{view}");
        assert_eq!(count(&session(&["lambertian_reflection"; 2])), 0, "{view}");
    }
}

#[test]
fn a_mirror_stands_where_the_half_vector_is_the_normal() {
    let mut shown = session(&[GLASS]);
    let set = |shown: &mut Session, abscissa, fixed_deg| {
        shown.views.each(|plot: &mut cartesian::Options| {
            (plot.abscissa, plot.fixed_deg) = (abscissa, fixed_deg);
        });
    };
    set(&mut shown, Abscissa::Half, 0.0);
    // At theta_d = 0: ((1.5 - 1) / (1.5 + 1))^2.
    assert!(has(&shown, "cartesian", "delta 0.040"));
    assert!(has(&shown, "cartesian", "no half vector"));
    set(&mut shown, Abscissa::Difference, 0.0);
    shown.theta_deg = 0.0;
    assert!(has(&shown, "cartesian", "delta 0.040"));
    assert!(!has(&shown, "cartesian", "delta 0.040, at"));
    set(&mut shown, Abscissa::Difference, 20.0);
    assert!(has(&shown, "cartesian", "delta 0.040, at θh 0°"));
}

#[test]
fn a_delta_outside_the_section_is_shown_as_such() {
    let mut shown = session(&[MIRROR]);
    for view in ["cartesian", "decomposition"] {
        shown.section_phi_deg = None;
        assert!(!has(&shown, view, "outside this section"), "{view}");
        shown.section_phi_deg = Some(40.0);
        assert!(
            has(&shown, view, "delta 0.900, outside this section"),
            "{view}"
        );
    }
    assert!(has(&shown, "polar", "Dashed: outside this section"));
    assert!(has(&shown, "polar", "delta 0.900"));
}

#[test]
fn comparisons_are_of_shares_and_quantities_have_their_own() {
    let mut shown = session(&["specular_reflection:reflectance=0.4", MIRROR]);
    let first = shown.materials.iter().next().unwrap().id();
    shown.materials.compare_with(first);
    shown
        .views
        .each(|plot: &mut cartesian::Options| plot.is_residual = true);
    assert!(has(&shown, "cartesian", "delta 0.500"));
    assert!(!has(&shown, "cartesian", "delta 0.900"));
    for (comparison, text) in [
        (Comparison::Difference, "delta 0.500"),
        (Comparison::Ratio, "delta 2.250"),
    ] {
        shown
            .views
            .each(|map: &mut hemisphere::Options| map.comparison = comparison);
        assert!(has(&shown, "hemisphere", text), "{text}");
    }
    let mut shown = session(&[GLASS]);
    shown.theta_deg = 0.0;
    for (quantity, text) in [
        (Quantity::FCos, "delta 0.040"),
        (Quantity::Pdf, "delta, probability 0.040"),
        (Quantity::Weight, "delta, weight 1.000"),
    ] {
        shown
            .views
            .each(|map: &mut hemisphere::Options| map.quantity = quantity);
        assert!(has(&shown, "hemisphere", text), "{text}");
    }
    shown.views.each(|map: &mut hemisphere::Options| {
        (map.is_lower, map.quantity) = (true, Quantity::F);
    });
    assert!(has(&shown, "hemisphere", "delta 0.040, above"));
    assert!(has(&shown, "hemisphere", "delta 0.960"));
}

#[test]
fn labels_of_many_deltas_do_not_lie_on_one_another() {
    let mirrors = [0.9, 0.9, 0.89, 0.88, 0.6]
        .map(|reflectance| format!("specular_reflection:reflectance={reflectance}"));
    let mirrors: Vec<&str> = mirrors.iter().map(String::as_str).collect();
    for view in ["cartesian", "polar", "lobe3d"] {
        let texts = texts(&session(&mirrors), view);
        let is_delta = |(text, _): &&(String, Rect)| text.starts_with("delta ");
        let places: Vec<Rect> = texts.iter().filter(is_delta).map(|(_, at)| *at).collect();
        assert_eq!(places.len(), mirrors.len(), "{view}: {texts:?}");
        for (index, place) in places.iter().enumerate() {
            let is_apart = |other: &Rect| !other.intersects(*place);
            assert!(places[..index].iter().all(is_apart), "{view}: {places:?}");
        }
    }
}

/// A share that lies over the number of an angle makes neither legible.
#[test]
fn no_number_of_the_polar_grid_lies_below_a_share() {
    let mut shares = 0;
    for size in [[330, 400], [360, 360], [360, 300], [480, 360]] {
        for theta_deg in [50.0, 62.0, 75.0, 84.0] {
            let shown = Session {
                theta_deg,
                ..session(&[MIRROR, GLASS])
            };
            let harness = picture(shown, Some("polar"), size, Theme::Dark).shapes();
            let all = &harness.output().shapes;
            let text = |clipped: &egui::epaint::ClippedShape| match &clipped.shape {
                Shape::Text(text) => {
                    Some((text.galley.text().to_owned(), text.visual_bounding_rect()))
                }
                _ => None,
            };
            let texts: Vec<(String, Rect)> = all.iter().filter_map(text).collect();
            let is_delta = |(text, _): &&(String, Rect)| text.starts_with("delta ");
            let is_angle = |(text, _): &&(String, Rect)| text.ends_with('°');
            assert!(texts.iter().filter(is_angle).count() > 8, "{texts:?}");
            for (share, place) in texts.iter().filter(is_delta) {
                shares += 1;
                for (angle, at) in texts.iter().filter(is_angle) {
                    assert!(
                        !at.intersects(*place),
                        "{size:?} {theta_deg}: {share} over {angle}"
                    );
                }
            }
        }
    }
    assert!(shares > 16);
}
