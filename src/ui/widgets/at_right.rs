//! What stands at the right end of a bar, in the order in which it is read: Tab goes through it from left to right.

use egui::{Align, Id, Layout, Ui, UiBuilder};

/// The change of a width that is seen, in points.
const SEEN: f32 = 0.5;

/// The width that what is known by `id` had when it was last drawn, in points.
#[must_use]
pub fn width(ui: &Ui, id: Id) -> f32 {
    ui.data(|data| data.get_temp(id)).unwrap_or_default()
}

/// Draws what `add` adds from left to right up to the right end of the room, and keeps its width under `id`: the first time it
/// is drawn twice.
pub fn show<R>(ui: &mut Ui, id: Id, add: impl FnOnce(&mut Ui) -> R) -> R {
    let kept = width(ui, id);
    let room = ui.available_rect_before_wrap();
    let place = room.with_min_x((room.right() - kept).max(room.left()));
    let layout = Layout::left_to_right(Align::Center);
    let scope = UiBuilder::new().max_rect(place).layout(layout);
    let shown = ui.scope_builder(scope, add);
    let used = shown.response.rect.width();
    if (used - kept).abs() > SEEN {
        ui.data_mut(|data| data.insert_temp(id, used));
        ui.ctx()
            .request_discard("what stands at the right end is measured");
    }
    shown.inner
}
