//! Opening, saving, dropping and restoring, with the dialogs answered by the test.

use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use brdf_explorer::study::session::{MaterialEntry, Session};
use brdf_explorer::study::store::{Answer, Dialogs, Disk, FileDialog, Files, Store};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::export;
use egui::{Event, Key, Modifiers, OutputCommand, Role, ThemePreference};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::{Folder, session, show_decades, window, window_of};

/// What is asked, and what is answered, in this order.
#[derive(Default)]
pub(super) struct Script {
    pub(super) asked: Vec<FileDialog>,
    pub(super) answers: Vec<Answer>,
}

/// Dialogs that answer from a script.
struct Scripted {
    script: Rc<RefCell<Script>>,
    open: Option<FileDialog>,
}

impl Dialogs for Scripted {
    fn ask(&mut self, dialog: FileDialog) {
        self.script.borrow_mut().asked.push(dialog.clone());
        self.open = Some(dialog);
    }

    fn is_open(&self) -> bool {
        self.open.is_some()
    }

    fn answer(&mut self) -> Option<(FileDialog, Answer)> {
        let answer = self.script.borrow_mut().answers.pop()?;
        Some((self.open.take()?, answer))
    }
}

/// A file that is dropped on the window.
#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

/// Lets the application keep its own in `folder`, and returns what answers its dialogs.
pub(super) fn work_in(harness: &mut Harness<'_, App>, folder: &Folder) -> Rc<RefCell<Script>> {
    work_on(harness, Arc::new(Disk), folder)
}

pub(super) fn work_on(
    harness: &mut Harness<'_, App>,
    files: Arc<dyn Files>,
    folder: &Folder,
) -> Rc<RefCell<Script>> {
    let script = Rc::new(RefCell::new(Script::default()));
    let dialogs = Scripted {
        script: Rc::clone(&script),
        open: None,
    };
    let store = Store::new(files, Some(folder.file("data")));
    let ctx = harness.ctx.clone();
    harness
        .state_mut()
        .work_on(&ctx, store, Box::new(dialogs), export::MAKER);
    harness.run();
    script
}

pub(super) fn file_menu(harness: &mut Harness<'_, App>, items: &[&str]) {
    for item in ["File"].iter().chain(items) {
        harness.get_by_label(item).click();
        harness.run();
    }
}

pub(super) fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

pub(super) fn drop_file(harness: &mut Harness<'_, App>, path: &Path) {
    let file: Arc<dyn egui::DroppedFile + Send + Sync> = Arc::new(Dropped(path.to_owned()));
    harness.input_mut().dropped_files.push(file);
    harness.run();
}

pub(super) fn titles(harness: &Harness<'_, App>) -> Vec<String> {
    let all = &harness.state().session.materials;
    all.iter().map(MaterialEntry::title).collect()
}

pub(super) fn read(path: &Path) -> Session {
    Session::from_toml(&fs::read_to_string(path).unwrap(), "saved").unwrap()
}

#[test]
fn a_session_is_saved_and_opened() {
    let folder = Folder::new("save");
    let path = folder.file("mine.toml");
    let mut harness = window_of(&["gold", "phong"]);
    let script = work_in(&mut harness, &folder);
    file_menu(&mut harness, &["Save"]);
    let asked = FileDialog::Save("session.toml".to_owned());
    assert_eq!(script.borrow().asked, [asked]);
    script.borrow_mut().answers.push(Answer::File(path.clone()));
    harness.run_steps(3);
    assert_eq!(read(&path), harness.state().session);
    // It has a file now: nothing is asked.
    show_decades(&mut harness);
    harness.run();
    press(&mut harness, Modifiers::COMMAND, Key::S);
    assert_eq!(script.borrow().asked.len(), 1);
    assert_eq!(read(&path), harness.state().session);
    // The last good one is kept beside it.
    assert!(!read(&folder.file("mine.toml.bak")).views.is_logarithmic());
    let saved = harness.state().session.clone();

    let mut other = window("chalk");
    let script = work_in(&mut other, &Folder::new("other"));
    script.borrow_mut().answers.push(Answer::File(path.clone()));
    press(&mut other, Modifiers::COMMAND, Key::O);
    other.run_steps(3);
    assert_eq!(other.state().session, saved);
    press(&mut other, Modifiers::COMMAND, Key::Z);
    assert_eq!(titles(&other), ["Chalk"], "undo brings the other one back");
    file_menu(&mut other, &["Open recent", "mine.toml"]);
    assert_eq!(other.state().session, saved);
}

#[test]
fn a_dialog_that_is_dismissed_changes_nothing() {
    let folder = Folder::new("dismiss");
    let mut harness = window("gold");
    let script = work_in(&mut harness, &folder);
    let before = harness.state().session.clone();
    for item in ["Open…", "Save as…"] {
        script.borrow_mut().answers.push(Answer::Dismissed);
        file_menu(&mut harness, &[item]);
        harness.run_steps(2);
        assert_eq!(harness.state().session, before);
    }
    assert_eq!(script.borrow().asked.len(), 2);
}

#[test]
fn files_are_dropped_on_the_window() {
    let folder = Folder::new("drop");
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    let [material, other] = ["material.toml", "session.toml"].map(|name| folder.file(name));
    fs::write(&material, "name = \"Wall\"\n[[lobes]]\nmodel = \"phong\"").unwrap();
    fs::write(&other, session(&["chalk", "ward"]).to_toml().unwrap()).unwrap();
    drop_file(&mut harness, &material);
    assert_eq!(titles(&harness), ["Gold", "Wall"]);
    drop_file(&mut harness, &other);
    assert_eq!(titles(&harness), ["Chalk", "Ward"]);
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(titles(&harness), ["Gold", "Wall"]);
}

#[test]
fn files_that_cannot_be_read_are_told_of_and_the_session_stays() {
    let folder = Folder::new("unreadable");
    let mut harness = window_of(&["gold", "phong"]);
    work_in(&mut harness, &folder);
    let before = harness.state().session.clone();
    let whole = before.to_toml().unwrap();
    let newer = whole.replace("version = 3", "version = 9");
    for (name, bytes, said) in [
        ("letter.txt", &b"Dear all,\nsee below."[..], "line 1"),
        ("picture.png", b"\x89PNG\xff", "no text"),
        ("huge.toml", &vec![b'#'; (32 << 20) + 1], "more than 32 MiB"),
        ("cut.toml", &whole.as_bytes()[..400], "the file is cut off"),
        ("odd.toml", b"flavour = 1", "unknown field"),
        ("newer.toml", newer.as_bytes(), "a newer one is needed"),
    ] {
        let path = folder.file(name);
        fs::write(&path, bytes).unwrap();
        drop_file(&mut harness, &path);
        assert!(harness.query_by_label_contains(said).is_some(), "{name}");
        assert_eq!(harness.state().session, before, "{name}");
        harness.get_by_label("Dismiss").click();
        harness.run();
    }
}

#[test]
fn a_place_that_cannot_be_written_is_told_of() {
    let folder = Folder::new("unwritable");
    let mut harness = window("gold");
    let script = work_in(&mut harness, &folder);
    let nowhere = folder.file("no/such/folder/mine.toml");
    script.borrow_mut().answers.push(Answer::File(nowhere));
    file_menu(&mut harness, &["Save as…"]);
    harness.run_steps(3);
    assert!(harness.query_by_label_contains("mine.toml").is_some());
    assert_eq!(titles(&harness), ["Gold"]);
}

#[test]
fn the_session_is_restored_at_the_next_start() {
    let folder = Folder::new("restore");
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    show_decades(&mut harness);
    harness.run();
    // A moment passes: it is kept without being asked.
    harness.run_steps(8);
    let kept = folder.file("data/session.toml");
    assert_eq!(read(&kept), harness.state().session);
    let left = harness.state().session.clone();
    drop(harness);

    let mut next = window("chalk");
    work_in(&mut next, &folder);
    assert_eq!(next.state().session, left);
    press(&mut next, Modifiers::COMMAND, Key::Z);
    assert_eq!(next.state().session, left, "there is nothing to undo yet");

    drop(next);
    // A broken one is told of, and the one before it is taken.
    fs::write(&kept, "theta_deg = \"steep\"").unwrap();
    let mut third = window("chalk");
    work_in(&mut third, &folder);
    assert!(
        third
            .query_by_label_contains("session.toml: line 1")
            .is_some()
    );
}

#[test]
fn one_text_restores_the_whole_session() {
    let mut harness = window_of(&["gold", "phong"]);
    show_decades(&mut harness);
    harness.run();
    let copied = harness.state().session.clone();
    harness.get_by_label("File").click();
    harness.run();
    harness.get_by_label("Copy session as text").click();
    let mut text = None;
    for _ in 0..4 {
        harness.step();
        for command in &harness.output().platform_output.commands {
            if let OutputCommand::CopyText(copy) = command {
                text = Some(copy.clone());
            }
        }
    }
    file_menu(&mut harness, &["New session"]);
    assert_eq!(harness.state().session, Session::default());
    harness.event(Event::Paste(text.unwrap()));
    harness.run();
    assert_eq!(harness.state().session, copied);
}

#[test]
fn pictures_and_tests_have_no_files() {
    let mut harness = window("gold");
    assert!(!harness.state().has_files());
    press(&mut harness, Modifiers::COMMAND, Key::S);
    press(&mut harness, Modifiers::COMMAND, Key::O);
    assert!(harness.query_by_label("Dismiss").is_none());
}

#[test]
fn what_of_the_panel_is_folded_is_kept_for_the_next_run() {
    let folder = Folder::new("side");
    let is_folded = |harness: &Harness<'_, App>| harness.query_by_label("Your materials").is_none();
    let is_all_shown = |harness: &Harness<'_, App>| {
        let masking = harness.query_by_role_and_label(Role::ComboBox, "Masking");
        masking.is_some()
    };
    let mut harness = window_of(&["rough_conductor"]);
    work_in(&mut harness, &folder);
    harness.run();
    assert!(!is_folded(&harness) && !is_all_shown(&harness));
    harness.get_by_label("More parameters").click();
    harness.run();
    press(&mut harness, Modifiers::COMMAND, Key::B);
    harness.run();
    assert!(is_folded(&harness));
    let mut other = window_of(&["rough_conductor"]);
    work_in(&mut other, &folder);
    other.run();
    assert!(is_folded(&other));
    press(&mut other, Modifiers::COMMAND, Key::B);
    other.run();
    assert!(!is_folded(&other) && is_all_shown(&other));
}

#[test]
fn the_theme_is_the_systems_until_one_is_chosen_and_then_kept() {
    let folder = Folder::new("theme");
    let preference = |harness: &Harness<'_, App>| {
        let options = |options: &egui::Options| options.theme_preference;
        harness.ctx.options(options)
    };
    let mut harness = window_of(&["gold"]);
    work_in(&mut harness, &folder);
    assert_eq!(preference(&harness), ThemePreference::System);
    for (name, chosen) in [
        ("Light theme", ThemePreference::Light),
        ("Dark theme", ThemePreference::Dark),
        ("As the system theme", ThemePreference::System),
    ] {
        harness.get_by_label("Theme").click();
        harness.run();
        harness.get_by_label(name).click();
        harness.run();
        let mut other = window_of(&["gold"]);
        work_in(&mut other, &folder);
        assert_eq!(preference(&other), chosen);
    }
}

/// Chooses a kind of file in the menu of the polar plot, answers the dialog, and waits until it is written.
fn export(harness: &mut Harness<'_, App>, script: &Rc<RefCell<Script>>, kind: &str, path: &Path) {
    script
        .borrow_mut()
        .answers
        .push(Answer::File(path.to_owned()));
    for label in ["Export Polar plot", kind] {
        harness.get_by_label(label).click();
        harness.run_steps(4);
    }
    while harness.state().is_exporting() {
        std::thread::sleep(std::time::Duration::from_millis(5));
        harness.step();
    }
    harness.run();
}

#[test]
fn a_view_is_exported_from_its_menu() {
    let folder = Folder::new("export-menu");
    let mut harness = window_of(&["gold", "phong"]);
    let script = work_in(&mut harness, &folder);
    let path = folder.file("section.csv");
    export(&mut harness, &script, "Numbers (CSV)", &path);
    assert_eq!(
        script.borrow().asked,
        [FileDialog::Export("polar.csv".to_owned())]
    );
    let table = fs::read_to_string(&path).unwrap();
    assert!(table.starts_with("material,angle (degrees)") && table.contains("\nPhong,"));
    // A place that cannot be written is told of, and nothing is lost.
    export(
        &mut harness,
        &script,
        "Drawing (SVG)",
        &folder.file("none/section.svg"),
    );
    assert!(harness.query_by_label_contains("No such file").is_some());
    assert_eq!(titles(&harness), ["Gold", "Phong"]);
}
