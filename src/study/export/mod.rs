//! What a session shows as files. Numbers, meshes and materials are made here; pictures and drawings by the window.

use crate::answers::Answers;
use crate::colors::{Theme, material_color};
use crate::session::{MaterialEntry, Session, ViewId};
use crate::views::{Options, ViewKind, lobe3d};
use bxdf::error::{Error, Result};
use bxdf::material::file as material_file;
use bxdf_lab::analysis::deltas::Arrows;

pub mod figure;
mod format;
pub mod mesh;
pub mod names;
pub mod table;

pub use format::{FORMATS, Format, FormatSpec, format_of};

/// The file of what `view` shows of the session; meshes have the colours of `theme`. `None` for pictures and drawings, which the
/// window makes.
///
/// # Errors
/// Where the view has nothing to show or no such file, and where no view is named for numbers.
#[must_use]
pub fn text(
    session: &Session,
    view: Option<ViewId>,
    theme: Theme,
    format: Format,
) -> Option<Result<Vec<u8>>> {
    match format {
        Format::Png | Format::Svg => None,
        Format::Csv => Some(numbers(
            session,
            view.and_then(|view| session.views.get(view)),
        )),
        Format::Obj => Some(lobes(session, theme).map(|lobes| mesh::obj(&lobes).into_bytes())),
        Format::Gltf => Some(lobes(session, theme).map(|lobes| mesh::gltf(&lobes).into_bytes())),
        Format::Toml => Some(Ok(
            material_file::print(&session.material().with_data()).into_bytes()
        )),
    }
}

/// A view that has no file of some kind, or nothing to show.
#[must_use]
pub fn refused(view: &ViewKind, problem: &str) -> Error {
    Error::parse(format!("view '{}'", view.id), problem)
}

fn numbers(session: &Session, options: Option<&Options>) -> Result<Vec<u8>> {
    let Some(options) = options else {
        return Err(Error::parse(
            "export",
            "numbers are those of one view: name it with --view",
        ));
    };
    let view = options.kind();
    if !view.has_file(Format::Csv) {
        return Err(refused(
            view,
            "no table: its numbers are copied with its button",
        ));
    }
    let table = options.table(session, &mut Answers::at_once());
    if table.rows.is_empty() {
        let why = no_values(session).unwrap_or("no light leaves where it looks");
        return Err(refused(view, &format!("nothing to show: {why}")));
    }
    table.csv()
}

/// The lobes of the materials shown, each with its colour.
fn lobes(session: &Session, theme: Theme) -> Result<Vec<mesh::Named>> {
    let mut answers = Answers::at_once();
    let options: lobe3d::Options = session.views.options();
    let request = options.request(session);
    let named = session.materials.shown().map(|entry| mesh::Named {
        name: session.materials.title(entry),
        color: linear(material_color(theme, entry.slot())),
        mesh: answers.ask(session, entry, request),
        with_cosine: session.with_cosine,
        names: names::Names::of_lobe(session, options.scale),
        deltas: answers.ask(session, entry, Arrows),
    });
    let lobes: Vec<mesh::Named> = named.collect();
    if !lobes.iter().any(mesh::Named::has_mesh) {
        let why = no_values(session).unwrap_or("no light leaves");
        return Err(Error::parse("export", format!("no mesh: {why}")));
    }
    Ok(lobes)
}

/// A colour of the screen as shares of light.
fn linear(color: [u8; 3]) -> [f32; 3] {
    palette::Srgb::from(color).into_linear().into()
}

/// Why no view has anything to show.
#[must_use]
pub fn nothing_to_show(session: &Session) -> Option<&'static str> {
    let materials = &session.materials;
    if materials.shown().next().is_some() {
        None
    } else if materials.iter().any(|entry| !entry.material.is_complete()) {
        Some("No material is shown: data is missing")
    } else {
        Some("Every material is hidden")
    }
}

/// Why an export of values has nothing, though there are materials.
#[must_use]
pub fn no_values(session: &Session) -> Option<&'static str> {
    let is_delta = |entry: &MaterialEntry| entry.material.is_delta_only();
    let is_empty = session.materials.shown().all(is_delta);
    nothing_to_show(session)
        .or(is_empty.then_some("All light is in Dirac deltas: f and the density are 0 everywhere"))
}
