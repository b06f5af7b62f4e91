//! `lessons`: the lessons and the questions there are, and whether one holds what it says.

use std::fmt::Write as _;
use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::output;
use super::say::say;
use bxdf::error::{Error, Result};
use bxdf_lab::quantities;
use bxdf_study::lessons::{
    self, Expression, Fault, Kind, Lesson, Shelf, Step, Tolerance, plain, plain_spans,
};

mod sheet;

/// Where errors say that the program's own lessons and questions stand.
const FOLDERS: [&str; 2] = ["assets/lessons", "assets/questions"];

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// Go through every step, answer every question rightly and wrongly, and fail where one is broken
    #[arg(long)]
    check: bool,
    #[command(flatten)]
    sheet: sheet::OfSheet,
    /// With --check: the lessons to check, a file or a folder of them. With --sheet: those whose questions are asked, each by its number, its id or its file (.md), as 1 or 01-scattering.2 [default: all of the program]
    #[arg(value_name = "FILE|FOLDER|NN[.STEP]")]
    names: Vec<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// List the quantities that a lesson may name
    #[arg(long, conflicts_with_all = ["check", "json"])]
    quantities: bool,
}

/// Prints what is asked for. Returns whether all that was checked is as it should be.
///
/// # Errors
/// Where a file or a folder cannot be read, and where standard output cannot be written.
pub(super) fn run(arguments: &Arguments) -> Result<bool> {
    if arguments.quantities {
        output::print(&listed_quantities())?;
        return Ok(true);
    }
    if arguments.sheet.is_wanted() {
        arguments.sheet.write(&arguments.names)?;
        return Ok(true);
    }
    let groups = match arguments.checked()? {
        Some(path) => {
            let shelf = Shelf::open(path)?;
            let place = path.display().to_string();
            // The lessons of a folder are called by its name and theirs.
            let is_folder = path.is_dir();
            vec![Group {
                place,
                is_folder,
                lessons: shelf.lessons,
                problems: shelf.problems,
            }]
        }
        None => own(),
    };
    let mut faults: Vec<String> = Vec::new();
    for group in &groups {
        faults.extend(group.problems.iter().cloned());
        if arguments.check {
            faults.extend(group.lessons.iter().flat_map(|lesson| group.faults(lesson)));
        }
    }
    for fault in &faults {
        say(&format!("error: {fault}"));
    }
    let all: Vec<&Lesson> = groups.iter().flat_map(|group| &group.lessons).collect();
    if arguments.json {
        let (lessons, questions) = groups.split_at(1.min(groups.len()));
        let json_of = |groups: &[Group]| -> Vec<Json> {
            let lessons = groups.iter().flat_map(|group| &group.lessons);
            lessons.map(lesson_json).collect()
        };
        output::print_json(&json!({
            "lessons": json_of(lessons),
            "questions": json_of(questions),
            "faults": faults,
        }))?;
    } else if arguments.check {
        let steps: usize = all.iter().map(|lesson| lesson.steps.len()).sum();
        let asked = all.iter().flat_map(|lesson| &lesson.steps);
        let asked = asked.filter(|step| step.ask.is_some()).count();
        output::print(&format!(
            "{} lessons, {steps} steps, {asked} questions, {} faults\n",
            all.len(),
            faults.len()
        ))?;
    } else {
        output::print(&listed(&groups))?;
    }
    Ok(faults.is_empty())
}

impl Arguments {
    /// The file or folder to be checked; `None` for what the program has.
    fn checked(&self) -> Result<Option<&PathBuf>> {
        let refused =
            |path: &PathBuf, problem| Err(Error::parse(format!("'{}'", path.display()), problem));
        match self.names.as_slice() {
            [path, ..] if !self.check => refused(path, "it goes with --check or --sheet"),
            [_, second, ..] => refused(second, "one file or folder is checked at a time"),
            names => Ok(names.first()),
        }
    }
}

/// Lessons of one place.
struct Group {
    place: String,
    is_folder: bool,
    lessons: Vec<Lesson>,
    problems: Vec<String>,
}

impl Group {
    fn faults(&self, lesson: &Lesson) -> Vec<String> {
        let place = if self.is_folder {
            format!("{}/{}.md", self.place, lesson.id)
        } else {
            self.place.clone()
        };
        let faults = lessons::check(lesson).into_iter().chain(in_window(lesson));
        let lines = faults.map(|fault| format!("{place}: line {}: {}", fault.line, fault.problem));
        lines.collect()
    }
}

/// What is wrong with what a lesson names in the window.
#[cfg(feature = "gui")]
fn in_window(lesson: &Lesson) -> Vec<Fault> {
    bxdf_ui::headless::unknown_controls(lesson)
}

/// A build without the window cannot look.
#[cfg(not(feature = "gui"))]
fn in_window(_: &Lesson) -> Vec<Fault> {
    Vec::new()
}

/// The lessons and the questions of the program.
fn own() -> Vec<Group> {
    let [lessons, questions] = FOLDERS;
    [
        (lessons, lessons::lessons()),
        (questions, lessons::questions()),
    ]
    .map(|(place, lessons)| Group {
        place: place.to_owned(),
        is_folder: true,
        lessons: lessons.to_vec(),
        problems: Vec::new(),
    })
    .into()
}

fn listed(groups: &[Group]) -> String {
    let mut text = String::new();
    for group in groups {
        for lesson in &group.lessons {
            let minutes = match lesson.minutes {
                0 => String::new(),
                minutes => format!(" ({minutes} min)"),
            };
            let _ = writeln!(text, "{:28} {}{minutes}", lesson.id, lesson.title);
        }
    }
    text
}

fn listed_quantities() -> String {
    let mut text = String::new();
    for quantity in quantities::all() {
        let unit = match quantity.unit {
            "" => String::new(),
            unit => format!(" [{unit}]"),
        };
        let _ = writeln!(
            text,
            "{}{unit}\n    {}",
            quantity.form().trim_matches('\''),
            quantity.meaning
        );
    }
    text
}

fn lesson_json(lesson: &Lesson) -> Json {
    let steps: Vec<Json> = lesson.steps.iter().map(step_json).collect();
    json!({
        "id": lesson.id,
        "title": lesson.title,
        "minutes": lesson.minutes,
        "summary": lesson.summary,
        "steps": steps,
    })
}

/// A number stands as the expression that it is computed by.
fn step_json(step: &Step) -> Json {
    let value = |number: &Expression| format!("{{{}}}", number.text());
    let question = step.ask.as_ref().map(|ask| {
        let (kind, quantity, tolerance) = match &ask.kind {
            Kind::Choice(_) => ("choice", None, None),
            Kind::Number(number) => {
                let tolerance = match number.tolerance {
                    Tolerance::Absolute(by) => json!({ "absolute": by }),
                    Tolerance::Relative(part) => json!({ "relative": part }),
                };
                ("number", Some(number.value.text()), Some(tolerance))
            }
            Kind::Reach(reach) => ("state", Some(reach.until.text()), None),
        };
        json!({
            "text": plain_spans(&ask.question, &value),
            "kind": kind,
            "quantity": quantity,
            "tolerance": tolerance,
        })
    });
    json!({
        "title": step.title,
        "text": plain(&step.text, &value),
        "question": question,
    })
}
