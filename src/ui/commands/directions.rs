//! The commands that take hold of the light and of the viewer: the arrow keys move them then.

use super::command::{Command, Group, PLAIN, command, key};
use crate::widgets::directions::key_of;
use bxdf_lab::analysis::Hold;

/// Gives the light the focus.
pub static LIGHT: Command = Command {
    state: Some(|_| "Light: the arrow keys move it".to_owned()),
    ..command(
        Group::View,
        [
            "light",
            "Move the light by keys",
            "Give the light (wi) in the view last clicked the focus: the arrow keys move it then",
        ],
        &[key(PLAIN, key_of(Hold::Light))],
        |app, ctx| app.focus_direction(Hold::Light, ctx),
    )
};

/// Gives the viewer the focus.
pub static VIEWER: Command = Command {
    state: Some(|_| "Viewer: the arrow keys move it".to_owned()),
    ..command(
        Group::View,
        [
            "viewer",
            "Move the viewer by keys",
            "Give the viewer (wo) in the view last clicked the focus: the arrow keys move it then",
        ],
        &[key(PLAIN, key_of(Hold::Viewer))],
        |app, ctx| app.focus_direction(Hold::Viewer, ctx),
    )
};
