//! The panel at the side: whether it is folded, and the picker beside it.

use egui::{Context, Key, Modifiers, Popup, Vec2};

use super::App;
use crate::theme;

/// Where the panel at the side is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drawer {
    /// Beside the views: the window has room for it.
    #[default]
    Beside,
    /// Nowhere: the window is small, with one view at a time.
    Closed,
    /// Over the view of a small window.
    Open,
}

impl App {
    /// Whether the window is small: one view at a time, and the panel at the side over it.
    #[must_use]
    pub fn is_small(&self) -> bool {
        self.drawer != Drawer::Beside
    }

    /// Takes note of how large the window is now.
    pub(crate) fn fit_to(&mut self, size: Vec2, ctx: &Context) {
        let is_small = self.only.is_none() && theme::is_small(size);
        if is_small != self.is_small() {
            self.drawer = if is_small {
                Drawer::Closed
            } else {
                Drawer::Beside
            };
        }
        theme::fit_to_hand(ctx, is_small);
    }

    /// Whether the panel at the side is folded: in a small window it is gone until it is asked for, elsewhere it is icons, as
    /// it was chosen, else where the window is narrow.
    #[must_use]
    pub fn is_side_folded(&self, ctx: &Context) -> bool {
        if self.is_small() {
            return self.drawer == Drawer::Closed;
        }
        self.side.is_folded.unwrap_or_else(|| is_narrow(ctx))
    }

    /// Folds the panel at the side, or unfolds it. What a window of its width does anyway is no choice that is kept.
    pub fn fold_side(&mut self, ctx: &Context) {
        if self.is_small() {
            self.drawer = match self.drawer {
                Drawer::Closed => Drawer::Open,
                _ => Drawer::Closed,
            };
            return;
        }
        let wanted = !self.is_side_folded(ctx);
        self.side.is_folded = (wanted != is_narrow(ctx)).then_some(wanted);
    }

    /// Whether Escape is pressed for the panel that lies over the view: nothing above it takes the key.
    pub(crate) fn is_drawer_escaped(&self, ctx: &Context) -> bool {
        let is_below = Popup::is_any_open(ctx) || self.picker.is_open() || self.is_help_shown;
        let has_focus = self.is_typed_in(ctx);
        let is_pressed =
            |input: &mut egui::InputState| input.consume_key(Modifiers::NONE, Key::Escape);
        !is_below && !has_focus && ctx.input_mut(is_pressed)
    }

    /// Lets the picker add the next choice, or not any more.
    pub fn start_adding(&mut self, ctx: &Context) {
        let selected = self.session.materials.selected();
        self.picker.toggle(ctx, true, selected);
    }

    /// Lets the picker replace the selected material by the next choice, or not any more.
    pub fn start_changing(&mut self, ctx: &Context) {
        let selected = self.session.materials.selected();
        self.picker.toggle(ctx, false, selected);
    }
}

fn is_narrow(ctx: &Context) -> bool {
    ctx.content_rect().width() < theme::FOLD_BELOW
}
