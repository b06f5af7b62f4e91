//! Small windows, as on phones: from which size on a window is one, and the sizes in it.

use egui::Vec2;

/// Below this width or this height, in points, a window is small: see [`is_small`].
pub const SMALL_WINDOW: Vec2 = Vec2::new(700.0, 480.0);
/// The least height of what is pressed in a small window, in points: a finger is to hit it.
pub const TOUCHED: f32 = 32.0;
/// The least width beside the panel at the side that lies over the view in a small window, in points: pressed there, it goes.
pub const BESIDE_DRAWER: f32 = 64.0;
/// How dark that is beside it, 0..255.
pub const DRAWER_SHADE: u8 = 120;
/// The part of the height of a small window that a lesson takes below the view.
pub const LESSON_HEIGHT_SHARE: f32 = 0.45;

/// The room around the help, in points.
pub const HELP_MARGIN: f32 = 80.0;

/// Whether a window of this size, in points, has room for one view at a time alone, as on a phone.
#[must_use]
pub fn is_small(size: Vec2) -> bool {
    size.x < SMALL_WINDOW.x || size.y < SMALL_WINDOW.y
}

/// The room that a dialog has in the window, in points: it leaves the least at the edges of a small one.
#[must_use]
pub fn room_of_dialog(ctx: &egui::Context) -> Vec2 {
    let window = ctx.content_rect().size();
    let margin = if is_small(window) {
        SMALL_DIALOG_MARGIN
    } else {
        HELP_MARGIN
    };
    window - Vec2::splat(margin)
}

/// The room around a dialog in a small window, with its frame, in points.
const SMALL_DIALOG_MARGIN: f32 = 32.0;

/// The height of what is pressed where a mouse points, in points.
pub(super) const POINTED_AT: f32 = 20.0;

/// Lets what is pressed be high enough for a finger, or for a mouse alone. Menus and windows follow: it holds for all of them.
pub fn fit_to_hand(ctx: &egui::Context, is_touched: bool) {
    let height = if is_touched { TOUCHED } else { POINTED_AT };
    if ctx.global_style().spacing.interact_size.y != height {
        ctx.all_styles_mut(|style| style.spacing.interact_size.y = height);
    }
}
