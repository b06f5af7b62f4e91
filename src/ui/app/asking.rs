//! Asking for files: by the dialogs of the system, or by a field for the path where it has none.

use std::path::Path;
use std::time::Duration;

use egui::Context;

use super::App;
use super::files::Files;
use crate::error::Result;
use crate::ui::store::{Answer, Dialogs, Question};
use crate::ui::widgets::path_field::{Outcome, PathField};

/// How often an open dialog is looked at, in seconds.
const POLL: f64 = 0.1;

/// What asks for files, one question at a time.
pub struct Asking {
    dialogs: Box<dyn Dialogs>,
    /// Whether it turned out that the system has no dialogs.
    has_none: bool,
    /// The question that is asked in their place.
    field: Option<PathField>,
}

impl Asking {
    /// Asks by these dialogs, as long as they answer.
    pub(super) fn by(dialogs: Box<dyn Dialogs>) -> Self {
        Self {
            dialogs,
            has_none: false,
            field: None,
        }
    }
}

impl Files {
    /// Asks for a file, unless something is being asked for. Returns whether it does.
    pub(super) fn ask(&mut self, question: Question) -> bool {
        if self.asking.dialogs.is_open() || self.asking.field.is_some() {
            return false;
        }
        if self.asking.has_none {
            self.ask_in_field(question);
        } else {
            self.asking.dialogs.ask(question);
        }
        true
    }

    fn ask_in_field(&mut self, question: Question) {
        let folder = self.store.working_folder();
        self.asking.field = Some(PathField::new(question, folder));
    }
}

impl App {
    /// Takes what a dialog answers.
    pub(super) fn take_answers(&mut self, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        if !files.asking.dialogs.is_open() {
            return;
        }
        match files.asking.dialogs.answer() {
            Some((question, Answer::File(path))) => {
                let done = self.do_with(&question, &path, ctx);
                self.notice.report(done);
            }
            Some((_, Answer::Dismissed)) => {}
            Some((question, Answer::NoDialog)) => {
                files.asking.has_none = true;
                files.ask_in_field(question);
            }
            None => ctx.request_repaint_after(Duration::from_secs_f64(POLL)),
        }
    }

    /// The field for a path, while it asks.
    pub(super) fn show_path_field(&mut self, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        let Some(mut field) = files.asking.field.take() else {
            return;
        };
        let outcome = field.show(ctx, &|path: &Path| files.store.look(path));
        let stays = match outcome {
            Outcome::Open => true,
            Outcome::Dismissed => false,
            Outcome::Chosen(path) => {
                let question = field.question().clone();
                match self.do_with(&question, &path, ctx) {
                    Ok(()) => false,
                    Err(error) => {
                        field.refuse(error.to_string());
                        true
                    }
                }
            }
        };
        if let Some(files) = &mut self.files
            && stays
        {
            files.asking.field = Some(field);
        }
    }

    /// Does what the file was asked for.
    fn do_with(&mut self, question: &Question, path: &Path, ctx: &Context) -> Result<()> {
        match question {
            Question::Open => self.open(path, ctx),
            Question::Save(_) => self.save_to(path)?,
            Question::Export(_) => self.export_to(path, ctx),
        }
        Ok(())
    }
}
