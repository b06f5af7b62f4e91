//! Sessions and materials as text, to be copied, pasted and opened.

use std::path::Path;

use toml::de::DeTable;

use super::Session;
use super::data;
use super::entry::MaterialEntry;
use super::file::Read;
use crate::files;
use bxdf::Material;
use bxdf::error::{Error, Result};
use bxdf::material::{file, library};
use bxdf::resource::ReadFile;

/// Where pasted text comes from, in errors.
const PLACE: &str = "clipboard";

/// What a text or a file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Opened {
    /// A whole session, and what is left out of it.
    Session(Box<Read>),
    /// A material, to be added.
    Material(Box<Material>),
}

impl From<Session> for Opened {
    /// All of a session.
    fn from(session: Session) -> Self {
        let left_out = Vec::new();
        Self::Session(Box::new(Read { session, left_out }))
    }
}

impl Opened {
    /// Names files from the root on that are named from `folder` on.
    pub(crate) fn rooted_at(&mut self, folder: &Path) {
        match self {
            Self::Session(read) => read.session.rooted_at(folder),
            Self::Material(material) => material.rooted_at(folder),
        }
    }

    /// Reads the files of data that nobody has read yet.
    pub(crate) fn read_files(&mut self, read: ReadFile<'_>) {
        match self {
            Self::Session(opened) => opened.session.read_files(read),
            Self::Material(material) => data::read_files(material, read),
        }
    }

    /// The session, or a new one of the material.
    #[must_use]
    pub fn into_session(self) -> Session {
        match self {
            Self::Session(read) => read.session,
            Self::Material(material) => Session::of(*material),
        }
    }

    /// What there is to be said of it, a line each: what is left out, and which data is missing or has changed.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        match self {
            Self::Session(read) => read.remarks(),
            Self::Material(material) => data::problems(material).collect(),
        }
    }
}

impl MaterialEntry {
    /// The material as text, with the name the user gave it and all its data: `id:name=value,name=value` where that says all,
    /// else the text of its file.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut material = self.material.with_data();
        if !self.name.is_empty() {
            material.name.clone_from(&self.name);
        }
        material.to_text()
    }
}

/// What a pasted text says: a model with parameters, the id of a named material, the text of a file, or data as it stands in
/// a file.
///
/// # Errors
/// [`Error::Limit`] for a text longer than [`files::MAX_TEXT`], and what readers of sessions and materials refuse.
pub fn pasted(text: &str) -> Result<Opened> {
    files::require_fit("the pasted text", text.len() as u64)?;
    if let Some(data) = Material::of_data(text.as_bytes(), None) {
        return Ok(Opened::Material(Box::new(data?)));
    }
    let trimmed = text.trim();
    let is_line = !trimmed.contains('\n') && !trimmed.contains("[[");
    if is_line && !trimmed.is_empty() {
        let material = library::read(trimmed)?;
        Ok(Opened::Material(Box::new(material)))
    } else {
        read(text, PLACE)
    }
}

/// What the text of a file says: a session, or a material, which has lobes. `place` names it in errors.
///
/// # Errors
/// Where there is nothing in it, and what readers of sessions and materials refuse.
pub fn read(text: &str, place: &str) -> Result<Opened> {
    let table = DeTable::parse(text).map(toml::Spanned::into_inner);
    if table.as_ref().is_ok_and(toml::map::Map::is_empty) {
        return Err(Error::parse(place, "there is nothing in it"));
    }
    let has_lobes = table.is_ok_and(|table| table.contains_key("lobes"));
    if has_lobes {
        let material = file::parse(text, place)?;
        Ok(Opened::Material(Box::new(material)))
    } else {
        let read = Session::read_toml(text, place)?;
        Ok(Opened::Session(Box::new(read)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Materials;

    /// The material that is pasted.
    fn material(text: &str) -> Material {
        match pasted(text).unwrap() {
            Opened::Material(material) => *material,
            Opened::Session(_) => panic!("{text} is a session"),
        }
    }

    #[test]
    fn a_text_restores_the_whole_session() {
        let mut session = Session::of("phong".parse().unwrap());
        session.materials.add("ward".parse().unwrap()).unwrap();
        session.materials.selected_mut().is_visible = false;
        session.theta_deg = 12.5;
        let text = session.to_toml().unwrap();
        let opened = Opened::from(session);
        assert_eq!(pasted(&text).unwrap(), opened);
        assert_eq!(read(&text, "s.toml").unwrap(), opened);
    }

    #[test]
    fn what_is_copied_is_pasted_as_the_same() {
        for id in ["gold", "car_paint", "phong:exponent=20"] {
            let materials = Materials::of(library::read(id).unwrap());
            let text = materials.selected().to_text();
            assert_eq!(material(&text), materials.selected().material, "{text}");
        }
        let mut renamed = Materials::of("phong".parse().unwrap());
        renamed.selected_mut().name = "Wall".to_owned();
        let text = renamed.selected().to_text();
        assert_eq!(material(&text).title(), "Wall");
        assert_eq!(material(" chalk \n").title(), "Chalk");
    }

    #[test]
    fn rubbish_is_refused_in_a_line() {
        let long = "x".repeat(files::MAX_TEXT as usize + 1);
        for (text, expected) in [
            ("", "there is nothing in it"),
            ("# only\n# remarks\n", "there is nothing in it"),
            ("golt", "unknown material 'golt'; nearest: gold"),
            (
                "Dear all,\nthe meeting is on Monday.",
                "clipboard: line 1: ",
            ),
            ("phong:exponent=-3", "phong: exponent = -3: allowed is"),
            (long.as_str(), "is 32.1 MiB of text; the limit is 32 MiB"),
            ("\u{0}\u{1}\u{2}", "unknown material"),
        ] {
            let line = pasted(text).unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }
}
