//! Exporting a view from the window: where to is asked, what is written is made by threads of the pool.

use std::path::{Path, PathBuf};
use std::sync::mpsc::TryRecvError;
use std::time::Duration;

use egui::Context;

use super::App;
use super::exports::{Made, Making};
use super::picture::{Maker, Picture};
use crate::widgets::saved::Saved;
use bxdf::error::{Error, Result};
use bxdf_study::export::{FORMATS, Format};
use bxdf_study::session::ViewId;
use bxdf_study::store::FileDialog;

/// The size of an exported view, in points, and its pixels per point: legible in print.
const SIZE: [u32; 2] = [960, 720];
const SCALE: f32 = 2.0;

/// How often a file that is being made is looked for, in seconds.
const POLL: f64 = 0.1;

impl App {
    /// Asks where to export a view to.
    pub(crate) fn ask_export(&mut self, view: ViewId, format: Format) {
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
            Format::Png | Format::Svg | Format::Csv => self.session.views.file_name(view),
        };
        // A dialog that is open already keeps what it was opened for.
        if files.ask(FileDialog::Export(format!("{name}.{extension}"))) {
            self.exports.asked = Some((view, format));
        }
    }

    /// Begins to make the file that was asked for.
    pub(super) fn export_to(&mut self, path: &Path, ctx: &Context) {
        let Some((view, format)) = self.exports.asked.take() else {
            return;
        };
        let Some(maker) = self.maker() else { return };
        let picture = self.picture_of(view, ctx);
        let path = Some(path.to_owned());
        self.make(
            path,
            move || (maker.file)(picture, format).map(Made::File),
            ctx,
        );
    }

    /// Begins to make a picture of a view for the clipboard: the one that a file of it would hold.
    pub(crate) fn copy_picture(&mut self, view: ViewId, ctx: &Context) {
        let Some(maker) = self.maker() else { return };
        let picture = self.picture_of(view, ctx);
        let make = move || (maker.image)(picture).map(Made::Picture);
        self.make(None, make, ctx);
    }

    fn maker(&self) -> Option<Maker> {
        self.files.as_ref().map(|files| files.maker)
    }

    fn picture_of(&self, view: ViewId, ctx: &Context) -> Picture {
        Picture {
            session: self.session.clone(),
            only: Some(view),
            size: SIZE,
            scale: SCALE,
            theme: ctx.theme(),
            figure: None,
        }
    }

    fn make(
        &mut self,
        path: Option<PathBuf>,
        make: impl FnOnce() -> Result<Made> + Send + 'static,
        ctx: &Context,
    ) {
        let wake = ctx.clone();
        let answer = self.pool.compute(make, move || wake.request_repaint());
        self.exports.making.push(Making { path, answer });
    }

    /// Writes the files that are made.
    pub(super) fn write_exports(&mut self, ctx: &Context) {
        let mut still = Vec::new();
        for making in std::mem::take(&mut self.exports.making) {
            let made = match making.answer.try_recv() {
                Ok(made) => made,
                Err(TryRecvError::Empty) => {
                    still.push(making);
                    continue;
                }
                Err(TryRecvError::Disconnected) => Err(Error::parse(
                    making
                        .path
                        .as_ref()
                        .map_or("picture".into(), |path| path.to_string_lossy()),
                    "it could not be made",
                )),
            };
            let done = made.and_then(|made| match (made, &making.path) {
                (Made::File(bytes), Some(path)) => self.write_file(path, &bytes),
                (Made::Picture(image), _) => {
                    ctx.copy_image(image);
                    self.saved = Some(Saved::done("The picture is in the clipboard"));
                    Ok(())
                }
                (Made::File(_), None) => Ok(()),
            });
            self.notice.report(done);
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
