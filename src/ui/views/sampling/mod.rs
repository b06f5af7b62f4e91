//! The sampling: where `sample_f` sends its samples, whether they follow the density, and what they are worth.

use std::sync::Arc;

use egui::{Color32, Ui};

use super::{ViewContext, ViewSpec};
use crate::analysis::sampling::Study;
use crate::ui::export::table;
use crate::ui::session::{EntryId, MaterialEntry, SAMPLE_COUNTS_LOG2, SamplingPlot, Session};
use crate::ui::widgets::{choice, draw};

mod charts;
mod discs;

/// The list entry.
pub(super) const SPEC: ViewSpec = ViewSpec {
    id: "sampling",
    title: "Sampling",
    what_you_see: "Where the sampler sends directions for the held one: good samplers follow \
        f cos and weigh all samples alike",
    show,
    table: Some(table::sampling),
    is_mesh: false,
};

fn show(ui: &mut Ui, cx: &mut ViewContext<'_>) {
    controls(ui, cx.session);
    if let Some(note) = super::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    match cx.session.views.sampling.plot {
        SamplingPlot::Points => discs::show(ui, cx, discs::draw_points),
        SamplingPlot::Warp => discs::show(ui, cx, discs::draw_warp),
        SamplingPlot::Histogram => discs::show(ui, cx, discs::draw_histogram),
        SamplingPlot::Curves => charts::show_curves(ui, cx),
        SamplingPlot::Weights => charts::show_weights(ui, cx),
        SamplingPlot::Estimators => charts::show_estimators(ui, cx),
    }
}

fn controls(ui: &mut Ui, session: &mut Session) {
    let options = &mut session.views.sampling;
    ui.horizontal_wrapped(|ui| {
        let hint = "What of the sampling is shown";
        choice::choice(
            ui,
            ("Show", hint),
            &mut options.plot,
            SamplingPlot::ALL,
            SamplingPlot::title,
        );
        let hint = "How many samples are drawn: a power of 2";
        ui.label("Samples").on_hover_text(hint);
        let slider = egui::Slider::new(&mut options.count_log2, SAMPLE_COUNTS_LOG2)
            .custom_formatter(|log2, _| format!("{}", 1_u32 << log2 as u32))
            .custom_parser(|text| text.trim().parse::<f64>().ok().map(f64::log2));
        let response = ui.add(slider).on_hover_text(hint);
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_label("Samples"));
        let hint = "Other random numbers";
        ui.label("Seed").on_hover_text(hint);
        let response = ui
            .add(egui::DragValue::new(&mut options.seed))
            .on_hover_text(hint);
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_label("Seed"));
        let hint = "On the dome, seen from where the 3D lobe is seen";
        choice::switch_if(
            options.plot.shows_directions(),
            ui,
            ("Dome", hint),
            &mut options.is_dome,
        );
    });
}

fn studies(cx: &mut ViewContext<'_>) -> Vec<(EntryId, Arc<Study>)> {
    let (session, data) = (&*cx.session, &mut *cx.data);
    let study = |entry: &MaterialEntry| {
        (
            entry.id(),
            data.ask(session, entry, session.sampling_request()),
        )
    };
    session.materials.shown().map(study).collect()
}

fn color_of(cx: &ViewContext<'_>, entry: EntryId) -> Color32 {
    let found = cx.session.materials.get(entry);
    found.map_or(cx.palette.ink, |entry| cx.palette.material(entry.slot()))
}
