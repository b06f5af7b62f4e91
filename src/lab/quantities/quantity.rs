//! What a quantity is: its name, unit and meaning, what it takes, and how it is computed.

use std::fmt;

use super::scene::Scene;
use bxdf::error::shown;

/// A number about a scene.
pub struct Quantity {
    /// The word for it in texts.
    pub id: &'static str,
    /// Its symbol at the screen.
    pub symbol: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// What it is, in a sentence without a full stop.
    pub meaning: &'static str,
    /// What stands in parentheses behind the word, in this order.
    pub arguments: &'static [Argument],
    /// Computes it.
    pub(super) value: fn(&Scene, &[Given]) -> Value,
}

/// What a quantity is worth in a scene, or a phrase why there is no such number.
pub type Value = std::result::Result<f64, String>;

/// What a quantity takes besides the scene.
pub struct Argument {
    /// What it says.
    pub name: &'static str,
    /// What it may be.
    pub takes: Takes,
    /// Whether it may be left out.
    pub is_optional: bool,
}

/// What an argument may be.
#[derive(Clone, Copy)]
pub enum Takes {
    /// One of these words.
    Word(&'static [&'static str]),
    /// A number between these, ends included.
    Number([f64; 2]),
    /// A name that the scene may know.
    Name,
}

impl Argument {
    pub(super) const fn word(name: &'static str, words: &'static [&'static str]) -> Self {
        Self {
            name,
            takes: Takes::Word(words),
            is_optional: false,
        }
    }

    pub(super) const fn number(name: &'static str, range: [f64; 2]) -> Self {
        Self {
            name,
            takes: Takes::Number(range),
            is_optional: false,
        }
    }

    pub(super) const fn name(name: &'static str) -> Self {
        Self {
            name,
            takes: Takes::Name,
            is_optional: false,
        }
    }

    pub(super) const fn optional(mut self) -> Self {
        self.is_optional = true;
        self
    }
}

/// An argument as it is given.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// A word or a name.
    Word(String),
    /// A number.
    Number(f64),
}

impl Given {
    /// The word, or the number as it is typed.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Word(word) => word.clone(),
            Self::Number(number) => number.to_string(),
        }
    }
}

impl fmt::Display for Given {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => f.write_str(&shown(word)),
            Self::Number(number) => number.fmt(f),
        }
    }
}

impl Quantity {
    /// Checks what is given as arguments.
    ///
    /// # Errors
    /// A sentence that names the first argument that is wrong, and what is allowed.
    pub fn check(&self, given: &[Given]) -> std::result::Result<(), String> {
        let required = self
            .arguments
            .iter()
            .filter(|argument| !argument.is_optional)
            .count();
        if given.len() < required || given.len() > self.arguments.len() {
            return Err(format!("it is written {}", self.form()));
        }
        self.arguments
            .iter()
            .zip(given)
            .try_for_each(|(argument, given)| argument.check(given))
    }

    /// What it is worth in `scene`, with arguments that [`Self::check`] has passed.
    ///
    /// # Errors
    /// A phrase that says why there is no such number.
    pub fn value(&self, scene: &Scene, given: &[Given]) -> Value {
        self.check(given)?;
        let value = (self.value)(scene, given)?;
        if value.is_nan() {
            return Err(format!("{} is undefined here", self.symbol));
        }
        Ok(value)
    }

    /// How it is written: `share(category, [side])`.
    #[must_use]
    pub fn form(&self) -> String {
        if self.arguments.is_empty() {
            return format!("'{}'", self.id);
        }
        let arguments = self.arguments.iter().map(|argument| {
            let takes = match argument.takes {
                Takes::Word(words) => words.join("|"),
                Takes::Number([low, high]) => format!("{}: {low} to {high}", argument.name),
                Takes::Name => argument.name.to_owned(),
            };
            if argument.is_optional {
                format!("[{takes}]")
            } else {
                takes
            }
        });
        let arguments: Vec<String> = arguments.collect();
        format!("'{}({})'", self.id, arguments.join(", "))
    }
}

impl Argument {
    fn check(&self, given: &Given) -> std::result::Result<(), String> {
        let name = self.name;
        match (self.takes, given) {
            (Takes::Word(words), Given::Word(word)) if words.contains(&word.as_str()) => Ok(()),
            // A 1 is the name of an integrand, too.
            (Takes::Word(words), Given::Number(x)) if words.contains(&x.to_string().as_str()) => {
                Ok(())
            }
            (Takes::Word(words), given) => Err(format!(
                "the {name} '{given}': allowed is {}",
                words.join(", ")
            )),
            (Takes::Number([low, high]), Given::Number(x)) if (low..=high).contains(x) => Ok(()),
            (Takes::Number([low, high]), given) => Err(format!(
                "the {name} '{given}': allowed is a number from {low} to {high}"
            )),
            (Takes::Name, Given::Word(_)) => Ok(()),
            (Takes::Name, given) => Err(format!("the {name} '{given}': expected a name")),
        }
    }
}

/// The word given at `index`, or the empty one.
pub(super) fn word(given: &[Given], index: usize) -> String {
    given.get(index).map(Given::text).unwrap_or_default()
}

/// The number given at `index`.
pub(super) fn number(given: &[Given], index: usize) -> Option<f64> {
    match given.get(index) {
        Some(Given::Number(number)) => Some(*number),
        _ => None,
    }
}
