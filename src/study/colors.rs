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

/// The colours of the materials in a theme, in the order in which their places are taken; sRGB. Each pair of them, and each
/// with the colours of the light, the viewer, the mirror direction and the ink, differs by a CIEDE2000 of 12 at least, as seen
/// by normal, protanopic and deuteranopic eyes: found by a search from blue, orange, green, magenta, yellow and so on.
#[must_use]
pub const fn material_colors(theme: Theme) -> [[u8; 3]; 8] {
    match theme {
        Theme::Dark => [
            [77, 180, 249],
            [213, 110, 4],
            [12, 145, 111],
            [184, 106, 153],
            [255, 238, 49],
            [73, 135, 215],
            [229, 79, 110],
            [168, 153, 153],
        ],
        Theme::Light => [
            [46, 127, 167],
            [224, 112, 15],
            [1, 152, 143],
            [203, 61, 120],
            [136, 149, 100],
            [54, 146, 243],
            [133, 11, 24],
            [91, 85, 85],
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
