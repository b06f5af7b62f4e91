//! The lessons there are: those of the program, and those of a person.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};

use super::lesson::Lesson;
use super::read::read;
use crate::files;
use bxdf::error::{Error, Result};

/// The files. Their folders are the one list of them.
static LESSONS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../assets/lessons");
static QUESTIONS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../assets/questions");

static READ: LazyLock<[Vec<Lesson>; 2]> = LazyLock::new(|| [&LESSONS, &QUESTIONS].map(embedded));

/// The lessons of the program, in the order of the path.
#[must_use]
pub fn lessons() -> &'static [Lesson] {
    let [lessons, _] = &*READ;
    lessons
}

/// The questions that people ask most, each a lesson of one step.
#[must_use]
pub fn questions() -> &'static [Lesson] {
    let [_, questions] = &*READ;
    questions
}

/// The lessons of a folder of the program. A test reads every file: none is left out here.
fn embedded(folder: &Dir<'static>) -> Vec<Lesson> {
    let read_all = |folder| texts(folder).filter_map(|(id, text)| read(text, id, id).ok());
    read_all(folder).collect()
}

/// The files of a folder of the program, by name: the id and the text of each.
pub(super) fn texts(folder: &Dir<'static>) -> impl Iterator<Item = (&'static str, &'static str)> {
    let mut all: Vec<_> = folder
        .files()
        .filter_map(|file| Some((lesson_id(file.path())?, file.contents_utf8()?)))
        .collect();
    all.sort_unstable();
    all.into_iter()
}

/// What the name of a file of a lesson ends in.
pub const EXTENSION: &str = "md";

/// The id of the lesson in a file; `None` where the file holds none.
fn lesson_id(path: &Path) -> Option<&str> {
    let is_markdown = path
        .extension()
        .is_some_and(|extension| extension == EXTENSION);
    let id = path.file_stem()?.to_str()?;
    (is_markdown && !id.eq_ignore_ascii_case("readme")).then_some(id)
}

/// Whether a path is of a lesson or of a folder of them.
#[must_use]
pub fn is_lesson(path: &Path) -> bool {
    lesson_id(path).is_some() || path.is_dir()
}

/// Lessons that a person opened.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shelf {
    /// The lessons, by the names of their files.
    pub lessons: Vec<Lesson>,
    /// What could not be read: a line for each file.
    pub problems: Vec<String>,
}

impl Shelf {
    /// The lesson of a file that has been read; `path` names it.
    ///
    /// # Errors
    /// Where the text is no lesson.
    pub fn of_text(text: &str, path: &Path) -> Result<Self> {
        let id = path.file_stem().map(|stem| stem.to_string_lossy());
        let place = path.display().to_string();
        Ok(Self {
            lessons: vec![read(text, &id.unwrap_or_default(), &place)?],
            problems: Vec::new(),
        })
    }

    /// The lesson of a file, or those of all files of a folder, the rest of which loads where some are broken.
    ///
    /// # Errors
    /// Where the file or the folder cannot be read, and where a folder holds no lesson.
    pub fn open(path: &Path) -> Result<Self> {
        let mut shelf = Self::default();
        if !path.is_dir() {
            shelf.lessons.push(opened(path)?);
            return Ok(shelf);
        }
        let paths = files_of(path)?;
        if paths.is_empty() {
            return Err(Error::parse(
                path.display().to_string(),
                "there is no lesson in it: a file that ends in .md",
            ));
        }
        for path in paths {
            match opened(&path) {
                Ok(lesson) => shelf.lessons.push(lesson),
                Err(error) => shelf.problems.push(error.to_string()),
            }
        }
        Ok(shelf)
    }
}

/// The files of lessons in a folder, by name.
fn files_of(folder: &Path) -> Result<Vec<PathBuf>> {
    let refused = |error: std::io::Error| Error::io(folder.display().to_string(), error);
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(refused)? {
        let path = entry.map_err(refused)?.path();
        if lesson_id(&path).is_some() {
            paths.push(path);
        }
    }
    paths.sort_unstable();
    Ok(paths)
}

/// The lesson of a file.
///
/// # Errors
/// Where it cannot be read, and where it is no lesson.
pub(super) fn opened(path: &Path) -> Result<Lesson> {
    let place = path.display().to_string();
    let text = files::text_at(path, "a lesson is text")?;
    let id = path.file_stem().map(|stem| stem.to_string_lossy());
    read(&text, &id.unwrap_or_default(), &place)
}
