//! Links of the window, until they are followed or copied.

use egui::{Context, Key};

/// Where links lead to, and what was made of them.
#[derive(Default)]
pub struct Links {
    /// The address of the page that links begin with, where one is known.
    pub(super) page: Option<String>,
    /// The link that was made last, from `#` on, until somebody takes it.
    pub(super) made: Option<String>,
    /// The address of the page while it is typed.
    pub(super) typed: Option<String>,
}

/// What becomes of the field for the address of the page.
pub(super) enum Outcome {
    /// It stays.
    Open,
    /// It was left as it was before.
    Left,
    /// This is the address.
    Set,
}

/// Whether a text is the address of a page: what links may begin with.
pub(super) fn is_page(text: &str) -> bool {
    let begins = ["https://", "http://", "file://"];
    let rest = begins.iter().find_map(|begin| text.strip_prefix(begin));
    rest.is_some_and(|rest| !rest.is_empty()) && !text.contains(['#', ' ', '\n', '\t'])
}

/// The field for the address of the page.
pub(super) fn show_field(ctx: &Context, typed: &mut String) -> Outcome {
    let mut outcome = Outcome::Open;
    let id = egui::Id::unique("address of the page");
    let modal = egui::Modal::new(id).show(ctx, |ui| {
        ui.heading("Address of the page");
        ui.label("Links begin with it: the folder that scripts/web makes, wherever it is hosted.");
        let field = egui::TextEdit::singleline(typed)
            .desired_width(420.0)
            .hint_text("https://example.org/explorer/");
        let label = ui.label("Address");
        let response = ui.add(field).labelled_by(label.id);
        if !ui.memory(|memory| memory.has_focus(response.id)) && !response.lost_focus() {
            response.request_focus();
        }
        let text = typed.trim();
        let is_sound = text.is_empty() || is_page(text);
        if !is_sound {
            ui.label("An address begins with https:// and has no # in it");
        }
        let has_entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        ui.horizontal(|ui| {
            let set = ui.add_enabled(is_sound, egui::Button::new("Set"));
            if set.clicked() || is_sound && has_entered {
                outcome = Outcome::Set;
            }
            if ui.button("Cancel").clicked() {
                outcome = Outcome::Left;
            }
        });
    });
    if modal.should_close() && matches!(outcome, Outcome::Open) {
        return Outcome::Left;
    }
    outcome
}

#[cfg(test)]
mod tests {
    use super::is_page;

    #[test]
    fn addresses_are_told_from_other_texts() {
        for text in [
            "https://a.example/b/",
            "http://127.0.0.1:8080/",
            "https://a/b/?theme=dark",
        ] {
            assert!(is_page(text), "{text}");
        }
        for text in [
            "",
            "https://",
            "a.example",
            "https://a/#s=3",
            "https://a b",
            "javascript:3",
        ] {
            assert!(!is_page(text), "{text}");
        }
    }
}
