//! The colours that materials are known by, on the screen and in files.

use serde::{Deserialize, Serialize};

use super::session::PaletteIndex;

/// Light on dark, or dark on light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Theme {
    /// Light text on a dark ground.
    #[default]
    Dark,
    /// Dark text on a light ground.
    Light,
}

/// The colour-blind-safe colours of Okabe & Ito 2008 ("Color Universal Design").
pub mod okabe_ito {
    /// Orange.
    pub const ORANGE: [u8; 3] = [230, 159, 0];
    /// Yellow.
    pub const YELLOW: [u8; 3] = [240, 228, 66];
    /// Sky blue.
    pub const SKY_BLUE: [u8; 3] = [86, 180, 233];
    /// Bluish green.
    pub const GREEN: [u8; 3] = [0, 158, 115];
    /// Blue.
    pub const BLUE: [u8; 3] = [0, 114, 178];
    /// Vermilion.
    pub const VERMILION: [u8; 3] = [213, 94, 0];
    /// Reddish purple.
    pub const PURPLE: [u8; 3] = [204, 121, 167];
}

/// The colours of the materials in a theme, in the order in which their places are taken; sRGB.
#[must_use]
pub const fn material_colors(theme: Theme) -> [[u8; 3]; 7] {
    match theme {
        Theme::Dark => [
            okabe_ito::SKY_BLUE,
            [240, 120, 40],
            [20, 185, 140],
            [226, 150, 192],
            okabe_ito::YELLOW,
            [60, 140, 220],
            [187; 3],
        ],
        Theme::Light => [
            okabe_ito::BLUE,
            okabe_ito::VERMILION,
            [0, 136, 100],
            [180, 85, 140],
            [140, 118, 0],
            [40, 140, 200],
            [112; 3],
        ],
    }
}

/// The colour of the material in this place; sRGB.
#[must_use]
pub fn material_color(theme: Theme, slot: PaletteIndex) -> [u8; 3] {
    let colors = material_colors(theme);
    let index = usize::from(slot.0) % colors.len();
    colors.get(index).copied().unwrap_or_default()
}
