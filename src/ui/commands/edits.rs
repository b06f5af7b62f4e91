//! The commands of the history, and of what is set of parameters.

use egui::Key;

use super::command::{CTRL, CTRL_SHIFT, Command, Group, command, key, switched};
use crate::app::App;

/// Takes back the last edit.
pub static UNDO: Command = Command {
    is_enabled: |app| app.history.undone().is_some(),
    now: |app| app.history.undone().map(|edit| edit.title("Undo")),
    ..command(
        Group::Edit,
        ["undo", "Undo", "Undo the last edit of the session"],
        &[key(CTRL, Key::Z)],
        |app, _| app.history.undo(&mut app.session),
    )
};

/// Does again what was taken back.
pub static REDO: Command = Command {
    is_enabled: |app| app.history.redone().is_some(),
    now: |app| app.history.redone().map(|edit| edit.title("Redo")),
    ..command(
        Group::Edit,
        ["redo", "Redo", "Redo the edit that was undone"],
        &[key(CTRL_SHIFT, Key::Z), key(CTRL, Key::Y)],
        |app, _| app.history.redo(&mut app.session),
    )
};

/// Pins the parameter that was changed last, or no longer.
pub static PIN: Command = Command {
    is_enabled: |app| app.last_changed.is_some(),
    state: Some(|app| {
        let name = app.last_changed.unwrap_or_default();
        switched("Pinned", app.session.pinned.contains(name))
    }),
    now: App::pin_now,
    ..command(
        Group::Edit,
        [
            "pin",
            "Pin the parameter changed last",
            "While the views are presented the bar below them has a slider for it",
        ],
        &[key(CTRL_SHIFT, Key::P)],
        |app, _| app.pin_last(),
    )
};
