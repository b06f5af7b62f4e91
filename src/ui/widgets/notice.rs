//! What could not be done, in a line.

use std::fmt::Display;

use egui::{Align, Label, Layout, Panel, RichText, Ui};

use super::draw;

/// The most characters that are shown: an error may name what it was given.
const LONGEST: usize = 200;

/// The last thing to be said, until it is dismissed.
#[derive(Debug, Default)]
pub struct Notice(Option<String>);

impl Notice {
    /// Says what went wrong.
    pub fn say(&mut self, problem: &impl Display) {
        let line = problem.to_string().replace(['\n', '\r'], " ");
        self.0 = Some(draw::clipped(&line, LONGEST));
    }

    /// Says what went wrong, if anything did.
    pub fn report<T, E: Display>(&mut self, result: Result<T, E>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(error) => {
                self.say(&error);
                None
            }
        }
    }

    /// A panel at the bottom, while there is something to say.
    pub fn show(&mut self, ui: &mut Ui) {
        let Some(text) = &self.0 else { return };
        let color = ui.visuals().error_fg_color;
        let mut is_dismissed = false;
        Panel::bottom("notice").show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    is_dismissed = ui
                        .button("Dismiss")
                        .on_hover_text("Take this line away")
                        .clicked();
                    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                        ui.add(Label::new(RichText::new(text).color(color)).truncate());
                    });
                });
            });
        });
        if is_dismissed {
            self.0 = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_is_one_line_of_bounded_length() {
        let mut notice = Notice::default();
        assert_eq!(notice.report::<_, String>(Ok(3)), Some(3));
        assert_eq!(notice.0, None);
        notice.report::<(), _>(Err("no\nsuch thing"));
        assert_eq!(notice.0.as_deref(), Some("no such thing"));
        notice.say(&"x".repeat(1000));
        assert_eq!(
            notice.0.as_ref().map(|text| text.chars().count()),
            Some(201)
        );
    }
}
