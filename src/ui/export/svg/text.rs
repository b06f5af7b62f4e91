//! Text stays text: each stretch of one look in each row.

use std::fmt::Write as _;

use egui::epaint::TextShape;
use egui::text::{Galley, LayoutSection};
use egui::{Color32, FontFamily, Rect, Stroke, vec2};

use super::Writer;
use super::elements::{escaped, paint, place, short, turned};

/// A stretch of a row in one look.
struct Run<'a> {
    section: &'a LayoutSection,
    text: String,
    /// Its box in the galley, and its baseline.
    place: Rect,
    baseline: f32,
}

impl Writer<'_> {
    /// Fonts differ from machine to machine: the length of each stretch is kept.
    pub(super) fn galley(&mut self, shape: &TextShape) {
        let turn = turned(shape.angle, shape.pos);
        for run in runs(&shape.galley) {
            let format = &run.section.format;
            let own = match format.color {
                Color32::PLACEHOLDER => shape.fallback_color,
                color => color,
            };
            let color = shape.override_text_color.unwrap_or(own);
            let color = color.gamma_multiply(shape.opacity_factor);
            let at = run.place.translate(shape.pos.to_vec2());
            let background = format.background.gamma_multiply(shape.opacity_factor);
            if background != Color32::TRANSPARENT {
                let geometry = format!("{}{turn}", place(at.expand(format.expand_bg)));
                self.element("rect", &geometry, background, Stroke::NONE);
            }
            if color == Color32::TRANSPARENT || run.text.trim().is_empty() {
                continue;
            }
            let mut look = String::new();
            if format.font_id.family == FontFamily::Monospace {
                look += " font-family=\"Hack, monospace\"";
            }
            if format.italics {
                look += " font-style=\"italic\"";
            }
            let is_under = !format.underline.is_empty() || !shape.underline.is_empty();
            let lines = [
                (is_under, "underline"),
                (!format.strikethrough.is_empty(), "line-through"),
            ];
            let lines: Vec<&str> = lines.iter().filter(|l| l.0).map(|l| l.1).collect();
            if !lines.is_empty() {
                let _ = write!(look, " text-decoration=\"{}\"", lines.join(" "));
            }
            // Writing to a string cannot fail.
            let _ = writeln!(
                self.text,
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\" \
                 xml:space=\"preserve\"{look}{turn} {}>{}</text>",
                short(at.left()),
                short(shape.pos.y + run.baseline),
                short(format.font_id.size),
                short(at.width()),
                paint("fill", color),
                escaped(&run.text)
            );
        }
    }
}

/// The stretches of a galley, row by row.
fn runs(galley: &Galley) -> Vec<Run<'_>> {
    let sections = &galley.job.sections;
    let mut runs: Vec<Run<'_>> = Vec::new();
    // Where each glyph stands in the text of the job.
    let mut byte = 0;
    for placed in &galley.rows {
        let mut is_first = true;
        for glyph in &placed.row.glyphs {
            let of = |section: &&LayoutSection| section.byte_range.end.0 > byte;
            let Some(section) = sections.iter().find(of).or(sections.last()) else {
                continue;
            };
            byte += glyph.chr.len_utf8();
            let corner = placed.pos + vec2(glyph.pos.x, 0.0);
            let size = vec2(glyph.advance_width, placed.row.size.y);
            let place = Rect::from_min_size(corner, size);
            match runs.last_mut() {
                Some(run) if !is_first && std::ptr::eq(run.section, section) => {
                    run.text.push(glyph.chr);
                    run.place = run.place.union(place);
                }
                _ => runs.push(Run {
                    section,
                    text: glyph.chr.to_string(),
                    place,
                    baseline: placed.pos.y + glyph.pos.y,
                }),
            }
            is_first = false;
        }
        if placed.ends_with_newline {
            byte += 1;
        }
    }
    runs
}
