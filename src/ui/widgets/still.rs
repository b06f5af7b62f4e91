//! What nobody can act in: pictures are drawn by the views themselves, whose controls are not there then.

use egui::{ScrollArea, Sense, Ui};

/// Leaves only what is to be seen of all that is drawn into `ui` from now on: nothing takes the pointer or the focus, and no
/// text can be selected.
pub fn make(ui: &mut Ui) {
    let style = ui.style_mut();
    style.interaction.selectable_labels = false;
    // It looks as it does elsewhere.
    style.visuals.disabled_alpha = 1.0;
    ui.disable();
}

/// Whether `ui` is such a place.
#[must_use]
pub fn is(ui: &Ui) -> bool {
    !ui.is_enabled()
}

/// What something in `ui` senses that senses this where it can be acted in.
#[must_use]
pub fn sense(ui: &Ui, sense: Sense) -> Sense {
    if is(ui) { Sense::hover() } else { sense }
}

/// What `add` draws, in `area` where it can be scrolled.
pub fn scroll(ui: &mut Ui, area: ScrollArea, add: impl FnOnce(&mut Ui)) {
    if is(ui) {
        add(ui);
    } else {
        area.show(ui, add);
    }
}
