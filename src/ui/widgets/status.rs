//! The value under the pointer, and whether something is being computed.

use egui::{Label, RichText, Ui};

use super::draw;
use bxdf_lab::analysis::reflectance::has_flux;
use bxdf_study::answers::Progress;
use bxdf_study::cursor::Cursor;
use bxdf_study::session::{Curves, Session};

/// What the value is, where it is one number.
const LUMINANCE: &str = "The luminance of the value: its R, G and B weighted as the eye does. The Inspector has the channels";

/// What values are where the free direction lies in the surface plane.
pub const IN_PLANE: &str = "At θ = 90°, in the surface plane, f is the limit that it has there; no light crosses that plane, \
                            and f cos θ of a direction in it is 0";

/// The value under the pointer, in the room there is.
pub fn value(ui: &mut Ui, session: &Session, cursor: Option<(&Cursor, [f64; 3])>) {
    let text = cursor.map_or_else(
        || RichText::new("Point at a view to read its value").weak(),
        |(cursor, value)| RichText::new(draw::cursor_text(cursor, session, value)),
    );
    let mut shown = ui.add(Label::new(text).truncate());
    if cursor.is_some_and(|(cursor, _)| !has_flux(cursor.direction)) {
        shown = shown.on_hover_text(IN_PLANE);
    }
    if cursor.is_some() && session.shown_curves() == Curves::Luminance {
        shown.on_hover_text(LUMINANCE);
    }
}

/// Whether something is being computed; how long the last change took is told only to who points there.
pub fn progress(ui: &mut Ui, progress: Progress) {
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
