//! Materials whose values come from files or were baked: dropped, saved with all, moved, missing, found again.

use std::fs;

use brdf_explorer::bxdf::resource::{Content, Recipe};
use brdf_explorer::bxdf::table::{Shape, Table};
use brdf_explorer::bxdf::{Component, Material, Resource};
use brdf_explorer::study::session::Session;
use brdf_explorer::study::store::{Answer, FileDialog};
use brdf_explorer::ui::app::App;
use egui::{Event, Key, Modifiers, OutputCommand};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::files::{drop_file, file_menu, press, titles, work_in};
use super::{Folder, material, window};

/// A table of a material, large enough to be no part of a text, and its recipe.
pub(super) fn table(id: &str) -> (Recipe, Table) {
    let material = material(id);
    let shape = Shape::of(24, true).unwrap();
    let table = Table::bake(&*material.build::<f64>(), shape, u64::MAX).unwrap();
    (material.recipe(shape).unwrap(), table)
}

fn baked(id: &str) -> Material {
    let (recipe, table) = table(id);
    let mut component: Component = "table".parse().unwrap();
    component
        .set_resource("data", Resource::baked(recipe, table))
        .unwrap();
    component.into()
}

pub(super) fn says(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn a_dropped_table_is_a_material_that_a_moved_session_misses_and_finds_again() {
    let (from, to) = (Folder::new("data-from"), Folder::new("data-to"));
    let file = from.file("measured.table");
    fs::write(&file, table("chalk").1.to_string()).unwrap();
    let mut harness = window("gold");
    let script = work_in(&mut harness, &from);
    drop_file(&mut harness, &file);
    harness.run_steps(3);
    assert_eq!(titles(&harness), ["Gold", "measured"]);
    assert!(says(&harness, "measured.table"));
    let answers = [from.file("mine.toml"), from.file("whole.toml")];
    for path in answers.iter().rev() {
        script.borrow_mut().answers.push(Answer::File(path.clone()));
    }
    file_menu(&mut harness, &["Save as…"]);
    harness.run_steps(3);
    file_menu(&mut harness, &["Save with data…"]);
    harness.run_steps(3);
    let asked = FileDialog::SaveWithData("mine.toml".to_owned());
    assert_eq!(script.borrow().asked.last(), Some(&asked));
    let [by_name, whole] = answers.map(|path| fs::read_to_string(path).unwrap());
    assert!(by_name.contains("file = \"measured.table\"") && by_name.len() < 8000);
    assert!(whole.len() > 100_000);

    let moved = to.file("mine.toml");
    fs::write(&moved, by_name).unwrap();
    let mut other = window("phong");
    work_in(&mut other, &to);
    drop_file(&mut other, &moved);
    other.run_steps(3);
    assert_eq!(titles(&other), ["Gold", "measured"]);
    assert!(says(&other, "measured.table is missing"));
    assert!(says(&other, "measured is not shown"));
    assert_eq!(other.state().session.materials.shown().count(), 1);
    // Where the file comes back, it is read at a click, and that can be undone.
    fs::copy(&file, to.file("measured.table")).unwrap();
    other.get_by_label("Read again Data").click();
    other.run_steps(4);
    assert_eq!(other.state().session.materials.shown().count(), 2);
    assert!(!says(&other, "measured is not shown"));

    fs::write(&moved, whole).unwrap();
    fs::remove_file(to.file("measured.table")).unwrap();
    let mut third = window("phong");
    work_in(&mut third, &Folder::new("data-third"));
    drop_file(&mut third, &moved);
    third.run_steps(3);
    assert_eq!(third.state().session.materials.shown().count(), 2);
    assert!(!says(&third, "missing"));
}

#[test]
fn what_was_baked_is_baked_again_and_the_copy_of_a_session_needs_nothing() {
    let folder = Folder::new("data-baked");
    let mut session = Session::of(baked("chalk"));
    let text = session.to_toml().unwrap();
    assert!(text.contains("baked = ") && text.len() < 8000);
    let waiting = Session::from_toml(&text, "s").unwrap();
    assert_eq!(waiting.materials.shown().count(), 0);
    let path = folder.file("mine.toml");
    fs::write(&path, text).unwrap();
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    drop_file(&mut harness, &path);
    harness.run_steps(3);
    assert_eq!(harness.state().session, session);
    // That it came later is no step: the one to undo is the opening.
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(titles(&harness), ["Gold"]);
    press(&mut harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(harness.state().session, session);

    harness.get_by_label("File").click();
    harness.run();
    harness.get_by_label("Copy session as text").click();
    let mut copied = None;
    for _ in 0..4 {
        harness.step();
        for command in &harness.output().platform_output.commands {
            if let OutputCommand::CopyText(text) = command {
                copied = Some(text.clone());
            }
        }
    }
    let copied = copied.unwrap();
    let mut fresh = window("phong");
    fresh.input_mut().events.push(Event::Paste(copied));
    fresh.run();
    assert_eq!(fresh.state().session, session);
    assert!(fresh.state().session.awaited().is_empty());

    // Where baking fails, the material stays and says so.
    let awaited = waiting.awaited();
    session = waiting;
    session.take_data(&awaited[0].1, &Content::Missing("no memory".into()));
    let mut failed = window("gold");
    failed.state_mut().session = session;
    failed.run();
    assert!(says(&failed, "is missing: no memory"));
}

#[test]
fn a_table_is_pasted_and_taken_away_again() {
    let mut harness = window("gold");
    let text = Table::even(0.1).to_string();
    harness.input_mut().events.push(Event::Paste(text));
    harness.run();
    assert_eq!(titles(&harness), ["Gold", "Table"]);
    assert!(harness.state().session.material().has_data());
    assert!(says(&harness, "data in the text"));
    harness.get_by_label("Reset Data").click();
    harness.run();
    assert!(!harness.state().session.material().has_data());
    assert!(says(&harness, "none: open a file"));
}
