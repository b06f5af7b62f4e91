//! `export`: what the window would save, without one.

use std::path::Path;

use super::output;
use super::render::{self, RenderArgs};
use crate::error::{Error, Result};
use crate::ui::export::{self, FORMATS};
use crate::ui::views;

/// Writes the file that the request names; what it holds follows from the end of its name.
///
/// # Errors
/// Where the name ends in no known kind, the session cannot be read, the view is unknown or has nothing to show, or the
/// file cannot be written.
pub(super) fn run(request: &RenderArgs) -> Result<()> {
    let extension = request.output.extension().and_then(|end| end.to_str());
    let format = extension
        .and_then(export::format_of)
        .ok_or_else(|| unknown(&request.output))?;
    let mut picture = render::picture(request)?;
    // A file shows one view: the first one where none is named.
    picture.only = picture.only.or_else(|| views::VIEWS.first());
    output::write(&request.output, &export::bytes(picture, format)?)
}

fn unknown(path: &Path) -> Error {
    let known: Vec<&str> = FORMATS.iter().map(|spec| spec.extension).collect();
    Error::parse(
        format!("file '{}'", path.display()),
        format!("expected a name that ends in one of: {}", known.join(", ")),
    )
}
