//! A material as an icon: its sphere, over its line and colour in the views.

use egui::{Color32, Rect, Response, Role, Sense, StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2};

use crate::theme::{self, Dash, Palette};
use crate::widgets::draw;
use crate::widgets::focus;
use crate::widgets::thumbnails::{self, Thumbnails};
use bxdf_study::answers::Answers;
use bxdf_study::session::{MaterialEntry, Materials};

/// The room above and below the picture, in points: the line stands in the lower one.
const MARGINS: [f32; 2] = [3.0, 7.0];

/// An icon, about to be shown.
pub(super) struct Icon<'a> {
    pub(super) materials: &'a Materials,
    pub(super) entry: &'a MaterialEntry,
}

impl Icon<'_> {
    /// The icon, as wide as there is room.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        thumbnails: &mut Thumbnails,
        answers: &mut Answers,
        palette: &Palette,
    ) -> Response {
        let [above, below] = MARGINS;
        let side = theme::ROW_PICTURE;
        let size = vec2(ui.available_width(), above + side + below);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let title = self.materials.title(self.entry);
        let is_selected = self.materials.selected().id() == self.entry.id();
        let name = format!("Select {title}");
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &name));
        if ui.is_rect_visible(rect) {
            let visuals = ui.visuals();
            if is_selected {
                ui.painter()
                    .rect_filled(rect, 4.0, visuals.selection.bg_fill);
            } else if response.hovered() {
                let stroke = visuals.widgets.hovered.bg_stroke;
                ui.painter()
                    .rect_stroke(rect, 4.0, stroke, StrokeKind::Inside);
            }
            let strength = if self.materials.is_shown(self.entry) {
                1.0
            } else {
                theme::HIDDEN_STRENGTH
            };
            let corner = rect.center_top() + vec2(-0.5 * side, above);
            let place = Rect::from_min_size(corner, Vec2::splat(side));
            if let Some(texture) = thumbnails.of_entry(ui.ctx(), self.entry, side, answers) {
                thumbnails::paint(ui, place, texture, Color32::WHITE.gamma_multiply(strength));
            }
            let y = rect.bottom() - 0.5 * below;
            let ends = [place.left(), place.right()].map(|x| pos2(x, y));
            let slot = self.entry.slot();
            let color = palette.material(slot).gamma_multiply(strength);
            let stroke = (theme::CURVE_WIDTH, color);
            draw::line(ui.painter(), ends, stroke, Dash::of(slot));
            focus::ring(ui, &response);
        }
        response.on_hover_text(format!("{title}\nClick to select it"))
    }
}
