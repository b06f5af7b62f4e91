//! The row of a parameter: its name with the buttons for it, and what sets it.

use egui::{Align, ComboBox, Layout, Response, Ui, WidgetInfo};

use super::controls::{name, reset_button};
use super::ties::Ties;
use super::words::{accessible, hint, reason, sentence};
use crate::theme;
use crate::widgets::data::{self, Change};
use crate::widgets::hint::at_number;
use crate::widgets::number::{Number, Shown};
use bxdf::Component;
use bxdf::param::{Kind, ParamSpec, Role, Scale, Value};
use bxdf_study::number::NumberSpec;
use bxdf_study::parameters::{CHANNELS, label, labels};

/// Says why a model refuses a value though it is within its range.
type Check<'a> = &'a dyn Fn(Value) -> Result<(), String>;

/// A parameter, and the number of its lobe among several, from 1, which its accessible names then say.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) spec: &'static ParamSpec,
    pub(super) ordinal: Option<usize>,
}

impl Place {
    fn accessible(self, label: &str) -> String {
        accessible(label, self.ordinal)
    }
}

/// The row of a parameter of `component`, which it changes.
pub(super) fn of_component(
    ui: &mut Ui,
    component: &mut Component,
    place: Place,
    ties: Option<&mut Ties<'_>>,
) {
    let spec = place.spec;
    if spec.kind == Kind::Data {
        let name = place.accessible(&label(spec));
        let resource = component.params().resource(spec.name);
        if let Some(changed) = data::show(ui, spec, &name, resource) {
            // Data is of no combination that a model refuses.
            let _ = match changed {
                Change::ReadAgain(resource) => component.set_resource(spec.name, resource),
                Change::TakeAway => component.set(spec.name, spec.default),
            };
        }
        return;
    }
    let Some(value) = component.params().get(spec.name) else {
        return;
    };
    let before = component.clone();
    let check = |value| before.clone().set(spec.name, value).map_err(reason);
    let mut edited = value;
    ui.push_id((component.model().id, spec.name), |ui| {
        show(ui, place, &mut edited, ties, &check);
    });
    if edited != value {
        set(component, spec, edited);
    }
}

/// The name, the slider and the number of a parameter of `component`, in a line.
pub(super) fn in_line(
    ui: &mut Ui,
    component: &mut Component,
    place: Place,
    (title, rail): (&str, f32),
) {
    let spec = place.spec;
    let Some(Value::Number(before)) = component.params().get(spec.name) else {
        return;
    };
    let (known, mut value, was) = (place.accessible(&label(spec)), before, component.clone());
    let check = |x| {
        let refused = was.clone().set(spec.name, Value::Number(x));
        refused.map_err(reason)
    };
    let number = number_of(spec, &known, &check);
    let hint = hint(spec);
    ui.label(title).on_hover_text(&hint);
    ui.spacing_mut().slider_width = rail;
    let _ = at_number(number.rail(ui, &mut value), &hint);
    let shown = number.field(ui, &mut value).on_hover_text(&hint);
    shown.explain_above(ui);
    if value != before {
        set(component, spec, Value::Number(value));
    }
}

/// Sets a parameter. Where the model refuses a choice because of the parameters it brings into play, these start from
/// their defaults; any other refused combination leaves the component as it was, and the slider springs back.
fn set(component: &mut Component, spec: &ParamSpec, value: Value) {
    if component.set(spec.name, value).is_ok() {
        return;
    }
    let mut reset = component.clone();
    for other in component.model().parameters {
        let is_brought = other
            .relevant_when
            .is_some_and(|(name, _)| name == spec.name);
        if is_brought && reset.set(other.name, other.default).is_err() {
            return;
        }
    }
    if reset.set(spec.name, value).is_ok() {
        *component = reset;
    }
}

/// The row of a value: what sets it stands below its name where it needs the width.
pub(super) fn show(
    ui: &mut Ui,
    place: Place,
    value: &mut Value,
    ties: Option<&mut Ties<'_>>,
    check: Check<'_>,
) {
    let Place { spec, ordinal } = place;
    let is_flag = matches!(value, Value::Bool(_));
    let mut shown = Vec::new();
    let head = ui.horizontal(|ui| {
        let name_label = match value {
            Value::Bool(flag) => {
                let checkbox = ui.checkbox(flag, label(spec)).on_hover_text(hint(spec));
                name(&checkbox, &label(spec), ordinal);
                checkbox
            }
            _ => ui.label(label(spec)).on_hover_text(hint(spec)),
        };
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let is_changed = *value != spec.default;
            let hint = format!("Reset to {}", spec.default);
            if reset_button(ui, &label(spec), ordinal, is_changed, &hint) {
                *value = spec.default;
            }
            if let Some(ties) = ties {
                ties.link_button(ui, spec, ordinal);
                ties.pin_button(ui, spec, ordinal);
            }
            if let Value::Choice(word) = value {
                choice(ui, place, word);
            }
        });
        name_label
    });
    if !is_flag {
        below(ui, place, value, &head.inner, &mut shown, check);
    }
    for field in shown {
        field.explain(ui);
    }
}

/// What stands below the name.
fn below(
    ui: &mut Ui,
    place: Place,
    value: &mut Value,
    label: &Response,
    shown: &mut Vec<Shown>,
    check: Check<'_>,
) {
    let spec = place.spec;
    match value {
        Value::Number(number) => {
            let known = place.accessible(&bxdf_study::parameters::label(spec));
            let check = |x| check(Value::Number(x));
            let of_spec = number_of(spec, &known, &check);
            let row = ui.horizontal(|ui| rail_and_field(ui, spec, &of_spec, number));
            let (rail, field) = row.inner;
            // The name says more than the label where there are several lobes.
            rail.labelled_by(label.id).accessible_name(&known);
            shown.push(field);
        }
        Value::Rgb(rgb) if spec.is_colour() => {
            let row = ui.horizontal(|ui| colour(ui, place, rgb, check));
            shown.extend(row.inner);
        }
        Value::Rgb(rgb) => {
            let now = *rgb;
            for ((index, channel), label) in rgb.iter_mut().enumerate().zip(labels(spec)) {
                let check = |x| check(with_channel(now, index, x));
                let known = place.accessible(&label);
                let number = number_of(spec, &known, &check);
                let letter = CHANNELS.get(index).copied().unwrap_or_default();
                let row = ui.horizontal(|ui| {
                    ui.label(letter).on_hover_text(hint(spec));
                    rail_and_field(ui, spec, &number, channel).1
                });
                row.inner.explain(ui);
            }
        }
        Value::Choice(_) | Value::Bool(_) | Value::Data(_) => {}
    }
}

/// The number of a parameter that assistive tools know by `name`.
fn number_of<'a>(
    spec: &ParamSpec,
    name: &'a str,
    check: &'a dyn Fn(f64) -> Result<(), String>,
) -> Number<'a> {
    Number::new(name, NumberSpec::of(spec))
        .logarithmic(spec.scale == Scale::Logarithmic)
        .check(check)
}

/// The slider, as long as the room before the number is.
fn rail_and_field(
    ui: &mut Ui,
    spec: &ParamSpec,
    number: &Number<'_>,
    value: &mut f64,
) -> (Response, Shown) {
    let room = ui.available_width() - theme::NUMBER_WIDTH - ui.spacing().item_spacing.x;
    ui.spacing_mut().slider_width = room.max(theme::SHORTEST_SLIDER);
    let hint = hint(spec);
    let rail = at_number(number.rail(ui, value), &hint);
    (rail, number.field(ui, value).on_hover_text(&hint))
}

/// The colour with `x` as one of its channels.
fn with_channel(mut rgb: [f64; 3], index: usize, x: f64) -> Value {
    if let Some(channel) = rgb.get_mut(index) {
        *channel = x;
    }
    Value::Rgb(rgb)
}

fn colour(ui: &mut Ui, place: Place, rgb: &mut [f64; 3], check: Check<'_>) -> Vec<Shown> {
    let spec = place.spec;
    let mut color = rgb.map(|channel| channel as f32);
    let button = ui
        .color_edit_button_rgb(&mut color)
        .on_hover_text(hint(spec));
    let known = place.accessible(&label(spec));
    button.widget_info(|| WidgetInfo::labeled(egui::Role::ColorWell, true, &known));
    let number = NumberSpec::of(spec);
    if button.changed() {
        for (channel, chosen) in rgb.iter_mut().zip(color) {
            number.put(channel, f64::from(chosen));
        }
    }
    let now = *rgb;
    let channels = rgb.iter_mut().zip(CHANNELS).zip(labels(spec)).enumerate();
    let fields = channels.map(|(index, ((channel, letter), label))| {
        let known = place.accessible(&label);
        let check = |x| check(with_channel(now, index, x));
        let prefix = format!("{letter} ");
        let field = Number::new(&known, number).prefix(&prefix).check(&check);
        let shown = field.field(ui, channel);
        shown.on_hover_text(&format!("{letter}\n{}", hint(spec)))
    });
    fields.collect()
}

fn choice(ui: &mut Ui, place: Place, word: &mut &'static str) {
    let spec = place.spec;
    let combo_box = ComboBox::from_id_salt(spec.name)
        .selected_text(sentence(word))
        .width(theme::COMBO_WIDTH.min(ui.available_width()))
        .show_ui(ui, |ui| {
            for option in spec.choices {
                ui.selectable_value(word, option, sentence(option));
            }
        })
        .response
        .on_hover_text(hint(spec));
    name(&combo_box, &label(spec), place.ordinal);
}

/// Whether the box that links the widths stands below it.
pub(super) fn is_last_width(spec: &ParamSpec) -> bool {
    spec.role == Role::WidthT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_choice_that_its_parameters_forbid_resets_them() {
        let mut mirror: Component = "specular_reflection:fresnel=conductor,eta=0.143,k=4"
            .parse()
            .unwrap();
        let fresnel = &mirror.model().parameters[0];
        set(&mut mirror, fresnel, Value::Choice("dielectric"));
        assert_eq!(mirror.to_string(), "specular_reflection:fresnel=dielectric");
    }
}
