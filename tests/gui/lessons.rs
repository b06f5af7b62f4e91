//! Lessons, gone through in the window.

use brdf_explorer::study::lessons::{Kind, Lesson, lessons, questions, read};
use brdf_explorer::study::session::Session;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::headless::unknown_controls;
use egui::{Key, Modifiers, Role, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

fn window(size: [u32; 2]) -> Harness<'static, App> {
    super::picture(Session::default(), None, size, Theme::Dark).controls()
}

fn example() -> Lesson {
    let text = include_str!("../../assets/lessons/README.md");
    let (_, behind) = text.split_once("````markdown\n").unwrap();
    let (lesson, _) = behind.split_once("````\n").unwrap();
    read(lesson, "example", "README.md").unwrap()
}

/// The lesson that the documentation teaches with is one, and is gone through by the keyboard alone.
#[test]
fn the_example_is_gone_through_by_keys() {
    let mut harness = window([1280, 800]);
    harness.state_mut().open_lesson(&example(), 0);
    harness.run();
    let chosen = |harness: &Harness<'_, App>| harness.query_by_label("✔ Right").is_some();
    // From letter to letter, until the right one has the focus.
    let wanted = "B: It grows about fourfold";
    harness.get_by_label(wanted).focus();
    harness.run();
    harness.key_press(Key::Space);
    harness.run();
    assert!(chosen(&harness));
    assert!(
        harness
            .state()
            .session
            .to_toml()
            .unwrap()
            .contains("alpha_x=0.2")
    );
    harness.key_press(Key::PageDown);
    harness.run();
    assert!(harness.query_by_label("Do it").is_some());
    assert!(!chosen(&harness));
    // The state that is asked for is seen as soon as it is there.
    let solution = "rough_conductor:fresnel=one,alpha=.05".parse().unwrap();
    harness
        .state_mut()
        .session
        .materials
        .selected_mut()
        .material = solution;
    harness.run();
    assert!(chosen(&harness));
    harness.key_press(Key::PageUp);
    harness.run();
    assert!(chosen(&harness), "what was answered stays so");
    // All of it is undone like anything else.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert!(
        harness.query_by_label("Do it").is_some() || harness.query_by_label("Predict").is_some()
    );
}

#[test]
fn a_wrong_answer_shows_what_it_means_and_goes_back() {
    let text = "+++\ntitle = \"T\"\n[state]\nmaterials = [\"chalk\"]\nlight = 30\n+++\n## One\n\n\
        ```ask\nquestion = \"Where?\"\nnumber = \"angle(light)\"\ntolerance = 1\nshows = \"light\"\nhints = [\"Look.\"]\n```\n\nSo.\n";
    let lesson = read(text, "t", "t.md").unwrap();
    let mut harness = window([1024, 640]);
    harness.state_mut().open_lesson(&lesson, 0);
    harness.run();
    harness.get_by_label("Hint").click();
    harness.run();
    assert!(harness.query_by_label("Look.").is_some());
    let answer = |harness: &mut Harness<'_, App>, text: &str| {
        let field = harness.get_by_role_and_label(Role::TextInput, "Your answer");
        field.focus();
        harness.run();
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness
            .get_by_role_and_label(Role::TextInput, "Your answer")
            .type_text(text);
        harness.run();
        harness.get_by_label("Answer").click();
        harness.run();
    };
    answer(&mut harness, "steep");
    assert!(
        harness
            .query_by_label_contains("'steep' is no number")
            .is_some()
    );
    answer(&mut harness, "70");
    assert!(
        harness
            .query_by_label("✖ Not within the tolerance")
            .is_some()
    );
    harness.get_by_label("See what that means").click();
    harness.run();
    assert_eq!(harness.state().session.theta_deg, 70.0);
    harness.get_by_label("Back to the step").click();
    harness.run();
    assert_eq!(harness.state().session.theta_deg, 30.0);
    answer(&mut harness, "30,4");
    assert!(harness.query_by_label("✔ Right").is_some() && harness.query_by_label("So.").is_some());
}

/// Every step of every lesson stands in a small window.
#[test]
fn every_step_stands_in_the_window() {
    let mut harness = window([1024, 640]);
    for lesson in lessons().iter().chain(questions()) {
        for (index, step) in lesson.steps.iter().enumerate() {
            harness.state_mut().open_lesson(lesson, index);
            harness.run_ok();
            let place = format!("{} {}", lesson.id, step.title);
            let is_there = harness.query_all_by_label(&step.title).next().is_some();
            assert!(is_there, "{place}");
            if let Some(Kind::Choice(choices)) = step.ask.as_ref().map(|ask| &ask.kind) {
                let letters = (b'A'..).map(char::from).take(choices.len());
                for letter in letters {
                    let name = format!("{letter}: ");
                    let found = harness.query_all_by_label_contains(&name).next();
                    assert!(found.is_some(), "{place}: {name}");
                }
            }
        }
    }
}

#[test]
fn controls_that_are_not_there_are_found() {
    for lesson in lessons().iter().chain(questions()) {
        assert_eq!(unknown_controls(lesson), [], "{}", lesson.id);
    }
    let text = "+++\ntitle = \"T\"\n+++\n## One\n\n[A](#control-Fourr%20kinds) and [B](#control-Four%20kinds).\n";
    let lesson = read(text, "t", "t.md").unwrap();
    let faults = unknown_controls(&lesson);
    let [fault] = &faults[..] else {
        panic!("{faults:?}");
    };
    assert_eq!(fault.line, 4);
    assert!(
        fault.problem.contains("nearest: Four kinds"),
        "{}",
        fault.problem
    );
}

#[test]
fn lessons_are_listed_and_found() {
    let mut harness = window([1280, 800]);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::L);
    harness.run();
    let first = &lessons()[0];
    assert!(harness.query_by_label(&first.title).is_some());
    harness
        .get_by_role_and_label(Role::TextInput, "Find a lesson or a question")
        .focus();
    harness.run();
    harness
        .get_by_role_and_label(Role::TextInput, "Find a lesson or a question")
        .type_text("no such thing");
    harness.run();
    assert!(harness.query_by_label(&first.title).is_none());
    assert!(harness.query_by_label("Nothing of the kind").is_some());
}

/// What a screen reader reads of the panel, in its order: texts, and controls by their names.
fn read_aloud(harness: &Harness<'_, App>) -> Vec<String> {
    let nodes = harness.root().children_recursive();
    let texts = nodes.filter_map(|node| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value())
    });
    texts.collect()
}

/// The text comes before the question, that before its choices, those before what helps; and so goes the focus.
#[test]
fn a_step_is_read_and_gone_through_in_order() {
    let mut harness = window([1280, 800]);
    harness.state_mut().open_lesson(&example(), 0);
    harness.run();
    let read = read_aloud(&harness);
    let place = |wanted: &str| {
        let found = read.iter().position(|text| text.contains(wanted));
        found.unwrap_or_else(|| panic!("'{wanted}' in {read:?}"))
    };
    let order = [
        "Predict",
        "The light",
        "Question",
        "Alpha becomes half as large",
        "A: It stays",
        "B: It grows about fourfold",
        "C: It falls",
        "Hint",
        "Show the answer",
        "Copy link",
        "Next",
    ];
    let places = order.map(place);
    assert!(places.is_sorted(), "{places:?}");
    // From the first choice on, Tab goes to what is read next.
    harness.get_by_label("A: It stays").focus();
    harness.run();
    for wanted in [
        "B: It grows about fourfold",
        "C: It falls",
        "Hint",
        "Show the answer",
        "Copy link",
    ] {
        harness.key_press(Key::Tab);
        harness.run();
        let focused = harness
            .root()
            .children_recursive()
            .find(|node| node.accesskit_node().is_focused());
        let name = focused.and_then(|node| node.accesskit_node().label());
        assert!(
            name.as_deref().is_some_and(|name| name.contains(wanted)),
            "{name:?} for {wanted}"
        );
    }
    // Formulas are heard in words.
    harness.get_by_label("B: It grows about fourfold").click();
    harness.run();
    let read = read_aloud(&harness);
    let is_heard = |text: &String| text.starts_with("1 over") && text.contains("alpha squared");
    assert!(read.iter().any(is_heard), "{read:?}");
}

/// Words point at things, and things at words.
#[test]
fn words_and_things_point_at_one_another() {
    let strokes = |harness: &Harness<'_, App>| {
        let shapes = harness.output().shapes.iter();
        let circles = shapes.filter(|clipped| matches!(&clipped.shape, egui::Shape::Circle(_)));
        circles.count()
    };
    let mut harness = window([1280, 800]);
    harness.state_mut().open_lesson(&example(), 0);
    harness.run();
    let before = strokes(&harness);
    harness.hover_at(harness.get_by_label("The light").rect().center());
    harness.run();
    assert!(
        strokes(&harness) >= before + 2,
        "a ring about the light in both views"
    );
    let widest = |harness: &Harness<'_, App>| {
        let shapes = harness.output().shapes.iter();
        let widths = shapes.filter_map(|clipped| match &clipped.shape {
            egui::Shape::Path(path) => Some(path.stroke.width),
            _ => None,
        });
        widths.fold(0.0, f32::max)
    };
    let before = widest(&harness);
    harness.hover_at(harness.get_by_label("the lobe").rect().center());
    harness.run();
    let after = widest(&harness);
    assert!(after > before, "the curve: {before} to {after}");
    harness.state_mut().open_lesson(&example(), 1);
    harness.run();
    harness.hover_at(harness.get_by_label("the slider").rect().center());
    harness.run_ok();
    let slider = harness.query_all_by_label("Roughness along s (alpha)");
    let slider = slider.map(|node| node.rect()).next().unwrap();
    let rings = harness
        .output()
        .shapes
        .iter()
        .filter_map(|clipped| match &clipped.shape {
            egui::Shape::Rect(rect) if rect.stroke.width > 2.0 => Some(rect.rect),
            _ => None,
        });
    let mut near = rings.filter(|ring| ring.contains_rect(slider));
    assert!(near.next().is_some(), "a frame about {slider}");
}

/// Whatever has the keyboard in one step, keys lead on from it: no field of a step is taken for a button of the next.
#[test]
fn page_down_leads_through_every_lesson() {
    for lesson in lessons() {
        let mut harness = window([1280, 800]);
        harness.state_mut().open_lesson(lesson, 0);
        harness.run();
        for step in 2..=lesson.steps.len() {
            // As after a step that asks for a number.
            let fields = harness.query_all_by_label("Your answer");
            let field = fields.into_iter().next();
            if let Some(field) = field {
                field.focus();
                harness.run();
                harness.key_press(Key::Escape);
                harness.run();
            }
            harness.key_press(Key::PageDown);
            harness.run();
            let at = harness.state().step_link();
            assert_eq!(at.as_deref(), Some(&*format!("{}.{step}", lesson.id)));
        }
    }
}

/// The half vector is drawn by nothing else: it has a mark in each of the views that show light and viewer.
#[test]
fn words_point_at_the_half_vector() {
    let text = "+++\ntitle = \"T\"\n[state]\nmaterials = [\"brass\"]\nlight = 20\nviewer = 50\n\
        views = [\"polar\", \"lobe3d\", \"hemisphere\"]\n+++\n## One\n\nHere [the half vector](#h) is shown.\n";
    let lesson = read(text, "t", "t.md").unwrap();
    let mut harness = window([1900, 900]);
    harness.state_mut().open_lesson(&lesson, 0);
    harness.run();
    let names = |harness: &Harness<'_, App>| {
        let shapes = harness.output().shapes.iter();
        let texts = shapes.filter(|clipped| match &clipped.shape {
            egui::Shape::Text(text) => text.galley.text() == "h",
            _ => false,
        });
        texts.count()
    };
    assert_eq!(names(&harness), 0);
    harness.hover_at(harness.get_by_label("the half vector").rect().center());
    harness.run();
    assert_eq!(names(&harness), 3);
    // Across the surface there is none.
    harness.state_mut().session.set_other(-glam::DVec3::Z);
    harness.run();
    assert_eq!(names(&harness), 0);
}

/// What would say the answer comes with it.
#[test]
fn what_a_question_asks_for_is_covered_until_it_is_answered() {
    let covered = "shown with the answer";
    let mut harness = window([1900, 900]);
    let reflectance = lessons().iter().find(|one| one.id == "09-reflectance");
    let last = reflectance.unwrap().steps.len() - 1;
    harness.state_mut().open_lesson(reflectance.unwrap(), last);
    harness.run();
    let seen =
        |harness: &Harness<'_, App>, text: &str| harness.query_all_by_label_contains(text).count();
    // In the bar, and below the name.
    assert_eq!(seen(&harness, covered), 2);
    assert_eq!(seen(&harness, "Energy of"), 0);
    assert_eq!(
        seen(&harness, "| absorbed") + seen(&harness, "| created"),
        0
    );
    harness.get_by_label_contains("C: More than all").click();
    harness.run();
    assert_eq!(seen(&harness, covered), 0);
    assert!(seen(&harness, "Energy of") > 0 && seen(&harness, "| created") > 0);
    // Without the panel there is no question.
    let text = "+++\ntitle = \"T\"\n+++\n## One\n\n```ask\nquestion = \"Q\"\nnumber = \"1\"\ntolerance = 0.1\n\
        covers = [\"parameters\", \"turning\"]\n```\n";
    let lesson = read(text, "t", "t.md").unwrap();
    harness.state_mut().open_lesson(&lesson, 0);
    harness.run();
    assert_eq!(seen(&harness, covered), 1);
    assert_eq!(seen(&harness, "turning it changes nothing"), 0);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::L);
    harness.run();
    assert_eq!(seen(&harness, covered), 0);
    assert!(seen(&harness, "turning it changes nothing") > 0);
}
