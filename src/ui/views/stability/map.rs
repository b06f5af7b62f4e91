//! The maps of f32 and f64, side by side.

use std::sync::Arc;

use egui::{Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo};

use super::super::context::{Lines, ViewContext};
use super::pair::go_to;
use super::plate::{self, PRECISIONS};
use crate::widgets::pictures::{self, ColorScale};
use crate::widgets::{draw, still};
use bxdf_lab::analysis::hemisphere::contour;
use bxdf_lab::stability::map::{Axis, Cell, Map, Request};
use bxdf_study::format;
use bxdf_study::memo::Memo;
use bxdf_study::memo::Same;
use bxdf_study::views::stability::{ErrorUnit, Options, place};

/// The decades of the condition number that have a line.
const KAPPAS: std::ops::RangeInclusive<i32> = 1..=12;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let request = cx.options.request(cx.session);
    let selected = cx.session.materials.selected();
    let map = cx.answers.ask(cx.session, selected, request.clone());
    let (scale, name) = plate::colors(cx.options.unit);
    let whole = ui.available_rect_before_wrap();
    let room = pictures::color_bar(ui, whole, scale, name, cx.palette);
    let mut note = None;
    let rooms = plate::rooms(ui, room, PRECISIONS.len());
    cx.lacks(plate::lacking(&rooms));
    for (index, (picture, title)) in rooms.into_iter().zip(PRECISIONS).enumerate() {
        plate::title(ui, picture, title, cx.palette);
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
    let [error, ratio] = [cell.errors, cell.ratios].map(|both| plate::of(both, precision));
    plate::in_unit(unit, precision, error, ratio)
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
    plate::draw_violations(ui, cx.palette, rect, map, |cell| {
        value(cell, precision, ErrorUnit::Bound)
    });
    let [x, y] = [&request.x, &request.y].map(plate::Axis::from);
    plate::draw_axes(ui, rect, [&x, &y], precision == 0, cx.palette);
    let (wo, wi) = cx.pair();
    let place = place(cx.session, wo, wi);
    let share = [request.x.share(&place), 1.0 - request.y.share(&place)];
    let at = pictures::position_of(rect, share);
    ui.painter().circle_stroke(at, 5.0, (1.5, cx.palette.ink));
    let response = ui.interact(rect, id, still::sense(ui, Sense::click()));
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
