//! The index of a metal as its name, with the numbers behind it.

use egui::{Align, ComboBox, Layout, RichText, Ui};

use super::controls::{name, reset_button};
use super::row::{self, Place};
use super::ties::Ties;
use super::words::{accessible, sentence};
use crate::theme;
use crate::widgets::chevron::{self, Points};
use bxdf::Component;
use bxdf::param::{ParamSpec, Value};
use bxdf_lab::spectral::{Constants, metals};

/// What the row is called.
const METAL: &str = "Metal";

/// The word for numbers that are no metal's.
const CUSTOM: &str = "Custom";

/// What choosing a metal does.
const HINT: &str = "Sets n and k of each channel so that it reflects, at 0 and at 82 degrees, what light of the whole \
                    spectrum does in it";

/// The row of `specs`, n and k of `component`: the metal they are of, and, where `is_open`, the six numbers. `ordinal` as for
/// [`super::show`].
pub(super) fn show(
    ui: &mut Ui,
    component: &mut Component,
    specs: [&'static ParamSpec; 2],
    ordinal: Option<usize>,
    ties: &mut Ties<'_>,
    is_open: &mut bool,
) {
    let known = Constants::of(component);
    ui.horizontal(|ui| {
        let what = accessible("n and k of the metal", ordinal);
        let points = Points::of_heading(*is_open);
        let hint = "Show or hide n and k of each channel";
        if chevron::button(ui, points, *is_open, &what, hint).clicked() {
            *is_open ^= true;
        }
        ui.label(METAL).on_hover_text(HINT);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let values =
                |component: &Component| specs.map(|spec| component.params().get(spec.name));
            let is_changed = values(component) != specs.map(|spec| Some(spec.default));
            let hint = "Reset n and k to those of the model";
            if reset_button(ui, METAL, ordinal, is_changed, hint) {
                put(component, specs, specs.map(|spec| spec.default));
            }
            let shown = known.map_or_else(|| CUSTOM.to_owned(), |known| sentence(known.id));
            let combo_box = ComboBox::from_id_salt("metal")
                .selected_text(shown)
                .width(theme::COMBO_WIDTH)
                .show_ui(ui, |ui| {
                    for metal in metals() {
                        let is_it = known.is_some_and(|known| known.id == metal.id);
                        if ui.selectable_label(is_it, sentence(metal.id)).clicked() && !is_it {
                            put(component, specs, metal.given().map(Value::Rgb));
                        }
                    }
                });
            name(&combo_box.response.on_hover_text(HINT), METAL, ordinal);
        });
    });
    if !*is_open {
        return;
    }
    ui.indent("n and k", |ui| {
        for spec in specs {
            let place = Place { spec, ordinal };
            row::of_component(ui, component, place, Some(&mut *ties));
        }
        ui.label(RichText::new("One n and one k for each of red, green and blue").small());
    });
}

/// Sets both at once: a metal may have an n that its model refuses beside the k of another.
fn put(component: &mut Component, specs: [&'static ParamSpec; 2], values: [Value; 2]) {
    let [n, k] = specs.map(|spec| spec.name);
    let [first, second] = values;
    if let Some(params) = component.params().with(&[(n, first), (k, second)]) {
        // Of a metal and of the model's own nothing is refused.
        let _ = component.set_all(&params);
    }
}
