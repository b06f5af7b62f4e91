//! The hemisphere: values in every direction of one side of the surface, as colours on a disc.

use std::sync::Arc;

use egui::{Rect, Response, Shape, Ui};

use super::context::ViewContext;
use super::{direction, half_vector, settings};
use crate::theme::Dash;
use crate::widgets::labels::Labels;
use crate::widgets::pictures::{self, Cell, ColorScale, Picture, ScaleKind};
use crate::widgets::{choice, deltas, draw};
use bxdf_lab::analysis::hemisphere::{Comparison, Map, Projection, Quantity, Range, contour};
use bxdf_lab::analysis::{Channel, HeldLobe, Hold, Subject};
use bxdf_study::cursor::Cursor;
use bxdf_study::format;
use bxdf_study::session::{EntryId, MaterialEntry, Session};
use bxdf_study::views::DECADES;
use bxdf_study::views::hemisphere::Options;

mod marks;
mod place;

use place::{label_room, mirrored};

/// The largest ratio that colours tell apart.
const LARGEST_RATIO: f64 = 100.0;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, |ui, cx| controls(ui, cx.session, cx.options));
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    let maps = maps(cx);
    let options = *cx.options;
    let range = maps
        .iter()
        .map(|(_, map)| map.range(Channel::Luminance))
        .reduce(Range::with)
        .filter(|range| range.is_some());
    // What is 0 everywhere has no colours.
    let is_ratio = options.comparison == Comparison::Ratio;
    let has_values = |range: &Range| is_ratio || range.highest > 0.0 || range.lowest < 0.0;
    let range = range.filter(has_values);
    let has_deltas = maps.iter().any(|(_, map)| !map.deltas.is_empty());
    if range.is_none() && !has_deltas {
        let side = if options.is_lower { "below" } else { "above" };
        let what = match options.comparison {
            Comparison::None => "No light leaves",
            Comparison::Difference | Comparison::Ratio => "Nothing differs",
        };
        draw::centred_note(ui, &format!("{what} on the side {side}"));
        return;
    }
    let mut room = ui.available_rect_before_wrap();
    let scale = range.map(|range| scale(range, options));
    if let Some(scale) = scale {
        room = pictures::color_bar(ui, room, scale, &options.quantity_name(), cx.palette);
    }
    let cells = pictures::cells(ui, room, maps.len(), 1.0);
    let (mut first, mut covered) = (None, Vec::new());
    for (cell, (entry, map)) in cells.into_iter().zip(&maps) {
        let disc = Cell {
            picture: cell.picture.shrink(label_room(ui)),
            ..cell
        };
        covered.extend(show_map(ui, cx, disc, (*entry, map), scale));
        first = first.or(Some(disc.picture));
    }
    // Above all pictures: a grip may reach into the next one.
    if let Some(picture) = first {
        drag_directions(ui, cx, picture, &covered);
        mark_half(ui, cx, picture);
    }
    ui.advance_cursor_after_rect(room);
}

fn controls(ui: &mut Ui, session: &mut Session, options: &mut Options) {
    ui.horizontal_wrapped(|ui| {
        let hint = "Which number: the value, with the cosine, the density of the sampler, or \
            what a sample weighs";
        choice::choice(
            ui,
            ("Show", hint),
            &mut options.quantity,
            &Quantity::ALL,
            Quantity::title,
        );
        let hint = "On its own, or compared with the reference";
        choice::choice(
            ui,
            ("Compared", hint),
            &mut options.comparison,
            &Comparison::ALL,
            Comparison::title,
        );
        if options.comparison != Comparison::None {
            super::context::reference_choice(ui, &mut session.materials);
        }
        let hint = "How directions are projected onto the disc";
        choice::choice(
            ui,
            ("Disc", hint),
            &mut options.projection,
            &Projection::ALL,
            Projection::title,
        );
        let hint = "A logarithmic scale: decades below the highest value";
        choice::switch_if(
            options.comparison == Comparison::None,
            ui,
            ("By decades", hint),
            &mut options.is_logarithmic,
        );
        let hint = "Lines of equal value";
        choice::switch(ui, ("Contours", hint), &mut options.has_contours);
        let hint = "The side below the surface, seen from above";
        choice::switch(ui, ("Lower half", hint), &mut options.is_lower);
    });
}

/// The maps of the materials shown; where they are compared, the reference is none of them, unless it is alone.
fn maps(cx: &mut ViewContext<'_, Options>) -> Vec<(EntryId, Arc<Map>)> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let reference = session.materials.reference();
    let is_compared = cx.options.comparison != Comparison::None;
    let request = cx.options.request();
    let is_only = session.materials.shown().count() == 1;
    let wanted = |entry: &&MaterialEntry| !is_compared || is_only || entry.id() != reference.id();
    let against = is_compared.then_some(reference);
    let map = |entry: &MaterialEntry| {
        (
            entry.id(),
            answers.compare(session, entry, against, request),
        )
    };
    session.materials.shown().filter(wanted).map(map).collect()
}

/// The colours of values that reach so far.
fn scale(range: Range, options: Options) -> ColorScale {
    let largest = range.highest.max(f64::MIN_POSITIVE);
    match options.comparison {
        Comparison::None if options.is_logarithmic => ColorScale {
            // Zeros lie at the low end, whatever it is.
            range: [
                range
                    .smallest_positive
                    .clamp(largest * 10_f64.powf(-DECADES), 0.5 * largest),
                largest,
            ],
            kind: ScaleKind::Logarithmic,
        },
        Comparison::None => ColorScale {
            range: [0.0, largest],
            kind: ScaleKind::Linear,
        },
        Comparison::Difference => {
            let end = range
                .highest
                .abs()
                .max(range.lowest.abs())
                .max(f64::MIN_POSITIVE);
            ColorScale {
                range: [-end, end],
                kind: ScaleKind::Diverging,
            }
        }
        Comparison::Ratio => {
            let end = largest
                .max(1.0 / range.smallest_positive)
                .clamp(1.01, LARGEST_RATIO);
            ColorScale {
                range: [1.0 / end, end],
                kind: ScaleKind::DivergingLogarithmic,
            }
        }
    }
}

/// Draws the map of a material. Returns what its labels cover.
fn show_map(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    cell: Cell,
    (entry, map): (EntryId, &Arc<Map>),
    scale: Option<ColorScale>,
) -> Vec<Rect> {
    let picture = Picture {
        entry,
        sources: vec![Arc::clone(map) as _],
        look: scale,
    };
    let textures = &mut cx.state.textures;
    let paint = || {
        scale
            .unwrap_or(NOTHING)
            .paint(&map.channel(Channel::Luminance))
    };
    let response = pictures::show(ui, textures, cell, picture, cx.session, cx.palette, paint);
    if let Some(scale) = scale.filter(|_| cx.options.has_contours) {
        draw_contours(ui, cx, cell.picture, (entry, map), scale);
    }
    marks::draw_grid(ui, cx.options.projection, cell.picture, cx.palette);
    marks::draw_directions(ui, cx, cell.picture);
    let covered = marks::draw_deltas(ui, cx, cell.picture, (entry, map));
    point(ui, cx, cell.picture, (entry, map), &response);
    covered
}

/// The colours where there is no value above 0.
const NOTHING: ColorScale = ColorScale {
    range: [0.0, 1.0],
    kind: ScaleKind::Linear,
};

fn draw_contours(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    rect: Rect,
    (entry, map): (EntryId, &Arc<Map>),
    scale: ColorScale,
) {
    let [low, high] = scale.range;
    let lines = cx
        .state
        .contours(ui.ctx(), (cx.view, entry), map, scale, |map| {
            let values = map.channel(Channel::Luminance);
            let levels = contour::levels(low, high, scale.kind == ScaleKind::Logarithmic);
            contour::lines(&values, &levels)
        });
    let painter = ui.painter_at(rect);
    let is_on_white =
        scale.kind == ScaleKind::Diverging || scale.kind == ScaleKind::DivergingLogarithmic;
    let color = if is_on_white {
        cx.palette.contour_on_white
    } else {
        cx.palette.contour
    };
    let stroke = (0.8, color);
    for line in lines.iter() {
        let points = line.iter().map(|place| pictures::position_of(rect, *place));
        painter.add(Shape::line(points.collect(), egui::Stroke::from(stroke)));
    }
}

/// The handles of light and viewer, where they are on the side shown, with their names clear of what is `covered`.
fn drag_directions(ui: &Ui, cx: &mut ViewContext<'_, Options>, rect: Rect, covered: &[Rect]) {
    let options = *cx.options;
    let mut labels = Labels::within(rect.expand(label_room(ui)));
    for room in covered
        .iter()
        .copied()
        .chain(marks::room_of_axes(rect, label_room(ui)))
    {
        labels.keep_off(room);
    }
    for one in cx.directions() {
        if (one.direction.z > 0.0) == options.is_lower {
            continue;
        }
        let at = pictures::position_of(rect, mirrored(options.projection.place(one.direction)));
        direction::name(ui, ui.painter(), cx, &mut labels, (&one, at, rect.center()));
        let name = match one.of {
            Hold::Light => "Light in the hemisphere",
            Hold::Viewer => "Viewer in the hemisphere",
        };
        let named = (name, ui.clip_rect(), direction::KEYS);
        let handle = direction::show(ui, cx, &one, at, named);
        let dragged_to = handle.dragged_to().and_then(|place| {
            let [x, y] = pictures::share_of(rect, place).map(|share| 2.0 * share - 1.0);
            let reach = x.hypot(-y).max(1.0);
            let place = [x / reach, -y / reach];
            options.projection.direction(place, !options.is_lower)
        });
        let turned = handle
            .steps()
            .map(|steps| direction::turned(one.direction, steps));
        if let Some(w) = dragged_to.or(turned) {
            cx.put(one.of, w);
            ui.ctx().request_repaint();
        }
    }
}

/// The half vector while words point at it, which is on the upper side.
fn mark_half(ui: &Ui, cx: &ViewContext<'_, Options>, rect: Rect) {
    let half = half_vector::pointed(ui, cx.session).filter(|_| !cx.options.is_lower);
    let tip = half.map(|half| {
        let place = mirrored(cx.options.projection.place(half));
        pictures::position_of(rect, place)
    });
    half_vector::mark(ui, [None, tip], Dash::Solid, cx.palette);
}

/// The direction under the pointer; the one pointed at in another view.
fn point(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    rect: Rect,
    (entry, map): (EntryId, &Arc<Map>),
    response: &Response,
) {
    let options = *cx.options;
    let Some(pointer) = response.hover_pos() else {
        if let Some((cursor, strength)) = &cx.mark
            && (cursor.direction.z > 0.0) != options.is_lower
        {
            let place = options.projection.place(cursor.direction);
            let at = pictures::position_of(rect, mirrored(place));
            draw::cross(ui.painter(), at, (cx.palette, *strength));
        }
        return;
    };
    let [x, y] = pictures::share_of(rect, pointer).map(|share| 2.0 * share - 1.0);
    let Some(direction) = options.projection.direction([x, -y], !options.is_lower) else {
        return;
    };
    let cursor = Cursor {
        material: entry,
        direction,
    };
    let mut text = read_out(cx, &cursor);
    for value in &map.deltas {
        let at = place::position(rect, value.direction, options.projection);
        if at.distance(pointer) <= deltas::BESIDE_RING {
            text = format!("{text}\n{}", marks::delta_label(value, options));
        }
    }
    draw::pointer_note(ui, pointer, ui.clip_rect(), &text, cx.palette);
    *cx.pointed = Some(cursor);
}

/// The value at the cursor, as the map has it.
fn read_out(cx: &mut ViewContext<'_, Options>, cursor: &Cursor) -> String {
    let session = &*cx.session;
    let (entry, reference) = (cursor.entry(session), session.materials.reference());
    let [surface, other] = [entry, reference].map(|entry| cx.answers.surface(session, entry));
    let lobe = |surface| HeldLobe::new(surface, session.hold, session.held());
    let subject = Subject {
        against: Some(lobe(&*other.bxdf)),
        ..Subject::of(lobe(&*surface.bxdf))
    };
    let values = cx.options.request().values(&subject, &[cursor.direction]);
    let value = values.and_then(|values| values.first().copied());
    let value = value.map_or(f64::NAN, |rgb| Channel::Luminance.of(rgb));
    let value = if value.is_finite() {
        format::value(value)
    } else {
        "not defined".to_owned()
    };
    format!(
        "{}\n{}  {value}",
        draw::cursor_place(cursor, session),
        cx.options.quantity_name()
    )
}
