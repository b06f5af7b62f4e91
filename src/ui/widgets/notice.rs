//! What could not be done, in a line.

use std::fmt::Display;

use egui::{Align, Label, Layout, Panel, RichText, Ui};

use super::draw;

/// The most characters of a line that are shown: an error may name what it was given.
const LONGEST: usize = 200;

/// The last thing to be said, until it is dismissed.
#[derive(Debug, Default)]
pub struct Notice {
    /// In a line; several where they belong together.
    lines: Vec<String>,
    /// Why the session is not kept for the next run, as long as it is not, whatever else is said.
    lasting: Option<String>,
    /// Whether something was said since it was last shown.
    is_new: bool,
}

impl Notice {
    /// Says what went wrong.
    pub fn say(&mut self, problem: &impl Display) {
        self.say_all(&[problem.to_string()]);
    }

    /// Says several things that belong together, line by line.
    pub fn say_all(&mut self, lines: &[String]) {
        self.lines = lines.iter().map(|line| on_one_line(line)).collect();
        self.is_new = true;
    }

    /// Says what goes wrong all the time, or that it does no longer.
    pub fn say_lasting(&mut self, problem: Option<&str>) {
        self.lasting = problem.map(on_one_line);
        self.is_new = true;
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

    /// Whether something was said since it was last shown: another frame is wanted.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.is_new
    }

    /// A panel at the bottom, while there is something to say.
    pub fn show(&mut self, ui: &mut Ui) {
        self.is_new = false;
        if self.lines.is_empty() && self.lasting.is_none() {
            return;
        }
        let color = ui.visuals().error_fg_color;
        let mut is_dismissed = false;
        Panel::bottom("notice").show(ui, |ui| {
            let lines = self.lasting.iter().chain(&self.lines);
            for (index, text) in lines.enumerate() {
                ui.horizontal(|ui| {
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                        if index == 0 {
                            is_dismissed = ui
                                .button("Dismiss")
                                .on_hover_text("Take these words away")
                                .clicked();
                        }
                        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                            ui.add(Label::new(RichText::new(text).color(color)).truncate());
                        });
                    });
                });
            }
        });
        if is_dismissed {
            self.lines.clear();
            self.lasting = None;
        }
    }
}

fn on_one_line(text: &str) -> String {
    draw::clipped(&text.replace(['\n', '\r'], " "), LONGEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_is_one_line_of_bounded_length() {
        let mut notice = Notice::default();
        assert_eq!(notice.report::<_, String>(Ok(3)), Some(3));
        assert!(notice.lines.is_empty() && !notice.is_new());
        notice.report::<(), _>(Err("no\nsuch thing"));
        assert_eq!(notice.lines, ["no such thing"]);
        assert!(notice.is_new());
        notice.say(&"x".repeat(1000));
        let lengths = notice.lines.iter().map(|line| line.chars().count());
        assert_eq!(lengths.collect::<Vec<_>>(), [201]);
    }

    #[test]
    fn what_lasts_stays_while_something_else_is_said() {
        let mut notice = Notice::default();
        notice.say_lasting(Some("the disk is full"));
        notice.say(&"no such thing");
        assert_eq!(notice.lasting.as_deref(), Some("the disk is full"));
        notice.say_lasting(None);
        assert_eq!((notice.lasting, notice.lines.len()), (None, 1));
    }
}
