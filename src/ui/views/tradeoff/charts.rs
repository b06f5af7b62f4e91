//! The charts, one for each question, side by side or one above the other; they share the errors upwards and the tolerance.

use egui::{RichText, Ui};

use super::super::context::ViewContext;
use super::plot;
use crate::theme;
use crate::widgets::choice;
use bxdf_lab::tradeoff::{FamilyReport, Question, Report};
use bxdf_study::views::tradeoff::Options;

/// A room this many times as wide as high has the charts side by side.
const WIDE: f32 = 1.3;

/// A narrower room has them one above the other, in points: legends and axes would fill it.
const NARROW: f32 = 440.0;

/// Draws the charts that have points into the room left.
pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, report: &Report) {
    let families = |question: Question| -> Vec<&FamilyReport> {
        let all = report.families.iter();
        let of_it = all.filter(|family| family.cost_unit.question() == question);
        of_it.filter(|family| !family.points.is_empty()).collect()
    };
    let asked = Question::ALL.map(|question| (question, families(question)));
    let asked: Vec<_> = asked.iter().filter(|(_, some)| !some.is_empty()).collect();
    let errors = plot::errors(report, cx.options.tolerance);
    let (room, gap) = (ui.available_size(), ui.spacing().item_spacing);
    let columns = if room.x > WIDE * room.y && room.x > NARROW {
        asked.len()
    } else {
        1
    }
    .max(1);
    let rows = asked.len().div_ceil(columns).max(1);
    let width = (room.x - gap.x * (columns - 1) as f32) / columns as f32;
    let height = room.y / rows as f32;
    for row in asked.chunks(columns) {
        let top = ui.cursor().top();
        ui.horizontal_top(|ui| {
            for (question, families) in row {
                ui.vertical(|ui| {
                    ui.set_width(width);
                    names(ui, cx, *question, families);
                });
            }
        });
        let left = height - (ui.cursor().top() - top) - gap.y;
        ui.horizontal_top(|ui| {
            for (question, families) in row {
                ui.push_id(question.title(), |ui| {
                    ui.vertical(|ui| {
                        ui.set_width(width);
                        plot::show(ui, cx, report, (*question, families), (&errors, left));
                    });
                });
            }
        });
    }
}

/// The question, and the families with their marks.
fn names(
    ui: &mut Ui,
    cx: &ViewContext<'_, Options>,
    question: Question,
    families: &[&FamilyReport],
) {
    ui.horizontal_wrapped(|ui| {
        let spacing = ui.spacing_mut();
        (spacing.item_spacing.y, spacing.interact_size.y) = (0.0, theme::LEGEND_ROW);
        ui.label(RichText::new(question.title()).small().strong());
        for family in families {
            let style = egui::TextStyle::Small;
            let width = choice::width_of(ui, family.title, &style) + theme::LINE_SAMPLE;
            choice::keep_together(ui, width);
            ui.horizontal(|ui| {
                plot::sample(ui, family.id, cx.palette);
                let hint = format!("Held against: {}", family.reference);
                let name = ui.label(RichText::new(family.title).small());
                name.on_hover_text(hint);
            });
        }
    });
}
