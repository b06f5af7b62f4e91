//! The fonts of the window, as pages hold them.

use std::collections::HashMap;

use egui::{FontData, FontDefinitions, FontFamily};
use krilla::text::{Font, GlyphId};
use skrifa::{FontRef, MetadataProvider};

/// The fonts there are, and those that are in use.
pub(super) struct Faces {
    definitions: FontDefinitions,
    used: HashMap<String, Font>,
}

/// A letter in the font that has it.
#[derive(Clone, PartialEq)]
pub(super) struct Letter {
    /// The font.
    pub(super) font: Font,
    /// The letter in it.
    pub(super) glyph: GlyphId,
    /// How large it is drawn, against the size that is asked for.
    pub(super) scale: f32,
    /// By how much it is lowered, as a part of its size.
    pub(super) lower: f32,
}

impl Faces {
    /// Those of the window.
    pub(super) fn new() -> Self {
        Self {
            definitions: crate::theme::fonts(),
            used: HashMap::new(),
        }
    }

    /// A letter in the first font of the family that has it; `None` where none has.
    pub(super) fn letter(&mut self, family: &FontFamily, letter: char) -> Option<Letter> {
        let names = self.definitions.families.get(family)?;
        let mut all = names.iter();
        let (name, data, glyph) = all.find_map(|name| {
            let data = self.definitions.font_data.get(name)?;
            Some((name, data, glyph(data, letter)?))
        })?;
        let used = self.used.get(name).cloned();
        let font = used.or_else(|| Font::new(data.font.clone().into(), data.index))?;
        self.used
            .entry(name.clone())
            .or_insert_with(|| font.clone());
        Some(Letter {
            font,
            glyph,
            scale: data.tweak.scale,
            lower: data.tweak.y_offset_factor,
        })
    }
}

fn glyph(data: &FontData, letter: char) -> Option<GlyphId> {
    let font = FontRef::from_index((*data.font).as_ref(), data.index).ok()?;
    let glyph = font.charmap().map(letter)?;
    Some(GlyphId::new(glyph.to_u32()))
}
