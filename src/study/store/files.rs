//! The file system, as the window uses it.

use std::any::Any;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use crate::files;

/// What stands at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// A file, or a link to one.
    File,
    /// A folder.
    Folder,
    /// A device, a pipe or the like: nothing that may be moved or replaced.
    Other,
}

/// A hold on a file, until it is dropped.
pub type Held = Box<dyn Any + Send + Sync>;

/// Reading and writing files: the one place of the window that does it, and what tests replace by one that fails.
pub trait Files: Send + Sync {
    /// Reads a file.
    ///
    /// # Errors
    /// The system's; `FileTooLarge` where it holds more than `limit` bytes, which are then not read.
    fn read(&self, path: &Path, limit: u64) -> io::Result<Vec<u8>>;

    /// Writes a file, and returns when it is on the disk.
    ///
    /// # Errors
    /// The system's; some of it may be written then.
    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Gives a file another name, in place of any that has it.
    ///
    /// # Errors
    /// The system's.
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;

    /// Removes a file.
    ///
    /// # Errors
    /// The system's.
    fn remove(&self, path: &Path) -> io::Result<()>;

    /// Makes a folder and those around it, where they are missing.
    ///
    /// # Errors
    /// The system's.
    fn make_folder(&self, path: &Path) -> io::Result<()>;

    /// What stands at `path`.
    ///
    /// # Errors
    /// The system's; `NotFound` where there is nothing.
    fn look(&self, path: &Path) -> io::Result<Found>;

    /// Takes hold of the file at `path`, which is made where it is missing, until what is returned is dropped or the program
    /// ends in whatever way. `None` where another program, or another part of this one, has it.
    ///
    /// # Errors
    /// The system's, where it knows no locks among others.
    fn lock(&self, path: &Path) -> io::Result<Option<Held>>;

    /// Where what is written at `path` belongs: behind the links that stand there, `path` itself where none does.
    ///
    /// # Errors
    /// Where links lead to one another in a circle.
    fn behind_links(&self, path: &Path) -> io::Result<PathBuf> {
        Ok(path.to_owned())
    }

    /// Whether files have places of their own, where they are found again: in a browser they have none.
    fn has_places(&self) -> bool {
        true
    }
}

/// The most links that are followed one after the other, as many as Linux follows.
const MAX_LINKS: usize = 40;

/// The files of this machine.
#[derive(Clone, Copy, Debug)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path, limit: u64) -> io::Result<Vec<u8>> {
        files::read_bytes(File::open(path)?, limit)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        use std::io::Write as _;

        let mut file = File::create(path)?;
        file.write_all(bytes)?;
        file.sync_all()
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        std::fs::rename(from, to)?;
        // The name is on the disk when its folder is; where folders cannot be synced there is no more to be done.
        #[cfg(unix)]
        if let Some(Ok(folder)) = to.parent().map(File::open) {
            let _ = folder.sync_all();
        }
        Ok(())
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        std::fs::remove_file(path)
    }

    fn make_folder(&self, path: &Path) -> io::Result<()> {
        std::fs::create_dir_all(path)
    }

    fn look(&self, path: &Path) -> io::Result<Found> {
        let found = std::fs::metadata(path)?;
        Ok(match (found.is_file(), found.is_dir()) {
            (true, _) => Found::File,
            (_, true) => Found::Folder,
            _ => Found::Other,
        })
    }

    fn lock(&self, path: &Path) -> io::Result<Option<Held>> {
        use std::fs::TryLockError;

        let mut options = File::options();
        let file = options.create(true).append(true).open(path)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(Box::new(file))),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(error),
        }
    }

    fn behind_links(&self, path: &Path) -> io::Result<PathBuf> {
        let mut end = path.to_owned();
        for _ in 0..MAX_LINKS {
            match std::fs::read_link(&end) {
                // A relative one counts from the folder that it stands in.
                Ok(next) => end = end.with_file_name(next),
                Err(_) => return Ok(end),
            }
        }
        Err(io::Error::other(
            "it is a link that leads back to itself: remove it, or name another file",
        ))
    }
}
