//! A lesson, and the state of each of its steps.

use super::ask::Ask;
use super::patch::Patch;
use super::text::{Block, Span, Thing, spans};
use crate::session::Session;

/// A lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// The name of its file, without the ending.
    pub id: String,
    /// Its title.
    pub title: String,
    /// How long it takes, about.
    pub minutes: u32,
    /// What it is about, in a sentence; of a question the short answer.
    pub summary: String,
    /// Words by which it is found besides its title.
    pub keywords: Vec<String>,
    /// What it changes of the session that a new window has.
    pub state: Patch,
    /// Its steps, at least one.
    pub steps: Vec<Step>,
}

/// A step of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The line of its heading in the file.
    pub line: usize,
    /// Its title.
    pub title: String,
    /// What there is to read before the question.
    pub text: Vec<Block>,
    /// Which state it builds on.
    pub from: Start,
    /// What it changes of that state; `None` where it goes on with what there is.
    pub state: Option<Patch>,
    /// What is pointed out.
    pub shows: Vec<Thing>,
    /// What it asks.
    pub ask: Option<Ask>,
    /// The line of the question in the file; 0 where there is none.
    pub ask_line: usize,
    /// What there is to read once the question is answered.
    pub answer: Vec<Block>,
    /// What is changed then.
    pub after: Option<Patch>,
}

/// Which state a step builds on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// That of the step before; the lesson's for the first.
    #[default]
    Before,
    /// That of the lesson.
    Lesson,
    /// That of the step with this title.
    Step(String),
}

impl Step {
    /// The things that it points out or has words for.
    #[must_use]
    pub fn things(&self) -> Vec<&Thing> {
        let ask = self.ask.iter().flat_map(Ask::spans);
        let texts = spans(&self.text).into_iter().chain(spans(&self.answer));
        let of_words = texts.chain(ask).filter_map(|span| match span {
            Span::Words { style, .. } => style.thing.as_ref(),
            _ => None,
        });
        self.shows.iter().chain(of_words).collect()
    }
}

impl Lesson {
    /// Whether all words of `typed` stand in its title, its summary or its keywords, whatever their case.
    #[must_use]
    pub fn is_found_by(&self, typed: &str) -> bool {
        let keywords = self.keywords.iter().map(String::as_str);
        let texts = [self.title.as_str(), self.summary.as_str()];
        let all: Vec<String> = texts
            .into_iter()
            .chain(keywords)
            .map(str::to_lowercase)
            .collect();
        let typed = typed.to_lowercase();
        typed
            .split_whitespace()
            .all(|word| all.iter().any(|text| text.contains(word)))
    }

    /// The state of the step as it is once its question is answered.
    ///
    /// # Errors
    /// As [`Self::state_of`].
    pub fn state_after(&self, step: usize, session: &mut Session) -> Result<(), String> {
        let after = self.steps.get(step).and_then(|step| step.after.as_ref());
        after.map_or(Ok(()), |after| after.apply(session))
    }

    /// The state of a step: whatever was done before, it is the same each time.
    ///
    /// # Errors
    /// A sentence, where a patch asks for what there is not, or states build on one another in a circle.
    pub fn state_of(&self, step: usize) -> Result<Session, String> {
        let mut chain = Vec::new();
        let mut next = Some(step);
        while let Some(index) = next {
            if chain.contains(&index) {
                let title = |index: &usize| {
                    let step = self.steps.get(*index);
                    step.map_or_else(String::new, |step| format!("'{}'", step.title))
                };
                let titles: Vec<String> = chain.iter().chain([&index]).map(title).collect();
                return Err(format!(
                    "states that build on one another in a circle: {}",
                    titles.join(" on ")
                ));
            }
            chain.push(index);
            next = self.before(index)?;
        }
        let mut session = Session::default();
        self.state.apply(&mut session)?;
        let patches = chain
            .iter()
            .rev()
            .filter_map(|index| self.steps.get(*index));
        for patch in patches.filter_map(|step| step.state.as_ref()) {
            patch.apply(&mut session)?;
        }
        Ok(session)
    }

    /// The step that another one builds on; `None` where that is the lesson.
    fn before(&self, index: usize) -> Result<Option<usize>, String> {
        match self.steps.get(index).map(|step| &step.from) {
            Some(Start::Before) => Ok(index.checked_sub(1)),
            Some(Start::Lesson) | None => Ok(None),
            Some(Start::Step(title)) => {
                let mut steps = self.steps.iter();
                let found = steps.position(|step| step.title == *title);
                let titles = self.steps.iter().map(|step| step.title.as_str());
                let unknown = || bxdf::Error::unknown("step", title, titles).to_string();
                found.map(Some).ok_or_else(unknown)
            }
        }
    }
}
