//! The stability: where floating point gives out for the selected material, and why formulas are written as they are.

mod coat;
mod formula_curves;
mod formula_maps;
mod formulas;
mod map;
mod pair;
mod plate;
mod verdict;
mod worst;

use egui::Ui;

use super::context::ViewContext;
use super::settings;
use crate::theme;
use crate::widgets::{choice, draw};
use bxdf_lab::formula_comparison::COMPARISONS;
use bxdf_lab::stability::map::Axis;
use bxdf_study::session::Session;
use bxdf_study::views::stability::{ErrorUnit, Options, Plot, Trial};

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    if !cx.state.is_picture {
        tabs(ui, cx.options);
    }
    settings::show(ui, cx, |ui, cx| controls(ui, cx.session, cx.options));
    match cx.options.plot {
        Plot::Formulas => formula(ui, cx),
        Plot::Coat => coat::show(ui, cx),
        Plot::Map => {
            verdict::show(ui, cx);
            if cx.session.material().is_delta_only() {
                let note = "All light is in Dirac deltas: f and the density are 0 everywhere";
                draw::centred_note(ui, note);
            } else {
                maps_and_list(ui, cx);
            }
        }
    }
}

/// The formula chosen: how far its forms are off, in a sentence and in pictures, and why.
fn formula(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let comparison = cx.options.formula();
    let Some(curve) = cx.answers.of_nothing(cx.options.curve_request()) else {
        draw::centred_note(ui, "Trying both forms of the formula …");
        return;
    };
    ui.label(formulas::verdict(comparison, &curve));
    let room = ui.available_height();
    let is_brief = room < theme::LIST_BELOW;
    let height = room
        - if is_brief {
            formulas::BRIEF_WORDS
        } else {
            formulas::WORDS
        };
    if cx.options.is_formula_mapped() {
        formula_maps::show(ui, cx, comparison, height);
    } else {
        formula_curves::show(ui, cx, (comparison, &curve), height);
    }
    formulas::words(ui, comparison, is_brief);
}

/// What the view is of, always in sight.
fn tabs(ui: &mut Ui, options: &mut Options) {
    ui.horizontal(|ui| {
        for (plot, hint) in [
            (Plot::Map, "Where digits of the selected material are lost"),
            (
                Plot::Formulas,
                "Formulas as textbooks have them and as they are computed here: which of them keep their digits",
            ),
            (
                Plot::Coat,
                "1 - F of which angle stands over the diffuse part under a coat: which forms are reciprocal, and which keep energy",
            ),
        ] {
            let tab = ui.selectable_value(&mut options.plot, plot, plot.title());
            tab.on_hover_text(hint);
        }
    });
}

/// The maps, with the list of the worst points beside or below them.
fn maps_and_list(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let room = ui.available_size();
    if cx.state.is_figure() {
        // The verdict names the worst of them.
        map::show(ui, cx);
    } else if room.x > theme::ADVICE_BESIDE {
        ui.horizontal_top(|ui| {
            ui.allocate_ui(egui::vec2(room.x - theme::ADVICE_WIDTH, room.y), |ui| {
                ui.vertical(|ui| map::show(ui, cx));
            });
            ui.vertical(|ui| worst::show(ui, cx));
        });
    } else if room.y > theme::LIST_BELOW {
        let height = room.y * theme::CHART_SHARE;
        ui.allocate_ui(egui::vec2(room.x, height), |ui| map::show(ui, cx));
        worst::show(ui, cx);
    } else {
        map::show(ui, cx);
    }
}

fn controls(ui: &mut Ui, session: &Session, options: &mut Options) {
    ui.horizontal_wrapped(|ui| {
        match options.plot {
            Plot::Formulas => {
                formula_choice(ui, options);
                if !options.is_formula_mapped() {
                    return;
                }
            }
            Plot::Map => axes_choice(ui, session, options),
            Plot::Coat => {
                ui.label(coat::WHAT);
                return;
            }
        }
        let hint = "In units of u, the rounding of one operation (6e-8 in f32, 1.1e-16 in f64); as a \
            share of the value; or over what the stability law allows, 16 (1 + κ) u: above 1 the \
            formula is to blame, not the inputs";
        choice::choice(
            ui,
            ("Errors", hint),
            &mut options.unit,
            ErrorUnit::ALL,
            ErrorUnit::title,
        );
        if options.plot == Plot::Map {
            let hint = "Lines of equal condition number κ, one for each decade: how much the rounding \
                of the inputs is multiplied";
            choice::switch(ui, ("κ", hint), &mut options.has_contours);
        }
    });
}

fn axes_choice(ui: &mut Ui, session: &Session, options: &mut Options) {
    let axes = Axis::all(session.material());
    let (x, y) = options.axes(session);
    let hint = "What varies along the horizontal axis; all else is fixed";
    axis_choice(ui, ("Across", hint), &mut options.x, &x, &axes);
    let hint = "What runs upwards";
    axis_choice(ui, ("Up", hint), &mut options.y, &y, &axes);
}

fn axis_choice(
    ui: &mut Ui,
    (name, hint): (&str, &str),
    chosen: &mut String,
    shown: &Axis,
    axes: &[Axis],
) {
    let mut id = shown.id();
    choice::named_combo(ui, (name, name, hint), &shown.title(), |ui| {
        for axis in axes {
            ui.selectable_value(&mut id, axis.id(), axis.title());
        }
    });
    if id != shown.id() {
        *chosen = id;
    }
}

fn formula_choice(ui: &mut Ui, options: &mut Options) {
    let shown = options.formula();
    let mut id = shown.id;
    let hint = "A quantity as textbooks write it, and as the core computes it";
    choice::named_combo(ui, ("Formula", "Formula", hint), shown.title, |ui| {
        for comparison in &COMPARISONS {
            ui.selectable_value(&mut id, comparison.id, comparison.title);
        }
    });
    if id != shown.id {
        id.clone_into(&mut options.trial);
    }
    let hint = "Along one argument, or over both, where the formula has two";
    ui.add_enabled_ui(shown.second.is_some(), |ui| {
        choice::choice(
            ui,
            ("As", hint),
            &mut options.trial_as,
            Trial::ALL,
            Trial::title,
        );
    });
}
