//! Exporting a view from the window: where to is asked, what is written is made by threads of the pool.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::mpsc::TryRecvError;
use std::time::Duration;

use egui::{Context, Vec2};

use super::App;
use super::exports::{Asked, Made, Making};
use super::picture::{Maker, OnScreen, Picture, Title};
use crate::widgets::saved::Saved;
use bxdf::error::{Error, Result};
use bxdf_study::export::figure::FigureChoice;
use bxdf_study::export::{FORMATS, Format, format_of};
use bxdf_study::session::ViewId;
use bxdf_study::store::FileDialog;

/// How large a view is taken to be that was not on the screen yet, in points.
const UNSEEN: Vec2 = Vec2::new(480.0, 360.0);

/// How often a file that is being made is looked for, in seconds.
const POLL: f64 = 0.1;

impl App {
    /// Asks where to export a view to; `title`: that of a figure.
    pub(crate) fn ask_export(&mut self, view: ViewId, format: Format, title: Title) {
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
            self.exports.asked = Some(Asked {
                view,
                format,
                title,
            });
        }
    }

    /// Begins to make the file that was asked for.
    ///
    /// # Errors
    /// Where its name ends as that of another kind of file.
    pub(super) fn export_to(&mut self, path: &Path, ctx: &Context) -> Result<()> {
        let wanted = self.exports.asked.as_ref().map(|asked| asked.format);
        let named = path.extension().and_then(OsStr::to_str).and_then(format_of);
        if let (Some(wanted), Some(named)) = (wanted, named)
            && wanted != named
        {
            let spec = FORMATS.iter().find(|spec| spec.format == wanted);
            let (title, extension) = spec.map_or(("", ""), |spec| (spec.title, spec.extension));
            return Err(Error::parse(
                path.display().to_string(),
                format!("the name of another kind of file: end that of a {title} in .{extension}"),
            ));
        }
        let (Some(asked), Some(maker)) = (self.exports.asked.take(), self.maker()) else {
            return Ok(());
        };
        let format = asked.format;
        let picture = self.picture_of(asked.view, asked.title, ctx);
        let path = Some(path.to_owned());
        let make = move || async move { (maker.file)(picture, format).await.map(Made::File) };
        self.make(path, make, ctx);
        Ok(())
    }

    /// Begins to make a picture of a view for the clipboard: the one that a file of it would hold.
    pub(crate) fn copy_figure(&mut self, view: ViewId, title: Title, ctx: &Context) {
        let Some(maker) = self.maker() else { return };
        let picture = self.picture_of(view, title, ctx);
        let make = move || async move { (maker.image)(picture).await.map(Made::Picture) };
        self.make(None, make, ctx);
    }

    /// Asks where to export a view to, as figures were made last.
    pub(crate) fn ask_export_of(&mut self, view: ViewId, format: Format) {
        let title = self.title_of("");
        self.ask_export(view, format, title);
    }

    /// Puts the figure of a view, as figures were made last, into the clipboard.
    pub fn copy_picture(&mut self, view: ViewId, ctx: &Context) {
        let title = self.title_of("");
        self.copy_figure(view, title, ctx);
    }

    /// The title of a figure with these words of a person's own; none where figures have no title.
    pub(super) fn title_of(&self, own: &str) -> Title {
        match own.trim() {
            _ if !self.exports.choice.has_title => Title::None,
            "" => Title::Automatic,
            own => Title::Own(own.to_owned()),
        }
    }

    pub(super) fn maker(&self) -> Option<Maker> {
        self.files.as_ref().map(|files| files.maker)
    }

    /// The figure of a view, as figures are made.
    pub(super) fn picture_of(&self, view: ViewId, title: Title, ctx: &Context) -> Picture {
        let FigureChoice { purpose, theme, .. } = self.exports.choice;
        let size = self.exports.sizes.get(&view).copied().unwrap_or(UNSEEN);
        let screen = OnScreen {
            size: [size.x, size.y].map(|points| points.round().max(1.0) as u32),
            scale: ctx.pixels_per_point(),
        };
        Picture::of_figure(self.session.clone(), view, (purpose, title, theme), screen)
    }

    /// Keeps in mind how large a view is on the screen.
    pub(crate) fn note_size(&mut self, view: ViewId, size: Vec2) {
        self.exports.sizes.insert(view, size);
    }

    fn make<F: Future<Output = Result<Made>> + 'static>(
        &mut self,
        path: Option<PathBuf>,
        make: impl FnOnce() -> F + Send + 'static,
        ctx: &Context,
    ) {
        let wake = ctx.clone();
        let answer = self.pool.complete(make, move || wake.request_repaint());
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
                    (self.put_picture)(ctx, image)?;
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
