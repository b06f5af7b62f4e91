//! The answers in a sentence each: the cheapest choice within the tolerance, what it saves, and how far it is off, where.

use egui::{RichText, Ui};

use super::super::context::ViewContext;
use super::advice;
use super::plot::duration;
use bxdf::math::frame;
use bxdf_lab::tradeoff::{FAMILIES, Point, Question, Report, Verdict, verdict};
use bxdf_study::format;
use bxdf_study::views::tradeoff::Options;

pub(super) fn show(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    report: &Report,
    (is_awaited, has_list): (bool, bool),
) {
    for question in Question::ALL {
        let Some(text) = sentence(cx.options, report, question, is_awaited) else {
            continue;
        };
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            ui.label(RichText::new(format!("{}:", question.title())).strong());
            ui.label(text);
            let found = verdict(report, question, cx.options.tolerance);
            // Where there is no list of advice, what is advised is used from here.
            if !has_list && let Some(material) = found.and_then(|found| found.chosen.material) {
                advice::use_or_save(ui, cx, report, &material);
            }
        });
    }
}

/// The answer to `question`; `None` where nothing of it is wanted.
fn sentence(
    options: &Options,
    report: &Report,
    question: Question,
    is_awaited: bool,
) -> Option<String> {
    let mut of_it = FAMILIES
        .iter()
        .filter(|family| family.cost_unit().question() == question);
    if !of_it.any(|family| options.wants(family.id())) {
        return None;
    }
    if let Some(found) = verdict(report, question, options.tolerance) {
        return Some(in_words(
            &found,
            (report, question),
            options.tolerance,
            is_awaited,
        ));
    }
    let families = report.families.iter();
    let mut of_it = families.filter(|family| family.cost_unit.question() == question);
    let reason = of_it.find_map(|family| family.not_applicable.as_deref());
    let text = match reason {
        _ if is_awaited => "nothing is measured yet".to_owned(),
        Some(reason) => format!("nothing to choose, because {reason}"),
        None => "nothing was measured".to_owned(),
    };
    Some(text)
}

fn in_words(
    found: &Verdict,
    (report, question): (&Report, Question),
    tolerance: f64,
    is_awaited: bool,
) -> String {
    let so_far = if is_awaited { "so far " } else { "" };
    let (chosen, within) = (&found.chosen, format::share(tolerance));
    let (name, cost) = (chosen.name(), duration(chosen.cost_ns));
    let off = off(chosen, report, question);
    if !found.is_met {
        return format!(
            "{so_far}nothing comes within {within}; “{name}” is nearest at {cost}, {off}"
        );
    }
    let saved = match &found.instead {
        Some(instead) => saved(chosen, instead),
        None => format!("takes {cost}, and nothing cheaper comes as near"),
    };
    format!("{so_far}cheapest within {within}: “{name}” {saved}, {off}")
}

/// From so many times the cost on it is said how many times, rather than what share is saved.
const TIMES: f64 = 10.0;

/// What is saved with a choice in place of `instead`.
fn saved(chosen: &Point, instead: &Point) -> String {
    let [cost, other] = [chosen, instead].map(|point| duration(point.cost_ns));
    let (name, times) = (instead.name(), instead.cost_ns / chosen.cost_ns);
    if times < TIMES {
        let share = format::share(1.0 - 1.0 / times);
        format!("saves {share} ({cost} for {other} of “{name}”)")
    } else {
        let times = format::value(format::two_digits(times));
        format!("is {times} times as fast as “{name}” ({cost} for {other})")
    }
}

/// How far a choice is off at most, and where.
fn off(chosen: &Point, report: &Report, question: Question) -> String {
    let most = chosen.error_max.unwrap_or(chosen.error_rms);
    if most == 0.0 {
        return "without any error".to_owned();
    }
    let how = match chosen.error_max {
        Some(_) => "wrong by at most",
        None => "wrong by",
    };
    let angle = |w| format::degrees(frame::theta(w).to_degrees());
    let place = match (chosen.worst, question) {
        (Some(worst), _) => format!(
            ", with the light at {} and the viewer at {}",
            angle(worst.wi),
            angle(worst.wo)
        ),
        (None, Question::Integrate) => format!(", with the viewer at {}", angle(report.held)),
        (None, Question::Evaluate) => String::new(),
    };
    format!("{how} {}{place}", format::share(most))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Material;
    use bxdf_lab::tradeoff::Pair;
    use glam::DVec3;

    fn point(choice: &str, cost_ns: f64, error: f64) -> Point {
        Point {
            choice: choice.to_owned(),
            n: None,
            cost_ns,
            cost_spread_ns: [cost_ns; 2],
            bytes: None,
            error_rms: error,
            error_rms_f32: None,
            error_max: Some(4.0 * error),
            worst: None,
            albedo_error: None,
            delta_e: None,
            pareto: true,
            lost: None,
            material: None,
        }
    }

    fn said(found: &Verdict, question: Question, is_awaited: bool) -> String {
        let report = Report {
            material: "phong".parse::<Material>().unwrap(),
            held: frame::direction_from_degrees(45.0, 0.0),
            families: Vec::new(),
        };
        in_words(found, (&report, question), 0.01, is_awaited).replace('\u{a0}', " ")
    }

    #[test]
    fn the_verdict_says_what_is_saved_and_how_far_it_is_off_where() {
        let mut found = Verdict {
            chosen: Point {
                worst: Some(Pair {
                    wo: DVec3::X,
                    wi: DVec3::Z,
                }),
                ..point("Schlick", 20.0, 0.01)
            },
            is_met: true,
            instead: Some(point("f64", 40.0, 0.0)),
        };
        assert_eq!(
            said(&found, Question::Evaluate, false),
            "cheapest within 1 %: “Schlick” saves 50 % (20 ns for 40 ns of “f64”), wrong by at most 4 %, with the light at 0° and the viewer at 90°"
        );
        found.instead = Some(point("plain", 900.0, 0.0));
        found.chosen.worst = None;
        let text = said(&found, Question::Integrate, true);
        assert!(text.starts_with("so far cheapest within 1 %: “Schlick” is 45 times as fast as"));
        assert!(text.ends_with("wrong by at most 4 %, with the viewer at 45°"));
        found.is_met = false;
        let text = said(&found, Question::Evaluate, false);
        assert!(text.starts_with("nothing comes within 1 %; “Schlick” is nearest at 20 ns"));
        found.chosen.error_max = Some(0.0);
        assert!(said(&found, Question::Evaluate, false).ends_with("without any error"));
    }
}
