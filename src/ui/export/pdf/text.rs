//! Text stays text, letter by letter where the window has it.

use egui::{Stroke, pos2};
use krilla::geom::{Point, Transform};
use krilla::text::KrillaGlyph;

use super::faces::Letter;
use super::writer::{Writer, fill};
use crate::export::runs::Run;
use crate::export::shapes::Canvas as _;

/// How far italics lean: across for each point up.
const SLANT: f32 = 0.2;

/// Where a line under a text lies below its baseline, where one through it lies above, and how thick they are, as parts of
/// its size.
const UNDER: f32 = 0.14;
/// See [`UNDER`].
const THROUGH: f32 = 0.3;
/// See [`UNDER`].
const THICK: f32 = 0.06;

/// Letters of one font that follow one another.
struct Stretch {
    letter: Letter,
    text: String,
    start: f32,
    glyphs: Vec<KrillaGlyph>,
}

impl Writer<'_, '_> {
    /// Letters, and the lines under and through them.
    pub(super) fn stretch(&mut self, run: &Run) {
        if run.is_italic {
            let slant = Transform::from_row(1.0, 0.0, -SLANT, 1.0, SLANT * run.baseline, 0.0);
            self.surface.push_transform(&slant);
        }
        for stretch in self.stretches(run) {
            let Letter { scale, lower, .. } = stretch.letter;
            let size = run.font.size * scale;
            let start = Point::from_xy(stretch.start, run.baseline + lower * size);
            self.surface.set_fill(fill(run.color));
            self.surface.set_stroke(None);
            let font = stretch.letter.font;
            self.surface
                .draw_glyphs(start, &stretch.glyphs, font, &stretch.text, size, false);
        }
        if run.is_italic {
            self.surface.pop();
        }
        let lines = [(run.is_underlined, UNDER), (run.is_struck, -THROUGH)];
        for (_, below) in lines.into_iter().filter(|(is_there, _)| *is_there) {
            let y = run.baseline + below * run.font.size;
            let ends = [run.place.left(), run.place.right()].map(|x| pos2(x, y));
            self.line(&ends, Stroke::new(THICK * run.font.size, run.color));
        }
    }

    /// The letters by their fonts; what no font has leaves its place free.
    fn stretches(&mut self, run: &Run) -> Vec<Stretch> {
        let mut all: Vec<Stretch> = Vec::new();
        let mut is_broken = true;
        for (letter, (x, room)) in run.text.chars().zip(places(run)) {
            // Spaces of every kind are one.
            let drawn = if letter.is_whitespace() { ' ' } else { letter };
            let Some(found) = self.faces.letter(&run.font.family, drawn) else {
                is_broken = true;
                continue;
            };
            if is_broken || all.last().is_none_or(|last| last.letter.font != found.font) {
                all.push(Stretch {
                    letter: found.clone(),
                    text: String::new(),
                    start: x,
                    glyphs: Vec::new(),
                });
            }
            is_broken = false;
            if let Some(last) = all.last_mut() {
                let from = last.text.len();
                last.text.push(letter);
                let advance = room / (run.font.size * found.scale);
                let range = from..last.text.len();
                let glyph = KrillaGlyph::new(found.glyph, advance, 0.0, 0.0, 0.0, range, None);
                last.glyphs.push(glyph);
            }
        }
        all
    }
}

/// Where each letter begins and how much room it has. Those that the window draws as one (fi), so that the later ones have no
/// room, share that of the whole.
fn places(run: &Run) -> Vec<(f32, f32)> {
    let ends = run.starts.iter().skip(1).copied();
    let ends = ends.chain([run.place.right()]);
    let rooms: Vec<(f32, f32)> = run.starts.iter().copied().zip(ends).collect();
    let wholes = rooms.chunk_by(|_, (start, end)| end <= start);
    let shared = wholes.flat_map(|whole| {
        let from = whole.first().map_or(0.0, |(start, _)| *start);
        let to = whole.last().map_or(from, |(_, end)| *end);
        let room = (to - from) / whole.len() as f32;
        (0..whole.len()).map(move |part| (from + room * part as f32, room))
    });
    shared.collect()
}
