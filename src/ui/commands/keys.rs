//! Commands by their keys.

use egui::{Context, Event, InputState, KeyboardShortcut, Modifiers};

use super::command::Command;
use super::list::COMMANDS;
use crate::app::App;

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
