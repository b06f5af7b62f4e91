//! A session as the text of its file.

use toml::de::{DeTable, DeValue};

use super::Session;
use bxdf::error::{Error, Result};

/// The version of the file. It grows when an older program would read a newer file as something else.
pub const VERSION: u64 = 1;

/// The first line of what is written.
const HEADER: &str = "# BRDF Explorer session";

/// The last line of what begins with the first one.
const END: &str = "# End of the session";

impl Session {
    /// Reads a session from TOML text; `place` names it in errors.
    ///
    /// # Errors
    /// [`Error::Parse`] where the text is no session, is one of a newer version or is cut off, and where a number is out of
    /// its range.
    pub fn from_toml(text: &str, place: &str) -> Result<Self> {
        if text.starts_with(HEADER) && !text.trim_end().ends_with(END) {
            return Err(Error::parse(
                place,
                "the file is cut off: its last line is missing",
            ));
        }
        let text = without_version(text, place)?;
        let mut session: Self =
            toml::from_str(&text).map_err(|error| refused(&text, place, &error))?;
        let numbers = session.check_numbers();
        numbers.map_err(|problem| Error::parse(place, problem))?;
        let layout = session.layout.validate();
        layout.map_err(|problem| Error::parse(place, problem))?;
        Ok(session)
    }

    /// The session as TOML text, with the version and a last line by which a part of it is told from the whole.
    ///
    /// # Errors
    /// [`Error::Parse`] if it cannot be written, which no session does.
    pub fn to_toml(&self) -> Result<String> {
        let body =
            toml::to_string(self).map_err(|error| Error::parse("session", error.to_string()))?;
        Ok(format!("{HEADER}\nversion = {VERSION}\n{body}\n{END}\n"))
    }
}

/// `text` with blanks in place of its version, which is no part of the session.
fn without_version(text: &str, place: &str) -> Result<String> {
    let document = DeTable::parse(text).map_err(|error| refused(text, place, &error))?;
    let Some((key, value)) = document.get_ref().get_key_value("version") else {
        return Ok(text.to_owned());
    };
    let version: Option<u64> = match value.get_ref() {
        DeValue::Integer(number) => number.as_str().parse().ok(),
        _ => None,
    };
    match version {
        Some(0..=VERSION) => {}
        Some(newer) => {
            let problem = format!(
                "a session of version {newer}; this program reads up to version {VERSION}: a newer one is needed"
            );
            return Err(Error::parse(place, problem));
        }
        None => return Err(Error::parse(place, "the version is no whole number")),
    }
    let range = key.span().start..value.span().end;
    let blanks = " ".repeat(range.len());
    let mut text = text.to_owned();
    text.replace_range(range, &blanks);
    Ok(text)
}

/// What the reader of TOML refuses, with the line.
fn refused(text: &str, place: &str, error: &toml::de::Error) -> Error {
    let start = error.span().map_or(0, |span| span.start);
    let before = text.get(..start).unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    Error::parse(
        format!("{place}: line {line}"),
        error.message().replace('\n', " "),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Materials;
    use bxdf_lab::analysis::{Hold, RadialScale};

    #[test]
    fn toml_round_trips() {
        let session = Session {
            materials: Materials::of("oren_nayar:sigma=35".parse().unwrap()),
            hold: Hold::Viewer,
            scale: RadialScale::Logarithmic { decades: 3.0 },
            section_phi_deg: Some(30.0),
            ..Session::default()
        };
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, "test").unwrap(), session);
        assert_eq!(Session::from_toml("", "test").unwrap(), Session::default());
    }

    #[test]
    fn broken_sessions_name_the_line() {
        for (text, expected) in [
            ("hold = \"light\"\ntheta_deg = \"steep\"", "s.toml: line 2"),
            (
                "theta_deg = 200.0",
                "theta_deg = 200: allowed is 0 to 180 degrees",
            ),
            ("material = \"gold\"", "unknown model 'gold'"),
            ("flavour = 1", "unknown field"),
            (
                "scale = { logarithmic = { decades = 1e6 } }",
                "decades = 1000000: allowed is 1 to 16",
            ),
            (
                "scale = { logarithmic = { decades = nan } }",
                "decades = NaN: allowed is 1 to 16",
            ),
        ] {
            let line = Session::from_toml(text, "s.toml").unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }

    #[test]
    fn a_part_of_a_file_is_refused_and_so_is_a_newer_one() {
        let text = Session::default().to_toml().unwrap();
        for length in 0..text.trim_end().len() {
            let part = &text[..length];
            let is_whole_by_its_own_words = !part.starts_with(HEADER);
            assert!(
                is_whole_by_its_own_words || Session::from_toml(part, "s").is_err(),
                "{part}"
            );
        }
        let newer = text.replace("version = 1", "flavour = 3\nversion = 2");
        let line = Session::from_toml(&newer, "s.toml")
            .unwrap_err()
            .to_string();
        assert!(
            line.starts_with("s.toml: a session of version 2;"),
            "{line}"
        );
        assert!(Session::from_toml("version = \"x\"", "s").is_err());
        assert_eq!(
            Session::from_toml("version = 1", "s").unwrap(),
            Session::default()
        );
    }
}
