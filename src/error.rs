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

/// How many near names an error proposes.
const MAX_PROPOSALS: usize = 3;

/// What has the names nearest to `wanted`, best first, of `known` with their names.
pub fn nearest<'a, T>(wanted: &str, known: impl IntoIterator<Item = (&'a str, T)>) -> Vec<T> {
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
}
