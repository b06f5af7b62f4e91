//! The legend of a view that shows several materials.

use std::sync::Arc;

use egui::{
    Align2, FontSelection, Rect, RichText, Role, Sense, TextWrapMode, Ui, WidgetInfo, WidgetText,
    pos2, vec2,
};

use super::{draw, hint, still};
use crate::theme::{self, Dash, Palette};
use bxdf_study::session::{EntryId, MaterialEntry, Session};

/// What stands before a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Swatch {
    /// The line of a curve.
    Line,
    /// The colour of a surface.
    Patch,
}

/// The most rows of names: as many as leave room for the view.
const MAX_ROWS: usize = 5;

/// Between the swatch and the name, and between two entries, in points.
const GAPS: [f32; 2] = [6.0, 14.0];

/// The room for how many are left out, in points.
const MORE: f32 = 84.0;

/// The least room for a name, in points.
const SHORTEST: f32 = 60.0;

/// The room to the left of the first entry, in points.
const MARGIN: f32 = 4.0;

/// An entry of the legend, laid out.
struct Item<'a> {
    entry: &'a MaterialEntry,
    title: String,
    text: Arc<egui::Galley>,
    /// What stands behind the name.
    number: Arc<egui::Galley>,
    /// Its place, counted from the corner of the legend.
    place: Rect,
}

/// The names of the materials shown, above a view, each with its number of `numbers` behind it where there are any; a click
/// selects one. A single one needs no legend.
pub fn show(
    ui: &mut Ui,
    swatch: Swatch,
    numbers: &[String],
    session: &mut Session,
    palette: &Palette,
) {
    if !session.materials.is_overlay() {
        return;
    }
    let items = items(ui, session, numbers);
    let left_out = session.materials.shown().count() - items.len();
    let last = items.last().map_or(Rect::ZERO, |item| item.place);
    let width = ui.available_width();
    let (legend, _) = ui.allocate_exact_size(vec2(width, last.bottom()), Sense::hover());
    let selected = session.materials.selected().id();
    let mut chosen: Option<EntryId> = None;
    for item in &items {
        let rect = item.place.translate(legend.min.to_vec2());
        let id = ui.scope_id().with(("legend", item.entry.id()));
        if still::is(ui) {
            draw_item(ui, rect, swatch, item, false, palette);
            continue;
        }
        let response = ui.interact(rect, id, Sense::click());
        let is_selected = item.entry.id() == selected;
        let name = format!("Legend: {}", item.title);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &name));
        let is_strong = is_selected || response.hovered();
        draw_item(ui, rect, swatch, item, is_strong, palette);
        let words = format!(
            "{}\nClick to select it: the panel at the side edits it",
            item.title
        );
        if hint::in_plot(response, &words).clicked() {
            chosen = Some(item.entry.id());
        }
    }
    if left_out > 0 {
        let place = legend.min + last.right_center().to_vec2() + vec2(GAPS[1], 0.0);
        let (text, font) = (format!("and {left_out} more"), draw::small_font(ui));
        ui.painter()
            .text(place, Align2::LEFT_CENTER, text, font, palette.faint_ink);
    }
    if let Some(id) = chosen {
        session.materials.select(id);
    }
}

/// The entries that fit, one after the other in rows.
fn items<'a>(ui: &Ui, session: &'a Session, numbers: &[String]) -> Vec<Item<'a>> {
    let [gap, distance] = GAPS;
    let width = ui.available_width();
    let share = if numbers.is_empty() { 0.5 } else { 1.0 };
    let longest = share * width - theme::LINE_SAMPLE - gap - distance;
    // Nobody can ask a picture for what is left out.
    let most_rows = if still::is(ui) { usize::MAX } else { MAX_ROWS };
    let written = |text: &str, room: f32| {
        let (text, wrap) = (RichText::new(text).small(), TextWrapMode::Truncate);
        WidgetText::from(text).into_galley(ui, Some(wrap), room, FontSelection::Default)
    };
    let (mut x, mut row) = (MARGIN, 0);
    let mut items = Vec::new();
    let mut shown = session.materials.shown().zip(0_usize..).peekable();
    while let Some((entry, index)) = shown.next() {
        let title = session.materials.title(entry);
        let number = numbers.get(index).map_or("", String::as_str);
        let number = written(number, f32::INFINITY);
        let behind = match number.size().x {
            0.0 => 0.0,
            width => gap + width,
        };
        let text = written(&title, (longest - behind).max(SHORTEST));
        let height = draw::label_scale(ui) * theme::LEGEND_ROW;
        let size = vec2(theme::LINE_SAMPLE + gap + text.size().x + behind, height);
        if x > MARGIN && x + size.x > width {
            (x, row) = (MARGIN, row + 1);
        }
        // Behind the last one that fits stands how many are left out.
        let is_followed = row + 1 == most_rows && shown.peek().is_some();
        if row == most_rows || (is_followed && x + size.x + MORE > width) {
            break;
        }
        let corner = pos2(x, row as f32 * height);
        let place = Rect::from_min_size(corner, size);
        x += size.x + distance;
        items.push(Item {
            entry,
            title,
            text,
            number,
            place,
        });
    }
    items
}

fn draw_item(
    ui: &Ui,
    rect: Rect,
    swatch: Swatch,
    item: &Item<'_>,
    is_strong: bool,
    palette: &Palette,
) {
    let color = palette.material(item.entry.slot());
    let painter = ui.painter();
    let left = rect.left_center();
    match swatch {
        Swatch::Line => {
            let ends = [left, left + vec2(theme::LINE_SAMPLE, 0.0)];
            let stroke = (theme::CURVE_WIDTH, color);
            draw::line(painter, ends, stroke, Dash::of(item.entry.slot()));
        }
        Swatch::Patch => {
            let size = theme::SWATCH;
            let corner = left + vec2(theme::LINE_SAMPLE - size.x, -0.5 * size.y);
            painter.rect_filled(Rect::from_min_size(corner, size), 2.0, color);
        }
    }
    let ink = if is_strong {
        palette.ink
    } else {
        palette.faint_ink
    };
    let x = left.x + theme::LINE_SAMPLE + GAPS[0];
    let place = pos2(x, rect.center().y - 0.5 * item.text.size().y);
    painter.galley_with_override_text_color(place, Arc::clone(&item.text), ink);
    let behind = place + vec2(item.text.size().x + GAPS[0], 0.0);
    painter.galley_with_override_text_color(behind, Arc::clone(&item.number), ink);
    if is_strong {
        let below = rect.bottom() - 1.0;
        painter.hline(x..=rect.right(), below, (1.0, color));
    }
}
