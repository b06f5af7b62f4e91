//! The sampling as numbers: densities in the section, weights, estimators.

use egui::{Grid, RichText, ScrollArea, Ui};

use super::super::context;
use super::super::context::ViewContext;
use super::studies::{color_of, studies};
use crate::theme::{self, Dash};
use crate::widgets::chart::{self, Axis, Band, Chart, Series};
use crate::widgets::legend::Swatch;
use crate::widgets::{deltas as labels, draw, still};
use bxdf_lab::analysis::deltas::{self, Arrows};
use bxdf_study::format;
use bxdf_study::views::sampling::Options;

/// The density and f cos over its integral, in the section.
pub(super) fn show_curves(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    cx.legend(ui, Swatch::Patch);
    let studies = studies(cx);
    let is_overlay = studies.len() > 1;
    let mut series = Vec::new();
    for (entry, study) in &studies {
        let Some(found) = cx.session.materials.get(*entry) else {
            continue;
        };
        let title = if is_overlay {
            cx.session.materials.title(found) + " "
        } else {
            String::new()
        };
        let line =
            |name: &str, dash, of: &dyn Fn(&bxdf_lab::analysis::sampling::Density) -> f64| Series {
                name: format!("{title}{name}"),
                color: color_of(cx, *entry),
                dash,
                width: theme::CURVE_WIDTH,
                lines: vec![
                    study
                        .densities
                        .iter()
                        .map(|one| [one.angle_deg, of(one)])
                        .collect(),
                ],
            };
        series.push(line("pdf", Dash::Solid, &|one| one.pdf));
        series.push(line("f cos, over its integral", Dash::Dashed, &|one| {
            one.f_cos
        }));
    }
    series.retain(|one| one.lines.iter().any(|line| !line.is_empty()));
    let stems = delta_stems(cx);
    if series.is_empty() && stems.is_empty() {
        draw::centred_note(ui, "f is 0 all over this section");
        return;
    }
    let values = series.iter().flat_map(|one| one.lines.iter().flatten());
    let (highest, reach) = values.fold((0.0_f64, 90.0_f64), |(y, x), point| {
        (y.max(point[1]), x.max(point[0].abs()))
    });
    let reach = stems.iter().map(|stem| stem.at.abs()).fold(reach, f64::max);
    let reach = if reach > 90.5 { 180.0 } else { 90.0 };
    let x = Axis::degrees("θ of the direction drawn (degrees)", [-reach, reach]);
    let y = if highest > 0.0 {
        Axis::of_values("density (1/sr)", [0.0, highest], None)
    } else {
        Axis::of_values("probability", [0.0, 1.0], None)
    };
    let mut chart = Chart::of("Densities", [x, y], series);
    chart.stems = stems;
    chart.marks = context::section_marks(
        cx.session,
        cx.options.own_section_deg.of(cx.session),
        cx.palette,
    );
    chart.has_names = true;
    read(ui, cx, &chart, "θ ");
}

/// The deltas of the section, as high as the chance that a sample is theirs.
fn delta_stems(cx: &mut ViewContext<'_, Options>) -> Vec<chart::Stem> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let phi = cx.options.request(session).phi;
    let mut stems = Vec::new();
    for entry in session.materials.shown() {
        let arrows = answers.ask(session, entry, Arrows);
        let (title, color) = (
            session.materials.title(entry),
            cx.palette.material(entry.slot()),
        );
        stems.extend(deltas::chosen_in_section(&arrows, phi).iter().map(|stem| {
            let chance = stem.share();
            chart::Stem {
                name: format!("delta, probability {}", labels::share(chance)),
                ..context::chart_stem(stem, &title, color, context::OUTSIDE_SECTION)
            }
        }));
    }
    stems
}

/// What samples weigh, on a logarithmic axis.
pub(super) fn show_weights(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    cx.legend(ui, Swatch::Line);
    let studies = studies(cx);
    let (mut series, mut bands, mut texts) = (Vec::new(), Vec::new(), Vec::new());
    let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
    for (entry, study) in &studies {
        let Some(found) = cx.session.materials.get(*entry) else {
            continue;
        };
        let weights = &study.weights;
        let total: usize = weights.bins.iter().map(|bin| bin.count).sum();
        let mut steps = Vec::new();
        for bin in &weights.bins {
            let [low, high] = bin.log10;
            let share = bin.count as f64 / total.max(1) as f64;
            ends = [ends[0].min(low), ends[1].max(high)];
            steps.extend([[10_f64.powf(low), share], [10_f64.powf(high), share]]);
        }
        let title = cx.session.materials.title(found);
        texts.push(format!(
            "{title}  mean {}  largest {}  of weight 0 {} %",
            format::value(weights.mean),
            format::value(weights.largest),
            format::value(100.0 * weights.zeros)
        ));
        bands.push(Band {
            name: title.clone(),
            color: color_of(cx, *entry),
            points: steps.iter().map(|[x, y]| [x.log10(), 0.0, *y]).collect(),
        });
        series.push(Series {
            name: title,
            color: color_of(cx, *entry),
            dash: Dash::of(found.slot()),
            width: theme::CURVE_WIDTH,
            lines: vec![steps],
        });
    }
    if ends[0] >= ends[1] {
        draw::centred_note(ui, "No sample weighs anything");
        return;
    }
    let highest = series
        .iter()
        .flat_map(|one| one.lines.iter().flatten())
        .map(|[_, y]| *y);
    let highest = highest.fold(0.0, f64::max);
    let mut x = Axis::linear("weight f cos / pdf", ends.map(|end| 10_f64.powf(end)));
    x.is_logarithmic = true;
    let y = Axis::of_values("share of the samples", [0.0, highest], None);
    let mut chart = Chart::of("Weights", [x, y], series);
    chart.bands = bands;
    chart.has_labels = cx.state.is_figure() && studies.len() > 1;
    ui.label(RichText::new(texts.join("     ")).small().weak());
    let shown = chart.show(ui, None, cx.palette);
    cx.lacks(shown.lacking());
    if let Some([x, _]) = chart.pointed(&shown) {
        chart.read_out(
            ui,
            &shown,
            x,
            &format!("weight {}", format::value(x)),
            cx.palette,
        );
    }
}

/// Draws a chart and reads out under the pointer.
fn read(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, chart: &Chart, heading: &str) {
    let shown = chart.show(ui, None, cx.palette);
    cx.lacks(shown.lacking());
    if let Some([x, _]) = chart.pointed(&shown) {
        chart.read_out(
            ui,
            &shown,
            x,
            &format!("{heading}{}", format::degrees(x)),
            cx.palette,
        );
    }
}

/// The spread of estimates of the integral of f cos by each way of sampling.
pub(super) fn show_estimators(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let studies = studies(cx);
    let count = cx.options.request(cx.session).count;
    ui.label(format!(
        "Estimates of the integral of f cos from {count} samples each, deltas left out:"
    ));
    let area = ScrollArea::both().auto_shrink([false, false]);
    still::scroll(ui, area, |ui| {
        Grid::new("estimators")
            .striped(true)
            .spacing([16.0, 5.0])
            .show(ui, |ui| {
                for (name, meaning) in ESTIMATOR_COLUMNS {
                    ui.label(RichText::new(name).weak()).on_hover_text(meaning);
                }
                ui.end_row();
                for (entry, study) in &studies {
                    let found = cx.session.materials.get(*entry);
                    let title = found.map(|entry| cx.session.materials.title(entry));
                    let [own, ..] = &study.estimators;
                    for (index, estimator) in study.estimators.iter().enumerate() {
                        ui.horizontal(|ui| {
                            if index == 0 {
                                draw::swatch(ui, color_of(cx, *entry));
                                ui.label(title.as_deref().unwrap_or(""));
                            }
                        });
                        ui.label(estimator.name);
                        let samples_needed = estimator.variance / own.variance;
                        for number in [
                            estimator.mean,
                            estimator.standard_error,
                            estimator.variance,
                            samples_needed,
                        ] {
                            let text = if number.is_finite() {
                                format::value(number)
                            } else {
                                "-".to_owned()
                            };
                            ui.label(RichText::new(text).monospace());
                        }
                        ui.end_row();
                    }
                }
            });
    });
}

/// The columns of the estimators: name and meaning.
const ESTIMATOR_COLUMNS: [(&str, &str); 6] = [
    ("", "The material"),
    ("Sampling", "How directions are drawn"),
    ("Estimate", "The mean of the samples"),
    ("± error", "The standard error of the mean"),
    ("Variance", "The variance of one sample"),
    (
        "Samples needed",
        "How many samples reach the error of one sample drawn by the model itself",
    ),
];
