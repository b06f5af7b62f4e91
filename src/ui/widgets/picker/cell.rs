//! What can be chosen, in the grid: its picture and its name.

use egui::text::LayoutJob;
use egui::{
    Align, Color32, Rect, Response, Role, Sense, StrokeKind, TextFormat, TextStyle, Ui, WidgetInfo,
    vec2,
};

use super::entry::Entry;
use crate::theme;
use crate::widgets::thumbnails::{self, Thumbnails};
use bxdf_study::answers::Answers;

/// The room above a picture and between it and the name, in points.
const GAP: f32 = 4.0;

/// The lines that a name may take.
const NAME_LINES: usize = 2;

/// A cell, about to be shown.
pub(super) struct Cell {
    pub(super) entry: Entry,
    /// Whether the selected material was chosen as this.
    pub(super) is_selected: bool,
    /// Whether Enter chooses it.
    pub(super) is_next: bool,
}

impl Cell {
    /// The cell; the name says it all to those who do not see.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        thumbnails: &mut Thumbnails,
        answers: &mut Answers,
    ) -> Response {
        let (rect, response) = ui.allocate_exact_size(theme::CELL, Sense::click());
        let title = self.entry.title();
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, self.is_selected, &title));
        if ui.is_rect_visible(rect) {
            self.background(ui, rect, &response);
            let corner = rect.center_top() + vec2(-0.5 * theme::CELL_PICTURE, GAP);
            let place = Rect::from_min_size(corner, egui::Vec2::splat(theme::CELL_PICTURE));
            let material = self.entry.material();
            let listed = (self.entry.id(), &*material);
            let texture = thumbnails.of_listed(ui.ctx(), listed, theme::CELL_PICTURE, answers);
            if let Some(texture) = texture {
                thumbnails::paint(ui, place, texture, Color32::WHITE);
            }
            self.name(ui, rect.with_min_y(place.bottom() + GAP), &title);
        }
        response.on_hover_text(self.entry.hint())
    }

    fn background(&self, ui: &Ui, rect: Rect, response: &Response) {
        let visuals = ui.visuals();
        let radius = visuals.widgets.inactive.corner_radius;
        if self.is_selected {
            ui.painter()
                .rect_filled(rect, radius, visuals.selection.bg_fill);
        } else if response.hovered() {
            let fill = visuals.widgets.hovered.weak_bg_fill;
            ui.painter().rect_filled(rect, radius, fill);
        }
        if self.is_next || response.has_focus() {
            let stroke = visuals.selection.stroke;
            ui.painter()
                .rect_stroke(rect, radius, stroke, StrokeKind::Inside);
        }
    }

    fn name(&self, ui: &Ui, rect: Rect, title: &str) {
        // The sides stay together.
        let title = title.replace(" + ", "\u{a0}+\u{a0}");
        let color = if self.is_selected {
            ui.visuals().strong_text_color()
        } else {
            ui.visuals().text_color()
        };
        let format = TextFormat::simple(TextStyle::Small.resolve(ui.style()), color);
        let mut job = LayoutJob::single_section(title, format);
        job.halign = Align::Center;
        job.wrap.max_width = rect.width() - 2.0 * GAP;
        job.wrap.max_rows = NAME_LINES;
        let galley = ui.painter().layout_job(job);
        ui.painter().galley(rect.center_top(), galley, color);
    }
}
