//! Which lesson, and which step of it, the words stand for that a person types: what *Copy link to this step* copies among
//! them.

use std::path::Path;

use super::lesson::Lesson;
use super::shelf::{EXTENSION, lessons, opened, questions};
use crate::link;
use bxdf::error::{Error, Result, shown};

/// A lesson by what it is called, with a step of it where one is named.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// The lesson.
    pub lesson: Lesson,
    /// The index of the step, which there is; `None` where none is named.
    pub step: Option<usize>,
}

impl Named {
    /// Reads `NN[.STEP]`, or a link to that. NN: the id of a lesson or a question; the number that the id begins with, which is a question's
    /// where no lesson has it; or the path of a file that ends in `.md`. STEP: from 1 on.
    ///
    /// # Errors
    /// [`Error::UnknownId`] where there is no such lesson, with the nearest; [`Error::Parse`] where it has no such step, and
    /// where a file is no lesson; [`Error::Io`] where it cannot be read.
    pub fn read(text: &str) -> Result<Self> {
        match link::step_in(text) {
            Some(named) => Self::listed(named),
            None => Self::found(text, |name| file(name).or_else(|| listed(name))),
        }
    }

    /// [`Self::read`], of the lessons of the program alone: whoever wrote the text names no file.
    ///
    /// # Errors
    /// The same, but those of files.
    pub fn listed(text: &str) -> Result<Self> {
        Self::found(text, listed)
    }

    fn found(text: &str, found: impl Fn(&str) -> Option<Result<Lesson>>) -> Result<Self> {
        if let Some(lesson) = found(text) {
            let lesson = lesson?;
            return Ok(Self { lesson, step: None });
        }
        let is_number = |step: &str| !step.is_empty() && step.bytes().all(|b| b.is_ascii_digit());
        let parts = text.rsplit_once('.').filter(|(_, step)| is_number(step));
        let (name, step) = parts.ok_or_else(|| unknown(text))?;
        let lesson = found(name).unwrap_or_else(|| Err(unknown(name)))?;
        let count = lesson.steps.len();
        let index = step.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
        match index.filter(|index| *index < count) {
            Some(index) => Ok(Self {
                lesson,
                step: Some(index),
            }),
            None => Err(Error::parse(
                format!("step '{}' of lesson '{}'", shown(step), lesson.id),
                match count {
                    1 => "it has one step: 1".to_owned(),
                    _ => format!("it has steps 1 to {count}"),
                },
            )),
        }
    }
}

/// All lessons of the program, the questions last.
fn all() -> impl Iterator<Item = &'static Lesson> {
    lessons().iter().chain(questions())
}

fn unknown(name: &str) -> Error {
    Error::unknown("lesson", name, all().map(|lesson| lesson.id.as_str()))
}

/// The lesson of the file of this name, if it is one of a lesson.
fn file(name: &str) -> Option<Result<Lesson>> {
    let path = Path::new(name);
    let is_lesson = path.extension().is_some_and(|end| end == EXTENSION);
    is_lesson.then(|| opened(path))
}

/// The lesson of the program of this name, if it is one.
fn listed(name: &str) -> Option<Result<Lesson>> {
    let number = name.parse::<u32>().ok();
    let has_number = |lesson: &&Lesson| {
        let begin = lesson.id.split('-').next();
        number.is_some() && begin.and_then(|begin| begin.parse().ok()) == number
    };
    let by_id = all().find(|lesson| lesson.id == name);
    let lesson = by_id.or_else(|| all().find(has_number));
    lesson.cloned().map(Ok)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (String, Option<usize>) {
        let named = Named::read(text).unwrap();
        (named.lesson.id, named.step)
    }

    #[test]
    fn lessons_are_named_by_number_by_id_and_by_file() {
        let lesson = &lessons()[0];
        let id = lesson.id.clone();
        assert!(id.starts_with("01-"), "{id}");
        for text in ["1", "01", &id] {
            assert_eq!(read(text), (id.clone(), None));
            assert_eq!(read(&format!("{text}.2")), (id.clone(), Some(1)));
        }
        let question = questions().last().unwrap();
        assert_eq!(read(&question.id), (question.id.clone(), None));
        assert_eq!(read(&questions().len().to_string()).0, question.id);
        let file = format!("../../assets/lessons/{id}.md");
        assert_eq!(read(&file), (id.clone(), None));
        assert_eq!(read(&format!("{file}.3")), (id, Some(2)));
    }

    #[test]
    fn what_there_is_not_is_refused_with_what_there_is() {
        let (first, count) = (&lessons()[0].id, lessons()[0].steps.len());
        for (text, expected) in [
            ("99", "unknown lesson '99'"),
            ("01-scatering", "nearest: 01-scattering"),
            (
                "01-scatering.2",
                "unknown lesson '01-scatering'; nearest: 01-scattering",
            ),
            ("no-such.md", "no-such.md"),
            ("", "unknown lesson ''"),
            ("1.", "unknown lesson '1.'"),
            (
                "1.0",
                &format!("step '0' of lesson '{first}': it has steps 1 to {count}"),
            ),
            ("1.99999999999999999999", "it has steps 1 to"),
            ("01-why-one-over-pi.2", "it has one step: 1"),
        ] {
            if file(text).is_none() {
                let listed = Named::listed(text).unwrap_err().to_string();
                assert!(listed.contains(expected), "{text}: {listed}");
            }
            let error = Named::read(text).unwrap_err().to_string();
            assert!(error.contains(expected), "{text}: {error}");
        }
    }
}
