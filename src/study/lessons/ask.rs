//! What a lesson asks, and what is right: always something that is computed from the state, never what was typed twice.

use serde::Deserialize;

use super::expression::{Condition, Expression};
use super::patch::Patch;
use super::scenes::Scenes;
use super::text::{self, Span};
use crate::session::Session;

/// A question.
#[derive(Clone, Debug, PartialEq)]
pub struct Ask {
    /// The question.
    pub question: Vec<Span>,
    /// What is asked for.
    pub kind: Kind,
    /// What helps before the answer, one by one.
    pub hints: Vec<Vec<Span>>,
    /// What of the window says the answer, and is not shown before.
    pub covers: Vec<Cover>,
}

/// What the window says of a material beside its views, and a question may ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Cover {
    /// `shares`: where its light goes, in the bar at the bottom.
    Shares,
    /// `laws`: which laws it keeps, under its name and in the list.
    Laws,
    /// `parameters`: of what kind it is, and its parameters with their controls.
    Parameters,
    /// `turning`: what turning its surface does, in the bar at the bottom.
    Turning,
}

impl Ask {
    /// Whether one of several answers is chosen.
    #[must_use]
    pub fn is_choice(&self) -> bool {
        matches!(self.kind, Kind::Choice(_))
    }

    /// All that there is to read in it.
    #[must_use]
    pub fn spans(&self) -> Vec<&Span> {
        let choices: &[Choice] = match &self.kind {
            Kind::Choice(choices) => choices,
            Kind::Number(_) | Kind::Reach(_) => &[],
        };
        let of_choices = choices.iter().flat_map(|choice| {
            let because = choice.because.iter().flatten();
            choice.text.iter().chain(because)
        });
        let hints = self.hints.iter().flatten();
        self.question
            .iter()
            .chain(hints)
            .chain(of_choices)
            .collect()
    }
}

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// One of several answers.
    Choice(Vec<Choice>),
    /// A number.
    Number(Number),
    /// A state that is to be reached.
    Reach(Reach),
}

/// An answer to be chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What it says.
    pub text: Vec<Span>,
    /// It is right where this is so.
    pub when: Condition,
    /// Why it is wrong, where it is.
    pub because: Option<Vec<Span>>,
    /// What would be seen if it were right.
    pub shows: Option<Patch>,
}

/// A number that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// What it is.
    pub value: Expression,
    /// Its unit; empty for a pure number.
    pub unit: String,
    /// How far from it an answer may be that is right.
    pub tolerance: Tolerance,
    /// The key of the state to which an answer is put, so that one sees what it would mean.
    pub shows: Option<String>,
}

/// How far an answer may be from the number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// By this much.
    Absolute(f64),
    /// By this part of it.
    Relative(f64),
}

/// A state that is to be reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// It is reached where this is so.
    pub until: Condition,
    /// A way to reach it.
    pub solution: Patch,
}

/// What an answer is.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Right.
    Right,
    /// Wrong.
    Wrong,
    /// Nothing that could be right or wrong, with what is expected.
    Unreadable(String),
}

impl From<bool> for Verdict {
    fn from(is_right: bool) -> Self {
        if is_right { Self::Right } else { Self::Wrong }
    }
}

/// The block of a question, as its file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Written {
    question: String,
    #[serde(default)]
    hints: Vec<String>,
    #[serde(default)]
    covers: Vec<Cover>,
    choices: Option<Vec<WrittenChoice>>,
    number: Option<String>,
    unit: Option<String>,
    tolerance: Option<toml::Value>,
    shows: Option<String>,
    until: Option<String>,
    solution: Option<Patch>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenChoice {
    text: String,
    when: String,
    because: Option<String>,
    shows: Option<Patch>,
}

impl Written {
    /// The question.
    ///
    /// # Errors
    /// A sentence.
    pub(super) fn read(self) -> Result<Ask, String> {
        let Self {
            question,
            hints,
            covers,
            choices,
            number,
            unit,
            tolerance,
            shows,
            until,
            solution,
        } = self;
        let is_number = number.is_some();
        let kind = match (choices, number, until) {
            (Some(choices), None, None) => Kind::Choice(read_choices(choices)?),
            (None, Some(value), None) => {
                let value = Expression::read(&value)?;
                let tolerance = tolerance.as_ref();
                let tolerance = tolerance.ok_or("a number needs a tolerance: 0.1 or \"5 %\"")?;
                Kind::Number(Number {
                    unit: unit.clone().unwrap_or_else(|| value.unit().to_owned()),
                    value,
                    tolerance: read_tolerance(tolerance)?,
                    shows: shows.clone(),
                })
            }
            (None, None, Some(until)) => Kind::Reach(Reach {
                until: Condition::read(&until)?,
                solution: solution
                    .clone()
                    .ok_or("a state to be reached needs a solution: a table")?,
            }),
            _ => {
                return Err("a question needs one of: choices, number, until".to_owned());
            }
        };
        let is_reach = matches!(kind, Kind::Reach(_));
        for (key, is_given, is_used) in [
            ("tolerance", tolerance.is_some(), is_number),
            ("unit", unit.is_some(), is_number),
            ("shows", shows.is_some(), is_number),
            ("solution", solution.is_some(), is_reach),
        ] {
            if is_given && !is_used {
                return Err(format!("{key} has no place in this question"));
            }
        }
        let hints: Result<_, String> = hints.iter().map(|hint| text::line(hint)).collect();
        Ok(Ask {
            question: text::line(&question)?,
            kind,
            hints: hints?,
            covers,
        })
    }
}

fn read_choices(written: Vec<WrittenChoice>) -> Result<Vec<Choice>, String> {
    if written.len() < 2 {
        return Err("a choice needs at least two answers".to_owned());
    }
    let choices = written.into_iter().map(|choice| {
        let because = choice.because.as_deref().map(text::line).transpose()?;
        Ok(Choice {
            text: text::line(&choice.text)?,
            when: Condition::read(&choice.when)?,
            because,
            shows: choice.shows,
        })
    });
    choices.collect()
}

fn read_tolerance(value: &toml::Value) -> Result<Tolerance, String> {
    let percent = |text: &str| text.trim().strip_suffix('%')?.trim().parse::<f64>().ok();
    let tolerance = match value {
        toml::Value::Float(x) => Some(Tolerance::Absolute(*x)),
        toml::Value::Integer(x) => Some(Tolerance::Absolute(*x as f64)),
        toml::Value::String(text) => percent(text).map(|part| Tolerance::Relative(part / 100.0)),
        _ => None,
    };
    let is_some = |tolerance: &Tolerance| match tolerance {
        Tolerance::Absolute(x) => x.is_finite() && *x > 0.0,
        Tolerance::Relative(x) => *x > 0.0 && *x < 1.0,
    };
    let tolerance = tolerance.filter(is_some);
    tolerance.ok_or_else(|| {
        format!("tolerance = {value}: allowed is a number above 0, or a percentage as \"5 %\"")
    })
}

impl Number {
    /// Whether an answer is near enough to the number.
    ///
    /// # Errors
    /// A phrase, where there is no such number.
    pub fn grade(&self, answer: f64, scenes: &Scenes) -> Result<bool, String> {
        let value = self.value.value(scenes)?;
        let allowed = match self.tolerance {
            Tolerance::Absolute(allowed) => allowed,
            Tolerance::Relative(part) => part * value.abs(),
        };
        // A tolerance typed in decimals admits what is exactly so far.
        Ok((answer - value).abs() <= allowed * (1.0 + 1e-12))
    }

    /// What a typed answer is worth.
    ///
    /// # Errors
    /// As [`Self::grade`].
    pub fn grade_text(&self, answer: &str, scenes: &Scenes) -> Result<Verdict, String> {
        if let Some(number) = typed_number(answer) {
            return self.grade(number, scenes).map(Verdict::from);
        }
        let unit = match self.unit.as_str() {
            "" => String::new(),
            unit => format!(" in {unit}"),
        };
        Ok(Verdict::Unreadable(format!(
            "'{}' is no number: type one{unit}, as 0.25 or 2.5e-1",
            bxdf::error::shown(answer)
        )))
    }

    /// The state with an answer in it, where that can be shown.
    #[must_use]
    pub fn shown(&self, answer: f64, session: &Session) -> Option<Session> {
        let patch = Patch::of_number(self.shows.as_ref()?, answer).ok()?;
        let mut session = session.clone();
        patch.apply(&mut session).ok()?;
        Some(session)
    }
}

/// The number that a person typed, with a decimal point or a comma, or in per cent.
#[must_use]
pub fn typed_number(text: &str) -> Option<f64> {
    let text = text.trim().replace(',', ".");
    let (digits, factor) = match text.strip_suffix('%') {
        Some(digits) => (digits.trim(), 0.01),
        None => (text.as_str(), 1.0),
    };
    let number: f64 = digits.parse().ok()?;
    number.is_finite().then_some(number * factor)
}

/// The place of the choice that is right.
///
/// # Errors
/// A sentence, where none is right or more than one, and where one of the conditions has no value.
pub fn right_choice(choices: &[Choice], scenes: &Scenes) -> Result<usize, String> {
    let mut right = Vec::new();
    for (index, choice) in choices.iter().enumerate() {
        if choice.when.holds(scenes)? {
            right.push(index);
        }
    }
    match right[..] {
        [one] => Ok(one),
        [] => Err("none of the choices is right in this state".to_owned()),
        [one, two, ..] => Err(format!(
            "choices {} and {} are both right in this state",
            one + 1,
            two + 1
        )),
    }
}
