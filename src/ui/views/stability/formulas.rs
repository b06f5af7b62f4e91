//! Formulas compared in words: which, how far each form is off, and why.

use egui::{RichText, Ui};

use super::plate;
use bxdf_lab::formula_comparison::{Comparison, Outcome};
use bxdf_study::format;

/// Room below the chart for the words, in points.
pub(super) const WORDS: f32 = 84.0;

/// Room for why alone.
pub(super) const BRIEF_WORDS: f32 = 36.0;

/// What is known along the parameter of a comparison.
pub(super) type Curve = Vec<(f64, Outcome)>;

/// How far both forms are off at their worst, and where.
pub(super) fn verdict(comparison: &Comparison, curve: &Curve) -> String {
    let largest = |of: &dyn Fn(&Outcome) -> f64| {
        let errors = curve.iter().map(|(x, outcome)| (*x, of(outcome)));
        errors
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or_default()
    };
    let (x, single) = largest(&|outcome| outcome.textbook[0]);
    let (_, double) = largest(&|outcome| outcome.textbook[1]);
    let [own_single, own_double] =
        [0, 1].map(|p| largest(&|outcome| plate::of(outcome.stable, p)).1);
    format!(
        "{}: in f32 the textbook's form {} ({}: {}), the core's by {} at most; in f64 it {}, the core's by {}",
        comparison.title,
        wrong(single),
        comparison.axis_of_curve(),
        format::value(x),
        format::share(own_single),
        wrong(double),
        format::share(own_double),
    )
}

/// An error in words.
fn wrong(error: f64) -> String {
    if error.is_finite() {
        format!("is wrong by up to {}", format::share(error))
    } else {
        "gives no number".to_owned()
    }
}

/// Both forms, and why one of them loses its digits; that alone where it `is_brief`.
pub(super) fn words(ui: &mut Ui, comparison: &Comparison, is_brief: bool) {
    let all = [
        ("Textbook", comparison.textbook),
        ("Core", comparison.stable),
        ("Why", comparison.why),
    ];
    for (name, text) in all.into_iter().skip(if is_brief { 2 } else { 0 }) {
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(name).small().strong());
            ui.label(RichText::new(text).small());
        });
    }
}

/// The errors of both forms where the parameter is `x`.
pub(super) fn outcome_in_words(comparison: &Comparison, x: f64, outcome: &Outcome) -> String {
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
