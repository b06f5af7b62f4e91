//! What can be done to a row of the list, and by which keys.

use egui::{Id, Key, Modifiers, Ui};

use bxdf_lab::contract::Witness;
use bxdf_study::session::EntryId;

/// What is to become of a material of the list.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    /// Edit it in the panels.
    Select,
    /// Show it, or do not.
    SetVisible(bool),
    /// Show it alone, or together with the others.
    SetSolo(bool),
    /// Type its name.
    StartRenaming,
    /// Go on typing.
    Type(String),
    /// Take over what was typed, or forget it.
    EndRenaming(bool),
    /// Add another one like it.
    Duplicate,
    /// Move it to this place.
    MoveTo(usize),
    /// Copy it as text.
    Copy,
    /// Remove it.
    Remove,
    /// Select it and hold the directions where it breaks a law.
    Inspect(Witness),
}

/// The id of the grip of a material's row: it stays the same when the row moves.
pub(super) fn grip_id(id: EntryId) -> Id {
    row_id(id).with("grip")
}

/// Whether `key` was pressed while the focus is on `response`, with Alt where `is_alt`.
pub(super) fn is_pressed(ui: &Ui, response: &egui::Response, key: Key, is_alt: bool) -> bool {
    let modifiers = if is_alt {
        Modifiers::ALT
    } else {
        Modifiers::NONE
    };
    response.has_focus() && ui.input_mut(|input| input.consume_key(modifiers, key))
}

/// The id of a material's row.
pub(super) fn row_id(id: EntryId) -> Id {
    Id::unique(("row", id))
}
