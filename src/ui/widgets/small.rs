//! Buttons of secondary rank: low beside text, as high as a finger needs where there are fingers.

use egui::{Button, IntoAtoms, Ui};

use crate::theme;

/// A button that is no higher than its text, where a mouse points at it.
pub fn button<'a>(ui: &Ui, text: impl IntoAtoms<'a>) -> Button<'a> {
    let button = Button::new(text);
    if ui.spacing().interact_size.y < theme::TOUCHED {
        button.small()
    } else {
        button
    }
}
