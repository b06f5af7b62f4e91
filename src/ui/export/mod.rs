//! What is on the screen as files: pictures, drawings, numbers, meshes, materials. The window and the command line use
//! the same code, and pictures and drawings the same `App`.

use std::sync::Arc;

use egui::ColorImage;

use super::data::Data;
use super::headless::{self, Picture};
use super::theme::Palette;
use super::views::ViewSpec;
use crate::bxdf::material::file as material_file;
use crate::error::{Error, Result};

pub mod mesh;
pub mod names;
pub mod svg;
pub mod table;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A picture of the view.
    Png,
    /// A drawing of the view.
    Svg,
    /// The numbers behind the view.
    Csv,
    /// The lobes as a mesh, for modelling programs.
    Obj,
    /// The lobes as a mesh, for the web.
    Gltf,
    /// The selected material.
    Toml,
}

/// What there is to say of a kind of file.
pub struct FormatSpec {
    /// The kind.
    pub format: Format,
    /// What its names end in.
    pub extension: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What it holds.
    pub meaning: &'static str,
}

/// Every kind of file, in the order of the menu.
pub static FORMATS: [FormatSpec; 6] = [
    FormatSpec {
        format: Format::Png,
        extension: "png",
        title: "Picture (PNG)",
        meaning: "This view as a picture, at twice the size of the screen",
    },
    FormatSpec {
        format: Format::Svg,
        extension: "svg",
        title: "Drawing (SVG)",
        meaning: "This view as a drawing for print: lines stay lines, text stays text",
    },
    FormatSpec {
        format: Format::Csv,
        extension: "csv",
        title: "Numbers (CSV)",
        meaning: "The numbers behind this view, with all their digits and the units in the header",
    },
    FormatSpec {
        format: Format::Obj,
        extension: "obj",
        title: "Lobe mesh (OBJ)",
        meaning: "The lobes of the 3D view as a mesh for modelling programs",
    },
    FormatSpec {
        format: Format::Gltf,
        extension: "gltf",
        title: "Lobe mesh (glTF)",
        meaning: "The lobes of the 3D view as a mesh with their colours",
    },
    FormatSpec {
        format: Format::Toml,
        extension: "toml",
        title: "Material (TOML)",
        meaning: "The selected material as a file that can be opened here",
    },
];

/// The kind of file that ends in `extension`, whatever its case.
#[must_use]
pub fn format_of(extension: &str) -> Option<Format> {
    let mut all = FORMATS.iter();
    let found = all.find(|spec| spec.extension.eq_ignore_ascii_case(extension));
    found.map(|spec| spec.format)
}

/// The file of what `picture` shows.
///
/// # Errors
/// Where the view has nothing to show or no such file, and where there is no graphics adapter for a picture.
pub fn bytes(picture: Picture, format: Format) -> Result<Vec<u8>> {
    match format {
        Format::Png => picture.png(),
        Format::Svg => drawing(picture),
        Format::Csv => numbers(&picture),
        Format::Obj => Ok(mesh::obj(&lobes(&picture)?).into_bytes()),
        Format::Gltf => Ok(mesh::gltf(&lobes(&picture)?).into_bytes()),
        Format::Toml => Ok(material_file::print(picture.session.material()).into_bytes()),
    }
}

/// A view that has no file of some kind, or nothing to show.
fn refused(view: &ViewSpec, problem: &str) -> Error {
    Error::parse(format!("view '{}'", view.id), problem)
}

fn drawing(picture: Picture) -> Result<Vec<u8>> {
    if let Some(view) = picture.only.filter(|view| view.is_mesh) {
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

fn numbers(picture: &Picture) -> Result<Vec<u8>> {
    let Some(view) = picture.only else {
        return Err(Error::parse(
            "export",
            "numbers are those of one view: name it with --view",
        ));
    };
    let Some(fill) = view.table else {
        return Err(refused(
            view,
            "no table: its numbers are copied with its button",
        ));
    };
    let session = &picture.session;
    let table = fill(session, &mut Data::new(None, || {}));
    if table.rows.is_empty() {
        let why = super::views::no_values(session).unwrap_or("no light leaves where it looks");
        return Err(refused(view, &format!("nothing to show: {why}")));
    }
    table.csv()
}

/// The lobes of the materials shown, each with its colour.
fn lobes(picture: &Picture) -> Result<Vec<mesh::Named>> {
    let (session, palette) = (&picture.session, Palette::of(picture.theme));
    let mut data = Data::new(None, || {});
    let request = session.mesh_request();
    let named = session.materials.shown().map(|entry| {
        let [r, g, b, _] = egui::Rgba::from(palette.material(entry.slot())).to_array();
        mesh::Named {
            name: session.materials.title(entry),
            color: [r, g, b],
            mesh: data.ask(session, entry, request),
            with_cosine: session.with_cosine,
            names: names::Names::of_lobe(session),
            deltas: data.arrows(session, entry),
        }
    });
    let lobes: Vec<mesh::Named> = named.collect();
    if !lobes.iter().any(mesh::Named::has_mesh) {
        let why = super::views::no_values(session).unwrap_or("no light leaves");
        return Err(Error::parse("export", format!("no mesh: {why}")));
    }
    Ok(lobes)
}

/// A picture as the bytes of a PNG file.
///
/// # Errors
/// [`Error::Platform`] where it cannot be encoded.
fn png_of(image: &ColorImage) -> Result<Vec<u8>> {
    let [width, height] = image.size.map(|side| side as u32);
    let bytes = image
        .pixels
        .iter()
        .flat_map(egui::Color32::to_srgba_unmultiplied);
    headless::encoded(
        &image::RgbaImage::from_raw(width, height, bytes.collect()).unwrap_or_default(),
    )
}

/// The picture behind a texture, if it is one of the views'.
type ImageOf<'a> = &'a dyn Fn(egui::TextureId) -> Option<Arc<ColorImage>>;
