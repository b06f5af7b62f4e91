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

/// A step of a lesson is named as *Copy link to this step* has it.
#[test]
fn a_step_of_a_lesson_is_a_picture_of_the_window() {
    let folder = folder("lesson");
    let picture = |lesson: &str, name: &str| {
        let path = folder.join(name).display().to_string();
        let size = ["--size", "640x400", "--scale", "1.5", "-o", &path];
        let output =
            super::run_with_input(&[&["render", "--lesson", lesson][..], &size].concat(), "");
        let message = super::stderr(&output).to_owned();
        if message.contains("no graphics adapter is found") {
            return None;
        }
        assert_eq!((output.status.code(), message.as_str()), (Some(0), ""));
        let picture = image::open(&path).unwrap();
        assert_eq!([picture.width(), picture.height()], [960, 600]);
        Some(std::fs::read(path).unwrap())
    };
    let Some(first) = picture("01-scattering", "a.png") else {
        return;
    };
    assert!(picture("1.1", "b.png").unwrap() == first);
    assert!(picture("01-scattering.2", "c.png").unwrap() != first);
}

#[test]
fn what_is_no_lesson_or_more_than_one_is_refused() {
    for (arguments, expected) in [
        (
            "--lesson 01-scatering",
            "unknown lesson '01-scatering'; nearest: 01-scattering",
        ),
        (
            "--lesson 1.99",
            "step '99' of lesson '01-scattering': it has steps 1 to",
        ),
        ("--lesson 1.0", "step '0' of lesson '01-scattering'"),
        ("--lesson no-such.md", "no-such.md"),
        (
            "--lesson 1 --session a.toml",
            "'--lesson <NN[.STEP]>' cannot be used with '--session <FILE>'",
        ),
        (
            "--lesson 1 --material gold",
            "cannot be used with '--material",
        ),
        (
            "--lesson 1 --view polar",
            "cannot be used with '--view <ID>'",
        ),
        ("--lesson 1 --hold wi", "cannot be used with '--hold"),
        ("--lesson 1 --figure web", "cannot be used with '--figure"),
    ] {
        let words = arguments.split(' ');
        let words: Vec<&str> = ["render"]
            .into_iter()
            .chain(words)
            .chain(["-o", "a.png"])
            .collect();
        let line = super::refused(&words, "");
        assert!(line.contains(expected), "{arguments}: {line}");
    }
    let line = super::refused(&["render", "--lesson", "1", "-o", "a.txt"], "");
    assert!(line.contains("a name that ends in .png"), "{line}");
    let line = super::refused(&["export", "--lesson", "1", "-o", "a.svg"], "");
    assert!(line.contains("unexpected argument '--lesson'"), "{line}");
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
