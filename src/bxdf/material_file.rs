//! Materials as TOML text: a name, notes, and lobes with their parameters.
//!
//! ```toml
//! name = "Brushed gold"
//! note = "Chosen by eye"
//!
//! [[lobes]]
//! model = "rough_conductor"
//! alpha_x = 0.05
//! alpha_y = 0.3
//! eta = [0.143, 0.375, 1.442]
//! ```

use toml::{Table, Value};

use super::Material;
use crate::error::{Error, Result};

/// Keys of a file that describe the material and do not change it.
const DESCRIPTIONS: [&str; 3] = ["name", "note", "source"];

/// Reads a material from TOML `text`; `place` (the file) is named in errors, with the line.
///
/// # Errors
/// [`Error::Parse`] for a syntax error, an unknown key, model or parameter, a value out of range, and, since a material
/// has one lobe as yet, for a file with none or several.
pub fn parse(text: &str, place: &str) -> Result<Material> {
    let at = |key: &str, problem: String| {
        Error::parse(format!("{place}: line {}", line_of(text, key)), problem)
    };
    let table: Table = text.parse().map_err(|error: toml::de::Error| {
        let before = error
            .span()
            .and_then(|span| text.get(..span.start))
            .unwrap_or_default();
        let line = before.matches('\n').count() + 1;
        Error::parse(
            format!("{place}: line {line}"),
            error.message().replace('\n', " "),
        )
    })?;
    if let Some(key) = table
        .keys()
        .find(|key| !DESCRIPTIONS.contains(&key.as_str()) && *key != "lobes")
    {
        return Err(at(
            key,
            format!("unknown key '{key}'; known are name, note, source and lobes"),
        ));
    }
    let lobes = table
        .get("lobes")
        .and_then(Value::as_array)
        .map(Vec::as_slice)
        .unwrap_or_default();
    let [Value::Table(lobe)] = lobes else {
        let problem = format!(
            "{} lobes; a material has one [[lobes]] table as yet",
            lobes.len()
        );
        return Err(at("[[lobes]]", problem));
    };
    let model = lobe
        .get("model")
        .and_then(Value::as_str)
        .unwrap_or_default();
    let mut assignments = Vec::new();
    for (name, value) in lobe.iter().filter(|(name, _)| *name != "model") {
        let word = word_of(value).ok_or_else(|| {
            at(
                name,
                format!("{name} is no number, colour, word or truth value"),
            )
        })?;
        let assignment = format!("{name}={word}");
        // Each alone first, so that the error names its line.
        format!("{model}:{assignment}")
            .parse::<Material>()
            .map_err(|error| match error {
                Error::UnknownId { what: "model", .. } => at("model", error.to_string()),
                _ => at(name, error.to_string()),
            })?;
        assignments.push(assignment);
    }
    format!("{model}:{}", assignments.join(","))
        .parse()
        .map_err(|error: Error| at("model", error.to_string()))
}

/// A value as the command line has it: a number, `r/g/b`, a word.
fn word_of(value: &Value) -> Option<String> {
    match value {
        Value::String(word) => Some(word.clone()),
        Value::Integer(number) => Some(number.to_string()),
        Value::Float(number) => Some(number.to_string()),
        Value::Boolean(flag) => Some(flag.to_string()),
        Value::Array(channels) => {
            let words: Option<Vec<String>> = channels.iter().map(word_of).collect();
            Some(words?.join("/"))
        }
        Value::Datetime(_) | Value::Table(_) => None,
    }
}

/// The number of the first line that begins with `key`; 1 where there is none.
fn line_of(text: &str, key: &str) -> usize {
    text.lines()
        .position(|line| line.trim_start().starts_with(key))
        .map_or(1, |index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_a_material() {
        let text = "name = \"Gold\"\n[[lobes]]\nmodel = \"rough_conductor\"\nalpha = 0.05\neta = [0.2, 0.4, 1]\n";
        let material = parse(text, "gold.toml").unwrap();
        assert_eq!(
            material.to_string(),
            "rough_conductor:eta=0.2/0.4/1,alpha_x=0.05,alpha_y=0.05"
        );
        assert_eq!(
            parse("[[lobes]]\nmodel = \"oren_nayar\"", "m")
                .unwrap()
                .to_string(),
            "oren_nayar"
        );
    }

    #[test]
    fn mistakes_name_file_and_line() {
        for (text, expected) in [
            ("name = \"x\"\nnote \"y\"", "m.toml: line 2: "),
            (
                "[[lobes]]\nmodel = \"gold\"\nalpha = 1",
                "m.toml: line 2: unknown model 'gold'",
            ),
            (
                "[[lobes]]\nmodel = \"oren_nayar\"\nsigma = 91",
                "m.toml: line 3: oren_nayar: sigma = 91: allowed is",
            ),
            (
                "[[lobes]]\nmodel = \"oren_nayar\"\nsgma = 9",
                "m.toml: line 3: unknown parameter 'sgma'; nearest: sigma",
            ),
            ("colour = 1\n", "m.toml: line 1: unknown key 'colour'"),
            ("name = \"none\"", "0 lobes"),
            (
                "[[lobes]]\nmodel = \"oren_nayar\"\n[[lobes]]\nmodel = \"oren_nayar\"",
                "line 1: 2 lobes",
            ),
        ] {
            let line = parse(text, "m.toml").unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }
}
