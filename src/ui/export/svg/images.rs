//! The pictures in a drawing.

use egui::ColorImage;

use crate::headless;
use bxdf::error::Result;

/// A picture as the bytes of a PNG file.
///
/// # Errors
/// [`Error::Platform`] where it cannot be encoded.
pub(super) fn png_of(image: &ColorImage) -> Result<Vec<u8>> {
    let [width, height] = image.size.map(|side| side as u32);
    let bytes = image
        .pixels
        .iter()
        .flat_map(egui::Color32::to_srgba_unmultiplied);
    let image = image::RgbaImage::from_raw(width, height, bytes.collect()).unwrap_or_default();
    headless::encoded(&image, None)
}
