//! The terms of a formula: what stands in it, with its number.

use bxdf::Spectrum;
use bxdf::param::{ParamSet, Value as Parameter};

/// What a term is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Worth {
    /// One number.
    Number(f64),
    /// Linear R, G, B.
    Rgb([f64; 3]),
}

impl Worth {
    /// Its channels; of one number, the same in each.
    #[must_use]
    pub fn channels(self) -> [f64; 3] {
        match self {
            Self::Number(number) => [number; 3],
            Self::Rgb(rgb) => rgb,
        }
    }
}

impl From<f64> for Worth {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Spectrum<f64>> for Worth {
    fn from(Spectrum(rgb): Spectrum<f64>) -> Self {
        Self::Rgb(rgb)
    }
}

/// What stands in a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Its symbol, in TeX.
    pub symbol: &'static str,
    /// What it is computed by, in TeX; empty where it is given.
    pub formula: &'static str,
    /// What it is, without a full stop.
    pub meaning: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its number.
    pub worth: Worth,
}

/// The symbols of f, and of the weight of a delta.
pub(super) const VALUE: &str = r"\lobe{f}";
pub(super) const WEIGHT: &str = r"\lobe{w}";

impl Term {
    /// Whether it is a parameter of the model.
    #[must_use]
    pub fn is_parameter(&self) -> bool {
        self.formula.is_empty() && self.symbol.starts_with("\\param{")
    }

    /// Whether it is f.
    #[must_use]
    pub fn is_f(&self) -> bool {
        self.symbol == VALUE
    }

    /// Whether it is what the formula is of: f, or the weight of a delta.
    #[must_use]
    pub fn is_last(&self) -> bool {
        self.is_f() || self.symbol == WEIGHT
    }
}

/// The name of a term: symbol, formula and meaning.
pub(super) type Name = [&'static str; 3];

/// The terms of a formula, in the order in which they are computed.
pub(super) struct Terms<'a> {
    params: &'a ParamSet,
    /// Those so far.
    pub(super) list: Vec<Term>,
}

impl<'a> Terms<'a> {
    pub(super) fn of(params: &'a ParamSet) -> Self {
        Self {
            params,
            list: Vec::new(),
        }
    }

    fn push(&mut self, [symbol, formula, meaning]: Name, unit: &'static str, worth: Worth) {
        self.list.push(Term {
            symbol,
            formula,
            meaning,
            unit,
            worth,
        });
    }

    /// A pure number.
    pub(super) fn number(&mut self, name: Name, number: f64) -> f64 {
        self.push(name, "", number.into());
        number
    }

    /// A number in 1/sr.
    pub(super) fn density(&mut self, name: Name, number: f64) -> f64 {
        self.push(name, "1/sr", number.into());
        number
    }

    /// Three pure numbers.
    pub(super) fn rgb(&mut self, name: Name, rgb: Spectrum<f64>) -> Spectrum<f64> {
        self.push(name, "", rgb.into());
        rgb
    }

    /// Three numbers in 1/sr.
    pub(super) fn value(&mut self, name: Name, rgb: Spectrum<f64>) -> Spectrum<f64> {
        self.push(name, "1/sr", rgb.into());
        rgb
    }

    /// The numeric parameter `name`, whose symbol is `symbol`.
    pub(super) fn parameter(&mut self, name: &str, symbol: &'static str) -> f64 {
        let number = self.params.number(name);
        self.given(name, symbol, number.into());
        number
    }

    /// The parameter `name` of three channels.
    pub(super) fn colour(&mut self, name: &str, symbol: &'static str) -> Spectrum<f64> {
        let rgb = Spectrum(self.params.rgb(name));
        self.given(name, symbol, rgb.into());
        rgb
    }

    fn given(&mut self, name: &str, symbol: &'static str, worth: Worth) {
        let spec = self.params.iter().find(|(spec, _)| spec.name == name);
        debug_assert!(spec.is_some_and(|(_, value)| !matches!(value, Parameter::Choice(_))));
        let (meaning, unit) = spec.map_or(("", ""), |(spec, _)| (spec.meaning, spec.unit));
        self.push([symbol, "", meaning], unit, worth);
    }
}
