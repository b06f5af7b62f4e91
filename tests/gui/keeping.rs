//! What is kept where things go wrong: no dialogs, no room on the disk, texts that are too long.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use brdf_explorer::bxdf::error::Error;
use brdf_explorer::bxdf::material::Component;
use brdf_explorer::bxdf::resource::Decoded;
use brdf_explorer::bxdf::table::{Shape, Table};
use brdf_explorer::bxdf::{Material, Resource};
use brdf_explorer::study::export::Format;
use brdf_explorer::study::export::figure::Use;
use brdf_explorer::study::platform;
use brdf_explorer::study::session::Session;
use brdf_explorer::study::store::{Answer, Disk, Files, Found, Held};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::export;
use eframe::App as _;
use egui::{Event, Key, Modifiers, OutputCommand, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::files::{press, read, titles, work_in, work_on};
use super::{Folder, material, session, show_decades, window, window_of};

/// More than reading takes, on any machine.
const PATIENCE: Duration = Duration::from_mins(2);

/// Types a path in place of the one in the field, and presses Enter.
fn answer(harness: &mut Harness<'_, App>, path: &Path) {
    press(harness, Modifiers::COMMAND, Key::A);
    harness.event(Event::Text(path.display().to_string()));
    harness.run();
    press(harness, Modifiers::NONE, Key::Enter);
}

#[test]
fn where_no_dialog_opens_a_path_is_typed() {
    let folder = Folder::new("no-dialog");
    let mut harness = window("gold");
    let script = work_in(&mut harness, &folder);
    script.borrow_mut().answers.push(Answer::NoDialog);
    press(&mut harness, Modifiers::COMMAND, Key::S);
    harness.run_steps(3);
    assert!(harness.query_by_label("Path of the file").is_some());
    // What is wrong is said in the field, which stays.
    for (path, said) in [
        (folder.file("none/mine.toml"), "none is no folder"),
        (folder.file("."), "is a folder"),
    ] {
        answer(&mut harness, &path);
        assert!(harness.query_by_label_contains(said).is_some(), "{said}");
    }
    let path = folder.file("mine.toml");
    answer(&mut harness, &path);
    assert!(harness.query_by_label("Path of the file").is_none());
    assert_eq!(read(&path), harness.state().session);
    let told = format!("Saved to {}", path.display());
    assert!(harness.query_by_label(&told).is_some());
    harness.get_by_label("Hide").click();
    harness.run();
    // Nothing is asked of dialogs any more. A file that is there is replaced at the second time only.
    let before = fs::read(&path).unwrap();
    show_decades(&mut harness);
    press(&mut harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    answer(&mut harness, &path);
    assert!(
        harness
            .query_by_label_contains("is there already")
            .is_some()
    );
    assert_eq!(fs::read(&path).unwrap(), before);
    press(&mut harness, Modifiers::NONE, Key::Enter);
    assert_eq!(read(&path), harness.state().session);
    // Escape wants no file.
    press(&mut harness, Modifiers::COMMAND, Key::O);
    assert!(harness.query_by_label("Path of the file").is_some());
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert!(harness.query_by_label("Path of the file").is_none());
    press(&mut harness, Modifiers::COMMAND, Key::N);
    press(&mut harness, Modifiers::COMMAND, Key::O);
    answer(&mut harness, &path);
    harness.run();
    assert_eq!(read(&path), harness.state().session);
    assert_eq!(script.borrow().asked.len(), 1);
    // Exports ask the same way, and propose their own names in the folder used last.
    harness.get_by_label("Export Polar plot").click();
    harness.run();
    harness.get_by_label("Numbers (CSV)").click();
    harness.run();
    press(&mut harness, Modifiers::NONE, Key::Enter);
    while harness.state().is_exporting() {
        std::thread::sleep(Duration::from_millis(5));
        harness.step();
    }
    harness.run();
    assert!(folder.file("polar.csv").exists());
    assert!(harness.query_by_label_contains("polar.csv").is_some());
}

#[test]
fn it_is_said_where_the_clipboard_takes_no_picture() {
    let folder = Folder::new("no-clipboard");
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    harness.state_mut().use_clipboard(Box::new(|_, _| {
        Err(Error::Platform {
            problem: "the clipboard does not take the picture: none is there".to_owned(),
            remedy: "export it as a file".to_owned(),
        })
    }));
    harness.get_by_label("Export Polar plot").click();
    harness.run();
    harness.get_by_label("Copy picture").click();
    harness.step();
    let begin = Instant::now();
    while harness.state().is_exporting() {
        assert!(begin.elapsed() < PATIENCE);
        std::thread::sleep(Duration::from_millis(5));
        harness.step();
    }
    harness.run();
    let said = |words: &str| harness.query_by_label_contains(words).is_some();
    assert!(said("does not take the picture") && said("export it as a file"));
    assert!(!said("is in the clipboard"));
}

#[test]
fn a_picture_is_copied_as_its_file_holds_it() {
    let folder = Folder::new("copy-picture");
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    harness.get_by_label("Export Polar plot").click();
    harness.run();
    harness.get_by_label("Copy picture").click();
    let begin = Instant::now();
    let copied = loop {
        harness.step();
        let mut commands = harness.output().platform_output.commands.iter();
        let copied = commands.find_map(|command| match command {
            OutputCommand::CopyImage(image) => Some(image.clone()),
            _ => None,
        });
        if let Some(image) = copied {
            break image;
        }
        assert!(begin.elapsed() < PATIENCE);
        std::thread::sleep(Duration::from_millis(5));
    };
    let figure = super::figures::figure(session(&["gold"]), "polar", Use::Web, Theme::Light);
    let file = export::bytes(figure, Format::Png).unwrap();
    let file = image::load_from_memory(&file).unwrap().into_rgba8();
    assert_eq!(
        copied.size,
        [file.width(), file.height()].map(|side| side as usize)
    );
    let bytes: Vec<u8> = copied
        .pixels
        .iter()
        .flat_map(egui::Color32::to_array)
        .collect();
    assert!(bytes == *file.as_raw());
}

/// A disk that is full below a folder, while it is so.
struct Full {
    folder: PathBuf,
    is_full: Arc<AtomicBool>,
}

impl Files for Full {
    fn read(&self, path: &Path, limit: u64) -> io::Result<Vec<u8>> {
        Disk.read(path, limit)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        if self.is_full.load(Ordering::SeqCst) && path.starts_with(&self.folder) {
            return Err(io::ErrorKind::StorageFull.into());
        }
        Disk.write(path, bytes)
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        Disk.rename(from, to)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
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

#[test]
fn a_full_disk_is_said_at_once_and_again_at_the_end() {
    let folder = Folder::new("full-disk");
    let is_full = Arc::new(AtomicBool::new(true));
    let files = Full {
        folder: folder.file("data"),
        is_full: Arc::clone(&is_full),
    };
    let mut harness = window("gold");
    work_on(&mut harness, Arc::new(files), &folder);
    show_decades(&mut harness);
    harness.run();
    let said = "the session is not kept for the next start";
    let mut delay = Duration::MAX;
    for _ in 0..12 {
        if harness.query_by_label_contains(said).is_some() {
            break;
        }
        let outputs = &harness.output().viewport_output;
        delay = outputs[&egui::ViewportId::ROOT].repaint_delay;
        harness.step();
    }
    assert!(harness.query_by_label_contains(said).is_some());
    assert_eq!(
        delay,
        Duration::ZERO,
        "the frame that fails asks for another"
    );
    // It stays while other things are said.
    harness.event(Event::Paste("golt".to_owned()));
    harness.run();
    assert!(
        harness
            .query_by_label_contains("unknown material")
            .is_some()
    );
    assert!(harness.query_by_label_contains(said).is_some());
    // At the end it is put elsewhere, and told of.
    harness.state_mut().on_exit();
    let problem = harness.state().exit_problem();
    let line = problem.lock().unwrap().take().unwrap().to_string();
    let (_, place) = line.split_once("it is in ").unwrap();
    let place = place.split_once(": open it").unwrap().0;
    assert_eq!(read(Path::new(place)), harness.state().session);
    fs::remove_file(place).unwrap();
    // With room, it is kept by the next try, which says so, and at the end.
    is_full.store(false, Ordering::SeqCst);
    harness.run_steps(40);
    assert!(harness.query_by_label_contains(said).is_none());
    assert!(
        harness
            .query_by_label("The session is kept again")
            .is_some()
    );
    assert_eq!(
        read(&folder.file("data/session.toml")),
        harness.state().session
    );
    harness.state_mut().on_exit();
    assert!(problem.lock().unwrap().is_none());
}

/// A material with a table of so many nodes along each coordinate: from 92 on, two of them are all that a session takes.
fn long_material(nodes: usize) -> Material {
    let bxdf = material("phong").build::<f64>();
    let shape = Shape::of(nodes, true).unwrap();
    let table = Table::bake(&*bxdf, shape, u64::MAX).unwrap();
    let mut component: Component = "table".parse().unwrap();
    let decoded = Arc::new(Decoded::table(table));
    component
        .set_resource("data", Resource::inline(decoded))
        .unwrap();
    Material::from(component)
}

#[test]
fn an_edit_that_nobody_would_read_again_is_refused_when_it_is_made() {
    let folder = Folder::new("too-long");
    let mut harness = Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_max_steps(64)
        .build_eframe(|cc| App::new(cc, Session::of(long_material(92)), None, None));
    harness.run();
    let said = "MiB of text; the limit is 32 MiB";
    press(&mut harness, Modifiers::COMMAND, Key::D);
    assert_eq!(titles(&harness).len(), 2);
    assert!(harness.query_by_label_contains(said).is_none());
    let before = harness.state().session.clone();
    press(&mut harness, Modifiers::COMMAND, Key::D);
    assert!(harness.query_by_label_contains(said).is_some());
    assert_eq!(harness.state().session, before);
    // So is one that is pasted, and what is left is saved and opened.
    harness.get_by_label("Dismiss").click();
    harness.run();
    let pasted = Session::of(long_material(92));
    let text = pasted.materials.selected().to_text();
    harness.event(Event::Paste(text));
    harness.run();
    assert!(harness.query_by_label_contains(said).is_some());
    assert_eq!(harness.state().session, before);
    let script = work_in(&mut harness, &folder);
    let path = folder.file("long.toml");
    script.borrow_mut().answers.push(Answer::File(path.clone()));
    press(&mut harness, Modifiers::COMMAND, Key::S);
    harness.run_steps(3);
    assert!(read(&path) == before);
}

#[test]
fn a_long_text_is_read_while_the_window_goes_on() {
    let pasted = Session::of(long_material(48));
    let mut harness = Harness::builder()
        .with_size(egui::vec2(1280.0, 800.0))
        .with_max_steps(64)
        .build_eframe(|cc| App::new(cc, Session::default(), None, Some(platform::seconds)));
    harness.run_steps(3);
    harness.event(Event::Paste(pasted.to_toml().unwrap()));
    harness.step();
    assert!(harness.state().is_reading());
    assert_eq!(harness.state().session, Session::default());
    assert!(
        harness
            .query_by_label_contains("Reading the clipboard, 1.7 MiB")
            .is_some()
    );
    let begin = Instant::now();
    while harness.state().is_reading() {
        assert!(begin.elapsed() < PATIENCE);
        std::thread::sleep(Duration::from_millis(1));
        harness.step();
    }
    assert!(harness.state().session == pasted);
    assert!(harness.query_by_label_contains("Reading").is_none());
}

#[test]
fn text_fields_take_no_texts_that_take_seconds_to_lay_out() {
    let mut harness = window_of(&["gold"]);
    press(&mut harness, Modifiers::COMMAND, Key::K);
    harness.event(Event::Paste("save ".repeat(1 << 20)));
    harness.run();
    let said = "the pasted text is 5 MiB; a field takes 16384 bytes at most";
    assert!(harness.query_by_label_contains(said).is_some());
    assert!(
        harness
            .query_by_label("No command has these words")
            .is_none()
    );
}

#[test]
fn a_session_of_a_newer_program_is_told_of_in_lines_and_stays() {
    let folder = Folder::new("newer");
    let kept = folder.file("data/session.toml");
    fs::create_dir_all(folder.file("data")).unwrap();
    let newer = session(&["gold"]).to_toml().unwrap();
    let newer = newer.replace("version = 3", "version = 4");
    fs::write(&kept, &newer).unwrap();
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    let lines = [
        "a newer one is needed",
        "then kept as session.toml.unreadable-1",
        "this is a new session",
    ];
    let heights = lines.map(|line| harness.get_by_label_contains(line).rect().center().y);
    // Line by line at the bottom: the views keep their room.
    assert!(heights.is_sorted() && heights[0] > 690.0, "{heights:?}");
    harness.run_steps(12);
    assert_eq!(fs::read_to_string(&kept).unwrap(), newer);
    show_decades(&mut harness);
    harness.run_steps(12);
    let aside = folder.file("data/session.toml.unreadable-1");
    assert_eq!(fs::read_to_string(aside).unwrap(), newer);
    assert_eq!(read(&kept), harness.state().session);
    let told = harness.query_by_label_contains("is now session.toml.unreadable-1");
    assert!(told.is_some());
}
