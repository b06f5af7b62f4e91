//! Arithmetic over quantities, as lessons write it: `rho_dh at light 80 < 1 - share(diffuse)`. How it is written, `parse.rs`
//! says.

use super::node::{Comparison, Node, Value};
use super::parse;
use super::scenes::Scenes;
use super::tokens::Tokens;

/// A number to be computed, with the text it was read from.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    text: String,
    node: Node,
}

/// What is true of a state or not, with the text it was read from.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    text: String,
    all: Vec<Comparison>,
}

impl Expression {
    /// Reads an expression.
    ///
    /// # Errors
    /// A sentence that says what is wrong at which word, and what is allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut tokens = Tokens::of(text)?;
        let node = parse::sum(&mut tokens, 0)?;
        tokens.end()?;
        Ok(Self {
            text: text.trim().to_owned(),
            node,
        })
    }

    /// The text it was read from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The unit, where it is one quantity; else empty.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match &self.node {
            Node::Of(call) => call.quantity.unit,
            _ => "",
        }
    }

    /// The symbol, where it is one quantity where the state is; else empty.
    #[must_use]
    pub fn symbol(&self) -> &'static str {
        match &self.node {
            Node::Of(call) if call.settings.is_empty() => call.quantity.symbol,
            _ => "",
        }
    }

    /// What it is worth.
    ///
    /// # Errors
    /// A phrase that says why there is no such number.
    pub fn value(&self, scenes: &Scenes) -> Value<f64> {
        self.node.value(scenes)
    }
}

impl Condition {
    /// Reads a condition.
    ///
    /// # Errors
    /// As [`Expression::read`].
    pub fn read(text: &str) -> Result<Self, String> {
        let mut tokens = Tokens::of(text)?;
        let mut all = vec![parse::comparison(&mut tokens)?];
        while tokens.takes_word("and") {
            all.push(parse::comparison(&mut tokens)?);
        }
        tokens.end()?;
        Ok(Self {
            text: text.trim().to_owned(),
            all,
        })
    }

    /// The text it was read from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether it is so.
    ///
    /// # Errors
    /// A phrase, where there is no number to compare.
    pub fn holds(&self, scenes: &Scenes) -> Value<bool> {
        for comparison in &self.all {
            if !comparison.holds(scenes)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Session;

    fn value(text: &str) -> f64 {
        let scenes = Scenes::of(&Session::default());
        let read = Expression::read(text).unwrap();
        read.value(&scenes).unwrap()
    }

    #[test]
    fn arithmetic_is_the_usual_one() {
        for (text, expected) in [
            ("1 + 2 * 3 - 4 / 2", 5.0),
            ("-2 ^ 2", -4.0),
            ("2 ^ -1", 0.5),
            ("2 ^ 3 ^ 2", 512.0),
            ("(1 - .5) * 4", 2.0),
            ("sqrt(2) ^ 2", 2.0),
            ("abs(1 - 3)", 2.0),
            ("cos(60) + sin(30) + tan(45)", 2.0),
            ("1e-3 * 1e3", 1.0),
            ("pi / pi", 1.0),
            ("integral(cos) / integral(1)", 0.5),
            ("angle(light)", 50.0),
            ("angle(light) at light 80", 80.0),
            ("angle(light) at light 80 azimuth 30", 80.0),
            (
                "angle(light_azimuth) at light 80 azimuth 30, viewer 20",
                30.0,
            ),
            ("angle(viewer_azimuth) at viewer 20 azimuth -90", -90.0),
            ("parameter(alpha_x) at alpha .7", 0.7),
            ("alpha_of_roughness(disney, .5) * 4", 1.0),
        ] {
            let difference = value(text) - expected;
            assert!(difference.abs() < 1e-9, "{text}: {}", value(text));
        }
        assert_eq!(Expression::read("f").unwrap().unit(), "1/sr");
        assert_eq!(Expression::read("f / 2").unwrap().unit(), "");
    }

    #[test]
    fn conditions_compare() {
        let scenes = Scenes::of(&Session::default());
        for (text, expected) in [
            ("angle(light) > 40 and angle(light) <= 50", true),
            ("angle(light) ~ 50.2", true),
            ("angle(light) ~ 52", false),
            ("1 < 1", false),
            ("angle(light) < 50", false),
            ("angle(light) > 50", false),
            ("1 >= 1 and 2 < 1", false),
        ] {
            let condition = Condition::read(text).unwrap();
            assert_eq!(condition.holds(&scenes), Ok(expected), "{text}");
        }
    }

    #[test]
    fn broken_texts_say_where() {
        for (text, expected) in [
            ("", "it ends where a number or a quantity is expected"),
            ("1 +", "it ends where a number or a quantity is expected"),
            ("1 2", "'2' where the end is expected"),
            ("(1", "it ends where ')' is expected"),
            ("rho_hx", "unknown quantity 'rho_hx'"),
            ("angle(moon)", "angle: the of 'moon': allowed is light, "),
            ("angle", "angle: it is written 'angle("),
            ("f at", "it ends where light, viewer, material or the name"),
            ("f at light", "it ends where its value is expected"),
            ("1 $ 2", "'$' is no sign of an expression"),
            ("f at material \"gold", "a quotation mark is not closed"),
            (&"(".repeat(99), "nested more than 32 deep"),
            (&"-".repeat(99), "nested more than 32 deep"),
        ] {
            let line = Expression::read(text).unwrap_err();
            assert!(line.contains(expected), "{text}: {line}");
        }
        let line = Condition::read("1 + 1").unwrap_err();
        assert!(line.contains("a comparison: <"), "{line}");
        let scenes = Scenes::of(&Session::default());
        for (text, expected) in [
            ("f at flavour 3", "unknown parameter 'flavour'"),
            ("f at alpha 7", "alpha"),
            ("f at light steep", "light 'steep': expected an angle"),
            (
                "f at light 20 azimuth 400",
                "light azimuth '400': expected an angle from -360 to 360 degrees",
            ),
            ("f at material 3", "there is no material 3"),
            ("f at material brass", "there is no material 'brass'"),
            ("1 / 0", "undefined"),
        ] {
            let line = Expression::read(text).unwrap().value(&scenes).unwrap_err();
            assert!(line.contains(expected), "{text}: {line}");
        }
    }
}
