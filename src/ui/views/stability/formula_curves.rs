//! Formulas compared: the errors of the textbook's form and of the core's along a parameter.

use egui::Ui;

use super::super::context::ViewContext;
use super::formulas::{Curve, outcome_in_words};
use crate::theme::{self, Dash};
use crate::widgets::chart::{Axis, Chart, Series};
use crate::widgets::draw;
use bxdf_lab::formula_comparison::{Comparison, Outcome};
use bxdf_study::views::stability::Options;

/// The errors that are drawn: an exact result stands at the lower end, one that is no number at the upper.
const ERRORS: [f64; 2] = [1e-18, 10.0];

/// Draws the curves into a room of this height.
pub(super) fn show(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    (comparison, outcomes): (&'static Comparison, &Curve),
    height: f32,
) {
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
        "Formulas compared",
        [
            Axis {
                is_logarithmic: true,
                ..Axis::linear(comparison.axis_of_curve(), comparison.range)
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
    let shown = chart.show(ui, Some(height), cx.palette);
    cx.lacks(shown.lacking());
    if let Some(pointer) = shown.response.hover_pos() {
        let [x, _] = chart.value_at(&shown, pointer);
        if let Some((x, outcome)) = nearest(outcomes, x) {
            let text = outcome_in_words(comparison, *x, outcome);
            draw::pointer_note(ui, pointer, shown.frame(), &text, cx.palette);
        }
    }
}

/// The value nearest to `x` that was tried, by their ratio: they run evenly over decades.
fn nearest(outcomes: &Curve, x: f64) -> Option<&(f64, Outcome)> {
    let distance = |tried: f64| (tried / x).ln().abs();
    outcomes
        .iter()
        .min_by(|(a, _), (b, _)| distance(*a).total_cmp(&distance(*b)))
}
