//! The help: what keys and the mouse do.

use egui::{Context, Grid, Id, Modal, RichText, ScrollArea, Ui};

use super::command::{Command, Group};
use super::list::COMMANDS;
use crate::theme;

/// What the mouse and the keys do in parts of the window.
const GESTURES: [(&str, &[(&str, &str)]); 5] = [
    (
        "In the views",
        &[
            ("Drag the round handle", "Move the light or the viewer"),
            (
                "Arrows, at a handle with the focus",
                "Move it by 1°; with Shift by 0.1°",
            ),
            ("Drag the 3D lobe", "Orbit the camera; with Shift, pan it"),
            ("Scroll or pinch", "Zoom"),
            (
                "Double-click, Reset view",
                "Undo panning, zooming and turning",
            ),
            ("Click a name of a legend", "Select that material"),
            (
                "Right-click the name of a view",
                "Duplicate it, or give it a section of its own",
            ),
        ],
    ),
    (
        "In a search",
        &[
            ("Up, Down", "Go through what is found"),
            ("Enter", "Choose it"),
            ("Escape", "Leave, and clear the search"),
        ],
    ),
    (
        "In the pictures to choose from",
        &[
            ("Arrows", "Go to the next picture, or a row on"),
            ("Enter or click", "Choose it, and leave"),
            ("Shift+Enter, Shift+click", "Add it, and choose on"),
            ("Escape", "Leave"),
        ],
    ),
    (
        "In the list of materials",
        &[
            ("Double-click or F2", "Rename"),
            ("Drag the grip, Alt+Up, Alt+Down", "Change the order"),
            ("Delete", "Remove"),
            ("Right-click", "Everything else"),
        ],
    ),
    (
        "At a slider",
        &[
            ("Left, Right", "Move it by a step, while it has the focus"),
            ("Click the number", "Type a value"),
            (
                "Tab, Shift+Tab",
                "Go to the next control, or the one before",
            ),
        ],
    ),
];

/// The window of the help. Returns whether it stays open.
#[must_use]
pub fn show(ctx: &Context) -> bool {
    let modal = Modal::new(Id::unique("help")).show(ctx, |ui| {
        ui.set_width(theme::HELP_SIZE.x.min(theme::room_of_dialog(ctx).x));
        ui.heading("Keyboard and mouse");
        let height = ctx.content_rect().height() - 2.0 * theme::HELP_MARGIN;
        ScrollArea::vertical()
            .max_height(theme::HELP_SIZE.y.min(height))
            .show(ui, contents);
        ui.add_space(4.0);
        ui.button("Close the list")
            .on_hover_text("Close the help (Escape)")
            .clicked()
    });
    !modal.inner && !modal.should_close()
}

fn contents(ui: &mut Ui) {
    for group in Group::ALL {
        section(ui, group.title(), |ui| {
            let of_group = |command: &&&Command| command.group == group;
            for command in COMMANDS.iter().filter(of_group) {
                row(ui, &command.keys(ui.ctx()), command.title, command.hint);
            }
        });
    }
    for (title, gestures) in GESTURES {
        section(ui, title, |ui| {
            for (gesture, effect) in gestures {
                row(ui, gesture, effect, "");
            }
        });
    }
}

fn section(ui: &mut Ui, title: &str, rows: impl FnOnce(&mut Ui)) {
    ui.add_space(6.0);
    ui.label(RichText::new(title).strong());
    if ui.available_width() < 2.0 * theme::HELP_KEYS_WIDTH {
        // What is done stands below its keys.
        ui.vertical(rows);
        return;
    }
    Grid::new(title)
        .num_columns(2)
        .min_col_width(theme::HELP_KEYS_WIDTH)
        .show(ui, rows);
}

fn row(ui: &mut Ui, keys: &str, effect: &str, hint: &str) {
    ui.label(RichText::new(keys).monospace().small());
    let effect = ui.label(effect);
    if !hint.is_empty() {
        effect.on_hover_text(hint);
    }
    ui.end_row();
}
