//! Materials by whatever names them: text, the name of one of the library, or the path of a file.

use std::ffi::OsStr;
use std::path::Path;

use super::{Material, file, library};
use crate::error::{Error, Result, shown};
use crate::files;

/// What a file of a material is.
const MATERIAL_FILE: &str = "a material is read from TOML text (.toml) with [[lobes]]";

impl Material {
    /// The material that `given` names: a model, as `id` or `id:name=value,name=value`; the id of a named material; or the
    /// path of a material file, whatever its name ends in.
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
    /// files refuse, [`Error::Io`] for a file that cannot be read.
    pub fn open(given: impl AsRef<OsStr>) -> Result<Self> {
        let given = given.as_ref();
        if let Some(text) = given.to_str()
            && library::is_known(text)
        {
            return library::read(text);
        }
        let path = Path::new(given);
        if path.exists() || is_path(path) {
            return material_at(path);
        }
        if let Some(text) = given.to_str() {
            // It names what is nearest.
            return Err(library::unknown(text));
        }
        let problem = "there is no such file, and other names are UTF-8 text";
        let place = format!("material '{}'", shown(&given.to_string_lossy()));
        Err(Error::parse(place, problem))
    }
}

/// Whether the path ends as those of material files do.
fn ends_in_toml(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// Whether a name that nothing has can only have been meant as a path.
fn is_path(path: &Path) -> bool {
    let is_assigned = path.to_string_lossy().contains(':');
    ends_in_toml(path) || (path.components().count() > 1 && !is_assigned)
}

/// Reads the material file at `path`.
fn material_at(path: &Path) -> Result<Material> {
    let place = path.display().to_string();
    let text = files::text_at(path, MATERIAL_FILE)?;
    file::parse(&text, &place).map_err(|error| match error {
        Error::Parse { place, problem } if !ends_in_toml(path) => {
            Error::parse(place, format!("{problem}; {MATERIAL_FILE}"))
        }
        other => other,
    })
}
