//! Asking the user for a file.

use std::path::PathBuf;

/// What is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Question {
    /// A file to open.
    Open,
    /// A file to save to; this name is proposed.
    Save(String),
    /// A file to export to; this name is proposed.
    Export(String),
}

/// Asks for files, one question at a time, without waiting for the answer.
pub trait Dialogs {
    /// Asks, unless another question is open.
    fn ask(&mut self, question: Question);

    /// Whether a question is open.
    fn is_open(&self) -> bool;

    /// The answer, once it is there, with its question; `None` as its path where the user wants no file after all.
    fn answer(&mut self) -> Option<(Question, Option<PathBuf>)>;
}

#[cfg(not(target_arch = "wasm32"))]
pub use native::Native;

#[cfg(not(target_arch = "wasm32"))]
mod native {
    use std::future::Future;
    use std::pin::Pin;
    use std::task::{Context, Poll, Waker};

    use rfd::{AsyncFileDialog, FileHandle};

    use super::{Dialogs, PathBuf, Question};

    /// The files of sessions and materials: what they are called, and what their names end in.
    const SESSIONS: (&str, &[&str]) = ("Session or material", &["toml"]);

    type Answer = Pin<Box<dyn Future<Output = Option<FileHandle>>>>;

    /// The dialogs of this machine.
    #[derive(Default)]
    pub struct Native {
        open: Option<(Question, Answer)>,
    }

    impl Dialogs for Native {
        fn ask(&mut self, question: Question) {
            if self.open.is_some() {
                return;
            }
            let dialog = AsyncFileDialog::new();
            let answer: Answer = match &question {
                Question::Open => Box::pin(dialog.add_filter(SESSIONS.0, SESSIONS.1).pick_file()),
                Question::Save(name) => {
                    let dialog = dialog.add_filter(SESSIONS.0, SESSIONS.1);
                    Box::pin(dialog.set_file_name(name).save_file())
                }
                Question::Export(name) => {
                    let extension = name.rsplit('.').next().unwrap_or_default();
                    let dialog = dialog.add_filter(extension.to_uppercase(), &[extension]);
                    Box::pin(dialog.set_file_name(name).save_file())
                }
            };
            self.open = Some((question, answer));
        }

        fn is_open(&self) -> bool {
            self.open.is_some()
        }

        fn answer(&mut self) -> Option<(Question, Option<PathBuf>)> {
            let (_, answer) = self.open.as_mut()?;
            // The window asks again in a moment: nobody has to be woken.
            let mut context = Context::from_waker(Waker::noop());
            let Poll::Ready(file) = answer.as_mut().poll(&mut context) else {
                return None;
            };
            let (question, _) = self.open.take()?;
            Some((question, file.map(|file| file.path().to_owned())))
        }
    }
}
