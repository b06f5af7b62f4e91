//! The search of the commands.

use egui::Context;

use super::command::Command;
use super::list::COMMANDS;
use crate::app::App;
use crate::widgets::hits::{self, Found, Known};
use crate::widgets::search::{Entry, Outcome, Search};

/// The window of `search`, while it goes on.
pub fn show(search: &mut Search, ctx: &Context, app: &App) -> Outcome<&'static Command> {
    search.show(ctx, found, |command| Entry {
        title: format!("{}: {}", command.group.title(), command.title_now(app)),
        keys: command.first_keys(ctx).unwrap_or_default(),
        hint: command.hint,
        is_enabled: (command.is_enabled)(app),
    })
}

/// The commands that `wanted` finds; all of them where nothing is wanted.
fn found(wanted: &str) -> Found<&'static Command> {
    hits::found(wanted, COMMANDS, |command| Known {
        names: vec![command.title],
        texts: vec![command.group.title(), command.hint],
    })
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
        assert_eq!(ids("save"), ["save", "save_as", "save_with_data"]);
        assert_eq!(ids("save another"), ["save_as"]);
        assert_eq!(ids("  FILE  text session"), ["copy_session", "paste"]);
        // The title goes before the hints of commands that stand earlier in the list.
        assert_eq!(ids("undo")[0], "undo");
        assert_eq!(ids("sve")[0], "save");
        assert!(matches!(found("xyzzy"), Found::Nearest(_)));
    }
}
