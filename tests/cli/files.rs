//! Files as people name and save them, and what is no file of the kind that is wanted.

use std::fs;

use super::{HEADER, done, folder, json, refused};

/// A material, as text of its file.
const MINE: &str = "name = \"Mine\"\n[[lobes]]\nmodel = \"rough_conductor\"\nalpha = 0.1\n";

/// The material that `albedo` reads from `given`.
fn material_of(given: &str) -> String {
    let report = json(&done(&["albedo", given, "--theta", "0", "--json"], ""));
    report["material"].as_str().unwrap().to_owned()
}

#[test]
fn a_path_that_exists_is_a_file_whatever_it_ends_in() {
    let folder = folder("endings");
    let utf16 = |text: &str| -> Vec<u8> {
        let units = std::iter::once('\u{feff}').chain(text.chars());
        let text: String = units.collect();
        text.encode_utf16().flat_map(u16::to_le_bytes).collect()
    };
    for (name, bytes) in [
        ("GOLD.TOML", MINE.as_bytes().to_vec()),
        ("Gold.Toml", MINE.as_bytes().to_vec()),
        ("gold.txt", MINE.as_bytes().to_vec()),
        ("gold", MINE.replace('\n', "\r\n").into_bytes()),
        ("gold of mine, 2.material", MINE.as_bytes().to_vec()),
        ("marked.toml", format!("\u{feff}{MINE}").into_bytes()),
        ("utf16.toml", utf16(MINE)),
    ] {
        let path = folder.join(name);
        fs::write(&path, bytes).unwrap();
        assert_eq!(
            material_of(path.to_str().unwrap()),
            "rough_conductor:alpha_x=0.1,alpha_y=0.1",
            "{name}"
        );
    }
    // In the folder itself: what is known by its name is that, and a path is a path.
    let here = |given: &str| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
            .args(["albedo", given, "--theta", "0", "--json"])
            .current_dir(&folder)
            .output()
            .unwrap();
        let report = json(super::stdout(&output));
        report["material"].as_str().unwrap().to_owned()
    };
    assert_eq!(here("./gold"), "rough_conductor:alpha_x=0.1,alpha_y=0.1");
    assert_eq!(here("gold.txt"), "rough_conductor:alpha_x=0.1,alpha_y=0.1");
    assert_eq!(here("gold"), material_of("gold"));
}

#[test]
fn what_is_no_material_says_what_one_is() {
    let folder = folder("no_material");
    let wanted = "a material is read from TOML text (.toml) with [[lobes]]";
    for (name, bytes, expected) in [
        (
            "lambert.binary",
            &b"\x00\x01\xff\xfe"[..],
            "holds no text; ",
        ),
        (
            "picture.png",
            b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR",
            "holds no text; ",
        ),
        ("zeros.toml", &[0; 64], "holds no text; "),
        ("empty", b"", "is empty; "),
        ("blank.toml", b" \n", "is empty; "),
        ("rows.csv", b"wo_x,wo_y\n1,2\n", "line 1: "),
        ("letter.txt", b"Dear all,\n", "line 1: "),
    ] {
        let path = folder.join(name);
        fs::write(&path, bytes).unwrap();
        let path = path.to_str().unwrap();
        for verb in ["eval", "albedo", "check", "tradeoff", "bench"] {
            let line = refused(&[verb, path], "");
            assert!(
                line.starts_with(&format!("error: {path}: {expected}")),
                "{line}"
            );
            assert!(line.ends_with(wanted), "{line}");
        }
    }
    let line = refused(&["eval", folder.to_str().unwrap()], "");
    assert!(line.ends_with(&format!("is a folder; {wanted}")), "{line}");
    // What can only be meant as a path is one.
    for missing in ["no/such", "nowhere.TOML", "./gold"] {
        let line = refused(&["eval", missing], "");
        assert!(line.starts_with(&format!("error: {missing}: ")), "{line}");
        assert!(line.contains("os error 2"), "{line}");
    }
    let line = refused(&["eval", "nowhere.binary"], "");
    assert!(line.contains("unknown material 'nowhere.binary'"), "{line}");
}

#[cfg(unix)]
#[test]
fn files_without_end_are_refused_at_the_limit() {
    for verb in ["eval", "albedo"] {
        let line = refused(&[verb, "/dev/zero"], "");
        assert!(line.contains("/dev/zero: more than 32 MiB"), "{line}");
    }
    let line = refused(&["eval", "phong", "--in", "/dev/zero"], "");
    assert!(
        line.contains("line 1 is longer than 1048576 bytes"),
        "{line}"
    );
    #[cfg(feature = "gui")]
    for verb in ["render", "export"] {
        let line = refused(&[verb, "--session", "/dev/zero", "-o", "x.png"], "");
        assert!(line.contains("/dev/zero: more than 32 MiB"), "{line}");
        let line = refused(&[verb, "--session", "/dev", "-o", "x.png"], "");
        assert!(
            line.contains("/dev: is a folder; a session is read from"),
            "{line}"
        );
        let line = refused(&[verb, "--session", "/dev/null", "-o", "x.png"], "");
        assert!(
            line.contains("/dev/null: is empty; a session is read from"),
            "{line}"
        );
    }
}

#[cfg(unix)]
#[test]
fn names_that_are_no_text_are_files_or_named() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;
    use std::process::Command;

    let folder = folder("no_text");
    let name = OsStr::from_bytes(b"g\xf6ld.toml");
    fs::write(folder.join(name), MINE).unwrap();
    fs::write(folder.join(OsStr::from_bytes(b"rows\xff")), HEADER).unwrap();
    let run = |words: &[&[u8]]| {
        let output = Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
            .args(words.iter().map(|word| OsStr::from_bytes(word)))
            .current_dir(&folder)
            .output()
            .unwrap();
        (output.status.code(), super::stderr(&output).to_owned())
    };
    let done = (Some(0), String::new());
    assert_eq!(run(&[b"albedo", b"g\xf6ld.toml", b"--theta", b"0"]), done);
    assert_eq!(run(&[b"eval", b"g\xf6ld.toml", b"--in", b"rows\xff"]), done);
    for (words, expected) in [
        (
            &[&b"eval"[..], b"g\xfcld"][..],
            "error: material 'g\u{fffd}ld': there is no such file, and other names are UTF-8 text\n",
        ),
        (
            &[
                b"eval",
                b"phong",
                b"--in",
                b"rows\xff",
                b"--precision",
                b"f\xfe",
            ],
            "error: argument 'f\u{fffd}': expected text in UTF-8\n",
        ),
        (
            &[b"albedo", b"phong", b"--theta=\xfe1", b"--phi", b"\xfd"],
            "error: argument '--theta=\u{fffd}1': expected text in UTF-8\n",
        ),
    ] {
        assert_eq!(run(words), (Some(2), expected.to_owned()));
    }
    let (code, line) = run(&[b"\xfemodels"]);
    assert!(code == Some(2) && line.contains("\u{fffd}models"), "{line}");
}

#[test]
fn nothing_in_a_file_or_an_argument_acts_on_the_terminal() {
    let folder = folder("hostile");
    let hostile = "\\u001b[31m\\u0007\\u202e";
    for (name, text) in [
        ("model.toml", format!("[[lobes]]\nmodel = \"{hostile}\"\n")),
        (
            "key.toml",
            format!("[[lobes]]\nmodel = \"phong\"\n\"{hostile}\" = 1\n"),
        ),
        (
            "value.toml",
            format!("[[lobes]]\nmodel = \"phong\"\nexponent = \"{hostile}\"\n"),
        ),
        (
            "weight.toml",
            format!("[[lobes]]\nmodel = \"phong\"\nweight = \"{hostile}\"\n"),
        ),
        ("top.toml", format!("\"{hostile}\" = 1\n")),
        ("syntax.toml", "a = \u{1b}[31m\n".to_owned()),
    ] {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        let line = refused(&["eval", path.to_str().unwrap()], "");
        assert!(!line.chars().any(char::is_control), "{line:?}");
        assert!(!line.contains('\u{202e}'), "{line:?}");
    }
    let long = "x".repeat(100_000);
    let escape = "\u{1b}[2J";
    for words in [
        &["eval", escape][..],
        &["eval", &format!("phong:{escape}=1")],
        &["eval", &format!("phong:exponent={escape}")],
        &["eval", "phong", "--precision", escape],
        &["eval", "phong", "--in", escape],
        &[&format!("--{escape}")],
        &[escape],
        &["sample", "phong", "--wo", escape, "-n", "1"],
        &["tradeoff", "phong", "--tolerance", escape],
        &["eval", &long],
        &["eval", &format!("phong:{long}=1")],
        &["eval", &format!("phong:exponent={long}")],
        &["eval", "phong", "--precision", &long],
        &[&format!("--{long}")],
        &[&long],
        &["albedo", "phong", "--theta", &long],
    ] {
        let line = refused(words, "");
        assert!(!line.chars().any(char::is_control), "{line:?}");
        assert!(line.chars().count() < 2500, "{}", line.len());
    }
    let rows = format!("{HEADER}{escape},0,1,0,0,1\n");
    let line = refused(&["eval", "phong"], &rows);
    assert_eq!(line, "error: line 2: wo_x = '\\u{1b}[2J' is not a number");
}

#[test]
fn a_negative_number_is_answered_as_a_number() {
    for (words, expected) in [
        (
            &["tradeoff", "phong", "--tolerance", "-1"][..],
            "error: tolerance '-1': expected a number, 0 or more",
        ),
        (
            &["bench", "phong", "--threads", "-1"],
            "error: --threads '-1': expected a whole number from 1 to 1024",
        ),
        (
            &["check", "--all", "--points", "-1"],
            "error: '-1': expected a whole number",
        ),
        (
            &["albedo", "phong", "--theta", "-1"],
            "error: theta '-1': expected 0 to 180 degrees",
        ),
        (
            &["eval", "phong", "--precision", "-1"],
            "error: unknown precision '-1'; nearest: f32, f64, reference",
        ),
        (
            &["eval", "phong", "--in", "-1"],
            "error: -1: No such file or directory (os error 2)",
        ),
    ] {
        assert_eq!(refused(words, ""), expected);
    }
}

/// A link that leads back to itself is no place for a file, and nothing to be replaced.
#[cfg(unix)]
#[test]
fn nothing_is_written_over_a_link_to_itself() {
    let link = folder("circle").join("circle.csv");
    std::os::unix::fs::symlink(&link, &link).unwrap();
    let text = link.to_str().unwrap();
    let message = refused(
        &["sample", "phong", "--wo", "30,0", "-n", "8", "--out", text],
        "",
    );
    assert!(
        message.contains("a link that leads back to itself"),
        "{message}"
    );
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
}
