//! The stability: where floating point gives out for the selected material, and why formulas are written as they are.

mod formulas;
mod map;
mod pair;
mod worst;

use egui::{RichText, Ui};

use super::context::ViewContext;
use crate::theme;
use crate::widgets::{choice, draw};
use bxdf_lab::formula_comparison::COMPARISONS;
use bxdf_lab::stability::map::Axis;
use bxdf_study::session::Session;
use bxdf_study::views::stability::{ErrorUnit, Options, Plot};

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    controls(ui, cx.session, cx.options);
    match cx.options.plot {
        Plot::Formulas => formulas::show(ui, cx),
        Plot::Map if cx.session.material().is_delta_only() => {
            let note = "All light is in Dirac deltas: f and the density are 0 everywhere";
            draw::centred_note(ui, note);
        }
        Plot::Map => maps_and_list(ui, cx),
    }
}

/// The maps, with the list of the worst points beside or below them.
fn maps_and_list(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let room = ui.available_size();
    if room.x > theme::ADVICE_BESIDE {
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
    let axes = Axis::all(session.material());
    let (x, y) = options.axes(session);
    let selected = session.materials.title(session.materials.selected());
    ui.horizontal_wrapped(|ui| {
        let hint = "The selected material over two axes, or the forms of formulas that keep or lose \
            their digits";
        choice::choice(ui, ("Show", hint), &mut options.plot, Plot::ALL, Plot::title);
        if options.plot == Plot::Formulas {
            formula_choice(ui, &mut options.trial);
            return;
        }
        let hint = "What varies along the horizontal axis; all else is fixed";
        axis_choice(ui, ("Across", hint), &mut options.x, &x, &axes);
        let hint = "What runs upwards";
        axis_choice(ui, ("Up", hint), &mut options.y, &y, &axes);
        let hint = "In units of u, the rounding of one operation (6e-8 in f32, 1.1e-16 in f64); as a \
            share of the value; or over what the stability law allows, 16 (1 + κ) u: above 1 the \
            formula is to blame, not the inputs";
        choice::choice(ui, ("Errors", hint), &mut options.unit, ErrorUnit::ALL, ErrorUnit::title);
        let hint = "Lines of equal condition number κ, one for each decade: how much the rounding \
            of the inputs is multiplied";
        choice::switch(ui, ("κ", hint), &mut options.has_contours);
        ui.label(RichText::new(selected).weak());
    });
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

fn formula_choice(ui: &mut Ui, chosen: &mut String) {
    let shown = formulas::chosen(chosen);
    let mut id = shown.id;
    let hint = "A quantity as textbooks write it, and as the core computes it";
    choice::named_combo(ui, ("Formula", "Formula", hint), shown.title, |ui| {
        for comparison in &COMPARISONS {
            ui.selectable_value(&mut id, comparison.id, comparison.title);
        }
    });
    if id != shown.id {
        id.clone_into(chosen);
    }
}
