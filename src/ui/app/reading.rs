//! Reading what is opened or pasted: by a thread of the pool, so that the window goes on meanwhile.

use std::path::PathBuf;
use std::sync::mpsc::TryRecvError;
use std::time::Duration;

use egui::{Context, Panel, Ui};

use super::App;
use super::readings::Reading;
use bxdf::error::{Error, Result};
use bxdf_study::files;
use bxdf_study::parallel::Pool;
use bxdf_study::session::Opened;

/// Texts up to this many bytes are read at once: that takes no longer than a frame.
const AT_ONCE: usize = 1 << 15;

/// How often it is looked whether a text is read, in seconds.
const POLL: f64 = 0.1;

impl App {
    /// Reads a text that was pasted.
    pub(super) fn read_pasted(
        &mut self,
        length: usize,
        read: impl FnOnce() -> Result<Opened> + Send + 'static,
        ctx: &Context,
    ) {
        let what = format!("the clipboard, {}", files::in_words(length as u64));
        let is_long = length > AT_ONCE;
        self.read(what, None, is_long, read, ctx);
    }

    /// Reads a file.
    pub(super) fn read_file(
        &mut self,
        path: PathBuf,
        read: impl FnOnce() -> Result<Opened> + Send + 'static,
        ctx: &Context,
    ) {
        let what = path.display().to_string();
        self.read(what, Some(path), true, read, ctx);
    }

    fn read(
        &mut self,
        what: String,
        path: Option<PathBuf>,
        is_long: bool,
        read: impl FnOnce() -> Result<Opened> + Send + 'static,
        ctx: &Context,
    ) {
        let wake = ctx.clone();
        let at_once = Pool::at_once();
        let pool = if is_long { &self.pool } else { &at_once };
        let answer = pool.wait_for(read, move || wake.request_repaint());
        self.readings.push_back(Reading { what, path, answer });
        self.take_what_is_read(ctx);
    }

    /// Shows what is read by now, each after what came before it.
    pub(super) fn take_what_is_read(&mut self, ctx: &Context) {
        while let Some(first) = self.readings.front() {
            let opened = match first.answer.try_recv() {
                Ok(opened) => opened,
                Err(TryRecvError::Empty) => {
                    ctx.request_repaint_after(Duration::from_secs_f64(POLL));
                    return;
                }
                Err(TryRecvError::Disconnected) => {
                    Err(Error::parse(first.what.as_str(), "it could not be read"))
                }
            };
            let path = self.readings.pop_front().and_then(|reading| reading.path);
            self.take(opened, path);
        }
    }

    /// Whether something is being read.
    #[must_use]
    pub fn is_reading(&self) -> bool {
        !self.readings.is_empty()
    }

    /// A panel at the bottom that says what is being read.
    pub(crate) fn show_reading(&self, ui: &mut Ui) {
        if let Some(first) = self.readings.front() {
            Panel::bottom("reading").show(ui, |ui| {
                // No wheel turns: it would have every frame drawn, beside the thread that reads.
                ui.label(format!("Reading {} …", first.what));
            });
        }
    }
}
