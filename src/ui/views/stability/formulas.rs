//! Formulas compared: the errors of the textbook's form and of the core's along a parameter.

use egui::{RichText, Ui};

use super::super::context::ViewContext;
use crate::theme::{self, Dash};
use crate::widgets::chart::{Axis, Chart, Series};
use crate::widgets::draw;
use bxdf_lab::formula_comparison::{COMPARISONS, Comparison, Outcome};
use bxdf_study::format;
use bxdf_study::views::stability::Options;

/// Values tried along the parameter.
const COUNT: usize = 240;

/// The errors that are drawn: an exact result stands at the lower end, one that is no number at the upper.
const ERRORS: [f64; 2] = [1e-18, 10.0];

/// Room below the chart for the words, in points.
const WORDS: f32 = 84.0;

/// The comparison of this id, the first where there is none.
pub(super) fn chosen(id: &str) -> &'static Comparison {
    let [first, ..] = &COMPARISONS;
    COMPARISONS
        .iter()
        .find(|comparison| comparison.id == id)
        .unwrap_or(first)
}

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let comparison = chosen(&cx.options.trial);
    let outcomes: Vec<(f64, Outcome)> = comparison.curve(COUNT).collect();
    let line = |of: &dyn Fn(&Outcome) -> f64| -> Vec<[f64; 2]> {
        let place = |(x, outcome): &(f64, Outcome)| [*x, of(outcome).clamp(ERRORS[0], ERRORS[1])];
        outcomes.iter().map(place).collect()
    };
    let [bad, good] = [cx.palette.warning, cx.palette.kept];
    let series = |name: &str, color, dash, of: &dyn Fn(&Outcome) -> f64| Series {
        name: name.to_owned(),
        color,
        dash,
        width: theme::CURVE_WIDTH,
        lines: vec![line(of)],
    };
    let mut chart = Chart::of(
        "Formulas on trial",
        [
            Axis {
                is_logarithmic: true,
                ..Axis::linear(comparison.axis, comparison.range)
            },
            Axis {
                is_logarithmic: true,
                ..Axis::linear("relative error", ERRORS)
            },
        ],
        vec![
            series("textbook, f32", bad, Dash::Solid, &|outcome| {
                outcome.textbook[0]
            }),
            series("textbook, f64", bad, Dash::Dashed, &|outcome| {
                outcome.textbook[1]
            }),
            series("core, f32", good, Dash::Solid, &|outcome| outcome.stable[0]),
            series("core, f64", good, Dash::Dashed, &|outcome| {
                outcome.stable[1]
            }),
            series("bound, f32", cx.palette.axis, Dash::Dotted, &|outcome| {
                outcome.allowed[0]
            }),
            series("bound, f64", cx.palette.axis, Dash::Dotted, &|outcome| {
                outcome.allowed[1]
            }),
        ],
    );
    chart.has_names = true;
    let height = (ui.available_height() - WORDS).max(0.6 * ui.available_height());
    let shown = chart.show(ui, Some(height), cx.palette);
    if let Some(pointer) = shown.response.hover_pos() {
        let [x, _] = chart.value_at(&shown, pointer);
        let [from, to] = comparison.range;
        let text = read_out(comparison, x.clamp(from, to));
        draw::pointer_note(ui, pointer, shown.frame(), &text, cx.palette);
    }
    for (name, text) in [
        ("Textbook", comparison.textbook),
        ("Core", comparison.stable),
        ("Why", comparison.why),
    ] {
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(name).small().strong());
            ui.label(RichText::new(text).small());
        });
    }
}

fn read_out(comparison: &Comparison, x: f64) -> String {
    let outcome = comparison.at(x);
    let line = |name: &str, of: [f64; 2]| {
        let [single, double] = of.map(format::value);
        format!("{name}: {single} in f32, {double} in f64")
    };
    format!(
        "{}: {}\n{}\n{}\n{}",
        comparison.axis,
        format::value(x),
        line("textbook", outcome.textbook),
        line("core", outcome.stable),
        line("bound", outcome.allowed)
    )
}
