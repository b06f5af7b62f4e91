//! What lies below an open menu, and what of a long one is seen in a small window.

use egui::{Area, Context, Id, Order, Popup, ScrollArea, Sense, Ui};

use crate::theme;

/// The room above and below a menu that is as high as the window, in points.
const EDGE: f32 = 24.0;

/// The entries of a menu; in a small window they are scrolled where it is lower than they are.
pub fn entries<R>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
    let room = ui.ctx().content_rect().size();
    if !theme::is_small(room) {
        return add(ui);
    }
    let area = ScrollArea::vertical().max_height(room.y - 2.0 * EDGE);
    area.show(ui, add).inner
}

/// Takes the clicks and drags beside an open menu, which close it, so that they do nothing to what lies there. To be called when
/// all is drawn.
pub fn shield(ctx: &Context) {
    if !Popup::is_any_open(ctx) {
        return;
    }
    let room = ctx.content_rect();
    Area::new(Id::unique("below a menu"))
        .order(Order::Middle)
        .movable(false)
        .fixed_pos(room.min)
        .show(ctx, |ui| {
            // Tab does not stop at it.
            let (_, _) = ui.allocate_exact_size(room.size(), Sense::CLICK | Sense::DRAG);
        });
}
