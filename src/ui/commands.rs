//! The commands: the one list that buttons, shortcuts and the help make use of.

use egui::{Button, Context, Key, KeyboardShortcut, Modifiers, Ui};

use super::app::App;

/// Something that can be done to the whole window.
pub struct Command {
    /// The id: a word that never changes.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What it does, in a sentence.
    pub hint: &'static str,
    /// The keys for it, the first of which is shown.
    pub shortcuts: &'static [KeyboardShortcut],
    /// Whether it can be done now.
    pub is_enabled: fn(&App) -> bool,
    /// Does it.
    pub run: fn(&mut App, &Context),
}

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

const fn key(modifiers: Modifiers, key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(modifiers, key)
}

/// Takes back the last edit.
pub static UNDO: Command = Command {
    id: "undo",
    title: "Undo",
    hint: "Take back the last edit of the session",
    shortcuts: &[key(Modifiers::COMMAND, Key::Z)],
    is_enabled: |app| app.history.can_undo(),
    run: |app, _| app.history.undo(&mut app.session),
};

/// Does again what was taken back.
pub static REDO: Command = Command {
    id: "redo",
    title: "Redo",
    hint: "Do again what was taken back",
    shortcuts: &[key(CTRL_SHIFT, Key::Z), key(Modifiers::COMMAND, Key::Y)],
    is_enabled: |app| app.history.can_redo(),
    run: |app, _| app.history.redo(&mut app.session),
};

/// Every command.
pub static COMMANDS: [&Command; 2] = [&UNDO, &REDO];

impl Command {
    /// Does it, if it can be done now.
    pub fn try_run(&self, app: &mut App, ctx: &Context) {
        if (self.is_enabled)(app) {
            (self.run)(app, ctx);
        }
    }

    /// What it does, with the keys for it.
    #[must_use]
    pub fn hint(&self, ctx: &Context) -> String {
        self.shortcuts.first().map_or_else(
            || self.hint.to_owned(),
            |shortcut| format!("{} ({})", self.hint, ctx.format_shortcut(shortcut)),
        )
    }

    /// A button for it. Returns whether it is clicked.
    pub fn button(&self, ui: &mut Ui, app: &App) -> bool {
        let hint = self.hint(ui.ctx());
        ui.add_enabled((self.is_enabled)(app), Button::new(self.title))
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
