//! The command line as other programs meet it: values, exit codes, messages.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test stops at what it did not expect"
)]

mod albedo;
mod bench;
mod check;
mod eval;
mod files;
#[cfg(target_os = "linux")]
mod interrupts;
mod lessons;
#[cfg(feature = "gui")]
mod pictures;
mod sample;
mod tradeoff;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use brdf_explorer::study::views::VIEWS;
use serde_json::Value as Json;

/// The columns that `eval` reads, as a header line.
const HEADER: &str = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n";

fn run_with_input(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    std::thread::scope(|scope| {
        // A program that refuses its arguments closes its input early.
        scope.spawn(move || stdin.write_all(input.as_bytes()).unwrap_or_default());
        child.wait_with_output().unwrap()
    })
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

fn stderr(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).unwrap()
}

/// Standard output of a run that must succeed without a message.
fn done(arguments: &[&str], input: &str) -> String {
    let output = run_with_input(arguments, input);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stderr(&output), "");
    stdout(&output).to_owned()
}

/// The one line of a run that must be refused.
fn refused(arguments: &[&str], input: &str) -> String {
    let output = run_with_input(arguments, input);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
    assert!(message.starts_with("error: "), "{arguments:?}: {message}");
    message.trim_end().to_owned()
}

/// An empty folder for the test `name`.
fn folder(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("cli")
        .join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

fn files_in(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name());
    let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

/// The rows of a table without its header, as fields.
fn rows(table: &str) -> Vec<Vec<&str>> {
    let lines = table.lines().skip(1);
    lines.map(|line| line.split(',').collect()).collect()
}

fn numbers(fields: &[&str]) -> Vec<f64> {
    fields.iter().map(|field| field.parse().unwrap()).collect()
}

fn json(text: &str) -> Json {
    serde_json::from_str(text).unwrap()
}

#[test]
fn materials_are_refused_with_what_is_allowed() {
    for (material, expected) in [
        (
            "lambert",
            "error: unknown material 'lambert'; nearest: lambertian_reflection",
        ),
        (
            "oren_nayar:sigma=91",
            "error: oren_nayar: sigma = 91: allowed is a number from 0 to 90 degrees",
        ),
        (
            "oren_nayar:sigam=9",
            "unknown parameter 'sigam'; nearest: sigma",
        ),
        (
            "rough_conductor:fresnel=best",
            "allowed is one of conductor, schlick, one",
        ),
        ("rough_conductor:eta=0,k=0", "may not both be 0"),
        ("oren_nayar:sigma", "'sigma' is not name=value"),
        ("lambert\nian", "error: unknown material 'lambert ian'"),
        ("", "error: unknown material ''"),
    ] {
        for verb in ["eval", "albedo"] {
            let line = refused(&[verb, material], "");
            assert!(line.contains(expected), "{line}");
        }
    }
}

#[test]
fn a_named_material_stands_wherever_a_material_may() {
    let report = json(&done(&["albedo", "gold", "--theta", "0", "--json"], ""));
    assert!(
        report["material"]
            .as_str()
            .unwrap()
            .starts_with("rough_conductor:")
    );
    let table = done(&["eval", "gold"], &format!("{HEADER}0,0,1,0,0,1\n"));
    assert_eq!(rows(&table).len(), 1);
    let report = json(&done(&["models", "--json"], ""));
    let materials = report["materials"].as_array().unwrap();
    assert!(materials.iter().any(|named| named["id"] == "gold"));
}

#[test]
fn lobes_that_create_energy_are_warned_of() {
    let folder = folder("energy");
    let lobe = "[[lobes]]\nmodel = \"lambertian_reflection\"\nreflectance = 0.6\n";
    let two = folder.join("two.toml");
    fs::write(&two, lobe.repeat(2)).unwrap();
    let path = two.to_str().unwrap();
    let output = run_with_input(&["albedo", path, "--theta", "0"], "");
    assert_eq!(output.status.code(), Some(0));
    let line = stderr(&output);
    assert_eq!(line.lines().count(), 1, "{line}");
    assert!(line.starts_with("warning: ") && line.contains("two.toml creates energy: With light"));
    let said = "degrees 20 % more leaves than arrives, because the lobes add up";
    assert!(line.contains(said), "{line}");
    assert!(stdout(&output).contains("1.200000"));
    let output = run_with_input(&["check", path], "");
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("creates energy"));
    // One lobe is warned of like several.
    fs::write(&two, format!("{lobe}weight = 3\n")).unwrap();
    let output = run_with_input(&["eval", path], HEADER);
    assert_eq!(output.status.code(), Some(0));
    let said = "80 % more leaves than arrives, because its weight is 3";
    assert!(stderr(&output).contains(said), "{}", stderr(&output));
    // One lobe, and two that share the light, are fine.
    for text in [lobe, &format!("{lobe}weight = 0.5\n{lobe}weight = 0.5\n")] {
        fs::write(&two, text).unwrap();
        done(&["albedo", path, "--theta", "0"], "");
    }
}

#[test]
fn words_are_refused_with_the_nearest() {
    for (arguments, expected) in [
        (
            &["eval", "oren_nayar", "--precision", "f16"][..],
            "error: unknown precision 'f16'; nearest: f32",
        ),
        (&["modles"], "a similar subcommand exists: 'models'"),
        (
            &["albedo", "oren_nayar", "--thete", "1"],
            "a similar argument exists: '--theta'",
        ),
        (
            &["eval"],
            "required arguments were not provided: <MATERIAL>",
        ),
    ] {
        let line = refused(arguments, "");
        assert!(line.contains(expected), "{line}");
    }
}

#[test]
fn models_lists_what_the_contract_names() {
    let report = json(&done(&["models", "--json"], ""));
    let models = report["models"].as_array().unwrap();
    let listing = done(&["models"], "");
    let categories = [
        "diffuse",
        "glossy_specular",
        "perfect_specular",
        "retro_reflective",
    ];
    for model in models {
        let id = model["id"].as_str().unwrap();
        assert!(listing.contains(id), "{id}");
        assert!(model["title"].is_string() && model["source"].is_string());
        assert!(model["properties"].is_object());
        for lobe in model["lobes"].as_array().unwrap() {
            assert!(categories.contains(&lobe["category"].as_str().unwrap()));
            assert!(["reflection", "transmission"].contains(&lobe["side"].as_str().unwrap()));
        }
        for parameter in model["parameters"].as_array().unwrap() {
            let mut keys: Vec<&String> = parameter.as_object().unwrap().keys().collect();
            keys.sort();
            let expected = [
                "choices", "default", "kind", "max", "min", "name", "scale", "soft_max",
                "soft_min", "unit",
            ];
            assert_eq!(keys, expected, "{id}");
            match parameter["kind"].as_str().unwrap() {
                "number" => {
                    assert!(parameter["default"].is_number() && parameter["max"].is_number());
                }
                "rgb" => assert_eq!(parameter["default"].as_array().unwrap().len(), 3),
                "choice" => assert!(
                    parameter["choices"]
                        .as_array()
                        .unwrap()
                        .contains(&parameter["default"])
                ),
                "data" => assert!(parameter["default"].is_null()),
                kind => assert!(kind == "bool" && parameter["default"].is_boolean()),
            }
        }
        // What is listed can be typed.
        done(&["albedo", id, "--theta", "30"], "");
    }
}

#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
        .args(["sample", "oren_nayar", "--wo", "30,0", "-n", "100000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(stderr(&output), "");
}

#[test]
fn help_and_version_are_results() {
    assert!(done(&["--help"], "").contains("Usage"));
    assert!(done(&["--version"], "").starts_with("brdf-explorer "));
    let render = done(&["render", "--help"], "");
    let words: Vec<&str> = render.split([' ', ',', '\n']).collect();
    for kind in &VIEWS {
        assert!(words.contains(&kind.id), "{} in {render}", kind.id);
    }
    #[cfg(not(feature = "gui"))]
    for words in [&[][..], &["render", "oren_nayar", "-o", "x.png"]] {
        assert!(refused(words, "").contains("this build has no window"));
    }
}
