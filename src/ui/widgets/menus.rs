//! What lies below an open menu.

use egui::{Area, Context, Id, Order, Popup, Sense};

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
