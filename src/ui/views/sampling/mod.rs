//! The sampling: where `sample_f` sends its samples, whether they follow the density, and what they are worth.

use egui::Ui;

use super::context::ViewContext;
use super::settings;
use crate::widgets::number::Number;
use crate::widgets::{choice, draw};
use bxdf_study::views::sampling::{Options, Plot, SAMPLES_LOG2, SEED};

mod charts;
mod discs;
mod studies;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, |ui, cx| controls(ui, cx.options));
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
        let hint = "Which part of sampling is shown";
        choice::choice(
            ui,
            ("Show", hint),
            &mut options.plot,
            Plot::ALL,
            Plot::title,
        );
        let hint = "How many samples are drawn: a power of 2";
        let log2 = &mut options.count_log2;
        choice::power_of_two(ui, ("Samples", hint), log2, &SAMPLES_LOG2);
        let hint = "Other random numbers";
        let mut seed = f64::from(options.seed);
        let number = Number::new("Seed", SEED).speed(0.25);
        choice::number(ui, ("Seed", hint), &number, &mut seed);
        options.seed = seed as u32;
        let hint = "On the dome, from the same viewpoint as the 3D lobe";
        choice::switch_if(
            options.plot.shows_directions(),
            ui,
            ("Dome", hint),
            &mut options.is_dome,
        );
    });
}
