//! The files that the application works on, and what asks for them.

use std::collections::HashMap;
use std::path::PathBuf;

use super::picture::Maker;
use crate::widgets::path_field::PathField;
use bxdf_study::history::Document;
use bxdf_study::store::{Dialogs, FileDialog, Store};

/// The files that the application works on.
pub struct Files {
    pub(super) store: Store,
    pub(super) asking: Asking,
    /// What makes the files of pictures.
    pub(super) maker: Maker,
    /// The files of the sessions that were opened from one or saved to one.
    pub(super) of: HashMap<Document, PathBuf>,
}

/// What asks for files, one dialog at a time.
pub struct Asking {
    pub(super) dialogs: Box<dyn Dialogs>,
    /// Whether it turned out that the system has no dialogs.
    pub(super) has_none: bool,
    /// The dialog that is asked in their place.
    pub(super) field: Option<PathField>,
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
    /// Whether a path is being typed.
    pub(super) fn is_asking(&self) -> bool {
        self.asking.field.is_some()
    }

    /// Asks for a file, unless something is being asked for. Returns whether it does.
    pub(super) fn ask(&mut self, dialog: FileDialog) -> bool {
        if self.asking.dialogs.is_open() || self.asking.field.is_some() {
            return false;
        }
        if self.asking.has_none {
            self.ask_in_field(dialog);
        } else {
            self.asking.dialogs.ask(dialog);
        }
        true
    }

    pub(super) fn ask_in_field(&mut self, dialog: FileDialog) {
        let folder = self.store.working_folder();
        self.asking.field = Some(PathField::new(dialog, folder));
    }
}
