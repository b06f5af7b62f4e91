//! Exporting a view from the window: where to is asked, what is written is made by a thread of its own.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::time::Duration;

use egui::Context;

use super::App;
use crate::error::{Error, Result};
use crate::ui::export::{self, FORMATS, Format};
use crate::ui::headless::Picture;
use crate::ui::platform;
use crate::ui::session::ViewId;
use crate::ui::store::Question;
use crate::ui::views;

/// The size of an exported view, in points, and its pixels per point: legible in print.
const SIZE: [u32; 2] = [960, 720];
const SCALE: f32 = 2.0;

/// How often a file that is being made is looked for, in seconds.
const POLL: f64 = 0.1;

/// What the window exports.
#[derive(Default)]
pub struct Exports {
    /// What a place is being asked for.
    asked: Option<(ViewId, Format)>,
    /// What is being made, and where it will be written.
    making: Vec<(PathBuf, Receiver<Result<Vec<u8>>>)>,
}

impl App {
    /// Asks where to export a view to.
    pub(super) fn ask_export(&mut self, view: ViewId, format: Format) {
        let Some(files) = &mut self.files else {
            return;
        };
        let spec = FORMATS.iter().find(|spec| spec.format == format);
        let extension = spec.map_or("", |spec| spec.extension);
        let name = match format {
            Format::Toml => self
                .session
                .materials
                .title(self.session.materials.selected()),
            Format::Obj | Format::Gltf => "lobes".to_owned(),
            Format::Png | Format::Svg | Format::Csv => view.as_str().to_owned(),
        };
        // A dialog that is open already keeps what it was opened for.
        if files.ask(Question::Export(format!("{name}.{extension}"))) {
            self.exports.asked = Some((view, format));
        }
    }

    /// Begins to make the file that was asked for.
    pub(super) fn export_to(&mut self, path: &Path, ctx: &Context) {
        let Some((view, format)) = self.exports.asked.take() else {
            return;
        };
        let picture = Picture {
            session: self.session.clone(),
            only: views::find(view.as_str()).ok(),
            size: SIZE,
            scale: SCALE,
            theme: ctx.theme(),
        };
        let (sender, receiver) = mpsc::channel();
        let wake = ctx.clone();
        let make = move || {
            // Nobody listens where the window is closed meanwhile.
            let _ = sender.send(export::bytes(picture, format));
            wake.request_repaint();
        };
        if platform::spawn(make) {
            self.exports.making.push((path.to_owned(), receiver));
        } else {
            self.notice.say(&"no thread to make the file");
        }
    }

    /// Writes the files that are made.
    pub(super) fn write_exports(&mut self, ctx: &Context) {
        let mut still = Vec::new();
        for (path, receiver) in std::mem::take(&mut self.exports.making) {
            let made = match receiver.try_recv() {
                Ok(made) => made,
                Err(TryRecvError::Empty) => {
                    still.push((path, receiver));
                    continue;
                }
                Err(TryRecvError::Disconnected) => Err(Error::parse(
                    path.display().to_string(),
                    "it could not be made",
                )),
            };
            let written = made.and_then(|bytes| self.write_file(&path, &bytes));
            self.notice.report(written);
        }
        self.exports.making = still;
        if !self.exports.making.is_empty() {
            ctx.request_repaint_after(Duration::from_secs_f64(POLL));
        }
    }

    /// Whether a file is being made.
    #[must_use]
    pub fn is_exporting(&self) -> bool {
        !self.exports.making.is_empty()
    }
}
