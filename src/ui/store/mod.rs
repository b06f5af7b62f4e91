//! Where sessions are kept: in files of the user's, and between two runs of the program.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::session::{self, Opened, Session};
use crate::error::{Error, Result};

mod dialogs;
mod files;

#[cfg(not(target_arch = "wasm32"))]
pub use dialogs::Native;
pub use dialogs::{Dialogs, Question};
#[cfg(not(target_arch = "wasm32"))]
pub use files::Disk;
pub use files::Files;

/// The largest file that is read, in bytes: ten times the largest session.
pub const MAX_FILE: u64 = 1 << 20;

/// The session of the last run, in the folder of the program's data.
const LAST_SESSION: &str = "session.toml";

/// The files opened last and the theme chosen, beside it.
const PREFERENCES: &str = "preferences.toml";

/// How many recent files are kept.
const MAX_RECENT: usize = 8;

/// How long an edit may stay unsaved, in seconds: what a crash costs at most.
const DELAY: f64 = 1.0;

/// A theme that was chosen, whatever the system has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ChosenTheme {
    /// Light on dark.
    Dark,
    /// Dark on light.
    Light,
}

/// What belongs to the person, not to a session.
#[derive(Clone, Default, Serialize, Deserialize)]
#[serde(default)]
struct Preferences {
    /// The files opened last, the latest first.
    recent: Vec<PathBuf>,
    /// The theme; the system's where none is chosen.
    theme: Option<ChosenTheme>,
}

/// Files of sessions and materials. Whatever is written stands complete in its place, or the file before it does.
pub struct Store {
    files: Box<dyn Files>,
    /// Where the program keeps its own.
    folder: Option<PathBuf>,
    preferences: Preferences,
    /// The session as it was last kept for the next run.
    kept: Option<Session>,
    /// When the session was first seen to differ from it, in the time of the window.
    changed_at: Option<f64>,
}

impl Store {
    /// A store on `files`, which keeps the program's own in `folder`; without one it keeps nothing for the next run.
    #[must_use]
    pub fn new(files: Box<dyn Files>, folder: Option<PathBuf>) -> Self {
        let mut store = Self {
            files,
            folder,
            preferences: Preferences::default(),
            kept: None,
            changed_at: None,
        };
        store.preferences = store.read_preferences();
        store
    }

    /// The store of this machine, in the folder where programs keep their data.
    #[cfg(not(target_arch = "wasm32"))]
    #[must_use]
    pub fn platform() -> Self {
        let folders = directories::ProjectDirs::from("", "", "brdf-explorer");
        let folder = folders.map(|folders| folders.data_dir().to_owned());
        Self::new(Box::new(Disk), folder)
    }

    /// The session of the last run, or the one before it where that cannot be read; and why it cannot.
    pub fn restore(&mut self) -> (Option<Session>, Option<Error>) {
        let Some(path) = self.own(LAST_SESSION) else {
            return (None, None);
        };
        let mut first_problem = None;
        for path in [path.clone(), backup(&path)] {
            match self.read_session(&path) {
                Ok(session) => {
                    self.kept = first_problem.is_none().then(|| session.clone());
                    return (Some(session), first_problem);
                }
                Err(Error::Io { source, .. }) if source.kind() == std::io::ErrorKind::NotFound => {}
                Err(error) => first_problem = first_problem.or(Some(error)),
            }
        }
        (None, first_problem)
    }

    /// Keeps the session for the next run, a moment after it has changed; `now` in seconds. Returns after how many
    /// seconds it has to be asked again.
    ///
    /// # Errors
    /// Where it cannot be written; it is tried again with the next change.
    pub fn keep(&mut self, session: &Session, now: f64) -> Result<Option<f64>> {
        if self.folder.is_none() || self.kept.as_ref() == Some(session) {
            self.changed_at = None;
            return Ok(None);
        }
        let changed_at = *self.changed_at.get_or_insert(now);
        let left = changed_at + DELAY - now;
        if left > 0.0 {
            return Ok(Some(left));
        }
        self.keep_now(session).map(|()| None)
    }

    /// Keeps the session for the next run, at once.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn keep_now(&mut self, session: &Session) -> Result<()> {
        let Some(path) = self.own(LAST_SESSION) else {
            return Ok(());
        };
        if self.kept.as_ref() == Some(session) {
            return Ok(());
        }
        self.changed_at = None;
        // Whatever becomes of it: it is not tried again in every frame.
        self.kept = Some(session.clone());
        self.make_own_folder()?;
        self.replace(&path, &session.to_toml()?)
    }

    /// Writes the session to a file of the user's.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub fn save(&mut self, path: &Path, session: &Session) -> Result<()> {
        self.replace(path, &session.to_toml()?)?;
        self.remember(path);
        Ok(())
    }

    /// Writes what was exported to a file of the user's.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub fn export(&self, path: &Path, bytes: &[u8]) -> Result<()> {
        self.put(path, bytes, false)
    }

    /// Reads a file of the user's: a session or a material.
    ///
    /// # Errors
    /// Where it cannot be read, is larger than [`MAX_FILE`], and where it is neither.
    pub fn open(&mut self, path: &Path) -> Result<Opened> {
        let opened = session::read(&self.text(path)?, &path.display().to_string())?;
        self.remember(path);
        Ok(opened)
    }

    /// The files opened or saved last, the latest first.
    #[must_use]
    pub fn recent(&self) -> &[PathBuf] {
        &self.preferences.recent
    }

    /// The theme that was chosen last; the system's where there is none.
    #[must_use]
    pub fn theme(&self) -> Option<ChosenTheme> {
        self.preferences.theme
    }

    /// Keeps the theme that is chosen.
    pub fn keep_theme(&mut self, theme: Option<ChosenTheme>) {
        if self.preferences.theme != theme {
            self.preferences.theme = theme;
            self.keep_preferences();
        }
    }

    fn own(&self, name: &str) -> Option<PathBuf> {
        self.folder.as_ref().map(|folder| folder.join(name))
    }

    fn make_own_folder(&self) -> Result<()> {
        match &self.folder {
            Some(folder) => self
                .files
                .make_folder(folder)
                .map_err(|error| Error::io(folder, error)),
            None => Ok(()),
        }
    }

    fn text(&self, path: &Path) -> Result<String> {
        let bytes = self
            .files
            .read(path, MAX_FILE)
            .map_err(|error| Error::io(path, error))?;
        String::from_utf8(bytes).map_err(|_| {
            let place = path.display().to_string();
            Error::parse(place, "no text: neither a session nor a material")
        })
    }

    fn read_session(&self, path: &Path) -> Result<Session> {
        Session::from_toml(&self.text(path)?, &path.display().to_string())
    }

    /// Whether there is a session or a material at `path`.
    fn is_good(&self, path: &Path) -> bool {
        let read = self.text(path).and_then(|text| session::read(&text, ""));
        read.is_ok()
    }

    /// Writes `text` to the file at `path`: beside it first, then moved into its place. What was there before is kept as
    /// the backup, if it can be read: a broken file never takes the place of the last good one.
    fn replace(&self, path: &Path, text: &str) -> Result<()> {
        self.put(path, text.as_bytes(), self.is_good(path))
    }

    /// Writes `bytes` beside the file at `path`, then moves them into its place; `has_backup`: whether what was there is
    /// kept.
    fn put(&self, path: &Path, bytes: &[u8], has_backup: bool) -> Result<()> {
        let temporary = with_suffix(path, ".partial");
        let written = self.files.write(&temporary, bytes).and_then(|()| {
            if has_backup {
                self.files.rename(path, &backup(path))?;
            }
            self.files.rename(&temporary, path)
        });
        written.map_err(|error| {
            // The error that led here is the one to tell.
            let _ = self.files.remove(&temporary);
            Error::io(path, error)
        })
    }

    fn read_preferences(&self) -> Preferences {
        // Where they are missing or broken there are none: nothing but convenience is lost.
        let text = self.own(PREFERENCES).and_then(|path| self.text(&path).ok());
        let mut read: Preferences = text
            .and_then(|text| toml::from_str(&text).ok())
            .unwrap_or_default();
        read.recent.truncate(MAX_RECENT);
        read
    }

    fn remember(&mut self, path: &Path) {
        let recent = &mut self.preferences.recent;
        recent.retain(|other| other != path);
        recent.insert(0, path.to_owned());
        recent.truncate(MAX_RECENT);
        self.keep_preferences();
    }

    fn keep_preferences(&self) {
        if let (Some(path), Ok(text)) = (self.own(PREFERENCES), toml::to_string(&self.preferences))
            && self.make_own_folder().is_ok()
        {
            // What cannot be kept is forgotten with the program.
            let _ = self.files.write(&path, text.as_bytes());
        }
    }
}

/// The place of the last good file before the one at `path`.
fn backup(path: &Path) -> PathBuf {
    with_suffix(path, ".bak")
}

fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.file_name().map_or_else(OsString::new, OsString::from);
    name.push(suffix);
    path.with_file_name(name)
}

#[cfg(test)]
mod tests;
