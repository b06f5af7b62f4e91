//! The shape of the source: which module may name which, what stands in which file, what is cited.

#![allow(clippy::unwrap_used, reason = "a test stops at what it did not expect")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

mod imports;
mod models;

/// The packages, by their folders, each after those that it may name: cargo keeps that order, and `src/` itself, the program,
/// is the last. Within them a file names only files that do not lead back to it.
const PACKAGES: [&str; 6] = [
    "src/bxdf/",
    "src/lab/",
    "src/study/",
    "src/ui/",
    PAGE,
    "src/",
];

/// The only package that knows the window.
const WINDOW: &str = "src/ui/";

/// The package of the page.
const PAGE: &str = "src/web/";

/// The longest source file, in lines: beyond it a file is more than one thing.
const MAX_LINES: usize = 400;

/// What the model core does without: threads, clocks, the process it runs in, and files but in one place.
const STD_MODULES_NOT_IN_BXDF: [&str; 6] = ["env", "fs", "net", "process", "thread", "time"];

/// Where it reads them, for `Material::open`, if at all: behind the feature `files`.
const FILES_OF_BXDF: &str = "src/bxdf/files.rs";

struct SourceFile {
    /// Relative to the root of the repository, with forward slashes.
    path: String,
    text: String,
}

impl SourceFile {
    /// The text without comments.
    fn code(&self) -> String {
        let lines = self.text.lines();
        lines
            .map(|line| line.split_once("//").map_or(line, |(code, _)| code))
            .fold(String::new(), |code, line| code + line + "\n")
    }

    /// The comments only.
    fn comments(&self) -> String {
        let lines = self.text.lines();
        lines
            .filter_map(|line| line.split_once("//"))
            .fold(String::new(), |text, (_, comment)| text + comment + "\n")
    }

    /// The code without its tests.
    fn tested(&self) -> String {
        let code = self.code();
        let mut rest = code.as_str();
        let mut kept = String::new();
        while let Some((before, tests)) = rest.split_once("#[cfg(test)]\nmod ") {
            kept.push_str(before);
            // A module in a file of its own ends with its line, else where nothing is indented any more.
            let (line, after) = tests.split_once('\n').unwrap_or((tests, ""));
            rest = if line.ends_with(';') {
                after
            } else {
                after.split_once("\n}\n").map_or("", |(_, after)| after)
            };
        }
        kept + rest
    }

    /// The folder of the package that the file belongs to.
    fn package(&self) -> &'static str {
        let mut folders = PACKAGES.into_iter();
        folders
            .find(|folder| self.path.starts_with(folder))
            .unwrap()
    }

    /// Whether all of it is tests, or an example, which runs with them.
    fn is_test(&self) -> bool {
        let folders = ["/tests/", "/examples/"];
        self.path.ends_with("/tests.rs") || folders.iter().any(|folder| self.path.contains(folder))
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every `.rs` file below `folder`.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

fn sources() -> Vec<SourceFile> {
    let read = |path: PathBuf| {
        let relative = path.strip_prefix(root()).unwrap().to_str().unwrap();
        SourceFile {
            path: relative.replace('\\', "/"),
            text: fs::read_to_string(&path).unwrap(),
        }
    };
    let files: Vec<SourceFile> = rust_files(&root().join("src"))
        .into_iter()
        .map(read)
        .collect();
    assert!(files.iter().any(|file| file.path == "src/bxdf/lib.rs"));
    files
}

/// The names that follow `prefix` in `code`, those of a braced list included: `a` and `b` in `crate::{a::c, b}`.
fn names_after(code: &str, prefix: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (at, _) in code.match_indices(prefix) {
        let rest = code.split_at(at + prefix.len()).1;
        if let Some(list) = rest.strip_prefix('{') {
            let mut depth = 1_u32;
            let mut item = String::new();
            for character in list.chars() {
                match character {
                    '{' => depth += 1,
                    '}' => depth -= 1,
                    ',' if depth == 1 => names.extend(first_name(&std::mem::take(&mut item))),
                    _ if depth == 1 => item.push(character),
                    _ => {}
                }
                if depth == 0 {
                    break;
                }
            }
            names.extend(first_name(&item));
        } else {
            names.extend(first_name(rest));
        }
    }
    names
}

fn first_name(text: &str) -> Option<String> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let name: String = text
        .trim_start()
        .chars()
        .take_while(|c| is_part(*c))
        .collect();
    Some(name).filter(|name| !name.is_empty())
}

#[test]
fn names_are_found_in_paths_and_lists() {
    let code = "use crate::{analysis::{lobe::Lobe, scale}, bxdf,\n    ui::run};\ncrate::lab::x();";
    let found = names_after(code, "crate::");
    assert!(found.iter().eq(["analysis", "bxdf", "lab", "ui"]));
}

/// The files of the package in `folder`: path in the package, path in the repository, code.
fn files_of<'a>(sources: &'a [SourceFile], folder: &str) -> Vec<(&'a str, String, String)> {
    let is_source = |file: &&SourceFile| file.package() == folder && !file.is_test();
    let files = sources.iter().filter(is_source);
    let parts = files.map(|file| {
        let inside = file.path.strip_prefix(folder).unwrap();
        (inside, file.path.clone(), file.tested())
    });
    parts.collect()
}

#[test]
fn no_file_leads_back_to_itself() {
    let sources = sources();
    let mut problems = Vec::new();
    for folder in PACKAGES {
        let files = files_of(&sources, folder);
        let package = imports::Package::new(&files);
        let named: BTreeMap<_, _> = package.named();
        assert!(
            named.values().map(BTreeSet::len).sum::<usize>() > 4,
            "{folder}"
        );
        for (file, back) in imports::circles(&named) {
            problems.push(format!("{file} names {}", back.join(", ")));
        }
    }
    assert!(problems.is_empty(), "circles:\n{}", problems.join("\n"));
}

/// Rooms of the packages that have an order, each after those that it may name; what stands in none of them may name all.
const ROOMS: [&[&str]; 2] = [
    &["src/lab/analysis/", "src/lab/"],
    &[
        "src/ui/scene3d/",
        "src/ui/theme/",
        "src/ui/widgets/",
        "src/ui/views/",
        "src/ui/tiles",
        "src/ui/app/",
        "src/ui/commands/",
        "src/ui/side.rs",
        "src/ui/shell",
        "src/ui/headless.rs",
        "src/ui/export/",
        "src/ui/window.rs",
    ],
];

#[test]
fn rooms_name_only_those_before_them() {
    let sources = sources();
    for rooms in ROOMS {
        let rank = |path: &str| rooms.iter().position(|room| path.starts_with(room));
        let folder = PACKAGES
            .into_iter()
            .find(|folder| rooms[0].starts_with(folder))
            .unwrap();
        let files = files_of(&sources, folder);
        let package = imports::Package::new(&files);
        let mut checked = 0;
        for (file, others) in package.named() {
            for other in others {
                if let (Some(own), Some(named)) = (rank(file), rank(other)) {
                    assert!(named <= own, "{file} names {other}");
                    checked += 1;
                }
            }
        }
        assert!(checked > 20, "{checked}");
    }
}

#[test]
fn egui_is_named_only_by_the_window() {
    for file in sources() {
        // The page is the window of browsers.
        let may_name = [WINDOW, PAGE].contains(&file.package());
        let code = file.code();
        for word in ["egui", "eframe", "wgpu", "winit"] {
            assert!(
                may_name || !code.contains(word),
                "{} names {word}",
                file.path
            );
        }
    }
}

/// egui's own fields clamp and alter what is typed: one field of the window's own takes their place.
#[test]
fn numbers_are_typed_into_one_kind_of_field() {
    let is_field = |file: &SourceFile| file.path.starts_with("src/ui/widgets/number/");
    for file in sources().iter().filter(|file| !is_field(file)) {
        for word in ["DragValue", "Slider"] {
            assert!(!file.code().contains(word), "{} names {word}", file.path);
        }
    }
}

#[test]
fn the_model_core_has_no_threads_or_clocks_and_files_in_one_place() {
    for file in sources() {
        if !file.path.starts_with("src/bxdf/") || file.is_test() {
            continue;
        }
        let named = names_after(&file.tested(), "std::");
        for module in STD_MODULES_NOT_IN_BXDF {
            let may_name = file.path == FILES_OF_BXDF && module == "fs";
            assert!(
                may_name || !named.contains(module),
                "{} names std::{module}",
                file.path
            );
        }
    }
}

#[test]
fn source_files_are_short() {
    let long: Vec<String> = sources()
        .iter()
        .map(|file| (file.text.lines().count(), &file.path))
        .filter(|(lines, _)| *lines > MAX_LINES)
        .map(|(lines, path)| format!("{path} has {lines} lines"))
        .collect();
    assert!(long.is_empty(), "over {MAX_LINES}: {}", long.join(", "));
}

/// Where threads are begun: the pool, and what waits for signals while the command line writes files.
const BEGINNERS: [&str; 2] = ["src/study/parallel.rs", "src/cli/signals.rs"];

#[test]
fn one_pool_begins_all_threads() {
    let mut found = BTreeSet::new();
    for file in sources().into_iter().filter(|file| !file.is_test()) {
        let code = file.tested();
        let words = [
            "thread::Builder",
            "thread::spawn",
            "thread::scope",
            "PoolBuilder",
            "rayon::spawn",
        ];
        if words.iter().any(|word| code.contains(word)) {
            found.insert(file.path);
        }
    }
    assert!(
        found.iter().eq(BTreeSet::from(BEGINNERS).iter()),
        "{found:?}"
    );
}

#[test]
fn the_core_builds_without_a_window() {
    let output = Command::new(env!("CARGO"))
        .current_dir(root())
        .args([
            "tree",
            "--offline",
            "--locked",
            "-p",
            "brdf-explorer",
            "--no-default-features",
        ])
        .args(["--edges", "normal", "--prefix", "none"])
        .output()
        .unwrap();
    let tree = String::from_utf8(output.stdout).unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(tree.contains("glam"), "{tree}");
    for package in ["egui", "eframe", "wgpu", "winit"] {
        assert!(!tree.contains(package), "{tree}");
    }
}
