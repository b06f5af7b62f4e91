//! Links: a whole session, or a step of a lesson, in the address of a page.
//!
//! A session stands in the fragment of an address, `#s=`, as the text of its file, compressed by zlib and written in the
//! letters of base64 that addresses may hold. Materials of the library stand there by their names. A step of a lesson is
//! `#lesson=06-lambert.2`. A fragment is sent to no server.
//!
//! A link comes from anybody: it names no path and is read within limits, and what it names that is not in it is missing.

mod shortened;

use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;
use toml::{Table, Value};

use crate::session::{Opened, Session};
use bxdf::error::{Error, Result, shown};
use bxdf::resource::Origin;

/// What comes before a session.
const SESSION: &str = "#s=";

/// What comes before a step of a lesson.
const STEP: &str = "#lesson=";

/// The most bytes of the text in a link, before it was compressed.
pub const MOST_TEXT: u64 = 1 << 20;

/// The most materials in a link.
pub const MOST_MATERIALS: usize = 16;

/// How deep tables and lists may stand in one another in a link.
const MOST_NESTED: usize = 32;

/// What links are called in errors.
const PLACE: &str = "link";

/// What a link leads to.
#[derive(Clone, Debug, PartialEq)]
pub enum Linked {
    /// A session.
    Session(Opened),
    /// A lesson and the step of it, as the command line names them: `06-lambert.2`.
    Step(String),
}

/// A link that was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// The fragment, from `#` on.
    pub fragment: String,
    /// What is not in it, as names.
    pub left_behind: Vec<String>,
}

/// The link to a session. Data in files does not travel: whoever follows the link is told what is missing.
///
/// # Errors
/// [`Error::Limit`] where the session is larger than links may be.
pub fn to_session(session: &Session) -> Result<Made> {
    let count = session.materials.count();
    if count > MOST_MATERIALS {
        return Err(Error::Limit {
            what: "the number of materials in a link",
            value: count.to_string(),
            limit: MOST_MATERIALS.to_string(),
        });
    }
    let (session, left_behind) = without_folders(session);
    let whole = parsed(&session.to_toml()?)?;
    let text = shortened::short(whole).to_string();
    if text.len() as u64 > MOST_TEXT {
        return Err(too_long());
    }
    Ok(Made {
        fragment: format!("{SESSION}{}", packed(&text).map_err(unpackable)?),
        left_behind,
    })
}

/// The link to a step of a lesson; `named` as the command line names it: `06-lambert.2`.
#[must_use]
pub fn to_step(named: &str) -> String {
    format!("{STEP}{named}")
}

/// The link in a text that is one, from `#` on: an address that ends in it, or nothing but it. `None` for any other text.
#[must_use]
pub fn fragment_of(text: &str) -> Option<&str> {
    let text = text.trim();
    let (before, _) = text.split_once('#')?;
    let is_address = before.is_empty() || before.contains("://");
    let fragment = text.get(before.len()..)?;
    let is_link = [SESSION, STEP]
        .iter()
        .any(|kind| fragment.starts_with(kind));
    (is_link && is_address && !text.contains(char::is_whitespace)).then_some(fragment)
}

/// The lesson and the step that a text leads to, as the command line names them, where it is a link to one.
#[must_use]
pub fn step_in(text: &str) -> Option<&str> {
    fragment_of(text)?.strip_prefix(STEP)
}

/// What a link leads to; `fragment` from `#` on.
///
/// # Errors
/// [`Error::Parse`] where it is cut off or damaged, and what readers of sessions refuse, a newer version among it;
/// [`Error::Limit`] where it is larger than links may be.
pub fn read(fragment: &str) -> Result<Linked> {
    if let Some(named) = fragment.strip_prefix(STEP) {
        return Ok(Linked::Step(named.to_owned()));
    }
    let Some(packed) = fragment.strip_prefix(SESSION) else {
        let problem = format!(
            "'{}' is none: a link has {SESSION} or {STEP}",
            shown(fragment)
        );
        return Err(Error::parse(PLACE, problem));
    };
    let short = parsed(&unpacked(packed)?)?;
    require_flat(&short)?;
    let materials = short.get("materials").and_then(Value::as_array);
    if let Some(count) = materials
        .map(Vec::len)
        .filter(|count| *count > MOST_MATERIALS)
    {
        return Err(Error::Limit {
            what: "the number of materials in a link",
            value: count.to_string(),
            limit: MOST_MATERIALS.to_string(),
        });
    }
    let mut read = Session::read_toml(&shortened::whole(short)?.to_string(), PLACE)?;
    strand(&mut read.session);
    read.session.require_fit()?;
    Ok(Linked::Session(Opened::Session(Box::new(read))))
}

/// The session with the names of its files alone, and those names.
fn without_folders(session: &Session) -> (Session, Vec<String>) {
    let (mut session, mut names) = (session.clone(), Vec::new());
    session.map_resources(&mut |resource| {
        resource.map_path(|path| Some(file_name(path)));
        if matches!(resource.origin(), Origin::File(_)) && !resource.is_embedded() {
            names.push(resource.name());
        }
    });
    names.sort();
    names.dedup();
    (session, names)
}

/// Lets nothing be looked for on the disk: what a link does not hold is missing, whatever it says of folders.
fn strand(session: &mut Session) {
    session.map_resources(&mut |resource| {
        resource.map_path(|path| Some(file_name(path)));
        if matches!(resource.origin(), Origin::File(_)) {
            resource.strand("it does not travel with a link: drop the file here");
        }
    });
}

fn file_name(path: &Path) -> PathBuf {
    // Separators of other systems may stand in it, too.
    let text = path.to_string_lossy();
    let name = text
        .rsplit(['/', '\\'])
        .find(|part| !matches!(*part, "" | "." | ".."));
    PathBuf::from(name.unwrap_or("data"))
}

fn packed(text: &str) -> io::Result<String> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes())?;
    Ok(BASE64_URL_SAFE_NO_PAD.encode(encoder.finish()?))
}

fn unpacked(packed: &str) -> Result<String> {
    let damaged = || Error::parse(PLACE, "it is cut off or damaged; nothing is changed");
    let bytes = BASE64_URL_SAFE_NO_PAD.decode(packed.trim_end_matches('='));
    let bytes = bytes.map_err(|_| damaged())?;
    let mut text = Vec::new();
    let read = ZlibDecoder::new(&*bytes)
        .take(MOST_TEXT + 1)
        .read_to_end(&mut text);
    if read.map_err(|_| damaged())? as u64 > MOST_TEXT {
        return Err(too_long());
    }
    String::from_utf8(text).map_err(|_| damaged())
}

fn too_long() -> Error {
    Error::Limit {
        what: "the text of a link",
        value: format!("more than {}", crate::files::in_words(MOST_TEXT)),
        limit: format!("{}: save a file instead", crate::files::in_words(MOST_TEXT)),
    }
}

fn unpackable(error: io::Error) -> Error {
    Error::io(Path::new(PLACE), error)
}

fn parsed(text: &str) -> Result<Table> {
    let parsed = text.parse::<Table>();
    parsed.map_err(|error| Error::parse(PLACE, error.message()))
}

fn require_flat(table: &Table) -> Result<()> {
    fn depth(value: &Value) -> usize {
        let within = match value {
            Value::Array(values) => values.iter().map(depth).max(),
            Value::Table(table) => table.values().map(depth).max(),
            _ => None,
        };
        within.unwrap_or(0) + 1
    }
    let depth = table.values().map(depth).max().unwrap_or(0);
    if depth > MOST_NESTED {
        return Err(Error::Limit {
            what: "the nesting of tables in a link",
            value: depth.to_string(),
            limit: MOST_NESTED.to_string(),
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
