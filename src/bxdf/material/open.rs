//! Materials by whatever names them: text, the name of one of the library, or the path of a file.

use std::ffi::OsStr;
use std::path::Path;

use super::data::formats;
use super::{Material, file, library};
use crate::error::{Error, Result, shown};
use crate::files;
use crate::resource::{Content, Resource};

/// What a file of a material is.
const MATERIAL_FILE: &str = "a material is read from TOML text (.toml) with [[lobes]]";

impl Material {
    /// The material that `given` names: a model, as `id` or `id:name=value,name=value`; the id of a named material; the path
    /// of a material file, whatever its name ends in, or that of a file of data that a model shows, as `gold.table`.
    ///
    /// ```
    /// use bxdf::Material;
    ///
    /// # fn main() -> bxdf::Result<()> {
    /// assert_eq!(Material::open("gold")?.name, "Gold");
    /// assert_eq!(Material::open("phong:exponent=20")?.components().len(), 1);
    /// assert!(Material::open("golf").is_err_and(|error| error.to_string().contains("nearest: gold")));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::UnknownId`] for a name that stands nowhere, with the nearest ones; what the readers of parameters and of
    /// files refuse, [`Error::Io`] for a file that cannot be read, and [`Error::Parse`] for one that a parameter names.
    pub fn open(given: impl AsRef<OsStr>) -> Result<Self> {
        let given = given.as_ref();
        let text = given.to_str();
        let path = Path::new(given);
        let mut material = match text.filter(|text| library::is_known(text)) {
            Some(text) => library::read(text)?,
            None if path.exists() || is_path(path) => at(path)?,
            None => {
                // It names what is nearest.
                return Err(text.map_or_else(|| no_text(given), library::unknown));
            }
        };
        material.fetch(&files::data_at);
        let missing = material.resources().find(|(_, data)| is_missing(data));
        match missing.and_then(|(_, data)| data.problem()) {
            Some(problem) => Err(Error::parse(shown(&given.to_string_lossy()), problem)),
            None => Ok(material),
        }
    }
}

fn is_missing(data: &Resource) -> bool {
    matches!(data.content(), Content::Missing(_))
}

fn no_text(given: &OsStr) -> Error {
    let problem = "there is no such file, and other names are UTF-8 text";
    let place = format!("material '{}'", shown(&given.to_string_lossy()));
    Error::parse(place, problem)
}

/// Whether the path ends as those of material files do.
fn ends_in_toml(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// Whether a name that nothing has can only have been meant as a path.
fn is_path(path: &Path) -> bool {
    let is_assigned = path.to_string_lossy().contains(':');
    let ends_in_data = || {
        formats().any(|(_, spec)| {
            let mut decoders = spec.decoders.iter();
            decoders.any(|decoder| decoder.has_extension(path))
        })
    };
    ends_in_toml(path) || (!is_assigned && (path.components().count() > 1 || ends_in_data()))
}

/// Reads the file of a material, or of data, at `path`.
fn at(path: &Path) -> Result<Material> {
    let is_text = ends_in_toml(path) || !path.is_file();
    if !is_text && let Some(material) = Material::of_data(&files::data_at(path)?, Some(path)) {
        return material;
    }
    let place = path.display().to_string();
    let text = files::text_at(path, MATERIAL_FILE)?;
    let mut material = file::parse(&text, &place).map_err(|error| match error {
        Error::Parse { place, problem } if !ends_in_toml(path) => {
            Error::parse(place, format!("{problem}; {MATERIAL_FILE}"))
        }
        other => other,
    })?;
    material.rooted_at(path.parent().unwrap_or(Path::new("")));
    Ok(material)
}
