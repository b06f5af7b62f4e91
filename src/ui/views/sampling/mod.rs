//! The sampling: where `sample_f` sends its samples, whether they follow the density, and what they are worth.

use egui::Ui;

use super::context::ViewContext;
use crate::widgets::number::Number;
use crate::widgets::{choice, draw};
use bxdf_study::number::NumberSpec;
use bxdf_study::views::sampling::{Options, Plot, SAMPLES_LOG2, SEED};

mod charts;
mod discs;
mod studies;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    controls(ui, cx.options);
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    match cx.options.plot {
        Plot::Points => discs::show(ui, cx, discs::draw_points),
        Plot::Warp => discs::show(ui, cx, discs::draw_warp),
        Plot::Histogram => discs::show(ui, cx, discs::draw_histogram),
        Plot::Curves => charts::show_curves(ui, cx),
        Plot::Weights => charts::show_weights(ui, cx),
        Plot::Estimators => charts::show_estimators(ui, cx),
    }
}

fn controls(ui: &mut Ui, options: &mut Options) {
    ui.horizontal_wrapped(|ui| {
        let hint = "What of the sampling is shown";
        choice::choice(
            ui,
            ("Show", hint),
            &mut options.plot,
            Plot::ALL,
            Plot::title,
        );
        let hint = "How many samples are drawn: a power of 2";
        ui.label("Samples").on_hover_text(hint);
        samples(ui, options, hint);
        let hint = "Other random numbers";
        ui.label("Seed").on_hover_text(hint);
        let mut seed = f64::from(options.seed);
        let number = Number::new("Seed", SEED).speed(0.25);
        number.field(ui, &mut seed).on_hover_text(hint).explain(ui);
        options.seed = seed as u32;
        let hint = "On the dome, seen from where the 3D lobe is seen";
        choice::switch_if(
            options.plot.shows_directions(),
            ui,
            ("Dome", hint),
            &mut options.is_dome,
        );
    });
}

/// The number of samples: its power of 2 on the slider, the number itself in the field.
fn samples(ui: &mut Ui, options: &mut Options, hint: &str) {
    let mut log2 = f64::from(options.count_log2);
    let counts = NumberSpec::new("samples", SAMPLES_LOG2.range.map(f64::exp2)).whole();
    let is_power = |count: f64| {
        let allowed = counts.allowed();
        let problem = || format!("{count} is no power of 2; {allowed}");
        (count.log2().fract() == 0.0)
            .then_some(())
            .ok_or_else(problem)
    };
    let shown = ui.horizontal(|ui| {
        let rail = Number::new("Samples", SAMPLES_LOG2).steps(1.0, 0);
        rail.rail(ui, &mut log2);
        let mut count = log2.exp2();
        let shown = Number::new("Samples", counts)
            .check(&is_power)
            .field(ui, &mut count);
        log2 = count.log2();
        shown
    });
    let shown = shown.inner.on_hover_text(hint);
    shown.explain(ui);
    options.count_log2 = log2.round() as u8;
}
