//! The files of the application: opening, saving, dropping, and what is kept for the next run.

use std::path::{Path, PathBuf};
use std::time::Duration;

use egui::{Align2, Context, Event, ThemePreference, Ui};

use super::App;
use crate::error::{Error, Result};
use crate::ui::commands::{COMMANDS, Command, Group, OPEN};
use crate::ui::session::{self, Opened};
use crate::ui::store::{ChosenTheme, Dialogs, Question, Store};

/// How often an open dialog is looked at, in seconds.
const DIALOG_POLL: f64 = 0.1;

/// The name proposed for a new file.
const NEW_NAME: &str = "session.toml";

/// The files that the application works on.
pub struct Files {
    store: Store,
    dialogs: Box<dyn Dialogs>,
    /// The file of the session, where it has one.
    file: Option<PathBuf>,
}

impl Files {
    /// Asks for a file, unless something is being asked for. Returns whether it does.
    pub(super) fn ask(&mut self, question: Question) -> bool {
        let can_ask = !self.dialogs.is_open();
        if can_ask {
            self.dialogs.ask(question);
        }
        can_ask
    }
}

impl App {
    /// Writes a file of the user's.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub(super) fn write_file(&self, path: &Path, bytes: &[u8]) -> Result<()> {
        match &self.files {
            Some(files) => files.store.export(path, bytes),
            None => Ok(()),
        }
    }

    /// Works on files from here on, and goes on with the session of the last run, if there is one. Pictures and tests
    /// have no files unless they are given some.
    pub fn work_on(&mut self, ctx: &Context, mut store: Store, dialogs: Box<dyn Dialogs>) {
        ctx.set_theme(match store.theme() {
            None => ThemePreference::System,
            Some(ChosenTheme::Dark) => ThemePreference::Dark,
            Some(ChosenTheme::Light) => ThemePreference::Light,
        });
        let (restored, problem) = store.restore();
        if let Some(session) = restored {
            self.restart(session);
        }
        if let Some(problem) = problem {
            self.notice.say(&problem);
        }
        self.files = Some(Files {
            store,
            dialogs,
            file: None,
        });
    }

    /// Whether files can be opened and saved.
    #[must_use]
    pub fn has_files(&self) -> bool {
        self.files.is_some()
    }

    /// The menu of files. Returns the command chosen.
    pub(super) fn file_menu(&mut self, ui: &mut Ui) -> Option<&'static Command> {
        let (mut wished, mut recent) = (None, None);
        ui.menu_button("File", |ui| {
            let of_files = |command: &&&Command| command.group == Group::File;
            for command in COMMANDS.iter().filter(of_files) {
                if command.menu_item(ui, self) {
                    wished = Some(*command);
                }
                if command.id == OPEN.id {
                    recent = self.recent_menu(ui);
                }
            }
        });
        if let Some(path) = recent {
            self.open(&path);
        }
        wished
    }

    /// The files opened or saved last. Returns the one chosen.
    fn recent_menu(&self, ui: &mut Ui) -> Option<PathBuf> {
        let recent = self
            .files
            .as_ref()
            .map_or(&[][..], |files| files.store.recent());
        let mut chosen = None;
        ui.add_enabled_ui(!recent.is_empty(), |ui| {
            ui.menu_button("Open recent", |ui| {
                for path in recent {
                    let name = path.file_name().unwrap_or(path.as_os_str());
                    let item = ui.button(name.to_string_lossy());
                    if item.on_hover_text(path.display().to_string()).clicked() {
                        chosen = Some(path.clone());
                        ui.close();
                    }
                }
            });
        });
        chosen
    }

    /// Asks for a file to open.
    pub fn ask_open(&mut self) {
        if let Some(files) = &mut self.files {
            files.dialogs.ask(Question::Open);
        }
    }

    /// Asks for a file to save to.
    pub fn ask_save(&mut self) {
        if let Some(files) = &mut self.files {
            let name = files.file.as_ref().and_then(|path| path.file_name());
            let name = name.map_or(NEW_NAME.into(), |name| name.to_string_lossy().into_owned());
            files.dialogs.ask(Question::Save(name));
        }
    }

    /// Saves to the file of the session; asks for one where it has none.
    pub fn save(&mut self) {
        match self.files.as_ref().and_then(|files| files.file.clone()) {
            Some(path) => self.save_to(&path),
            None => self.ask_save(),
        }
    }

    fn save_to(&mut self, path: &Path) {
        let Some(files) = &mut self.files else { return };
        let saved = files.store.save(path, &self.session);
        if self.notice.report(saved).is_some() {
            files.file = Some(path.to_owned());
        }
    }

    /// Opens a file: a session in place of this one, a material beside the others. What is on the screen stays where it
    /// cannot be read.
    pub fn open(&mut self, path: &Path) {
        let Some(files) = &mut self.files else { return };
        let opened = files.store.open(path);
        if matches!(opened, Ok(Opened::Session(_))) {
            files.file = Some(path.to_owned());
        }
        self.take(opened);
    }

    /// Shows what was opened or pasted.
    fn take(&mut self, opened: Result<Opened>) {
        let taken = opened.and_then(|opened| match opened {
            Opened::Session(session) => {
                self.session = *session;
                Ok(())
            }
            Opened::Material(material) => self.session.materials.add(*material).map(|_| ()),
        });
        self.notice.report(taken);
    }

    /// Takes what is pasted where no text field does, what is dropped on the window, and what a dialog answers.
    pub(super) fn take_what_comes(&mut self, ctx: &Context) {
        if !ctx.text_edit_focused() {
            let pasted = ctx.input(|input| {
                let mut events = input.events.iter().rev();
                events.find_map(|event| match event {
                    Event::Paste(text) => Some(session::pasted(text)),
                    Event::PasteImage(_) => {
                        Some(Err(Error::parse("clipboard", "a picture, no text")))
                    }
                    _ => None,
                })
            });
            if let Some(opened) = pasted {
                self.take(opened);
            }
        }
        let dropped = ctx.input(|input| input.raw.dropped_files.clone());
        for file in dropped {
            self.open(file.path());
        }
        self.write_exports(ctx);
        let Some(files) = &mut self.files else { return };
        say_what_dropping_does(ctx);
        if !files.dialogs.is_open() {
            return;
        }
        match files.dialogs.answer() {
            Some((Question::Open, Some(path))) => self.open(&path),
            Some((Question::Save(_), Some(path))) => self.save_to(&path),
            Some((Question::Export(_), Some(path))) => self.export_to(&path, ctx),
            Some((_, None)) => {}
            None => ctx.request_repaint_after(Duration::from_secs_f64(DIALOG_POLL)),
        }
    }

    /// Keeps the theme for the next run, and the session a moment after it has changed.
    pub(super) fn keep(&mut self, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        files
            .store
            .keep_theme(match ctx.options(|options| options.theme_preference) {
                ThemePreference::System => None,
                ThemePreference::Dark => Some(ChosenTheme::Dark),
                ThemePreference::Light => Some(ChosenTheme::Light),
            });
        let now = ctx.input(|input| input.time);
        let kept = files.store.keep(&self.session, now);
        if let Some(Some(seconds)) = self.notice.report(kept) {
            ctx.request_repaint_after(Duration::from_secs_f64(seconds));
        }
    }

    /// Keeps the session for the next run, at the end of this one.
    pub(super) fn keep_now(&mut self) {
        if let Some(files) = &mut self.files {
            let kept = files.store.keep_now(&self.session);
            self.notice.report(kept);
        }
    }
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
                    "Drop to open: a session in place of this one, a material beside the others",
                );
            });
        });
}
