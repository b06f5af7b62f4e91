//! Text stays text: each stretch of one look in each row.

use std::fmt::Write as _;

use egui::{FontFamily, Pos2};

use super::Writer;
use super::elements::{escaped, paint, short, turned};
use crate::export::runs::Run;

impl Writer {
    /// Fonts differ from machine to machine: the length of each stretch is kept.
    pub(super) fn stretch(&mut self, run: &Run, angle: f32, pivot: Pos2) {
        let turn = turned(angle, pivot);
        let mut look = String::new();
        if run.font.family == FontFamily::Monospace {
            look += " font-family=\"Hack, monospace\"";
        }
        if run.is_italic {
            look += " font-style=\"italic\"";
        }
        let lines = [
            (run.is_underlined, "underline"),
            (run.is_struck, "line-through"),
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
            short(run.place.left()),
            short(run.baseline),
            short(run.font.size),
            short(run.place.width()),
            paint("fill", run.color),
            escaped(&run.text)
        );
    }
}
