//! The model picker: every model under its category.

use egui::{RichText, Ui};

use crate::bxdf::models::MODELS;
use crate::bxdf::{Category, Material, ModelSpec, Side};

/// The list of models; choosing one replaces the material by the one of that model last put on the `shelf`, or by the
/// model's defaults, and puts the old one there.
pub fn show(ui: &mut Ui, material: &mut Material, shelf: &mut Vec<Material>) {
    for category in Category::ALL {
        ui.label(RichText::new(category.title()).strong())
            .on_hover_text(category.meaning());
        ui.indent(category.id(), |ui| {
            for model in MODELS
                .into_iter()
                .filter(|model| model.category() == category)
            {
                let is_chosen = model.id == material.model().id;
                let hint = format!(
                    "{}\n\n{}\n\nR: reflects, T: transmits",
                    model.summary, model.source
                );
                if ui
                    .selectable_label(is_chosen, title(model))
                    .on_hover_text(hint)
                    .clicked()
                    && !is_chosen
                {
                    let kept = shelf.iter().position(|kept| kept.model().id == model.id);
                    let next =
                        kept.map_or_else(|| Material::of(model), |index| shelf.swap_remove(index));
                    shelf.push(std::mem::replace(material, next));
                }
            }
        });
    }
}

/// The title, and the sides where they are not plain from it.
fn title(model: &ModelSpec) -> String {
    let sides: Vec<&str> = [(Side::Reflection, "R"), (Side::Transmission, "T")]
        .into_iter()
        .filter(|(side, _)| model.lobes.iter().any(|lobe| lobe.side == *side))
        .map(|(_, letter)| letter)
        .collect();
    format!("{}  ({})", model.title, sides.join(" + "))
}
