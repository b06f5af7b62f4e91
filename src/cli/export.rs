//! `export`: what the window would save, without one.

use std::path::Path;

use super::output;
use super::render::{self, RenderArgs};
use bxdf::error::{Error, Result};
use bxdf_study::export::{self, FORMATS};
use bxdf_study::views;

/// Writes the file that the request names; what it holds follows from the end of its name.
///
/// # Errors
/// Where the name ends in no known kind, or in one that is no picture though a figure is asked for, the session cannot be read, the view is unknown or has nothing to show, or the
/// file cannot be written.
pub(super) fn run(request: &RenderArgs) -> Result<()> {
    let extension = request.output.extension().and_then(|end| end.to_str());
    let format = extension
        .and_then(export::format_of)
        .ok_or_else(|| unknown(&request.output))?;
    if request.figure.is_some() && !format.is_picture() {
        return Err(only_pictures());
    }
    // A file shows one view: of the first kind where none is named.
    let (session, view) = render::chosen(request, views::VIEWS.first())?;
    let theme = request.theme.unwrap_or_default();
    let bytes = match export::text(&session, view, theme, format) {
        Some(bytes) => bytes?,
        None => render::drawn(request, session, view, format)?,
    };
    output::write(&request.output, &bytes)
}

fn only_pictures() -> Error {
    let pictures = FORMATS.iter().filter(|spec| spec.format.is_picture());
    let known: Vec<&str> = pictures.map(|spec| spec.extension).collect();
    Error::parse(
        "--figure",
        format!(
            "a figure is a picture, whose name ends in one of: {}",
            known.join(", ")
        ),
    )
}

fn unknown(path: &Path) -> Error {
    let known: Vec<&str> = FORMATS.iter().map(|spec| spec.extension).collect();
    Error::parse(
        format!("file '{}'", path.display()),
        format!("expected a name that ends in one of: {}", known.join(", ")),
    )
}
