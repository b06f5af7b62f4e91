//! Symbols and indices as they are written beside the chart.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, TextStyle, Ui};

use bxdf_lab::analysis::fresnel::Index;
use bxdf_study::format;

/// The size of a subscript as a part of that of its line.
const SUBSCRIPT: f32 = 0.7;

/// A text in which `_` stands before a letter that is a subscript.
pub(super) fn with_subscripts(ui: &Ui, text: &str, color: Color32) -> LayoutJob {
    let font_id = TextStyle::Small.resolve(ui.style());
    let mut small = font_id.clone();
    small.size *= SUBSCRIPT;
    let format = |font_id, valign| TextFormat {
        font_id,
        color,
        valign,
        ..TextFormat::default()
    };
    let (full, small) = (format(font_id, Align::Center), format(small, Align::BOTTOM));
    let mut job = LayoutJob::default();
    let mut parts = text.split('_');
    job.append(parts.next().unwrap_or_default(), 0.0, full.clone());
    for part in parts {
        let end = part.chars().next().map_or(0, char::len_utf8);
        let (subscript, rest) = part.split_at(end);
        job.append(subscript, 0.0, small.clone());
        job.append(rest, 0.0, full.clone());
    }
    job
}

/// An index as it is written.
pub(super) fn index_text(index: Index) -> String {
    if index.is_absorbing() {
        let [n, k] = [index.n, index.k].map(format::value);
        format!("{n} + {k} i")
    } else {
        format::value(index.n)
    }
}
