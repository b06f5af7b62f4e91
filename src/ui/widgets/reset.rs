//! The button that puts back a view which was panned, zoomed or turned.

use egui::{Align2, Button, Id, Rect, RichText, Sense, TextWrapMode, Ui, UiBuilder};
use egui_plot::PlotMemory;

use super::still;
use crate::theme;

/// Where the button stands in a corner of `room`.
#[must_use]
pub fn place(room: Rect, corner: Align2) -> Rect {
    corner.align_size_within_rect(theme::RESET_VIEW, room.shrink(theme::TILE_MARGIN))
}

/// The button, in a corner of `room`, where the view `is_changed`. Returns whether it is clicked.
pub fn button(ui: &mut Ui, room: Rect, corner: Align2, is_changed: bool) -> bool {
    let place = place(room, corner);
    // It takes no room, and what comes after it keeps its id, whether it is shown or not.
    let mut above = ui.new_child(UiBuilder::new().max_rect(place).id_salt("reset view"));
    theme::plain_text(&mut above);
    // A drag that begins on it is none of the view below.
    let text = RichText::new("Reset view").small();
    let button = Button::new(text)
        .sense(Sense::click_and_drag())
        .wrap_mode(TextWrapMode::Extend);
    is_changed
        && !still::is(ui)
        && above
            .add_sized(theme::RESET_VIEW, button)
            .on_hover_text("Undo panning, zooming and turning (double-click the view)")
            .clicked()
}

/// The button of the plot with this id, whose frame is `room`; it acts by itself.
pub fn of_plot(ui: &mut Ui, id: Id, room: Rect, is_changed: bool) {
    if button(ui, room, Align2::RIGHT_BOTTOM, is_changed)
        && let Some(mut memory) = PlotMemory::load(ui.ctx(), id)
    {
        memory.auto_bounds = true.into();
        memory.store(ui.ctx(), id);
        ui.ctx().request_repaint();
    }
}
