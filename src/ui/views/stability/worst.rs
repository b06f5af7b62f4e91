//! The worst points of the material, the worst first: each leads there.

use egui::{RichText, ScrollArea, Ui};

use super::super::context::ViewContext;
use super::pair::go_to;
use crate::widgets::still;
use bxdf_lab::stability::{Extreme, Ranking};
use bxdf_study::format;
use bxdf_study::views::stability::Options;

/// Rows of the list.
const ROWS: usize = 12;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let selected = cx.session.materials.selected();
    let found = cx.answers.ask(cx.session, selected, Ranking);
    let hint = "Where the error uses up most of what the stability law allows for the rounding of the inputs, at \
        every extreme of directions; a click holds that pair in every view";
    ui.label(RichText::new("Worst points").strong())
        .on_hover_text(hint);
    if found.is_empty() {
        ui.label(RichText::new("going to the extremes …").small().weak());
        return;
    }
    let faults: u64 = found.iter().map(Extreme::faults).sum();
    let points: u64 = found.iter().map(|extreme| extreme.n).sum();
    let line = if faults == 0 {
        format!(
            "Errors as shares of what rounding explains; {points} points, all finite, none negative"
        )
    } else {
        format!("{faults} of {points} points are not finite, negative or misplaced")
    };
    let text = RichText::new(line).small();
    ui.label(if faults == 0 {
        text.weak()
    } else {
        text.color(cx.palette.warning)
    });
    let mut ranked: Vec<&Extreme> = found
        .iter()
        .filter(|extreme| extreme.worst.is_some())
        .collect();
    let rank = |extreme: &Extreme| (extreme.faults() > 0, extreme.max_bound_ratio);
    ranked.sort_by(|a, b| {
        rank(b)
            .partial_cmp(&rank(a))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let mut wanted = None;
    let area = ScrollArea::vertical().id_salt("worst points");
    still::scroll(ui, area, |ui| {
        for extreme in ranked.into_iter().take(ROWS) {
            let (Some(worst), case) = (&extreme.worst, extreme.case) else {
                continue;
            };
            let text = format!(
                "{}, {}: {}",
                case.title(),
                extreme.precision,
                format::share(extreme.max_bound_ratio)
            );
            let text = RichText::new(text).small();
            let text = if extreme.is_stable() {
                text
            } else {
                text.color(cx.palette.warning)
            };
            let hint = format!(
                "{}\n{} off by at most {} there; wo {}, wi {}",
                case.meaning(),
                worst.what,
                format::value(extreme.max_rel_error),
                place(worst.wo),
                place(worst.wi)
            );
            let line = if still::is(ui) {
                ui.label(text)
            } else {
                ui.selectable_label(false, text)
            };
            if line.on_hover_text(hint).clicked() {
                wanted = Some((worst.wo, worst.wi));
            }
        }
    });
    if let Some((wo, wi)) = wanted {
        go_to(cx, wo, wi);
    }
}

/// A direction by its angles.
fn place(w: glam::DVec3) -> String {
    use bxdf::math::frame;
    let [theta, phi] = [frame::theta(w), frame::phi(w)].map(f64::to_degrees);
    format!("({}, {})", format::degrees(theta), format::degrees(phi))
}
