//! The fonts of formulas: those that KaTeX has its metrics from (SIL Open Font License 1.1).

use std::sync::Arc;

use egui::{FontData, FontDefinitions, FontFamily};

/// The fonts, by the names that a formula that is laid out has for them. Script, Fraktur and typewriter are no part of our
/// formulas.
const FONTS: [&str; 11] = [
    "Main-Regular",
    "Main-Bold",
    "Main-Italic",
    "Main-BoldItalic",
    "Math-Italic",
    "AMS-Regular",
    "Caligraphic-Regular",
    "Size1-Regular",
    "Size2-Regular",
    "Size3-Regular",
    "Size4-Regular",
];

/// Adds them, each as a family of its own that falls back on that of text.
pub(super) fn add(fonts: &mut FontDefinitions) {
    let text = fonts.families.get(&FontFamily::Proportional).cloned();
    let text = text.unwrap_or_default();
    for name in FONTS {
        let Some(bytes) = ratex_katex_fonts::ttf_bytes(&format!("KaTeX_{name}.ttf")) else {
            continue;
        };
        let data = FontData::from_owned(bytes.into_owned());
        fonts.font_data.insert(name.to_owned(), Arc::new(data));
        let family = std::iter::once(name.to_owned()).chain(text.iter().cloned());
        fonts.families.insert(family_of(name), family.collect());
    }
}

/// The family of a font of formulas; that of text for one that is none of them.
#[must_use]
pub fn family_of(name: &str) -> FontFamily {
    if FONTS.contains(&name) {
        FontFamily::Name(name.into())
    } else {
        FontFamily::Proportional
    }
}
