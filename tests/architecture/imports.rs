//! Which file names which: a file's imports and paths, resolved as Rust resolves them, as far as text shows them.

use std::collections::{BTreeMap, BTreeSet};

/// The modules of one package, each a file.
pub struct Package<'a> {
    /// By path within the package, as `["material", "file"]`.
    modules: BTreeMap<Vec<&'a str>, Module>,
}

struct Module {
    /// The file, relative to the root of the repository.
    path: String,
    /// What it imports, and whether it makes that known further on.
    uses: Vec<(Vec<String>, bool)>,
    /// The paths in its code.
    paths: Vec<Vec<String>>,
    /// The names that it defines.
    defined: BTreeSet<String>,
}

/// What a path leads to: a module, or something in it.
enum Target<'a> {
    Module(Vec<&'a str>),
    Item(Vec<&'a str>),
}

/// The longest chain of imports that is followed.
const MAX_DEPTH: usize = 16;

impl<'a> Package<'a> {
    /// The package of these files: path relative to the package, path relative to the repository, code without tests and
    /// comments.
    pub fn new(files: &[(&'a str, String, String)]) -> Self {
        let modules = files.iter().map(|(inside, path, code)| {
            let (uses, code) = uses(code);
            let module = Module {
                path: path.clone(),
                uses,
                paths: paths(&code),
                defined: defined(&code),
            };
            (name_of(inside), module)
        });
        Self {
            modules: modules.collect(),
        }
    }

    /// The files that each file names, by their paths.
    pub fn named(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let mut named = BTreeMap::new();
        for (place, module) in &self.modules {
            let mut found = BTreeSet::new();
            for (path, is_public) in &module.uses {
                let is_glob = path.last().is_some_and(|name| name == "*");
                let path = path
                    .split_last()
                    .filter(|_| is_glob)
                    .map_or(&path[..], |(_, rest)| rest);
                match self.resolve(place, path, 0) {
                    // A parent's `pub use` of what is its own.
                    Some(Target::Module(target) | Target::Item(target))
                        if *is_public && target.starts_with(place) => {}
                    // A module that is only named is counted where something of it is.
                    Some(Target::Module(_)) if !is_glob => {}
                    Some(Target::Module(target) | Target::Item(target)) => {
                        found.extend(self.file(&target));
                    }
                    None => {}
                }
            }
            for path in &module.paths {
                if let Some(Target::Item(target)) = self.resolve(place, path, 0) {
                    found.extend(self.file(&target));
                }
            }
            found.remove(module.path.as_str());
            named.insert(module.path.as_str(), found);
        }
        named
    }

    fn file<'s>(&'s self, module: &[&'a str]) -> Option<&'s str> {
        self.modules.get(module).map(|module| module.path.as_str())
    }

    fn resolve(&self, from: &[&'a str], path: &[String], depth: usize) -> Option<Target<'a>> {
        let (first, mut rest) = path.split_first()?;
        if depth > MAX_DEPTH {
            return None;
        }
        let mut at = from.to_vec();
        match first.as_str() {
            "crate" => at.clear(),
            "self" => {}
            "super" => {
                at.pop();
                while let Some((next, others)) = rest.split_first()
                    && next == "super"
                {
                    at.pop();
                    rest = others;
                }
            }
            name if self.child(&at, name).is_some() => rest = path,
            name => {
                let module = self.modules.get(from)?;
                let is_it = |(use_, _): &&(Vec<String>, bool)| {
                    use_.len() > 1 && use_.last().is_some_and(|last| last == name) && use_ != path
                };
                let (use_, _) = module.uses.iter().find(is_it)?;
                let Target::Module(found) = self.resolve(from, use_, depth + 1)? else {
                    return None;
                };
                return self.walk(found, rest, depth + 1);
            }
        }
        self.walk(at, rest, depth)
    }

    fn child(&self, parent: &[&'a str], name: &str) -> Option<&'a str> {
        let mut names = self.modules.keys();
        let is_child = |module: &&Vec<&'a str>| {
            module.len() == parent.len() + 1
                && module.starts_with(parent)
                && module.last() == Some(&name)
        };
        names.find(is_child)?.last().copied()
    }

    fn walk(&self, mut at: Vec<&'a str>, path: &[String], depth: usize) -> Option<Target<'a>> {
        let mut rest = path;
        while let Some((first, others)) = rest.split_first()
            && let Some(name) = self.child(&at, first)
        {
            at.push(name);
            rest = others;
        }
        let Some((name, others)) = rest.split_first() else {
            return Some(Target::Module(at));
        };
        let module = self.modules.get(&at)?;
        if depth > MAX_DEPTH || module.defined.contains(name) {
            return Some(Target::Item(at));
        }
        // What the module has from elsewhere is named there.
        for (use_, is_public) in &module.uses {
            let Some((last, parent)) = use_.split_last() else {
                continue;
            };
            if *is_public && last == name {
                return match self.resolve(&at, use_, depth + 1)? {
                    Target::Module(found) if !others.is_empty() => {
                        self.walk(found, others, depth + 1)
                    }
                    found => Some(found),
                };
            }
            if *is_public
                && last == "*"
                && let Some(Target::Module(found)) = self.resolve(&at, parent, depth + 1)
                && self
                    .modules
                    .get(&found)
                    .is_some_and(|module| module.defined.contains(name))
            {
                return Some(Target::Item(found));
            }
        }
        // What no file has: a name of a module within one, of an enumeration, of another crate.
        None
    }
}

/// The files that lie on a circle of names, each with those of its circle that it names.
pub fn circles<'a>(named: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> Vec<(&'a str, Vec<&'a str>)> {
    let reached = |from: &'a str| {
        let mut seen = BTreeSet::new();
        let mut next: Vec<&str> = named.get(from).into_iter().flatten().copied().collect();
        while let Some(file) = next.pop() {
            if seen.insert(file) {
                next.extend(named.get(file).into_iter().flatten());
            }
        }
        seen
    };
    let all: BTreeMap<&str, BTreeSet<&str>> =
        named.keys().map(|file| (*file, reached(file))).collect();
    let of = |file: &'a str| all.get(file).into_iter().flatten().copied();
    named
        .iter()
        .filter(|(file, _)| of(file).any(|other| other == **file))
        .map(|(file, others)| {
            let back = others
                .iter()
                .filter(|other| of(other).any(|one| one == *file));
            (*file, back.copied().collect())
        })
        .collect()
}

/// The module that a file is, by its path within the package.
fn name_of(inside: &str) -> Vec<&str> {
    let mut parts: Vec<&str> = inside.trim_end_matches(".rs").split('/').collect();
    if matches!(parts.last(), Some(&("mod" | "lib" | "main"))) {
        parts.pop();
    }
    parts
}

/// The statements of `use` in the code, by what they name and whether they are public, and the code without them.
fn uses(code: &str) -> (Vec<(Vec<String>, bool)>, String) {
    let (mut found, mut others) = (Vec::new(), String::new());
    let mut rest = code;
    while let Some((line, after)) = rest.split_once('\n') {
        let (word, _) = line.trim_start().split_once("use ").unwrap_or(("no", ""));
        let is_public = word.starts_with("pub") && word.ends_with(' ');
        if !word.is_empty() && !is_public {
            others.push_str(line);
            others.push('\n');
            rest = after;
            continue;
        }
        let (statement, after) = rest.split_once(';').unwrap_or((rest, ""));
        let tree = statement.split_once("use ").map_or("", |(_, tree)| tree);
        let mut paths = Vec::new();
        expand(tree.trim(), &mut Vec::new(), &mut paths);
        found.extend(paths.into_iter().map(|path| (path, is_public)));
        rest = after;
    }
    (found, others + rest)
}

/// The paths of a tree as `a::{b, c::d as e}`.
fn expand(tree: &str, before: &mut Vec<String>, paths: &mut Vec<Vec<String>>) {
    let length = before.len();
    let (head, list) = tree
        .split_once('{')
        .map_or((tree, None), |(head, list)| (head, Some(list)));
    let head = head.split(" as ").next().unwrap_or_default();
    let names = head
        .split("::")
        .map(str::trim)
        .filter(|name| !name.is_empty());
    before.extend(
        names
            .filter(|name| *name != "self" || length == 0)
            .map(str::to_owned),
    );
    match list.and_then(|list| list.trim_end().strip_suffix('}')) {
        Some(list) => {
            let (mut depth, mut start) = (0, 0);
            for (at, character) in list.char_indices() {
                match character {
                    '{' => depth += 1,
                    '}' => depth -= 1,
                    ',' if depth == 0 => {
                        expand(
                            list.get(start..at).unwrap_or_default().trim(),
                            before,
                            paths,
                        );
                        start = at + 1;
                    }
                    _ => {}
                }
            }
            let last = list.get(start..).unwrap_or_default().trim();
            if !last.is_empty() {
                expand(last, before, paths);
            }
        }
        None => paths.push(before.clone()),
    }
    before.truncate(length);
}

/// The paths of more than one name in the code itself.
fn paths(code: &str) -> Vec<Vec<String>> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let words = code.split(|c: char| !is_part(c));
    let paths = words.filter(|word| word.contains("::") && !word.starts_with(':'));
    let names = |path: &str| {
        path.split("::")
            .filter(|name| !name.is_empty())
            .map(str::to_owned)
            .collect()
    };
    paths
        .map(names)
        .filter(|path: &Vec<String>| path.len() > 1)
        .collect()
}

/// The names of what is defined at the top of a file.
fn defined(code: &str) -> BTreeSet<String> {
    const KINDS: [&str; 9] = [
        "fn",
        "struct",
        "enum",
        "trait",
        "const",
        "static",
        "type",
        "union",
        "macro_rules!",
    ];
    let lines = code
        .lines()
        .filter(|line| !line.starts_with(char::is_whitespace));
    let name = |line: &str| {
        let mut words = line
            .split_whitespace()
            .skip_while(|word| !KINDS.contains(word) || *word == "const" && line.contains(" fn "));
        words.next()?;
        let name: String = words
            .next()?
            .chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect();
        Some(name)
    };
    lines.filter_map(name).collect()
}

#[test]
fn imports_are_resolved_and_circles_found() {
    let files = [
        ("lib.rs", "pub mod a;\nmod b;\npub use b::Thing;\n"),
        (
            "a.rs",
            "use crate::{Thing, b::{self, Other as Else}};\nfn f() { b::g(); }\n",
        ),
        (
            "b/mod.rs",
            "mod c;\npub use c::*;\npub struct Other;\npub fn g() { c::h() }\n",
        ),
        (
            "b/c.rs",
            "use super::Other;\npub struct Thing;\npub const fn h() {}\n",
        ),
    ];
    let files = files.map(|(inside, code)| (inside, format!("x/{inside}"), code.to_owned()));
    let package = Package::new(&files);
    let named = package.named();
    let of = |file: &str| {
        named
            .get(file)
            .into_iter()
            .flatten()
            .copied()
            .collect::<Vec<_>>()
    };
    assert_eq!(of("x/a.rs"), ["x/b/c.rs", "x/b/mod.rs"]);
    assert_eq!(of("x/b/c.rs"), ["x/b/mod.rs"]);
    assert_eq!(of("x/lib.rs"), [""; 0]);
    let found = circles(&named);
    assert_eq!(
        found,
        [
            ("x/b/c.rs", vec!["x/b/mod.rs"]),
            ("x/b/mod.rs", vec!["x/b/c.rs"])
        ]
    );
}
