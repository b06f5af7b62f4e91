//! The reflectance over the angle of incidence, with its parts.

use egui::{RichText, Ui};

use super::context::ViewContext;
use super::settings;
use crate::theme::{self, Dash};
use crate::widgets::chart::{Axis, Band, Chart, Mark, Series};
use crate::widgets::legend::Swatch;
use crate::widgets::{choice, draw};
use bxdf::{Category, Side};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::reflectance::{Curve, LobeShare, by_kind};
use bxdf_study::format;
use bxdf_study::session::Session;
use bxdf_study::views::reflectance::{Options, Split, request};

/// A part of the light that leaves.
struct Part {
    name: String,
    category: Option<Category>,
    /// The angle in degrees, the share, its error.
    points: Vec<[f64; 3]>,
}

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::show(ui, cx, |ui, cx| controls(ui, cx.options));
    if let Some(note) = bxdf_study::export::nothing_to_show(cx.session) {
        draw::centred_note(ui, note);
        return;
    }
    let (chart, means) = chart(cx);
    match &means[..] {
        [mean] => {
            ui.label(RichText::new(mean).small().weak());
        }
        means => {
            // The lines of parts are those of the parts, whatever the material.
            let swatch = match cx.options.split {
                Split::Total => Swatch::Line,
                Split::Side | Split::Category | Split::Lobe => Swatch::Patch,
            };
            cx.legend_of_numbers(ui, swatch, means);
        }
    }
    let shown = chart.show(ui, None, cx.palette);
    cx.lacks(shown.lacking());
    let pointed = chart
        .pointed(&shown)
        .filter(|[x, _]| (0.0..=90.0).contains(x));
    let Some([x, _]) = pointed else {
        chart.mark(ui, &shown, held_angle(cx.session), (cx.palette, 1.0));
        return;
    };
    chart.read_out(
        ui,
        &shown,
        x,
        &format!("θ {}", format::degrees(x)),
        cx.palette,
    );
    if shown.response.clicked() {
        cx.session.set_theta_deg((10.0 * x).round() / 10.0);
    }
}

/// The held direction's angle from the axis of its side.
fn held_angle(session: &Session) -> f64 {
    session.theta_deg.min(180.0 - session.theta_deg)
}

fn controls(ui: &mut Ui, options: &mut Options) {
    ui.horizontal_wrapped(|ui| {
        let hint = "Into what the light that leaves is split; of several materials the parts \
            differ in the line";
        choice::choice(
            ui,
            ("Parts", hint),
            &mut options.split,
            Split::ALL,
            Split::title,
        );
        let hint = "What is missing in a white furnace: absorbed, or lost by the model; below \
            0 energy is created";
        let is_whole = options.split == Split::Total;
        choice::switch_if(is_whole, ui, ("1 - ρ", hint), &mut options.is_furnace);
    });
}

/// The chart of every material shown, and the hemispherical reflectance of each in words.
fn chart(cx: &mut ViewContext<'_, Options>) -> (Chart, Vec<String>) {
    let (session, answers, palette) = (&*cx.session, &mut *cx.answers, cx.palette);
    let options = *cx.options;
    let is_furnace = options.is_furnace && options.split == Split::Total;
    let is_overlay = session.materials.is_overlay();
    let (mut series, mut bands, mut means) = (Vec::new(), Vec::new(), Vec::new());
    for entry in session.materials.shown() {
        let curve = answers.ask(session, entry, request(session));
        let title = session.materials.title(entry);
        means.push(hemispherical(&curve));
        for (index, part) in parts(&curve, options.split).into_iter().enumerate() {
            let own = palette.material(entry.slot());
            let color = part
                .category
                .filter(|_| !is_overlay)
                .map_or(own, |kind| palette.category(kind));
            let is_total = options.split == Split::Total;
            let value = |share: f64| if is_furnace { 1.0 - share } else { share };
            series.push(Series {
                name: match (is_total, is_overlay) {
                    (true, _) => title.clone(),
                    (false, true) => format!("{title}: {}", part.name),
                    (false, false) => part.name.clone(),
                },
                color,
                dash: if is_total {
                    Dash::of(entry.slot())
                } else {
                    Dash::of_part(index)
                },
                width: theme::CURVE_WIDTH,
                lines: vec![
                    part.points
                        .iter()
                        .map(|[x, share, _]| [*x, value(*share)])
                        .collect(),
                ],
            });
            let ends = part.points.iter().map(|[x, share, error]| {
                let value = value(*share);
                [*x, value - error, value + error]
            });
            bands.push(Band {
                name: part.name,
                color,
                points: ends.collect(),
            });
        }
    }
    let values = || {
        series
            .iter()
            .flat_map(|one: &Series| one.lines.iter().flatten())
            .map(|[_, y]| *y)
    };
    let least = values().fold(0.0, f64::min);
    let highest = values().fold(1.0, f64::max);
    let x = Axis::degrees("θ of the light (degrees)", [0.0, 90.0]);
    let y = Axis::of_values(options.quantity(), [least, highest], None).or_short("ρ");
    let mut chart = Chart::of("Reflectance", [x, y], series);
    chart.bands = bands;
    chart.has_labels = cx.state.is_figure() && is_overlay;
    chart.has_names = options.split != Split::Total;
    let (level, name) = if is_furnace {
        (0.0, "0: nothing is lost")
    } else {
        (1.0, "1: all light leaves")
    };
    chart.levels = vec![Mark {
        name: name.to_owned(),
        at: level,
        color: palette.faint_ink,
        dash: Dash::Dashed,
    }];
    chart.marks = vec![Mark {
        name: session.held_name().to_owned(),
        at: held_angle(session),
        color: palette.held(session.hold),
        dash: Dash::Solid,
    }];
    (chart, means)
}

/// The share that leaves of light arriving from everywhere, in words.
fn hemispherical(curve: &Curve) -> String {
    let Some(mean) = &curve.hemispherical else {
        return "ρ_hh\u{a0}…".to_owned();
    };
    let [r, t] = [mean.reflection, mean.transmission].map(|rgb| Channel::Luminance.of(rgb));
    let transmitted = if t > 0.0 {
        format!(" + {} transmitted", format::value(t))
    } else {
        String::new()
    };
    format!("ρ_hh\u{a0}{}{transmitted}", format::value(r))
}

/// The parts of a curve.
fn parts(curve: &Curve, split: Split) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for row in &curve.rows {
        for (name, category, value, error) in split_shares(&row.shares, split) {
            let known = parts.iter().position(|part| part.name == name);
            let index = known.unwrap_or_else(|| {
                parts.push(Part {
                    name,
                    category,
                    points: Vec::new(),
                });
                parts.len() - 1
            });
            if let Some(part) = parts.get_mut(index) {
                part.points.push([row.theta_deg, value, error]);
            }
        }
    }
    parts
}

/// The names, categories, shares and errors of the parts at one angle.
fn split_shares(shares: &[LobeShare], split: Split) -> Vec<(String, Option<Category>, f64, f64)> {
    let side_name = |side: Side| match side {
        Side::Reflection => "reflected",
        Side::Transmission => "transmitted",
    };
    let luminance = |share: &LobeShare| Channel::Luminance.of(share.value);
    let sum = |name: &str, of: &dyn Fn(&LobeShare) -> bool| {
        let chosen = || shares.iter().filter(|share| of(share));
        let (value, error) = (
            chosen().map(luminance).sum(),
            chosen().map(|share| share.error).sum(),
        );
        (name.to_owned(), None, value, error)
    };
    let named = |share: &LobeShare| {
        let (lobe, kind) = (&share.lobe, share.lobe.category.title());
        let own = if lobe.name.is_empty() {
            String::new()
        } else {
            format!(", {}", lobe.name)
        };
        let name = format!("{kind}, {}{own}", side_name(lobe.side));
        (name, Some(lobe.category), luminance(share), share.error)
    };
    match split {
        Split::Total => vec![sum("all", &|_| true)],
        Split::Side => [Side::Reflection, Side::Transmission]
            .map(|side| sum(side_name(side), &|share| share.lobe.side == side))
            .into(),
        Split::Category => by_kind(shares).iter().map(named).collect(),
        Split::Lobe => shares.iter().map(named).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Lobe;

    #[test]
    fn parts_sum_to_the_whole() {
        let share = |lobe, value| LobeShare {
            lobe,
            value: [value; 3],
            error: 1e-5,
        };
        let shares = [
            share(Lobe::reflection(Category::Diffuse), 0.25),
            share(
                Lobe::reflection(Category::GlossySpecular).named("coat"),
                0.125,
            ),
            share(Lobe::transmission(Category::Diffuse), 0.5),
        ];
        for split in Split::ALL {
            let parts = split_shares(&shares, *split);
            let sum: f64 = parts.iter().map(|(_, _, value, _)| value).sum();
            assert!((sum - 0.875).abs() < 1e-12, "{split:?}");
        }
        assert_eq!(split_shares(&shares, Split::Side).len(), 2);
        assert_eq!(
            split_shares(&shares, Split::Lobe)[1].0,
            "Glossy specular, reflected, coat"
        );
    }
}
