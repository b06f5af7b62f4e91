//! The commands: what each is, and how it is run, by buttons and by keys.

use egui::{Button, Context, KeyboardShortcut, Modifiers, Ui};

use super::app::App;

mod list;

pub use list::*;

/// What a command is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Files and the clipboard.
    File,
    /// The history.
    Edit,
    /// The list of materials.
    Materials,
    /// How things are shown.
    View,
    /// The program itself.
    Help,
}

impl Group {
    /// Every group, in the order of the help.
    pub const ALL: [Self; 5] = [
        Self::File,
        Self::Edit,
        Self::Materials,
        Self::View,
        Self::Help,
    ];

    /// Its name at the screen.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::Materials => "Materials",
            Self::View => "View",
            Self::Help => "Help",
        }
    }
}

/// Something that can be done to the whole window.
pub struct Command {
    /// The id: a word that never changes.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What it does, in a sentence.
    pub hint: &'static str,
    /// What it is about.
    pub group: Group,
    /// The keys for it, the first of which is shown at buttons.
    pub shortcuts: &'static [KeyboardShortcut],
    /// Whether it can be done now.
    pub is_enabled: fn(&App) -> bool,
    /// Does it.
    pub run: fn(&mut App, &Context),
}

/// A command that can always be done: the start from which the others differ.
const fn command(
    group: Group,
    [id, title, hint]: [&'static str; 3],
    shortcuts: &'static [KeyboardShortcut],
    run: fn(&mut App, &Context),
) -> Command {
    Command {
        id,
        title,
        hint,
        group,
        shortcuts,
        is_enabled: |_| true,
        run,
    }
}

impl Command {
    /// Does it, if it can be done now.
    pub fn try_run(&self, app: &mut App, ctx: &Context) {
        if (self.is_enabled)(app) {
            (self.run)(app, ctx);
        }
    }

    /// The keys for it, as the screen shows them; empty where it has none.
    #[must_use]
    pub fn keys(&self, ctx: &Context) -> String {
        let keys = self.shortcuts.iter().map(|keys| ctx.format_shortcut(keys));
        keys.collect::<Vec<_>>().join(" or ")
    }

    /// What it does, with the first of the keys for it.
    #[must_use]
    pub fn hint(&self, ctx: &Context) -> String {
        self.shortcuts.first().map_or_else(
            || self.hint.to_owned(),
            |shortcut| format!("{} ({})", self.hint, ctx.format_shortcut(shortcut)),
        )
    }

    /// A button for it. Returns whether it is clicked.
    pub fn button(&self, ui: &mut Ui, app: &App) -> bool {
        self.show(ui, app, Button::new(self.title))
    }

    /// An entry of a menu for it, which closes the menu. Returns whether it is clicked.
    pub fn menu_item(&self, ui: &mut Ui, app: &App) -> bool {
        let mut button = Button::new(self.title);
        if let Some(shortcut) = self.shortcuts.first() {
            button = button.shortcut_text(ui.ctx().format_shortcut(shortcut));
        }
        let is_clicked = self.show(ui, app, button);
        if is_clicked {
            ui.close();
        }
        is_clicked
    }

    fn show(&self, ui: &mut Ui, app: &App, button: Button<'_>) -> bool {
        let hint = self.hint(ui.ctx());
        let is_enabled = (self.is_enabled)(app);
        let response = ui.add_enabled(is_enabled, button);
        // The keys beside the title are for the eye: the name is the title.
        response
            .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, is_enabled, self.title));
        response
            .on_hover_text(&hint)
            .on_disabled_hover_text(hint)
            .clicked()
    }
}

/// Runs the commands whose keys are pressed. A text field that is being typed in keeps its own.
pub fn run_pressed(app: &mut App, ctx: &Context) {
    if ctx.text_edit_focused() {
        return;
    }
    let keys_of =
        |command: &'static Command| command.shortcuts.iter().map(move |keys| (command, keys));
    let mut all: Vec<_> = COMMANDS.into_iter().flat_map(keys_of).collect();
    // egui takes Ctrl+Shift+Z for Ctrl+Z too: the more modifiers, the earlier.
    all.sort_by_key(|(_, keys)| {
        let Modifiers { alt, shift, .. } = keys.modifiers;
        std::cmp::Reverse(u8::from(alt) + u8::from(shift))
    });
    for (command, keys) in all {
        if ctx.input_mut(|input| input.consume_shortcut(keys)) {
            command.try_run(app, ctx);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn ids_titles_and_keys_are_each_of_one_command() {
        let ids: HashSet<&str> = COMMANDS.iter().map(|command| command.id).collect();
        let titles: HashSet<&str> = COMMANDS.iter().map(|command| command.title).collect();
        assert_eq!((ids.len(), titles.len()), (COMMANDS.len(), COMMANDS.len()));
        let keys: Vec<_> = COMMANDS
            .iter()
            .flat_map(|command| command.shortcuts)
            .collect();
        for (index, one) in keys.iter().enumerate() {
            assert!(keys.iter().skip(index + 1).all(|other| one != other));
        }
        for command in COMMANDS {
            assert!(!command.shortcuts.is_empty() && !command.hint.ends_with('.'));
        }
    }
}
