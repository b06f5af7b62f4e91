//! Asking for files in a browser: it has a dialog for those that are opened; what is saved it puts where it puts downloads.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, TryRecvError};

use rfd::AsyncFileDialog;

use bxdf_study::lessons;
use bxdf_study::readers;
use bxdf_study::store::{Answer, Dialogs, FileDialog, Files as _};

use crate::files::{DOWNLOADS, OPENED, PageFiles};

/// The dialogs of a page.
pub struct PageDialogs {
    files: Arc<PageFiles>,
    open: Option<(FileDialog, Receiver<Answer>)>,
}

impl PageDialogs {
    /// Dialogs that put what they open into the memory of `files`.
    pub fn new(files: Arc<PageFiles>) -> Self {
        Self { files, open: None }
    }
}

/// Where a file of this name stands once it is opened.
pub fn opened(name: &str) -> PathBuf {
    Path::new(OPENED).join(name)
}

impl Dialogs for PageDialogs {
    fn ask(&mut self, wanted: FileDialog) {
        if self.open.is_some() {
            return;
        }
        let (sender, answer) = mpsc::channel();
        match &wanted {
            FileDialog::Open => {
                let files = Arc::clone(&self.files);
                let readers = readers::all();
                let own = readers.iter().flat_map(|reader| reader.extensions());
                let endings: Vec<&str> = own.copied().chain([lessons::EXTENSION]).collect();
                wasm_bindgen_futures::spawn_local(async move {
                    let dialog = AsyncFileDialog::new().add_filter("", &endings);
                    let answer = match dialog.pick_file().await {
                        Some(file) => {
                            let path = opened(&file.file_name());
                            let laid = files.write(&path, &file.read().await);
                            laid.map_or(Answer::Dismissed, |()| Answer::File(path))
                        }
                        None => Answer::Dismissed,
                    };
                    // Nobody listens where the page is closed meanwhile.
                    let _ = sender.send(answer);
                });
            }
            FileDialog::Save(name) | FileDialog::SaveWithData(name) | FileDialog::Export(name) => {
                let _ = sender.send(Answer::File(Path::new(DOWNLOADS).join(name)));
            }
        }
        self.open = Some((wanted, answer));
    }

    fn is_open(&self) -> bool {
        self.open.is_some()
    }

    fn answer(&mut self) -> Option<(FileDialog, Answer)> {
        let (_, answer) = self.open.as_ref()?;
        let answer = match answer.try_recv() {
            Ok(answer) => answer,
            Err(TryRecvError::Empty) => return None,
            Err(TryRecvError::Disconnected) => Answer::Dismissed,
        };
        let (dialog, _) = self.open.take()?;
        Some((dialog, answer))
    }
}
