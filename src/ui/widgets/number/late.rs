//! What is typed in the very frame in which Tab moves the focus on. A slow frame holds several keys, and by the time it is
//! drawn the focus is at the next control: what came before Tab would be lost, or typed there.

use std::ops::Range;

use egui::{Event, Key};

/// Takes what was typed before Tab out of `events`, and puts it in place of the characters `selected` of `text`.
pub(super) fn type_before_tab(events: &mut Vec<Event>, text: &mut String, selected: Range<usize>) {
    let is_tab = |event: &Event| {
        matches!(
            event,
            Event::Key {
                key: Key::Tab,
                pressed: true,
                ..
            }
        )
    };
    let Some(tab) = events.iter().position(is_tab) else {
        return;
    };
    let mut selected = selected;
    let mut index = 0;
    events.retain(|event| {
        let is_before = index < tab;
        index += 1;
        let typed = match event {
            Event::Text(typed) | Event::Paste(typed) => typed.as_str(),
            Event::Key {
                key: Key::Backspace,
                pressed: true,
                ..
            } => {
                if selected.is_empty() {
                    selected.start = selected.start.saturating_sub(1);
                }
                ""
            }
            _ => return true,
        };
        if is_before {
            replace(text, &selected, typed);
            let end = selected.start + typed.chars().count();
            selected = end..end;
        }
        !is_before
    });
}

/// Puts `typed` in place of these characters.
fn replace(text: &mut String, selected: &Range<usize>, typed: &str) {
    let before = text.chars().take(selected.start);
    let after = text.chars().skip(selected.end);
    *text = before.chain(typed.chars()).chain(after).collect();
}

#[cfg(test)]
mod tests {
    use egui::Modifiers;

    use super::*;

    fn key(key: Key) -> Event {
        Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        }
    }

    #[test]
    fn what_comes_before_tab_is_typed_and_what_comes_after_stays() {
        let typed = |text: &str| Event::Text(text.to_owned());
        let mut text = "33,".to_owned();
        let mut events = vec![
            typed("7"),
            key(Key::Backspace),
            typed("25"),
            key(Key::Tab),
            typed("9"),
        ];
        type_before_tab(&mut events, &mut text, 3..3);
        assert_eq!(text, "33,25");
        assert_eq!(events, [key(Key::Tab), typed("9")]);
        let mut events = vec![typed("1"), key(Key::Tab)];
        type_before_tab(&mut events, &mut text, 0..5);
        assert_eq!(text, "1");
        let mut events = vec![typed("2")];
        type_before_tab(&mut events, &mut text, 0..1);
        assert_eq!((text.as_str(), events.len()), ("1", 1), "no Tab, no haste");
    }
}
