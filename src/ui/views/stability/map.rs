//! The maps of f32 and f64, side by side.

use std::sync::Arc;

use egui::{Align2, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, vec2};
use glam::DVec3;

use super::super::context::{Lines, ViewContext};
use super::pair::go_to;
use crate::theme::Palette;
use crate::widgets::draw;
use crate::widgets::pictures::{self, ColorScale, ScaleKind};
use bxdf::math::Real as _;
use bxdf_lab::analysis::hemisphere::contour;
use bxdf_lab::stability::map::{Axis, Cell, Map, Request};
use bxdf_study::format;
use bxdf_study::memo::Memo;
use bxdf_study::memo::Same;
use bxdf_study::views::stability::{ErrorUnit, Options, place};

/// The precisions, from the left.
const PRECISIONS: [&str; 2] = ["f32", "f64"];

/// The errors that colours tell apart: below the rounding of f64, and all digits lost.
const ERRORS: [f64; 2] = [1e-17, 1.0];

/// The shares of the bound that colours tell apart.
const RATIOS: [f64; 2] = [1e-3, 10.0];

/// The numbers of roundings that colours tell apart.
const ROUNDINGS: [f64; 2] = [0.1, 1e3];

/// One rounding in each precision.
const UNIT_ROUNDOFFS: [f64; 2] = [f32::UNIT_ROUNDOFF, f64::UNIT_ROUNDOFF];

/// The decades of the condition number that have a line.
const KAPPAS: std::ops::RangeInclusive<i32> = 1..=12;

/// Room for the names and numbers of the axes, in points: at the left and below.
const LABELS: egui::Vec2 = vec2(54.0, 30.0);

/// Room between numbers of an axis, in points.
const TICK_SPACING: f32 = 46.0;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let request = cx.options.request(cx.session);
    let selected = cx.session.materials.selected();
    let map = cx.answers.ask(cx.session, selected, request.clone());
    let (range, name) = match cx.options.unit {
        ErrorUnit::Roundings => (ROUNDINGS, "error, in u"),
        ErrorUnit::Relative => (ERRORS, "relative error"),
        ErrorUnit::Bound => (RATIOS, "error over bound"),
    };
    let kind = ScaleKind::Logarithmic;
    let scale = ColorScale { range, kind };
    let whole = ui.available_rect_before_wrap();
    let room = pictures::color_bar(ui, whole, scale, name, cx.palette);
    let cells = pictures::cells(room, PRECISIONS.len(), 1.0);
    let mut note = None;
    for (index, cell) in cells.into_iter().enumerate() {
        let mut picture = cell.picture;
        picture.min.x += LABELS.x;
        picture.max.y -= LABELS.y;
        let side = picture.width().min(picture.height());
        let picture = Rect::from_min_size(picture.min, vec2(side, side));
        let title = PRECISIONS.get(index).copied().unwrap_or_default();
        let place = picture.left_top() - vec2(0.0, 3.0);
        let font = draw::body_font(ui);
        ui.painter()
            .text(place, Align2::LEFT_BOTTOM, title, font, cx.palette.ink);
        note = show_map(ui, cx, picture, (&request, &map, index), scale).or(note);
    }
    // Over both maps.
    if let Some((pointer, text)) = note {
        draw::pointer_note(ui, pointer, ui.clip_rect(), &text, cx.palette);
    }
    ui.advance_cursor_after_rect(whole);
}

/// The error in a precision, in this unit.
fn value(cell: &Cell, precision: usize, unit: ErrorUnit) -> f64 {
    let of = |both: [f64; 2]| both.into_iter().nth(precision).unwrap_or(f64::NAN);
    match unit {
        ErrorUnit::Roundings => of(cell.errors) / of(UNIT_ROUNDOFFS),
        ErrorUnit::Relative => of(cell.errors),
        ErrorUnit::Bound => of(cell.ratios),
    }
}

/// Draws the map of a precision. Returns what is to be said where the pointer is.
fn show_map(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    rect: Rect,
    (request, map, precision): (&Request, &Arc<Map>, usize),
    scale: ColorScale,
) -> Option<(Pos2, String)> {
    let unit = cx.options.unit;
    let id = ui.scope_id().with(("stability", precision));
    let paint = || scale.paint(&map.map(|cell| value(cell, precision, unit)));
    let made_of = (vec![Arc::clone(map) as _], Some(scale));
    let texture = cx.state.textures.get(ui, id, made_of, paint);
    texture.paint(ui.painter(), rect);
    if cx.options.has_contours {
        draw_kappas(ui, cx, rect, map);
    }
    draw_violations(ui, cx.palette, rect, map, precision);
    draw_axes(ui, rect, request, precision == 0, cx.palette);
    let free = cx
        .cursor
        .map_or_else(|| mirror_of(cx.session.held()), |cursor| cursor.direction);
    let place = place(cx.session, cx.session.held(), free);
    let share = [request.x.share(&place), 1.0 - request.y.share(&place)];
    let at = pictures::position_of(rect, share);
    ui.painter().circle_stroke(at, 5.0, (1.5, cx.palette.ink));
    let response = ui.interact(rect, id, Sense::click());
    let name = format!(
        "Map of {}",
        PRECISIONS.get(precision).copied().unwrap_or_default()
    );
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &name));
    let pointer = response.hover_pos()?;
    let [x, y] = pictures::share_of(rect, pointer);
    let pixel = [x * map.width as f64, y * map.height as f64];
    let cell = map.at(pixel[0] as usize, pixel[1] as usize);
    if response.clicked()
        && let Some(place) = request.place_at([x, 1.0 - y])
    {
        let (wo, wi) = place.pair();
        cx.session.materials.selected_mut().material = place.material;
        go_to(cx, wo, wi);
    }
    Some((pointer, read_out(request, [x, 1.0 - y], cell)))
}

fn mirror_of(w: DVec3) -> DVec3 {
    DVec3::new(-w.x, -w.y, w.z)
}

/// Lines of equal condition number.
fn draw_kappas(ui: &Ui, cx: &mut ViewContext<'_, Options>, rect: Rect, map: &Arc<Map>) {
    let kappas: &mut Memo<Same<Map>, Lines> = cx.state.own(cx.view);
    let lines = kappas.get(Same(Arc::clone(map)), || {
        let levels: Vec<f64> = KAPPAS.map(f64::from).collect();
        contour::lines(&map.map(|cell| cell.kappa.max(1e-3).log10()), &levels)
    });
    let painter = ui.painter_at(rect);
    let stroke = Stroke::new(0.8, cx.palette.contour);
    for line in lines.iter() {
        let points = line.iter().map(|place| pictures::position_of(rect, *place));
        painter.add(Shape::line(points.collect(), stroke));
    }
}

/// A square where the error is larger than rounding explains, or a result is no number.
fn draw_violations(ui: &Ui, palette: &Palette, rect: Rect, map: &Map, precision: usize) {
    let painter = ui.painter_at(rect);
    let size = rect.size() / vec2(map.width.max(1) as f32, map.height.max(1) as f32);
    for (index, cell) in map.pixels.iter().enumerate() {
        if value(cell, precision, ErrorUnit::Bound) > 1.0 {
            let (column, row) = (index % map.width, index / map.width);
            let corner = rect.min + vec2(column as f32, row as f32) * size;
            painter.rect_filled(Rect::from_min_size(corner, size), 0.0, palette.warning);
        }
    }
}

fn draw_axes(ui: &Ui, rect: Rect, request: &Request, is_first: bool, palette: &Palette) {
    let painter = ui.painter();
    let font = draw::small_font(ui);
    painter.rect_stroke(rect, 0.0, (1.0, palette.axis), egui::StrokeKind::Outside);
    for (value, share) in ticks(&request.x, rect.width()) {
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
    let below = rect.center_bottom() + vec2(0.0, 15.0);
    painter.text(
        below,
        Align2::CENTER_TOP,
        request.x.title(),
        font.clone(),
        palette.ink,
    );
    for (value, share) in ticks(&request.y, rect.height()) {
        let left = pictures::position_of(rect, [0.0, 1.0 - share]) - vec2(4.0, 0.0);
        painter.text(
            left,
            Align2::RIGHT_CENTER,
            format::value(value),
            font.clone(),
            palette.faint_ink,
        );
    }
    if is_first {
        let galley = painter.layout_no_wrap(request.y.title(), font, palette.ink);
        let corner = rect.left_center() + vec2(-LABELS.x, 0.5 * galley.size().x);
        let text = egui::epaint::TextShape::new(corner, galley, palette.ink);
        painter.add(text.with_angle(-std::f32::consts::FRAC_PI_2));
    }
}

/// Numbers beside an axis of this length in points, with their shares.
fn ticks(axis: &Axis, length: f32) -> Vec<(f64, f64)> {
    let [low, high] = axis.range();
    let most = (length / TICK_SPACING).max(1.0) as usize;
    let all: Vec<f64> = if axis.is_logarithmic() {
        let decades = low.log10().ceil() as i32..=high.log10().floor() as i32;
        decades.map(|decade| 10.0_f64.powi(decade)).collect()
    } else {
        let step = format::round_step((high - low) / most as f64);
        let places = (low / step).ceil() as i64..=(high / step).floor() as i64;
        places.map(|k| k as f64 * step).collect()
    };
    let share = |value: f64| {
        if axis.is_logarithmic() {
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

fn read_out(request: &Request, [x, y]: [f64; 2], cell: Option<&Cell>) -> String {
    let axis =
        |axis: &Axis, share: f64| format!("{}: {}", axis.title(), format::value(axis.value(share)));
    let place = format!("{}\n{}", axis(&request.x, x), axis(&request.y, y));
    let Some(cell) = cell.filter(|cell| cell.kappa.is_finite()) else {
        return format!("{place}\nno value here");
    };
    let line = |precision: usize| {
        let name = PRECISIONS.get(precision).copied().unwrap_or_default();
        let [error, roundings, ratio] =
            [ErrorUnit::Relative, ErrorUnit::Roundings, ErrorUnit::Bound]
                .map(|unit| format::value(value(cell, precision, unit)));
        format!("{name}: error {error} ({roundings} u), {ratio} of its bound")
    };
    format!(
        "{place}\n{}\n{}\nκ {}",
        line(0),
        line(1),
        format::value(cell.kappa)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_few() {
        let angles = ticks(&Axis::ThetaI, 200.0);
        assert!(angles.len() <= 5 && angles[0] == (0.0, 0.0), "{angles:?}");
        let decades = ticks(&Axis::GrazingI, 200.0);
        assert!(
            decades
                .iter()
                .all(|(value, _)| (value.log10() - value.log10().round()).abs() < 1e-9)
        );
        assert!((3..=5).contains(&decades.len()), "{decades:?}");
    }
}
