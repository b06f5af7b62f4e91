//! The file of a lesson: a head between two lines of `+++`, then a step for each `## ` heading, in Markdown with blocks.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Tag, TagEnd};
use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::ask::{self, Ask};
use super::lesson::{Lesson, Start, Step};
use super::patch::Patch;
use super::text::{BlockReader, Problem, Thing, events};
use bxdf::error::{Error, Result};

/// The most bytes of a lesson.
const MAX_LENGTH: usize = 256 * 1024;

/// The most steps of a lesson.
const MAX_STEPS: usize = 64;

/// The line before and behind the head.
const FENCE: &str = "+++";

/// The head of a lesson.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    title: String,
    #[serde(default)]
    minutes: u32,
    #[serde(default)]
    summary: String,
    #[serde(default)]
    keywords: Vec<String>,
    #[serde(default)]
    state: Patch,
}

/// The block `state`.
#[derive(Default, Deserialize)]
struct WrittenState {
    /// The title of the step that it builds on, or `start`.
    from: Option<String>,
    #[serde(flatten)]
    patch: Patch,
}

/// The block `show`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenShow {
    view: Option<String>,
    control: Option<String>,
}

/// What is read of a step so far.
struct Draft {
    title: String,
    start: usize,
    body: BlockReader,
    text: Vec<super::text::Block>,
    state: Option<(usize, WrittenState)>,
    after: Option<Patch>,
    shows: Vec<Thing>,
    ask: Option<(usize, Ask)>,
}

/// Reads a lesson; `id` names it, `place` is what errors call its file.
///
/// # Errors
/// [`Error::Parse`] with the line, what is wrong there and what is allowed.
pub fn read(text: &str, id: &str, place: &str) -> Result<Lesson> {
    let refused = |(at, problem): Problem| {
        let before = text.get(..at).unwrap_or(text);
        let line = before.matches('\n').count() + 1;
        Error::parse(format!("{place}: line {line}"), problem)
    };
    if text.len() > MAX_LENGTH {
        return Err(Error::parse(
            place,
            format!("longer than {MAX_LENGTH} bytes"),
        ));
    }
    let (head, body) = split(text).map_err(refused)?;
    let written: Head = table(&text[head.clone()], head.start).map_err(refused)?;
    if written.title.trim().is_empty() {
        return Err(refused((head.start, "an empty title".to_owned())));
    }
    let steps = steps(text, body).map_err(refused)?;
    let lesson = Lesson {
        id: id.to_owned(),
        title: written.title,
        minutes: written.minutes,
        summary: written.summary,
        keywords: written.keywords,
        state: written.state,
        steps,
    };
    for (index, step) in lesson.steps.iter().enumerate() {
        let state = lesson.state_of(index);
        state.map_err(|problem| Error::parse(format!("{place}: line {}", step.line), problem))?;
    }
    Ok(lesson)
}

/// The bytes of the head, and where the body begins.
fn split(text: &str) -> std::result::Result<(Range<usize>, usize), Problem> {
    let begins = format!("{FENCE}\n");
    if !text.starts_with(&begins) {
        let problem = format!("a lesson begins with a line {FENCE} and its head");
        return Err((0, problem));
    }
    let start = begins.len();
    let ends = format!("\n{FENCE}");
    // The head may be empty.
    let rest = text.get(start - 1..).unwrap_or_default();
    let Some(length) = rest.find(&ends) else {
        return Err((0, format!("the head has no end: a line {FENCE}")));
    };
    let end = (start - 1 + length).max(start);
    Ok((start..end, start - 1 + length + ends.len()))
}

/// What a table says, which begins at the byte `start` of the file.
fn table<T: DeserializeOwned>(text: &str, start: usize) -> std::result::Result<T, Problem> {
    toml::from_str(text).map_err(|error: toml::de::Error| {
        let at = error.span().map_or(0, |span| span.start);
        (start + at, error.message().replace('\n', " "))
    })
}

/// The steps of the body.
fn steps(text: &str, body: usize) -> std::result::Result<Vec<Step>, Problem> {
    let mut steps: Vec<Step> = Vec::new();
    let mut draft: Option<Draft> = None;
    let mut events = events(text.get(body..).unwrap_or_default())
        .map(|(event, range)| (event, range.start + body..range.end + body));
    while let Some((event, range)) = events.next() {
        match event {
            Event::Start(Tag::Heading {
                level: HeadingLevel::H2,
                ..
            }) => {
                let mut title = String::new();
                for (event, _) in events.by_ref() {
                    match event {
                        Event::Text(text) | Event::Code(text) => title.push_str(&text),
                        Event::End(TagEnd::Heading(_)) => break,
                        _ => {}
                    }
                }
                if let Some(draft) = draft.replace(Draft::new(title, range.start)) {
                    steps.push(draft.finish(text)?);
                }
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(name))) => {
                let mut inside = range.end..range.end;
                for (event, range) in events.by_ref() {
                    match event {
                        Event::Text(_) if inside.is_empty() => inside = range,
                        Event::Text(_) => inside.end = range.end,
                        Event::End(TagEnd::CodeBlock) => break,
                        _ => {}
                    }
                }
                let block = text.get(inside.clone()).unwrap_or_default();
                let step = draft.as_mut().ok_or_else(|| outside(range.start))?;
                step.block(&name, block, inside.start, range.start)?;
            }
            event => {
                let step = draft.as_mut().ok_or_else(|| outside(range.start))?;
                step.body.read(event, &range)?;
            }
        }
    }
    if let Some(draft) = draft {
        steps.push(draft.finish(text)?);
    }
    let count = steps.len();
    if count == 0 || count > MAX_STEPS {
        let problem =
            format!("{count} steps, each a heading '## ...': allowed is 1 to {MAX_STEPS}");
        return Err((body, problem));
    }
    let mut titles: Vec<&str> = Vec::new();
    for step in &steps {
        if titles.contains(&step.title.as_str()) {
            let problem = format!("two steps are called '{}'", step.title);
            return Err((line_start(text, step.line), problem));
        }
        titles.push(&step.title);
    }
    Ok(steps)
}

/// The byte that a line begins with.
fn line_start(text: &str, line: usize) -> usize {
    let lines = text.split_inclusive('\n').take(line.saturating_sub(1));
    lines.map(str::len).sum()
}

fn outside(at: usize) -> Problem {
    let problem = "text before the first step: a step begins with '## ' and its title";
    (at, problem.to_owned())
}

impl Draft {
    fn new(title: String, start: usize) -> Self {
        Self {
            title,
            start,
            body: BlockReader::new(),
            text: Vec::new(),
            state: None,
            after: None,
            shows: Vec::new(),
            ask: None,
        }
    }

    /// Takes a block; `start`: where its text begins, `at`: where the block does.
    fn block(
        &mut self,
        name: &str,
        text: &str,
        start: usize,
        at: usize,
    ) -> std::result::Result<(), Problem> {
        match name {
            "state" if self.ask.is_some() => {
                if self.after.is_some() {
                    return Err((at, "a second state behind the question".to_owned()));
                }
                self.after = Some(table(text, start)?);
            }
            "state" => {
                if self.state.is_some() {
                    return Err((at, "a second state before the question".to_owned()));
                }
                self.state = Some((at, table(text, start)?));
            }
            "show" => {
                let WrittenShow { view, control } = table(text, start)?;
                let view = view.map(|id| Thing::read(&format!("#view-{id}")));
                let view = view.transpose().map_err(|problem| (start, problem))?;
                let control = control.map(Thing::Control);
                if view.is_none() && control.is_none() {
                    return Err((at, "nothing to show: allowed is view, control".to_owned()));
                }
                self.shows.extend(view.into_iter().chain(control));
            }
            "ask" => {
                if self.ask.is_some() {
                    return Err((at, "a second question in one step".to_owned()));
                }
                let written: ask::Written = table(text, start)?;
                let ask = written.read().map_err(|problem| (start, problem))?;
                self.ask = Some((at, ask));
                self.text = self.body.take();
            }
            other => {
                let problem = format!("a block '{other}': allowed is state, show and ask");
                return Err((at, problem));
            }
        }
        Ok(())
    }

    fn finish(mut self, text: &str) -> std::result::Result<Step, Problem> {
        let rest = self.body.take();
        let (text_before, answer) = if self.ask.is_some() {
            (self.text, rest)
        } else {
            (rest, Vec::new())
        };
        if text_before.is_empty() && self.ask.is_none() {
            return Err((self.start, format!("the step '{}' is empty", self.title)));
        }
        let line_of = |at: usize| text.get(..at).unwrap_or(text).matches('\n').count() + 1;
        let (from, state) = match self.state {
            Some((_, written)) => (written.from, Some(written.patch)),
            None => (None, None),
        };
        let from = from.map(|title| match title.as_str() {
            "start" => Start::Lesson,
            _ => Start::Step(title),
        });
        Ok(Step {
            line: line_of(self.start),
            title: self.title,
            text: text_before,
            from: from.unwrap_or_default(),
            state,
            shows: self.shows,
            ask_line: self.ask.as_ref().map_or(0, |(at, _)| line_of(*at)),
            ask: self.ask.map(|(_, ask)| ask),
            answer,
            after: self.after,
        })
    }
}
