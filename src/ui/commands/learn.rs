//! Commands of lessons.

use egui::Key;

use super::command::{CTRL, Command, Group, PLAIN, command, key};
use crate::app::App;

/// Shows the lessons, or hides them.
pub static LEARN: Command = Command {
    state: Some(|app| super::command::switched("Lessons", app.is_learning())),
    ..command(
        Group::Help,
        [
            "learn",
            "Learn",
            "Lessons and questions beside the views: predict, move something, see",
        ],
        &[key(CTRL, Key::L)],
        App::switch_learning,
    )
};

/// Goes to the next step of the lesson.
pub static NEXT_STEP: Command = Command {
    is_enabled: |app| app.has_step(1),
    ..command(
        Group::Help,
        [
            "next_step",
            "Next step of the lesson",
            "Goes on in the lesson; remote clickers do it, too",
        ],
        &[key(PLAIN, Key::PageDown)],
        |app, ctx| app.step(1, ctx),
    )
};

/// Goes back to the step before.
pub static STEP_BACK: Command = Command {
    is_enabled: |app| app.has_step(-1),
    ..command(
        Group::Help,
        [
            "step_back",
            "Step of the lesson before",
            "Goes back in the lesson",
        ],
        &[key(PLAIN, Key::PageUp)],
        |app, ctx| app.step(-1, ctx),
    )
};

/// Copies what leads to the step at hand.
pub static COPY_STEP: Command = Command {
    is_enabled: |app| app.step_link().is_some(),
    ..command(
        Group::Help,
        [
            "copy_step",
            "Copy link to this step",
            "Copies the lesson and the step as text: render --lesson takes it",
        ],
        &[key(super::command::CTRL_ALT, Key::L)],
        App::copy_step_link,
    )
};
