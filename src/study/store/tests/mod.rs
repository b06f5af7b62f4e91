//! What goes wrong with files, and that nothing is lost by it.

use std::fs;
use std::io;
use std::sync::atomic::{AtomicU32, Ordering};

use super::place::{backup, with_suffix};
use super::*;
use crate::files::MAX_TEXT;
use crate::session::{MAX_MATERIALS, Materials};
use bxdf::Material;
use bxdf::material::library;
use bxdf_lab::timing::Stopwatch::NoClock;
use bxdf_lab::tradeoff::{FAMILIES, Family, Study, measure};

mod data;
mod own;

/// The session of the last run, in the folder of the program's data.
const LAST_SESSION: &str = "session.toml";

/// For what is baked, and stands in no file.
fn nothing(path: &Path) -> Result<Vec<u8>> {
    panic!("{} is read", path.display());
}

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
        Store::new(Arc::new(Disk), Some(self.0.clone()))
    }

    /// What the next run begins with: the session of the last one, if there is any, and what is said.
    fn restored(&self) -> (Option<Session>, Vec<String>) {
        let Restored { session, said } = self.store().restore(fresh());
        (Some(session).filter(|session| *session != fresh()), said)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let name = |entry: io::Result<fs::DirEntry>| entry.unwrap().file_name();
        let mut names: Vec<String> = entries
            .map(|entry| name(entry).into_string().unwrap())
            .filter(|name| !name.contains(".lock"))
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
#[derive(Clone)]
struct Failing {
    works: Arc<AtomicU32>,
    /// Whether nothing can be done after it, as in a killed program.
    is_killed: bool,
}

impl Failing {
    fn after(works: u32, is_killed: bool) -> Self {
        Self {
            works: Arc::new(AtomicU32::new(works)),
            is_killed,
        }
    }

    fn step(&self) -> io::Result<()> {
        let left = self.works.load(Ordering::SeqCst);
        if left == 0 {
            return Err(io::ErrorKind::StorageFull.into());
        }
        self.works.store(left - 1, Ordering::SeqCst);
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

    fn look(&self, path: &Path) -> io::Result<Found> {
        Disk.look(path)
    }

    fn lock(&self, path: &Path) -> io::Result<Option<Held>> {
        Disk.lock(path)
    }
}

/// What a run begins with where there is nothing to go on with.
fn fresh() -> Session {
    session(77.0)
}

fn open(store: &mut Store, path: &Path) -> Result<Opened> {
    let opened = store.reader(path)()?;
    store.remember(path);
    Ok(opened)
}

/// Keeps the session of a window that is closed then.
fn keep(folder: &Folder, theta_deg: f64) {
    folder.store().keep_now(&session(theta_deg)).unwrap();
}

fn session(theta_deg: f64) -> Session {
    Session {
        theta_deg,
        ..Session::default()
    }
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
            let files = Failing::after(works, is_killed);
            let mut failing = Store::new(Arc::new(files), None);
            let line = failing.save(&path, &session(30.0)).unwrap_err().to_string();
            assert!(line.contains("mine.toml") && !line.contains('\n'), "{line}");
            // The last good one is there, in its place or as the backup of a killed program.
            let found = [path.clone(), backup(&path)]
                .into_iter()
                .find(|path| path.exists())
                .unwrap();
            let opened = open(&mut folder.store(), &found).unwrap();
            assert_eq!(opened, Opened::from(session(20.0)), "{works}");
            // What a killed program left beside it is in nobody's way.
            let mut store = folder.store();
            store.save(&path, &session(40.0)).unwrap();
            let opened = open(&mut store, &path).unwrap();
            assert_eq!(opened, Opened::from(session(40.0)));
            let partial = |name: &String| name.ends_with(".partial");
            let is_left = folder.names().iter().any(partial);
            assert_eq!(is_left, is_killed, "only a killed program leaves any");
        }
    }
}

#[test]
fn a_file_of_the_users_that_cannot_be_read_is_kept_beside_the_new_one() {
    let folder = Folder::new("aside");
    let path = folder.file("mine.toml");
    fs::write(&path, "version = 7").unwrap();
    let aside = folder.store().save(&path, &session(10.0)).unwrap();
    assert_eq!(aside, Some(with_suffix(&path, ".unreadable-1")));
    assert_eq!(fs::read_to_string(aside.unwrap()).unwrap(), "version = 7");
    // Nothing but files is moved.
    let line = folder.store().save(&folder.0, &session(1.0)).unwrap_err();
    assert!(line.to_string().contains("directory"), "{line}");
    assert!(folder.store().export(&folder.0, b"x").is_err());
}

#[test]
fn files_of_the_wrong_kind_are_refused_in_a_line() {
    let folder = Folder::new("wrong");
    let text = session(10.0).to_toml().unwrap();
    let huge = "# ".to_owned() + &"x".repeat(MAX_TEXT as usize);
    let newer = text.replace("version = 3", "version = 7");
    let cases: [(&str, &[u8], &str); 8] = [
        ("picture.png", b"\x89PNG\r\n\x1a\n\xff\xfe", "no text"),
        ("letter.txt", b"Dear all,\nsee below.", "line 1"),
        ("empty.toml", b"", "there is nothing in it"),
        ("huge.toml", huge.as_bytes(), "more than 32 MiB"),
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
            "a session of version 7; this program reads up to version 3",
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
        let line = open(&mut store, &path).unwrap_err().to_string();
        assert!(line.contains(name) && line.contains(expected), "{line}");
        assert!(!line.contains('\n'), "{line}");
    }
    assert!(open(&mut store, &folder.file("nowhere.toml")).is_err());
    assert!(open(&mut store, &folder.0).is_err(), "a folder");
    assert!(store.recent().is_empty());
}

#[test]
fn a_folder_that_cannot_be_written_is_told_of() {
    let folder = Folder::new("locked");
    // A file where the folder should be is refused to everybody, the administrator included.
    fs::write(folder.file("data"), "a file").unwrap();
    let own = folder.file("data");
    let mut store = Store::new(Arc::new(Disk), Some(own.clone()));
    let line = store.keep_now(&session(1.0)).unwrap_err().to_string();
    assert!(line.contains("data"), "{line}");
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
    open(&mut store, &paths[4]).unwrap();
    let again = folder.store();
    assert_eq!(again.recent(), store.recent());
    assert_eq!(again.recent().len(), MAX_RECENT);
    assert_eq!(again.recent()[..2], [paths[4].clone(), paths[9].clone()]);
    fs::write(folder.file(PREFERENCES), "recent = 3").unwrap();
    assert!(folder.store().recent().is_empty());
}

/// Every material that the trade-off offers in place of this one.
fn offered(id: &str) -> Vec<Material> {
    let material = &library::find(id).unwrap().material;
    let study = Study::new(material, None);
    let is_of_material = |family: &&dyn Family| family.is_of_material();
    let families: Vec<&dyn Family> = FAMILIES.into_iter().filter(is_of_material).collect();
    let report = measure(&study, &families, NoClock, &|| true, &mut |_, _| {}).unwrap();
    let points = report.families.into_iter().flat_map(|family| family.points);
    points.filter_map(|point| point.material).collect()
}

#[test]
fn all_that_the_trade_off_offers_is_kept_saved_and_opened_again() {
    let folder = Folder::new("offers");
    let path = folder.file("mine.toml");
    // What may be turned has the largest tables of three coordinates, what may not those of four.
    for id in ["chalk", "gold", "brushed_steel"] {
        let offered = offered(id);
        let tables = offered.iter().filter(|material| material.has_data());
        let tables: Vec<Material> = tables.cloned().collect();
        assert!(tables.len() > 3, "{id}");
        let each = offered.into_iter().map(|material| vec![material]);
        // Each beside the one it stands for, and as many as a session takes.
        let all: Vec<Material> = tables
            .iter()
            .rev()
            .cycle()
            .take(MAX_MATERIALS)
            .cloned()
            .collect();
        for materials in each.chain([tables, all]) {
            let session = Session {
                materials: Materials::new(materials).unwrap(),
                ..Session::default()
            };
            session.require_fit().unwrap();
            let mut store = folder.store();
            store.save(&path, &session).unwrap();
            store.keep_now(&session).unwrap();
            let mut opened = open(&mut store, &path).unwrap().into_session();
            opened.fetch(&nothing);
            assert!(opened == session, "{id}");
            drop(store);
            let (mut restored, said) = folder.restored();
            restored.as_mut().unwrap().fetch(&nothing);
            assert!(
                restored == Some(session) && said.is_empty(),
                "{id}: {said:?}"
            );
        }
    }
}
