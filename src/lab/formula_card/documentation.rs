//! What a model's file says of it: where it comes from, where it departs from that, and how far it is valid.

/// The sections of a model's documentation, each as paragraphs of plain text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Documentation {
    /// The works that the formula is of.
    pub source: Vec<String>,
    /// Where it is not theirs.
    pub departures: Vec<String>,
    /// How far it is valid, and what it leaves out.
    pub validity: Vec<String>,
}

impl Documentation {
    /// Cuts the sections out of the text of a file.
    pub(super) fn of(file: &str) -> Self {
        Self {
            source: section(file, "Source"),
            departures: section(file, "Departures"),
            validity: section(file, "Validity"),
        }
    }
}

/// The paragraphs below the heading `title`.
fn section(file: &str, title: &str) -> Vec<String> {
    let lines = file.lines().map_while(|line| line.strip_prefix("//!"));
    let lines = lines.map(str::trim);
    let of_title = |line: &str| line.strip_prefix("# ") == Some(title);
    let inside = lines.skip_while(|line| !of_title(line)).skip(1);
    let mut paragraphs = vec![String::new()];
    for line in inside.take_while(|line| !line.starts_with("# ")) {
        let is_new = line.is_empty() || line.starts_with("- ");
        if is_new || paragraphs.is_empty() {
            paragraphs.push(String::new());
        }
        if let Some(last) = paragraphs.last_mut() {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(&plain(line));
        }
    }
    paragraphs.retain(|paragraph| !paragraph.is_empty());
    paragraphs
}

/// A line without the signs of its markup.
fn plain(line: &str) -> String {
    line.replace("[`", "").replace("`]", "").replace('`', "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_become_paragraphs() {
        let file = "//! Head.\n//!\n//! # Source\n//! One `two`,\n//! and [`Three`].\n//!\n//! - four;\n//! - five.\n//!\n\
                    //! # Departures\n//! None.\n//!\n//! # Validity\n//! Ever.\n\nuse nothing;\n//! # Source\n//! no";
        let found = Documentation::of(file);
        assert_eq!(found.source, ["One two, and Three.", "- four;", "- five."]);
        assert_eq!(found.departures, ["None."]);
        assert_eq!(found.validity, ["Ever."]);
    }
}
