//! The dialogs of the system, which ask for files.

use std::future::Future;
use std::pin::Pin;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll, Waker};

use rfd::{AsyncFileDialog, FileHandle};

use bxdf_study::lessons;
use bxdf_study::readers::{self, Reader};
use bxdf_study::store::{Answer, Dialogs, FileDialog};

/// The files of sessions and materials: what they are called, and what their names end in.
const SESSIONS: (&str, &[&str]) = ("Session or material", &["toml", "TOML"]);

type Pending = Pin<Box<dyn Future<Output = Option<FileHandle>>>>;

/// The dialogs of this machine.
#[derive(Default)]
pub struct Native {
    open: Option<(FileDialog, Pending)>,
}

/// `dialog` for all that can be opened: of every format, of each, and whatever it is called.
fn with_readers(dialog: AsyncFileDialog) -> AsyncFileDialog {
    let readers = readers::all();
    // Dialogs may tell capitals from small letters.
    let endings = |reader: &dyn Reader| {
        let own = reader.extensions().iter();
        own.flat_map(|own| [(*own).to_owned(), own.to_uppercase()])
            .collect::<Vec<_>>()
    };
    let lessons = [
        lessons::EXTENSION.to_owned(),
        lessons::EXTENSION.to_uppercase(),
    ];
    let all: Vec<String> = readers
        .iter()
        .flat_map(|reader| endings(&**reader))
        .chain(lessons.clone())
        .collect();
    let mut dialog = dialog.add_filter("All that can be opened", &all);
    for reader in &readers {
        dialog = dialog.add_filter(reader.title(), &endings(&**reader));
    }
    dialog = dialog.add_filter("Lesson", &lessons);
    dialog.add_filter("Any file", &["*"])
}

impl Dialogs for Native {
    fn ask(&mut self, wanted: FileDialog) {
        if self.open.is_some() {
            return;
        }
        listener::listen();
        let dialog = AsyncFileDialog::new();
        let answer: Pending = match &wanted {
            FileDialog::Open => Box::pin(with_readers(dialog).pick_file()),
            FileDialog::Save(name) | FileDialog::SaveWithData(name) => {
                let dialog = dialog.add_filter(SESSIONS.0, SESSIONS.1);
                Box::pin(dialog.set_file_name(name).save_file())
            }
            FileDialog::Export(name) => {
                let extension = name.rsplit('.').next().unwrap_or_default();
                let dialog = dialog.add_filter(extension.to_uppercase(), &[extension]);
                Box::pin(dialog.set_file_name(name).save_file())
            }
        };
        self.open = Some((wanted, answer));
    }

    fn is_open(&self) -> bool {
        self.open.is_some()
    }

    fn answer(&mut self) -> Option<(FileDialog, Answer)> {
        let (_, answer) = self.open.as_mut()?;
        // The window asks again in a moment: nobody has to be woken.
        let mut context = Context::from_waker(Waker::noop());
        let Poll::Ready(file) = answer.as_mut().poll(&mut context) else {
            return None;
        };
        let (dialog, _) = self.open.take()?;
        let answer = match file {
            Some(file) => Answer::File(file.path().to_owned()),
            None if listener::take_failure() => Answer::NoDialog,
            None => Answer::Dismissed,
        };
        Some((dialog, answer))
    }
}

/// Whether the last resort of the library of dialogs failed: its answer is the same as where the user dismisses a dialog,
/// and only its log tells the two apart.
mod listener {
    use super::{AtomicBool, Ordering};

    /// Where the library tells, as an error, that neither a portal nor another program opens a dialog. What it tries
    /// before that tells from modules below.
    const LAST_RESORT: &str = "rfd::backend::xdg_desktop_portal";

    static HAS_FAILED: AtomicBool = AtomicBool::new(false);

    struct Listener;

    impl log::Log for Listener {
        fn enabled(&self, metadata: &log::Metadata<'_>) -> bool {
            metadata.level() == log::Level::Error && metadata.target() == LAST_RESORT
        }

        fn log(&self, record: &log::Record<'_>) {
            if self.enabled(record.metadata()) {
                HAS_FAILED.store(true, Ordering::SeqCst);
            }
        }

        fn flush(&self) {}
    }

    /// Listens from now on; where another logger listens already, every answer without a file counts as dismissed.
    pub(super) fn listen() {
        HAS_FAILED.store(false, Ordering::SeqCst);
        if log::set_logger(&Listener).is_ok() {
            log::set_max_level(log::LevelFilter::Error);
        }
    }

    /// Whether it failed since it was last listened for.
    pub(super) fn take_failure() -> bool {
        HAS_FAILED.swap(false, Ordering::SeqCst)
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::process::Command;
    use std::time::Duration;

    use super::*;

    /// Set in the process of the test that has neither a portal nor a program for dialogs.
    const IS_ALONE: &str = "BRDF_EXPLORER_TEST_WITHOUT_DIALOGS";

    #[test]
    fn a_machine_without_dialogs_is_told_from_a_dialog_dismissed() {
        if std::env::var_os(IS_ALONE).is_none() {
            // Once more, where nothing can be found: on the machine as it is a dialog would open.
            let nowhere = "/nonexistent";
            let test = std::thread::current().name().unwrap().to_owned();
            let output = Command::new(std::env::current_exe().unwrap())
                .args([&test, "--exact"])
                .env_clear()
                .envs([
                    (IS_ALONE, "1"),
                    ("PATH", nowhere),
                    ("XDG_RUNTIME_DIR", nowhere),
                    ("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent"),
                ])
                .output()
                .unwrap();
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            assert!(
                output.status.success() && text.contains("1 passed"),
                "{text}"
            );
            return;
        }
        let mut dialogs = Native::default();
        let questions = [FileDialog::Open, FileDialog::Save("a.toml".to_owned())];
        for dialog in questions {
            dialogs.ask(dialog.clone());
            let answer = loop {
                if let Some(answer) = dialogs.answer() {
                    break answer;
                }
                std::thread::sleep(Duration::from_millis(5));
            };
            assert_eq!(answer, (dialog, Answer::NoDialog));
        }
    }
}
