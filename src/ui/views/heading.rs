//! The title of a figure: what is shown, of which materials, for which directions.

use egui::{Rect, RichText, Sense, Ui, vec2};

use super::context::{Named, ViewContext};
use crate::theme::{self, Dash};
use crate::widgets::{choice, draw};
use bxdf_lab::analysis::half_difference::Spherical;
use bxdf_study::format;
use bxdf_study::session::MaterialEntry;
use bxdf_study::views::{Caption, Directions, Options, Subjects};

/// The most names of materials: more would leave no room for the view.
const MOST_NAMES: usize = 12;

/// The most characters of a title: some lines of the narrowest page.
const LONGEST_TITLE: usize = 240;

/// The most characters of a name.
const LONGEST_NAME: usize = 32;

/// The radius of the mark of a direction, in points.
const MARK_RADIUS: f32 = 4.0;

/// Between a mark and its text, and between two of them, in points.
const GAPS: [f32; 2] = [6.0, 14.0];

/// The height of a row, in points.
const ROW: f32 = 18.0;

/// Writes the title into `ui`, row by row; `own`: the words in place of those for what is shown.
pub fn show(ui: &mut Ui, cx: &mut ViewContext<'_>, options: &Options, own: Option<&str>) {
    let caption = options.caption(cx.session);
    let words = own.map_or_else(|| words(options, &caption), str::to_owned);
    let words = draw::clipped(&words, LONGEST_TITLE);
    let spacing = ui.spacing_mut();
    spacing.item_spacing = vec2(GAPS[1], 2.0);
    spacing.interact_size.y = ROW;
    ui.label(RichText::new(words).heading());
    ui.horizontal_wrapped(|ui| {
        name_materials(ui, cx, caption.names);
        name_directions(ui, cx, caption.directions);
    });
}

/// What is shown, with its unit.
#[must_use]
pub fn words(options: &Options, caption: &Caption) -> String {
    format!("{}: {}", options.kind().title, caption.quantity)
}

/// The materials that have no name of their own in the view, each with its line or its colour.
fn name_materials(ui: &mut Ui, cx: &ViewContext<'_>, names: Subjects) {
    let materials = &cx.session.materials;
    let named: Vec<&MaterialEntry> = match names {
        Subjects::Lines | Subjects::Colors => materials.shown().collect(),
        Subjects::Apart | Subjects::Legend if !materials.is_overlay() => {
            materials.shown().collect()
        }
        Subjects::Selected => vec![materials.selected()],
        Subjects::Apart | Subjects::Legend | Subjects::None => Vec::new(),
    };
    let has_lines = matches!(names, Subjects::Lines | Subjects::Legend);
    for entry in named.iter().take(MOST_NAMES) {
        let color = cx.palette.material(entry.slot());
        let title = draw::clipped(&materials.title(entry), LONGEST_NAME);
        let mark = if has_lines {
            theme::LINE_SAMPLE
        } else {
            theme::SWATCH.x
        };
        item(ui, &title, mark, |ui, rect| {
            let (painter, middle) = (ui.painter(), rect.center());
            if has_lines {
                let ends = [rect.left_center(), rect.right_center()];
                let stroke = (theme::CURVE_WIDTH, color);
                draw::line(painter, ends, stroke, Dash::of(entry.slot()));
            } else {
                let patch = Rect::from_center_size(middle, theme::SWATCH);
                painter.rect_filled(patch, 2.0, color);
            }
        });
    }
    let left_out = named.len().saturating_sub(MOST_NAMES);
    if left_out > 0 {
        ui.label(format!("and {left_out} more"));
    }
}

/// Light and viewer with their angles, as far as the view is of them.
fn name_directions(ui: &mut Ui, cx: &ViewContext<'_>, shown: Directions) {
    let is_shown = |one: &Named| match shown {
        Directions::Both => true,
        Directions::Held => one.is_held,
        Directions::None => false,
    };
    for one in cx.directions().iter().rev().filter(|one| is_shown(one)) {
        let Spherical { theta_deg, phi_deg } = Spherical::of(one.direction);
        let [theta, phi] = [theta_deg, phi_deg].map(format::degrees);
        let text = format!("{} θ {theta}, φ {phi}", one.name);
        item(ui, &text, 2.0 * MARK_RADIUS, |ui, rect| {
            ui.painter()
                .circle_filled(rect.center(), MARK_RADIUS, one.color);
        });
    }
}

/// A mark of this width with its text, on one line wherever the line ends.
fn item(ui: &mut Ui, text: &str, mark: f32, draw_mark: impl FnOnce(&Ui, Rect)) {
    let width = mark + GAPS[0] + choice::width_of(ui, text, &egui::TextStyle::Body);
    choice::keep_together(ui, width);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAPS[0];
        let (rect, _) = ui.allocate_exact_size(vec2(mark, ROW), Sense::hover());
        draw_mark(ui, rect);
        ui.label(text);
    });
}
