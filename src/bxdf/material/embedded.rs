//! The files of the named materials, embedded in the program.

use std::path::Path;

use include_dir::{Dir, File, include_dir};

/// The files. Their folder is the one list of them.
static FILES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/materials");

/// The files of materials: what stands beside them explains them.
pub(super) fn files() -> impl Iterator<Item = &'static File<'static>> {
    let is_material = |file: &&File<'_>| {
        let extension = file.path().extension();
        extension.is_some_and(|extension| extension == "toml")
    };
    FILES.files().filter(is_material)
}

/// The id of the material of `file`: its name without the ending.
pub(super) fn id_of(file: &'static File<'static>) -> Option<&'static str> {
    Path::file_stem(file.path()).and_then(|stem| stem.to_str())
}

/// The ids of all.
pub(crate) fn ids() -> impl Iterator<Item = &'static str> {
    files().filter_map(id_of)
}
