//! Where sessions are kept: in files of the user's, and between two runs of the program.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::colors::Theme;
use super::export::figure::FigureChoice;
use super::lessons::Shelf;
use super::parallel::Pool;
use super::session::{Opened, Session};
#[cfg(doc)]
use crate::files::MAX_TEXT;
use bxdf::error::Result;
use own::Own;
use place::Places;

mod dialogs;
mod files;
mod labels;
mod motion;
mod own;
mod partial;
mod place;
mod preferences;
mod progress;
mod window;

pub use dialogs::{Answer, Dialogs, FileDialog};
pub use files::{Disk, Files, Found, Held};
pub use labels::LabelSize;
pub use own::{Keeping, News, Restored};
pub use partial::{Partial, abandon_partial};
use preferences::Preferences;
pub use preferences::Side;
pub use progress::Progress;
pub use window::WindowPlace;

/// The files opened last, the theme, how the window stands and how figures are made, in the folder of the program's data.
const PREFERENCES: &str = "preferences.toml";

/// How many recent files are kept.
const MAX_RECENT: usize = 8;

/// Files of sessions and materials. Whatever is written stands complete in its place, or the file before it does.
pub struct Store {
    places: Places,
    /// Where the program keeps its own.
    folder: Option<PathBuf>,
    preferences: Preferences,
    /// Whether the window stands elsewhere than the file says.
    is_window_moved: bool,
    own: Own,
}

impl Store {
    /// A store on `files`, which keeps the program's own in `folder`; without one it keeps nothing for the next run.
    #[must_use]
    pub fn new(files: Arc<dyn Files>, folder: Option<PathBuf>) -> Self {
        let mut store = Self {
            places: Places::new(files),
            folder,
            preferences: Preferences::default(),
            is_window_moved: false,
            own: Own::default(),
        };
        store.preferences = store.read_preferences();
        store
    }

    /// The store of this machine, in the folder where programs keep their data.
    #[cfg(not(target_arch = "wasm32"))]
    #[must_use]
    pub fn platform() -> Self {
        let folders = directories::ProjectDirs::from("", "", "brdf-explorer");
        let folder = folders.map(|folders| folders.data_dir().to_owned());
        Self::new(Arc::new(Disk), folder)
    }

    /// Keeps the session in a thread of `pool` from now on: a disk that is busy does not stop the window.
    #[must_use]
    pub fn in_threads(mut self, pool: Pool) -> Self {
        self.own.pool = pool;
        self
    }

    /// The session of the last run, or the one before it where that cannot be read, or `start`; with what there is to say of
    /// it. Nothing is written before the session differs from it: what cannot be read stays as it is until then, and is set
    /// aside under another name.
    pub fn restore(&mut self, start: Session) -> Restored {
        match &self.folder {
            Some(folder) => self.own.restore(&self.places, folder, start),
            None => Restored {
                session: start,
                said: Vec::new(),
            },
        }
    }

    /// Keeps the session for the next run, a moment after it has changed, and again and again where that fails; `now` in
    /// seconds.
    pub fn keep(&mut self, session: &Session, now: f64) -> Keeping {
        match &self.folder {
            Some(folder) => self.own.keep(&self.places, folder, session, now),
            None => Keeping::default(),
        }
    }

    /// Keeps the session for the next run, and where the window stands, at once.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn keep_now(&mut self, session: &Session) -> Result<()> {
        if std::mem::take(&mut self.is_window_moved) {
            self.keep_preferences();
        }
        match &self.folder {
            Some(folder) => {
                let kept = self.own.keep_now(&self.places, folder, session);
                kept.map(|_| ())
            }
            None => Ok(()),
        }
    }

    /// Puts the session where files stand that nobody keeps, for want of a better place. Returns where.
    #[must_use]
    pub fn rescue(&self, session: &Session) -> Option<PathBuf> {
        if !self.places.files.has_places() {
            return None;
        }
        let name = format!("brdf-explorer-session-{}.toml", std::process::id());
        let path = std::env::temp_dir().join(name);
        let kept = self.places.replace(&path, session);
        kept.is_ok().then_some(path)
    }

    /// Writes the session to a file of the user's. Returns the name that a file in its place has now, if that could not be
    /// read.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub fn save(&mut self, path: &Path, session: &Session) -> Result<Option<PathBuf>> {
        let aside = self.places.replace(path, session)?;
        self.remember(path);
        Ok(aside)
    }

    /// [`Self::save`], with all data in the file, which then needs no other.
    ///
    /// # Errors
    /// As [`Self::save`], and where the file would be too large, with the sizes of its data.
    pub fn save_with_data(&mut self, path: &Path, session: &Session) -> Result<Option<PathBuf>> {
        self.save(path, &session.with_data()?)
    }

    /// Writes what was exported to a file of the user's.
    ///
    /// # Errors
    /// Where it cannot be written; the file that was there is as it was.
    pub fn export(&mut self, path: &Path, bytes: &[u8]) -> Result<()> {
        self.places.put(path, bytes, || Ok(()))?;
        self.work_in(path);
        self.keep_preferences();
        Ok(())
    }

    /// What reads a file of the user's, a session or a material, in whichever thread.
    ///
    /// # Errors
    /// Those of what is returned: where the file cannot be read, is larger than [`MAX_TEXT`], and where it is neither.
    pub fn reader(&self, path: &Path) -> impl FnOnce() -> Result<Opened> + Send + 'static {
        let (places, path) = (self.places.clone(), path.to_owned());
        move || places.read(&path)
    }

    /// The lesson at `path`, or those of a folder.
    ///
    /// # Errors
    /// Where it cannot be read, and where it holds no lesson.
    pub fn lessons(&self, path: &Path) -> Result<Shelf> {
        match self.look(path) {
            Ok(Found::File) => Shelf::of_text(&self.places.text(path)?, path),
            _ => Shelf::open(path),
        }
    }

    /// What reads a file of data, in whichever thread.
    pub fn data_reader(&self) -> impl Fn(&Path) -> Result<Vec<u8>> + Send + 'static {
        let places = self.places.clone();
        move |path| places.data(path)
    }

    /// What stands at a path.
    ///
    /// # Errors
    /// The system's; `NotFound` where there is nothing.
    pub fn look(&self, path: &Path) -> std::io::Result<Found> {
        self.places.files.look(path)
    }

    /// The folder that files were saved in or opened from last, else that of the user's documents.
    #[must_use]
    pub fn working_folder(&self) -> PathBuf {
        let is_there = |folder: &PathBuf| matches!(self.look(folder), Ok(Found::Folder));
        let last = self.preferences.folder.clone().filter(is_there);
        last.or_else(|| home().filter(is_there)).unwrap_or_default()
    }

    /// The files opened or saved last, the latest first.
    #[must_use]
    pub fn recent(&self) -> &[PathBuf] {
        &self.preferences.recent
    }

    /// The theme that was chosen last; the system's where there is none.
    #[must_use]
    pub fn theme(&self) -> Option<Theme> {
        self.preferences.theme
    }

    /// Keeps the theme that is chosen.
    pub fn keep_theme(&mut self, theme: Option<Theme>) {
        if self.preferences.theme != theme {
            self.preferences.theme = theme;
            self.keep_preferences();
        }
    }

    /// Whether the first steps were done or left in any run.
    #[must_use]
    pub fn has_seen_first_steps(&self) -> bool {
        // Where nothing is kept they would come again and again.
        self.folder.is_none() || self.preferences.has_seen_first_steps
    }

    /// Keeps that the first steps were done or left.
    pub fn keep_first_steps_seen(&mut self) {
        if !self.preferences.has_seen_first_steps {
            self.preferences.has_seen_first_steps = true;
            self.keep_preferences();
        }
    }

    /// Where the window stood last, and how large it was.
    #[must_use]
    pub fn window(&self) -> Option<WindowPlace> {
        self.preferences.window
    }

    /// Keeps where the window stands; that is written with something else, or at the end of the run.
    pub fn keep_window(&mut self, window: WindowPlace) {
        self.is_window_moved |= self.preferences.window != Some(window);
        self.preferences.window = Some(window);
    }

    /// How large the labels of plots were last.
    #[must_use]
    pub fn labels(&self) -> LabelSize {
        self.preferences.labels
    }

    /// Keeps how large the labels of plots are.
    pub fn keep_labels(&mut self, labels: LabelSize) {
        if self.preferences.labels != labels {
            self.preferences.labels = labels;
            self.keep_preferences();
        }
    }

    /// How the panel at the side stood last.
    #[must_use]
    pub fn side(&self) -> Side {
        self.preferences.side
    }

    /// Keeps how the panel at the side stands.
    pub fn keep_side(&mut self, side: Side) {
        if self.preferences.side != side {
            self.preferences.side = side;
            self.keep_preferences();
        }
    }

    /// How figures were made last.
    #[must_use]
    pub fn figure(&self) -> FigureChoice {
        self.preferences.figure
    }

    /// Keeps how figures are made.
    pub fn keep_figure(&mut self, figure: FigureChoice) {
        if self.preferences.figure != figure {
            self.preferences.figure = figure;
            self.keep_preferences();
        }
    }

    /// Which questions of lessons were answered.
    #[must_use]
    pub fn progress(&self) -> &Progress {
        &self.preferences.lessons
    }

    /// Keeps which questions of lessons were answered.
    pub fn keep_progress(&mut self, progress: &Progress) {
        if self.preferences.lessons != *progress {
            self.preferences.lessons.clone_from(progress);
            self.keep_preferences();
        }
    }

    /// The address of the page that links begin with.
    #[must_use]
    pub fn page(&self) -> Option<&str> {
        self.preferences.page.as_deref()
    }

    /// Keeps the address of the page that links begin with.
    pub fn keep_page(&mut self, page: Option<String>) {
        if self.preferences.page != page {
            self.preferences.page = page;
            self.keep_preferences();
        }
    }

    fn own_file(&self, name: &str) -> Option<PathBuf> {
        self.folder.as_ref().map(|folder| folder.join(name))
    }

    fn read_preferences(&self) -> Preferences {
        // Where they are missing or broken there are none: nothing but convenience is lost, and of one broken line only that.
        let text = self
            .own_file(PREFERENCES)
            .and_then(|path| self.places.text(&path).ok());
        let table: Option<toml::Table> = text.and_then(|text| toml::from_str(&text).ok());
        let is_sound = |key: &String, value: &toml::Value| {
            let alone = toml::Table::from_iter([(key.clone(), value.clone())]);
            alone.try_into::<Preferences>().is_ok()
        };
        let sound = table.into_iter().flatten();
        let sound: toml::Table = sound.filter(|(key, value)| is_sound(key, value)).collect();
        let mut read: Preferences = sound.try_into().unwrap_or_default();
        read.recent.truncate(MAX_RECENT);
        read.window = read.window.filter(WindowPlace::is_allowed);
        read
    }

    /// Puts a file that was opened or saved first in the list of recent ones.
    pub fn remember(&mut self, path: &Path) {
        if !self.places.files.has_places() {
            return;
        }
        // Another window may have been at work meanwhile.
        if self.folder.is_some() {
            self.preferences.recent = self.read_preferences().recent;
        }
        let recent = &mut self.preferences.recent;
        recent.retain(|other| other != path);
        recent.insert(0, path.to_owned());
        recent.truncate(MAX_RECENT);
        self.work_in(path);
        self.keep_preferences();
    }

    fn work_in(&mut self, path: &Path) {
        self.preferences.folder = path.parent().map(Path::to_owned);
    }

    fn keep_preferences(&self) {
        if let (Some(folder), Ok(text)) = (&self.folder, toml::to_string(&self.preferences))
            && self.places.files.make_folder(folder).is_ok()
        {
            // What cannot be kept is forgotten with the program.
            let path = folder.join(PREFERENCES);
            let _ = self.places.put(&path, text.as_bytes(), || Ok(()));
        }
    }
}

/// Where the user's own files are.
fn home() -> Option<PathBuf> {
    let folders = directories::UserDirs::new()?;
    let documents = folders.document_dir().map(Path::to_owned);
    Some(documents.unwrap_or_else(|| folders.home_dir().to_owned()))
}

#[cfg(test)]
mod tests;
