//! The model picker: every model under its category.

use egui::{RichText, ScrollArea, TextEdit, Ui};

use crate::bxdf::models::MODELS;
use crate::bxdf::{Category, Material, ModelSpec, Side};

/// The share of the panel's height that the list may take; the rest is for the parameters.
const LIST_SHARE: f32 = 0.45;

/// What the picker keeps between frames.
#[derive(Default)]
pub struct Picker {
    search: String,
    /// Materials looked at before: their sliders stand as they were left.
    shelf: Vec<Material>,
    /// The id of the chosen model the list was last scrolled to.
    scrolled_to: &'static str,
}

impl Picker {
    /// The list of models that the search leaves. Choosing one replaces the material by the one of that model looked at
    /// before, or by the model's defaults.
    pub fn show(&mut self, ui: &mut Ui, material: &mut Material) {
        let field = TextEdit::singleline(&mut self.search)
            .hint_text("Search models")
            .desired_width(f32::INFINITY);
        let field = ui
            .add(field)
            .on_hover_text("Find a model by name, id, category or author");
        ui.ctx()
            .accesskit_node_builder(field.id, |node| node.set_label("Search models"));
        let wanted = self.search.trim().to_lowercase();
        let height = LIST_SHARE * ui.available_height();
        let area = ScrollArea::vertical()
            .id_salt("models")
            .max_height(height)
            .auto_shrink([false, true]);
        area.show(ui, |ui| self.list(ui, &wanted, material));
    }

    fn list(&mut self, ui: &mut Ui, wanted: &str, material: &mut Material) {
        let mut is_empty = true;
        for category in Category::ALL {
            let is_listed =
                |model: &&ModelSpec| model.category() == category && is_found(model, wanted);
            let models: Vec<&'static ModelSpec> = MODELS.into_iter().filter(is_listed).collect();
            if models.is_empty() {
                continue;
            }
            is_empty = false;
            ui.label(RichText::new(category.title()).strong())
                .on_hover_text(category.meaning());
            ui.indent(category.id(), |ui| {
                for model in models {
                    self.row(ui, model, material);
                }
            });
        }
        if is_empty {
            ui.weak("No model has this name, category or author");
        }
    }

    fn row(&mut self, ui: &mut Ui, model: &'static ModelSpec, material: &mut Material) {
        let is_chosen = material
            .only()
            .is_some_and(|only| only.model().id == model.id);
        let hint = format!(
            "{}\n\n{}\n\nR: reflects, T: transmits",
            model.summary, model.source
        );
        let row = ui
            .selectable_label(is_chosen, title(model))
            .on_hover_text(hint);
        if is_chosen && self.scrolled_to != model.id {
            self.scrolled_to = model.id;
            row.scroll_to_me(None);
        }
        if row.clicked() && !is_chosen {
            let kept = self
                .shelf
                .iter()
                .position(|kept| kept.only().is_some_and(|only| only.model().id == model.id));
            let next = kept.map_or_else(
                || Material::of(model),
                |index| self.shelf.swap_remove(index),
            );
            self.shelf.push(std::mem::replace(material, next));
        }
    }
}

/// Whether `wanted`, in lower case, stands somewhere in what is known of the model.
fn is_found(model: &ModelSpec, wanted: &str) -> bool {
    [
        model.title,
        model.id,
        model.category().title(),
        model.source,
    ]
    .iter()
    .any(|text| text.to_lowercase().contains(wanted))
}

/// The title, and the sides where they are not plain from it.
#[must_use]
pub fn title(model: &ModelSpec) -> String {
    let sides: Vec<&str> = [(Side::Reflection, "R"), (Side::Transmission, "T")]
        .into_iter()
        .filter(|(side, _)| model.lobes.iter().any(|lobe| lobe.side == *side))
        .map(|(_, letter)| letter)
        .collect();
    format!("{}  ({})", model.title, sides.join(" + "))
}
