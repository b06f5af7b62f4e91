//! Numbers typed into fields, one event a frame.

use std::collections::BTreeSet;

use egui::{Event, Key, Modifiers, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

pub fn key(key: Key, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

/// Clicks a field and types over what stands there, one event a frame.
pub fn type_into<S>(harness: &mut Harness<'_, S>, name: &str, text: &str) {
    let field = harness.get_by_role_and_label(Role::SpinButton, name);
    field.click();
    harness.step();
    harness.event(key(Key::A, Modifiers::COMMAND));
    harness.event(key(Key::Delete, Modifiers::NONE));
    for letter in text.chars() {
        harness.event(Event::Text(letter.to_string()));
    }
    harness.step();
}

pub fn press<S>(harness: &mut Harness<'_, S>, pressed: Key) {
    harness.event(key(pressed, Modifiers::NONE));
    harness.step();
    harness.step();
}

pub fn enter<S>(harness: &mut Harness<'_, S>, name: &str, text: &str) {
    type_into(harness, name, text);
    press(harness, Key::Enter);
}

/// The text in a field, and why it is refused.
pub fn said<S>(harness: &Harness<'_, S>, name: &str) -> (String, Option<String>) {
    let field = harness.get_by_role_and_label(Role::SpinButton, name);
    let node = field.accesskit_node();
    let is_refused = node.data().invalid().is_some();
    let words = node.description().filter(|_| is_refused);
    (field.value().unwrap_or_default(), words)
}

/// The names of all fields.
pub fn fields<S>(harness: &Harness<'_, S>) -> BTreeSet<String> {
    let all = harness.query_all_by_role(Role::SpinButton);
    all.filter_map(|node| node.accesskit_node().label())
        .collect()
}
