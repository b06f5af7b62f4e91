//! The reflectance of an interface over the angle, beside Snell's triangle.

use egui::{Rect, RichText, Ui, UiBuilder, vec2};

use super::context::ViewContext;
use super::settings;
use crate::widgets::chart::Chart;
use crate::widgets::number::Number;
use crate::widgets::pictures;
use crate::widgets::{choice, draw};
use bxdf_lab::analysis::fresnel::{Fresnel, lobes};
use bxdf_study::format;
use bxdf_study::session::{EntryId, MaterialEntry};
use bxdf_study::views::fresnel::{OWN_K, OWN_N, Options, Over, SeenFrom, is_own, subjects};

mod curves;
mod rays;
mod snell;
mod words;

/// Smaller charts have room for their curves only, in points.
const ROOM_FOR_WORDS: egui::Vec2 = vec2(230.0, 150.0);

/// Smaller charts have no room for the names of the angles of each channel, in points.
const ROOM_FOR_MARKS: egui::Vec2 = vec2(360.0, 240.0);

/// From this size on there is room for the triangle beside the chart, in points.
const ROOM_FOR_SNELL: egui::Vec2 = vec2(520.0, 260.0);

/// The part of the width that the triangle has, and its least and most, in points.
const SNELL_WIDTH: (f32, [f32; 2]) = (0.3, [190.0, 320.0]);

/// Between the chart and the triangle, in points.
const GAP: f32 = 10.0;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, controls);
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    if is_own(cx.session) {
        own_interface(ui, cx);
    }
    let shown: Vec<(EntryId, String)> = subjects(cx.session)
        .into_iter()
        .map(|(entry, title)| (entry.id(), title))
        .collect();
    let room = ui.available_rect_before_wrap();
    let cells = pictures::cells_of_charts(ui, room, shown.len());
    for (cell, (entry, _)) in cells.into_iter().zip(&shown) {
        let name = pictures::title(ui, cell, *entry, cx.session, cx.palette);
        show_material(ui, cx, (*entry, &name), cell.picture);
    }
    ui.advance_cursor_after_rect(room);
}

/// The chart of a material, and the triangle where there is room.
fn show_material(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    (id, name): (EntryId, &str),
    rect: Rect,
) {
    let Some(entry) = cx.session.materials.get(id) else {
        return;
    };
    let request = cx.options.request();
    let fresnel = cx.answers.ask(cx.session, entry, request);
    let look = curves::Look {
        slot: entry.slot(),
        palette: cx.palette,
        held: cx.palette.held(cx.session.hold),
        held_name: cx.session.held_name(),
        shown: cx.options.curves,
    };
    let is_over_wavelength = cx.options.is_over_wavelength(&entry.material);
    let mut chart = if is_over_wavelength {
        let query = cx.options.over_wavelength();
        let all = cx.answers.ask(cx.session, entry, query);
        curves::over_wavelength(name, &all, &look)
    } else {
        curves::over_angle(name, &fresnel, &look)
    };
    let has_snell = rect.size().min(ROOM_FOR_SNELL) == ROOM_FOR_SNELL;
    let (mut plot, mut beside) = (rect, rect);
    if has_snell {
        let (share, [least, most]) = SNELL_WIDTH;
        let width = (share * rect.width()).clamp(least, most);
        beside.min.x = rect.right() - width;
        plot.max.x = beside.min.x - GAP;
    } else if rect.size().min(ROOM_FOR_WORDS) != ROOM_FOR_WORDS && !cx.state.is_figure() {
        chart.leave_out_words();
    } else if fresnel.curves.len() > 1 && rect.size().min(ROOM_FOR_MARKS) != ROOM_FOR_MARKS {
        chart.marks.iter_mut().for_each(|mark| mark.name.clear());
    }
    if has_snell {
        ui.scope_builder(UiBuilder::new().id_salt(id).max_rect(beside), |ui| {
            snell::show(ui, &fresnel, &look);
        });
    }
    ui.scope_builder(UiBuilder::new().max_rect(plot), |ui| {
        ui.push_id(id, |ui| {
            show_chart(ui, cx, &chart, (&fresnel, is_over_wavelength));
        });
    });
}

/// The chart, with what the pointer does in it: a click holds the angle there.
fn show_chart(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    chart: &Chart,
    (fresnel, is_over_wavelength): (&Fresnel, bool),
) {
    let shown = chart.show(ui, None, cx.palette);
    cx.lacks(shown.lacking());
    let [low, high] = chart.x.range;
    let pointed = chart
        .pointed(&shown)
        .filter(|[x, _]| (low..=high).contains(x));
    let Some([x, _]) = pointed else {
        if !is_over_wavelength {
            chart.mark(ui, &shown, fresnel.theta_deg, (cx.palette, 1.0));
        }
        return;
    };
    let heading = if is_over_wavelength {
        format!("{x:.0} nm")
    } else {
        format!("θ {}", format::degrees(x))
    };
    chart.read_out(ui, &shown, x, &heading, cx.palette);
    if shown.response.clicked() && !is_over_wavelength {
        let theta = (10.0 * x).round() / 10.0;
        let is_below = cx.session.theta_deg > 90.0;
        cx.session
            .set_theta_deg(if is_below { 180.0 - theta } else { theta });
    }
}

fn controls(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    ui.horizontal_wrapped(|ui| {
        choose_lobe(ui, cx);
        let shown = || cx.session.materials.shown();
        let request = cx.options.request();
        let is_clear = |entry: &MaterialEntry| {
            !cx.answers.ask(cx.session, entry, request).is_absorbing
        };
        // Out of a metal no light comes.
        if shown().any(is_clear) {
            let hint = "The side that the light comes from: that of the fixed direction, or always the same";
            let titles = SeenFrom::title;
            let value = &mut cx.options.seen_from;
            choice::choice(ui, ("From", hint), value, SeenFrom::ALL, titles);
        }
        if shown().any(|entry| cx.options.has_wavelengths(&entry.material)) {
            let hint = "Over the angle, or over the wavelength by the table of the metal at the angle that is fixed";
            let value = &mut cx.options.over;
            choice::choice(ui, ("Over", hint), value, Over::ALL, Over::title);
        }
        let curves = &mut cx.options.curves;
        for (name, hint, value) in [
            ("s", "Light whose electric field is perpendicular to the plane of incidence", &mut curves.s),
            ("p", "Light whose electric field lies in the plane of incidence", &mut curves.p),
            ("Mean", "Unpolarised light: the mean of s and p", &mut curves.mean),
            ("Schlick", "F0 + (1 - F0)(1 - cos θ)⁵; from the denser side by the angle beyond the interface", &mut curves.schlick),
            ("Lazanyi", "Schlick's approximation with a term that makes it exact at 82°", &mut curves.lazanyi),
        ] {
            let width = choice::small_switch_width(ui, name);
            choice::keep_together(ui, width);
            choice::switch(ui, (name, hint), value);
        }
    });
}

/// The choice of the lobe, of a material that has several with an interface.
fn choose_lobe(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let session = &*cx.session;
    let names = |entry: &MaterialEntry| -> Vec<String> {
        let titles = lobes(&entry.material).map(|lobe| lobe.model().title);
        let titles = titles.enumerate();
        titles
            .map(|(place, title)| format!("{}: {title}", place + 1))
            .collect()
    };
    let selected = session.materials.selected();
    let first = Some(selected).filter(|entry| session.materials.is_shown(entry));
    let all = first.into_iter().chain(session.materials.shown());
    let Some(names) = all.map(names).find(|names| names.len() > 1) else {
        return;
    };
    let value = &mut cx.options.lobe;
    let place = (*value).min(names.len() - 1);
    let chosen = names.get(place).cloned().unwrap_or_default();
    let hint = "The lobe whose interface is shown; of a material with fewer the last";
    choice::named_combo(ui, ("Lobe", "Lobe", hint), &chosen, |ui| {
        for (place, name) in names.iter().enumerate() {
            ui.selectable_value(value, place, name);
        }
    });
}

/// What is said where no material has an interface, and the index that is taken instead.
fn own_interface(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let has_deltas_only = cx
        .session
        .materials
        .shown()
        .all(|entry| entry.material.is_delta_only());
    let of = if has_deltas_only {
        "mirror"
    } else {
        "material"
    };
    let line =
        format!("No {of} shown has an index of refraction: this interface is the view's own");
    if cx.state.is_picture {
        let [n, k] = [cx.options.own_n, cx.options.own_k].map(format::value);
        ui.label(
            RichText::new(format!("{line}, n {n}, k {k}"))
                .small()
                .weak(),
        );
        return;
    }
    ui.label(RichText::new(line).small().weak());
    ui.horizontal_wrapped(|ui| {
        let rows = [
            (
                "Own n",
                "n",
                "Index of refraction below the surface over the one above",
                &OWN_N,
                &mut cx.options.own_n,
            ),
            (
                "Own k",
                "k",
                "Absorption index: above 0 it is a metal",
                &OWN_K,
                &mut cx.options.own_k,
            ),
        ];
        for (name, label, hint, spec, value) in rows {
            Number::new(name, *spec)
                .slider(ui, label, value)
                .on_hover_text(hint)
                .explain(ui);
        }
    });
}
