//! How far a person is in the lessons.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

/// The questions that were answered rightly.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Progress {
    /// The titles of steps, by the ids of their lessons.
    answered: BTreeMap<String, BTreeSet<String>>,
}

impl Progress {
    /// Whether the question of a step was answered.
    #[must_use]
    pub fn is_answered(&self, lesson: &str, step: &str) -> bool {
        let steps = self.answered.get(lesson);
        steps.is_some_and(|steps| steps.contains(step))
    }

    /// Notes that it was. Returns whether that is new.
    pub fn answer(&mut self, lesson: &str, step: &str) -> bool {
        let steps = self.answered.entry(lesson.to_owned()).or_default();
        steps.insert(step.to_owned())
    }

    /// Whether nothing was answered.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.answered.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_kept_by_lesson_and_step() {
        let mut progress = Progress::default();
        assert!(progress.is_empty() && progress.answer("01-x", "One"));
        assert!(!progress.answer("01-x", "One"));
        let text = toml::to_string(&progress).unwrap();
        let read: Progress = toml::from_str(&text).unwrap();
        assert!(read.is_answered("01-x", "One") && !read.is_answered("01-x", "Two"));
        assert!(!read.is_answered("02-y", "One"));
    }
}
