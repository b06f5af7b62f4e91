//! A question on paper: with room for its answer, or with it.

use egui::{Frame, RichText, Sense, Stroke, Ui, pos2, vec2};

use super::setter::rule;
use crate::widgets::lesson::{Prose, written};
use bxdf::error::{Error, Result};
use bxdf_lab::analysis::half_difference::Spherical;
use bxdf_study::format;
use bxdf_study::lessons::{Ask, Choice, Kind, Lesson, Scenes, Span, Style, right_choice};
use bxdf_study::session::Session;

/// The side of a box to be ticked, in points.
const BOX: f32 = 12.0;

/// The length of the line for a number, in points.
const NUMBER_LINE: f32 = 130.0;

/// The height of a line to write on, in points.
const LINE: f32 = 26.0;

/// How many lines there are for what was done in the window.
const LINES: usize = 2;

/// What is right.
pub(super) struct Solved {
    answer: Answer,
    /// The state that is shown once the question is answered.
    pub(super) after: Session,
}

enum Answer {
    /// The choice at this index.
    Choice(usize),
    /// This, in place of what is written or done.
    Words(String),
}

/// The answer to the question of a step, computed from the state that the step begins with.
///
/// # Errors
/// Where it cannot be computed, in a lesson that does not hold what it says.
pub(super) fn solved(lesson: &Lesson, step: usize, ask: &Ask, begun: &Session) -> Result<Solved> {
    let refused = |problem| {
        Error::parse(
            format!("lesson '{}', step {}", lesson.id, step + 1),
            problem,
        )
    };
    let scenes = Scenes::of(begun);
    let mut after = begun.clone();
    let answer = match &ask.kind {
        Kind::Choice(choices) => right_choice(choices, &scenes)
            .map(Answer::Choice)
            .map_err(refused)?,
        Kind::Number(number) => {
            let value = number.value.value(&scenes).map_err(refused)?;
            Answer::Words(written(value, &number.unit))
        }
        Kind::Reach(reach) => {
            reach.solution.apply(&mut after).map_err(refused)?;
            Answer::Words(format!("For instance: {}", done(begun, &after)))
        }
    };
    lesson.state_after(step, &mut after).map_err(refused)?;
    Ok(Solved { answer, after })
}

/// What was done to the selected material, the light, the viewer and the turn of the surface; the whole state where none of them is another.
fn done(before: &Session, after: &Session) -> String {
    let material = |session: &Session| session.materials.selected().material.to_string();
    let changed = [
        (material(before), material(after)),
        (directions(before), directions(after)),
        (turn(before), turn(after)),
    ];
    let changed = changed
        .into_iter()
        .filter(|(before, after)| before != after);
    let words: Vec<String> = changed.map(|(_, after)| after).collect();
    if words.is_empty() {
        state_line(after)
    } else {
        words.join("; ")
    }
}

/// By how much the surface is turned.
fn turn(session: &Session) -> String {
    format!("turned by {}", format::degrees(session.rotation_deg))
}

/// The light and the viewer of a state.
fn directions(session: &Session) -> String {
    let theta = |direction| format::degrees(Spherical::of(direction).theta_deg);
    let [light, viewer] = [session.light(), session.viewer()].map(theta);
    format!("light at {light}, viewer at {viewer}")
}

/// The materials of a state, and its light and viewer.
pub(super) fn state_line(session: &Session) -> String {
    let materials = &session.materials;
    let names: Vec<String> = materials
        .shown()
        .map(|entry| materials.title(entry))
        .collect();
    format!("{}; {}", names.join(", "), directions(session))
}

/// Writes a question with its number.
pub(super) fn show(
    ui: &mut Ui,
    number: usize,
    (ask, solved): (&Ask, Option<&Solved>),
    prose: &mut Prose<'_>,
) {
    let answer = solved.map(|solved| &solved.answer);
    let stroke = Stroke::new(1.0, prose.palette.faint_ink);
    Frame::group(ui.style()).stroke(stroke).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(
            RichText::new(format!("Question {number}"))
                .size(prose.size)
                .strong(),
        );
        prose.line(ui, &ask.question);
        ui.add_space(6.0);
        match (&ask.kind, answer) {
            (Kind::Choice(choices), _) => {
                let right = match answer {
                    Some(Answer::Choice(index)) => Some(*index),
                    _ => None,
                };
                self::choices(ui, choices, right, prose);
            }
            (_, Some(Answer::Words(words))) => {
                ui.label(RichText::new(words).size(prose.size).strong());
            }
            (Kind::Number(number), _) => {
                ui.horizontal(|ui| {
                    rule(ui, NUMBER_LINE, prose.palette.ink);
                    ui.label(RichText::new(&number.unit).size(prose.size));
                });
            }
            (Kind::Reach(_), _) => {
                let words = RichText::new("Do it in the window. What did you do?");
                ui.label(words.size(prose.size).italics());
                for _ in 0..LINES {
                    ui.add_space(LINE - prose.size);
                    rule(ui, ui.available_width(), prose.palette.ink);
                }
            }
        }
    });
}

/// Writes what helps with a question, in one paragraph.
pub(super) fn show_hints(ui: &mut Ui, number: usize, ask: &Ask, prose: &mut Prose<'_>) {
    let words = |text: String, is_strong| Span::Words {
        text,
        style: Style {
            is_strong,
            ..Style::default()
        },
    };
    let mut spans = vec![words(format!("Question {number}: "), true)];
    for hint in &ask.hints {
        spans.extend(hint.iter().cloned());
        spans.push(words(" ".to_owned(), false));
    }
    prose.line(ui, &spans);
}

/// The choices, each with a box; `right`: the index of the one that is ticked.
fn choices(ui: &mut Ui, choices: &[Choice], right: Option<usize>, prose: &mut Prose<'_>) {
    for (index, choice) in choices.iter().enumerate() {
        ui.horizontal_top(|ui| {
            let room = vec2(BOX + 4.0, prose.size + 4.0);
            let (rect, _) = ui.allocate_exact_size(room, Sense::hover());
            let middle = pos2(rect.left() + 0.5 * BOX, rect.center().y);
            let square = egui::Rect::from_center_size(middle, vec2(BOX, BOX));
            let stroke = Stroke::new(1.0, prose.palette.ink);
            let painter = ui.painter();
            painter.rect_stroke(square, 1.0, stroke, egui::StrokeKind::Middle);
            if right == Some(index) {
                let at = |x: f32, y: f32| square.lerp_inside(vec2(x, y));
                let tick = vec![at(0.15, 0.5), at(0.42, 0.85), at(1.05, -0.15)];
                painter.line(tick, Stroke::new(2.2, prose.palette.ink));
            }
            ui.vertical(|ui| prose.line(ui, &choice.text));
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_done_is_what_is_another() {
        let before = Session::default();
        let mut after = before.clone();
        assert_eq!(done(&before, &after), state_line(&after));
        after.theta_deg = before.theta_deg + 20.0;
        assert_eq!(done(&before, &after), directions(&after));
        let material = "phong:exponent=20".parse().unwrap();
        after.materials.selected_mut().material = material;
        let both = format!("phong:exponent=20; {}", directions(&after));
        assert_eq!(done(&before, &after), both);
        let mut turned = before.clone();
        turned.rotation_deg = 90.0;
        assert_eq!(done(&before, &turned), "turned by 90°");
    }
}
