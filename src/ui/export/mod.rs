//! What is on the screen as files. Pictures and drawings are made of the same `App`, in the window and at the command line.

use egui::ColorImage;

use super::app::{Maker, Picture};
use super::theme::{self, Palette};
use bxdf::error::Result;
use bxdf_study::export::{Format, refused, text};

pub mod svg;

/// What makes the files of pictures in the window.
pub const MAKER: Maker = Maker {
    file: bytes,
    image: |picture| {
        let image = picture.image()?;
        let size = [image.width(), image.height()].map(|side| side as usize);
        Ok(ColorImage::from_rgba_unmultiplied(size, &image))
    },
};

/// The file of what `picture` shows.
///
/// # Errors
/// Where the view has nothing to show or no such file, and where there is no graphics adapter for a picture.
pub fn bytes(picture: Picture, format: Format) -> Result<Vec<u8>> {
    let theme = theme::chosen(picture.theme);
    match text(&picture.session, picture.only, theme, format) {
        Some(bytes) => bytes,
        None if format == Format::Svg => drawing(picture),
        None => picture.png(),
    }
}

fn drawing(picture: Picture) -> Result<Vec<u8>> {
    let view = picture
        .only
        .and_then(|view| picture.session.views.kind(view));
    if let Some(view) = view.filter(|view| view.is_mesh) {
        return Err(refused(
            view,
            "a mesh has no drawing: export png, obj or gltf",
        ));
    }
    let background = Palette::of(picture.theme).background;
    let size = egui::vec2(picture.size[0] as f32, picture.size[1] as f32);
    let harness = picture.shapes();
    let image_of = |id| harness.state().image(id);
    let shapes = &harness.output().shapes;
    svg::drawing(shapes, size, background, &image_of).map(String::into_bytes)
}
