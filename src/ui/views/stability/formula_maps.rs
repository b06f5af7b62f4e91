//! Formulas compared over both of their arguments: a map for each form in each precision.

use std::sync::Arc;

use egui::{Pos2, Rect, Role, Sense, Ui, WidgetInfo, vec2};

use super::super::context::ViewContext;
use super::formulas::outcome_in_words;
use super::plate::{self, PRECISIONS};
use crate::widgets::draw;
use crate::widgets::pictures;
use bxdf_lab::formula_comparison::{Argument, Comparison, Map, Outcome, along};
use bxdf_study::format;
use bxdf_study::views::stability::{ErrorUnit, Options};

/// The forms, from above.
const FORMS: [&str; 2] = ["textbook", "core"];

/// Draws the maps into a room of this height.
pub(super) fn show(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    comparison: &'static Comparison,
    height: f32,
) {
    let map = cx.answers.of_nothing(cx.options.map_request());
    let map = map.unwrap_or_default();
    let Some(second) = &comparison.second else {
        return;
    };
    let (scale, name) = plate::colors(cx.options.unit);
    let whole = ui.available_rect_before_wrap();
    let whole = Rect::from_min_size(whole.min, vec2(whole.width(), height));
    let room = pictures::color_bar(ui, whole, scale, name, cx.palette);
    let axis = |title: &str, range| plate::Axis {
        title: title.to_owned(),
        range,
        is_logarithmic: true,
    };
    let [x, y] = [
        axis(comparison.axis, comparison.range),
        axis(second.axis, second.range),
    ];
    let kinds = [0, 1]
        .into_iter()
        .flat_map(|form| [0, 1].map(|p| (form, p)));
    let rooms = plate::rooms(ui, room, FORMS.len() * PRECISIONS.len());
    cx.lacks(plate::lacking(&rooms));
    let mut note = None;
    for ((form, precision), rect) in kinds.zip(rooms.iter().copied()) {
        let of =
            |of: usize, names: [&'static str; 2]| names.into_iter().nth(of).unwrap_or_default();
        let title = format!("{}, {}", of(form, FORMS), of(precision, PRECISIONS));
        plate::title(ui, rect, &title, cx.palette);
        let unit = cx.options.unit;
        let id = ui.scope_id().with(("formula", form, precision));
        let paint = || scale.paint(&map.map(|outcome| value(outcome, (form, precision), unit)));
        let made_of = (vec![Arc::clone(&map) as _], Some(scale));
        let texture = cx.state.textures.get(ui, id, made_of, paint);
        texture.paint(ui.painter(), rect);
        plate::draw_violations(ui, cx.palette, rect, &map, |outcome| {
            value(outcome, (form, precision), ErrorUnit::Bound)
        });
        let is_first = rooms.iter().all(|other| other.left() >= rect.left());
        plate::draw_axes(ui, rect, [&x, &y], is_first, cx.palette);
        let response = ui.interact(rect, id, Sense::hover());
        let name = format!("Map of {title}");
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &name));
        let pointed = response.hover_pos();
        note = pointed.map(|pointer| (pointer, rect)).or(note);
    }
    if let Some((pointer, rect)) = note {
        let text = read_out((comparison, second), &map, (pointer, rect));
        draw::pointer_note(ui, pointer, ui.clip_rect(), &text, cx.palette);
    }
    ui.advance_cursor_after_rect(whole);
}

/// The error of a form in a precision, in this unit.
fn value(outcome: &Outcome, (form, precision): (usize, usize), unit: ErrorUnit) -> f64 {
    let errors = if form == 0 {
        outcome.textbook
    } else {
        outcome.stable
    };
    let [error, allowed] = [errors, outcome.allowed].map(|both| plate::of(both, precision));
    plate::in_unit(unit, precision, error, error / allowed)
}

/// What both forms are off where the pointer is.
fn read_out(
    (comparison, second): (&Comparison, &Argument),
    map: &Map,
    (pointer, rect): (Pos2, Rect),
) -> String {
    let [right, down] = pictures::share_of(rect, pointer);
    let [x, y] = [
        along(comparison.range, right),
        along(second.range, 1.0 - down),
    ];
    let pixel = [right * map.width as f64, down * map.height as f64];
    let outcome = map.at(pixel[0] as usize, pixel[1] as usize);
    let outcome = outcome.map(|outcome| outcome_in_words(comparison, x, outcome));
    format!(
        "{}: {}\n{}",
        second.axis,
        format::value(y),
        outcome.unwrap_or_default()
    )
}
