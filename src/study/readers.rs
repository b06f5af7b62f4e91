//! The formats that files are read in: one list for the command line, dialogs, what is dropped on the window or pasted.
//!
//! A session or a material is text; the other formats are those that the models of the catalogue read their data in.

use std::borrow::Cow;
use std::path::Path;

use crate::files;
use crate::session::{self, Opened};
use bxdf::Material;
use bxdf::error::Result;
use bxdf::material::data;
use bxdf::resource::Decoder;

/// A format that files are read in.
pub trait Reader {
    /// What a file of it is, at the screen.
    fn title(&self) -> Cow<'static, str>;

    /// What the names of its files end in, without the dot and in small letters.
    fn extensions(&self) -> &'static [&'static str];

    /// Whether bytes that begin so are of this format, whatever the name of their file.
    fn begins(&self, bytes: &[u8]) -> bool;

    /// The most bytes that are read.
    fn limit(&self) -> u64;

    /// What the bytes of a file are, all of them.
    ///
    /// # Errors
    /// Where they are broken, naming the file.
    fn read(&self, bytes: Vec<u8>, path: &Path) -> Result<Opened>;
}

/// Sessions and materials, which are text.
struct Document;

impl Reader for Document {
    fn title(&self) -> Cow<'static, str> {
        "Session or material".into()
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["toml"]
    }

    fn begins(&self, _: &[u8]) -> bool {
        // Text begins in any way: it is read where no other format is known.
        false
    }

    fn limit(&self) -> u64 {
        files::MAX_TEXT
    }

    fn read(&self, bytes: Vec<u8>, path: &Path) -> Result<Opened> {
        let text = files::text_of(bytes, path)?;
        session::read(&text, &path.display().to_string())
    }
}

impl Reader for &'static Decoder {
    fn title(&self) -> Cow<'static, str> {
        self.title.into()
    }

    fn extensions(&self) -> &'static [&'static str] {
        self.extensions
    }

    fn begins(&self, bytes: &[u8]) -> bool {
        (self.begins)(bytes)
    }

    fn limit(&self) -> u64 {
        files::MAX_DATA
    }

    fn read(&self, bytes: Vec<u8>, path: &Path) -> Result<Opened> {
        match Material::of_data(&bytes, Some(path)) {
            Some(material) => Ok(Opened::Material(Box::new(material?))),
            // The format is one of the catalogue's: it always is one.
            None => Document.read(bytes, path),
        }
    }
}

/// Every format.
#[must_use]
pub fn all() -> Vec<Box<dyn Reader>> {
    let mut all: Vec<Box<dyn Reader>> = vec![Box::new(Document)];
    let decoders = data::formats().flat_map(|(_, spec)| spec.decoders.iter().copied());
    all.extend(decoders.map(|decoder| Box::new(decoder) as _));
    all
}

fn has_extension(reader: &dyn Reader, path: &Path) -> bool {
    let mut own = reader.extensions().iter();
    path.extension()
        .is_some_and(|extension| own.any(|own| extension.eq_ignore_ascii_case(own)))
}

/// The most bytes of a file of this name that are read.
#[must_use]
pub fn limit(path: &Path) -> u64 {
    let all = all();
    let by_name = all.iter().find(|reader| has_extension(&***reader, path));
    by_name.map_or(files::MAX_TEXT, |reader| reader.limit())
}

/// What the file at `path` holds, whose bytes are these: of the format that its name ends as, or that they begin as.
///
/// # Errors
/// What the reader of the format refuses.
pub fn read(bytes: Vec<u8>, path: &Path) -> Result<Opened> {
    let all = all();
    let by_name = all.iter().find(|reader| has_extension(&***reader, path));
    let found = by_name.or_else(|| all.iter().find(|reader| reader.begins(&bytes)));
    match found {
        Some(reader) => reader.read(bytes, path),
        None => Document.read(bytes, path),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::table::Table;

    fn opened(bytes: &[u8], name: &str) -> Result<Material> {
        match read(bytes.to_vec(), Path::new(name))? {
            Opened::Material(material) => Ok(*material),
            Opened::Session(read) => Ok(read.session.material().clone()),
        }
    }

    #[test]
    fn a_file_is_known_by_its_name_or_by_how_it_begins() {
        let table = Table::even(0.1).to_string();
        for name in ["/f/even.table", "/f/even.TABLE", "/f/even", "/f/even.txt"] {
            let material = opened(table.as_bytes(), name).unwrap();
            assert_eq!(material.title(), "even");
            assert!(material.is_complete() && material.has_data());
        }
        for name in ["a.toml", "a.txt", "a"] {
            assert!(!opened(b"material = \"phong\"", name).unwrap().has_data());
        }
        for (bytes, name, expected) in [
            (&b"wo_x,wo_y\n"[..], "a.table", "a.table: is not HALVES"),
            (b"2x2x2;AAAA", "a", "a: 3 bytes of values"),
            (b"\x89PNG\xff", "a.png", "a.png: no text"),
            (table.as_bytes(), "a.toml", "a.toml: line 1: "),
        ] {
            let line = opened(bytes, name).unwrap_err().to_string();
            assert!(line.starts_with(expected) && !line.contains('\n'), "{line}");
        }
    }

    #[test]
    fn every_format_has_a_name_and_endings_of_its_own() {
        let all = all();
        let endings: Vec<&str> = all.iter().flat_map(|r| r.extensions()).copied().collect();
        let different: std::collections::BTreeSet<&str> = endings.iter().copied().collect();
        assert_eq!(different.len(), endings.len());
        assert!(
            all.len() > 1
                && all
                    .iter()
                    .all(|r| !r.title().is_empty() && !r.extensions().is_empty())
        );
        assert!(limit(Path::new("a.table")) > limit(Path::new("a.toml")));
    }
}
