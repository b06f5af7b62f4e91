//! The commands: what each is, and how it is run, by buttons and by keys.

use egui::{Button, Context, Event, InputState, KeyboardShortcut, Modifiers, Ui};

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
    /// How things are now that it changes, in a few words; for what one sees anyway there are none.
    pub state: Option<fn(&App) -> String>,
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
        state: None,
    }
}

impl Command {
    /// Does it, if it can be done now.
    pub fn try_run(&self, app: &mut App, ctx: &Context) {
        if (self.is_enabled)(app) {
            (self.run)(app, ctx);
        }
    }

    /// Does it, if it can be done now, and says what has become of it.
    pub fn run_and_say(&self, app: &mut App, ctx: &Context) {
        if !(self.is_enabled)(app) {
            app.say(format!("Not possible now: {}", self.title), ctx);
            return;
        }
        (self.run)(app, ctx);
        if let Some(state) = self.state {
            app.say(state(app), ctx);
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

/// Runs the commands whose keys are pressed, in their order, until one of them gives the focus to a text: what follows is
/// typed there. A text that has the focus keeps all keys.
pub fn run_pressed(app: &mut App, ctx: &Context) {
    while !app.is_typed_in(ctx) {
        let Some(pressed) = ctx.input_mut(take_pressed) else {
            return;
        };
        if !is_letter(*pressed.keys) {
            pressed.command.try_run(app, ctx);
        } else if !pressed.is_repeated {
            pressed.command.run_and_say(app, ctx);
        }
    }
}

/// Keys of a command that are pressed.
struct Pressed {
    command: &'static Command,
    keys: &'static KeyboardShortcut,
    /// Whether they are held since an earlier frame.
    is_repeated: bool,
}

/// Takes the first keys of a command out of the events, with the text that they would type.
fn take_pressed(input: &mut InputState) -> Option<Pressed> {
    let mut events = input.events.iter().enumerate();
    let (index, pressed) = events.find_map(|(index, event)| Some((index, pressed(event)?)))?;
    input.events.remove(index);
    if matches!(input.events.get(index), Some(Event::Text(_))) {
        input.events.remove(index);
    }
    Some(pressed)
}

fn pressed(event: &Event) -> Option<Pressed> {
    let Event::Key {
        key,
        pressed: true,
        modifiers,
        repeat,
        ..
    } = event
    else {
        return None;
    };
    let all = COMMANDS.into_iter().flat_map(|command| {
        let keys = command.shortcuts.iter();
        keys.map(move |keys| (command, keys))
    });
    let is_meant = |(_, keys): &(&Command, &KeyboardShortcut)| {
        keys.logical_key == *key && modifiers.matches_logically(keys.modifiers)
    };
    // egui takes Ctrl+Shift+Z for Ctrl+Z too: the more modifiers, the earlier.
    let (command, keys) = all.filter(is_meant).max_by_key(|(_, keys)| {
        let Modifiers { alt, shift, .. } = keys.modifiers;
        u8::from(alt) + u8::from(shift)
    })?;
    Some(Pressed {
        command,
        keys,
        is_repeated: *repeat,
    })
}

/// Whether these keys would type something into a text: nothing at them says that they do more.
fn is_letter(keys: KeyboardShortcut) -> bool {
    keys.modifiers.is_none() && keys.logical_key.symbol_or_name().chars().count() == 1
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

    #[test]
    fn what_a_letter_does_can_be_said() {
        let has_letter = |command: &&Command| command.shortcuts.iter().copied().any(is_letter);
        let with_letters: Vec<&Command> = COMMANDS.into_iter().filter(has_letter).collect();
        assert!(with_letters.len() > 5);
        for command in with_letters {
            assert!(command.state.is_some(), "{}", command.id);
        }
    }
}
