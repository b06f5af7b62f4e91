//! What several verbs read from their arguments.

use std::ffi::OsStr;
use std::path::Path;

use clap::builder::{OsStringValueParser, TypedValueParser};
use xprec::Df64;

use super::say::say;
use bxdf::Material;
use bxdf::error::{Error, Result, shown};
use bxdf::material::{self, library};
use bxdf::math::Real;
use bxdf_lab::contract::check_energy;
use bxdf_study::files;

/// The word that stands for standard input or output.
pub(super) const STANDARD_STREAM: &str = "-";

/// Whether `path` stands for standard input or output.
pub(super) fn is_standard_stream(path: &Path) -> bool {
    path == Path::new(STANDARD_STREAM)
}

/// A material, and how it was given.
#[derive(Clone, Debug)]
pub(super) struct Given {
    material: Material,
    text: String,
    is_file: bool,
}

impl Given {
    /// The material. Where it is a file whose lobes create energy, one line on standard error says so.
    pub(super) fn checked(&self) -> &Material {
        if self.is_file
            && let Some(report) = check_energy(&self.material)
            && let Some(sentence) = report.sentence()
        {
            say(&format!(
                "warning: {} creates energy: {sentence}",
                self.text
            ));
        }
        &self.material
    }

    /// How it was given.
    pub(super) fn text(&self) -> &str {
        &self.text
    }
}

/// What a file of a material is.
const MATERIAL_FILE: &str = "a material is read from TOML text (.toml) with [[lobes]]";

/// The parser of materials, which may be paths that are no text.
pub(super) fn material() -> impl TypedValueParser<Value = Given> {
    OsStringValueParser::new().try_map(|given| read_material(&given))
}

/// Reads a material: the id of a model, `id:name=value,name=value`, the id of a named material, or the path of a material
/// file, whatever its name ends in.
fn read_material(given: &OsStr) -> Result<Given> {
    let path = Path::new(given);
    let text = given.to_string_lossy().into_owned();
    let is_text = given.to_str().is_some();
    if is_text && library::is_known(&text) {
        return Ok(Given {
            material: library::read(&text)?,
            text,
            is_file: false,
        });
    }
    if path.exists() || is_path(path) {
        return Ok(Given {
            material: material_at(path)?,
            text,
            is_file: true,
        });
    }
    Err(if is_text {
        // It names what is nearest.
        library::unknown(&text)
    } else {
        let problem = "there is no such file, and other names are UTF-8 text";
        Error::parse(format!("material '{}'", shown(&text)), problem)
    })
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
    let text = text_at(path, MATERIAL_FILE)?;
    material::file::parse(&text, &place).map_err(|error| match error {
        Error::Parse { place, problem } if !ends_in_toml(path) => {
            Error::parse(place, format!("{problem}; {MATERIAL_FILE}"))
        }
        other => other,
    })
}

/// Reads the text of a file; `wanted` says what one is where there is none.
///
/// # Errors
/// Where it cannot be read, is longer than [`files::MAX_TEXT`], and where there is no text in it.
pub(super) fn text_at(path: &Path, wanted: &str) -> Result<String> {
    let refused = |problem: &str| {
        let problem = format!("{problem}; {wanted}");
        Err(Error::parse(path.display().to_string(), problem))
    };
    if path.is_dir() {
        return refused("is a folder");
    }
    let text = match files::text_at(path) {
        Err(Error::Parse { .. }) => return refused("holds no text"),
        text => text?,
    };
    if text.contains('\0') {
        return refused("holds no text");
    }
    if text.trim().is_empty() {
        return refused("is empty");
    }
    Ok(text)
}

/// A precision, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PrecisionName {
    F32,
    F64,
    Reference,
}

/// Reads the name of a precision.
pub(super) fn precision(text: &str) -> Result<PrecisionName> {
    choice(
        "precision",
        text,
        &[
            (<f32 as Real>::NAME, PrecisionName::F32),
            (<f64 as Real>::NAME, PrecisionName::F64),
            (<Df64 as Real>::NAME, PrecisionName::Reference),
        ],
    )
}

/// Reads the name of a precision that the machine has.
pub(super) fn native_precision(text: &str) -> Result<PrecisionName> {
    choice(
        "native precision",
        text,
        &[
            (<f32 as Real>::NAME, PrecisionName::F32),
            (<f64 as Real>::NAME, PrecisionName::F64),
        ],
    )
}

/// The value that the word `text` names among `choices`.
///
/// # Errors
/// [`Error::UnknownId`] about `what`, with the nearest words.
pub(super) fn choice<T: Copy>(
    what: &'static str,
    text: &str,
    choices: &[(&'static str, T)],
) -> Result<T> {
    choices
        .iter()
        .find(|(word, _)| *word == text)
        .map(|(_, value)| *value)
        .ok_or_else(|| Error::unknown(what, text, choices.iter().map(|(word, _)| *word)))
}

/// A direction in spherical coordinates, in degrees: theta from n, 0 to 180, and phi from s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Angles {
    pub(super) theta_deg: f64,
    pub(super) phi_deg: f64,
}

/// Reads `THETA,PHI`.
pub(super) fn angles(text: &str) -> Result<Angles> {
    let [theta, phi] = text
        .split(',')
        .collect::<Vec<_>>()
        .try_into()
        .map_err(|_| {
            Error::parse(
                format!("direction '{}'", shown(text)),
                "expected THETA,PHI in degrees",
            )
        })?;
    Ok(Angles {
        theta_deg: polar_angle(theta)?,
        phi_deg: azimuth(phi)?,
    })
}

/// Reads a polar angle in degrees, 0 to 180.
pub(super) fn polar_angle(text: &str) -> Result<f64> {
    finite(text)
        .filter(|theta| (0.0..=180.0).contains(theta))
        .ok_or_else(|| {
            Error::parse(
                format!("theta '{}'", shown(text)),
                "expected 0 to 180 degrees",
            )
        })
}

/// Reads an azimuth in degrees, any finite number.
pub(super) fn azimuth(text: &str) -> Result<f64> {
    finite(text).ok_or_else(|| {
        Error::parse(
            format!("phi '{}'", shown(text)),
            "expected a finite number of degrees",
        )
    })
}

/// Reads a number of things.
pub(super) fn count(text: &str) -> Result<u64> {
    let number = text.trim().parse();
    number.map_err(|_| Error::parse(format!("'{}'", shown(text)), "expected a whole number"))
}

/// The finite number that `text` stands for.
pub(super) fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_two_angles() {
        let read = angles("180, -30.5").unwrap();
        assert_eq!((read.theta_deg, read.phi_deg), (180.0, -30.5));
        for (text, expected) in [
            ("30", "direction '30': expected THETA,PHI in degrees"),
            (
                "30,40,50",
                "direction '30,40,50': expected THETA,PHI in degrees",
            ),
            ("-1,0", "theta '-1': expected 0 to 180 degrees"),
            ("nan,0", "theta 'nan': expected 0 to 180 degrees"),
            ("180.5,0", "theta '180.5': expected 0 to 180 degrees"),
            ("30,inf", "phi 'inf': expected a finite number of degrees"),
            ("30,", "phi '': expected a finite number of degrees"),
        ] {
            assert_eq!(angles(text).unwrap_err().to_string(), expected);
        }
    }

    #[test]
    fn precisions_go_by_their_names() {
        assert_eq!(precision("reference").unwrap(), PrecisionName::Reference);
        assert_eq!(
            precision("f16").unwrap_err().to_string(),
            "unknown precision 'f16'; nearest: f32, f64, reference"
        );
    }
}
