//! What is on the screen as files. Pictures and drawings are made of the same `App`, in the window and at the command line.

use egui::epaint::ClippedShape;
use egui::{ColorImage, Rect, Shape};
use egui_kittest::Harness;
use image::RgbaImage;

use super::app::{App, Maker, Picture};
use super::headless;
use super::theme::{self, Palette};
use bxdf::error::Result;
use bxdf_study::export::{Format, text};

pub mod svg;

/// What makes the files of pictures in the window.
pub const MAKER: Maker = Maker {
    file: bytes,
    image: |picture| picture.image().map(|image| as_colors(&image)),
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
    let page = picture.figure.as_ref().and_then(|figure| figure.page);
    let (scale, background) = (picture.scale, Palette::of(picture.theme).background);
    let mut harness = picture.clone().shapes();
    let has_scene = |clipped: &ClippedShape| matches!(clipped.shape, Shape::Callback(_));
    let mut scenes = None;
    if harness.output().shapes.iter().any(has_scene) {
        harness = picture.drawn()?;
        harness.state_mut().draw_axes_as_lines();
        scenes = Some(scenes_of(&mut harness)?);
    }
    let page = svg::Page {
        size: harness.ctx.content_rect().size(),
        print_width_mm: page.and_then(|page| page.print_width_mm),
        background,
    };
    let pictures = svg::Pictures {
        of_texture: &|id| harness.state().image(id),
        of_scene: &|rect| scenes.as_ref().map(|scenes| part(scenes, rect, scale)),
    };
    let drawing = svg::drawing(&harness.output().shapes, page, pictures);
    drawing.map(String::into_bytes)
}

/// The page with nothing on it but what the graphics processor draws.
fn scenes_of(harness: &mut Harness<'_, App>) -> Result<ColorImage> {
    harness.state_mut().paint_scenes_alone(true);
    harness.run_ok();
    let scenes = headless::rendered(harness)?;
    harness.state_mut().paint_scenes_alone(false);
    harness.run_ok();
    Ok(as_colors(&scenes))
}

/// The part of a picture of the page that shows `rect`, in points.
fn part(page: &ColorImage, rect: Rect, scale: f32) -> ColorImage {
    page.region(&rect, Some(scale))
}

fn as_colors(image: &RgbaImage) -> ColorImage {
    let size = [image.width(), image.height()].map(|side| side as usize);
    ColorImage::from_rgba_unmultiplied(size, image)
}
