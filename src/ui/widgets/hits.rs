//! What a search finds: ranked by where the words stand, and gone through by arrows.

use egui::{Key, Modifiers, Ui};

use bxdf::error;

/// How well something is found, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rank {
    /// One of its names is what was typed.
    Name,
    /// One of its names begins with what was typed.
    NameStart,
    /// Every word that was typed begins a word of one of its names.
    WordsOfName,
    /// Every word that was typed begins a word of what is known of it.
    Words,
}

/// What something is found by.
#[derive(Clone, Debug, Default)]
pub struct Known<'a> {
    /// What it is called, the title first.
    pub names: Vec<&'a str>,
    /// What else is said of it.
    pub texts: Vec<&'a str>,
}

/// What a search finds.
#[derive(Debug, PartialEq, Eq)]
pub enum Found<T> {
    /// Nothing is searched for: everything, in its order.
    All(Vec<T>),
    /// What has the words, the best first, else in its order.
    Hits(Vec<T>),
    /// Nothing has the words: these have the names most like them.
    Nearest(Vec<T>),
}

impl<T> Found<T> {
    /// What is listed.
    #[must_use]
    pub fn listed(&self) -> &[T] {
        match self {
            Self::All(listed) | Self::Hits(listed) | Self::Nearest(listed) => listed,
        }
    }
}

/// What `wanted` finds among `all`, which are known by `known`.
pub fn found<'a, T: Copy>(
    wanted: &str,
    all: impl IntoIterator<Item = T>,
    known: impl Fn(T) -> Known<'a>,
) -> Found<T> {
    let all: Vec<T> = all.into_iter().collect();
    if wanted.trim().is_empty() {
        return Found::All(all);
    }
    let of = |one: &T| Some((rank(wanted, &known(*one))?, *one));
    let mut hits: Vec<(Rank, T)> = all.iter().filter_map(of).collect();
    if hits.is_empty() {
        let names = all.into_iter().filter_map(|one| {
            let title = known(one).names.first().copied();
            title.map(|name| (name, one))
        });
        return Found::Nearest(error::nearest(wanted.trim(), names));
    }
    hits.sort_by_key(|(rank, _)| *rank);
    Found::Hits(hits.into_iter().map(|(_, one)| one).collect())
}

/// The words of a text, in lower case.
fn words(text: &str) -> Vec<String> {
    let text = text.to_lowercase();
    let words = text.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| !word.is_empty());
    words.map(str::to_owned).collect()
}

/// How well `wanted` finds what is known so; `None` where it does not. Only where a word begins it is found: "road" is no
/// part of "broad".
fn rank(wanted: &str, known: &Known<'_>) -> Option<Rank> {
    let wanted = words(wanted);
    let names: Vec<Vec<String>> = known.names.iter().map(|name| words(name)).collect();
    let begins_one =
        |start: &String, words: &[String]| words.iter().any(|word| word.starts_with(start));
    let phrase = wanted.join(" ");
    if names.contains(&wanted) {
        Some(Rank::Name)
    } else if names.iter().any(|name| name.join(" ").starts_with(&phrase)) {
        Some(Rank::NameStart)
    } else if names
        .iter()
        .any(|name| wanted.iter().all(|start| begins_one(start, name)))
    {
        Some(Rank::WordsOfName)
    } else {
        let texts = known.texts.iter().flat_map(|text| words(text));
        let all: Vec<String> = names.iter().flatten().cloned().chain(texts).collect();
        let has_all = wanted.iter().all(|start| begins_one(start, &all));
        has_all.then_some(Rank::Words)
    }
}

/// Which of what is listed Enter chooses.
#[derive(Debug, Default)]
pub struct Highlight {
    at: Option<usize>,
    is_moved: bool,
}

impl Highlight {
    /// Begins anew with another list.
    pub fn restart(&mut self) {
        *self = Self {
            at: None,
            is_moved: true,
        };
    }

    /// Goes by so many rows through what is found, from the first hit on; where there is none, from before the first row.
    pub fn go<T>(&mut self, found: &Found<T>, rows: isize) {
        let before = self.at;
        let count = found.listed().len();
        if self.at.is_none() && matches!(found, Found::Hits(_)) {
            self.at = Some(0);
        }
        if rows != 0 {
            let from = self.at.map_or(-1, usize::cast_signed);
            self.at = Some(from.saturating_add(rows).max(0).cast_unsigned());
        }
        self.at = self.at.map(|at| at.min(count.saturating_sub(1)));
        self.at = self.at.filter(|_| count > 0);
        self.is_moved |= self.at != before;
    }

    /// Goes to this place in what is found.
    pub fn go_to(&mut self, at: usize) {
        self.is_moved |= self.at != Some(at);
        self.at = Some(at);
    }

    /// The row that Enter chooses.
    #[must_use]
    pub fn at(&self) -> Option<usize> {
        self.at
    }

    /// Whether another row has become that, so that it is to be brought into sight; told once.
    pub fn take_moved(&mut self) -> bool {
        std::mem::take(&mut self.is_moved)
    }
}

/// By how many rows Up and Down go in this frame; the field, which would move its cursor, does not see them.
#[must_use]
pub fn take_rows(ui: &Ui) -> isize {
    take_presses(ui, [Key::ArrowUp, Key::ArrowDown])
}

/// By how many places Left and Right go in this frame, as [`take_rows`].
#[must_use]
pub fn take_columns(ui: &Ui) -> isize {
    take_presses(ui, [Key::ArrowLeft, Key::ArrowRight])
}

/// How often the second key was pressed, less how often the first one was; nobody else sees them.
fn take_presses(ui: &Ui, keys: [Key; 2]) -> isize {
    let [back, forth] = keys.map(|key| {
        let presses = ui.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key));
        isize::try_from(presses).unwrap_or(isize::MAX)
    });
    forth.saturating_sub(back)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_first_and_words_count_from_their_beginning() {
        const NAMES: [&str; 7] = [
            "Black rubber",
            "Brass",
            "Rolled gold",
            "Gold leaf",
            "Goldfinch",
            "Road sign",
            "Gold",
        ];
        const NOTES: [&str; 7] = [
            "A broad lobe",
            "Yellow as gold is",
            "",
            "",
            "",
            "Sends light back",
            "",
        ];
        let ask = |wanted: &str| {
            found(wanted, 0..NAMES.len(), |index| Known {
                names: vec![NAMES[index]],
                texts: vec![NOTES[index]],
            })
        };
        let hits = |wanted: &str| match ask(wanted) {
            Found::Hits(hits) => hits.into_iter().map(|index| NAMES[index]).collect(),
            Found::All(_) | Found::Nearest(_) => Vec::new(),
        };
        let by_rank = ["Gold", "Gold leaf", "Goldfinch", "Rolled gold", "Brass"];
        assert_eq!(hits("gold"), by_rank);
        assert_eq!(hits("  GOLD "), by_rank);
        assert_eq!(hits("road"), ["Road sign"]);
        assert_eq!(hits("leaf gold"), ["Gold leaf"]);
        assert_eq!(hits("sign light"), ["Road sign"]);
        assert!(hits("old").is_empty() && hits("roa d").is_empty());
        assert_eq!(ask(" "), Found::All((0..NAMES.len()).collect()));
        let Found::Nearest(nearest) = ask("goldd") else {
            panic!("no name begins so");
        };
        assert_eq!(NAMES[nearest[0]], "Gold");
    }

    #[test]
    fn arrows_stay_within_what_is_found() {
        let mut highlight = Highlight::default();
        let hits = Found::Hits(vec![0, 1, 2]);
        for (rows, at) in [(0, 0), (1, 1), (5, 2), (-1, 1), (-9, 0)] {
            highlight.go(&hits, rows);
            assert_eq!(highlight.at(), Some(at), "{rows}");
        }
        assert!(highlight.take_moved() && !highlight.take_moved());
        // What is only near is not chosen unless it is gone to.
        let nearest = Found::Nearest(vec![0, 1]);
        highlight.restart();
        highlight.go(&nearest, 0);
        assert_eq!(highlight.at(), None);
        highlight.go(&nearest, 1);
        assert_eq!(highlight.at(), Some(0));
        highlight.go(&Found::Hits(Vec::<usize>::new()), 1);
        assert_eq!(highlight.at(), None);
    }
}
