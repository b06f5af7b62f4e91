//! Several materials side by side: a picture of each under its name, its kind and, where it has one of its own, its scale.

use egui::{Align2, Rect, TextStyle, Ui, vec2};

use super::context::ViewContext;
use crate::theme;
use crate::widgets::{choice, draw, pictures};
use bxdf_study::format;
use bxdf_study::session::{EntryId, Session};

/// Between what is said of a material on one line.
const BETWEEN: &str = " · ";

/// The places of the pictures in `room`, `aspect` being width over height of each, below their titles, which are drawn. `all`: the
/// materials, each with the value in 1/sr at the full length where that is its own.
pub(super) fn cells<O>(
    ui: &Ui,
    cx: &mut ViewContext<'_, O>,
    (room, aspect): (Rect, f32),
    all: &[(EntryId, Option<f64>)],
) -> Vec<Rect> {
    let lines = |(entry, own): &(EntryId, Option<f64>)| lines(cx.session, *entry, *own);
    let mut below: Vec<Vec<String>> = all.iter().map(lines).collect();
    let on_one: Vec<String> = below.iter().map(|lines| lines.join(BETWEEN)).collect();
    let widths = on_one
        .iter()
        .map(|line| choice::width_of(ui, line, &TextStyle::Small));
    let widest = widths.fold(0.0, f32::max);
    let cells_below = |rows: usize| pictures::cells_below(ui, (room, aspect), all.len(), rows);
    let mut cells = cells_below(2);
    if cells
        .first()
        .is_some_and(|cell| cell.title.width() < widest)
    {
        let most = below.iter().map(Vec::len).max().unwrap_or_default();
        cells = cells_below(1 + most);
    } else {
        below = on_one.into_iter().map(|line| vec![line]).collect();
    }
    let row = draw::label_scale(ui) * theme::LEGEND_ROW;
    let titled = cells.into_iter().zip(all).zip(below);
    let draw_title =
        |((cell, (entry, _)), lines): ((pictures::Cell, &(EntryId, _)), Vec<String>)| {
            let name = cell.title.with_max_y(cell.title.top() + row);
            let named = pictures::Cell {
                title: name,
                ..cell
            };
            pictures::title(ui, named, *entry, cx.session, cx.palette);
            let (font, ink) = (draw::small_font(ui), cx.palette.faint_ink);
            let painter = ui.painter_at(cell.title);
            for (index, line) in lines.into_iter().enumerate() {
                let middle = name.left_center() + vec2(0.0, row * (index + 1) as f32);
                painter.text(middle, Align2::LEFT_CENTER, line, font.clone(), ink);
            }
            cell.picture
        };
    titled.map(draw_title).collect()
}

/// What is said of a material below its name.
fn lines(session: &Session, entry: EntryId, own: Option<f64>) -> Vec<String> {
    let Some(found) = session.materials.get(entry) else {
        return Vec::new();
    };
    let kind = found.material.category().title().to_owned();
    let quantity = if session.with_cosine { "f cos θ" } else { "f" };
    // A mirror alone has no f that could have a peak.
    let own = own.filter(|peak| *peak > 0.0).map(|peak| {
        let peak = format::value(peak);
        format!("own scale, peak {quantity} {peak} 1/sr")
    });
    [kind].into_iter().chain(own).collect()
}
