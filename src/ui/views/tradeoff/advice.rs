//! The answer: the cheapest choice within the tolerance.

use egui::{RichText, ScrollArea, Ui};

use super::super::context::ViewContext;
use super::chosen::choose;
use super::plot;
use crate::widgets::{small, still};
use bxdf::Material;
use bxdf_lab::tradeoff::{Advice, Point, Report, WHOLE, advise};
use bxdf_study::export::Format;
use bxdf_study::format;
use bxdf_study::views::tradeoff::Options;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, report: &Report) {
    let tolerance = cx.options.tolerance;
    let mut advice = advise(report, tolerance);
    // The answer for the material as a whole comes first.
    advice.sort_by_key(|one| one.family != WHOLE);
    still::scroll(ui, ScrollArea::vertical().id_salt("advice"), |ui| {
        let heading = format!("Cheapest within {}", format::share(tolerance));
        ui.label(RichText::new(heading).strong());
        for one in &advice {
            ui.separator();
            entry(ui, cx, report, one);
        }
    });
}

/// One answer, with a button where the choice is a material.
fn entry(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, report: &Report, advice: &Advice) {
    let title = if advice.family == WHOLE {
        "The material as a whole"
    } else {
        let family = report
            .families
            .iter()
            .find(|family| family.id == advice.family);
        family.map_or(advice.family, |family| family.title)
    };
    ui.label(RichText::new(title).small().strong());
    if !advice.met {
        let text = RichText::new("Nothing comes that close; the nearest is").small();
        ui.label(text.color(cx.palette.warning));
    }
    let n = advice.n.map_or(String::new(), |n| format!(", {n}"));
    ui.label(format!("{}{n}", advice.choice));
    let numbers = format!(
        "{}, error {}",
        plot::duration(advice.cost_ns),
        plot::error(advice.error_rms)
    );
    ui.label(RichText::new(numbers).small());
    if let Some(lost) = &advice.lost {
        ui.label(RichText::new(format!("lost: {lost}")).small().weak());
    }
    if let Some(material) = &advice.material {
        use_or_save(ui, cx, report, material);
    }
}

/// The button that makes a choice a material of the list, or saves it once it is the selected one; none for what was measured.
pub(super) fn use_or_save(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    report: &Report,
    material: &Material,
) {
    if *material == report.material || cx.state.is_picture {
        return;
    }
    if cx.session.material().components() == material.components() {
        let hint = "Save the selected material to a file";
        if ui
            .add(small::button(ui, "Save it…"))
            .on_hover_text(hint)
            .clicked()
        {
            cx.state.wished_file = Some((cx.view, Format::Toml));
        }
        return;
    }
    let hint = "Add it to the list of materials, next to the one measured";
    if ui
        .add(small::button(ui, "Use it"))
        .on_hover_text(hint)
        .clicked()
    {
        let mut points = report.families.iter().flat_map(|family| &family.points);
        let of_it = |point: &&Point| point.material.as_ref() == Some(material);
        if let Some(point) = points.find(of_it) {
            choose(cx, point, &report.material);
        }
    }
}
