//! The trade-off: error over cost of every choice, and the cheapest that is good enough.

mod advice;
mod chosen;
mod plot;

use chosen::{Chosen, look};

use egui::{ProgressBar, RichText, Ui};

use super::context::ViewContext;
use crate::theme;
use crate::widgets::number::Number;
use crate::widgets::{choice, draw};
use bxdf_lab::tradeoff::{FAMILIES, Report, Request};
use bxdf_study::answers::Ordered;
use bxdf_study::jobs::Part;
use bxdf_study::views::tradeoff::{Options, TOLERANCE, request};

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let is_wanted = cx.options.is_immediate && !ui.ctx().egui_is_using_pointer();
    if is_wanted && !is_measured(cx) {
        start(cx);
    }
    let ordered = cx.answers.ordered::<Request>();
    controls(ui, cx, ordered.as_ref());
    let report = ordered.as_ref().and_then(|ordered| ordered.answer.clone());
    let Some(report) = report.filter(|report| !report.families.is_empty()) else {
        let note = match ordered {
            Some(_) => "Finding where the material sends its light …",
            None => {
                "Press Measure: every choice a renderer has for this material is tried on this \
                 machine, some seconds long"
            }
        };
        draw::centred_note(ui, note);
        return;
    };
    let room = ui.available_size();
    let is_wide = room.x > theme::ADVICE_BESIDE;
    if is_wide {
        ui.horizontal_top(|ui| {
            ui.allocate_ui(egui::vec2(room.x - theme::ADVICE_WIDTH, room.y), |ui| {
                ui.vertical(|ui| plot::show(ui, cx, &report));
            });
            ui.vertical(|ui| advice::show(ui, cx, &report));
        });
    } else {
        let height = room.y * theme::CHART_SHARE;
        ui.allocate_ui(egui::vec2(room.x, height), |ui| plot::show(ui, cx, &report));
        advice::show(ui, cx, &report);
    }
}

/// Whether what is measured, or being measured, is of what is selected and held.
fn is_measured(cx: &mut ViewContext<'_, Options>) -> bool {
    let request = request(cx.session, cx.state.stopwatch);
    let selected = cx.session.materials.selected();
    cx.answers.is_ordered(selected, &request)
}

fn start(cx: &mut ViewContext<'_, Options>) {
    *cx.state.own::<Chosen>(cx.view) = None;
    let request = request(cx.session, cx.state.stopwatch);
    cx.answers.order(cx.session.materials.selected(), request);
}

/// The buttons, how far it is, and what is measured.
fn controls(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, ordered: Option<&Ordered<Report>>) {
    let is_running = ordered.is_some_and(|ordered| ordered.is_awaited);
    ui.horizontal_wrapped(|ui| {
        if is_running {
            if ui
                .button("Cancel")
                .on_hover_text("Stop measuring; what is known stays")
                .clicked()
            {
                cx.answers.call_off::<Request>();
            }
            progress(ui, ordered.and_then(|ordered| ordered.part));
        } else {
            let hint = "Measure cost and error of every choice for the selected material";
            if ui.button("Measure").on_hover_text(hint).clicked() {
                start(cx);
            }
        }
        let options = &mut *cx.options;
        let hint = "The largest relative error (root mean square) that is good enough; the line \
            in the plot can be dragged";
        ui.label("Tolerance").on_hover_text(hint);
        let number = Number::new("Tolerance", TOLERANCE).logarithmic(true);
        let shown = number.field(ui, &mut options.tolerance);
        shown.on_hover_text(hint).explain(ui);
        let hint = "Measure whenever another material is selected, or it changes";
        choice::switch(ui, ("At once", hint), &mut options.is_immediate);
        if let Some(ordered) = ordered {
            let material = &ordered.surface.material;
            let title = material.title();
            let is_selected = material == cx.session.material();
            let text = if is_selected {
                title
            } else {
                format!("measured: {title}")
            };
            ui.label(RichText::new(text).weak());
        }
    });
    families(
        ui,
        cx,
        ordered.and_then(|ordered| ordered.answer.as_deref()),
    );
}

/// How far it is; no part is known yet at first.
fn progress(ui: &mut Ui, part: Option<Part>) {
    let left = part.and_then(|part| part.seconds_left);
    let text = left.map_or_else(
        || "measuring".to_owned(),
        |left| format!("about {left:.0} s left"),
    );
    let bar = ProgressBar::new(part.map_or(0.0, |part| part.share as f32));
    ui.add(bar.desired_width(theme::PROGRESS_WIDTH).text(text));
}

/// The families: each with its mark and whether it is wanted.
fn families(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, report: Option<&Report>) {
    let options = &mut *cx.options;
    ui.horizontal_wrapped(|ui| {
        for (index, family) in FAMILIES.iter().enumerate() {
            let (color, _) = look(index, cx.palette);
            let known = report.and_then(|report| {
                let mut families = report.families.iter();
                families.find(|known| known.id == family.id())
            });
            let reason = known.and_then(|known| known.not_applicable.as_ref());
            let hint = match (reason, known) {
                (Some(reason), _) => format!("Does not apply: {reason}"),
                (None, Some(known)) => format!("Held against: {}", known.reference),
                (None, None) => "Whether it is measured and shown".to_owned(),
            };
            let width = theme::LINE_SAMPLE + choice::small_switch_width(ui, family.title());
            choice::keep_together(ui, width);
            let ink = cx.palette.text_in(color);
            let text = RichText::new(family.title()).small().color(ink);
            let text = if reason.is_some() {
                text.strikethrough()
            } else {
                text
            };
            let mut is_wanted = options.wants(family.id());
            ui.horizontal(|ui| {
                plot::sample(ui, index, cx.palette);
                if ui
                    .checkbox(&mut is_wanted, text)
                    .on_hover_text(hint)
                    .changed()
                {
                    options.left_out.retain(|id| id != family.id());
                    if !is_wanted {
                        options.left_out.push(family.id().to_owned());
                    }
                }
            });
        }
    });
}
