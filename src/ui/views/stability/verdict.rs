//! The answer in a sentence: which precision is safe for the material, and how bad the worst of it is, where.

use std::borrow::Cow;

use egui::{RichText, Ui};
use glam::DVec3;

use super::super::context::ViewContext;
use bxdf::math::frame;
use bxdf_lab::stability::{Extreme, Ranking, Worst};
use bxdf_study::format;
use bxdf_study::views::stability::Options;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let selected = cx.session.materials.selected();
    if selected.material.is_delta_only() {
        ui.label(DELTAS);
        return;
    }
    let found = cx.answers.ask(cx.session, selected, Ranking);
    let (text, is_safe) = sentence(&found);
    let text = RichText::new(text);
    ui.label(if is_safe {
        text
    } else {
        text.color(cx.palette.warning)
    });
}

/// Where no number can be off.
const DELTAS: &str = "No digit is lost here: a Dirac delta has a direction and a share of the flux, and no value to be off";

/// The precisions, the cheaper one first.
const PRECISIONS: [&str; 2] = ["f32", "f64"];

/// The verdict on what was found, and whether f32 is safe.
fn sentence(found: &[Extreme]) -> (Cow<'static, str>, bool) {
    if found.is_empty() {
        return ("Going to the extremes of directions …".into(), true);
    }
    let [single, double] = PRECISIONS.map(|precision| {
        let own = found
            .iter()
            .filter(|extreme| extreme.precision == precision);
        own.collect::<Vec<_>>()
    });
    let is_safe = |found: &[&Extreme]| found.iter().all(|extreme| extreme.is_stable());
    let text = match (is_safe(&single), is_safe(&double)) {
        (true, true) => format!("f32 is safe: {}", worst(&single)),
        (true, false) => format!("f32 is safe, f64 is not: in f64 {}", worst(&double)),
        (false, true) => format!("f32 is not safe, f64 is: in f32 {}", worst(&single)),
        (false, false) => format!("Neither f32 nor f64 is safe: in f64 {}", worst(&double)),
    };
    (text.into(), is_safe(&single))
}

/// How bad the worst of `found` is, and where.
fn worst(found: &[&Extreme]) -> String {
    let faults: u64 = found.iter().map(|extreme| extreme.faults()).sum();
    if faults > 0 {
        let points: u64 = found.iter().map(|extreme| extreme.n).sum();
        let first = found.iter().find(|extreme| extreme.faults() > 0);
        let at = first.and_then(|extreme| extreme.worst.as_ref());
        let at = at.map_or(String::new(), |at| {
            format!(", first {}, {}", at.what, place(at))
        });
        return format!("{faults} of {points} results are not finite, negative or misplaced{at}");
    }
    let largest = found
        .iter()
        .max_by(|a, b| a.max_bound_ratio.total_cmp(&b.max_bound_ratio));
    let at = largest.and_then(|extreme| extreme.worst.as_ref());
    let ratio = largest.map_or(0.0, |extreme| extreme.max_bound_ratio);
    match at {
        Some(at) if ratio > 0.0 => {
            format!("the worst error is {}, {}", of_explained(ratio), place(at))
        }
        _ => "no result is off at all".to_owned(),
    }
}

/// A share of what the stability law allows.
pub(super) fn of_explained(ratio: f64) -> String {
    if ratio <= 1.0 {
        format!("{} of what rounding explains", format::share(ratio))
    } else {
        let times = format::value(ratio);
        format!("{times} times what rounding explains")
    }
}

fn place(at: &Worst) -> String {
    pair_in_words(at.wo, at.wi)
}

/// Where the light and the viewer stand.
fn pair_in_words(wo: DVec3, wi: DVec3) -> String {
    let [light, viewer] = [wi, wo].map(|w| format::degrees(frame::theta(w).to_degrees()));
    format!("with the light at {light} and the viewer at {viewer}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf_lab::stability::ExtremeKind;

    fn extreme(precision: &'static str, ratio: f64, faults: u64) -> Extreme {
        Extreme {
            case: ExtremeKind::Grazing,
            precision,
            n: 100,
            non_finite: faults,
            negative: 0,
            misplaced: 0,
            max_rel_error: 0.1,
            max_bound_ratio: ratio,
            allowed_ratio: 1.0,
            max_weight: None,
            worst: Some(Worst {
                params: String::new(),
                wo: DVec3::Z,
                wi: DVec3::X,
                what: "not finite".to_owned(),
            }),
        }
    }

    #[test]
    fn the_verdict_says_what_how_much_and_where() {
        let said = |found: &[Extreme]| sentence(found).0.replace('\u{a0}', " ");
        let safe = [extreme("f32", 0.1, 0), extreme("f32", 0.223, 0)];
        assert_eq!(
            said(&safe),
            "f32 is safe: the worst error is 22 % of what rounding explains, with the light at 90° and the viewer at 0°"
        );
        let lost = [extreme("f32", 3.5, 0), extreme("f64", 0.2, 0)];
        assert_eq!(
            said(&lost),
            "f32 is not safe, f64 is: in f32 the worst error is 3.5 times what rounding explains, with the light at 90° and the viewer at 0°"
        );
        let broken = [extreme("f32", 0.1, 3), extreme("f64", 0.2, 1)];
        assert_eq!(
            said(&broken),
            "Neither f32 nor f64 is safe: in f64 1 of 100 results are not finite, negative or misplaced, first not finite, with the light at 90° and the viewer at 0°"
        );
        assert!(said(&[]).ends_with('…') && !sentence(&lost).1);
    }
}
