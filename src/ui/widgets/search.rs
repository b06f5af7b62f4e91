//! A window to search and choose in.

use egui::{Align, Button, Context, Id, Key, Modal, Response, ScrollArea, TextEdit, Ui};

use super::hits::{self, Found, Highlight};
use crate::theme;

/// What becomes of the search.
pub enum Outcome<T> {
    /// It goes on.
    Open,
    /// It is over.
    Closed,
    /// This is chosen.
    Chosen(T),
}

/// How something to choose is shown.
pub struct Entry {
    /// What it is called.
    pub title: String,
    /// The keys for it, as the screen shows them; empty where it has none.
    pub keys: String,
    /// What it does.
    pub hint: &'static str,
    /// Whether it can be chosen now.
    pub is_enabled: bool,
}

/// A search that is going on.
#[derive(Debug, Default)]
pub struct Search {
    wanted: String,
    /// Which of those found Enter chooses.
    highlight: Highlight,
}

impl Search {
    /// A search whose field has the focus from here on.
    #[must_use]
    pub fn begin(ctx: &Context) -> Self {
        ctx.memory_mut(|memory| memory.request_focus(field_id()));
        Self::default()
    }

    /// The window of the search among what `found` finds, each shown as `entry` says.
    pub fn show<T: Copy>(
        &mut self,
        ctx: &Context,
        found: impl Fn(&str) -> Found<T>,
        entry: impl Fn(&T) -> Entry,
    ) -> Outcome<T> {
        let modal = Modal::new(Id::unique("search")).show(ctx, |ui| {
            ui.set_width(theme::SEARCH_SIZE.x.min(theme::room_of_dialog(ctx).x));
            let rows = hits::take_rows(ui);
            let field = TextEdit::singleline(&mut self.wanted)
                .id(field_id())
                .hint_text("Search commands")
                .desired_width(f32::INFINITY);
            let field = ui.add(field);
            ctx.accesskit_node_builder(field.id, |node| node.set_label("Search all commands"));
            if !field.has_focus() {
                field.request_focus();
            }
            if field.changed() {
                self.highlight.restart();
            }
            let found = found(&self.wanted);
            self.highlight.go(&found, rows);
            if matches!(found, Found::Nearest(_)) {
                ui.weak("No command matches; the nearest are");
            }
            let is_entered = ui.input(|input| input.key_pressed(Key::Enter));
            let (listed, next) = (found.listed(), self.highlight.at());
            let mut chosen = next
                .filter(|_| is_entered)
                .and_then(|at| listed.get(at))
                .copied();
            let is_moved = self.highlight.take_moved();
            let area = ScrollArea::vertical().max_height(theme::SEARCH_SIZE.y);
            area.show(ui, |ui| {
                for (index, one) in listed.iter().enumerate() {
                    let is_next = next == Some(index);
                    let row = row(ui, &entry(one), is_next);
                    if is_next && is_moved {
                        row.scroll_to_me(Some(Align::Center));
                    }
                    if row.clicked() {
                        chosen = Some(*one);
                    }
                }
            });
            chosen
        });
        match modal.inner {
            Some(one) => Outcome::Chosen(one),
            None if modal.should_close() => Outcome::Closed,
            None => Outcome::Open,
        }
    }
}

/// The field's, known before it is shown.
fn field_id() -> Id {
    Id::unique("search of the commands")
}

/// Something that is found.
fn row(ui: &mut Ui, entry: &Entry, is_next: bool) -> Response {
    let title = entry.title.as_str();
    let mut button =
        Button::selectable(is_next, title).min_size(egui::vec2(ui.available_width(), 0.0));
    if !entry.keys.is_empty() {
        button = button.shortcut_text(&entry.keys);
    }
    let response = ui.add_enabled(entry.is_enabled, button);
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::Button, entry.is_enabled, is_next, title)
    });
    response.on_hover_text(entry.hint)
}
