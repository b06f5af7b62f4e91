//! Where the light goes: a bar of shares by category and side, with its legend.

use egui::{Color32, Grid, Painter, Rect, Role, Sense, Ui, Vec2, WidgetInfo, pos2, vec2};

use glam::DVec3;

use super::{category, covered};
use crate::theme::{self, Palette};
use bxdf::{Category, Side};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::reflectance::{LobeShare, Reflectance, by_kind, has_flux};
use bxdf_study::format;

/// A sum of shares beyond 1 that is taken for more than an error of the quadrature or of rounded parameters.
const EXCESS: f64 = 0.005;

/// What the numbers are.
const HINT: &str = "What becomes of light arriving along the fixed direction, as shares of its flux: luminance, that is R, G and B weighted as the \
     eye does";

/// A part of the bar: its name, its share and how it is filled.
struct Part {
    name: String,
    share: f64,
    color: Color32,
    category: Option<Category>,
    is_hatched: bool,
}

/// What is said where more leaves than arrives.
const CREATED: &str = "creates energy";

/// Why there are no shares: in a few words, and in whole sentences.
type Missing = [&'static str; 2];

/// Where no light arrives.
const NONE_ARRIVES: Missing = [
    "– no light arrives at θ = 90°",
    "In the surface plane cos θ is 0: no flux arrives, and shares of it are undefined. Towards 90° they have a limit, which \
     the view Reflectance shows",
];

/// Where they are not known yet.
const NOT_YET: Missing = ["…", "Computing the shares of the light"];

/// Where the light of the selected material goes, about to be shown.
pub struct Energy<'a> {
    found: Result<Reflectance, Missing>,
    parts: Vec<Part>,
    palette: &'a Palette,
}

impl<'a> Energy<'a> {
    /// Of the shares of its lobes, as they are answered for light along `wi`.
    #[must_use]
    pub fn of(wi: DVec3, shares: Option<&[LobeShare]>, palette: &'a Palette) -> Self {
        let shares = shares.filter(|_| has_flux(wi));
        let missing = if has_flux(wi) { NOT_YET } else { NONE_ARRIVES };
        Self {
            found: shares.map(Reflectance::of).ok_or(missing),
            parts: shares.map_or_else(Vec::new, |shares| parts(shares, palette)),
            palette,
        }
    }

    /// Of shares that a question asks for: nothing is shown of them.
    #[must_use]
    pub const fn covered(palette: &'a Palette) -> Self {
        Self {
            found: Err([covered::INSTEAD, covered::WHY]),
            parts: Vec::new(),
            palette,
        }
    }

    /// The bar of shares, with its legend for who points there.
    pub fn bar(&self, ui: &mut Ui) {
        bar(ui, &self.parts, self.palette).on_hover_ui(|ui| self.legend(ui));
    }

    /// The sums, and a warning where more leaves than arrives.
    pub fn words(&self, ui: &mut Ui) {
        let found = match &self.found {
            Ok(found) => found,
            Err([text, hint]) => {
                ui.weak(*text).on_hover_text(*hint);
                return;
            }
        };
        ui.label(sums(found)).on_hover_ui(|ui| self.legend(ui));
        if creates_energy(found) {
            ui.colored_label(self.palette.warning, CREATED)
                .on_hover_text(format!(
                    "More light leaves than arrives: {:.3} times as much, in the channel that gains most",
                    found.largest()
                ));
        }
    }

    /// What [`Self::words`] say, one after the other.
    #[must_use]
    pub fn texts(&self) -> Vec<String> {
        match &self.found {
            Ok(found) => {
                let warning = creates_energy(found).then(|| CREATED.to_owned());
                std::iter::once(sums(found)).chain(warning).collect()
            }
            Err([text, _]) => vec![(*text).to_owned()],
        }
    }

    fn legend(&self, ui: &mut Ui) {
        match &self.found {
            Ok(found) => legend(ui, &self.parts, found.error, self.palette),
            Err([_, hint]) => {
                ui.label(*hint);
            }
        }
    }
}

fn creates_energy(found: &Reflectance) -> bool {
    found.largest() > 1.0 + found.error + EXCESS
}

/// What becomes of the light, in words; nothing of what is not transmitted. Where energy is created, what is left of it is no
/// share that is absorbed.
fn sums(found: &Reflectance) -> String {
    let [reflected, transmitted, rest] = rounded(found);
    let (verb, rest) = named_rest(rest);
    let transmitted = if transmitted == 0.0 {
        String::new()
    } else {
        format!("transmitted {transmitted:.3} | ")
    };
    format!("reflected {reflected:.3} | {transmitted}{verb} {rest:.3}")
}

/// What the rest to 1 is, and how much of it.
fn named_rest(rest: f64) -> (&'static str, f64) {
    if rest < 0.0 {
        ("created", -rest)
    } else {
        ("absorbed", rest)
    }
}

/// The kinds of lobes, then what is absorbed.
fn parts(shares: &[LobeShare], palette: &Palette) -> Vec<Part> {
    let mut parts: Vec<Part> = by_kind(shares)
        .into_iter()
        .map(|LobeShare { lobe, value, .. }| {
            let is_hatched = lobe.side == Side::Transmission;
            let side = if is_hatched {
                "transmitted"
            } else {
                "reflected"
            };
            Part {
                name: format!("{}, {side}", lobe.category.title()),
                share: Channel::Luminance.of(value),
                color: palette.category(lobe.category),
                category: Some(lobe.category),
                is_hatched,
            }
        })
        .collect();
    let [_, _, absorbed] = rounded(&Reflectance::of(shares));
    // What is created is among the parts above.
    if absorbed >= 0.0 {
        parts.push(Part {
            name: "Absorbed".to_owned(),
            share: absorbed,
            color: palette.absorbed,
            category: None,
            is_hatched: false,
        });
    }
    parts
}

/// The luminance of what is reflected, transmitted and absorbed, in thousandths; they sum to 1 exactly, the rest being
/// what is absorbed. It is negative where energy is created; an excess that is an error of the integral is none.
fn rounded(shares: &Reflectance) -> [f64; 3] {
    let thousandths = |rgb: [f64; 3]| (Channel::Luminance.of(rgb) * 1000.0).round() / 1000.0;
    let (reflected, transmitted) = (
        thousandths(shares.reflection),
        thousandths(shares.transmission),
    );
    let rest = ((1.0 - reflected - transmitted) * 1000.0).round() / 1000.0;
    let absorbed = if creates_energy(shares) {
        rest
    } else {
        rest.max(0.0)
    };
    // Adding 0 turns the -0 of rounding into 0.
    [reflected, transmitted, absorbed + 0.0]
}

fn bar(ui: &mut Ui, parts: &[Part], palette: &Palette) -> egui::Response {
    let (rect, response) = ui.allocate_exact_size(theme::SHARE_BAR, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, "Shares of light"));
    // Where energy is created there is more than the bar holds: its whole length is then all that leaves.
    let whole: f64 = parts.iter().map(|part| part.share.max(0.0)).sum();
    if parts.is_empty() {
        let edge = (1.0, palette.absorbed);
        let inside = egui::StrokeKind::Inside;
        ui.painter().rect_stroke(rect, 0.0, edge, inside);
    }
    let mut left = rect.left();
    for part in parts {
        let width = rect.width() * (part.share.max(0.0) / whole.max(1.0)) as f32;
        let size = vec2(width, rect.height());
        fill(
            ui.painter(),
            Rect::from_min_size(pos2(left, rect.top()), size),
            part,
            palette,
        );
        left += width;
    }
    response
}

/// Fills `rect` as `part` is: plain, or hatched in the colour of the background; with the icon of its category where there is
/// room.
fn fill(painter: &Painter, rect: Rect, part: &Part, palette: &Palette) {
    painter.rect_filled(rect, 0.0, part.color);
    if part.is_hatched {
        hatch(painter, rect, palette);
    }
    let room = Rect::from_center_size(rect.center(), Vec2::splat(rect.height()));
    if let Some(category) = part.category
        && rect.contains_rect(room)
    {
        painter.rect_filled(room, 0.0, part.color);
        category::icon(painter, room.shrink(1.0), category, palette.background);
    }
}

fn hatch(painter: &Painter, rect: Rect, palette: &Palette) {
    let painter = painter.with_clip_rect(rect.intersect(painter.clip_rect()));
    let lines = ((rect.width() + rect.height()) / theme::HATCH_STEP) as u32;
    for line in 0..=lines {
        let x = rect.left() + theme::HATCH_STEP * line as f32;
        let ends = [pos2(x, rect.top()), pos2(x - rect.height(), rect.bottom())];
        painter.line_segment(ends, (theme::HATCH_WIDTH, palette.background));
    }
}

/// Every share as text, beside a sample of its colour.
fn legend(ui: &mut Ui, parts: &[Part], error: f64, palette: &Palette) {
    ui.label(HINT);
    let grid = Grid::new("legend").min_col_width(theme::SWATCH.x);
    grid.show(ui, |ui| {
        for part in parts {
            let (rect, _) = ui.allocate_exact_size(theme::SWATCH, Sense::hover());
            fill(ui.painter(), rect, part, palette);
            ui.label(&part.name);
            ui.label(format!("{:.3}", part.share));
            ui.end_row();
        }
    });
    ui.label(format!(
        "Error of the integration at most {}",
        format::value(error)
    ));
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Lobe;

    #[test]
    fn shares_sum_to_one() {
        let shares = Reflectance {
            reflection: [0.333_33; 3],
            transmission: [0.333_33; 3],
            error: 0.0,
        };
        assert_eq!(rounded(&shares), [0.333, 0.333, 0.334]);
        let all = Reflectance {
            reflection: [1.0 - 1e-9; 3],
            transmission: [0.0; 3],
            error: 0.0,
        };
        assert_eq!(rounded(&all), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn what_is_created_is_not_called_absorbed() {
        let of = |reflected: f64| Reflectance {
            reflection: [reflected; 3],
            transmission: [0.0; 3],
            error: 1e-3,
        };
        let expected = "reflected 1.329 | created 0.329";
        assert_eq!(sums(&of(1.329)), expected);
        let expected = "reflected 1.002 | absorbed 0.000";
        assert_eq!(sums(&of(1.002)), expected);
        let glass = Reflectance {
            transmission: [0.5; 3],
            ..of(0.2)
        };
        let expected = "reflected 0.200 | transmitted 0.500 | absorbed 0.300";
        assert_eq!(sums(&glass), expected);
        let lobe = Lobe::reflection(Category::Diffuse);
        let share = |value: f64| LobeShare {
            lobe,
            value: [value; 3],
            error: 0.0,
        };
        let names = |value: f64| {
            let parts = parts(&[share(value)], &Palette::of(egui::Theme::Dark));
            parts.into_iter().map(|part| part.name).collect::<Vec<_>>()
        };
        assert_eq!(names(1.3), ["Diffuse, reflected"]);
        assert_eq!(names(0.3), ["Diffuse, reflected", "Absorbed"]);
    }

    #[test]
    fn parts_are_told_apart_by_name_colour_and_hatch() {
        let palette = Palette::of(egui::Theme::Dark);
        let lobes = Category::ALL
            .into_iter()
            .flat_map(|category| [Lobe::reflection(category), Lobe::transmission(category)]);
        let shares: Vec<LobeShare> = lobes
            .map(|lobe| LobeShare {
                lobe,
                value: [0.1; 3],
                error: 0.0,
            })
            .collect();
        let parts = parts(&shares, &palette);
        assert_eq!(parts.len(), 9);
        for (index, part) in parts.iter().enumerate() {
            for other in parts.iter().skip(index + 1) {
                assert_ne!(part.name, other.name);
                assert_ne!(
                    (part.color, part.is_hatched),
                    (other.color, other.is_hatched)
                );
            }
        }
        assert!((parts.iter().map(|part| part.share).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}
