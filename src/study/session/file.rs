//! A session as the text of its file.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use toml::de::{DeTable, DeValue, Deserializer, ValueDeserializer};
use toml::{Spanned, Table, Value};

use super::Session;
use super::layout::Place;
use super::stored_views::{self, Written};
use super::written;
use crate::views::Scale;
use bxdf::error::{Error, Result};
use bxdf_lab::analysis::RadialScale;

/// The version of the file. It grows when an older program would read a newer file as something else.
///
/// In version 1 the views of the layout were ids, and the options of all kinds stood under `views`. Up to version 2 one key
/// `scale` said how polar plots and lobes turn values into radii; since then each view does. All versions are read by the same
/// reader, and so are files without one.
pub const VERSION: u64 = 3;

/// The first line of what is written.
const HEADER: &str = "# BRDF Explorer session";

/// The last line of what begins with the first one.
const END: &str = "# End of the session";

/// A session that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// The session.
    pub session: Session,
    /// What is left out of it, because this program knows nothing of it: a line each.
    pub left_out: Vec<String>,
}

/// The session with its views, as one table.
#[derive(Serialize)]
struct Whole<'a> {
    #[serde(flatten)]
    session: &'a Session,
    #[serde(flatten)]
    views: Written<'a>,
}

impl Session {
    /// Reads a session from TOML text; `place` names it in errors.
    ///
    /// # Errors
    /// [`Error::Parse`] where the text is no session, is one of a newer version or is cut off, and where a number is out of
    /// its range.
    pub fn read_toml(text: &str, place: &str) -> Result<Read> {
        if text.starts_with(HEADER) && !text.trim_end().ends_with(END) {
            return Err(Error::parse(
                place,
                "the file is cut off: its last line is missing",
            ));
        }
        let refused = |error: toml::de::Error| refused(text, place, &error);
        let mut document = DeTable::parse(text).map_err(refused)?;
        let at = |start, problem| Error::parse(located(text, place, start), problem);
        if let Some((start, problem)) = written::repeated(document.get_ref()) {
            return Err(at(start, problem));
        }
        let table = document.get_mut();
        check_version(table.remove("version"), place)?;
        let layout: Option<Place<Spanned<Value>>> = taken(table, "layout").map_err(refused)?;
        let closed: Option<BTreeMap<String, Spanned<Table>>> =
            taken(table, "views").map_err(refused)?;
        let scale: Option<RadialScale> = taken(table, "scale").map_err(refused)?;
        let mut session = Self::deserialize(Deserializer::from(document)).map_err(refused)?;
        let views = stored_views::read(layout, closed.unwrap_or_default());
        let (views, left_out) = views.map_err(|(start, problem)| at(start, problem))?;
        session.views = views;
        if let Some(lengths) = scale {
            session.views.scale_radii(Scale::of(lengths));
        }
        let numbers = session.check_numbers();
        numbers.map_err(|number| match written::start_of(text, &number) {
            Some(start) => at(start, number.to_string()),
            None => Error::parse(place, number.to_string()),
        })?;
        let left_out = left_out.iter().map(|line| format!("{place}: {line}"));
        Ok(Read {
            left_out: left_out.collect(),
            session,
        })
    }

    /// [`Self::read_toml`], where nobody is to be told what is left out.
    ///
    /// # Errors
    /// The same.
    pub fn from_toml(text: &str, place: &str) -> Result<Self> {
        Self::read_toml(text, place).map(|read| read.session)
    }

    /// The session as TOML text, with the version and a last line by which a part of it is told from the whole.
    ///
    /// # Errors
    /// [`Error::Parse`] if it cannot be written, which no session does.
    pub fn to_toml(&self) -> Result<String> {
        let written = |session| {
            let views = Written::of(&self.views)?;
            toml::to_string(&Whole { session, views })
        };
        let body = written(self).map_err(|error| Error::parse("session", error.to_string()))?;
        Ok(format!("{HEADER}\nversion = {VERSION}\n{body}\n{END}\n"))
    }
}

/// Takes what stands under a key of the document.
fn taken<'de, T: Deserialize<'de>>(
    table: &mut DeTable<'de>,
    key: &str,
) -> std::result::Result<Option<T>, toml::de::Error> {
    let value = table.remove(key).map(ValueDeserializer::from);
    value.map(T::deserialize).transpose()
}

/// Refuses a version that is newer than this program.
fn check_version(version: Option<Spanned<DeValue<'_>>>, place: &str) -> Result<()> {
    let Some(version) = version else {
        return Ok(());
    };
    let version: Option<u64> = match version.get_ref() {
        DeValue::Integer(number) => number.as_str().parse().ok(),
        _ => None,
    };
    match version {
        Some(0..=VERSION) => Ok(()),
        Some(newer) => {
            let problem = format!(
                "a session of version {newer}; this program reads up to version {VERSION}: a newer one is needed"
            );
            Err(Error::parse(place, problem))
        }
        None => Err(Error::parse(place, "the version is no whole number")),
    }
}

/// What the reader of TOML refuses, with the line.
fn refused(text: &str, place: &str, error: &toml::de::Error) -> Error {
    let start = error.span().map_or(0, |span| span.start);
    let problem = error.message().replace('\n', " ");
    Error::parse(located(text, place, start), problem)
}

/// `place`, with the line of the text that holds its byte `start`.
fn located(text: &str, place: &str, start: usize) -> String {
    let before = text.get(..start).unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    format!("{place}: line {line}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Materials;
    use crate::views::{DECADES, cartesian, lobe3d, polar};
    use bxdf_lab::analysis::Hold;

    #[test]
    fn toml_round_trips() {
        let session = Session {
            materials: Materials::of("oren_nayar:sigma=35".parse().unwrap()),
            hold: Hold::Viewer,
            section_phi_deg: Some(30.0),
            ..Session::default()
        };
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, "test").unwrap(), session);
        assert_eq!(Session::from_toml("", "test").unwrap(), Session::default());
    }

    /// What older programs wrote, and hands may write.
    #[test]
    fn one_scale_is_that_of_every_polar_plot_and_lobe() {
        let own = "{ kind = \"polar\", scale.is_each_to_peak = true }";
        let plots = format!("[{own}, \"polar\", \"lobe3d\", \"cartesian\"]");
        let text = format!(
            "scale.logarithmic.decades = 3.0\nlayout.tabs.views = {plots}\n[views.cartesian]\nis_logarithmic = true\nis_normalised = true"
        );
        let views = Session::from_toml(&text, "s").unwrap().views;
        let by_decades = |decades| Scale::of(RadialScale::Logarithmic { decades });
        let scales = views
            .all::<polar::Options>()
            .into_iter()
            .map(|plot| plot.scale);
        let own = Scale {
            is_each_to_peak: true,
            ..Scale::default()
        };
        assert!(scales.eq([own, by_decades(3.0)]));
        assert_eq!(views.options::<lobe3d::Options>().scale, by_decades(3.0));
        let cartesian = views.options::<cartesian::Options>().scale;
        let expected = Scale {
            is_each_to_peak: true,
            ..by_decades(DECADES)
        };
        assert_eq!(cartesian, expected);
        // It stays as it is written again.
        let mut session = Session::from_toml(&text, "s").unwrap();
        session.views.each_scale(|scale| scale.lock(Some(0.5)));
        let again = session.to_toml().unwrap();
        assert!(!again.contains("\nscale") && again.contains("locked_at = 0.5"));
        assert_eq!(Session::from_toml(&again, "again").unwrap(), session);
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
        let newer = text.replace("version = 3", "flavour = 3\nversion = 4");
        let line = Session::from_toml(&newer, "s.toml")
            .unwrap_err()
            .to_string();
        assert!(
            line.starts_with("s.toml: a session of version 4;"),
            "{line}"
        );
        assert!(Session::from_toml("version = \"x\"", "s").is_err());
        assert_eq!(
            Session::from_toml("version = 1", "s").unwrap(),
            Session::default()
        );
    }
}
