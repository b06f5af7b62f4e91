//! Where a file was written, with a way there.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

use egui::{Align, Button, Label, Layout, Panel, RichText, Ui};

use bxdf_study::parallel::Pool;
use bxdf_study::platform;

/// For how long it is shown at least, in seconds: it goes with the next movement after that.
const SHOWN: f64 = 15.0;

/// How folders are opened.
type Open = fn(&Path) -> io::Result<()>;

/// What was done last, until it is taken away: a file that was written, or a picture in the clipboard.
pub struct Saved {
    text: String,
    path: Option<PathBuf>,
    /// What becomes of opening the folder.
    opening: Option<Receiver<io::Result<()>>>,
    open: Open,
    /// When it was first shown, in the time of the window.
    since: Option<f64>,
}

impl Saved {
    /// A file was written.
    #[must_use]
    pub fn to(path: &Path) -> Self {
        // As it can be used anywhere: from the root on.
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        Self {
            path: Some(path.clone()),
            ..Self::done(&format!("Saved to {}", path.display()))
        }
    }

    /// Something else was done.
    #[must_use]
    pub fn done(text: &str) -> Self {
        Self {
            text: text.to_owned(),
            path: None,
            opening: None,
            open: platform::open_folder,
            since: None,
        }
    }

    /// Says one thing more of it.
    pub fn add(&mut self, text: &str) {
        self.text = format!("{} ({text})", self.text);
    }

    /// A panel at the bottom; folders are opened by `pool`. Returns whether it stays.
    #[must_use]
    pub fn show(&mut self, ui: &mut Ui, pool: &Pool) -> bool {
        self.take_failure();
        let now = ui.input(|input| input.time);
        let is_old = now - *self.since.get_or_insert(now) > SHOWN;
        let mut stays = true;
        let panel = Panel::bottom("saved").show(ui, |ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let hint = "Take this line away";
                stays = !ui.button("Hide").on_hover_text(hint).clicked();
                if let Some(path) = &self.path {
                    if ui.button("Copy path").clicked() {
                        ui.copy_text(path.display().to_string());
                    }
                    let hint = "Open the file's folder in the system's file manager";
                    let button = Button::new("Open folder");
                    let is_idle = self.opening.is_none();
                    if ui
                        .add_enabled(is_idle, button)
                        .on_hover_text(hint)
                        .clicked()
                    {
                        self.opening = opened(path, self.open, ui.ctx(), pool);
                    }
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let label = Label::new(RichText::new(&self.text)).truncate();
                    ui.add(label.selectable(true));
                });
            });
        });
        stays && (!is_old || panel.response.contains_pointer())
    }

    /// Says so where the folder could not be opened: the path is there to be selected.
    fn take_failure(&mut self) {
        let Some(answer) = self
            .opening
            .as_ref()
            .and_then(|opening| opening.try_recv().ok())
        else {
            return;
        };
        (self.opening, self.since) = (None, None);
        if let (Err(error), Some(path)) = (answer, &self.path) {
            let path = path.display();
            self.text = format!("Saved to {path} (no program opens its folder: {error})");
        }
    }
}

/// Opens the folder of `path` without waiting for it.
fn opened(
    path: &Path,
    open: Open,
    ctx: &egui::Context,
    pool: &Pool,
) -> Option<Receiver<io::Result<()>>> {
    let folder = path.parent()?.to_owned();
    let wake = ctx.clone();
    Some(pool.wait_for(move || open(&folder), move || wake.request_repaint()))
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;

    use super::*;

    #[test]
    fn the_path_stays_where_no_program_opens_its_folder() {
        let mut saved = Saved::to(Path::new("/f/a.toml"));
        saved.open = |folder| {
            assert_eq!(folder, Path::new("/f"));
            Err(io::ErrorKind::NotFound.into())
        };
        let pool = Pool::new();
        let mut harness = Harness::new_ui_state(
            |ui, saved: &mut Option<Saved>| {
                if saved.as_mut().is_some_and(|saved| !saved.show(ui, &pool)) {
                    *saved = None;
                }
            },
            Some(saved),
        );
        assert!(harness.query_by_label("Saved to /f/a.toml").is_some());
        harness.get_by_label("Open folder").click();
        harness.run();
        for _ in 0..1000 {
            if harness
                .query_by_label_contains("no program opens")
                .is_some()
            {
                break;
            }
            std::thread::sleep(Duration::from_millis(5));
            harness.step();
        }
        let told = harness.query_by_label_contains("no program opens its folder");
        assert!(told.is_some() && harness.query_by_label_contains("/f/a.toml").is_some());
        harness.get_by_label("Hide").click();
        harness.run();
        assert!(harness.state().is_none());
    }
}
