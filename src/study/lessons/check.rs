//! Goes through a lesson as a student would who answers every question rightly, and wrongly.

use super::ask::{Ask, Kind, Number, Reach, Tolerance, Verdict, right_choice};
use super::lesson::{Lesson, Step};
use super::scenes::Scenes;
use super::text::{Block, Span, spans};
use crate::session::Session;

/// What is wrong with a lesson.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The line of the file.
    pub line: usize,
    /// What is wrong, in a sentence.
    pub problem: String,
}

/// Loads every step of a lesson, computes all its numbers, and answers every question rightly and wrongly.
#[must_use]
pub fn check(lesson: &Lesson) -> Vec<Fault> {
    let each = lesson.steps.iter().enumerate();
    each.flat_map(|(index, step)| check_step(lesson, index, step))
        .collect()
}

fn check_step(lesson: &Lesson, index: usize, step: &Step) -> Vec<Fault> {
    let at = |line: usize| move |problem: String| Fault { line, problem };
    let mut session = match lesson.state_of(index) {
        Ok(session) => session,
        Err(problem) => return vec![at(step.line)(problem)],
    };
    let mut faults: Vec<Fault> = numbers(&step.text, &session).map(at(step.line)).collect();
    if let Some(ask) = &step.ask {
        faults.extend(answered(ask, &mut session).map(at(step.ask_line)));
    }
    if let Some(after) = &step.after
        && let Err(problem) = after.apply(&mut session)
    {
        faults.push(at(step.ask_line)(problem));
    }
    // The text before the question is still read then.
    for (blocks, line) in [(&step.answer, step.ask_line), (&step.text, step.line)] {
        let more: Vec<Fault> = numbers(blocks, &session).map(at(line)).collect();
        faults.extend(
            more.into_iter()
                .filter(|fault| !faults.contains(fault))
                .collect::<Vec<_>>(),
        );
    }
    faults
}

/// The numbers of a text that have no value.
fn numbers(blocks: &[Block], session: &Session) -> impl Iterator<Item = String> {
    let scenes = Scenes::of(session);
    let all: Vec<String> = problems(spans(blocks), &scenes).collect();
    all.into_iter()
}

fn problems<'a>(
    spans: impl IntoIterator<Item = &'a Span>,
    scenes: &Scenes,
) -> impl Iterator<Item = String> {
    spans.into_iter().filter_map(move |span| match span {
        Span::Number(number) => {
            let problem = number.value(scenes).err()?;
            Some(format!("`= {}`: {problem}", number.text()))
        }
        _ => None,
    })
}

/// What is wrong with a question in this state; the state is left as the right answer leaves it.
fn answered(ask: &Ask, session: &mut Session) -> impl Iterator<Item = String> {
    let scenes = Scenes::of(session);
    let mut faults: Vec<String> = problems(ask.spans(), &scenes).collect();
    let found = match &ask.kind {
        Kind::Choice(choices) => {
            for choice in choices {
                let mut shown = session.clone();
                let applied = choice.shows.as_ref().map(|patch| patch.apply(&mut shown));
                faults.extend(applied.and_then(Result::err));
            }
            right_choice(choices, &scenes).map(|_| ())
        }
        Kind::Number(number) => number_answered(number, session, &scenes),
        Kind::Reach(reach) => reached(reach, session, &scenes),
    };
    faults.extend(found.err());
    faults.into_iter()
}

fn number_answered(number: &Number, session: &Session, scenes: &Scenes) -> Result<(), String> {
    let value = number.value.value(scenes)?;
    let grade = |answer: f64| number.grade_text(&answer.to_string(), scenes);
    if grade(value)? != Verdict::Right {
        return Err(format!(
            "{value}, the number itself, is not taken for right"
        ));
    }
    let far = match number.tolerance {
        Tolerance::Absolute(allowed) => 2.0 * allowed,
        Tolerance::Relative(part) => 2.0 * part * value.abs(),
    };
    if grade(value + far)? != Verdict::Wrong || far == 0.0 {
        return Err(format!(
            "{} is taken for right; the number is {value}",
            value + far
        ));
    }
    if number.shows.is_some() && number.shown(value, session).is_none() {
        return Err(format!("shows: {value} cannot be put into the state"));
    }
    Ok(())
}

fn reached(reach: &Reach, session: &mut Session, scenes: &Scenes) -> Result<(), String> {
    let until = reach.until.text();
    if reach.until.holds(scenes)? {
        return Err(format!("'{until}' is so from the beginning"));
    }
    reach.solution.apply(session)?;
    if !reach.until.holds(&Scenes::of(session))? {
        return Err(format!("'{until}' is not so with the solution"));
    }
    Ok(())
}
