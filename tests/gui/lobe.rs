//! The 3D lobe: its labels keep off its handle and one another, and its camera glides.

use std::time::Duration;

use brdf_explorer::study::session::{HomeView, OrbitCamera, Session};
use egui::{Rect, Role, Shape, Theme, vec2};
use egui_kittest::kittest::Queryable;

use super::{SIX, picture, session};

const SIZES: [[u32; 2]; 3] = [[360, 280], [640, 480], [1000, 700]];

/// What the 3D lobe of `shown` writes, and its handle, each with what it covers.
fn covered(shown: &Session, size: [u32; 2]) -> Vec<(String, Rect)> {
    fn each(shape: &Shape, all: &mut Vec<(String, Rect)>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| each(shape, all)),
            Shape::Text(text) => {
                all.push((text.galley.text().to_owned(), text.visual_bounding_rect()));
            }
            Shape::Circle(circle) if circle.radius > 6.0 => {
                all.push(("handle".to_owned(), shape.visual_bounding_rect()));
            }
            _ => {}
        }
    }
    let harness = picture(shown.clone(), Some("lobe3d"), size, Theme::Dark).shapes();
    let mut all = Vec::new();
    for clipped in &harness.output().shapes {
        each(&clipped.shape, &mut all);
    }
    all
}

#[test]
fn labels_keep_off_the_handle_and_one_another() {
    for count in [1, 3, 6] {
        for size in SIZES {
            for (theta_deg, phi_deg, show_geometry) in [
                (50.0, 180.0, false),
                (50.0, 180.0, true),
                (5.0, 60.0, false),
                (85.0, -60.0, true),
            ] {
                let mut shown = Session {
                    theta_deg,
                    phi_deg,
                    show_geometry,
                    ..session(&SIX[6 - count..])
                };
                for home in HomeView::ALL {
                    shown.camera = OrbitCamera::new(home);
                    let what = format!(
                        "{count} materials, {size:?}, theta {theta_deg}, {home:?}, {show_geometry}"
                    );
                    let covered = covered(&shown, size);
                    assert!(covered.iter().any(|(text, _)| text == "light"), "{what}");
                    for (index, (text, rect)) in covered.iter().enumerate() {
                        for (other, at) in &covered[..index] {
                            // Light and viewer may be in one place.
                            let are_handles = text == "handle" && other == "handle";
                            assert!(
                                are_handles || !rect.intersects(*at),
                                "{what}: {text} {rect} over {other} {at}"
                            );
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn the_camera_glides_home_and_rests() {
    let mut harness = picture(session(&["gold"]), Some("lobe3d"), [640, 480], Theme::Dark)
        .harness()
        .unwrap();
    let handle = |harness: &egui_kittest::Harness<'_, _>| {
        let found = harness.get_by_label("Light in the 3D lobe");
        found.rect().center()
    };
    let start = handle(&harness);
    harness.get_by_label("Top").click();
    let begin = harness.ctx.input(|input| input.time);
    let mut places = vec![start];
    for frame in 1..10 {
        harness.input_mut().time = Some(begin + 0.04 * f64::from(frame));
        harness.step();
        places.push(handle(&harness));
    }
    harness.input_mut().time = None;
    // The session is there at once, so that nothing on the way is stored.
    assert_eq!(
        harness.state().session.camera,
        OrbitCamera::new(HomeView::Top)
    );
    let end = places[places.len() - 1];
    let moved: Vec<f32> = places
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .collect();
    let steps = moved.iter().filter(|step| **step > 0.5).count();
    assert!(steps >= 3, "{moved:?}");
    assert!(
        moved.iter().all(|step| *step < 0.7 * start.distance(end)),
        "{moved:?}"
    );
    assert!(moved[moved.len() - 1] == 0.0, "{moved:?}");
    // Then nothing asks for frames any more.
    let canvas = harness
        .get_by_role_and_label(Role::Canvas, "3D lobe")
        .rect();
    harness.hover_at(canvas.left_bottom() + vec2(300.0, -60.0));
    harness.run();
    let output = harness.output();
    let wait = output
        .viewport_output
        .values()
        .map(|output| output.repaint_delay)
        .min();
    assert!(
        wait.is_none_or(|wait| wait > Duration::from_secs(1)),
        "{wait:?}"
    );
}
