//! The status line: the shares of light, the value under the pointer, the time of the last update.

use egui::{Align, Label, Layout, Ui};

use super::{draw, shares};
use crate::analysis::reflectance::LobeShare;
use crate::ui::data::Progress;
use crate::ui::session::Session;
use crate::ui::theme::Palette;
use crate::ui::views::Cursor;

/// The line.
pub fn show(
    ui: &mut Ui,
    session: &Session,
    cursor: Option<(&Cursor, [f64; 3])>,
    lobes: &[LobeShare],
    progress: Progress,
    palette: &Palette,
) {
    ui.horizontal(|ui| {
        shares::show(ui, lobes, palette);
        ui.separator();
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let text = match progress {
                Progress::Computing => "Computing ...".to_owned(),
                Progress::Complete(None) => "Update -".to_owned(),
                Progress::Complete(Some(seconds)) => format!("Update {:.1} ms", 1000.0 * seconds),
            };
            ui.label(text)
                .on_hover_text("Time from the last change to its full result; any change cancels what is being computed");
            let note = cursor.map_or_else(
                || "Point at a view to read its value".to_owned(),
                |(cursor, value)| draw::cursor_text(cursor, session, value),
            );
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add(Label::new(note).truncate());
            });
        });
    });
}
