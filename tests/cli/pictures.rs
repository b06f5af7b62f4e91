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
            "'--lesson <NN[.STEP]>' cannot be used with '--session <FILE|LINK>'",
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

/// A lesson that asks in every way, and needs no graphics adapter to be printed.
const ASKS: &str = "+++\ntitle = \"Asks\"\nsummary = \"S\"\n[state]\nmaterials = [\"chalk\"]\nlight = 30\nviews = [\"polar\"]\n+++\n\
    ## One\n\nHere $\\lobe{f}$ is `= f`.\n\n$$\\frac{1}{\\pi}$$\n\n- a\n- *b*\n\n\
    ```ask\nquestion = \"Where?\"\nnumber = \"angle(light)\"\ntolerance = 1\n```\n\nThere.\n\n\
    ## Two\n\n```ask\nquestion = \"Which?\"\nchoices = [{ text = \"A\", when = \"1 < 2\" }, { text = \"B\", when = \"1 > 2\" }]\n```\n\n\
    ## Three\n\n```ask\nquestion = \"Do\"\nuntil = \"angle(light) > 60\"\nsolution = { light = 75 }\n```\n\n\
    ## Four\n\nWhat is measured is another each time.\n\n```state\nviews = [\"tradeoff\"]\n```\n";

/// How many pages a document has.
fn pages(document: &[u8]) -> usize {
    let text = String::from_utf8_lossy(document);
    text.matches("/Type/Page/").count()
}

#[test]
fn a_lesson_and_its_questions_are_printed_the_same_each_time() {
    let folder = folder("paper");
    let lesson = folder.join("asks.md").display().to_string();
    std::fs::write(&lesson, ASKS).unwrap();
    let printed = |arguments: &[&str], name: &str| {
        let path = folder.join(name).display().to_string();
        super::done(&[arguments, &["-o", &path]].concat(), "");
        let document = std::fs::read(path).unwrap();
        assert!(document.starts_with(b"%PDF-"));
        document
    };
    let sheet = printed(&["render", "--lesson", &lesson], "a.pdf");
    assert_eq!(pages(&sheet), 1);
    assert!(sheet == printed(&["render", "--lesson", &lesson], "b.pdf"));
    let step = printed(&["render", "--lesson", &format!("{lesson}.4")], "step.pdf");
    assert!(step.len() < sheet.len() && pages(&step) == 1);
    let asked = ["lessons", "--sheet", &lesson];
    let questions = printed(&asked, "c.pdf");
    assert!(questions == printed(&asked, "d.pdf"));
    let answers = printed(&["lessons", "--sheet", "--answers", &lesson], "e.pdf");
    assert_eq!([pages(&questions), pages(&answers)], [1, 1]);
    assert!(questions != answers);
    let all = printed(&["lessons", "--sheet"], "all.pdf");
    assert!(pages(&all) > 2, "{}", pages(&all));
    // A step that asks nothing has no sheet of questions, and leaves no file.
    let silent = format!("{lesson}.4");
    let path = folder.join("none.pdf").display().to_string();
    let line = super::refused(&["lessons", "--sheet", &silent, "-o", &path], "");
    assert!(line.contains("asks: there is no question in it"), "{line}");
    assert!(!files_in(&folder).contains(&"none.pdf".to_owned()));
}

#[test]
fn what_no_sheet_has_is_refused() {
    for (arguments, expected) in [
        (
            "render --lesson 1 --size 9x9 -o a.pdf",
            "--size: a sheet is on A4",
        ),
        (
            "render --lesson 1 --theme dark -o a.pdf",
            "--theme: a sheet is on A4, and light",
        ),
        (
            "render -o a.pdf",
            "expected a name that ends in .png, or with --lesson in .pdf",
        ),
        ("lessons --sheet", "-o <FILE>"),
        (
            "lessons --sheet -o a.txt",
            "sheet 'a.txt': expected a name that ends in .pdf",
        ),
        ("lessons --sheet 99 -o a.pdf", "unknown lesson '99'"),
        ("lessons --sheet 1.99 -o a.pdf", "it has steps 1 to"),
        ("lessons --sheet --check -o a.pdf", "cannot be used with"),
        ("lessons --answers", "--sheet"),
        ("lessons -o a.pdf", "--sheet"),
        ("lessons 1", "'1': it goes with --check or --sheet"),
        (
            "lessons --check a.md b.md",
            "'b.md': one file or folder is checked at a time",
        ),
    ] {
        let words: Vec<&str> = arguments.split(' ').collect();
        let line = super::refused(&words, "");
        assert!(line.contains(expected), "{arguments}: {line}");
    }
}

/// A link stands where a file of a session does; one that is broken is refused in a line.
#[test]
fn a_link_is_exported_as_a_file_is() {
    use brdf_explorer::study::link;
    use brdf_explorer::study::session::Session;

    let folder = folder("links");
    let session = Session::of("phong:exponent=20".parse().unwrap());
    let made = link::to_session(&session).unwrap().fragment;
    std::fs::write(folder.join("s.toml"), session.to_toml().unwrap()).unwrap();
    let export = |given: &str, name: &str| {
        Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
            .args(["export", "--session", given, "--view", "polar", "-o", name])
            .current_dir(&folder)
            .output()
            .unwrap()
    };
    let link = format!("https://a.example/b/{made}");
    for (given, name) in [
        ("s.toml", "file.csv"),
        (&*made, "short.csv"),
        (&*link, "link.csv"),
    ] {
        let output = export(given, name);
        assert_eq!(
            (output.status.code(), super::stderr(&output)),
            (Some(0), "")
        );
        let [one, other] = ["file.csv", name].map(|name| std::fs::read(folder.join(name)).unwrap());
        assert!(!one.is_empty() && one == other, "{given}");
    }
    for (given, expected) in [
        (&link[..link.len() - 9], "cut off or damaged"),
        ("#lesson=06-lambert.2", "--lesson 06-lambert.2"),
    ] {
        let output = export(given, "none.csv");
        let message = super::stderr(&output);
        assert_eq!(output.status.code(), Some(2));
        assert!(
            message.contains(expected) && message.trim_end().lines().count() == 1,
            "{message}"
        );
    }
}
