//! The panel at the side: whether it is folded, and the picker beside it.

use egui::Context;

use super::App;
use crate::theme;

impl App {
    /// Whether the panel at the side is folded to icons: as it was chosen, else where the window is narrow.
    #[must_use]
    pub fn is_side_folded(&self, ctx: &Context) -> bool {
        self.side.is_folded.unwrap_or_else(|| is_narrow(ctx))
    }

    /// Folds the panel at the side, or unfolds it. What a window of its width does anyway is no choice that is kept.
    pub fn fold_side(&mut self, ctx: &Context) {
        let wanted = !self.is_side_folded(ctx);
        self.side.is_folded = (wanted != is_narrow(ctx)).then_some(wanted);
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
