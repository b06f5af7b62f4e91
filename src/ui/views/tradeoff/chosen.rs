//! A choice of the trade-off: how it is drawn, and what a click at it does.

use super::super::context::ViewContext;
use crate::theme::Palette;
use bxdf::Material;
use bxdf_lab::analysis::hemisphere::Comparison;
use bxdf_lab::contract::Witness;
use bxdf_lab::tradeoff::{FAMILIES, Family, Point};
use bxdf_study::cursor::Cursor;
use bxdf_study::session::{EntryId, MaterialEntry, Materials};
use bxdf_study::views::hemisphere;
use bxdf_study::views::tradeoff::Options;

/// The choice last clicked at: its family and its place there.
pub(super) type Chosen = Option<(&'static str, usize)>;

/// The colour and the mark of the family of this id: its own among those that answer the same question.
pub(super) fn look(id: &str, palette: &Palette) -> (egui::Color32, egui_plot::MarkerShape) {
    use egui_plot::MarkerShape::{Circle, Cross, Diamond, Down, Square, Up};
    let of = |family: &&dyn Family| family.cost_unit().question();
    let own = FAMILIES.into_iter().find(|family| family.id() == id);
    let mut alike = FAMILIES
        .into_iter()
        .filter(|family| own.as_ref().is_some_and(|own| of(own) == of(family)));
    let index = alike.position(|family| family.id() == id).unwrap_or(0);
    let shapes = [Circle, Square, Diamond, Up, Down, Cross];
    let shape = shapes.get(index % shapes.len()).copied().unwrap_or(Circle);
    (palette.kind(index), shape)
}

/// The entry of the list with the lobes of `material`, whatever its name.
pub(super) fn entry_of(materials: &Materials, material: &Material) -> Option<EntryId> {
    let mut entries = materials.iter();
    let is_it = |entry: &&MaterialEntry| entry.material.components() == material.components();
    entries.find(is_it).map(MaterialEntry::id)
}

/// Makes `point` a material beside the one that was measured, in every view, and shows the difference between the two, in the
/// first hemisphere, where it is largest.
pub(super) fn choose(cx: &mut ViewContext<'_, Options>, point: &Point, measured: &Material) {
    let materials = &mut cx.session.materials;
    let original = entry_of(materials, measured);
    let mut shown = original.unwrap_or_else(|| materials.selected().id());
    if let Some(material) = &point.material
        && material != measured
    {
        let mut named = material.clone();
        named.name = format!("{}: {}", measured.title(), point.choice);
        // Where there is no room for one more, the list says so itself.
        let known = entry_of(materials, material);
        if let Some(entry) = known.or_else(|| materials.add(named).ok()) {
            materials.select(entry);
            shown = entry;
        }
        if let Some(original) = original {
            materials.compare_with(original);
            let views = &mut cx.session.views;
            views.first_of(|map: &mut hemisphere::Options| map.comparison = Comparison::Difference);
        }
    }
    if let Some(worst) = point.worst {
        let witness = Witness {
            text: String::new(),
            wo: Some(worst.wo),
            wi: Some(worst.wi),
        };
        *cx.pointed = Cursor::jump(cx.session, shown, &witness);
    }
}
