//! The legend of a view that shows several materials.

use egui::{
    FontSelection, Pos2, Rect, RichText, Role, Sense, TextWrapMode, Ui, WidgetInfo, WidgetText,
    vec2,
};

use super::draw;
use crate::ui::session::{MaterialEntry, Session};
use crate::ui::theme::{self, Dash, Palette};

/// What stands before a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sample {
    /// The line of a curve.
    Line,
    /// The colour of a surface.
    Patch,
}

/// The share of the view that the legend may cover.
const LARGEST: egui::Vec2 = vec2(0.34, 0.6);

/// The distance from the corner of the view.
const MARGIN: egui::Vec2 = vec2(6.0, 6.0);

/// The names of the materials in the upper left corner of `frame`; a click selects one. A single one needs no legend.
pub fn show(ui: &Ui, frame: Rect, sample: Sample, session: &mut Session, palette: &Palette) {
    if !session.materials.is_overlay() {
        return;
    }
    let width = LARGEST.x * frame.width();
    let row_at = |row: usize| {
        let corner = frame.left_top() + MARGIN + vec2(0.0, row as f32 * theme::LEGEND_ROW);
        Rect::from_min_size(corner, vec2(width, theme::LEGEND_ROW))
    };
    let fitting = (LARGEST.y * frame.height() / theme::LEGEND_ROW).max(1.0) as usize;
    let count = session.materials.shown().count();
    // The last row says how many are left out.
    let rows = if count > fitting { fitting - 1 } else { count };
    let selected = session.materials.selected().id();
    let mut chosen = None;
    for (row, entry) in session.materials.shown().take(rows).enumerate() {
        let title = session.materials.title(entry);
        let id = ui.scope_id().with(("legend", entry.id()));
        let response = ui.interact(row_at(row), id, Sense::click());
        let is_selected = entry.id() == selected;
        let name = format!("Legend: {title}");
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &name));
        let is_strong = is_selected || response.hovered();
        draw_row(ui, row_at(row), sample, entry, (&title, is_strong), palette);
        if response
            .on_hover_text(format!(
                "{title}\nClick to select it: the panel at the side edits it"
            ))
            .clicked()
        {
            chosen = Some(entry.id());
        }
    }
    if count > rows {
        let place = row_at(rows).left_center();
        let text = format!("and {} more", count - rows);
        let font = draw::small_font(ui);
        ui.painter_at(frame).text(
            place,
            egui::Align2::LEFT_CENTER,
            text,
            font,
            palette.faint_ink,
        );
    }
    if let Some(id) = chosen {
        session.materials.select(id);
    }
}

/// A row: the sample, and the name as far as it fits; `is_strong`: in full ink.
fn draw_row(
    ui: &Ui,
    rect: Rect,
    sample: Sample,
    entry: &MaterialEntry,
    (title, is_strong): (&str, bool),
    palette: &Palette,
) {
    let color = palette.material(entry.slot());
    let text = if is_strong {
        RichText::new(title).small().strong().color(palette.ink)
    } else {
        RichText::new(title).small().color(palette.faint_ink)
    };
    let room = rect.width() - theme::LINE_SAMPLE - 8.0;
    let galley = WidgetText::from(text).into_galley(
        ui,
        Some(TextWrapMode::Truncate),
        room,
        FontSelection::Default,
    );
    let painter = ui.painter();
    let covered = Rect::from_min_size(
        rect.min,
        vec2(
            theme::LINE_SAMPLE + 10.0 + galley.size().x,
            theme::LEGEND_ROW,
        ),
    );
    painter.rect_filled(covered, 2.0, palette.background.gamma_multiply(0.8));
    let left = rect.left_center() + vec2(2.0, 0.0);
    match sample {
        Sample::Line => {
            let ends = [left, left + vec2(theme::LINE_SAMPLE, 0.0)];
            let stroke = (theme::CURVE_WIDTH, color);
            draw::line(painter, ends, stroke, Dash::of(entry.slot()));
        }
        Sample::Patch => {
            let size = theme::SWATCH;
            let patch = Rect::from_min_size(left - vec2(0.0, 0.5 * size.y), size);
            painter.rect_filled(patch, 2.0, color);
        }
    }
    let place = Pos2::new(
        left.x + theme::LINE_SAMPLE + 6.0,
        rect.center().y - 0.5 * galley.size().y,
    );
    painter.galley(place, galley, palette.ink);
}
