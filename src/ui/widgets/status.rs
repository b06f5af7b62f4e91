//! The status line: the shares of light, the value under the pointer, the time of the last update.

use egui::{Align, Label, Layout, Ui};

use super::{draw, shares};
use crate::analysis::reflectance::LobeShare;
use crate::ui::session::Session;
use crate::ui::theme::Palette;
use crate::ui::views::Cursor;

/// The line; `last_update` in seconds.
pub fn show(
    ui: &mut Ui,
    session: &Session,
    cursor: Option<&Cursor>,
    lobes: &[LobeShare],
    last_update: Option<f64>,
    palette: &Palette,
) {
    ui.horizontal(|ui| {
        shares::show(ui, lobes, palette);
        ui.separator();
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let time = last_update.map_or_else(
                || "-".to_owned(),
                |seconds| format!("{:.1} ms", 1000.0 * seconds),
            );
            ui.label(format!("Update {time}"))
                .on_hover_text("Time the last change took to compute");
            let note = cursor.map_or_else(
                || "Point at a view to read its value".to_owned(),
                |cursor| draw::cursor_text(cursor, session),
            );
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add(Label::new(note).truncate());
            });
        });
    });
}
