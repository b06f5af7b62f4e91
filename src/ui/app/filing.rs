//! Opening, saving, dropping, and what is kept for the next run.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use egui::{Align2, Context, Event, ThemePreference};

use super::App;
use super::files::{Asking, Files};
use super::picture::Maker;
use crate::screens;
use crate::theme;
use crate::widgets::saved::Saved;
use bxdf::error::{Error, Result};
use bxdf_study::colors;
use bxdf_study::files;
use bxdf_study::history::Document;
use bxdf_study::session::{self, Opened, Session};
use bxdf_study::store::{Dialogs, FileDialog, News, Store};
use bxdf_study::{lessons, link};

/// The name proposed for a new file.
const NEW_NAME: &str = "session.toml";

/// The most bytes that are pasted into a text field at once: no name, number or path is longer, and much longer lines take
/// seconds to be laid out.
const MOST_TYPED: usize = 1 << 14;

/// How a session is saved: as it refers to its data, or with all of it.
pub(super) type Save = fn(&mut Store, &Path, &Session) -> Result<Option<PathBuf>>;

impl App {
    /// Writes a file of the user's, and says where it is.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub(super) fn write_file(&mut self, path: &Path, bytes: &[u8]) -> Result<()> {
        if let Some(files) = &mut self.files {
            files.store.export(path, bytes)?;
            self.saved = Some(Saved::to(path));
        }
        Ok(())
    }

    /// Works on files from here on, and goes on with the session of the last run, if there is one. Pictures and tests
    /// have no files unless they are given some.
    pub fn work_on(
        &mut self,
        ctx: &Context,
        mut store: Store,
        dialogs: Box<dyn Dialogs>,
        maker: Maker,
    ) {
        ctx.set_theme(match store.theme() {
            None => ThemePreference::System,
            Some(colors::Theme::Dark) => ThemePreference::Dark,
            Some(colors::Theme::Light) => ThemePreference::Light,
        });
        if !store.has_seen_first_steps() {
            self.switch_first_steps();
        }
        self.side = store.side();
        self.labels = store.labels();
        theme::reduce_motion(ctx, store.has_reduced_motion());
        self.learning.restore(store.progress());
        self.exports.choice = store.figure();
        self.is_linked_from(store.page().map(str::to_owned));
        let restored = store.restore(self.session.clone());
        if restored.session != self.session {
            self.restart(restored.session);
        }
        if !restored.said.is_empty() {
            self.notice.say_all(&restored.said);
        }
        self.files = Some(Files {
            store,
            asking: Asking::by(dialogs),
            maker,
            of: HashMap::new(),
        });
    }

    /// Says a line at the place where problems are said.
    pub fn tell(&mut self, line: &str) {
        self.notice.say(&line);
    }

    /// Whether files can be opened and saved.
    #[must_use]
    pub fn has_files(&self) -> bool {
        self.files.is_some()
    }

    /// The files opened or saved last, the latest first.
    #[must_use]
    pub fn recent_files(&self) -> &[PathBuf] {
        let files = self.files.as_ref();
        files.map_or(&[], |files| files.store.recent())
    }

    /// Asks for a file to open.
    pub fn ask_open(&mut self) {
        if let Some(files) = &mut self.files {
            files.ask(FileDialog::Open);
        }
    }

    /// Asks for a file to save to.
    pub fn ask_save(&mut self) {
        let name = self.proposed_name();
        if let Some(files) = &mut self.files {
            files.ask(FileDialog::Save(name));
        }
    }

    /// Asks for a file to save to with all data in it.
    pub fn ask_save_with_data(&mut self) {
        let name = self.proposed_name();
        if let Some(files) = &mut self.files {
            files.ask(FileDialog::SaveWithData(name));
        }
    }

    /// Puts another session in place of this one, which undo brings back, with its file. The other has none yet.
    pub(super) fn replace(&mut self, session: Session) -> Document {
        self.session = session;
        self.history.replace()
    }

    /// The file of the session, where it has one.
    fn file(&self) -> Option<&PathBuf> {
        let files = self.files.as_ref()?;
        files.of.get(&self.history.document())
    }

    /// The name of the file of the session, or one for a new one.
    fn proposed_name(&self) -> String {
        let name = self.file().and_then(|path| path.file_name());
        name.map_or(NEW_NAME.into(), |name| name.to_string_lossy().into_owned())
    }

    /// Saves to the file of the session; asks for one where it has none.
    pub fn save(&mut self) {
        match self.file().cloned() {
            Some(path) => {
                let saved = self.save_to(&path, Store::save);
                self.notice.report(saved);
            }
            None => self.ask_save(),
        }
    }

    /// Saves to a file, which is that of the session from now on, and says where it is.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub(super) fn save_to(&mut self, path: &Path, save: Save) -> Result<()> {
        let Some(files) = &mut self.files else {
            return Ok(());
        };
        let aside = save(&mut files.store, path, &self.session)?;
        files.of.insert(self.history.document(), path.to_owned());
        let mut saved = Saved::to(path);
        if let Some(aside) = aside {
            saved.add(&set_aside(&aside));
        }
        self.saved = Some(saved);
        Ok(())
    }

    /// Opens a file: a session in place of this one, a material beside the others, lessons beside them. What is on the screen stays where it
    /// cannot be read.
    pub fn open(&mut self, path: &Path, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        if self.session.is_missing_file(path) {
            // What is missing comes first: it is what the drop was asked for.
            self.session.look_in(path);
            return;
        }
        if lessons::is_lesson(path) {
            if let Some(shelf) = self.notice.report(files.store.lessons(path)) {
                files.store.remember(path);
                self.take_lessons(shelf);
            }
        } else {
            let read = files.store.reader(path);
            self.read_file(path.to_owned(), read, ctx);
        }
    }

    /// Shows what was opened, from the file at `path`, or pasted.
    pub(super) fn take(&mut self, opened: Result<Opened>, path: Option<PathBuf>) {
        let is_session = matches!(opened, Ok(Opened::Session(_)));
        let taken = opened.and_then(|opened| {
            let remarks = opened.remarks();
            match opened {
                Opened::Session(read) => {
                    read.session.require_fit()?;
                    self.replace(read.session);
                }
                Opened::Material(material) => {
                    self.session.materials.add(*material)?;
                }
            }
            Ok(remarks)
        });
        let Some(remarks) = self.notice.report(taken) else {
            return;
        };
        // What was said of another session, or before a file came back, holds no longer.
        self.notice.say_all(&remarks);
        if let (Some(files), Some(path)) = (&mut self.files, path) {
            files.store.remember(&path);
            if is_session {
                files.of.insert(self.history.document(), path);
            }
        }
    }

    /// Takes back what this frame has done where nobody would read the session again: no edit leads to a session that cannot
    /// be kept.
    pub(crate) fn refuse_what_does_not_fit(&mut self) {
        let before = self.history.present();
        if self.session == *before {
            return;
        }
        if let Err(error) = self.session.require_fit() {
            self.history.refuse(&mut self.session);
            self.notice.say(&format!("{error}; nothing is changed"));
        }
    }

    /// Takes what is pasted where no text field does, what is dropped on the window, and what a dialog answers.
    pub(crate) fn take_what_comes(&mut self, ctx: &Context) {
        self.take_what_is_read(ctx);
        if ctx.text_edit_focused() {
            self.refuse_long_pastes(ctx);
        } else {
            self.take_paste(ctx);
        }
        let dropped = ctx.input(|input| input.raw.dropped_files.clone());
        for file in dropped {
            self.open(file.path(), ctx);
        }
        self.write_exports(ctx);
        if self.files.is_some() {
            say_what_dropping_does(ctx);
            self.take_answers(ctx);
        }
    }

    /// Reads what is pasted, the last where there are several.
    fn take_paste(&mut self, ctx: &Context) {
        let pasted = ctx.input(|input| {
            let mut events = input.events.iter().rev();
            events.find_map(|event| match event {
                Event::Paste(text) => Some(Ok(text.clone())),
                Event::PasteImage(_) => Some(Err(Error::parse("clipboard", "a picture, no text"))),
                _ => None,
            })
        });
        match pasted {
            Some(Ok(text)) => match link::fragment_of(&text) {
                Some(fragment) => self.open_link(fragment, ctx),
                None => self.read_pasted(text.len(), move || session::pasted(&text), ctx),
            },
            Some(Err(error)) => self.notice.say(&error),
            None => {}
        }
    }

    /// Keeps long texts from the text field that has the keyboard.
    fn refuse_long_pastes(&mut self, ctx: &Context) {
        let is_long = |event: &Event| match event {
            Event::Paste(text) if text.len() > MOST_TYPED => Some(text.len()),
            _ => None,
        };
        let longest = ctx.input(|input| input.events.iter().filter_map(is_long).max());
        if let Some(length) = longest {
            ctx.input_mut(|input| input.events.retain(|event| is_long(event).is_none()));
            let [length, most] = [length, MOST_TYPED].map(|n| files::in_words(n as u64));
            let line = format!("the pasted text is {length}; a field takes {most} at most");
            self.notice.say(&line);
        }
    }

    /// Keeps the theme, the labels, whether anything moves, the panel at the side and the place of the window for the next run, and the session a moment after it has changed.
    pub(crate) fn keep(&mut self, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        files
            .store
            .keep_theme(match ctx.options(|options| options.theme_preference) {
                ThemePreference::System => None,
                ThemePreference::Dark => Some(colors::Theme::Dark),
                ThemePreference::Light => Some(colors::Theme::Light),
            });
        files.store.keep_side(self.side);
        files.store.keep_labels(self.labels);
        let is_reduced = theme::has_reduced_motion(ctx);
        files.store.keep_reduced_motion(is_reduced);
        files.store.keep_progress(self.learning.progress());
        let is_presenting = self.zoom_before.is_some();
        let window = screens::place(ctx, files.store.window());
        if let Some(window) = window.filter(|_| !is_presenting) {
            files.store.keep_window(window);
        }
        files.store.keep_figure(self.exports.choice);
        let now = ctx.input(|input| input.time);
        let keeping = files.store.keep(&self.session, now);
        if let Some(news) = keeping.news {
            let (lasting, done) = match news {
                News::Failed(error) => {
                    let line = "the session is not kept for the next start, which is tried again";
                    (Some(format!("{error}: {line}")), None)
                }
                News::Recovered => (None, Some("The session is kept again".to_owned())),
                News::SetAside(path) => (None, Some(set_aside(&path))),
            };
            self.notice.say_lasting(lasting.as_deref());
            self.saved = done.map(|text| Saved::done(&text)).or(self.saved.take());
        }
        if let Some(seconds) = keeping.again {
            ctx.request_repaint_after(Duration::from_secs_f64(seconds));
        }
    }

    /// Keeps for the next run that the first steps were seen.
    pub(super) fn keep_first_steps(&mut self) {
        let is_left = self.first_steps.is_none();
        if let Some(files) = self.files.as_mut().filter(|_| is_left) {
            files.store.keep_first_steps_seen();
        }
    }

    /// Keeps the session for the next run, at the end of this one. Where that fails it is put where there is room, and told of
    /// by [`Self::exit_problem`].
    pub(crate) fn keep_now(&mut self) {
        let Some(files) = &mut self.files else { return };
        let Err(error) = files.store.keep_now(&self.session) else {
            return;
        };
        let remedy = match files.store.rescue(&self.session) {
            Some(path) => format!("it is in {}: open it from there", path.display()),
            None => "its last changes are lost".to_owned(),
        };
        let problem = format!("the session is not kept for the next start: {error}");
        let mut told = self
            .exit_problem
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        *told = Some(Error::Platform { problem, remedy });
    }

    /// Where what goes wrong at the end is told, when no window is there to say it.
    #[must_use]
    pub fn exit_problem(&self) -> Arc<Mutex<Option<Error>>> {
        Arc::clone(&self.exit_problem)
    }
}

/// What became of a file that could not be read.
fn set_aside(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    format!("The file that stood there could not be read and is now {name}")
}

/// While files hover over the window: what becomes of them if they are let go.
fn say_what_dropping_does(ctx: &Context) {
    if ctx.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    egui::Area::new(egui::Id::unique("drop"))
        .anchor(Align2::CENTER_CENTER, egui::Vec2::ZERO)
        .order(egui::Order::Foreground)
        .show(ctx, |ui| {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.heading(
                    "Drop to open: a session replaces this one, a material joins the others",
                );
            });
        });
}
