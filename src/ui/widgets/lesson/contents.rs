//! The list of lessons and questions.

use egui::{RichText, ScrollArea, TextEdit, Ui};

use crate::theme::Palette;
use bxdf_study::lessons::Lesson;
use bxdf_study::store::Progress;

/// Lessons under a heading.
pub struct Group<'a> {
    /// The heading.
    pub title: &'static str,
    /// The lessons.
    pub lessons: &'a [Lesson],
}

/// The groups that there are, filtered by what is typed; `is_new`: whether the list has just come, so that one may type. Returns the group and the place of the one that is chosen.
pub fn show(
    ui: &mut Ui,
    groups: &[Group<'_>],
    (typed, is_new): (&mut String, bool),
    (progress, palette): (&Progress, &Palette),
) -> Option<(usize, usize)> {
    let mut chosen = None;
    let field = TextEdit::singleline(typed)
        .hint_text("Find a lesson or a question")
        .desired_width(f32::INFINITY);
    let field = ui.add(field);
    let label = |node: &mut egui::accesskit::Node| node.set_label("Find a lesson or a question");
    ui.ctx().accesskit_node_builder(field.id, label);
    if is_new {
        field.request_focus();
    }
    let area = ScrollArea::vertical()
        .id_salt("lessons")
        .auto_shrink([false, false]);
    area.show(ui, |ui| {
        let mut is_any = false;
        for (of, group) in groups.iter().enumerate() {
            let found: Vec<_> = group.lessons.iter().enumerate().collect();
            let found: Vec<_> = found
                .into_iter()
                .filter(|(_, lesson)| lesson.is_found_by(typed))
                .collect();
            if found.is_empty() {
                continue;
            }
            is_any = true;
            ui.add_space(6.0);
            ui.label(RichText::new(group.title).heading());
            for (place, lesson) in found {
                if row(ui, lesson, progress, palette) {
                    chosen = Some((of, place));
                }
            }
        }
        if !is_any {
            ui.weak("Nothing of the kind");
        }
    });
    chosen
}

/// A lesson with how far one is in it. Returns whether it is chosen.
fn row(ui: &mut Ui, lesson: &Lesson, progress: &Progress, palette: &Palette) -> bool {
    let asked = lesson.steps.iter().filter(|step| step.ask.is_some());
    let all = asked.clone().count();
    let answered = asked.filter(|step| progress.is_answered(&lesson.id, &step.title));
    let answered = answered.count();
    let (sign, says) = match answered {
        0 => ("", String::new()),
        n if n == all => ("✔ ", "; all questions answered".to_owned()),
        n => ("◔ ", format!("; {n} of {all} questions answered")),
    };
    let text = RichText::new(format!("{sign}{}", lesson.title)).color(palette.ink);
    let button = ui.add(egui::Button::new(text).frame(false).wrap());
    let minutes = match lesson.minutes {
        0 => String::new(),
        minutes => format!(" ({minutes} minutes)"),
    };
    button
        .on_hover_text(format!("{}{minutes}{says}", lesson.summary))
        .clicked()
}
