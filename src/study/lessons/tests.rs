use super::*;
use crate::session::MaterialEntry;

const HEAD: &str = "+++\ntitle = \"T\"\nminutes = 5\n[state]\nmaterials = [\"chalk\", \"gold\"]\nlight = 30\n+++\n";

fn lesson(body: &str) -> Lesson {
    read(&format!("{HEAD}{body}"), "t", "t.md").unwrap()
}

fn refused(text: &str) -> String {
    read(text, "t", "t.md").unwrap_err().to_string()
}

#[test]
fn a_lesson_is_read_whole() {
    let lesson = lesson(
        "## One\n\nLook at [the *light*](#light) at `= angle(light)` degrees, $\\cos\\theta$.\n\n\
        - first\n- second\n\n$$f = \\frac{\\rho}{\\pi}$$\n\n\
        ```show\nview = \"polar\"\ncontrol = \"Fixed\"\n```\n\n\
        ```ask\nquestion = \"How much of `= angle(light)`?\"\nnumber = \"rho_dh\"\ntolerance = \"5 %\"\nhints = [\"See **here**.\"]\n```\n\n\
        It is `= rho_dh`.\n\n```state\nlight = 60\n```\n\n## Two\n\nNext.\n\n```state\nselect = 2\n```\n",
    );
    assert_eq!((lesson.title.as_str(), lesson.minutes), ("T", 5));
    let [one, two] = &lesson.steps[..] else {
        panic!("two steps");
    };
    assert_eq!((one.title.as_str(), one.line, two.line), ("One", 8, 35));
    let Block::Paragraph(spans) = &one.text[0] else {
        panic!("a paragraph");
    };
    let thing = |span: &Span| match span {
        Span::Words { style, .. } => style.thing.clone(),
        _ => None,
    };
    assert_eq!(spans.iter().filter_map(thing).count(), 2, "{spans:?}");
    assert!(matches!(&one.text[1], Block::List { first: None, items } if items.len() == 2));
    assert!(matches!(&one.text[2], Block::Formula(tex) if tex.contains("frac")));
    assert_eq!(
        one.shows,
        [
            Thing::View("polar".to_owned()),
            Thing::Control("Fixed".to_owned())
        ]
    );
    assert!(one.after.is_some() && one.answer.len() == 1);
    let ask = one.ask.as_ref().unwrap();
    assert!(
        matches!(&ask.kind, Kind::Number(number) if number.tolerance == Tolerance::Relative(0.05))
    );
    assert_eq!(check(&lesson), []);
    let text = plain(&one.text, &|number| format!("<{}>", number.text()));
    assert!(
        text.starts_with("Look at the light at <angle(light)> degrees, "),
        "{text}"
    );
}

#[test]
fn states_build_on_one_another() {
    let lesson = lesson(
        "## One\nA.\n```state\nlight = 10\n```\n## Two\nB.\n```state\nselect = 2\n```\n\
        ## Three\nC.\n```state\nfrom = \"start\"\nrotation_deg = 5.0\n```\n\
        ## Four\nD.\n```state\nfrom = \"One\"\nselect = 1\n```\n## Five\nE.\n",
    );
    let state = |index: usize| {
        let session = lesson.state_of(index).unwrap();
        let selected = session.materials.selected().title();
        (session.theta_deg, selected, session.rotation_deg)
    };
    let materials = lesson.state_of(0).unwrap().materials;
    let titles: Vec<String> = materials.iter().map(MaterialEntry::title).collect();
    let [chalk, gold] = [0, 1].map(|index: usize| titles[index].clone());
    assert_eq!(state(0), (10.0, chalk.clone(), 0.0));
    assert_eq!(state(1), (10.0, gold, 0.0));
    assert_eq!(state(2), (30.0, chalk.clone(), 5.0));
    assert_eq!(state(3), (10.0, chalk, 0.0));
    assert_eq!(state(4), state(3));
}

/// Whether each of these texts is refused with what is expected.
fn are_refused(texts: &[(String, &str)]) {
    for (text, expected) in texts {
        let line = refused(text);
        assert!(line.starts_with("t.md"), "{line}");
        assert!(
            line.contains(expected) && !line.contains('\n'),
            "{text}\n{line}"
        );
    }
}

fn step(body: &str) -> String {
    format!("{HEAD}## One\n\n{body}\n")
}

#[test]
fn broken_lessons_name_the_line_and_what_is_allowed() {
    are_refused(&[
        (String::new(), "line 1: a lesson begins with a line +++"),
        (
            "+++\ntitle = \"T\"\n".to_owned(),
            "line 1: the head has no end",
        ),
        ("+++\n+++\n## A\nB".to_owned(), "missing field `title`"),
        (
            "+++\ntitle = \"\"\n+++\n## A\nB".to_owned(),
            "an empty title",
        ),
        (
            "+++\ntitle = \"T\"\nflavour = 1\n+++\n## A\nB".to_owned(),
            "line 3: unknown field `flavour`",
        ),
        (HEAD.to_owned(), "0 steps, each a heading"),
        (
            format!("{HEAD}Before.\n"),
            "line 8: text before the first step",
        ),
        (
            format!("{HEAD}## One\n## Two\nB"),
            "line 8: the step 'One' is empty",
        ),
        (
            format!("{HEAD}## One\nA\n## One\nB"),
            "line 10: two steps are called 'One'",
        ),
        (step("### Deep"), "line 10: a heading but '## '"),
        (step("<b>so</b>"), "line 10: HTML is no part"),
        (step("![so](x.png)"), "line 10: a picture"),
        (
            step("[so](https://x.org)"),
            "line 10: a link to 'https://x.org': allowed is #light",
        ),
        (
            step("[so](#view-pola)"),
            "unknown view 'pola'; nearest: polar",
        ),
        (step("`= rho_ht`"), "line 10: unknown quantity 'rho_ht'"),
        (step("$\\frac{1}$"), "line 10: the formula"),
        (
            step("```python\nx\n```"),
            "line 10: a block 'python': allowed is state, show and ask",
        ),
        (
            step("A\n```state\n\nlight = \"x\"\n```"),
            "line 12: expected an angle in degrees",
        ),
        (
            step("A\n```state\nlight = 200\n```"),
            "line 8: theta_deg = 200: allowed is 0 to 180",
        ),
        (
            step("A\n```state\nmaterials = [\"gols\"]\n```"),
            "line 8: unknown material 'gols'",
        ),
        (
            step("A\n```state\nviews = [\"pola\"]\n```"),
            "unknown view 'pola'",
        ),
        (
            step("A\n```state\nflavour = 1\n```"),
            "unknown field `flavour`",
        ),
        (
            step("A\n```state\nfrom = \"Ome\"\n```"),
            "unknown step 'Ome'; nearest: One",
        ),
        (
            step("A\n```state\nfrom = \"One\"\n```"),
            "in a circle: 'One' on 'One'",
        ),
        (
            format!("{HEAD}## A\nA\n```state\nfrom = \"B\"\n```\n## B\nB\n"),
            "in a circle: 'A' on 'B' on 'A'",
        ),
        (
            step("A\n```show\n```"),
            "nothing to show: allowed is view, control",
        ),
        (
            step("A\n```show\nflavour = 1\n```"),
            "unknown field `flavour`",
        ),
    ]);
}

#[test]
fn broken_questions_do_too() {
    let ask = |body: &str| step(&format!("```ask\nquestion = \"Q\"\n{body}\n```"));
    are_refused(&[
        (ask(""), "a question needs one of: choices, number, until"),
        (
            ask("number = \"f\"\nuntil = \"f > 1\""),
            "a question needs one of",
        ),
        (ask("number = \"f\""), "a number needs a tolerance"),
        (
            ask("number = \"f\"\ntolerance = 0"),
            "tolerance = 0: allowed is a number above 0",
        ),
        (ask("number = \"f\"\ntolerance = \"200 %\""), "tolerance = "),
        (
            ask("number = \"flux\"\ntolerance = 1"),
            "unknown quantity 'flux'",
        ),
        (ask("until = \"f > 1\""), "needs a solution"),
        (ask("until = \"f\"\nsolution = {}"), "a comparison"),
        (
            ask("choices = [{ text = \"A\", when = \"1 > 0\" }]"),
            "at least two",
        ),
        (
            ask("number = \"f\"\ntolerance = 1\nsolution = {}"),
            "solution has no place",
        ),
        (ask("flavour = 1"), "line 12: unknown field `flavour`"),
    ]);
}

#[test]
fn what_does_not_hold_is_found() {
    let found = |body: &str| {
        let faults = check(&lesson(&format!("## One\n\n{body}\n")));
        faults
            .into_iter()
            .map(|fault| (fault.line, fault.problem))
            .collect::<Vec<_>>()
    };
    let ask = |body: &str| found(&format!("```ask\nquestion = \"Q\"\n{body}\n```"));
    let is = |faults: Vec<(usize, String)>, expected: &str| {
        assert!(
            faults
                .iter()
                .any(|(line, problem)| *line >= 8 && problem.contains(expected)),
            "{expected}: {faults:?}"
        );
    };
    is(found("`= angle(brewster)`"), "no index of refraction");
    is(
        ask("choices = [{ text = \"A\", when = \"1 > 2\" }, { text = \"B\", when = \"1 > 2\" }]"),
        "none of the choices",
    );
    is(
        ask("choices = [{ text = \"A\", when = \"1 < 2\" }, { text = \"B\", when = \"1 < 2\" }]"),
        "are both right",
    );
    is(
        ask("until = \"angle(light) > 20\"\nsolution = { light = 80 }"),
        "is so from the beginning",
    );
    is(
        ask("until = \"angle(light) > 70\"\nsolution = { light = 60 }"),
        "not so with the solution",
    );
    is(
        ask("number = \"rho_dh\"\ntolerance = 0.1\nshows = \"flavour\""),
        "cannot be put into the state",
    );
    is(
        ask("number = \"rho_dh - rho_dh\"\ntolerance = \"5 %\""),
        "is taken for right",
    );
    assert_eq!(
        ask("until = \"angle(light) > 70\"\nsolution = { light = 80 }"),
        []
    );
}

#[test]
fn typed_answers_are_graded() {
    let lesson = lesson(
        "## One\n\n```ask\nquestion = \"Q\"\nnumber = \"angle(light)\"\ntolerance = 1\n```\n",
    );
    let ask = lesson.steps[0].ask.as_ref().unwrap();
    let Kind::Number(number) = &ask.kind else {
        panic!("a number");
    };
    assert_eq!(number.unit, "degrees");
    let scenes = Scenes::of(&lesson.state_of(0).unwrap());
    for (text, expected) in [
        ("30", Verdict::Right),
        (" 30,9 ", Verdict::Right),
        ("3.1e1", Verdict::Right),
        ("31.1", Verdict::Wrong),
    ] {
        assert_eq!(number.grade_text(text, &scenes), Ok(expected), "{text}");
    }
    for text in ["", "thirty", "nan", "1e999", "30 degrees"] {
        let verdict = number.grade_text(text, &scenes).unwrap();
        assert!(
            matches!(verdict, Verdict::Unreadable(line) if line.contains("in degrees")),
            "{text}"
        );
    }
    assert_eq!(typed_number("12,5 %"), Some(0.125));
}

/// Every lesson and every question of the program is there, and holds what it says.
#[test]
fn the_lessons_of_the_program_are_whole() {
    for (folder, all) in [("lessons", lessons()), ("questions", questions())] {
        let path = format!("{}/../../assets/{folder}", env!("CARGO_MANIFEST_DIR"));
        let files = std::fs::read_dir(path).unwrap().filter_map(|entry| {
            let name = entry.unwrap().file_name().into_string().unwrap();
            name.strip_suffix(".md")
                .filter(|id| *id != "README")
                .map(str::to_owned)
        });
        let mut ids: Vec<String> = files.collect();
        ids.sort_unstable();
        let read: Vec<&str> = all.iter().map(|lesson| lesson.id.as_str()).collect();
        assert_eq!(
            ids, read,
            "a file of assets/{folder} cannot be read: lessons --check says why"
        );
        for lesson in all {
            assert_eq!(check(lesson), [], "{}", lesson.id);
        }
    }
}

#[test]
fn a_folder_loads_what_can_be_read() {
    let folder = std::env::temp_dir().join(format!("lessons-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write("b.md", &format!("{HEAD}## One\nA.\n"));
    write("a.md", "no lesson");
    write("README.md", "about");
    let shelf = Shelf::open(&folder).unwrap();
    assert_eq!(shelf.lessons.len(), 1);
    assert_eq!(shelf.problems.len(), 1);
    assert!(
        shelf.problems[0].contains("a.md: line 1: a lesson begins"),
        "{:?}",
        shelf.problems
    );
    assert!(Shelf::open(&folder.join("a.md")).is_err());
    assert_eq!(
        Shelf::open(&folder.join("b.md")).unwrap().lessons[0].id,
        "b"
    );
    std::fs::remove_file(folder.join("b.md")).unwrap();
    std::fs::remove_file(folder.join("a.md")).unwrap();
    let line = Shelf::open(&folder).unwrap_err().to_string();
    assert!(line.contains("there is no lesson in it"), "{line}");
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(Shelf::open(&folder).is_err());
}
