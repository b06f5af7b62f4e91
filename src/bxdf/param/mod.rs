//! Parameters: what a model takes, in which range, and the validated values.
//!
//! Everything that shows or reads a parameter (sliders, command line, documentation, tests) follows from its
//! [`ParamSpec`]. Validation happens here, where values enter; models may rely on it.

use std::fmt;

use crate::resource::{Decoder, decoders_in_words};

mod data;
mod set;

pub use set::ParamSet;

/// The kind of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One number.
    Number,
    /// Three linear channels.
    Rgb,
    /// One of a list of words.
    Choice,
    /// True or false.
    Bool,
    /// Data from a file, or baked.
    Data,
}

impl Kind {
    /// The word for it in `models --json`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Rgb => "rgb",
            Self::Choice => "choice",
            Self::Bool => "bool",
            Self::Data => "data",
        }
    }
}

/// The scale of a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios.
    Logarithmic,
}

impl Scale {
    /// The word for it in `models --json`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Logarithmic => "logarithmic",
        }
    }
}

/// What a parameter means, whatever its name: by this the labs find extremes, the window links what belongs together, and
/// maps find their axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Something of the model's own.
    Plain,
    /// The width of a lobe along s; a model that has it has one along t too.
    WidthS,
    /// The width of the same lobe along t.
    WidthT,
    /// The width of a lobe, the same all around.
    Width,
    /// The index of refraction below the surface over the one above, or its real part.
    Index,
    /// Its imaginary part.
    Absorption,
    /// A share of light, per channel.
    Colour,
    /// The choice of what a facet reflects.
    Fresnel,
    /// The choice of how microfacet normals are spread.
    Distribution,
}

impl Role {
    /// Whether it is the width of a lobe.
    #[must_use]
    pub const fn is_width(self) -> bool {
        matches!(self, Self::WidthS | Self::WidthT | Self::Width)
    }
}

/// The value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// One number, in the unit of its spec.
    Number(f64),
    /// Linear R, G, B.
    Rgb([f64; 3]),
    /// One of the words of its spec.
    Choice(&'static str),
    /// True or false.
    Bool(bool),
    /// Whether there is data; what it is, [`ParamSet::resource`] says.
    Data(bool),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(x) => write!(f, "{x}"),
            Self::Rgb([r, g, b]) if r == g && g == b => write!(f, "{r}"),
            Self::Rgb([r, g, b]) => write!(f, "{r}/{g}/{b}"),
            Self::Choice(word) => f.write_str(word),
            Self::Bool(b) | Self::Data(b) => write!(f, "{b}"),
        }
    }
}

/// A condition on a choice parameter of the same model: its name, and the words for which the condition holds.
pub type Condition = (&'static str, &'static [&'static str]);

/// What a parameter is, means and allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParamSpec {
    /// The name, in snake case; a contract of the command line and of files.
    pub name: &'static str,
    /// The kind of value.
    pub kind: Kind,
    /// What it means.
    pub role: Role,
    /// The value at first.
    pub default: Value,
    /// Smallest and largest value accepted (numbers and channels).
    pub hard: [f64; 2],
    /// Smallest and largest value of the slider (numbers and channels).
    pub soft: [f64; 2],
    /// The unit, empty for a pure number.
    pub unit: &'static str,
    /// The scale of the slider.
    pub scale: Scale,
    /// The words allowed (choices).
    pub choices: &'static [&'static str],
    /// What it means, for tooltips and documentation.
    pub meaning: &'static str,
    /// What reads its data (data).
    pub decoders: &'static [&'static Decoder],
    /// Where the parameter has an effect only for some value of a choice.
    pub relevant_when: Option<Condition>,
}

impl ParamSpec {
    const fn new(name: &'static str, kind: Kind, default: Value, meaning: &'static str) -> Self {
        Self {
            name,
            kind,
            role: Role::Plain,
            default,
            hard: [0.0, 1.0],
            soft: [0.0, 1.0],
            unit: "",
            scale: Scale::Linear,
            choices: &[],
            decoders: &[],
            meaning,
            relevant_when: None,
        }
    }

    /// A number, 0..1 unless [`Self::hard`] says otherwise.
    ///
    /// ```
    /// use bxdf::{ParamSpec, Value};
    ///
    /// const ETA: ParamSpec = ParamSpec::number("eta", 1.5, "Index of refraction").hard(1.0, 3.0);
    /// assert!(ETA.allows(Value::Number(2.42)) && !ETA.allows(Value::Number(0.9)));
    /// ```
    #[must_use]
    pub const fn number(name: &'static str, default: f64, meaning: &'static str) -> Self {
        Self::new(name, Kind::Number, Value::Number(default), meaning)
    }

    /// Three linear channels, each 0..1 unless [`Self::hard`] says otherwise.
    #[must_use]
    pub const fn rgb(name: &'static str, default: [f64; 3], meaning: &'static str) -> Self {
        Self::new(name, Kind::Rgb, Value::Rgb(default), meaning).role(Role::Colour)
    }

    /// One word of `choices`, the first by default.
    #[must_use]
    pub const fn choice(
        name: &'static str,
        choices: &'static [&'static str],
        meaning: &'static str,
    ) -> Self {
        let default = match choices.first() {
            Some(word) => word,
            None => "",
        };
        let mut spec = Self::new(name, Kind::Choice, Value::Choice(default), meaning);
        spec.choices = choices;
        spec
    }

    /// True or false.
    #[must_use]
    pub const fn flag(name: &'static str, default: bool, meaning: &'static str) -> Self {
        Self::new(name, Kind::Bool, Value::Bool(default), meaning)
    }

    /// Data that one of `decoders` reads; none at first.
    #[must_use]
    pub const fn data(
        name: &'static str,
        decoders: &'static [&'static Decoder],
        meaning: &'static str,
    ) -> Self {
        let mut spec = Self::new(name, Kind::Data, Value::Data(false), meaning);
        spec.decoders = decoders;
        spec
    }

    /// The spec with this hard range, and the same soft one.
    #[must_use]
    pub const fn hard(mut self, min: f64, max: f64) -> Self {
        self.hard = [min, max];
        self.soft = [min, max];
        self
    }

    /// The spec with this soft range (the slider's).
    #[must_use]
    pub const fn soft(mut self, min: f64, max: f64) -> Self {
        self.soft = [min, max];
        self
    }

    /// The spec with this slider scale.
    #[must_use]
    pub const fn scale(mut self, scale: Scale) -> Self {
        self.scale = scale;
        self
    }

    /// The spec with this unit.
    #[must_use]
    pub const fn unit(mut self, unit: &'static str) -> Self {
        self.unit = unit;
        self
    }

    /// The spec, of effect only where the choice parameter `name` is one of `words`.
    #[must_use]
    pub const fn relevant_when(
        mut self,
        name: &'static str,
        words: &'static [&'static str],
    ) -> Self {
        self.relevant_when = Some((name, words));
        self
    }

    /// The spec of a parameter that means this.
    #[must_use]
    pub const fn role(mut self, role: Role) -> Self {
        self.role = role;
        self
    }

    /// Whether the parameter is an index of refraction, or the real part of one.
    #[must_use]
    pub fn is_index(&self) -> bool {
        self.role == Role::Index
    }

    /// Whether the parameter is a share of light per channel.
    #[must_use]
    pub fn is_colour(&self) -> bool {
        self.role == Role::Colour
    }

    /// The name as the screen shows it: `alpha_x` is "Alpha x".
    #[must_use]
    pub fn label(&self) -> String {
        let spaced = self.name.replace('_', " ");
        let mut letters = spaced.chars();
        letters.next().map_or_else(String::new, |first| {
            first.to_uppercase().chain(letters).collect()
        })
    }

    /// What is allowed, as a phrase for an error line.
    #[must_use]
    pub fn allowed(&self) -> String {
        let [min, max] = self.hard;
        let unit = if self.unit.is_empty() {
            String::new()
        } else {
            format!(" {}", self.unit)
        };
        match self.kind {
            Kind::Number => format!("allowed is a number from {min} to {max}{unit}"),
            Kind::Rgb => {
                format!("allowed is one number or three as r/g/b, each from {min} to {max}{unit}")
            }
            Kind::Choice => format!("allowed is one of {}", self.choices.join(", ")),
            Kind::Bool => "allowed is true or false".to_owned(),
            Kind::Data => format!("allowed is {}", decoders_in_words(self.decoders)),
        }
    }

    /// The value that `text` stands for, before its range is checked. `None` where it stands for none.
    fn parse(&self, text: &str) -> Option<Value> {
        match self.kind {
            Kind::Number => text.parse().ok().map(Value::Number),
            Kind::Rgb => {
                let channels: Vec<f64> = text
                    .split('/')
                    .map(|part| part.parse().ok())
                    .collect::<Option<_>>()?;
                match channels[..] {
                    [grey] => Some(Value::Rgb([grey; 3])),
                    [r, g, b] => Some(Value::Rgb([r, g, b])),
                    _ => None,
                }
            }
            Kind::Choice => self
                .choices
                .iter()
                .find(|word| **word == text)
                .map(|word| Value::Choice(word)),
            Kind::Bool => text.parse().ok().map(Value::Bool),
            // Read by its decoders, see `ParamSet::set_text`.
            Kind::Data => None,
        }
    }

    /// Whether `value` has the kind and lies in the hard range of this spec.
    #[must_use]
    pub fn allows(&self, value: Value) -> bool {
        let in_range = |x: &f64| (self.hard[0]..=self.hard[1]).contains(x);
        match (self.kind, value) {
            (Kind::Number, Value::Number(x)) => in_range(&x),
            (Kind::Rgb, Value::Rgb(rgb)) => rgb.iter().all(in_range),
            (Kind::Choice, Value::Choice(word)) => self.choices.contains(&word),
            (Kind::Bool, Value::Bool(_)) => true,
            // It comes with what it is; taken away it may be by itself.
            (Kind::Data, Value::Data(is_there)) => !is_there,
            _ => false,
        }
    }
}
