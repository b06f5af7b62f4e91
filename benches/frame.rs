//! The work of one frame: the app's ui and tessellation, without painting.
//!
//! `cargo bench --bench frame` moves a slider at default settings, and the held direction, and prints the median and
//! the 95th percentile of the frames in which everything on the screen is computed anew.

use std::time::{Duration, Instant};

use brdf_explorer::bxdf::param::Value;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::session::Session;
use egui_kittest::Harness;

/// Frames measured per gesture.
const FRAMES: u32 = 400;

fn main() {
    let start = || Session::default();
    measure("slider alpha_x, default settings", start(), |session, t| {
        session.material.set("alpha_x", Value::Number(0.1 + 0.8 * t)).expect("in range");
    });
    measure("slider theta, default settings", start(), |session, t| session.theta_deg = 89.0 * t);
    measure("slider theta, alpha 0.001", with_material("rough_conductor:alpha=0.001"), |session, t| {
        session.theta_deg = 89.0 * t;
    });
    measure("slider theta, blade 0.01 by 0.5", with_material("rough_conductor:alpha_x=0.01,alpha_y=0.5"), |session, t| {
        session.theta_deg = 89.0 * t;
    });
    measure("nothing moves", start(), |_, _| {});
}

fn with_material(material: &str) -> Session {
    Session { material: material.parse().expect("a material"), ..Session::default() }
}

/// Steps the window `FRAMES` times, `change` taking the session through its gesture (t from 0 to 1) before each.
fn measure(name: &str, session: Session, change: impl Fn(&mut Session, f64)) {
    let mut harness: Harness<'_, App> = Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_max_steps(32)
        .build_eframe(|cc| App::new(cc, session, None, None));
    harness.run_ok();
    let mut times: Vec<Duration> = (0..FRAMES)
        .map(|frame| {
            change(&mut harness.state_mut().session, f64::from(frame) / f64::from(FRAMES));
            let begin = Instant::now();
            harness.step();
            let shapes = harness.output().shapes.clone();
            let primitives = harness.ctx.tessellate(shapes, 1.0);
            let time = begin.elapsed();
            assert!(!primitives.is_empty());
            time
        })
        .collect();
    times.sort();
    let at = |share: f64| times[((times.len() - 1) as f64 * share) as usize].as_secs_f64() * 1e3;
    println!("{name:40} median {:6.2} ms   95th percentile {:6.2} ms", at(0.5), at(0.95));
}
