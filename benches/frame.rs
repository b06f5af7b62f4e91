//! The work of one frame: the app's ui and tessellation, without painting.
//!
//! `cargo bench --bench frame` moves a slider at default settings, and the held direction, and prints the median and
//! the 95th percentile of the frames. *At once*: everything on the screen is computed in the frame that changes it, as for
//! pictures. *With workers*: as in the window, sixty frames a second, with the time after a change until every view shows a
//! first answer to it, and until all answers are full.

use std::time::{Duration, Instant};

use brdf_explorer::Result;
use brdf_explorer::analysis::Detail;
use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::study::jobs::Clock;
use brdf_explorer::study::platform;
use brdf_explorer::study::session::{Materials, Place, READY_LAYOUTS, Session, Views};
use brdf_explorer::study::views::{Options, VIEWS, ViewKind};
use brdf_explorer::ui::app::App;
use egui_kittest::Harness;

/// Frames measured per gesture.
const FRAMES: u32 = 400;

/// The time from one frame to the next.
const FRAME: Duration = Duration::from_micros(16_667);

/// Changes after which the answers are waited for.
const CHANGES: u32 = 20;

/// Eight materials of different kinds.
const EIGHT: [&str; 8] = [
    "gold",
    "brushed_steel",
    "frosted_glass",
    "car_paint",
    "velvet_cloth",
    "chalk",
    "moon",
    "skin",
];

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
    let one = |material: &str| Ok(Session::of(material.parse()?));
    let start = one("rough_conductor")?;
    measure("slider alpha_x, default settings", &start, alpha)?;
    measure("slider theta, default settings", &start, theta)?;
    measure(
        "slider theta, alpha 0.001",
        &one("rough_conductor:alpha=0.001")?,
        theta,
    )?;
    let blade = one("rough_conductor:alpha_x=0.01,alpha_y=0.5")?;
    measure("slider theta, blade 0.01 by 0.5", &blade, theta)?;
    measure("nothing moves", &start, |_, _| Ok(()))?;
    let eight = eight()?;
    let everything = Session {
        views: every_view(),
        ..eight.clone()
    };
    measure("theta, eight materials, Compare", &eight, theta)?;
    for (name, session) in [
        ("theta, default settings", &start),
        ("theta, blade", &blade),
        ("theta, eight materials, Compare", &eight),
        ("theta, eight materials, every view", &everything),
    ] {
        drag_with_workers(name, session, theta)?;
        wait_for_answers(name, session);
    }
    Ok(())
}

/// Eight materials in the layout made for comparing.
fn eight() -> Result<Session> {
    let materials: Result<Vec<Material>> = EIGHT
        .into_iter()
        .map(|id| library::find(id).map(|named| named.material.clone()))
        .collect();
    let compare = READY_LAYOUTS.iter().find(|ready| ready.name == "Compare");
    Ok(Session {
        materials: Materials::new(materials?)?,
        views: compare.map_or_else(Default::default, Views::ready),
        ..Session::default()
    })
}

/// Every view open once, in rows of three.
fn every_view() -> Views {
    const IN_A_ROW: usize = 3;
    let view = |kind: &ViewKind| Place::View(Options::of(kind));
    let row = |kinds: &[ViewKind]| Place::row(kinds.iter().map(view).collect());
    Place::column(VIEWS.chunks(IN_A_ROW).map(row).collect()).into()
}

/// The size of the window, in points: a large one where it is full of views.
fn size(session: &Session) -> egui::Vec2 {
    if session.views.ids().len() == VIEWS.len() {
        egui::vec2(2560.0, 1600.0)
    } else {
        egui::vec2(1280.0, 800.0)
    }
}

/// The window with `session`, settled.
fn window(session: &Session, clock: Option<Clock>) -> Harness<'static, App> {
    let shown = session.clone();
    let mut harness = Harness::builder()
        .with_size(size(session))
        .with_max_steps(32)
        .build_eframe(|cc| App::new(cc, shown, None, clock));
    harness.run_ok();
    settle(&mut harness);
    harness
}

/// Steps until every answer is full.
fn settle(harness: &mut Harness<'_, App>) {
    while harness.state().shown() != Some(Detail::Full) {
        harness.step();
    }
}

/// The work of a frame.
fn frame(harness: &mut Harness<'_, App>) -> Duration {
    let begin = Instant::now();
    harness.step();
    let primitives = harness.ctx.tessellate(harness.output().shapes.clone(), 1.0);
    assert!(!primitives.is_empty(), "a frame draws something");
    begin.elapsed()
}

/// Prints the median and the 95th percentile of `times`.
fn print(name: &str, mut times: Vec<Duration>) {
    times.sort();
    let at = |share: f64| {
        let index = ((times.len() - 1) as f64 * share) as usize;
        times
            .get(index)
            .map_or(f64::NAN, |time| time.as_secs_f64() * 1e3)
    };
    println!(
        "{name:58} median {:6.2} ms   95th percentile {:6.2} ms",
        at(0.5),
        at(0.95)
    );
}

/// Steps the window `FRAMES` times, taking the session through `gesture`.
fn measure(name: &str, session: &Session, gesture: Gesture) -> Result<()> {
    let mut harness = window(session, None);
    let mut times = Vec::new();
    for step in 0..FRAMES {
        let t = f64::from(step) / f64::from(FRAMES);
        gesture(&mut harness.state_mut().session, t)?;
        times.push(frame(&mut harness));
    }
    print(&format!("at once: {name}"), times);
    Ok(())
}

/// The same as in the window: sixty frames a second, the answers coming from the pool.
fn drag_with_workers(name: &str, session: &Session, gesture: Gesture) -> Result<()> {
    let mut harness = window(session, Some(platform::seconds));
    let mut times = Vec::new();
    for step in 0..FRAMES {
        let t = f64::from(step) / f64::from(FRAMES);
        gesture(&mut harness.state_mut().session, t)?;
        let work = frame(&mut harness);
        times.push(work);
        std::thread::sleep(FRAME.saturating_sub(work));
    }
    print(&format!("with workers: {name}"), times);
    Ok(())
}

/// Moves the light and waits, time and again.
fn wait_for_answers(name: &str, session: &Session) {
    let mut harness = window(session, Some(platform::seconds));
    let (mut first, mut full) = (Vec::new(), Vec::new());
    for change in 0..CHANGES {
        harness.state_mut().session.theta_deg = 4.0 * f64::from(change + 1);
        let begin = Instant::now();
        let mut has_first = false;
        loop {
            harness.step();
            let shown = harness.state().shown();
            if !has_first && shown.is_some() {
                first.push(begin.elapsed());
                has_first = true;
            }
            if shown == Some(Detail::Full) {
                full.push(begin.elapsed());
                break;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
    print(&format!("first answers: {name}"), first);
    print(&format!("full answers: {name}"), full);
}
