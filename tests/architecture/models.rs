//! What the files of models say, and that each is listed.

use std::collections::BTreeSet;
use std::fs;

use super::{SourceFile, root, rust_files, sources};
use brdf_explorer::bxdf::models::MODELS;

/// A closure that stays a call makes a batch's loop one of calls: seventeen times as slow, and nothing else tells.
#[test]
fn what_a_batch_asks_of_a_model_is_inlined() {
    let sources = sources();
    let is_kernels = |file: &&SourceFile| file.path.ends_with("bxdf/batch/kernels.rs");
    let kernels = sources.iter().find(is_kernels).unwrap();
    let lines: Vec<&str> = kernels.text.lines().map(str::trim).collect();
    let mut checked = 0;
    for pair in lines.windows(2) {
        let [before, line] = pair else { continue };
        let is_asked = line.contains("bxdf.") && line.contains('|');
        if is_asked {
            assert_eq!(*before, "#[inline(always)]", "{line}");
            checked += 1;
        }
    }
    assert!(checked >= 2, "{checked}");
}

#[test]
fn every_model_has_a_file_and_every_file_a_model() {
    let files: BTreeSet<String> = rust_files(&root().join("src/bxdf/models"))
        .iter()
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .filter(|name| name != "mod")
        .collect();
    let listed: BTreeSet<String> = MODELS.iter().map(|model| model.id.to_owned()).collect();
    assert_eq!(files, listed);
}

#[test]
fn models_say_where_they_come_from() {
    for file in sources() {
        if !file.path.starts_with("src/bxdf/models/") || file.path.ends_with("/mod.rs") {
            continue;
        }
        let comments = file.comments();
        for heading in ["# Source", "# Departures", "# Validity"] {
            assert!(comments.contains(heading), "{}: no {heading}", file.path);
        }
    }
}

#[test]
fn every_work_cited_stands_in_the_references() {
    let references = fs::read_to_string(root().join("references.bib")).unwrap();
    let known: Vec<&str> = references
        .lines()
        .filter(|line| line.starts_with('@'))
        .filter_map(|line| line.split_once('{'))
        .map(|(_, key)| key.trim_end_matches(','))
        .collect();
    let distinct: BTreeSet<&str> = known.iter().copied().collect();
    assert_eq!(distinct.len(), known.len(), "a key stands twice");
    for file in sources() {
        for key in cited_keys(&file.comments()) {
            assert!(
                distinct.contains(key.as_str()),
                "{} cites `{key}`, which references.bib lacks",
                file.path
            );
        }
    }
}

/// The bibliography keys between backticks: letters and a year, as in walter2007.
fn cited_keys(comments: &str) -> BTreeSet<String> {
    let is_key = |text: &&str| {
        let name = text.trim_start_matches(|c: char| c.is_ascii_lowercase());
        let year = name.trim_end_matches(|c: char| c.is_ascii_lowercase());
        name.len() < text.len() && year.len() == 4 && year.bytes().all(|b| b.is_ascii_digit())
    };
    comments
        .split('`')
        .filter(is_key)
        .map(str::to_owned)
        .collect()
}
