//! What a number of the window may be: said once, for the control that edits it and for the reader of the file.

use std::fmt;

use bxdf::param::ParamSpec;

/// A number that is not accepted; as text, one sentence with its name, its value and what is allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// Its key in the file, with those of the tables around it.
    pub name: &'static str,
    /// What it is.
    pub value: f64,
    allowed: String,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}: {}", self.name, plain(self.value), self.allowed)
    }
}

/// A number that can be typed, dragged and stored.
#[derive(Clone, Copy, Debug)]
pub struct NumberSpec {
    /// Its key in the file, with those of the tables around it.
    pub name: &'static str,
    /// The smallest and the largest value accepted.
    pub range: [f64; 2],
    /// The smallest and the largest value of its slider.
    pub soft: [f64; 2],
    /// The unit, empty for a pure number.
    pub unit: &'static str,
    /// Whether it has no fraction.
    pub is_whole: bool,
    /// The value stored for one that is accepted: the same angle within one turn.
    fold: fn(f64) -> f64,
}

impl NumberSpec {
    /// A pure number within `range`, ends included.
    #[must_use]
    pub const fn new(name: &'static str, range: [f64; 2]) -> Self {
        Self {
            name,
            range,
            soft: range,
            unit: "",
            is_whole: false,
            fold: |x| x,
        }
    }

    /// A parameter of a model, or each of its channels.
    #[must_use]
    pub const fn of(spec: &ParamSpec) -> Self {
        Self {
            soft: spec.soft,
            unit: spec.unit,
            ..Self::new(spec.name, spec.hard)
        }
    }

    /// The number with this unit.
    #[must_use]
    pub const fn unit(mut self, unit: &'static str) -> Self {
        self.unit = unit;
        self
    }

    /// The number without fractions.
    #[must_use]
    pub const fn whole(mut self) -> Self {
        self.is_whole = true;
        self
    }

    /// The number whose slider has the range `soft`, and which is stored as `fold` has it.
    #[must_use]
    pub const fn folded(mut self, soft: [f64; 2], fold: fn(f64) -> f64) -> Self {
        self.soft = soft;
        self.fold = fold;
        self
    }

    /// The number with this range, for its slider too.
    #[must_use]
    pub const fn within(mut self, range: [f64; 2]) -> Self {
        self.range = range;
        self.soft = range;
        self
    }

    /// Whether `x` is accepted; what is no number never is.
    #[must_use]
    pub fn admits(&self, x: f64) -> bool {
        let [low, high] = self.range;
        (low..=high).contains(&x) && (!self.is_whole || x.fract() == 0.0)
    }

    /// What is accepted, as a phrase.
    #[must_use]
    pub fn allowed(&self) -> String {
        let [low, high] = self.range.map(plain);
        let kind = if self.is_whole {
            "a whole number from "
        } else {
            ""
        };
        let space = if self.unit.is_empty() { "" } else { " " };
        format!("allowed is {kind}{low} to {high}{space}{}", self.unit)
    }

    /// The value stored for `x` from a file.
    ///
    /// # Errors
    /// [`Refused`] where it is not accepted.
    pub fn checked(&self, x: f64) -> Result<f64, Refused> {
        if self.admits(x) {
            Ok((self.fold)(x))
        } else {
            Err(Refused {
                name: self.name,
                value: x,
                allowed: self.allowed(),
            })
        }
    }

    /// Stores what a gesture or a typed number asks for: the nearest value that is accepted. What is no number changes
    /// nothing.
    pub fn put(&self, value: &mut f64, x: f64) {
        if x.is_nan() {
            return;
        }
        let [low, high] = self.range;
        let within = x.clamp(low, high);
        let whole = if self.is_whole {
            within.round()
        } else {
            within
        };
        // Adding 0 turns a -0 into 0.
        *value = (self.fold)(whole) + 0.0;
    }
}

/// Numbers that gestures and files set, each with what it may be.
pub type Numbers<'a> = Vec<(&'static NumberSpec, &'a mut f64)>;

/// Checks numbers, and folds angles into their turn.
///
/// # Errors
/// The first that is refused.
pub(crate) fn checked(numbers: Numbers<'_>) -> Result<(), Refused> {
    for (spec, value) in numbers {
        *value = spec.checked(*value)?;
    }
    Ok(())
}

/// Whether each of the numbers may be as it is.
pub(crate) fn are_allowed(numbers: &Numbers<'_>) -> bool {
    numbers.iter().all(|(spec, value)| spec.admits(**value))
}

/// Takes each number that is not allowed from those `before`.
pub(crate) fn keep(numbers: Numbers<'_>, before: &Numbers<'_>) {
    for (spec, value) in numbers {
        let known = before.iter().find(|(other, _)| other.name == spec.name);
        if !spec.admits(*value) {
            let [low, _] = spec.range;
            *value = known.map_or(low, |(_, old)| **old);
        }
    }
}

/// A number with every digit that it takes to read it back, short where it is very large or very small.
#[must_use]
pub fn plain(x: f64) -> String {
    let is_short = x == 0.0 || !x.is_finite() || (1e-5..1e15).contains(&x.abs());
    if is_short {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TURN: NumberSpec = NumberSpec::new("turn", [-360.0, 360.0])
        .unit("degrees")
        .folded([-180.0, 180.0], |x| x.rem_euclid(360.0));

    #[test]
    fn what_is_out_of_range_is_named_with_what_is_allowed() {
        assert_eq!(TURN.checked(-90.0), Ok(270.0));
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, 360.1] {
            let line = TURN.checked(x).unwrap_err().to_string();
            assert!(
                line.starts_with("turn = ") && line.ends_with("allowed is -360 to 360 degrees"),
                "{line}"
            );
        }
        let seed = NumberSpec::new("seed", [0.0, 1e-12]).whole();
        assert_eq!(seed.allowed(), "allowed is a whole number from 0 to 1e-12");
        assert!(!seed.admits(5e-13));
    }

    #[test]
    fn gestures_never_store_what_is_refused() {
        let mut value = 10.0;
        TURN.put(&mut value, f64::NAN);
        assert_eq!(value, 10.0);
        for (x, stored) in [(f64::INFINITY, 0.0), (-1e9, 0.0), (-90.0, 270.0)] {
            TURN.put(&mut value, x);
            assert_eq!(value, stored, "{x}");
        }
    }

    #[test]
    fn numbers_print_as_they_are_read_back() {
        for (x, text) in [
            (0.000_1, "0.0001"),
            (1e-12, "1e-12"),
            (0.123_456_789, "0.123456789"),
            (1e10, "10000000000"),
            (1e308, "1e308"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(plain(x), text);
        }
    }
}
