//! What several verbs read from their arguments.

use std::ffi::OsStr;
use std::path::Path;

use clap::builder::{OsStringValueParser, TypedValueParser};
use xprec::Df64;

use super::say::say;
use bxdf::Material;
use bxdf::error::{Error, Result, shown};
use bxdf::material::library;
use bxdf::math::Real;
use bxdf_lab::contract::check_energy;

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

/// The parser of materials, which may be paths that are no text.
pub(super) fn material() -> impl TypedValueParser<Value = Given> {
    OsStringValueParser::new().try_map(|given| read_material(&given))
}

/// Reads what [`Material::open`] opens.
fn read_material(given: &OsStr) -> Result<Given> {
    let text = given.to_string_lossy().into_owned();
    Ok(Given {
        material: Material::open(given)?,
        is_file: !library::is_known(&text),
        text,
    })
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
