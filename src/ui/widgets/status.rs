//! The status line: the shares of light, the value under the pointer, whether something is being computed.

use egui::{Align, Label, Layout, Ui};

use super::{draw, shares};
use crate::theme::Palette;
use bxdf_lab::analysis::reflectance::LobeShare;
use bxdf_study::answers::Progress;
use bxdf_study::cursor::Cursor;
use bxdf_study::session::Session;

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
            show_progress(ui, progress);
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

/// Whether something is being computed; how long the last change took is told only to who points there.
fn show_progress(ui: &mut Ui, progress: Progress) {
    let Progress::Complete(last) = progress else {
        ui.label("Computing…")
            .on_hover_text("Any change cancels what is being computed");
        return;
    };
    let took = last.map_or_else(String::new, |seconds| {
        format!(
            ": the last change took {:.1} ms to its full result",
            1000.0 * seconds
        )
    });
    let mark = ui.weak("✔").on_hover_text(format!("Up to date{took}"));
    ui.ctx()
        .accesskit_node_builder(mark.id, |node| node.set_value("Up to date"));
}
