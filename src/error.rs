//! The one error type, by who is at fault.

use std::path::PathBuf;

/// What can go wrong; each prints as one clear line.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A parameter value that the model does not allow.
    #[error("{model}: {name} = {value}: {allowed}")]
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
    #[error("unknown {what} '{id}'; {}", nearest_phrase(.nearest))]
    UnknownId {
        /// What was looked for: `model`, `parameter`, `view`.
        what: &'static str,
        /// The name that was given.
        id: String,
        /// The nearest known names, best first.
        nearest: Vec<String>,
    },
    /// Text that cannot be read.
    #[error("{place}: {problem}")]
    Parse {
        /// Where: `line 3`, `--wo`, a file.
        place: String,
        /// What is wrong there.
        problem: String,
    },
    /// A request beyond a stated limit.
    #[error("{what} is {value}; the limit is {limit}")]
    Limit {
        /// What was asked for.
        what: &'static str,
        /// How much of it.
        value: String,
        /// The limit, with its unit.
        limit: String,
    },
    /// A file or stream that cannot be read or written.
    #[error("{}: {source}", .path.display())]
    Io {
        /// The file, or the name of the stream.
        path: PathBuf,
        /// The system's own words.
        source: std::io::Error,
    },
    /// The machine lacks what the request needs.
    #[error("{problem}; {remedy}")]
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
            nearest: nearest(id, known),
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

/// How many near names an error proposes.
const MAX_PROPOSALS: usize = 3;

/// The longest name that is held against known ones, in bytes: what is longer is near none of them, and comparing takes time
/// in proportion to it for each.
const LONGEST_NAME: usize = 128;

fn nearest<'a>(id: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    if id.len() > LONGEST_NAME {
        return Vec::new();
    }
    let wanted = id.to_lowercase();
    let mut scored: Vec<(f64, &str)> = known
        .into_iter()
        .map(|name| {
            let contains = !wanted.is_empty() && (name.contains(&wanted) || wanted.contains(name));
            let bonus = if contains { 1.0 } else { 0.0 };
            (bonus + strsim::jaro_winkler(&wanted, name), name)
        })
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    scored
        .into_iter()
        .take(MAX_PROPOSALS)
        .map(|(_, name)| name.to_owned())
        .collect()
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
}
