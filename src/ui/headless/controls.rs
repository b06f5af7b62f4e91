//! What a lesson names in the window, looked for there.

use std::collections::BTreeSet;

use egui::Theme;
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;

use super::Picture;
use crate::app::App;
use bxdf::error::Error;
use bxdf_study::lessons::{Fault, Lesson, Step, Thing};
use bxdf_study::session::Session;

/// The size of the window in which controls are looked for, in points.
const SIZE: [u32; 2] = [1280, 800];

/// The controls that a lesson names and that are not in the window at that step, before or behind its question: each with the
/// line of its step, and the nearest names.
#[must_use]
pub fn unknown_controls(lesson: &Lesson) -> Vec<Fault> {
    let named: Vec<Vec<&str>> = lesson.steps.iter().map(controls_of).collect();
    if named.iter().all(Vec::is_empty) {
        return Vec::new();
    }
    let mut faults = Vec::new();
    let window = Picture {
        session: Session::default(),
        only: None,
        size: SIZE,
        scale: 1.0,
        theme: Theme::Dark,
        figure: None,
    };
    let mut window = window.controls();
    for (index, (step, names)) in lesson.steps.iter().zip(named).enumerate() {
        if names.is_empty() {
            continue;
        }
        window.state_mut().open_lesson(lesson, index);
        window.run_ok();
        let mut there = labels(&window);
        let app = window.state_mut();
        if lesson.state_after(index, &mut app.session).is_ok() {
            window.run_ok();
            there.extend(labels(&window));
        }
        for name in names.into_iter().filter(|name| !there.contains(*name)) {
            let known = there.iter().map(String::as_str);
            let error = Error::unknown("control", name, known);
            faults.push(Fault {
                line: step.line,
                problem: error.to_string(),
            });
        }
    }
    faults
}

/// The controls that a step names.
fn controls_of(step: &Step) -> Vec<&str> {
    let things = step.things().into_iter();
    let controls = things.filter_map(|thing| match thing {
        Thing::Control(name) => Some(name.as_str()),
        _ => None,
    });
    controls.collect()
}

/// The names that screen readers are told.
fn labels(window: &Harness<'_, App>) -> BTreeSet<String> {
    let nodes = window.root().children_recursive();
    let labels = nodes.filter_map(|node| node.accesskit_node().label());
    labels.collect()
}
