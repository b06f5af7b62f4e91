//! The session that a picture begins with: that of a file, or of a link.

use std::path::Path;

use crate::cli::say;
use bxdf::error::{Error, Result};
use bxdf_study::files;
use bxdf_study::link::{self, Linked};
use bxdf_study::session::{Opened, Session};

/// What a file of a session is.
const SESSION_FILE: &str = "a session is read from TOML text, as the window saves it";

/// The session of the file at `path`, or of the link that stands in its place; what there is to say of it is said.
///
/// # Errors
/// Where the file cannot be read, where the link leads to a lesson, and what readers refuse.
pub(super) fn read(path: &Path) -> Result<Session> {
    let fragment = path.to_str().and_then(link::fragment_of);
    let mut opened = match fragment.map(link::read).transpose()? {
        Some(Linked::Session(opened)) => opened,
        Some(Linked::Step(named)) => {
            let problem = format!("the link is to a lesson: --lesson {named}");
            return Err(Error::parse("--session", problem));
        }
        None => {
            let text = files::text_at(path, SESSION_FILE)?;
            let mut read = Session::read_toml(&text, &path.display().to_string())?;
            let folder = path.parent().unwrap_or(Path::new(""));
            read.session.rooted_at(folder);
            Opened::Session(Box::new(read))
        }
    };
    if let Opened::Session(read) = &mut opened {
        read.session.fetch(&files::data_at);
    }
    opened.remarks().iter().for_each(|line| say::say(line));
    Ok(opened.into_session())
}
