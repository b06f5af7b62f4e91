//! The work of one frame: the app's ui and tessellation, without painting.
//!
//! `cargo bench --bench frame` moves a slider at default settings, and the held direction, and prints the median and
//! the 95th percentile of the frames in which everything on the screen is computed anew.

use std::time::{Duration, Instant};

use brdf_explorer::Result;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::session::Session;
use egui_kittest::Harness;

/// Frames measured per gesture.
const FRAMES: u32 = 400;

/// A gesture: changes the session, by a time that goes from 0 to 1.
type Gesture = fn(&mut Session, f64) -> Result<()>;

fn main() -> Result<()> {
    let alpha: Gesture = |session, t| {
        session.materials.selected_mut().material =
            format!("rough_conductor:alpha_x={}", 0.1 + 0.8 * t).parse()?;
        Ok(())
    };
    let theta: Gesture = |session, t| {
        session.theta_deg = 89.0 * t;
        Ok(())
    };
    measure("slider alpha_x, default settings", "rough_conductor", alpha)?;
    measure("slider theta, default settings", "rough_conductor", theta)?;
    measure(
        "slider theta, alpha 0.001",
        "rough_conductor:alpha=0.001",
        theta,
    )?;
    measure(
        "slider theta, blade 0.01 by 0.5",
        "rough_conductor:alpha_x=0.01,alpha_y=0.5",
        theta,
    )?;
    measure("nothing moves", "rough_conductor", |_, _| Ok(()))
}

/// Steps the window `FRAMES` times, taking the session through `gesture`.
fn measure(name: &str, material: &str, gesture: Gesture) -> Result<()> {
    let session = Session::of(material.parse()?);
    let mut harness: Harness<'_, App> = Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_max_steps(32)
        .build_eframe(|cc| App::new(cc, session, None, None));
    harness.run_ok();
    let mut times = Vec::new();
    for frame in 0..FRAMES {
        gesture(
            &mut harness.state_mut().session,
            f64::from(frame) / f64::from(FRAMES),
        )?;
        let begin = Instant::now();
        harness.step();
        let primitives = harness.ctx.tessellate(harness.output().shapes.clone(), 1.0);
        times.push(begin.elapsed());
        assert!(!primitives.is_empty(), "a frame draws something");
    }
    times.sort();
    let at = |share: f64| {
        let index = (f64::from(FRAMES - 1) * share) as usize;
        times
            .get(index)
            .map_or(f64::NAN, |time: &Duration| time.as_secs_f64() * 1e3)
    };
    println!(
        "{name:40} median {:6.2} ms   95th percentile {:6.2} ms",
        at(0.5),
        at(0.95)
    );
    Ok(())
}
