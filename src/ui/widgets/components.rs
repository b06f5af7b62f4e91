//! The components of the material: what each is, its weight in a mixture, its parameters.

use egui::{RichText, Ui};

use super::params;
use crate::bxdf::{Component, Material};

/// The components of `material`, one below the other.
pub fn show(ui: &mut Ui, material: &mut Material) {
    let mut components = material.components().to_vec();
    for (index, component) in components.iter_mut().enumerate() {
        ui.push_id(index, |ui| show_one(ui, component));
    }
    if components != material.components()
        && let Ok(changed) = material.with_components(components)
    {
        *material = changed;
    }
}

fn show_one(ui: &mut Ui, component: &mut Component) {
    let model = component.model();
    ui.label(RichText::new(model.title).strong())
        .on_hover_text(model.source);
    ui.label(RichText::new(model.summary).small());
    ui.add_space(2.0);
    params::show(ui, component);
}
