//! Files that are not complete yet: none is left behind, neither by an error nor by an interrupt.

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::Files;
use crate::platform;

/// The files that are being written.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file beside its place, where it is written until it is complete. It is removed where it is dropped before.
pub struct Partial<'a> {
    files: &'a dyn Files,
    path: PathBuf,
    target: PathBuf,
    is_complete: bool,
}

impl<'a> Partial<'a> {
    /// A name for the file that is to stand at `target`, or where the link there leads; nothing stands there yet.
    ///
    /// # Errors
    /// `InvalidFilename` where `target` has no name, as `..`; those of links that lead nowhere.
    pub fn of(files: &'a dyn Files, target: &Path) -> io::Result<Self> {
        let target = files.behind_links(target)?;
        let path = temporary_beside(&target)?;
        // Listed first: whoever ends the program finds it in the list, or not on the disk.
        pending().push(path.clone());
        Ok(Self {
            files,
            path,
            target,
            is_complete: false,
        })
    }

    /// Where it is written.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Moves the file into its place, now that it is on the disk and closed.
    ///
    /// # Errors
    /// The system's; the file is then removed.
    pub fn complete(mut self) -> io::Result<()> {
        self.files.rename(&self.path, &self.target)?;
        self.is_complete = true;
        Ok(())
    }
}

impl Drop for Partial<'_> {
    fn drop(&mut self) {
        if !self.is_complete {
            // The error that led here is the one to tell.
            let _ = self.files.remove(&self.path);
        }
        pending().retain(|path| *path != self.path);
    }
}

/// Removes all files that are not complete, and does `then` before another one is begun: for who ends the program.
pub fn abandon_partial(then: impl FnOnce()) {
    let pending = pending();
    for path in pending.iter() {
        let _ = std::fs::remove_file(path);
    }
    then();
}

/// A name beside `target` that no other writer has, in this process or another, hidden where dots hide names.
fn temporary_beside(target: &Path) -> io::Result<PathBuf> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let name = target.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let (process, count) = (platform::process(), COUNT.fetch_add(1, Ordering::Relaxed));
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{process}-{count}.partial"));
    Ok(target.with_file_name(hidden))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::super::Disk;
    use super::*;

    #[test]
    fn a_file_stands_in_its_place_when_it_is_complete_or_nowhere() {
        let name = format!("brdf-explorer-partial-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).unwrap();
        let target = folder.join("mine.toml");
        let names = || -> Vec<_> {
            let entries = fs::read_dir(&folder).unwrap();
            entries.map(|entry| entry.unwrap().path()).collect()
        };
        for is_completed in [false, true] {
            let partial = Partial::of(&Disk, &target).unwrap();
            Disk.write(partial.path(), b"all of it").unwrap();
            assert!(pending().contains(&partial.path().to_owned()));
            assert_eq!(names(), [partial.path()]);
            if is_completed {
                partial.complete().unwrap();
                assert_eq!(names(), [target.as_path()]);
            } else {
                drop(partial);
                assert!(names().is_empty());
            }
            assert!(pending().iter().all(|path| !path.starts_with(&folder)));
        }
        fs::remove_dir_all(&folder).unwrap();
    }

    /// People keep their files elsewhere, and links in their place: these stay, also where nothing stands behind them yet.
    #[cfg(unix)]
    #[test]
    fn a_link_stays_and_what_it_leads_to_is_written() {
        use std::os::unix::fs::symlink;

        let name = format!("brdf-explorer-link-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        let elsewhere = folder.join("elsewhere");
        fs::create_dir_all(&elsewhere).unwrap();
        let [link, second, circle] = ["link", "second", "circle"].map(|name| folder.join(name));
        symlink("elsewhere/mine.toml", &second).unwrap();
        symlink(&second, &link).unwrap();
        symlink(&circle, &circle).unwrap();
        for text in ["before", "after"] {
            let partial = Partial::of(&Disk, &link).unwrap();
            assert_eq!(partial.path().parent(), Some(elsewhere.as_path()));
            Disk.write(partial.path(), text.as_bytes()).unwrap();
            partial.complete().unwrap();
            for path in [&link, &second] {
                assert!(fs::symlink_metadata(path).unwrap().is_symlink());
                assert_eq!(fs::read_to_string(path).unwrap(), text);
            }
        }
        let refused = Partial::of(&Disk, &circle).map(|_| ()).unwrap_err();
        assert!(refused.to_string().contains("leads back to itself"));
        assert!(fs::symlink_metadata(&circle).unwrap().is_symlink());
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn no_two_writers_have_one_temporary_name() {
        let target = Path::new("folder/mine.toml");
        let [a, b] = [(); 2].map(|()| temporary_beside(target).unwrap());
        assert!(a != b && a.parent() == target.parent());
        assert!(temporary_beside(Path::new("folder/..")).is_err());
    }
}
