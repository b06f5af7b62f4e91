//! `lessons`: what is listed, and what is found in a broken one.

use std::fs;

use super::*;

#[test]
fn the_lessons_of_the_program_are_listed_and_hold() {
    let text = done(&["lessons"], "");
    assert!(text.lines().any(|line| line.starts_with("01-")), "{text}");
    assert!(done(&["lessons", "--check"], "").ends_with(" 0 faults\n"));
    let found = json(&done(&["lessons", "--json"], ""));
    let lessons = found["lessons"].as_array().unwrap();
    let questions = found["questions"].as_array().unwrap();
    assert_eq!(lessons.len() + questions.len(), text.lines().count());
    let step = &lessons[0]["steps"][0];
    assert!(step["text"].is_string() && lessons[0]["minutes"].is_u64());
    let quantities = done(&["lessons", "--quantities"], "");
    assert!(
        quantities.contains("rho_dh([both|reflection|transmission])"),
        "{quantities}"
    );
}

#[test]
fn a_broken_lesson_fails_the_check_with_its_line() {
    let folder = folder("lessons");
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    let head = "+++\ntitle = \"T\"\n+++\n## One\n\n";
    write("good.md", &format!("{head}Text, `= rho_dh`.\n"));
    write(
        "asks.md",
        &format!("{head}```ask\nquestion = \"Q\"\nuntil = \"1 < 2\"\nsolution = {{}}\n```\n"),
    );
    write("broken.md", &format!("{head}`= rho_ht`\n"));
    let path = folder.display().to_string();
    let checked = run_with_input(&["lessons", "--check", &path], "");
    assert_eq!(checked.status.code(), Some(1));
    let said = stderr(&checked);
    let expected = [
        "broken.md: line 6: unknown quantity 'rho_ht'",
        "asks.md: line 6: '1 < 2' is so from the beginning",
    ];
    for line in expected {
        assert!(said.contains(line), "{said}");
    }
    assert!(stdout(&checked).starts_with("2 lessons, 2 steps, 1 questions, 2 faults"));
    let good = folder.join("good.md").display().to_string();
    assert!(done(&["lessons", "--check", &good], "").ends_with(" 0 faults\n"));
    refused(&["lessons", "--check", "no-such.md"], "");
}
