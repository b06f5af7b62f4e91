//! The search of the commands.

use egui::{Align, Button, Context, Id, Key, Modal, Modifiers, Response, ScrollArea, TextEdit, Ui};

use crate::ui::app::App;
use crate::ui::commands::{COMMANDS, Command};
use crate::ui::theme;

/// What becomes of the search.
pub enum Outcome {
    /// It goes on.
    Open,
    /// It is over.
    Closed,
    /// This command is to be run.
    Chosen(&'static Command),
}

/// A search that is going on.
#[derive(Debug, Default)]
pub struct Search {
    wanted: String,
    /// Which of the commands found Enter runs.
    index: usize,
    /// Whether another one is that now, and is to be brought into sight.
    is_moved: bool,
}

impl Search {
    /// The window of the search.
    pub fn show(&mut self, ctx: &Context, app: &App) -> Outcome {
        let modal = Modal::new(Id::unique("search")).show(ctx, |ui| {
            ui.set_width(theme::SEARCH_SIZE.x);
            self.keys(ui);
            let field = TextEdit::singleline(&mut self.wanted)
                .hint_text("Search commands")
                .desired_width(f32::INFINITY);
            let field = ui.add(field);
            ctx.accesskit_node_builder(field.id, |node| node.set_label("Search all commands"));
            if !field.has_focus() {
                field.request_focus();
            }
            if field.changed() {
                self.index = 0;
                self.is_moved = true;
            }
            let found = found(&self.wanted);
            self.index = self.index.min(found.len().saturating_sub(1));
            if found.is_empty() {
                ui.weak("No command has these words");
            }
            let is_entered = ui.input(|input| input.key_pressed(Key::Enter));
            let mut chosen = found.get(self.index).copied().filter(|_| is_entered);
            let is_moved = std::mem::take(&mut self.is_moved);
            let area = ScrollArea::vertical().max_height(theme::SEARCH_SIZE.y);
            area.show(ui, |ui| {
                for (index, command) in found.iter().enumerate() {
                    let is_next = index == self.index;
                    let row = row(ui, app, command, is_next);
                    if is_next && is_moved {
                        row.scroll_to_me(Some(Align::Center));
                    }
                    if row.clicked() {
                        chosen = Some(*command);
                    }
                }
            });
            chosen
        });
        match modal.inner {
            Some(command) => Outcome::Chosen(command),
            None if modal.should_close() => Outcome::Closed,
            None => Outcome::Open,
        }
    }

    /// Up and Down go through what is found; the field would move its cursor.
    fn keys(&mut self, ui: &Ui) {
        let is_pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        let before = self.index;
        if is_pressed(Key::ArrowDown) {
            self.index += 1;
        }
        if is_pressed(Key::ArrowUp) {
            self.index = self.index.saturating_sub(1);
        }
        self.is_moved |= self.index != before;
    }
}

/// The commands that have every word of `wanted`.
fn found(wanted: &str) -> Vec<&'static Command> {
    let wanted = wanted.to_lowercase();
    let has_all = |command: &&'static Command| {
        let text = format!(
            "{} {} {}",
            command.group.title(),
            command.title,
            command.hint
        );
        let text = text.to_lowercase();
        wanted.split_whitespace().all(|word| text.contains(word))
    };
    COMMANDS.into_iter().filter(has_all).collect()
}

/// A command that is found.
fn row(ui: &mut Ui, app: &App, command: &Command, is_next: bool) -> Response {
    let title = format!("{}: {}", command.group.title(), command.title);
    let mut button =
        Button::selectable(is_next, title.as_str()).min_size(egui::vec2(ui.available_width(), 0.0));
    if let Some(shortcut) = command.shortcuts.first() {
        button = button.shortcut_text(ui.ctx().format_shortcut(shortcut));
    }
    let is_enabled = (command.is_enabled)(app);
    let response = ui.add_enabled(is_enabled, button);
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::Button, is_enabled, is_next, &title)
    });
    response.on_hover_text(command.hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_words_must_be_found() {
        let ids = |wanted: &str| -> Vec<&str> {
            found(wanted).iter().map(|command| command.id).collect()
        };
        assert_eq!(ids("").len(), COMMANDS.len());
        assert_eq!(ids("save"), ["save", "save_as"]);
        assert_eq!(ids("save another"), ["save_as"]);
        assert_eq!(ids("  FILE  text session"), ["copy_session", "paste"]);
        assert!(ids("xyzzy").is_empty());
    }
}
