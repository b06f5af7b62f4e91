//! Pictures of the window and of each view, one model per category and several materials, dark and light.
//!
//! They are compared on the software driver only: other adapters round differently. Set `UPDATE_SNAPSHOTS=1` to
//! accept new ones, and look at each.

use std::collections::BTreeSet;

use brdf_explorer::study::lessons::{Lesson, lessons};
use brdf_explorer::study::session::{READY_LAYOUTS, Session};
use brdf_explorer::study::views::VIEWS;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::headless::Picture;
use eframe::egui_wgpu::wgpu;
use egui::{Key, Modifiers, Theme};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults, try_image_snapshot_options};

use super::{EIGHT, THREE, measure_tradeoff, picture, session, sessions};

/// What each view shows: one model of each category, with parameters that show it well, and several materials.
static SHOWN: [(&str, &[&str]); 5] = [
    ("diffuse", &["oren_nayar:sigma=30"]),
    ("perfect_specular", &["fresnel_specular"]),
    ("retro_reflective", &["retro_reflector"]),
    (
        "glossy_specular",
        &["rough_conductor:alpha_x=0.1,alpha_y=0.3"],
    ),
    ("overlay", &THREE),
];

/// How many of them, from the end, are stored in the light theme too: the others would say nothing new.
const SHOWN_LIGHT: usize = 2;

/// A comparison with a material that breaks a law and one that is a sum of lobes.
const COMPARED: [&str; 3] = ["car_paint", super::badges::BRIGHT, "rough_conductor"];

/// Pictures of the whole window: name, materials, ready layout, size in points, pixels per point.
type Window = (&'static str, &'static [&'static str], usize, [u32; 2], f32);

/// The start, the named materials with one of several lobes chosen, comparisons in every size that must do, and a phone.
const WINDOWS: [Window; 7] = [
    ("window", &["rough_conductor"], 0, [1280, 800], 1.0),
    ("materials", &["car_paint"], 0, [1280, 800], 1.0),
    ("three", &THREE, 0, [1280, 800], 1.0),
    ("eight", &EIGHT, 0, [1024, 640], 2.0),
    ("compare", &COMPARED, 1, [1024, 640], 1.0),
    ("tradeoff", &["gold"], 4, [1280, 800], 1.0),
    ("phone", &["rough_conductor"], 0, [390, 844], 1.0),
];

/// The limit on the stored pictures, all together.
const MAX_BYTES: u64 = 16 << 20;

/// Colour differences up to this go unseen (the scale of dify's YIQ distance); versions of the driver differ by less.
const THRESHOLD: f32 = 1.0;

/// Pixels on the edge of a line may fall either way between versions of the driver.
const MAX_FAILED_PIXELS: usize = 10;

const THEMES: [(&str, Theme); 2] = [("dark", Theme::Dark), ("light", Theme::Light)];

/// What the views show in a theme.
fn shown_in(theme: Theme) -> &'static [(&'static str, &'static [&'static str])] {
    let skipped = match theme {
        Theme::Dark => 0,
        Theme::Light => SHOWN.len() - SHOWN_LIGHT,
    };
    SHOWN.get(skipped..).unwrap_or_default()
}

/// The name of a picture of a view.
fn view_name(view: &str, what: &str, theme: &str) -> String {
    format!("{view}_{what}_{theme}")
}

/// The size of the pictures of sessions of older versions, in points: with room for a dozen views.
const STORED_SIZE: [u32; 2] = [1100, 640];

/// The sessions of older versions that have a picture in a theme.
fn stored_in(theme: Theme) -> Vec<(String, Session)> {
    match theme {
        Theme::Dark => sessions::stored(),
        Theme::Light => Vec::new(),
    }
}

/// The name of a picture of a session of an older version.
fn stored_name(session: &str, theme: &str) -> String {
    format!("session_{session}_{theme}")
}

/// The size of the pictures of lessons, in points: the smallest window that a class has.
const LESSON_SIZE: [u32; 2] = [1024, 640];

/// The lessons that have a picture in a theme: every other one, so that each has one.
fn lessons_in(theme: Theme) -> impl Iterator<Item = &'static Lesson> {
    let first = usize::from(theme == Theme::Light);
    lessons().iter().skip(first).step_by(2)
}

/// The name of a picture of a lesson.
fn lesson_name(lesson: &str, theme: &str) -> String {
    format!("lesson_{lesson}_{theme}")
}

/// The window with a lesson, at its second step: the first one is the simplest.
fn learning(lesson: &Lesson, theme: Theme) -> Harness<'static, App> {
    let mut shown = picture(Session::default(), None, LESSON_SIZE, theme)
        .harness()
        .unwrap();
    shown.state_mut().open_lesson(lesson, 1);
    shown.run_ok();
    shown
}

fn is_software_driver() -> bool {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::PRIMARY));
    adapters
        .iter()
        .any(|adapter| adapter.get_info().device_type == wgpu::DeviceType::Cpu)
}

/// The windows above the others: name and the keys that open them.
const ABOVE: [(&str, Modifiers, Key); 2] = [
    ("help", Modifiers::NONE, Key::F1),
    ("search", Modifiers::COMMAND, Key::K),
];

fn compare(results: &mut SnapshotResults, name: &str, picture: Picture) {
    let mut shown = picture.drawn().unwrap();
    measure_tradeoff(&mut shown);
    compare_shown(results, name, &mut shown);
}

fn compare_shown(results: &mut SnapshotResults, name: &str, shown: &mut Harness<'_, App>) {
    let image = shown.render().unwrap();
    let options = SnapshotOptions::new()
        .threshold(THRESHOLD)
        .max_failed_pixels(MAX_FAILED_PIXELS);
    results.add(try_image_snapshot_options(&image, name, &options));
}

#[test]
fn pictures_are_as_stored() {
    if !is_software_driver() {
        println!("no software driver: the stored pictures are not compared");
        return;
    }
    let mut results = SnapshotResults::new();
    for (theme_name, theme) in THEMES {
        for (name, shown, layout, size, scale) in WINDOWS {
            let mut shown = session(shown);
            let room = size.map(|side| side as f32);
            shown.views.show_ready(&READY_LAYOUTS[layout], room);
            let window = Picture {
                scale,
                ..picture(shown, None, size, theme)
            };
            compare(&mut results, &format!("{name}_{theme_name}"), window);
        }
        for (name, modifiers, key) in ABOVE {
            let window = picture(session(&["rough_conductor"]), None, [1024, 640], theme);
            let mut window = window.harness().unwrap();
            window.key_press_modifiers(modifiers, key);
            window.run();
            compare_shown(&mut results, &format!("{name}_{theme_name}"), &mut window);
        }
        for lesson in lessons_in(theme) {
            let name = lesson_name(&lesson.id, theme_name);
            compare_shown(&mut results, &name, &mut learning(lesson, theme));
        }
        for (name, session) in stored_in(theme) {
            let window = picture(session, None, STORED_SIZE, theme);
            compare(&mut results, &stored_name(&name, theme_name), window);
        }
        for view in &VIEWS {
            for (what, shown) in shown_in(theme) {
                let name = view_name(view.id, what, theme_name);
                let alone = picture(session(shown), Some(view.id), [480, 360], theme);
                compare(&mut results, &name, alone);
            }
        }
    }
}

/// A kind of view without its pictures is found by this, and a picture without its view.
#[test]
fn the_stored_pictures_are_one_per_view_model_and_theme() {
    let mut expected = BTreeSet::new();
    for (theme_name, theme) in THEMES {
        let windows = WINDOWS.iter().map(|(name, ..)| *name);
        let names = windows.chain(ABOVE.iter().map(|(name, ..)| *name));
        expected.extend(names.map(|name| format!("{name}_{theme_name}")));
        let learnt = lessons_in(theme);
        expected.extend(learnt.map(|lesson| lesson_name(&lesson.id, theme_name)));
        let stored = stored_in(theme).into_iter();
        expected.extend(stored.map(|(name, _)| stored_name(&name, theme_name)));
        for view in &VIEWS {
            let shown = shown_in(theme).iter();
            expected.extend(shown.map(|(what, _)| view_name(view.id, what, theme_name)));
        }
    }
    let mut bytes = 0;
    let mut names = BTreeSet::new();
    for entry in std::fs::read_dir("tests/snapshots").unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let name = name.strip_suffix(".png").unwrap();
        // What a failing comparison leaves beside them does not count.
        if !name.contains('.') {
            bytes += entry.metadata().unwrap().len();
            names.insert(name.to_owned());
        }
    }
    assert_eq!(names, expected);
    assert!(bytes <= MAX_BYTES, "{bytes} bytes");
}
