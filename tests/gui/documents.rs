//! Which file a session belongs to: the one that it was opened from or saved to, and no other that comes in its place.

use std::cell::RefCell;
use std::path::PathBuf;
use std::rc::Rc;

use brdf_explorer::study::lessons::{Lesson, lessons, read as read_lesson};
use brdf_explorer::study::store::{Answer, FileDialog};
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::files::{Script, drop_file, press, read, titles, work_in};
use super::{Folder, session, show_decades, window};

/// A window with a session that has a file, and what answers its dialogs.
fn saved(folder: &Folder) -> (Harness<'static, App>, PathBuf, Rc<RefCell<Script>>) {
    let path = folder.file("mine.toml");
    let mut harness = window("gold");
    let script = work_in(&mut harness, folder);
    script.borrow_mut().answers.push(Answer::File(path.clone()));
    press(&mut harness, Modifiers::COMMAND, Key::S);
    harness.run_steps(3);
    assert_eq!(read(&path), harness.state().session);
    (harness, path, script)
}

fn asking() -> Lesson {
    let text = "+++\ntitle = \"T\"\n[state]\nmaterials = [\"chalk\"]\n+++\n## One\n\n```ask\nquestion = \"Q\"\n\
        choices = [{ text = \"Yes\", when = \"1 < 2\" }, { text = \"No\", when = \"1 > 2\", shows = { light = 70 } }]\n```\n\nSo.\n\n\
        ```state\nmaterials = [\"phong\"]\n```\n\n## Two\n\nMore.\n";
    read_lesson(text, "t", "t.md").unwrap()
}

/// A way to put a session in place of another, with its name.
type Replace<'a> = (&'a str, &'a dyn Fn(&mut Harness<'static, App>));

/// Nothing that comes in place of a session is written over its file, and undo brings session and file back.
#[test]
fn what_comes_in_place_of_a_session_is_not_its_file() {
    let folder = Folder::new("documents");
    let (mut harness, path, script) = saved(&folder);
    let mine = harness.state().session.clone();
    let pasted = Event::Paste(session(&["chalk", "ward"]).to_toml().unwrap());
    let ways: [Replace<'_>; 4] = [
        ("new", &|harness| press(harness, Modifiers::COMMAND, Key::N)),
        ("lesson", &|harness| {
            harness.state_mut().open_lesson(&lessons()[3], 1);
        }),
        ("step", &|harness| {
            press(harness, Modifiers::NONE, Key::PageDown);
        }),
        ("paste", &|harness| harness.event(pasted.clone())),
    ];
    for (way, replace) in ways {
        replace(&mut harness);
        harness.run();
        assert!(harness.state().session != mine, "{way}");
        let asked = script.borrow().asked.len();
        press(&mut harness, Modifiers::COMMAND, Key::S);
        assert_eq!(read(&path), mine, "{way}");
        let dialogs = script.borrow().asked[asked..].to_vec();
        let expected = FileDialog::Save("session.toml".to_owned());
        assert_eq!(dialogs, [expected], "{way}");
        script.borrow_mut().answers.push(Answer::Dismissed);
        harness.run_steps(3);
        press(&mut harness, Modifiers::COMMAND, Key::Z);
        assert_eq!(harness.state().session, mine, "{way}");
        // It is itself again: it is saved to its file without being asked for one.
        let asked = script.borrow().asked.len();
        press(&mut harness, Modifiers::COMMAND, Key::S);
        assert_eq!(
            (read(&path), script.borrow().asked.len()),
            (mine.clone(), asked),
            "{way}"
        );
    }
    // Opened files have each their own.
    let other = folder.file("other.toml");
    std::fs::write(&other, session(&["chalk"]).to_toml().unwrap()).unwrap();
    drop_file(&mut harness, &other);
    assert_eq!(titles(&harness), ["Chalk"]);
    show_decades(&mut harness);
    harness.run();
    press(&mut harness, Modifiers::COMMAND, Key::S);
    assert_eq!(read(&other), harness.state().session);
    assert_eq!(read(&path), mine);
}

/// What a lesson does to a session that was opened beside it is not that session's either.
#[test]
fn a_lesson_makes_no_change_to_the_file_of_another_session() {
    for way in ["answer", "back", "again"] {
        let folder = Folder::new(&format!("documents-{way}"));
        let (mut harness, path, script) = saved(&folder);
        let mine = harness.state().session.clone();
        harness.state_mut().open_lesson(&asking(), 0);
        harness.run();
        if way == "back" {
            harness.get_by_label("B: No").click();
            harness.run();
            harness.get_by_label("See what that means").click();
            harness.run();
        }
        drop_file(&mut harness, &path);
        assert_eq!(harness.state().session, mine);
        let button = match way {
            "answer" => "A: Yes",
            "back" => "Back to the step",
            _ => "Step from its beginning",
        };
        harness.get_by_label_contains(button).click_accesskit();
        harness.run();
        assert!(harness.state().session != mine, "{way}");
        let asked = script.borrow().asked.len();
        press(&mut harness, Modifiers::COMMAND, Key::S);
        assert_eq!(script.borrow().asked.len(), asked + 1, "{way}");
        assert_eq!(read(&path), mine, "{way}");
    }
}

/// A lesson that was saved keeps its file while it is worked at, until the next step comes.
#[test]
fn the_state_of_a_step_has_a_file_once_it_is_saved() {
    let folder = Folder::new("documents-step");
    let mut harness = window("gold");
    let script = work_in(&mut harness, &folder);
    harness.state_mut().open_lesson(&asking(), 0);
    harness.run();
    let path = folder.file("lesson.toml");
    script.borrow_mut().answers.push(Answer::File(path.clone()));
    press(&mut harness, Modifiers::COMMAND, Key::S);
    harness.run_steps(3);
    harness.get_by_label("A: Yes").click();
    harness.run();
    assert!(harness.state().session != read(&path));
    press(&mut harness, Modifiers::COMMAND, Key::S);
    assert_eq!(harness.state().session, read(&path));
    assert_eq!(script.borrow().asked.len(), 1);
    press(&mut harness, Modifiers::NONE, Key::PageDown);
    press(&mut harness, Modifiers::COMMAND, Key::S);
    assert_eq!(script.borrow().asked.len(), 2);
}
