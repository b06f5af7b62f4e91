//! Presenting: the views alone, large, with one slim bar below them.

use egui::{Context, Key, Modifiers, ViewportCommand};

use super::App;
use crate::theme;
use crate::widgets::hint;

impl App {
    /// Whether the views are shown alone, for a class.
    #[must_use]
    pub fn is_presenting(&self) -> bool {
        self.zoom_before.is_some()
    }

    /// Begins to present, or ends it.
    pub fn switch_presenting(&mut self, ctx: &Context) {
        let ends = self.zoom_before.take();
        if let Some(before) = ends {
            ctx.set_zoom_factor(before);
        } else {
            self.zoom_before = Some(ctx.zoom_factor());
        }
        ctx.send_viewport_cmd(ViewportCommand::Fullscreen(ends.is_none()));
    }

    /// Keeps labels and strokes as large as the screen allows, and ends with Escape.
    pub(crate) fn present(&mut self, ctx: &Context) {
        hint::present(ctx, self.is_presenting());
        let Some(before) = self.zoom_before else {
            return;
        };
        let is_left =
            |input: &mut egui::InputState| input.consume_key(Modifiers::NONE, Key::Escape);
        // Escape closes a menu first.
        if !egui::Popup::is_any_open(ctx) && ctx.input_mut(is_left) {
            self.switch_presenting(ctx);
            return;
        }
        let width = ctx.content_rect().width() * ctx.zoom_factor() / before;
        ctx.set_zoom_factor(before * zoom(width));
    }
}

/// By how much a screen of this width, in points, is enlarged: twice, where that leaves room for two views.
fn zoom(width: f32) -> f32 {
    (width / theme::PRESENTED_WIDTH).clamp(1.0, theme::PRESENTED_ZOOM)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_twice_as_large_where_there_is_room() {
        assert_eq!(zoom(1920.0), 2.0);
        assert_eq!(zoom(3840.0), 2.0);
        assert_eq!(zoom(600.0), 1.0);
        assert!(zoom(1280.0) > 1.3);
    }
}
