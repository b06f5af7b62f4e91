//! The trade-off: the cheapest choice that is good enough, and error over cost of every one.

mod accuracy;
mod advice;
mod charts;
mod chosen;
mod plot;
mod verdict;

use chosen::Chosen;

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{PopupCloseBehavior, ProgressBar, RichText, Ui};

use super::context::ViewContext;
use super::settings;
use crate::theme;
use crate::widgets::number::Number;
use crate::widgets::{choice, draw};
use bxdf_lab::tradeoff::{FAMILIES, Family, Question, Report, Request};
use bxdf_study::answers::Ordered;
use bxdf_study::jobs::Part;
use bxdf_study::views::tradeoff::{Options, TOLERANCE, request};

/// From this height on there is a list below the charts, in points: two of them take more room than one.
const LIST_BELOW: f32 = 1.5 * theme::LIST_BELOW;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let is_wanted = cx.options.is_immediate && !ui.ctx().egui_is_using_pointer();
    if is_wanted && !is_measured(cx) {
        start(cx);
    }
    let ordered = cx.answers.ordered::<Request>();
    if !cx.state.is_picture {
        measuring(ui, cx, ordered.as_ref());
    }
    let report = ordered.as_ref().and_then(|ordered| ordered.answer.clone());
    settings::show(ui, cx, |ui, cx| controls(ui, cx, report.as_deref()));
    let Some(report) = report.filter(|report| !report.families.is_empty()) else {
        match ordered {
            Some(_) => draw::centred_note(ui, "Finding where the material sends its light …"),
            None => accuracy::show(ui, cx),
        }
        return;
    };
    let shown = cx.options.wanted(&report);
    let is_awaited = ordered.is_some_and(|ordered| ordered.is_awaited);
    // In a figure the verdict says what there is to say.
    let is_beside = ui.available_width() > theme::ADVICE_BESIDE && !cx.state.is_figure();
    let is_below = ui.available_height() > LIST_BELOW && !cx.state.is_figure();
    let has_list = is_beside || is_below;
    verdict::show(ui, cx, &shown, (is_awaited, has_list));
    if shown.families.iter().all(|family| family.points.is_empty()) {
        return;
    }
    let room = ui.available_size();
    if is_beside {
        ui.horizontal_top(|ui| {
            ui.allocate_ui(egui::vec2(room.x - theme::ADVICE_WIDTH, room.y), |ui| {
                ui.vertical(|ui| charts::show(ui, cx, &shown));
            });
            ui.vertical(|ui| advice::show(ui, cx, &shown));
        });
    } else if !has_list {
        charts::show(ui, cx, &shown);
    } else {
        let height = room.y * theme::CHART_SHARE;
        ui.allocate_ui(egui::vec2(room.x, height), |ui| {
            charts::show(ui, cx, &shown);
        });
        advice::show(ui, cx, &shown);
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

/// The button that begins or ends it, how far it is, and what is measured: always in sight.
fn measuring(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, ordered: Option<&Ordered<Report>>) {
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
}

/// The settings.
fn controls(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, report: Option<&Report>) {
    ui.horizontal_wrapped(|ui| {
        let options = &mut *cx.options;
        let hint = "The largest relative error (root mean square) that is good enough; the line \
            in the plots can be dragged";
        let number = Number::new("Tolerance", TOLERANCE).logarithmic(true);
        choice::number(ui, ("Tolerance", hint), &number, &mut options.tolerance);
        let hint = "Measure whenever another material is selected, or it changes";
        let named = ("Measure automatically", hint);
        choice::switch(ui, named, &mut options.is_immediate);
        let about = report.filter(|report| report.material == *cx.session.material());
        let menu = MenuButton::new("Choices")
            .config(MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside));
        let (response, _) = menu.ui(ui, |ui| families(ui, options, about));
        response.on_hover_text("Which families of choices are measured and shown");
    });
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

/// The families that may apply, and whether each is wanted; `report`: what is known of the selected material.
fn families(ui: &mut Ui, options: &mut Options, report: Option<&Report>) {
    let known = |family: &dyn Family| {
        let mut families = report?.families.iter();
        families.find(|known| known.id == family.id())
    };
    for question in Question::ALL {
        ui.label(RichText::new(question.title()).small().strong());
        for family in FAMILIES {
            let known = known(family);
            let is_out = known.is_some_and(|known| known.not_applicable.is_some());
            if is_out || family.cost_unit().question() != question {
                continue;
            }
            let hint = known.map_or_else(
                || "Whether it is measured and shown".to_owned(),
                |known| format!("Held against: {}", known.reference),
            );
            let mut is_wanted = options.wants(family.id());
            let switch = ui.checkbox(&mut is_wanted, family.title());
            if switch.on_hover_text(hint).changed() {
                options.left_out.retain(|id| id != family.id());
                if !is_wanted {
                    options.left_out.push(family.id().to_owned());
                }
            }
        }
    }
}
