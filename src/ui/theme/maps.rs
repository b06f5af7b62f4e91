//! Colours made of numbers: colour maps, radiance, tints.

use std::sync::LazyLock;

use egui::Color32;

use super::Rgba;
use super::palette::{rgb, translucent};
use bxdf_lab::analysis::Channel;

/// Alpha of the area under a curve, 0..255.
const FILL_ALPHA: u8 = 30;

/// `color` as the area under a curve.
#[must_use]
pub fn fill_of(color: Color32) -> Color32 {
    let [r, g, b, _] = color.to_array();
    translucent([r, g, b], FILL_ALPHA)
}

/// `color` as the 3D view takes it, with this alpha.
#[must_use]
pub fn rgba(color: Color32, alpha: u8) -> Rgba {
    let [r, g, b, _] = color.to_array();
    [r, g, b, alpha]
}

/// A colour map as a table: pictures look up each of their pixels.
struct Table([[u8; 3]; Self::STEPS + 1]);

impl Table {
    /// Steps of the table: four to each of the 256 tones of a channel.
    const STEPS: usize = 1024;

    fn of(gradient: colorous::Gradient) -> Self {
        let color = |index| {
            let color = gradient.eval_continuous(index as f64 / Self::STEPS as f64);
            [color.r, color.g, color.b]
        };
        Self(std::array::from_fn(color))
    }

    fn at(&self, t: f64) -> [u8; 3] {
        let index = (t.clamp(0.0, 1.0) * Self::STEPS as f64).round() as usize;
        self.0.get(index).copied().unwrap_or_default()
    }
}

/// The perceptual colour map of values: viridis. `t`: 0..1, clamped.
#[must_use]
pub fn viridis(t: f64) -> Rgba {
    static TABLE: LazyLock<Table> = LazyLock::new(|| Table::of(colorous::VIRIDIS));
    let [r, g, b] = TABLE.at(t);
    [r, g, b, 255]
}

/// The colour map of signed differences: neutral in the middle, red below and blue above. `t`: 0..1, clamped.
#[must_use]
pub fn diverging_color(t: f64) -> Color32 {
    static TABLE: LazyLock<Table> = LazyLock::new(|| Table::of(colorous::RED_BLUE));
    rgb(TABLE.at(t))
}

/// [`viridis`] as egui takes it.
#[must_use]
pub fn viridis_color(t: f64) -> Color32 {
    let [r, g, b, _] = viridis(t);
    rgb([r, g, b])
}

/// Linear channels 0..1 as the colour the screen shows.
#[must_use]
pub fn color_of_linear([r, g, b]: [f64; 3]) -> Color32 {
    egui::Rgba::from_rgb(r as f32, g as f32, b as f32).into()
}

/// Linear channels as the colour the screen shows, clipped at 1, where they cover this share of a pixel (0..1).
#[must_use]
pub fn color_of_linear_covered(rgb: [f64; 3], coverage: f32) -> Color32 {
    let [r, g, b] = rgb.map(|channel| channel.clamp(0.0, 1.0) as f32);
    egui::Rgba::from_rgba_unmultiplied(r, g, b, coverage).into()
}

/// The radiance of a small picture as the screen shows it, where it covers this share of a pixel (0..1). Highlights are
/// compressed in luminance, so that their colour stays.
#[must_use]
pub fn color_of_radiance(rgb: [f64; 3], coverage: f64) -> Color32 {
    // Reinhard's operator with the radiance that becomes white.
    const EXPOSURE: f64 = 1.1;
    const WHITE: f64 = 3.0;
    let luminance = EXPOSURE * Channel::Luminance.of(rgb);
    let gain = EXPOSURE * (1.0 + luminance / (WHITE * WHITE)) / (1.0 + luminance);
    let [r, g, b] = rgb.map(|channel| (gain * channel).min(1.0) as f32);
    egui::Rgba::from_rgba_unmultiplied(r, g, b, coverage as f32).into()
}
