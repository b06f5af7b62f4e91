//! What maps of errors have alike: their colours, their axes, and the marks of what rounding does not explain.

use egui::{Align2, Rect, Ui, vec2};

use crate::theme::Palette;
use crate::widgets::draw;
use crate::widgets::pictures::{self, Cell, ColorScale, ScaleKind};
use bxdf::math::Real as _;
use bxdf_lab::analysis::raster::Raster;
use bxdf_lab::stability::map;
use bxdf_study::format;
use bxdf_study::views::stability::ErrorUnit;

/// The precisions, from the left.
pub(super) const PRECISIONS: [&str; 2] = ["f32", "f64"];

/// The errors that colours tell apart: below the rounding of f64, and all digits lost.
const ERRORS: [f64; 2] = [1e-17, 1.0];

/// The shares of the bound that colours tell apart.
const RATIOS: [f64; 2] = [1e-3, 10.0];

/// The numbers of roundings that colours tell apart.
const ROUNDINGS: [f64; 2] = [0.1, 1e3];

/// One rounding in each precision.
const UNIT_ROUNDOFFS: [f64; 2] = [f32::UNIT_ROUNDOFF, f64::UNIT_ROUNDOFF];

/// Maps are legible from this side on, in points.
const LEGIBLE: f32 = 130.0;

/// Room for the names and numbers of the axes, in points: at the left and below.
fn label_room(ui: &Ui) -> egui::Vec2 {
    draw::label_scale(ui) * vec2(54.0, 30.0)
}

/// Room between numbers of an axis, in points.
fn tick_spacing(ui: &Ui) -> f32 {
    draw::label_scale(ui) * 46.0
}

/// The colours of errors in this unit, and what the scale is called.
pub(super) fn colors(unit: ErrorUnit) -> (ColorScale, &'static str) {
    let (range, name) = match unit {
        ErrorUnit::Roundings => (ROUNDINGS, "error, in u"),
        ErrorUnit::Relative => (ERRORS, "relative error"),
        ErrorUnit::Bound => (RATIOS, "error over bound"),
    };
    let kind = ScaleKind::Logarithmic;
    (ColorScale { range, kind }, name)
}

/// That of both precisions which is asked for.
pub(super) fn of(both: [f64; 2], precision: usize) -> f64 {
    both.into_iter().nth(precision).unwrap_or(f64::NAN)
}

/// A relative error and its ratio to the bound, in this unit.
pub(super) fn in_unit(unit: ErrorUnit, precision: usize, error: f64, ratio: f64) -> f64 {
    match unit {
        ErrorUnit::Roundings => error / of(UNIT_ROUNDOFFS, precision),
        ErrorUnit::Relative => error,
        ErrorUnit::Bound => ratio,
    }
}

/// Room for `n` maps with their axes.
pub(super) fn rooms(ui: &Ui, room: Rect, n: usize) -> Vec<Rect> {
    let labels = label_room(ui);
    // As wide as high without its axes.
    let side = (room.height() / n as f32).max(2.0 * labels.x);
    let cells = pictures::cells(ui, room, n, (side + labels.x) / (side + labels.y));
    cells.iter().map(|cell| square(cell, labels)).collect()
}

/// By how much maps are too small to be legible, in points.
pub(super) fn lacking(rooms: &[Rect]) -> f32 {
    let small = rooms.iter().map(|room| LEGIBLE - room.height());
    small.fold(0.0, f32::max)
}

/// The largest square of a cell beside its axes.
fn square(cell: &Cell, labels: egui::Vec2) -> Rect {
    let mut picture = cell.picture;
    picture.min.x += labels.x;
    picture.max.y -= labels.y;
    let side = picture.width().min(picture.height());
    Rect::from_min_size(picture.min, vec2(side, side))
}

/// The name of a map, above it.
pub(super) fn title(ui: &Ui, picture: Rect, title: &str, palette: &Palette) {
    let place = picture.left_top() - vec2(0.0, 3.0);
    let font = draw::body_font(ui);
    ui.painter()
        .text(place, Align2::LEFT_BOTTOM, title, font, palette.ink);
}

/// Marks where the error is larger than rounding explains, or a result is no number; `ratio`: over the bound.
pub(super) fn draw_violations<T>(
    ui: &Ui,
    palette: &Palette,
    rect: Rect,
    map: &Raster<T>,
    ratio: impl Fn(&T) -> f64,
) {
    let painter = ui.painter_at(rect);
    let size = rect.size() / vec2(map.width.max(1) as f32, map.height.max(1) as f32);
    for (row, cells) in map.pixels.chunks(map.width.max(1)).enumerate() {
        let mut column = 0;
        for run in cells.chunk_by(|a, b| (ratio(a) > 1.0) == (ratio(b) > 1.0)) {
            if run.first().is_some_and(|cell| ratio(cell) > 1.0) {
                let corner = rect.min + vec2(column as f32, row as f32) * size;
                // A little over the next row, lest the map shine through between them.
                let size = vec2(run.len() as f32, 1.0) * size + vec2(0.0, OVERLAP);
                painter.rect_filled(Rect::from_min_size(corner, size), 0.0, palette.warning);
            }
            column += run.len();
        }
    }
}

/// How far a mark reaches over the next row, in points: its edge is blended over one.
const OVERLAP: f32 = 1.0;

/// An axis of a map.
pub(super) struct Axis {
    pub(super) title: String,
    pub(super) range: [f64; 2],
    pub(super) is_logarithmic: bool,
}

impl From<&map::Axis> for Axis {
    fn from(axis: &map::Axis) -> Self {
        Self {
            title: axis.title(),
            range: axis.range(),
            is_logarithmic: axis.is_logarithmic(),
        }
    }
}

/// Draws both axes about a map, the name of the upright one where it `is_first` in its row.
pub(super) fn draw_axes(
    ui: &Ui,
    rect: Rect,
    [across, up]: [&Axis; 2],
    is_first: bool,
    palette: &Palette,
) {
    let painter = ui.painter();
    let (font, labels, spacing) = (draw::small_font(ui), label_room(ui), tick_spacing(ui));
    painter.rect_stroke(rect, 0.0, (1.0, palette.axis), egui::StrokeKind::Outside);
    for (value, share) in ticks(across, rect.width() / spacing) {
        let below = pictures::position_of(rect, [share, 1.0]) + vec2(0.0, 3.0);
        let anchor = if share > 0.95 {
            Align2::RIGHT_TOP
        } else {
            Align2::CENTER_TOP
        };
        painter.text(
            below,
            anchor,
            format::value(value),
            font.clone(),
            palette.faint_ink,
        );
    }
    // Where a name would reach into the next map, the pointer reads it out.
    let fits = |length: f32, room: f32, beside: f32| length < room + beside;
    let galley = painter.layout_no_wrap(across.title.clone(), font.clone(), palette.ink);
    if fits(galley.size().x, rect.width(), labels.x) {
        let below = rect.center_bottom() + vec2(-0.5 * galley.size().x, 0.5 * labels.y);
        painter.galley(below, galley, palette.ink);
    }
    for (value, share) in ticks(up, rect.height() / spacing) {
        let left = pictures::position_of(rect, [0.0, 1.0 - share]) - vec2(4.0, 0.0);
        painter.text(
            left,
            Align2::RIGHT_CENTER,
            format::value(value),
            font.clone(),
            palette.faint_ink,
        );
    }
    let galley = painter.layout_no_wrap(up.title.clone(), font, palette.ink);
    if is_first && fits(galley.size().x, rect.height(), labels.y) {
        let corner = rect.left_center() + vec2(-labels.x, 0.5 * galley.size().x);
        let text = egui::epaint::TextShape::new(corner, galley, palette.ink);
        painter.add(text.with_angle(-std::f32::consts::FRAC_PI_2));
    }
}

/// At most about so many numbers beside an axis, with their shares.
fn ticks(axis: &Axis, most: f32) -> Vec<(f64, f64)> {
    let [low, high] = axis.range;
    let most = most.max(1.0) as usize;
    let all: Vec<f64> = if axis.is_logarithmic {
        let decades = low.log10().ceil() as i32..=high.log10().floor() as i32;
        decades.map(|decade| 10.0_f64.powi(decade)).collect()
    } else {
        let step = format::round_step((high - low) / most as f64);
        let places = (low / step).ceil() as i64..=(high / step).floor() as i64;
        places.map(|k| k as f64 * step).collect()
    };
    let share = |value: f64| {
        if axis.is_logarithmic {
            (value / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        }
    };
    let every = all.len().div_ceil(most).max(1);
    all.into_iter()
        .step_by(every)
        .map(|value| (value, share(value)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_few() {
        let angles = ticks(&(&map::Axis::ThetaI).into(), 4.3);
        assert!(angles.len() <= 5 && angles[0] == (0.0, 0.0), "{angles:?}");
        let decades = ticks(&(&map::Axis::GrazingI).into(), 4.3);
        assert!(
            decades
                .iter()
                .all(|(value, _)| (value.log10() - value.log10().round()).abs() < 1e-9)
        );
        assert!((3..=5).contains(&decades.len()), "{decades:?}");
    }
}
