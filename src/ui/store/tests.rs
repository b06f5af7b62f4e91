//! What goes wrong with files, and that nothing is lost by it.

use std::cell::Cell;
use std::fs;
use std::io;
use std::rc::Rc;

use super::*;

/// A folder of its own, removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let name = format!("brdf-explorer-store-{name}-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn store(&self) -> Store {
        Store::new(Box::new(Disk), Some(self.0.clone()))
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let name = |entry: io::Result<fs::DirEntry>| entry.unwrap().file_name();
        let mut names: Vec<String> = entries
            .map(|entry| name(entry).into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A disk on which the next steps that write fail, one after so many that work: as where it is full, or the program is
/// killed.
struct Failing {
    works: Rc<Cell<u32>>,
    /// Whether nothing can be done after it, as in a killed program.
    is_killed: bool,
}

impl Failing {
    fn step(&self) -> io::Result<()> {
        let left = self.works.get();
        if left == 0 {
            return Err(io::ErrorKind::StorageFull.into());
        }
        self.works.set(left - 1);
        Ok(())
    }
}

impl Files for Failing {
    fn read(&self, path: &Path, limit: u64) -> io::Result<Vec<u8>> {
        Disk.read(path, limit)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let (first, rest) = bytes.split_at(bytes.len() / 2);
        self.step().inspect_err(|_| {
            Disk.write(path, first).unwrap();
        })?;
        Disk.write(path, &[first, rest].concat())
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        self.step()?;
        Disk.rename(from, to)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        if self.is_killed {
            return self.step();
        }
        Disk.remove(path)
    }

    fn make_folder(&self, path: &Path) -> io::Result<()> {
        Disk.make_folder(path)
    }
}

fn session(theta_deg: f64) -> Session {
    Session {
        theta_deg,
        ..Session::default()
    }
}

#[test]
fn the_session_is_kept_a_moment_after_it_changes() {
    let folder = Folder::new("kept");
    let mut store = folder.store();
    assert_eq!(store.restore().0, None, "nothing is there at first");
    assert_eq!(store.keep(&session(10.0), 5.0).unwrap(), Some(DELAY));
    assert_eq!(store.keep(&session(11.0), 5.75).unwrap(), Some(0.25));
    assert!(folder.names().is_empty());
    assert_eq!(store.keep(&session(12.0), 6.5).unwrap(), None);
    let (restored, problem) = folder.store().restore();
    assert_eq!(restored, Some(session(12.0)));
    assert!(problem.is_none());
    assert_eq!(store.keep(&session(12.0), 9.0).unwrap(), None);
    store.keep_now(&session(13.0)).unwrap();
    assert_eq!(folder.names(), [LAST_SESSION, "session.toml.bak"]);
    let mut restored = folder.store();
    assert_eq!(restored.restore().0, Some(session(13.0)));
    assert_eq!(restored.keep(&session(13.0), 0.0).unwrap(), None);
}

#[test]
fn without_a_folder_nothing_is_kept() {
    let mut store = Store::new(Box::new(Disk), None);
    assert_eq!(store.keep(&session(1.0), 100.0).unwrap(), None);
    store.keep_now(&session(1.0)).unwrap();
    assert!(store.restore().0.is_none() && store.recent().is_empty());
}

#[test]
fn a_writer_that_fails_anywhere_loses_nothing() {
    for is_killed in [false, true] {
        // Written beside, the old one moved to the backup, the new one moved into its place.
        for works in 0..3 {
            let folder = Folder::new(&format!("failing-{is_killed}-{works}"));
            let path = folder.file("mine.toml");
            let mut store = folder.store();
            store.save(&path, &session(10.0)).unwrap();
            store.save(&path, &session(20.0)).unwrap();
            let files = Failing {
                works: Rc::new(Cell::new(works)),
                is_killed,
            };
            let mut failing = Store::new(Box::new(files), None);
            let line = failing.save(&path, &session(30.0)).unwrap_err().to_string();
            assert!(line.contains("mine.toml") && !line.contains('\n'), "{line}");
            // The last good one is there, in its place or as the backup of a killed program.
            let found = [path.clone(), backup(&path)]
                .into_iter()
                .find(|path| path.exists())
                .unwrap();
            let opened = folder.store().open(&found).unwrap();
            assert_eq!(opened, Opened::Session(Box::new(session(20.0))), "{works}");
            // What a killed program left beside it is in nobody's way.
            let mut store = folder.store();
            store.save(&path, &session(40.0)).unwrap();
            let opened = store.open(&path).unwrap();
            assert_eq!(opened, Opened::Session(Box::new(session(40.0))));
            assert!(!with_suffix(&path, ".partial").exists());
        }
    }
}

#[test]
fn a_killed_program_is_restored_from_what_is_left() {
    for works in 0..3 {
        let folder = Folder::new(&format!("killed-{works}"));
        let mut store = folder.store();
        store.keep_now(&session(10.0)).unwrap();
        store.keep_now(&session(20.0)).unwrap();
        let files = Failing {
            works: Rc::new(Cell::new(works)),
            is_killed: true,
        };
        let mut killed = Store::new(Box::new(files), Some(folder.0.clone()));
        assert!(killed.keep_now(&session(30.0)).is_err());
        let (restored, problem) = folder.store().restore();
        assert_eq!(restored, Some(session(20.0)), "{works}");
        assert!(problem.is_none());
    }
}

#[test]
fn a_broken_session_is_told_of_and_never_replaces_the_backup() {
    let folder = Folder::new("broken");
    let mut store = folder.store();
    store.keep_now(&session(10.0)).unwrap();
    store.keep_now(&session(20.0)).unwrap();
    fs::write(folder.file(LAST_SESSION), "theta_deg = \"steep\"").unwrap();
    let mut store = folder.store();
    let (restored, problem) = store.restore();
    assert_eq!(restored, Some(session(10.0)));
    let line = problem.unwrap().to_string();
    assert!(line.contains("session.toml: line 1"), "{line}");
    store.keep_now(&session(30.0)).unwrap();
    fs::remove_file(folder.file(LAST_SESSION)).unwrap();
    assert_eq!(folder.store().restore().0, Some(session(10.0)));
}

#[test]
fn files_of_the_wrong_kind_are_refused_in_a_line() {
    let folder = Folder::new("wrong");
    let text = session(10.0).to_toml().unwrap();
    let huge = "# ".to_owned() + &"x".repeat(MAX_FILE as usize);
    let newer = text.replace("version = 1", "version = 7");
    let cases: [(&str, &[u8], &str); 8] = [
        ("picture.png", b"\x89PNG\r\n\x1a\n\xff\xfe", "no text"),
        ("letter.txt", b"Dear all,\nsee below.", "line 1"),
        ("empty.toml", b"", "there is nothing in it"),
        ("huge.toml", huge.as_bytes(), "more than 1048576 bytes"),
        (
            "cut.toml",
            &text.as_bytes()[..text.len() / 2],
            "the file is cut off",
        ),
        (
            "fields.toml",
            b"hold = \"wi\"\nflavour = 1",
            "line 2: unknown field `flavour`",
        ),
        (
            "newer.toml",
            newer.as_bytes(),
            "a session of version 7; this program reads up to version 1",
        ),
        (
            "model.toml",
            b"[[lobes]]\nmodel = \"gold\"",
            "line 2: unknown model 'gold'",
        ),
    ];
    let mut store = folder.store();
    for (name, bytes, expected) in cases {
        let path = folder.file(name);
        fs::write(&path, bytes).unwrap();
        let line = store.open(&path).unwrap_err().to_string();
        assert!(line.contains(name) && line.contains(expected), "{line}");
        assert!(!line.contains('\n'), "{line}");
    }
    assert!(store.open(&folder.file("nowhere.toml")).is_err());
    assert!(store.open(&folder.0).is_err(), "a folder");
    assert!(store.recent().is_empty());
}

#[test]
fn a_folder_that_cannot_be_written_is_told_of() {
    let folder = Folder::new("locked");
    // A file where the folder should be is refused to everybody, the administrator included.
    fs::write(folder.file("data"), "a file").unwrap();
    let own = folder.file("data");
    let mut store = Store::new(Box::new(Disk), Some(own.clone()));
    let line = store.keep_now(&session(1.0)).unwrap_err().to_string();
    assert!(line.contains("data"), "{line}");
    assert_eq!(
        store.keep(&session(1.0), 9.0).unwrap(),
        None,
        "said once, not in every frame"
    );
    assert!(store.save(&own.join("x.toml"), &session(1.0)).is_err());
    assert_eq!(fs::read_to_string(own).unwrap(), "a file");
}

#[test]
fn the_files_used_last_are_remembered() {
    let folder = Folder::new("recent");
    let mut store = folder.store();
    let paths: Vec<PathBuf> = (0..10).map(|i| folder.file(&format!("{i}.toml"))).collect();
    for path in &paths {
        store.save(path, &session(5.0)).unwrap();
    }
    store.open(&paths[4]).unwrap();
    let again = folder.store();
    assert_eq!(again.recent(), store.recent());
    assert_eq!(again.recent().len(), MAX_RECENT);
    assert_eq!(again.recent()[..2], [paths[4].clone(), paths[9].clone()]);
    fs::write(folder.file(PREFERENCES), "recent = 3").unwrap();
    assert!(folder.store().recent().is_empty());
}
