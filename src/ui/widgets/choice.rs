//! Small controls that the views have above them: a choice of words, and an angle.

use egui::{Response, Ui};

use crate::theme;
use crate::widgets::number::Number;
use bxdf_study::number::NumberSpec;

/// Begins a new row where `width` points do not fit into this one: what stands in a row of its own does not wrap.
pub fn keep_together(ui: &mut Ui, width: f32) {
    if width > ui.available_size_before_wrap().x {
        ui.end_row();
    }
}

/// The width of a word in points.
#[must_use]
pub fn width_of(ui: &Ui, text: &str, style: &egui::TextStyle) -> f32 {
    let font = style.resolve(ui.style());
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), font, ui.visuals().text_color());
    galley.size().x
}

/// The width of a switch with a small `text`, in points.
#[must_use]
pub fn small_switch_width(ui: &Ui, text: &str) -> f32 {
    let spacing = ui.spacing();
    let icon = spacing.icon_width + spacing.icon_spacing;
    icon + width_of(ui, text, &egui::TextStyle::Small) + spacing.item_spacing.x
}

/// The width of a drop-down that shows `text`, in points.
#[must_use]
pub fn combo_width(ui: &Ui, text: &str) -> f32 {
    let spacing = ui.spacing();
    let icon = spacing.icon_width + spacing.icon_spacing;
    let inside = (width_of(ui, text, &egui::TextStyle::Body) + icon).max(theme::SHORT_COMBO_WIDTH);
    inside + 2.0 * spacing.button_padding.x
}

/// A name and a drop-down, on one line wherever the line ends. `chosen`: what it shows.
pub fn named_combo(
    ui: &mut Ui,
    (name, label, hint): (&str, &str, &str),
    chosen: &str,
    items: impl FnOnce(&mut Ui),
) {
    let width = width_of(ui, label, &egui::TextStyle::Body)
        + combo_width(ui, chosen)
        + 2.0 * ui.spacing().item_spacing.x;
    keep_together(ui, width);
    ui.horizontal(|ui| {
        ui.label(label).on_hover_text(hint);
        let combo = egui::ComboBox::from_id_salt(name)
            .selected_text(chosen)
            .width(theme::SHORT_COMBO_WIDTH)
            .show_ui(ui, items);
        named(ui, &combo.response.on_hover_text(hint), name);
    });
}

/// A drop-down of `all`, each named by `title`; `name` stands before it and tells it to tests and screen readers.
pub fn choice<T: Copy + PartialEq>(
    ui: &mut Ui,
    (name, hint): (&str, &str),
    value: &mut T,
    all: &[T],
    title: impl Fn(T) -> &'static str,
) {
    named_combo(ui, (name, name, hint), title(*value), |ui| {
        for one in all {
            ui.selectable_value(value, *one, title(*one));
        }
    });
}

/// An angle in degrees, with its name before it.
pub fn angle(ui: &mut Ui, (name, hint): (&str, &str), value: &mut f64, spec: &NumberSpec) {
    number(ui, (name, hint), &Number::new(name, *spec), value);
}

/// A number with its name before it, on one line wherever the line ends.
pub fn number(ui: &mut Ui, (name, hint): (&str, &str), number: &Number<'_>, value: &mut f64) {
    let spacing = ui.spacing();
    let room = 2.0 * (spacing.button_padding.x + spacing.item_spacing.x);
    let digits = width_of(ui, &number.shown(*value), &egui::TextStyle::Button);
    let field = digits.max(theme::NUMBER_WIDTH);
    let label = width_of(ui, name, &egui::TextStyle::Body);
    keep_together(ui, label + field + room);
    ui.label(name).on_hover_text(hint);
    number.field(ui, value).on_hover_text(hint).explain(ui);
}

/// The width of a slider with its number and its `name` before it, in points.
#[must_use]
pub fn slider_width(ui: &Ui, name: &str) -> f32 {
    let spacing = ui.spacing();
    let rail = spacing.slider_width + theme::NUMBER_WIDTH + 3.0 * spacing.item_spacing.x;
    width_of(ui, name, &egui::TextStyle::Body) + rail
}

/// A power of 2 with its name before it: the exponent, which is what `log2` and `spec` are of, on the slider, the number itself
/// in the field.
pub fn power_of_two(ui: &mut Ui, (name, hint): (&str, &str), log2: &mut u8, spec: &NumberSpec) {
    keep_together(ui, slider_width(ui, name));
    ui.label(name).on_hover_text(hint);
    let mut exponent = f64::from(*log2);
    let counts = NumberSpec::new(spec.name, spec.range.map(f64::exp2)).whole();
    let is_power = |count: f64| {
        let allowed = counts.allowed();
        let problem = || format!("{count} is no power of 2; {allowed}");
        (count.log2().fract() == 0.0)
            .then_some(())
            .ok_or_else(problem)
    };
    let shown = ui.horizontal(|ui| {
        let rail = Number::new(name, *spec).steps(1.0, 0);
        rail.rail(ui, &mut exponent);
        let mut count = exponent.exp2();
        let field = Number::new(name, counts).check(&is_power);
        let shown = field.field(ui, &mut count);
        exponent = count.log2();
        shown
    });
    let shown = shown.inner.on_hover_text(hint);
    shown.explain(ui);
    *log2 = exponent.round() as u8;
}

/// A switch.
pub fn switch(ui: &mut Ui, named: (&str, &str), value: &mut bool) {
    switch_if(true, ui, named, value);
}

/// A switch that can be used where `is_enabled`.
pub fn switch_if(is_enabled: bool, ui: &mut Ui, (name, hint): (&str, &str), value: &mut bool) {
    ui.add_enabled(is_enabled, egui::Checkbox::new(value, name))
        .on_hover_text(hint);
}

/// Gives a control its name for tests and screen readers.
fn named(ui: &Ui, response: &Response, name: &str) {
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label(name));
}
