//! A chart: error over cost, both logarithmic.

use std::fmt::Write as _;

use egui::{Rect, Sense, Ui, vec2};

use super::super::context::ViewContext;
use super::chosen::{Chosen, choose, look};
use crate::theme::{self, Dash, Palette};
use crate::widgets::chart::{Axis, Chart, Dots, Mark, Series, Shown};
use crate::widgets::{draw, handle};
use bxdf_lab::tradeoff::{FamilyReport, Point, Question, Report};
use bxdf_study::format;
use bxdf_study::views::tradeoff::{Options, TOLERANCE};

/// Where an error of exactly 0 is drawn.
const ZERO: f64 = 1e-16;

/// The radius of a mark in points, and of one that nothing beats.
const RADIUS: f32 = 2.2;
const FRONT_RADIUS: f32 = 4.0;

/// The points of a family that are drawn, in the order of the dots.
struct Drawn<'a> {
    family: &'a FamilyReport,
    points: Vec<(usize, &'a Point)>,
}

/// Draws the chart of `families`, which answer one question, over these errors and of this height.
pub(super) fn show(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    report: &Report,
    (question, families): (Question, &[&FamilyReport]),
    (errors, height): (&Axis, f32),
) {
    let (mut drawn, mut dots, mut series) = (Vec::new(), Vec::new(), Vec::new());
    for family in families.iter().copied() {
        let (color, shape) = look(family.id, cx.palette);
        for is_front in [false, true] {
            let numbered = family.points.iter().enumerate();
            let points: Vec<_> = numbered
                .filter(|(_, point)| point.pareto == is_front)
                .collect();
            dots.push(Dots {
                name: family.title.to_owned(),
                color,
                shape,
                radius: if is_front { FRONT_RADIUS } else { RADIUS },
                is_filled: is_front,
                points: points.iter().map(|(_, point)| place(point)).collect(),
            });
            drawn.push(Drawn { family, points });
        }
        series.push(Series {
            name: family.title.to_owned(),
            color,
            dash: Dash::Solid,
            width: theme::FRONT_WIDTH,
            lines: vec![front(family)],
        });
    }
    let places: Vec<[f64; 2]> = dots
        .iter()
        .flat_map(|dots| dots.points.iter().copied())
        .collect();
    let tolerance = cx.options.tolerance;
    let axes = [costs(&places, question), errors.clone()];
    let mut chart = Chart::of(question.title(), axes, series);
    chart.dots = dots;
    chart.levels.push(Mark {
        name: format!("tolerance {}", format::share(tolerance)),
        at: tolerance,
        color: cx.palette.ink,
        dash: Dash::Dashed,
    });
    if places.iter().any(|[_, error]| *error <= ZERO) {
        chart.levels.push(Mark {
            name: "no error at all".to_owned(),
            at: ZERO,
            color: cx.palette.axis,
            dash: Dash::Dotted,
        });
    }
    let shown = chart.show(ui, Some(height), cx.palette);
    cx.lacks(shown.lacking());
    if !cx.state.is_picture {
        drag_tolerance(ui, cx, question, (&chart, &shown));
    }
    if let Some((family, index)) = *cx.state.own::<Chosen>(cx.view) {
        let chosen = families.iter().find(|one| one.id == family);
        if let Some(point) = chosen.and_then(|family| family.points.get(index)) {
            let at = chart.position_of(&shown, place(point));
            ui.painter_at(shown.frame())
                .circle_stroke(at, 8.0, (1.5, cx.palette.ink));
        }
    }
    let Some([kind, index]) = chart.pointed_dot(&shown) else {
        return;
    };
    let found = drawn.get(kind).and_then(|drawn| {
        let (number, point) = drawn.points.get(index)?;
        Some((drawn.family, *number, *point))
    });
    let Some((family, number, point)) = found else {
        return;
    };
    if let Some(pointer) = shown.response.hover_pos() {
        draw::pointer_note(
            ui,
            pointer,
            shown.frame(),
            &read_out(family, point),
            cx.palette,
        );
    }
    if shown.response.clicked() {
        *cx.state.own::<Chosen>(cx.view) = Some((family.id, number));
        choose(cx, point, &report.material);
    }
}

/// Cost and error, as they are drawn.
fn place(point: &Point) -> [f64; 2] {
    [point.cost_ns, point.error_rms.max(ZERO)]
}

/// The Pareto front as a line of steps.
fn front(family: &FamilyReport) -> Vec<[f64; 2]> {
    let best = family.points.iter().filter(|point| point.pareto);
    let mut best: Vec<[f64; 2]> = best.map(place).collect();
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut steps: Vec<[f64; 2]> = Vec::with_capacity(2 * best.len());
    for [cost, error] in best {
        if let Some([_, before]) = steps.last().copied() {
            steps.push([cost, before]);
        }
        steps.push([cost, error]);
    }
    steps
}

/// A logarithmic axis from `least` or above that holds all values that can stand on it, to whole decades.
fn axis(name: &str, values: impl Iterator<Item = f64>, least: f64) -> Axis {
    let (low, high) = values
        .filter(|x| x.is_finite() && *x > 0.0)
        .fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
    let range = if low > high {
        [1.0, 1e3]
    } else {
        let down = 10_f64.powf((0.9 * low).log10().floor()).max(least);
        [down, 10_f64.powf((1.1 * high).log10().ceil())]
    };
    Axis {
        is_logarithmic: true,
        ..Axis::linear(name, range)
    }
}

/// The axis of the costs of `places`.
fn costs(places: &[[f64; 2]], question: Question) -> Axis {
    let name = match question {
        Question::Evaluate => "cost of one value (ns)",
        Question::Integrate => "cost of one integral (ns)",
    };
    axis(name, places.iter().map(|[cost, _]| *cost), 1e-3)
}

/// The axis of all errors of a report and of the tolerance, which its charts share.
pub(super) fn errors(report: &Report, tolerance: f64) -> Axis {
    let points = report.families.iter().flat_map(|family| &family.points);
    let errors = points.map(|point| place(point)[1]);
    let name = "relative rms error";
    axis(name, errors.chain([tolerance]), 0.1 * ZERO)
}

/// By what factor an arrow key changes the tolerance: less would be lost where it is rounded to two digits.
const STEP: f64 = 1.125;

/// The handle at the end of the line of the tolerance.
fn drag_tolerance(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    question: Question,
    (chart, shown): (&Chart, &Shown),
) {
    let tolerance = cx.options.tolerance;
    let frame = shown.frame();
    let height = chart.position_of(shown, [1.0, tolerance]).y;
    let at = egui::pos2(frame.left() + theme::HANDLE_RADIUS, height);
    let id = ui.scope_id().with("tolerance");
    let name = match question {
        Question::Evaluate => "Line of the tolerance",
        Question::Integrate => "Line of the tolerance of integrals",
    };
    let named = (id, name, frame);
    let hint = "The largest error that is allowed. Drag it, or press Tab until it has the focus: Up and Down change it by an \
                eighth";
    let handle = handle::show(ui, at, named, hint, (cx.palette.ink, cx.palette));
    let dragged_to = handle.dragged_to().map(|place| {
        let [_, error] = chart.value_at(shown, place);
        error
    });
    let stepped = |up: f64| tolerance * STEP.powf(up.signum());
    let steps = handle.steps().filter(|steps| steps.up != 0.0);
    if let Some(error) = dragged_to.or(steps.map(|steps| stepped(steps.up))) {
        // As it is shown.
        TOLERANCE.put(&mut cx.options.tolerance, format::two_digits(error));
    }
}

/// A choice in words.
fn read_out(family: &FamilyReport, point: &Point) -> String {
    let unit = family.cost_unit.name();
    let [low, high] = point.cost_spread_ns.map(duration);
    let mut text = format!(
        "{}\n{} per {unit} [{low} to {high}]\nerror {}",
        point.name(),
        duration(point.cost_ns),
        error(point.error_rms)
    );
    // Writing to a string cannot fail.
    if let Some(max) = point.error_max.filter(|max| *max > 0.0) {
        let _ = write!(text, ", largest {}", error(max));
    }
    if let Some(bytes) = point.bytes {
        let _ = write!(text, "\n{} kB", format::value(bytes as f64 / 1024.0));
    }
    if let Some(albedo) = point.albedo_error.filter(|x| *x > 0.0) {
        let _ = write!(text, "\nreflectance off by {}", error(albedo));
    }
    if let Some(delta_e) = point.delta_e {
        let _ = write!(text, "\nΔE on the lit sphere {}", format::value(delta_e));
    }
    if let Some(lost) = &point.lost {
        let _ = write!(text, "\nlost: {lost}");
    }
    text
}

/// An error in words.
pub(super) fn error(error: f64) -> String {
    if error == 0.0 {
        "0 (exact)".to_owned()
    } else {
        format::share(error)
    }
}

/// A time in words.
pub(super) fn duration(ns: f64) -> String {
    let (value, unit) = match ns {
        ns if ns < 1e3 => (ns, "ns"),
        ns if ns < 1e6 => (ns * 1e-3, "µs"),
        ns if ns < 1e9 => (ns * 1e-6, "ms"),
        ns => (ns * 1e-9, "s"),
    };
    format!("{} {unit}", format::value(value))
}

/// The mark of the family of this id.
pub(super) fn sample(ui: &mut Ui, id: &str, palette: &Palette) {
    let (color, shape) = look(id, palette);
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, theme::LEGEND_ROW), Sense::hover());
    let mark = Rect::from_center_size(rect.center(), vec2(7.0, 7.0));
    draw::marker(ui.painter(), mark, shape, color);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_end_at_decades_and_hold_what_stands_on_them() {
        let cost = costs(&[[3.0, 0.5], [4000.0, 1e-16]], Question::Evaluate);
        assert_eq!(cost.range, [1.0, 1e4]);
        let error = axis("", [0.5, 1e-16].into_iter(), 0.1 * ZERO);
        assert!(error.range[0] <= 1e-16 && error.range[1] >= 0.5);
        assert!(costs(&[], Question::Integrate).range[1] > 1.0);
    }

    #[test]
    fn times_and_errors_are_words() {
        assert_eq!(duration(2.5), "2.5 ns");
        assert_eq!(duration(2.5e4), "25 µs");
        assert_eq!(error(0.0), "0 (exact)");
    }
}
