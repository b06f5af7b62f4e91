//! The search of the commands.

use egui::{Align, Button, Context, Id, Key, Modal, Response, ScrollArea, TextEdit, Ui};

use super::hits::{self, Found, Highlight, Known};
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
    highlight: Highlight,
}

impl Search {
    /// A search whose field has the focus from here on.
    #[must_use]
    pub fn begin(ctx: &Context) -> Self {
        ctx.memory_mut(|memory| memory.request_focus(field_id()));
        Self::default()
    }

    /// The window of the search.
    pub fn show(&mut self, ctx: &Context, app: &App) -> Outcome {
        let modal = Modal::new(Id::unique("search")).show(ctx, |ui| {
            ui.set_width(theme::SEARCH_SIZE.x);
            let rows = hits::take_rows(ui);
            let field = TextEdit::singleline(&mut self.wanted)
                .id(field_id())
                .hint_text("Search commands")
                .desired_width(f32::INFINITY);
            let field = ui.add(field);
            ctx.accesskit_node_builder(field.id, |node| node.set_label("Search all commands"));
            if !field.has_focus() {
                field.request_focus();
            }
            if field.changed() {
                self.highlight.restart();
            }
            let found = found(&self.wanted);
            self.highlight.go(&found, rows);
            if matches!(found, Found::Nearest(_)) {
                ui.weak("No command has these words; the nearest are");
            }
            let is_entered = ui.input(|input| input.key_pressed(Key::Enter));
            let (listed, next) = (found.listed(), self.highlight.at());
            let mut chosen = next
                .filter(|_| is_entered)
                .and_then(|at| listed.get(at))
                .copied();
            let is_moved = self.highlight.take_moved();
            let area = ScrollArea::vertical().max_height(theme::SEARCH_SIZE.y);
            area.show(ui, |ui| {
                for (index, command) in listed.iter().enumerate() {
                    let is_next = next == Some(index);
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
}

/// The field's, known before it is shown.
fn field_id() -> Id {
    Id::unique("search of the commands")
}

/// The commands that `wanted` finds; all of them where nothing is wanted.
fn found(wanted: &str) -> Found<&'static Command> {
    hits::found(wanted, COMMANDS, |command| Known {
        names: vec![command.title],
        texts: vec![command.group.title(), command.hint],
    })
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
            let found = found(wanted);
            found.listed().iter().map(|command| command.id).collect()
        };
        assert_eq!(ids("").len(), COMMANDS.len());
        assert_eq!(ids("save"), ["save", "save_as"]);
        assert_eq!(ids("save another"), ["save_as"]);
        assert_eq!(ids("  FILE  text session"), ["copy_session", "paste"]);
        // The title goes before the hints of commands that stand earlier in the list.
        assert_eq!(ids("undo")[0], "undo");
        assert_eq!(ids("sve")[0], "save");
        assert!(matches!(found("xyzzy"), Found::Nearest(_)));
    }
}
