//! Sliders, drop-downs and colour buttons, made from the parameter specs.

use std::collections::BTreeSet;

use egui::{ComboBox, Response, Ui, accesskit};

use crate::theme;
use crate::widgets::data::{self, Change};
use crate::widgets::number::{Number, Shown};
use bxdf::Component;
use bxdf::error::Error;
use bxdf::material::WEIGHT;
use bxdf::param::{Kind, ParamSpec, Role, Scale, Value};
use bxdf_study::number::NumberSpec;

/// Says why a model refuses a value though it is within its range.
type Check<'a> = &'a dyn Fn(Value) -> Result<(), String>;

/// The names of the channels.
const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// What ties parameters together, changed by the buttons beside them.
pub struct Ties<'a> {
    /// Whether the widths along s and t move together.
    pub has_linked_widths: &'a mut bool,
    /// The names of the parameters that are locked across materials.
    pub locked: &'a mut BTreeSet<String>,
    /// Whether other materials have a parameter too, so that it can be locked.
    pub is_shared: &'a dyn Fn(&ParamSpec) -> bool,
}

impl Ties<'_> {
    /// The button that locks the parameter across materials, where others have it.
    fn lock_button(&mut self, ui: &mut Ui, spec: &ParamSpec, ordinal: Option<usize>) {
        if !(self.is_shared)(spec) {
            return;
        }
        let is_locked = self.locked.contains(spec.name);
        let (icon, hint) = if is_locked {
            (
                "🔒",
                "Locked across materials: a change sets it in all that have it. Click to unlock",
            )
        } else {
            (
                "🔓",
                "Lock across materials: a change then sets it in all that have it",
            )
        };
        let button = egui::Button::new(icon).small().frame(false);
        let response = ui.add(button).on_hover_text(hint);
        let name = accessible(&format!("Lock {}", spec.label()), ordinal);
        response
            .widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, is_locked, &name));
        if response.clicked() && !self.locked.remove(spec.name) {
            self.locked.insert(spec.name.to_owned());
        }
    }

    /// The box that links the widths, below the second one.
    fn link_box(&mut self, ui: &mut Ui, ordinal: Option<usize>) {
        let checkbox = ui
            .checkbox(self.has_linked_widths, "Same alpha along s and t")
            .on_hover_text("Move both widths together: the lobe stays isotropic. Unlink them for brushed surfaces");
        name(&checkbox, "Same alpha along s and t", ordinal);
    }
}

/// The weight of `component`; `ordinal` as for [`show`].
pub fn show_weight(ui: &mut Ui, component: &mut Component, ordinal: Option<usize>) {
    let weight = component.weight();
    let mut edited = Value::Number(weight);
    ui.scope(|ui| {
        ui.spacing_mut().slider_width = slider_width(ui, labels(&WEIGHT).into_iter(), false);
        row(ui, &WEIGHT, &mut edited, ordinal, None, &|_| Ok(()));
    });
    if let Value::Number(edited) = edited
        && edited != weight
    {
        // Within the range of the slider nothing is refused.
        let _ = component.set_weight(edited);
    }
}

/// The parameters of `component`; those without effect at present are left out.
///
/// `ordinal`: the number of `component` among several lobes, from 1, which their accessible names then say.
pub fn show(ui: &mut Ui, component: &mut Component, ordinal: Option<usize>, ties: &mut Ties<'_>) {
    let params = component.params().clone();
    let sliders = params
        .iter()
        .filter(|(spec, _)| params.is_relevant(spec) && !spec.is_colour());
    let can_lock = params.iter().any(|(spec, _)| (ties.is_shared)(spec));
    let labels = sliders.flat_map(|(spec, _)| labels(spec));
    ui.spacing_mut().slider_width = slider_width(ui, labels, can_lock);
    let before = component.clone();
    for (spec, value) in params.iter().filter(|(spec, _)| params.is_relevant(spec)) {
        if spec.kind == Kind::Data {
            let name = accessible(&spec.label(), ordinal);
            let resource = params.resource(spec.name);
            if let Some(changed) = data::show(ui, spec, &name, resource) {
                // Data is of no combination that a model refuses.
                let _ = match changed {
                    Change::ReadAgain(resource) => component.set_resource(spec.name, resource),
                    Change::TakeAway => component.set(spec.name, spec.default),
                };
            }
            continue;
        }
        let check = |value| before.clone().set(spec.name, value).map_err(reason);
        let mut edited = value;
        ui.push_id((component.model().id, spec.name), |ui| {
            row(ui, spec, &mut edited, ordinal, Some(ties), &check);
            if spec.role == Role::WidthT {
                ties.link_box(ui, ordinal);
            }
        });
        if edited != value {
            set(component, spec, edited);
        }
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

/// The reason of a refusal, in a line.
#[must_use]
pub fn reason(error: Error) -> String {
    match error {
        Error::Parse { problem, .. } => problem,
        other => other.to_string(),
    }
}

/// The name under which assistive tools know the control with this label.
fn accessible(label: &str, ordinal: Option<usize>) -> String {
    ordinal.map_or_else(
        || label.to_owned(),
        |ordinal| format!("{label} of lobe {ordinal}"),
    )
}

/// Gives the control of `response` its accessible name.
fn name(response: &Response, label: &str, ordinal: Option<usize>) {
    let name = accessible(label, ordinal);
    let set_label = |node: &mut accesskit::Node| node.set_label(name);
    response.ctx.accesskit_node_builder(response.id, set_label);
}

fn row(
    ui: &mut Ui,
    spec: &ParamSpec,
    value: &mut Value,
    ordinal: Option<usize>,
    mut ties: Option<&mut Ties<'_>>,
    check: Check<'_>,
) {
    let mut fields = Vec::new();
    ui.horizontal(|ui| {
        let hint = hint(spec);
        match value {
            Value::Number(number) => {
                let check = |x| check(Value::Number(x));
                fields.push(slider(ui, spec, (&spec.label(), ordinal), number, &check));
            }
            Value::Rgb(rgb) if spec.is_colour() => {
                ui.vertical(|ui| {
                    // The fields below reach as far as the reset button: the lock stands beside the name.
                    ui.horizontal(|ui| {
                        ui.label(spec.label()).on_hover_text(&hint);
                        if let Some(ties) = ties.take() {
                            ties.lock_button(ui, spec, ordinal);
                        }
                    });
                    fields = ui
                        .horizontal(|ui| colour(ui, spec, rgb, ordinal, check))
                        .inner;
                });
            }
            Value::Rgb(rgb) => {
                let now = *rgb;
                ui.vertical(|ui| {
                    for ((index, channel), label) in rgb.iter_mut().enumerate().zip(labels(spec)) {
                        let check = |x| check(with_channel(now, index, x));
                        slider(ui, spec, (&label, ordinal), channel, &check).explain(ui);
                    }
                });
            }
            Value::Choice(word) => choice(ui, spec, word, ordinal),
            // It has a row of its own.
            Value::Data(_) => {}
            Value::Bool(flag) => {
                let checkbox = ui.checkbox(flag, spec.label()).on_hover_text(&hint);
                name(&checkbox, &spec.label(), ordinal);
            }
        }
        let is_changed = *value != spec.default;
        let reset = egui::Button::new("↺").small().frame(false);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let response = ui
                .add_enabled(is_changed, reset)
                .on_hover_text(format!("Reset to {}", spec.default));
            let name = accessible(&format!("Reset {}", spec.label()), ordinal);
            response
                .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, is_changed, &name));
            if response.clicked() {
                *value = spec.default;
            }
            if let Some(ties) = ties {
                ties.lock_button(ui, spec, ordinal);
            }
        });
    });
    for field in fields {
        field.explain(ui);
    }
}

/// The colour with `x` as one of its channels.
fn with_channel(mut rgb: [f64; 3], index: usize, x: f64) -> Value {
    if let Some(channel) = rgb.get_mut(index) {
        *channel = x;
    }
    Value::Rgb(rgb)
}

fn hint(spec: &ParamSpec) -> String {
    let [low, high] = spec.hard;
    let unit = if spec.unit.is_empty() {
        String::new()
    } else {
        format!(" {}", spec.unit)
    };
    match spec.kind {
        Kind::Number | Kind::Rgb => {
            format!("{}\n{}: {low} to {high}{unit}", spec.meaning, spec.name)
        }
        Kind::Choice | Kind::Bool | Kind::Data => format!("{}\n{}", spec.meaning, spec.name),
    }
}

fn slider(
    ui: &mut Ui,
    spec: &ParamSpec,
    (label, ordinal): (&str, Option<usize>),
    number: &mut f64,
    check: &dyn Fn(f64) -> Result<(), String>,
) -> Shown {
    let name = accessible(label, ordinal);
    let shown = Number::new(&name, NumberSpec::of(spec))
        .logarithmic(spec.scale == Scale::Logarithmic)
        .check(check)
        .slider(ui, label, number);
    // The text has no tooltip of its own: the whole row shows it.
    shown.on_hover_text(&hint(spec))
}

/// The labels of a parameter's sliders.
fn labels(spec: &ParamSpec) -> Vec<String> {
    match spec.kind {
        Kind::Number => vec![spec.label()],
        Kind::Rgb => CHANNELS
            .map(|name| format!("{} {name}", spec.label()))
            .to_vec(),
        Kind::Choice | Kind::Bool | Kind::Data => Vec::new(),
    }
}

/// The usual width, less what the longest label needs to stand beside the number and before the buttons for reset and,
/// where it `can_lock`, lock.
fn slider_width(ui: &Ui, labels: impl Iterator<Item = String>, can_lock: bool) -> f32 {
    let font = egui::TextStyle::Body.resolve(ui.style());
    let width = |label| {
        let text = ui
            .painter()
            .layout_no_wrap(label, font.clone(), egui::Color32::PLACEHOLDER);
        text.size().x
    };
    let longest = labels.map(width).fold(0.0, f32::max);
    let spacing = ui.spacing();
    let buttons = 1.0 + f32::from(u8::from(can_lock));
    let rest = longest
        + theme::NUMBER_WIDTH
        + buttons * theme::RESET_WIDTH
        + (2.0 + buttons) * spacing.item_spacing.x;
    (ui.available_width() - rest).clamp(theme::SHORTEST_SLIDER, spacing.slider_width)
}

fn colour(
    ui: &mut Ui,
    spec: &ParamSpec,
    rgb: &mut [f64; 3],
    ordinal: Option<usize>,
    check: Check<'_>,
) -> Vec<Shown> {
    let mut color = rgb.map(|channel| channel as f32);
    let button = ui
        .color_edit_button_rgb(&mut color)
        .on_hover_text(hint(spec));
    let label = accessible(&spec.label(), ordinal);
    button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ColorWell, true, &label));
    let number = NumberSpec::of(spec);
    if button.changed() {
        for (channel, chosen) in rgb.iter_mut().zip(color) {
            number.put(channel, f64::from(chosen));
        }
    }
    let now = *rgb;
    let channels = rgb.iter_mut().zip(CHANNELS).enumerate();
    let fields = channels.map(|(index, (channel, letter))| {
        let name = accessible(&format!("{} {letter}", spec.label()), ordinal);
        let check = |x| check(with_channel(now, index, x));
        let prefix = format!("{letter} ");
        let field = Number::new(&name, number).prefix(&prefix).check(&check);
        let shown = field.field(ui, channel);
        shown.on_hover_text(&format!("{letter}\n{}", hint(spec)))
    });
    fields.collect()
}

fn choice(ui: &mut Ui, spec: &ParamSpec, word: &mut &'static str, ordinal: Option<usize>) {
    let label = spec.label();
    let combo_box = ComboBox::from_label(&label)
        .selected_text(sentence(word))
        .width(theme::COMBO_WIDTH)
        .show_ui(ui, |ui| {
            for option in spec.choices {
                ui.selectable_value(word, option, sentence(option));
            }
        })
        .response
        .on_hover_text(hint(spec));
    name(&combo_box, &label, ordinal);
}

/// A word of the command line as the screen shows it.
fn sentence(word: &str) -> String {
    if word == "ggx" {
        return word.to_uppercase();
    }
    let spaced = word.replace('_', " ");
    let mut letters = spaced.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
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

    #[test]
    fn words_read_as_sentences() {
        assert_eq!(sentence("kulla_conty"), "Kulla conty");
        assert_eq!(sentence("ggx"), "GGX");
        assert_eq!(sentence(""), "");
    }
}
