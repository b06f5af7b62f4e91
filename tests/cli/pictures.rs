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
