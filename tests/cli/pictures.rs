//! Pictures where nothing of the environment is set.

use std::process::Command;

use super::{files_in, folder};

#[test]
fn an_empty_environment_adds_no_line() {
    let folder = folder("empty_environment");
    for (verb, name) in [
        ("render", "a.png"),
        ("export", "b.png"),
        ("export", "c.svg"),
        ("export", "d.csv"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
            .args([
                verb,
                "--material",
                "phong",
                "--view",
                "polar",
                "--size",
                "200x150",
                "-o",
                name,
            ])
            .env_clear()
            .current_dir(&folder)
            .output()
            .unwrap();
        let message = super::stderr(&output);
        if message.contains("no graphics adapter is found") {
            assert_eq!(message.lines().count(), 1, "{message}");
            continue;
        }
        assert_eq!(
            (output.status.code(), message),
            (Some(0), ""),
            "{verb} {name}"
        );
        assert!(files_in(&folder).contains(&name.to_owned()));
    }
    // A failure keeps its exit code and its one line.
    let output = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
        .args(["render", "--size", "0", "-o", "x.png"])
        .env_clear()
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(super::stderr(&output).lines().count(), 1);
}

#[test]
fn figures_are_of_one_view_in_a_size_of_their_own() {
    for (arguments, expected) in [
        (
            &["render", "--figure", "slide", "-o", "a.png"][..],
            "error: --figure slide: a figure is of one view: name it with --view",
        ),
        (
            &["render", "--figure", "column", "-o", "a.png"],
            "name it with --view",
        ),
        (
            &["render", "--figure", "poster", "-o", "a.png"],
            "unknown figure 'poster'; nearest: slide",
        ),
        (
            &["export", "--figure", "web", "--size", "9x9", "-o", "a.svg"],
            "--size goes with --figure screen only",
        ),
        (
            &["export", "--figure", "web", "-o", "a.csv"],
            "--figure: a figure is a picture, whose name ends in one of: png, svg",
        ),
    ] {
        let line = super::refused(arguments, "");
        assert!(line.contains(expected), "{line}");
    }
}

#[test]
fn a_drawing_of_a_column_is_light_and_88_mm_wide() {
    let folder = folder("column");
    let path = folder.join("a.svg");
    let arguments = ["export", "--view", "cartesian", "--figure", "column", "-o"];
    super::done(&[&arguments[..], &[path.to_str().unwrap()]].concat(), "");
    let drawing = std::fs::read_to_string(path).unwrap();
    assert!(drawing.contains("width=\"88.00mm\""));
    let ground = "<rect x=\"0\" y=\"0\" width=\"400\"";
    let ground = drawing.lines().find(|line| line.starts_with(ground));
    assert!(ground.unwrap().contains("fill=\"#fafaf7\""), "{ground:?}");
}
