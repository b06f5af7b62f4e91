//! A question on the screen: its answers, hints, and what a wrong answer would look like.

use egui::{Button, Frame, Key, RichText, Sense, Stroke, TextEdit, Ui};

use super::prose::{Prose, written};
use bxdf_study::lessons::{Ask, Choice, Kind, Number, Verdict, Work};
use bxdf_study::session::Session;

/// What is done at a question.
#[derive(Clone, Debug, PartialEq)]
pub enum Done {
    /// It is answered by the choice at this index.
    Choose(usize),
    /// It is answered by what is typed.
    Submit,
    /// Its answer is looked up.
    LookUp,
    /// What the wrong answer would look like is shown.
    Show,
    /// What is shown goes.
    Back,
}

/// The question. `is_shown`: whether the views show what a wrong answer would look like; `is_new`: whether it has just come, so
/// that the keyboard begins with its first choice. Returns what is done.
pub fn show(
    ui: &mut Ui,
    (ask, work): (&Ask, &mut Work),
    (is_shown, is_new): (bool, bool),
    prose: &mut Prose<'_>,
) -> Option<Done> {
    let mut done = None;
    let palette = prose.palette;
    Frame::group(ui.style())
        .fill(palette.background)
        .stroke(Stroke::new(1.0, palette.grid))
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.label(RichText::new("Question").weak());
            prose.line(ui, &ask.question);
            ui.add_space(4.0);
            match &ask.kind {
                Kind::Choice(choices) => {
                    done = self::choices(ui, (choices, is_new), work, prose);
                }
                Kind::Number(asked) => done = number(ui, asked, work, prose),
                Kind::Reach(_) => {
                    ui.label(
                        RichText::new("Do it in the window")
                            .size(prose.size)
                            .italics(),
                    );
                }
            }
            verdict(ui, ask, work, prose);
            if let Some(because) = work.because(ask) {
                prose.line(ui, because);
            }
            for hint in ask.hints.iter().take(work.hints) {
                ui.horizontal_top(|ui| {
                    ui.label("💡");
                    ui.vertical(|ui| prose.line(ui, hint));
                });
            }
            ui.horizontal_wrapped(|ui| {
                if !work.is_revealed() && work.hints < ask.hints.len() {
                    let text = if work.hints == 0 {
                        "Hint"
                    } else {
                        "Another hint"
                    };
                    if ui.button(text).clicked() {
                        work.hints += 1;
                    }
                }
                let shown = work.shown(ask, prose.session);
                let is_other = |shown: &Session| shown != prose.session;
                if is_shown {
                    let hint = "Show the state of the step again";
                    if ui.button("Back to the step").on_hover_text(hint).clicked() {
                        done = Some(Done::Back);
                    }
                } else if shown.as_ref().is_some_and(is_other) {
                    let hint = "Show what would be seen if your answer were right";
                    if ui
                        .button("See what that means")
                        .on_hover_text(hint)
                        .clicked()
                    {
                        done = Some(Done::Show);
                    }
                }
                if !work.is_revealed() && ui.button("Show the answer").clicked() {
                    done = Some(Done::LookUp);
                }
            });
        });
    done
}

fn choices(
    ui: &mut Ui,
    (choices, is_new): (&[Choice], bool),
    work: &Work,
    prose: &mut Prose<'_>,
) -> Option<Done> {
    let mut done = None;
    for (index, choice) in choices.iter().enumerate() {
        let letter = char::from(b'A' + index as u8 % 26);
        let name = format!("{letter}: {}", plain(choice));
        let row = ui.horizontal_top(|ui| {
            let is_chosen = work.chosen == Some(index);
            let button = ui.add_enabled(
                !work.is_revealed() || is_chosen,
                Button::selectable(is_chosen, letter.to_string()),
            );
            let label = |node: &mut egui::accesskit::Node| node.set_label(name.clone());
            ui.ctx().accesskit_node_builder(button.id, label);
            if is_new && index == 0 {
                button.request_focus();
            }
            if button.clicked() && !work.is_revealed() {
                done = Some(Done::Choose(index));
            }
            ui.vertical(|ui| prose.line(ui, &choice.text));
        });
        // The whole line answers to the pointer, and the letter to the keyboard.
        let line = row.response.interact(Sense::CLICK);
        if line.clicked() && !work.is_revealed() {
            done = Some(Done::Choose(index));
        }
    }
    done
}

/// The text of a choice for who hears it.
fn plain(choice: &Choice) -> String {
    bxdf_study::lessons::plain_spans(&choice.text, &|number| number.text().to_owned())
}

fn number(ui: &mut Ui, asked: &Number, work: &mut Work, prose: &mut Prose<'_>) -> Option<Done> {
    let mut done = None;
    let is_open = !work.is_revealed();
    ui.horizontal(|ui| {
        let field = TextEdit::singleline(&mut work.typed)
            .desired_width(90.0)
            .hint_text("a number");
        let field = ui.add_enabled(is_open, field);
        let label = |node: &mut egui::accesskit::Node| node.set_label("Your answer");
        ui.ctx().accesskit_node_builder(field.id, label);
        let is_entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        ui.label(RichText::new(&asked.unit).size(prose.size));
        let button = ui.add_enabled(is_open, Button::new("Answer"));
        if is_entered || button.clicked() {
            done = Some(Done::Submit);
        }
    });
    if !is_open {
        let value = asked.value.value(prose.scenes);
        let text = value.map_or_else(|problem| problem, |value| written(value, &asked.unit));
        ui.label(RichText::new(format!("The answer: {text}")).size(prose.size));
    }
    done
}

/// How the answer was, in a sign and a word.
fn verdict(ui: &mut Ui, ask: &Ask, work: &Work, prose: &Prose<'_>) {
    let palette = prose.palette;
    let (text, color) = match &work.verdict {
        Some(Verdict::Right) => ("✔ Right".to_owned(), palette.kept),
        Some(Verdict::Wrong) => {
            let text = match &ask.kind {
                Kind::Number(_) => "✖ Not within the tolerance",
                Kind::Choice(_) | Kind::Reach(_) => "✖ Not so",
            };
            (text.to_owned(), palette.warning)
        }
        Some(Verdict::Unreadable(problem)) => (problem.clone(), palette.warning),
        None => return,
    };
    let text = RichText::new(text)
        .size(prose.size)
        .color(palette.text_in(color));
    ui.label(text.strong());
}
