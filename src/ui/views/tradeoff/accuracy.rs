//! Before anything is measured: how far choices are off, which is the same on every machine.

use egui::{Grid, RichText, ScrollArea, Ui};

use super::super::context::ViewContext;
use super::plot;
use crate::widgets::{draw, still};
use bxdf_lab::tradeoff::{FamilyReport, Point};
use bxdf_study::views::tradeoff::{Options, accuracy};

/// What there is to be done.
const MEASURE: &str = "Press Measure: every choice a renderer has for this material is tried on this machine, some seconds long";

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    if cx.state.is_picture {
        draw::centred_note(ui, MEASURE);
        return;
    }
    let query = accuracy(cx.session);
    let selected = cx.session.materials.selected();
    let report = cx.answers.of_material(selected, query);
    let families = report.iter().flat_map(|report| &report.families);
    let wanted = |family: &&FamilyReport| cx.options.wants(family.id) && !family.points.is_empty();
    let families: Vec<&FamilyReport> = families.filter(wanted).collect();
    if families.is_empty() {
        draw::centred_note(ui, MEASURE);
        return;
    }
    still::scroll(ui, ScrollArea::vertical().id_salt("accuracy"), |ui| {
        ui.label(MEASURE);
        ui.label(RichText::new("How far its choices are off needs no clock:").strong());
        for family in families {
            ui.separator();
            let title = ui.label(RichText::new(family.title).small().strong());
            title.on_hover_text(format!("Held against: {}", family.reference));
            let mut points: Vec<&Point> = family.points.iter().collect();
            points.sort_by(|a, b| a.error_rms.total_cmp(&b.error_rms));
            Grid::new(family.id).num_columns(2).show(ui, |ui| {
                for point in points {
                    ui.label(point.name());
                    ui.label(format!("error {}", plot::error(point.error_rms)));
                    ui.end_row();
                }
            });
        }
    });
}
