//! What egui has painted as pages to be printed: lines stay lines, text stays text, in the fonts of the window.

use egui::{Pos2, Vec2};
use krilla::Document;
use krilla::error::KrillaError;
use krilla::geom::Transform;
use krilla::metadata::Metadata;
use krilla::page::PageSettings;

use super::painted::Painted;
use bxdf::error::{Error, Result};
use faces::Faces;
use writer::Writer;

mod faces;
mod paths;
mod text;
mod writer;

/// Points of print in a millimetre.
const PRINTED_POINTS_PER_MM: f32 = 72.0 / 25.4;

/// A sheet of paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Paper {
    /// Width and height, in millimetres.
    pub(super) size_mm: Vec2,
    /// How many points of what is painted are a millimetre.
    pub(super) points_per_mm: f32,
}

/// What was painted, and where its upper left corner is on a page, in points.
pub(super) type Placed<'a> = (Pos2, &'a Painted);

/// A document of these pages. It is the same bytes each time: it holds neither date nor chance.
///
/// # Errors
/// Where the paper has no size, and where a font or a picture cannot be embedded.
pub(super) fn document(title: &str, paper: Paper, pages: &[Vec<Placed<'_>>]) -> Result<Vec<u8>> {
    let mut document = Document::new();
    let metadata = Metadata::new().title(title.to_owned());
    document.set_metadata(metadata.language("en".to_owned()));
    let mut faces = Faces::new();
    let size = paper.size_mm * PRINTED_POINTS_PER_MM;
    let scale = PRINTED_POINTS_PER_MM / paper.points_per_mm;
    for parts in pages {
        let settings = PageSettings::from_wh(size.x, size.y).ok_or_else(|| {
            let [width, height] = [paper.size_mm.x, paper.size_mm.y];
            Error::parse(format!("a page of {width} x {height} mm"), "it has no area")
        })?;
        let mut page = document.start_page_with(settings);
        let mut surface = page.surface();
        surface.push_transform(&Transform::from_scale(scale, scale));
        for (corner, painted) in parts {
            surface.push_transform(&Transform::from_translate(corner.x, corner.y));
            let mut writer = Writer::new(&mut surface, &mut faces);
            let drawn = painted.draw(&mut writer);
            writer.end();
            surface.pop();
            drawn?;
        }
        surface.pop();
        surface.finish();
        page.finish();
    }
    document.finish().map_err(|error| refused(&error))
}

fn refused(error: &KrillaError) -> Error {
    Error::Platform {
        problem: format!("the pages cannot be written: {error:?}"),
        remedy: "fewer lessons on one sheet may do".to_owned(),
    }
}

#[cfg(test)]
mod tests;
