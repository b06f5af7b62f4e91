//! The names of lines across a chart, each beside its line.

use egui::{Align2, Pos2, Rect, Ui, vec2};

use super::series::Mark;
use super::{Chart, Shown, draw};
use crate::theme::Palette;

impl Chart {
    /// The names of the marks at the top, of the levels at the right. Returns where they stand.
    pub(super) fn name_marks(&self, ui: &Ui, shown: &Shown, palette: &Palette) -> Vec<Rect> {
        let frame = shown.frame();
        let painter = ui.painter_at(frame);
        let mut taken: Vec<Rect> = Vec::new();
        let font = draw::small_font(ui);
        let size = |mark: &Mark| {
            let galley = painter.layout_no_wrap(mark.name.clone(), font.clone(), mark.color);
            galley.size()
        };
        let write = |mark: &Mark, rect: Rect| {
            let (font, color) = (font.clone(), mark.color);
            let (at, anchor) = (rect.min, Align2::LEFT_TOP);
            draw::haloed_text(&painter, at, anchor, &mark.name, font, color, palette);
        };
        let at = |mark: &Mark| shown.position([self.x.place(mark.at), 0.0]).x;
        let lines: Vec<f32> = self.marks.iter().map(at).collect();
        let mut marks: Vec<&Mark> = self.marks.iter().collect();
        marks.retain(|mark| !mark.name.is_empty() && frame.x_range().contains(at(mark)));
        // Those first that find a place where they cover no line; the others where they cover no name.
        for lines in [&lines[..], &[]] {
            marks.retain(|mark| {
                let place = beside_line((&taken, frame), lines, at(mark), size(mark));
                if let Some(rect) = place {
                    taken.push(rect);
                    write(mark, rect);
                }
                place.is_none()
            });
        }
        for level in self.levels.iter().filter(|level| !level.name.is_empty()) {
            let y = shown.position([0.0, self.y.place(level.at)]).y;
            if frame.y_range().contains(y) {
                let place = Pos2::new(frame.right() - 4.0, y - 2.0);
                let rect = Align2::RIGHT_BOTTOM.anchor_size(place, size(level));
                let place = draw::free_place(&mut taken, rect);
                let is_over = |other: &Rect| *other != place && other.intersects(place);
                if frame.contains_rect(place) && !taken.iter().any(is_over) {
                    write(level, place);
                }
            }
        }
        taken
    }
}

/// The place of a name of this size beside the upright line at `x`: to its right or left in the highest row of the frame
/// where none of `taken` stands, and none of the upright `lines`.
fn beside_line(
    (taken, frame): (&[Rect], Rect),
    lines: &[f32],
    x: f32,
    size: egui::Vec2,
) -> Option<Rect> {
    const ROWS: u8 = 6;
    let of_row = |row: u8| {
        // Rows that touch would take each other's places.
        let y = frame.top() + 2.0 + f32::from(row) * (size.y + 1.0);
        let right = Rect::from_min_size(Pos2::new(x + 3.0, y), size);
        [right, right.translate(vec2(-size.x - 6.0, 0.0))]
    };
    let is_free = |place: &Rect| {
        frame.contains_rect(*place)
            && taken.iter().all(|other| !other.intersects(*place))
            && !lines.iter().any(|line| place.x_range().contains(*line))
    };
    (0..ROWS).flat_map(of_row).find(is_free)
}
