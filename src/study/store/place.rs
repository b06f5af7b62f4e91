//! Putting files into their places: what is written stands complete in its place, or the file before it does, and what was
//! there before is kept.

use std::collections::HashMap;
use std::ffi::OsString;
use std::hash::Hasher as _;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHasher;

use super::partial::Partial;
use super::{Files, Found};
use crate::files::{MAX_DATA, MAX_TEXT, text_of};
use crate::readers;
use crate::session::{Opened, Session};
use bxdf::error::{Error, Result};

/// How many files that cannot be read are set aside beside one, before it is refused to be written over.
const MOST_ASIDE: u32 = 99;

/// Files that are put into their places.
#[derive(Clone)]
pub(super) struct Places {
    pub(super) files: Arc<dyn Files>,
    /// The texts that were found good, or written, by their digests: they are not read through again and again.
    good: Arc<Mutex<HashMap<PathBuf, u64>>>,
}

impl Places {
    pub(super) fn new(files: Arc<dyn Files>) -> Self {
        Self {
            files,
            good: Arc::default(),
        }
    }

    /// The session or material at `path`. This is the one judgement of what can be read.
    ///
    /// # Errors
    /// Where it cannot be read, is larger than [`MAX_TEXT`], and where it is neither.
    pub(super) fn read(&self, path: &Path) -> Result<Opened> {
        let bytes = self.bytes(path, readers::limit(path))?;
        let digest = digest(&bytes);
        let mut opened = readers::read(bytes, path)?;
        let own = self.files.behind_links(path);
        opened.rooted_at(&folder_of(&own.map_err(|error| Error::io(path, error))?));
        opened.read_files(&|path| self.data(path));
        self.note(path, digest);
        Ok(opened)
    }

    /// The bytes of a file of data, which a text names: a pipe among them would keep whoever reads it waiting.
    ///
    /// # Errors
    /// Where there is no file, and where it cannot be read or is larger than [`MAX_DATA`].
    pub(super) fn data(&self, path: &Path) -> Result<Vec<u8>> {
        match self.files.look(path) {
            Ok(Found::File) => self.bytes(path, MAX_DATA),
            Ok(other) => Err(Error::io(path, no_file(other))),
            Err(error) => Err(Error::io(path, error)),
        }
    }

    fn bytes(&self, path: &Path, limit: u64) -> Result<Vec<u8>> {
        let read = self.files.read(path, limit);
        read.map_err(|error| Error::io(path, error))
    }

    /// The text of the file at `path`.
    ///
    /// # Errors
    /// Where it cannot be read, is larger than [`MAX_TEXT`], or is no text.
    pub(super) fn text(&self, path: &Path) -> Result<String> {
        text_of(self.bytes(path, MAX_TEXT)?, path)
    }

    /// Writes `session` in place of the file at `path`. What was there is kept: as the backup where it can be read, else
    /// under a name that is free, with the backup as it was. Returns that name. Where `path` is a link, it stays, and all this is
    /// done where it leads.
    ///
    /// # Errors
    /// Where it cannot be written, and where nobody would read it again; the files that were there are as they were.
    pub(super) fn replace(&self, path: &Path, session: &Session) -> Result<Option<PathBuf>> {
        let own = self.files.behind_links(path);
        let path = &*own.map_err(|error| Error::io(path, error))?;
        session.require_fit()?;
        let text = session.relative_to(&folder_of(path)).to_toml()?;
        let before = self.before(path);
        let aside = match before {
            Before::Unreadable => Some(self.aside(path)?),
            Before::Nothing | Before::Good => None,
        };
        self.put(path, text.as_bytes(), || match &aside {
            Some(aside) => self.files.rename(path, aside),
            None if matches!(before, Before::Good) => self.back_up(path),
            None => Ok(()),
        })?;
        self.note(path, digest(text.as_bytes()));
        Ok(aside)
    }

    /// Writes `bytes` beside the file at `path`, then moves them into its place; `make_room`: what is done in between.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub(super) fn put(
        &self,
        path: &Path,
        bytes: &[u8],
        make_room: impl FnOnce() -> io::Result<()>,
    ) -> Result<()> {
        let failed = |error| Error::io(path, error);
        match self.files.look(path) {
            Ok(Found::File) | Err(_) => {}
            Ok(other) => return Err(failed(no_file(other))),
        }
        let partial = Partial::of(&*self.files, path).map_err(failed)?;
        let written = self.files.write(partial.path(), bytes);
        let moved = written.and_then(|()| make_room()).and_then(|()| {
            // Where this fails, what was there has another name by now, which is found at the next start.
            partial.complete()
        });
        moved.map_err(failed)
    }

    /// Makes the file at `path` its backup; a backup that cannot be read is set aside first.
    fn back_up(&self, path: &Path) -> io::Result<()> {
        let backup = backup(path);
        if matches!(self.before(&backup), Before::Unreadable) {
            let aside = self.aside(&backup).map_err(io::Error::other)?;
            self.files.rename(&backup, &aside)?;
        }
        self.files.rename(path, &backup)?;
        let mut good = self.good.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(digest) = good.remove(path) {
            good.insert(backup, digest);
        }
        Ok(())
    }

    /// What stands where something is to be written.
    fn before(&self, path: &Path) -> Before {
        match self.files.read(path, MAX_TEXT) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Before::Nothing,
            Err(_) => return Before::Unreadable,
            Ok(bytes) if self.is_noted(path, &bytes) => return Before::Good,
            Ok(_) => {}
        }
        match self.read(path) {
            Ok(_) => Before::Good,
            Err(_) => Before::Unreadable,
        }
    }

    /// A name that is free, for the file at `path` that cannot be read.
    ///
    /// # Errors
    /// `AlreadyExists` where there are [`MOST_ASIDE`].
    pub(super) fn aside(&self, path: &Path) -> Result<PathBuf> {
        let names = (1..=MOST_ASIDE).map(|n| with_suffix(path, &format!(".unreadable-{n}")));
        let is_free = |path: &PathBuf| {
            let found = self.files.look(path);
            found.is_err_and(|error| error.kind() == io::ErrorKind::NotFound)
        };
        let mut free = names.filter(is_free);
        free.next()
            .ok_or_else(|| Error::io(path, io::ErrorKind::AlreadyExists.into()))
    }

    /// Takes note that bytes of this digest stand at `path`, and can be read.
    fn note(&self, path: &Path, digest: u64) {
        let mut good = self.good.lock().unwrap_or_else(PoisonError::into_inner);
        good.insert(path.to_owned(), digest);
    }

    fn is_noted(&self, path: &Path, bytes: &[u8]) -> bool {
        let good = self.good.lock().unwrap_or_else(PoisonError::into_inner);
        good.get(path) == Some(&digest(bytes))
    }
}

/// Why what was found is no file.
fn no_file(found: Found) -> io::Error {
    match found {
        Found::Folder => io::ErrorKind::IsADirectory.into(),
        Found::File | Found::Other => io::Error::other("a device or a pipe, no file"),
    }
}

/// What stands where something is to be written.
#[derive(Clone, Copy)]
enum Before {
    Nothing,
    Good,
    Unreadable,
}

fn digest(bytes: &[u8]) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write(bytes);
    hasher.finish()
}

/// The folder of the file at `path`, from the root on: what is named from it on is found wherever the program is started.
fn folder_of(path: &Path) -> PathBuf {
    let folder = path.parent().unwrap_or(Path::new(""));
    // A browser has no root.
    std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned())
}

/// The place of the last good file before the one at `path`.
pub(super) fn backup(path: &Path) -> PathBuf {
    with_suffix(path, ".bak")
}

pub(super) fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.file_name().map_or_else(OsString::new, OsString::from);
    name.push(suffix);
    path.with_file_name(name)
}
