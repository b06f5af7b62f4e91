//! Light and viewer, by accessible labels.

use brdf_explorer::analysis::Hold;
use brdf_explorer::bxdf::math::frame;
use brdf_explorer::ui::app::App;
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::interaction::drag_label;
use super::window;

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
