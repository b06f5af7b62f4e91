//! The sliders of pinned parameters, each in one line.

use std::collections::BTreeSet;

use egui::Ui;

use super::row::{self, Place};
use crate::theme;
use crate::widgets::choice::width_of;
use bxdf::Material;
use bxdf::param::ParamSpec;
use bxdf_study::parameters::label;

/// A parameter that is pinned.
#[derive(Clone, Copy)]
pub struct Pinned {
    spec: &'static ParamSpec,
    /// The index of its lobe.
    lobe: usize,
    /// The number of the lobe among several, from 1.
    ordinal: Option<usize>,
}

/// The parameters of `material` that have one of these names and an effect, lobe by lobe.
#[must_use]
pub fn all(material: &Material, names: &BTreeSet<String>) -> Vec<Pinned> {
    let is_only = material.only().is_some();
    let lobes = material.components().iter().enumerate();
    lobes
        .flat_map(|(lobe, component)| {
            let params = component.params();
            let specs = component.model().parameters.iter();
            let pinned =
                specs.filter(move |spec| names.contains(spec.name) && params.is_relevant(spec));
            pinned.map(move |spec| Pinned {
                spec,
                lobe,
                ordinal: (!is_only).then_some(lobe + 1),
            })
        })
        .collect()
}

impl Pinned {
    fn title(&self) -> String {
        super::words::accessible(&label(self.spec), self.ordinal)
    }

    /// The room that it takes beside a slider of this width, in points.
    #[must_use]
    pub fn width(&self, ui: &Ui, rail: f32) -> f32 {
        let gap = ui.spacing().item_spacing.x;
        let name = width_of(ui, &self.title(), &egui::TextStyle::Body);
        name + rail + theme::NUMBER_WIDTH + 3.0 * gap
    }

    /// Its name, its slider and its number in a line; they change `material`.
    pub fn show(&self, ui: &mut Ui, material: &mut Material, rail: f32) {
        let mut components = material.components().to_vec();
        let Some(component) = components.get_mut(self.lobe) else {
            return;
        };
        let place = Place {
            spec: self.spec,
            ordinal: self.ordinal,
        };
        row::in_line(ui, component, place, (&self.title(), rail));
        if components != material.components()
            && let Ok(changed) = material.with_components(components)
        {
            *material = changed;
        }
    }
}
