//! Lessons on paper: the sheet of one, with its texts, its figures and room to answer, and a sheet of questions for a class.
//!
//! Text, formulas and figures are painted by the window's own widgets, and set in the columns of a page.

use egui::{RichText, Theme};

use super::painted::Painted;
use super::pdf;
use crate::app::{OnScreen, Picture, Title};
use bxdf::error::{Error, Result};
use bxdf_study::colors;
use bxdf_study::export::figure::Use;
use bxdf_study::lessons::{Ask, Lesson, Named, Step};
use bxdf_study::session::{Session, ViewId};
use bxdf_study::views::{OfKind as _, tradeoff};
use columns::{COLUMN, Columns, Item, PAPER};
use setter::{SMALL, Setter, TEXT, TITLES};

mod columns;
mod question;
mod setter;

/// The most figures of a step: the first views.
const MOST_FIGURES: usize = 2;

/// Pixels per point of what the graphics processor draws in a figure: 300 dots per inch.
const SCENE_SCALE: f32 = 2.6;

/// The steps of a lesson that are meant, with their indices.
fn steps(named: &Named) -> impl Iterator<Item = (usize, &Step)> {
    let all = named.lesson.steps.iter().enumerate();
    all.filter(move |(index, _)| named.step.is_none_or(|step| step == *index))
}

/// The sheet of a lesson as a PDF file: the text of each step, its first views as figures, and questions with room to answer.
///
/// # Errors
/// Where a figure shows a scene and there is no graphics adapter, and where the pages cannot be written.
pub fn of_lesson(named: &Named) -> Result<Vec<u8>> {
    let lesson = &named.lesson;
    let mut setter = Setter::new(Theme::Light);
    let mut items = Vec::new();
    let mut last: Option<Session> = None;
    let (mut asked, mut hints) = (0, Vec::new());
    for (index, step) in steps(named) {
        let session = state(lesson, index)?;
        items.push(Item::heading(setter.title(&step.title, TITLES[2])));
        items.extend(setter.blocks(&session, &step.text));
        if last.as_ref() != Some(&session) {
            for view in session.views.ids().into_iter().take(MOST_FIGURES) {
                items.push(Item::figure(figure(&mut setter, &session, view)?));
            }
        }
        if let Some(ask) = &step.ask {
            asked += 1;
            let text = setter.prose(&session, |ui, prose| {
                question::show(ui, asked, (ask, None), prose);
            });
            items.push(Item::of(text));
            hints.push((asked, session.clone(), ask));
        }
        last = Some(session);
    }
    items.extend(all_hints(&mut setter, &hints));
    let head = setter.head(&lesson.title, &lesson.summary, true);
    print(&mut setter, &lesson.title, &head, items)
}

/// A sheet of the questions of these lessons as a PDF file, with the computed answers or with room for them.
///
/// # Errors
/// Where none of them asks anything, and where the pages cannot be written.
pub fn of_class(named: &[Named], has_answers: bool) -> Result<Vec<u8>> {
    let mut setter = Setter::new(Theme::Light);
    let mut items = Vec::new();
    let (mut asked, mut hints) = (0, Vec::new());
    for one in named {
        let lesson = &one.lesson;
        let mut is_begun = false;
        for (index, step) in steps(one) {
            let Some(ask) = &step.ask else { continue };
            asked += 1;
            if !is_begun {
                is_begun = true;
                items.push(Item::heading(setter.title(&lesson.title, TITLES[1])));
            }
            let begun = state(lesson, index)?;
            let solved = if has_answers {
                Some(question::solved(lesson, index, ask, &begun)?)
            } else {
                None
            };
            let text = setter.prose(&begun, |ui, prose| {
                ui.label(
                    RichText::new(question::state_line(prose.session))
                        .weak()
                        .size(TEXT - 2.0),
                );
                question::show(ui, asked, (ask, solved.as_ref()), prose);
            });
            items.push(Item::apart(text));
            let Some(solved) = solved else {
                hints.push((asked, begun, ask));
                continue;
            };
            items.extend(setter.blocks(&solved.after, &step.answer));
        }
    }
    if asked == 0 {
        let ids: Vec<&str> = named.iter().map(|one| one.lesson.id.as_str()).collect();
        return Err(Error::parse(ids.join(", "), "there is no question in it"));
    }
    items.extend(all_hints(&mut setter, &hints));
    let (title, about) = if has_answers {
        (
            "Questions and answers",
            "Every answer is computed from the state that the question is of.",
        )
    } else {
        (
            "Questions",
            "Each question is of the state that stands above it: open it in the window to see it.",
        )
    };
    let head = setter.head(title, about, !has_answers);
    print(&mut setter, title, &head, items)
}

/// What helps with the questions, each with its number and the state that it is of: small, behind them all, for who is at a loss.
fn all_hints(setter: &mut Setter, hints: &[(usize, Session, &Ask)]) -> Vec<Item> {
    let mut items = Vec::new();
    for (number, session, ask) in hints.iter().filter(|(.., ask)| !ask.hints.is_empty()) {
        if items.is_empty() {
            items.push(Item::heading(setter.title("Hints", TITLES[2])));
        }
        let text = setter.prose_of(SMALL, session, |ui, prose| {
            question::show_hints(ui, *number, ask, prose);
        });
        items.push(Item::of(text));
    }
    items
}

/// The pages of what is set in columns.
fn print(setter: &mut Setter, title: &str, head: &Painted, items: Vec<Item>) -> Result<Vec<u8>> {
    let columns = Columns::filled(head, items);
    let count = columns.pages();
    let feet: Vec<Painted> = (1..=count)
        .map(|page| setter.foot(title, page, count))
        .collect();
    pdf::document(title, PAPER, &columns.placed(head, &feet))
}

/// The state that a step begins with.
fn state(lesson: &Lesson, step: usize) -> Result<Session> {
    let refused = |problem| Error::parse(format!("lesson '{}'", lesson.id), problem);
    lesson.state_of(step).map_err(refused)
}

/// A view of a session, as a figure for a column. One that measures the machine would be another each time: where it is to be
/// seen is said in its place.
fn figure(setter: &mut Setter, session: &Session, view: ViewId) -> Result<Painted> {
    let kind = session.views.kind(view);
    if let Some(kind) = kind.filter(|kind| kind.id == tradeoff::Options::KIND.id) {
        let words = format!("{} measures the machine: see it in the window.", kind.title);
        return Ok(setter.note(&words));
    }
    let screen = OnScreen {
        size: [COLUMN as u32; 2],
        scale: SCENE_SCALE,
    };
    let how = (Use::Column, Title::Automatic, colors::Theme::Light);
    let mut picture = Picture::of_figure(session.clone(), view, how, screen);
    picture.scale = SCENE_SCALE;
    pollster::block_on(Painted::of(picture))
}
