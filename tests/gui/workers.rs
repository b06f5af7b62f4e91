//! The window with its workers: the same answers, a little later.

use std::time::{Duration, Instant};

use brdf_explorer::analysis::Detail;
use brdf_explorer::study::jobs::Clock;
use brdf_explorer::study::platform;
use brdf_explorer::study::session::{Place, Session};
use brdf_explorer::study::views::{self, Options, VIEWS, tradeoff};
use brdf_explorer::ui::app::App;
use egui::Color32;
use egui::epaint::Primitive;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{material, session};

/// More than any answer takes, on any machine.
const PATIENCE: Duration = Duration::from_mins(5);

/// A view of a needle, a blade and a mixture.
fn view(id: &str, clock: Option<Clock>) -> Harness<'static, App> {
    let shown = [
        "rough_conductor:alpha=0.001",
        "rough_conductor:alpha_x=0.01,alpha_y=0.5",
        "car_paint",
    ];
    let mut session = session(&shown);
    let only = session.views.show_alone(views::find(id).unwrap());
    let mut harness = Harness::builder()
        .with_size(egui::vec2(480.0, 360.0))
        .with_max_steps(32)
        .build_eframe(|cc| App::new(cc, session, Some(only), clock));
    harness.run_ok();
    harness
}

/// Steps until every answer is full; the corners of all that is drawn then, with their colours. Where letters stand in
/// the font's texture depends on what was written before, and is left out. Numbers are compared by their bits: degenerate lines
/// end in corners that are none.
fn settled(harness: &mut Harness<'_, App>) -> Vec<([u32; 2], Color32)> {
    let begin = Instant::now();
    // What follows the answers, a scale that goes over or a picture that waits for its turn, asks for further frames.
    let is_moving = |harness: &Harness<'_, App>| {
        harness.state().shown() != Some(Detail::Full) || harness.ctx.has_requested_repaint()
    };
    while is_moving(harness) {
        assert!(begin.elapsed() < PATIENCE, "the answers never come");
        std::thread::sleep(Duration::from_millis(1));
        harness.step();
    }
    harness.step();
    let shapes = harness.output().shapes.clone();
    let primitives = harness.ctx.tessellate(shapes, 1.0);
    let meshes = primitives
        .into_iter()
        .filter_map(|clipped| match clipped.primitive {
            Primitive::Mesh(mesh) => Some(mesh.vertices),
            Primitive::Callback(_) => None,
        });
    let corners: Vec<_> = meshes
        .flatten()
        .map(|v| ([v.pos.x, v.pos.y].map(f32::to_bits), v.color))
        .collect();
    assert!(corners.len() > 300, "the view is drawn");
    corners
}

#[test]
fn workers_give_the_answers_of_the_frame() {
    let (mut at_once, mut pooled) = (view("polar", None), view("polar", Some(platform::seconds)));
    assert!(settled(&mut at_once) == settled(&mut pooled));
    // Many changes in quick succession: only the last one counts.
    for theta in 1..60 {
        pooled.state_mut().session.theta_deg = f64::from(theta);
        pooled.step();
    }
    at_once.state_mut().session.theta_deg = 59.0;
    at_once.step();
    assert!(settled(&mut at_once) == settled(&mut pooled));
    // Back to what was shown while something else is being computed.
    for theta in [20.0, 59.0] {
        pooled.state_mut().session.theta_deg = theta;
        pooled.step();
    }
    assert!(settled(&mut at_once) == settled(&mut pooled));
}

#[test]
fn every_view_waits_for_its_workers() {
    for spec in &VIEWS {
        let mut pooled = view(spec.id, Some(platform::seconds));
        // The first frames have no answers yet; a graphics processor refuses a picture without pixels.
        for _ in 0..3 {
            let textures = &pooled.output().textures_delta.set;
            let is_sound = |size: [usize; 2]| size[0] > 0 && size[1] > 0;
            assert!(
                textures
                    .iter()
                    .all(|(_, deltas)| deltas.iter().all(|delta| is_sound(delta.image.size()))),
                "{}",
                spec.id
            );
            pooled.step();
        }
        let at_once = settled(&mut view(spec.id, None));
        assert!(at_once == settled(&mut pooled), "{}", spec.id);
    }
}

/// Every family, by the clock of the machine: that takes much longer than the views, which go on meanwhile.
#[test]
fn the_window_goes_on_while_a_tradeoff_is_measured() {
    let ids = ["tradeoff", "polar"];
    let views = ids.map(|id| Place::View(Options::of(views::find(id).unwrap())));
    let shown = Session {
        views: Place::row(views.into()).into(),
        ..Session::of(material("gold"))
    };
    assert!(
        shown
            .views
            .options::<tradeoff::Options>()
            .left_out
            .is_empty()
    );
    let mut harness = Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_max_steps(32)
        .build_eframe(|cc| App::new(cc, shown, None, Some(platform::seconds)));
    harness.step();
    harness.get_by_label("Measure").click();
    harness.run_steps(2);
    assert!(harness.query_by_label("Measure").is_none());
    // The first points are shown before the last ones are measured.
    let known = "The material as a whole";
    let begin = Instant::now();
    while harness.query_by_label(known).is_none() {
        assert!(harness.query_by_label("Cancel").is_some());
        assert!(begin.elapsed() < PATIENCE, "no part is ever told");
        std::thread::sleep(Duration::from_millis(1));
        harness.step();
    }
    for theta in [20.0, 50.0, 70.0] {
        harness.state_mut().session.theta_deg = theta;
        harness.step();
        while harness.state().shown() != Some(Detail::Full) {
            assert!(begin.elapsed() < PATIENCE, "the answers never come");
            std::thread::sleep(Duration::from_millis(1));
            harness.step();
        }
    }
    harness.get_by_label("Cancel").click();
    harness.run_steps(2);
    assert!(
        harness.query_by_label("Measure").is_some(),
        "it was over before"
    );
    assert!(harness.query_by_label(known).is_some());
    // It stays the one that was measured.
    let added = harness.state_mut().session.materials.add(material("phong"));
    added.unwrap();
    harness.run_steps(2);
    assert!(harness.query_by_label("measured: Gold").is_some());
    assert!(harness.query_by_label(known).is_some());
}
