//! Asking for files: by the dialogs of the system, or by a field for the path where it has none.

use std::path::Path;
use std::time::Duration;

use egui::Context;

use super::App;
use crate::widgets::path_field::Outcome;
use bxdf::error::Result;
use bxdf_study::store::{Answer, FileDialog, Store};

/// How often an open dialog is looked at, in seconds.
const POLL: f64 = 0.1;

impl App {
    /// Takes what a dialog answers.
    pub(super) fn take_answers(&mut self, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        if !files.asking.dialogs.is_open() {
            return;
        }
        match files.asking.dialogs.answer() {
            Some((dialog, Answer::File(path))) => {
                let done = self.do_with(&dialog, &path, ctx);
                self.notice.report(done);
            }
            Some((_, Answer::Dismissed)) => {}
            Some((dialog, Answer::NoDialog)) => {
                files.asking.has_none = true;
                files.ask_in_field(dialog);
            }
            None => ctx.request_repaint_after(Duration::from_secs_f64(POLL)),
        }
    }

    /// The field for a path, while it asks.
    pub(crate) fn show_path_field(&mut self, ctx: &Context) {
        let Some(files) = &mut self.files else { return };
        let Some(mut field) = files.asking.field.take() else {
            return;
        };
        let outcome = field.show(ctx, &|path: &Path| files.store.look(path));
        let stays = match outcome {
            Outcome::Open => true,
            Outcome::Dismissed => false,
            Outcome::Chosen(path) => {
                let dialog = field.dialog().clone();
                match self.do_with(&dialog, &path, ctx) {
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
    fn do_with(&mut self, dialog: &FileDialog, path: &Path, ctx: &Context) -> Result<()> {
        match dialog {
            FileDialog::Open => self.open(path, ctx),
            FileDialog::Save(_) => self.save_to(path, Store::save)?,
            FileDialog::SaveWithData(_) => self.save_to(path, Store::save_with_data)?,
            FileDialog::Export(_) => self.export_to(path, ctx)?,
        }
        Ok(())
    }
}
