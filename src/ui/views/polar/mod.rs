//! The polar plot: a section of the lobe through a plane that contains n.

use egui::{IdSalt, Pos2, Sense, Ui, UiBuilder, vec2};
use egui_plot::{Plot, PlotBounds, PlotMemory, PlotPoint, PlotTransform};

use glam::DVec3;

use super::context::ViewContext;
use super::{half_vector, settings, side_by_side};
use crate::theme::Dash;
use crate::widgets::legend::Swatch;
use crate::widgets::{draw, reset, still};
use bxdf_lab::analysis::reflectance::has_flux;
use bxdf_lab::analysis::{RadialScale, deltas, polar};
use bxdf_study::cursor::Cursor;
use bxdf_study::session::MaterialEntry;
use bxdf_study::views::Arrangement;
use bxdf_study::views::polar::Options;
use canvas::{Canvas, Plotted};
use radial::{Radial, Rings, at};

mod canvas;
mod handles;
mod labels;
mod names;
mod radial;
mod scales;

/// The room beside the plot's unit circle that labels need, and above it.
const SIDE_ROOM: f64 = 0.4;
const TOP_ROOM: f64 = 0.27;
/// Below the horizon, where nothing is drawn but the labels of the scale.
const LOWER_ROOM: f64 = 0.16;
/// The same in points, where that is more.
const LOWER_POINTS: f64 = 18.0;
/// Beyond this radius the pointer reads nothing.
const HOVER_RADIUS: f64 = 1.12;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let mut plotted = plotted(cx);
    let shared = scales::scale_all(ui, cx, &mut plotted);
    settings::row(ui, cx, |ui, cx| {
        let Options {
            mut scale,
            mut arrangement,
            ..
        } = *cx.options;
        settings::scale(ui, cx, &mut scale, shared);
        settings::arrangement(ui, cx, &mut arrangement);
        (cx.options.scale, cx.options.arrangement) = (scale, arrangement);
        settings::cosine(ui, cx);
        settings::section(ui, cx);
        settings::curves(ui, cx);
    });
    if cx.options.arrangement == Arrangement::Overlaid || plotted.len() < 2 {
        cx.legend(ui, Swatch::Line);
        let room = ui.available_rect_before_wrap();
        show_plot(ui, cx, &plotted, shared);
        scales::offer_peaks(ui, cx, &plotted, room);
        return;
    }
    // In the order of the list: the selected one is last for the sake of overlaid curves alone.
    plotted.sort_by_key(|one| one.slot);
    let room = ui.available_rect_before_wrap();
    let aspect = aspect(cx.state.shows_lower_half(cx.session));
    let is_own = cx.options.scale.is_each_to_peak;
    let named = plotted
        .iter()
        .map(|one| (one.entry, is_own.then_some(one.radial.full)));
    let named: Vec<_> = named.collect();
    let cells = side_by_side::cells(ui, cx, (room, aspect), &named);
    for (picture, one) in cells.into_iter().zip(plotted) {
        let scope = UiBuilder::new().max_rect(picture).id_salt(one.entry);
        ui.scope_builder(scope, |ui| show_plot(ui, cx, &[one], shared));
    }
    ui.advance_cursor_after_rect(room);
}

/// The rings behind curves. `shared`: the value at the unit circle, where it is that of all.
fn rings(cx: &ViewContext<'_, Options>, plotted: &[Plotted], shared: Option<f64>) -> Rings {
    let lengths = cx.options.scale.lengths;
    let quantity = if cx.session.with_cosine {
        "f cos θ"
    } else {
        "f"
    };
    let channels = cx.session.shown_curves().channels();
    let peaks = plotted
        .iter()
        .map(|one| radial::peak(&one.section, channels));
    let peak = peaks.fold(0.0, f64::max);
    if peak <= 0.0 {
        let has_deltas = plotted.iter().any(|one| !one.section.stems.is_empty());
        // Deltas alone: the rings count shares of the light. Nothing at all: any scale will do.
        let quantity = if has_deltas {
            "share of the flux".to_owned()
        } else {
            format!("{quantity} in 1/sr")
        };
        return Rings::of_shares(RadialScale::Linear, &quantity);
    }
    match (shared, plotted) {
        (Some(full), _) => Rings::of(Radial::new(lengths, full), &format!("{quantity} in 1/sr")),
        (None, [one]) => Rings::of(one.radial, &format!("{quantity} in 1/sr")),
        (None, _) => Rings::of_shares(lengths, &format!("{quantity} over its own peak")),
    }
}

/// The plot of one material or several, in the room that is left.
fn show_plot(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    plotted: &[Plotted],
    shared: Option<f64>,
) {
    let rings = rings(cx, plotted, shared);
    let has_lower = cx.state.shows_lower_half(cx.session);
    let window = window(ui.available_size(), has_lower, draw::label_scale(ui));
    let salt = ("polar", has_lower);
    let id = ui.make_persistent_id(IdSalt::new(salt));
    let is_new = PlotMemory::load(ui.ctx(), id).is_none();
    let plot = Plot::new(salt)
        .id(id)
        .data_aspect(1.0)
        .show_axes(false)
        .show_grid(false)
        .show_x(false)
        .show_y(false)
        .show_crosshair(false)
        .show_background(false)
        .allow_boxed_zoom(false)
        .allow_scroll(false)
        .sense(still::sense(ui, Sense::click_and_drag()))
        .set_margin_fraction(vec2(0.0, 0.0))
        .default_x_bounds(window.min()[0], window.max()[0])
        .default_y_bounds(window.min()[1], window.max()[1])
        .label_formatter(|_| None);
    let (palette, section) = (*cx.palette, cx.options.own_section_deg.of(cx.session));
    let directions = cx.directions();
    let response = plot.show(ui, |plot_ui| {
        if is_new {
            // The window follows the room until it is panned or zoomed; what is panned stays so in any room.
            plot_ui.set_auto_bounds(true);
        }
        draw::zoom_by_scrolling(plot_ui);
        canvas::draw_grid(plot_ui, &rings, &palette, has_lower);
        for one in plotted {
            canvas::draw_curves(plot_ui, cx.session, one, &palette);
        }
        canvas::draw_directions(plot_ui, cx.session, &directions, section, &palette);
    });
    let canvas = Canvas {
        ui,
        transform: &response.transform,
    };
    // Of several only the selected one is filled: tints laid over each other are no colour of any.
    let is_only = plotted.len() == 1;
    for one in plotted.iter().filter(|one| one.is_selected || is_only) {
        canvas.fill(cx.session, one, &palette);
    }
    let mut taken = Vec::new();
    for one in plotted {
        canvas.draw_arrows(one, &mut taken, &palette);
    }
    taken.extend(canvas.handles(&directions, section));
    // A name is worth more than one of many numbers.
    taken.extend(canvas.name_directions(cx.session, &directions, section, &palette));
    let numbers = canvas.label_grid(&rings, &taken, &palette, has_lower);
    taken.extend(numbers);
    canvas.name_materials(cx, plotted, taken);
    canvas.name_curves(cx.session, &palette);
    if let Some(note) = note(cx, plotted) {
        canvas.note(note, &palette);
    }
    let transform = response.transform;
    if handles::drag_all(ui, cx, &transform) {
        cx.state.keep_arrangement(has_lower);
    } else {
        read_out(ui, cx, &response.response, &transform, plotted, has_lower);
    }
    if !response.response.hovered() {
        mark_cursor(ui, cx, &transform);
    }
    if let Some(half) = half_vector::pointed(ui, cx.session) {
        let (ends, dash) = way_of(half, cx, &transform);
        half_vector::mark(ui, ends.map(Some), dash, &palette);
    }
    let memory = PlotMemory::load(ui.ctx(), id);
    let is_moved = memory.is_some_and(|memory| !memory.auto_bounds.all());
    reset::of_plot(ui, id, *transform.frame(), is_moved);
}

/// The direction pointed at in another view.
fn mark_cursor(ui: &Ui, cx: &ViewContext<'_, Options>, transform: &PlotTransform) {
    let Some((cursor, strength)) = &cx.mark else {
        return;
    };
    let (ends, dash) = way_of(cursor.direction, cx, transform);
    let look = (cx.palette, *strength);
    draw::cursor_mark(&ui.painter_at(*transform.frame()), ends, dash, look);
}

/// The line to a direction at its theta: dashed where it lies outside the section.
fn way_of(w: DVec3, cx: &ViewContext<'_, Options>, transform: &PlotTransform) -> ([Pos2; 2], Dash) {
    let azimuth = cx.options.own_section_deg.of(cx.session).phi();
    let angle = polar::signed_angle(w, azimuth);
    let ends = [[0.0, 0.0], at(1.0, angle)]
        .map(|[x, y]| transform.position_from_point(&PlotPoint::new(x, y)));
    if deltas::is_in_section(w, azimuth) {
        (ends, Dash::Solid)
    } else {
        (ends, Dash::Dashed)
    }
}

/// What the plot shows, the selected material last, so that it lies over the others.
fn plotted(cx: &mut ViewContext<'_, Options>) -> Vec<Plotted> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let selected = session.materials.selected().id();
    let request = cx.options.request(session);
    let plot = |entry: &MaterialEntry| Plotted {
        entry: entry.id(),
        slot: entry.slot(),
        is_selected: entry.id() == selected,
        section: answers.ask(session, entry, request),
        radial: Radial::new(request.scale, 0.0),
    };
    let mut plotted: Vec<Plotted> = session.materials.shown().map(plot).collect();
    plotted.sort_by_key(|one| one.is_selected);
    plotted
}

/// Why there is less to see than one might expect.
fn note(cx: &ViewContext<'_, Options>, plotted: &[Plotted]) -> Option<&'static str> {
    let session = &*cx.session;
    let is_empty = |one: &Plotted| one.section.upper.is_empty() && one.section.lower.is_empty();
    let mut stems = plotted.iter().flat_map(|one| &one.section.stems);
    let is_empty = plotted.iter().all(is_empty) && stems.clone().next().is_none();
    let has_outside = stems.any(|stem| !stem.is_inside);
    if plotted.is_empty() {
        Some("Every material is hidden")
    } else if is_empty && has_flux(session.held()) {
        Some("No light leaves: total internal reflection, or all is absorbed")
    } else if has_outside || !cx.options.own_section_deg.of(session).holds_held {
        Some("Dashed: outside this section, drawn at its θ")
    } else if session.curves != session.shown_curves() {
        Some("Luminance: R, G and B are drawn where one material is shown")
    } else {
        None
    }
}

/// Width over height of the part of the plane that holds the circle (or its upper half) with its labels.
fn aspect(has_lower: bool) -> f32 {
    let high = 1.0 + TOP_ROOM;
    let low = if has_lower { high } else { 1.4 * LOWER_ROOM };
    (2.0 * (1.0 + SIDE_ROOM) / (high + low)) as f32
}

/// The smallest part of the plot's plane of this shape that holds the circle (or its upper half) with its labels.
fn window(size: egui::Vec2, has_lower: bool, label_scale: f32) -> PlotBounds {
    // In a large plot labels that are twice as large take less than twice the room.
    let room = f64::from(0.5 + 0.5 * label_scale);
    let (right, top) = (1.0 + room * SIDE_ROOM, 1.0 + room * TOP_ROOM);
    let (width, height) = (f64::from(size.x.max(1.0)), f64::from(size.y.max(1.0)));
    // The numbers below the horizon are as high in a small plot as in a large one.
    let numbers = f64::from(label_scale) * LOWER_POINTS * 2.0 * right / width;
    let bottom = if has_lower {
        -top
    } else {
        -LOWER_ROOM.max(numbers)
    };
    let per_point = (2.0 * right / width).max((top - bottom) / height);
    let (half_width, half_height) = (0.5 * width * per_point, 0.5 * height * per_point);
    let middle = f64::midpoint(top, bottom);
    PlotBounds::from_min_max(
        [-half_width, middle - half_height],
        [half_width, middle + half_height],
    )
}

/// The direction and value under the pointer.
fn read_out(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    plot: &egui::Response,
    transform: &PlotTransform,
    plotted: &[Plotted],
    has_lower: bool,
) {
    let Some(pointer) = plot.hover_pos() else {
        return;
    };
    let place = transform.value_from_position(pointer);
    let is_inside = place.x.hypot(place.y) < HOVER_RADIUS && (has_lower || place.y >= 0.0);
    if !is_inside {
        return;
    }
    let angle = place.x.atan2(place.y);
    let materials = &cx.session.materials;
    let selected = materials.selected().id();
    let of_selected = plotted.iter().find(|one| one.is_selected);
    let Some(one) = of_selected.or(plotted.first()) else {
        return;
    };
    // Where the selected one is hidden, its value is read all the same.
    let read = if plotted.len() == 1 {
        one.entry
    } else {
        selected
    };
    let Some(entry) = materials.get(read) else {
        return;
    };
    let (slot, radial) = (entry.slot(), one.radial);
    let cursor = Cursor {
        material: entry.id(),
        direction: polar::direction(angle, cx.options.request(cx.session).phi),
    };
    let value = cursor.value(cx.session, cx.answers);
    let painter = ui.painter_at(*transform.frame());
    let position = |radius: f64| {
        let [x, y] = at(radius, angle);
        transform.position_from_point(&PlotPoint::new(x, y))
    };
    painter.line_segment([position(0.0), position(1.0)], (1.0, cx.palette.faint_ink));
    for channel in cx.session.shown_curves().channels() {
        let tip = position(radial.radius(channel.of(value)).min(1.0));
        painter.circle(
            tip,
            4.0,
            cx.palette.channel(*channel, slot),
            (1.5, cx.palette.background),
        );
    }
    draw::pointer_note(
        ui,
        pointer,
        *transform.frame(),
        &draw::cursor_text(&cursor, cx.session, value),
        cx.palette,
    );
    *cx.pointed = Some(cursor);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_of_window_holds_the_circle() {
        for size in [vec2(480.0, 360.0), vec2(300.0, 700.0), vec2(900.0, 200.0)] {
            for has_lower in [false, true] {
                let bounds = window(size, has_lower, 1.0);
                let ([left, low], [right, high]) = (bounds.min(), bounds.max());
                assert!(
                    left <= -1.399 && right >= 1.399 && high >= 1.269,
                    "{size:?}"
                );
                assert!(low <= if has_lower { -1.269 } else { -0.159 }, "{size:?}");
                let shape = (right - left) / (high - low);
                assert!(
                    (shape / f64::from(size.x / size.y) - 1.0).abs() < 1e-6,
                    "circles are round"
                );
            }
        }
    }
}
