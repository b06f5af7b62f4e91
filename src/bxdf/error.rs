//! The one error type, by who is at fault.
//!
//! Much of a message is not ours: names and values from files, arguments, paths, the words of libraries. All of it is
//! shown through [`printable`], so that no text moves a terminal's cursor, turns the line around, or fills the screen.

use std::path::PathBuf;

/// What can go wrong; each prints as one clear line.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A parameter value that the model does not allow.
    #[error("{}: {} = {}: {}", shown(.model), shown(.name), shown(.value), line(.allowed))]
    Parameter {
        /// The id of the model.
        model: String,
        /// The name of the parameter.
        name: String,
        /// The value as it was given.
        value: String,
        /// What is allowed, as a phrase.
        allowed: String,
    },
    /// A name that stands in no list.
    #[error("unknown {what} '{}'; {}", shown(.id), line(&nearest_phrase(.nearest)))]
    UnknownId {
        /// What was looked for: `model`, `parameter`, `view`.
        what: &'static str,
        /// The name that was given.
        id: String,
        /// The nearest known names, best first.
        nearest: Vec<String>,
    },
    /// Text that cannot be read.
    #[error("{}: {}", line(.place), line(.problem))]
    Parse {
        /// Where: `line 3`, `--wo`, a file.
        place: String,
        /// What is wrong there.
        problem: String,
    },
    /// A request beyond a stated limit.
    #[error("{what} is {}; the limit is {}", shown(.value), line(.limit))]
    Limit {
        /// What was asked for.
        what: &'static str,
        /// How much of it.
        value: String,
        /// The limit, with its unit.
        limit: String,
    },
    /// A file or stream that cannot be read or written.
    #[error("{}: {}", line(&.path.to_string_lossy()), line(&.source.to_string()))]
    Io {
        /// The file, or the name of the stream.
        path: PathBuf,
        /// The system's own words.
        source: std::io::Error,
    },
    /// The machine lacks what the request needs.
    #[error("{}; {}", line(.problem), line(.remedy))]
    Platform {
        /// What is missing.
        problem: String,
        /// What the user can do about it.
        remedy: String,
    },
}

/// `std::result::Result` with [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// An unknown name, with the nearest of the `known` ones.
    pub fn unknown<'a>(
        what: &'static str,
        id: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        Self::UnknownId {
            what,
            id: id.to_owned(),
            nearest: nearest(id, known.into_iter().map(|name| (name, name.to_owned()))),
        }
    }

    /// A parse error at `place`.
    pub fn parse(place: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Parse {
            place: place.into(),
            problem: problem.into(),
        }
    }

    /// An input or output error on `path`.
    pub fn io(path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        Self::Io {
            path: path.into(),
            source,
        }
    }
}

/// The longest name or value that a message repeats, in characters: as much as tells it from others.
const MAX_NAME: usize = 80;

/// The longest part of a message, in characters: paths are shown whole, and what is longer fills a terminal.
const MAX_LINE: usize = 800;

/// A name or a value that is not ours, as a part of a message: [`printable`], in 80 characters.
#[must_use]
pub fn shown(text: &str) -> String {
    printable(text, MAX_NAME)
}

/// A part of a message in which there may be text that is not ours: [`printable`], in 800 characters.
#[must_use]
pub fn line(text: &str) -> String {
    printable(text, MAX_LINE)
}

/// `text` on one line, with what would act on a terminal or hide in it spelled out (`\u{1b}`), and its middle left out
/// where it has more than `max` characters.
#[must_use]
pub fn printable(text: &str, max: usize) -> String {
    let text = text.trim_matches(is_break);
    // Only the ends are looked at: the text may be a whole file.
    if text.chars().nth(max).is_none() {
        return spelled_out(text.chars());
    }
    let last = max / 3;
    let tail: Vec<char> = text.chars().rev().take(last).collect();
    let head = spelled_out(text.chars().take(max - last));
    format!("{head}…{}", spelled_out(tail.into_iter().rev()))
}

fn spelled_out(characters: impl Iterator<Item = char>) -> String {
    let mut line = String::new();
    let mut was_break = false;
    for character in characters {
        if is_break(character) {
            was_break = true;
            continue;
        }
        if was_break && character != ' ' && !line.ends_with(' ') {
            line.push(' ');
        }
        was_break = false;
        if is_hidden(character) {
            line.extend(character.escape_unicode());
        } else {
            line.push(character);
        }
    }
    line
}

/// Whether the character parts lines or columns.
fn is_break(character: char) -> bool {
    matches!(character, '\t'..='\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// Whether the character shows nothing by itself and changes what is shown: controls, marks of direction, joiners, tags.
fn is_hidden(character: char) -> bool {
    character.is_control()
        || matches!(
            character,
            '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}'
                | '\u{feff}' | '\u{e0000}'..='\u{e007f}'
        )
}

/// How many near names an error proposes.
const MAX_PROPOSALS: usize = 3;

/// The longest name that is held against known ones, in bytes: what is longer is near none of them, and comparing takes time
/// in proportion to it for each.
const LONGEST_NAME: usize = 128;

/// What has the names nearest to `wanted`, best first, of `known` with their names.
pub fn nearest<'a, T>(wanted: &str, known: impl IntoIterator<Item = (&'a str, T)>) -> Vec<T> {
    if wanted.len() > LONGEST_NAME {
        return Vec::new();
    }
    let wanted = wanted.to_lowercase();
    let mut scored: Vec<(f64, T)> = known
        .into_iter()
        .map(|(name, known)| {
            let name = name.to_lowercase();
            let contains = !wanted.is_empty() && (name.contains(&wanted) || wanted.contains(&name));
            let bonus = if contains { 1.0 } else { 0.0 };
            (bonus + strsim::jaro_winkler(&wanted, &name), known)
        })
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    let best = scored.into_iter().take(MAX_PROPOSALS);
    best.map(|(_, known)| known).collect()
}

fn nearest_phrase(nearest: &[String]) -> String {
    if nearest.is_empty() {
        "nothing is known by such a name".to_owned()
    } else {
        format!("nearest: {}", nearest.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_ids_name_their_neighbours() {
        let known = ["lambertian_reflection", "rough_conductor", "oren_nayar"];
        let line = Error::unknown("model", "orennayar", known).to_string();
        assert!(
            line.starts_with("unknown model 'orennayar'; nearest: oren_nayar"),
            "{line}"
        );
        assert!(
            Error::unknown("model", "conductor", known)
                .to_string()
                .contains("nearest: rough_conductor")
        );
        assert!(!line.contains('\n'));
    }

    #[test]
    fn what_is_too_long_for_a_name_is_compared_with_none() {
        let known = ["phong"; 200];
        let start = std::time::Instant::now();
        // Whole texts come here where one was pasted: compared with each name, this one takes minutes.
        let text = "phong".repeat(4 << 20);
        let line = Error::unknown("material", &text, known).to_string();
        assert!(line.ends_with("nothing is known by such a name"));
        assert!(start.elapsed().as_secs() < 10);
    }

    /// One error of each variant, with `text` wherever text may stand.
    fn every_variant(text: &str) -> Vec<Error> {
        let owned = || text.to_owned();
        let all = vec![
            Error::Parameter {
                model: owned(),
                name: owned(),
                value: owned(),
                allowed: owned(),
            },
            Error::UnknownId {
                what: "model",
                id: owned(),
                nearest: vec![owned()],
            },
            Error::parse(text, text),
            Error::Limit {
                what: "the file",
                value: owned(),
                limit: owned(),
            },
            Error::io(text, std::io::Error::other(text)),
            Error::Platform {
                problem: owned(),
                remedy: owned(),
            },
        ];
        // A new variant does not compile here until it stands above.
        for error in &all {
            match error {
                Error::Parameter { .. }
                | Error::UnknownId { .. }
                | Error::Parse { .. }
                | Error::Limit { .. }
                | Error::Io { .. }
                | Error::Platform { .. } => {}
            }
        }
        all
    }

    #[test]
    fn no_text_acts_on_a_terminal() {
        let hostile = "a\u{1b}[31m\u{7}\r\n\u{9b}2J\u{202e}\u{200b}\u{e0041}\u{7f}\u{2028}b";
        for error in every_variant(hostile) {
            let line = error.to_string();
            assert!(
                !line.chars().any(|c| is_hidden(c) || is_break(c)),
                "{line:?}"
            );
            assert!(
                line.contains("a\\u{1b}[31m\\u{7} \\u{9b}2J\\u{202e}"),
                "{line}"
            );
        }
    }

    #[test]
    fn no_text_fills_the_screen() {
        let long = format!("begin{}end", "x".repeat(1_000_000));
        for error in every_variant(&long) {
            let line = error.to_string();
            assert!(line.chars().count() < 4 * MAX_LINE, "{}", line.len());
            assert!(line.contains("begin") && line.contains("xend"), "{line}");
        }
        let id = Error::unknown("model", &long, ["phong"]).to_string();
        assert!(id.chars().count() < 2 * MAX_NAME, "{id}");
    }

    #[test]
    fn what_is_shown_is_one_line_and_otherwise_as_it_was() {
        for (text, expected) in [
            ("a\r\n b\n", "a b"),
            ("\ta\t\tb", "a b"),
            ("naïve 中 é 👍", "naïve 中 é 👍"),
            ("", ""),
        ] {
            assert_eq!(printable(text, 20), expected);
        }
        assert_eq!(printable("123456789", 9), "123456789");
        assert_eq!(printable("1234567890", 9), "123456…890");
    }
}
