//! The stretches of one look that a text is made of, row by row.

use egui::epaint::TextShape;
use egui::text::LayoutSection;
use egui::{Color32, FontId, Pos2, Rect, vec2};

/// A stretch of a row in one look, before the text is turned.
pub(super) struct Run {
    /// What it says.
    pub(super) text: String,
    /// Where each of its letters begins, from left to right.
    pub(super) starts: Vec<f32>,
    /// Its box.
    pub(super) place: Rect,
    /// The height of its baseline.
    pub(super) baseline: f32,
    /// Its font.
    pub(super) font: FontId,
    /// The colour of its letters.
    pub(super) color: Color32,
    /// What lies behind it, and how far beyond its box.
    pub(super) background: (Color32, f32),
    /// Whether it is set in italics.
    pub(super) is_italic: bool,
    /// Whether there is a line under it.
    pub(super) is_underlined: bool,
    /// Whether there is a line through it.
    pub(super) is_struck: bool,
}

impl Run {
    fn begun(shape: &TextShape, section: &LayoutSection, baseline: f32) -> Self {
        let format = &section.format;
        let own = match format.color {
            Color32::PLACEHOLDER => shape.fallback_color,
            color => color,
        };
        let color = shape.override_text_color.unwrap_or(own);
        let background = format.background.gamma_multiply(shape.opacity_factor);
        Self {
            text: String::new(),
            starts: Vec::new(),
            place: Rect::NOTHING,
            baseline,
            font: format.font_id.clone(),
            color: color.gamma_multiply(shape.opacity_factor),
            background: (background, format.expand_bg),
            is_italic: format.italics,
            is_underlined: !format.underline.is_empty() || !shape.underline.is_empty(),
            is_struck: !format.strikethrough.is_empty(),
        }
    }

    /// Whether none of its letters is to be seen.
    pub(super) fn is_blank(&self) -> bool {
        self.color == Color32::TRANSPARENT || self.text.trim().is_empty()
    }

    fn push(&mut self, letter: char, place: Rect) {
        self.text.push(letter);
        self.starts.push(place.left());
        self.place = self.place.union(place);
    }
}

/// The stretches of a text, row by row.
pub(super) fn runs(shape: &TextShape) -> Vec<Run> {
    let galley = &shape.galley;
    let sections = &galley.job.sections;
    let mut runs: Vec<Run> = Vec::new();
    // Where each glyph stands in the text of the job.
    let mut byte = 0;
    for placed in &galley.rows {
        let corner: Pos2 = shape.pos + placed.pos.to_vec2();
        let mut last: Option<&LayoutSection> = None;
        for glyph in &placed.row.glyphs {
            let of = |section: &&LayoutSection| section.byte_range.end.0 > byte;
            let Some(section) = sections.iter().find(of).or(sections.last()) else {
                continue;
            };
            byte += glyph.chr.len_utf8();
            let size = vec2(glyph.advance_width, placed.row.size.y);
            let place = Rect::from_min_size(corner + vec2(glyph.pos.x, 0.0), size);
            if !last.is_some_and(|last| std::ptr::eq(last, section)) {
                runs.push(Run::begun(shape, section, corner.y + glyph.pos.y));
            }
            last = Some(section);
            if let Some(run) = runs.last_mut() {
                run.push(glyph.chr, place);
            }
        }
        if placed.ends_with_newline {
            byte += 1;
        }
    }
    runs
}
