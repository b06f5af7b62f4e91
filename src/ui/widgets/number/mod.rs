//! Numbers that are typed: the one field for them, alone or beside a slider.
//!
//! The text is the person's until Enter or until they leave the field. What is accepted is stored to the last digit; what
//! is not stays as it is, marked, and changes nothing.

use egui::{Response, Slider, SliderClamping, Ui};

mod described;
mod field;
mod late;
mod moving;
mod parse;

pub use described::{Check, Number, Shown};

impl Number<'_> {
    /// The slider alone, for what stands beside a field of its own.
    pub fn rail(&self, ui: &mut Ui, value: &mut f64) -> Response {
        let [least, most] = self.spec.range;
        let [low, high] = self.spec.soft;
        // It covers the soft range, and further only what the value has already.
        let rail = low.min(*value).max(least)..=high.max(*value).min(most);
        let slider = Slider::from_get_set(rail, |moved| {
            if let Some(moved) = moved {
                self.spec.put(value, moved);
            }
            *value
        });
        let slider = slider
            .show_value(false)
            .logarithmic(self.is_logarithmic)
            .clamping(SliderClamping::Never)
            .max_decimals(self.decimals)
            .step_by(self.step);
        ui.add(slider).accessible_name(self.name)
    }

    /// The field alone.
    pub fn field(&self, ui: &mut Ui, value: &mut f64) -> Shown {
        field::show(self, ui, value)
    }

    /// The slider, the field, and `label` behind them where it is not empty.
    pub fn slider(&self, ui: &mut Ui, label: &str, value: &mut f64) -> Shown {
        let row = ui.horizontal(|ui| {
            let rail = self.rail(ui, value);
            let shown = self.field(ui, value);
            if !label.is_empty() {
                let label = ui.label(label).id;
                // The name says more than the label where there are several lobes.
                rail.labelled_by(label).accessible_name(self.name);
                let field = shown.response.labelled_by(label);
                field.accessible_name(self.name);
            }
            shown.refusal
        });
        Shown {
            response: row.response,
            refusal: row.inner,
        }
    }
}
