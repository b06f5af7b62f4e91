//! What is said at the controls of parameters.

use bxdf::error::Error;
use bxdf::param::{Kind, ParamSpec};

/// The name under which assistive tools know the control with this label; `ordinal`: the number of its lobe among several.
pub(super) fn accessible(label: &str, ordinal: Option<usize>) -> String {
    ordinal.map_or_else(
        || label.to_owned(),
        |ordinal| format!("{label} of lobe {ordinal}"),
    )
}

/// What a parameter means and may be.
pub(super) fn hint(spec: &ParamSpec) -> String {
    let [low, high] = spec.hard;
    let unit = if spec.unit.is_empty() {
        String::new()
    } else {
        format!(" {}", spec.unit)
    };
    match spec.kind {
        Kind::Number | Kind::Rgb => {
            format!("{}\n{}: {low} to {high}{unit}", spec.meaning, spec.name)
        }
        Kind::Choice | Kind::Bool | Kind::Data => format!("{}\n{}", spec.meaning, spec.name),
    }
}

/// A word of the command line, or the id of a substance, as the screen shows it.
pub(super) fn sentence(word: &str) -> String {
    if word == "ggx" {
        return word.to_uppercase();
    }
    let spaced = word.replace('_', " ");
    let mut letters = spaced.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// The reason of a refusal, in a line.
#[must_use]
pub fn reason(error: Error) -> String {
    match error {
        Error::Parse { problem, .. } => problem,
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_read_as_sentences() {
        assert_eq!(sentence("kulla_conty"), "Kulla conty");
        assert_eq!(sentence("ggx"), "GGX");
        assert_eq!(sentence(""), "");
    }
}
