//! What is on the screen as files. Pictures and drawings are made of the same `App`, in the window and at the command line.

use super::app::{Maker, Picture};
use super::theme::{self, Palette};
use bxdf::error::Result;
use bxdf_study::export::{Format, text};
use painted::{Painted, as_colors};

mod painted;
#[cfg(not(target_arch = "wasm32"))]
mod pdf;
mod pieces;
mod runs;
pub mod shapes;
#[cfg(not(target_arch = "wasm32"))]
pub mod sheet;
pub mod svg;

/// What makes the files of pictures in the window.
pub const MAKER: Maker = Maker {
    file: |picture, format| Box::pin(file(picture, format)),
    image: |picture| {
        Box::pin(async {
            let image = picture.drawn_image().await;
            image.map(|image| as_colors(&image))
        })
    },
};

/// The file of what `picture` shows.
///
/// # Errors
/// Where the view has nothing to show or no such file, and where there is no graphics adapter for a picture.
#[cfg(not(target_arch = "wasm32"))]
pub fn bytes(picture: Picture, format: Format) -> Result<Vec<u8>> {
    pollster::block_on(file(picture, format))
}

/// [`bytes`], which in a browser has to be waited for.
async fn file(picture: Picture, format: Format) -> Result<Vec<u8>> {
    let theme = theme::chosen(picture.theme);
    match text(&picture.session, picture.only, theme, format) {
        Some(bytes) => bytes,
        None if format == Format::Svg => drawing(picture).await,
        None => picture.png().await,
    }
}

async fn drawing(picture: Picture) -> Result<Vec<u8>> {
    let page = picture.figure.as_ref().and_then(|figure| figure.page);
    let background = Palette::of(picture.theme).background;
    let painted = Painted::of(picture).await?;
    let page = svg::Page {
        size: painted.size,
        print_width_mm: page.and_then(|page| page.print_width_mm),
        background,
    };
    let drawing = painted.with_pictures(|known| svg::drawing(&painted.shapes, page, known));
    drawing.map(String::into_bytes)
}
