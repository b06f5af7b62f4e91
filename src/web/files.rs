//! The files of a page: what it keeps stands in the browser's storage, what is opened in memory, and what is written anywhere
//! else is a download.

use std::any::Any;
use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, Storage, Url};

use bxdf_study::store::{Files, Found};

/// The folder of what is kept from one visit to the next.
pub const KEPT: &str = "/kept";

/// The folder of what was opened.
pub const OPENED: &str = "/opened";

/// The folder of what is downloaded.
pub const DOWNLOADS: &str = "/downloads";

/// What the keys in the browser's storage begin with: other pages of the same host have their own.
const KEY: &str = "brdf-explorer/";

/// The files of a page.
pub struct PageFiles {
    /// What was opened, and what is not complete yet.
    memory: Mutex<HashMap<PathBuf, Vec<u8>>>,
    /// Which of the pages of this browser it is; 0 where that is not known.
    number: u32,
}

impl PageFiles {
    /// No files in memory; `number` as [`crate::start`] has it.
    pub fn new(number: u32) -> Self {
        Self {
            memory: Mutex::default(),
            number,
        }
    }

    fn memory(&self) -> MutexGuard<'_, HashMap<PathBuf, Vec<u8>>> {
        self.memory.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        if let Some(bytes) = self.memory().get(path) {
            return Ok(bytes.clone());
        }
        let kept = key(path).ok_or(io::ErrorKind::NotFound)?;
        let kept = storage()?
            .get_item(&kept)
            .map_err(|error| refused(&error))?;
        Ok(kept.ok_or(io::ErrorKind::NotFound)?.into_bytes())
    }
}

/// Whether the browser keeps anything for the next visit: in private windows it may not.
pub fn is_kept() -> bool {
    let key = format!("{KEY}probe");
    let probed = storage()
        .map(|storage| storage.set_item(&key, "1").is_ok() && storage.remove_item(&key).is_ok());
    probed.unwrap_or(false)
}

/// A storage that throws counts as none.
fn storage() -> io::Result<Storage> {
    let storage = web_sys::window().map(|window| window.local_storage());
    match storage {
        Some(Ok(Some(storage))) => Ok(storage),
        _ => Err(io::Error::other("this browser keeps nothing")),
    }
}

fn refused(error: &JsValue) -> io::Error {
    let name = error.dyn_ref::<js_sys::Error>().map(js_sys::Error::name);
    let is_full = name.is_some_and(|name| name.includes("Quota", 0));
    io::Error::other(if is_full {
        "the storage of the browser is full"
    } else {
        "the browser does not keep it"
    })
}

/// Under which key the browser keeps the file at `path`; `None` where it is not one of those.
fn key(path: &Path) -> Option<String> {
    let name = path.strip_prefix(KEPT).ok()?;
    Some(format!("{KEY}{}", name.display()))
}

/// Offers `bytes` as a file of this name.
fn download(bytes: &[u8], name: &str) -> Result<(), JsValue> {
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let options = BlobPropertyBag::new();
    options.set_type("application/octet-stream");
    let blob = Blob::new_with_u8_array_sequence_and_options(&parts, &options)?;
    let address = Url::create_object_url_with_blob(&blob)?;
    let document = web_sys::window().and_then(|window| window.document());
    let document = document.ok_or(JsValue::NULL)?;
    let link: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    link.set_href(&address);
    link.set_download(name);
    link.click();
    // The browser has taken hold of it by then.
    Url::revoke_object_url(&address)
}

impl Files for PageFiles {
    fn read(&self, path: &Path, limit: u64) -> io::Result<Vec<u8>> {
        let bytes = self.bytes(path)?;
        if bytes.len() as u64 > limit {
            return Err(io::ErrorKind::FileTooLarge.into());
        }
        Ok(bytes)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.memory().insert(path.to_owned(), bytes.to_vec());
        Ok(())
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        let bytes = self.bytes(from)?;
        if let Some(key) = key(to) {
            let text = String::from_utf8(bytes).map_err(io::Error::other)?;
            let kept = storage()?.set_item(&key, &text);
            kept.map_err(|error| refused(&error))?;
        } else if to.starts_with(OPENED) {
            self.memory().insert(to.to_owned(), bytes);
        } else {
            let name = to.file_name().unwrap_or_default().to_string_lossy();
            let offered = download(&bytes, &name);
            offered.map_err(|_| io::Error::other("the browser does not download it"))?;
        }
        self.remove(from)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        self.memory().remove(path);
        if let Some(key) = key(path) {
            let removed = storage()?.remove_item(&key);
            removed.map_err(|error| refused(&error))?;
        }
        Ok(())
    }

    fn make_folder(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn look(&self, path: &Path) -> io::Result<Found> {
        if [KEPT, OPENED, DOWNLOADS]
            .iter()
            .any(|folder| path == Path::new(folder))
        {
            return Ok(Found::Folder);
        }
        self.bytes(path).map(|_| Found::File)
    }

    /// Which page of the browser has which session is settled before this one starts.
    fn lock(&self, path: &Path) -> io::Result<Option<Box<dyn Any + Send + Sync>>> {
        let own = match self.number {
            0 => return Err(io::ErrorKind::Unsupported.into()),
            1 => "session.lock".to_owned(),
            number => format!("session-{number}.lock"),
        };
        let is_own = path.file_name().is_some_and(|name| *name == *own);
        Ok(is_own.then(|| Box::new(()) as Box<dyn Any + Send + Sync>))
    }

    fn has_places(&self) -> bool {
        false
    }
}
