//! The file system, as the window uses it.

use std::io;
use std::path::Path;

/// Reading and writing files: the one place of the window that does it, and what tests replace by one that fails.
pub trait Files {
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
}

/// The files of this machine.
#[cfg(not(target_arch = "wasm32"))]
#[derive(Clone, Copy, Debug)]
pub struct Disk;

#[cfg(not(target_arch = "wasm32"))]
impl Files for Disk {
    fn read(&self, path: &Path, limit: u64) -> io::Result<Vec<u8>> {
        use std::io::Read as _;

        let file = std::fs::File::open(path)?;
        let mut bytes = Vec::new();
        // One byte more tells a file that is too large from one that just fits.
        file.take(limit + 1).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > limit {
            return Err(io::Error::new(
                io::ErrorKind::FileTooLarge,
                format!("more than {limit} bytes"),
            ));
        }
        Ok(bytes)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        use std::io::Write as _;

        let mut file = std::fs::File::create(path)?;
        file.write_all(bytes)?;
        file.sync_all()
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        std::fs::rename(from, to)?;
        // The name is on the disk when its folder is; where folders cannot be synced there is no more to be done.
        #[cfg(unix)]
        if let Some(Ok(folder)) = to.parent().map(std::fs::File::open) {
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
}
