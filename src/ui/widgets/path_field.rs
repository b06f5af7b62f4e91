//! A field for the path of a file: what asks for one where the machine has no dialogs.

use std::io;
use std::path::{Path, PathBuf};

use egui::text::{CCursor, CCursorRange};
use egui::{Context, Id, Key, Modal, RichText, TextEdit, Ui};

use crate::theme;
use bxdf_study::store::{FileDialog, Found};

/// The longest path that is read, in characters: no system has longer ones.
const LONGEST: usize = 4096;

/// What becomes of the dialog.
#[derive(Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It stands.
    Open,
    /// No file is wanted.
    Dismissed,
    /// This file is meant.
    Chosen(PathBuf),
}

/// What stands at a path, as the system tells.
pub type Look<'a> = &'a dyn Fn(&Path) -> io::Result<Found>;

/// A dialog for a file that is being answered.
pub struct PathField {
    dialog: FileDialog,
    /// What a path without a folder is in.
    folder: PathBuf,
    text: String,
    problem: Option<String>,
    /// The file that is there already, if it may be replaced.
    replaced: Option<PathBuf>,
    /// Whether the name is to be marked, so that typing replaces it.
    is_new: bool,
}

impl PathField {
    /// Asks `dialog`; the path begins with `folder`.
    #[must_use]
    pub fn new(dialog: FileDialog, folder: PathBuf) -> Self {
        let proposed = match &dialog {
            FileDialog::Open => "",
            FileDialog::Save(name) | FileDialog::SaveWithData(name) | FileDialog::Export(name) => {
                name
            }
        };
        let text = folder.join(proposed).display().to_string();
        Self {
            dialog,
            folder,
            text,
            problem: None,
            replaced: None,
            is_new: true,
        }
    }

    /// The dialog.
    #[must_use]
    pub fn dialog(&self) -> &FileDialog {
        &self.dialog
    }

    /// Says what became of the answer, and goes on asking.
    pub fn refuse(&mut self, problem: String) {
        self.problem = Some(problem);
        self.replaced = None;
    }

    /// The window of the dialog.
    pub fn show(&mut self, ctx: &Context, look: Look<'_>) -> Outcome {
        let modal = Modal::new(Id::unique("path")).show(ctx, |ui| {
            ui.set_width(theme::PATH_WIDTH.min(theme::room_of_dialog(ctx).x));
            self.contents(ui, look)
        });
        match modal.inner {
            Outcome::Open if modal.should_close() => Outcome::Dismissed,
            outcome => outcome,
        }
    }

    fn contents(&mut self, ui: &mut Ui, look: Look<'_>) -> Outcome {
        let (title, verb) = match &self.dialog {
            FileDialog::Open => ("Open a file", "Open"),
            FileDialog::Save(_) => ("Save to a file", "Save"),
            FileDialog::SaveWithData(_) => ("Save to a file, with all data", "Save"),
            FileDialog::Export(_) => ("Export to a file", "Export"),
        };
        ui.label(RichText::new(title).strong());
        ui.label(
            RichText::new("This system has no file dialog")
                .weak()
                .small(),
        );
        let is_entered = self.field(ui);
        if let Some(problem) = &self.problem {
            ui.colored_label(ui.visuals().error_fg_color, problem);
        }
        let mut outcome = Outcome::Open;
        ui.horizontal(|ui| {
            let verb = if self.replaced.is_some() {
                "Replace it"
            } else {
                verb
            };
            if ui.button(verb).clicked() || is_entered {
                outcome = self.answer(look);
            }
            if ui.button("Cancel").clicked() {
                outcome = Outcome::Dismissed;
            }
        });
        outcome
    }

    /// The field itself. Returns whether Enter is pressed in it.
    fn field(&mut self, ui: &mut Ui) -> bool {
        let id = ui.scope_id().with("field");
        let field = TextEdit::singleline(&mut self.text)
            .id(id)
            .char_limit(LONGEST)
            .desired_width(f32::INFINITY);
        let mut output = field.show(ui);
        let response = output.response.response.clone();
        let name = "Path of the file";
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_label(name));
        if response.changed() {
            (self.problem, self.replaced) = (None, None);
        }
        let is_entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        // It has the focus when it is seen to: below a window that has just closed the first wish for it is not granted.
        self.is_new &= !response.has_focus();
        if is_entered || self.is_new {
            response.request_focus();
        }
        if self.is_new {
            // The name without its extension is marked: typing replaces it, the folder stays.
            let end = self.text.chars().count();
            let separator = |c: char| std::path::is_separator(c);
            let tail = self.text.rsplit(separator).next().unwrap_or_default();
            let start = end - tail.chars().count();
            let stem = tail.rsplit_once('.').map_or(tail, |(stem, _)| stem);
            let marked = [start, start + stem.chars().count()].map(CCursor::new);
            let range = CCursorRange::two(marked[0], marked[1]);
            output.state.cursor.set_char_range(Some(range));
            output.state.store(ui.ctx(), response.id);
        }
        is_entered
    }

    /// What is meant, or what is wrong with it.
    fn answer(&mut self, look: Look<'_>) -> Outcome {
        match self.checked(look) {
            Ok(path) => Outcome::Chosen(path),
            Err(problem) => {
                self.problem = Some(problem);
                Outcome::Open
            }
        }
    }

    fn checked(&mut self, look: Look<'_>) -> Result<PathBuf, String> {
        let mut path = self.path().ok_or("Name a file")?;
        let found = look(&path);
        if matches!(found, Ok(Found::Folder)) {
            return Err(format!("{} is a folder: name a file in it", path.display()));
        }
        let (FileDialog::Save(proposed)
        | FileDialog::SaveWithData(proposed)
        | FileDialog::Export(proposed)) = &self.dialog
        else {
            return match found {
                Ok(_) => Ok(path),
                Err(error) => Err(format!("{}: {error}", path.display())),
            };
        };
        if path.extension().is_none()
            && let Some(extension) = Path::new(proposed).extension()
        {
            path.set_extension(extension);
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        if !folder.as_os_str().is_empty() && !matches!(look(folder), Ok(Found::Folder)) {
            return Err(format!("{} is no folder", folder.display()));
        }
        if look(&path).is_ok() && self.replaced.as_ref() != Some(&path) {
            let problem = format!(
                "{} is there already: Enter once more replaces it",
                path.display()
            );
            self.replaced = Some(path);
            return Err(problem);
        }
        Ok(path)
    }

    /// The path that is typed; `None` where none is.
    fn path(&self) -> Option<PathBuf> {
        // As paths are pasted: with blanks, a line end, or quotes around them.
        let text = self.text.trim().trim_matches(['"', '\'']);
        if text.is_empty() || Path::new(text) == self.folder {
            return None;
        }
        if let Some(rest) = text.strip_prefix("~/")
            && let Some(home) = std::env::home_dir()
        {
            return Some(home.join(rest));
        }
        Some(self.folder.join(text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disk with folders /f and /g, and a file a.toml in the first.
    fn look(path: &Path) -> io::Result<Found> {
        match path.to_str() {
            Some("/f" | "/f/" | "/g") => Ok(Found::Folder),
            Some("/f/a.toml") => Ok(Found::File),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }

    fn answers(dialog: FileDialog, text: &str) -> Vec<Result<PathBuf, String>> {
        let mut field = PathField::new(dialog, "/f".into());
        field.text = text.to_owned();
        [(); 2].map(|()| field.checked(&look)).to_vec()
    }

    #[test]
    fn a_path_is_taken_as_it_is_meant() {
        let save = || FileDialog::Save("session.toml".to_owned());
        assert_eq!(PathField::new(save(), "/f".into()).text, "/f/session.toml");
        for text in ["/f/b.toml", "b.toml", " b ", "'/f/b'", "\"b.toml\""] {
            let expected = Ok(PathBuf::from("/f/b.toml"));
            assert_eq!(answers(save(), text)[0], expected, "{text}");
        }
        let opened = answers(FileDialog::Open, "a.toml");
        assert_eq!(opened[0], Ok("/f/a.toml".into()));
    }

    #[test]
    fn what_is_wrong_is_said_and_a_file_is_replaced_at_the_second_time() {
        let save = || FileDialog::Save("session.toml".to_owned());
        for (dialog, text, expected) in [
            (save(), "", "Name a file"),
            (save(), "/f/", "Name a file"),
            (save(), "/f/none/b", "/f/none is no folder"),
            (FileDialog::Open, "b.toml", "/f/b.toml: "),
            (FileDialog::Open, "/g", "/g is a folder"),
        ] {
            let found = answers(dialog, text);
            let line = found[1].clone().unwrap_err();
            assert!(line.starts_with(expected), "{text}: {line}");
        }
        let twice = answers(save(), "a");
        assert!(twice[0].clone().unwrap_err().contains("is there already"));
        assert_eq!(twice[1], Ok("/f/a.toml".into()));
    }
}
