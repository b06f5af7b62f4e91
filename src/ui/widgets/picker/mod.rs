//! The picker: every model and every named material under its category.

use egui::{
    Align, Atom, Button, Color32, Context, Id, IdSalt, Key, Layout, Rect, Response, RichText,
    ScrollArea, StrokeKind, TextEdit, Ui, Vec2, pos2,
};

use super::hits::{self, Found, Highlight};
use super::thumbnails::Thumbnails;
use crate::theme;
use bxdf::error::Result;
use bxdf::material::library::Named;
use bxdf::{Material, ModelSpec, Side};
use bxdf_study::answers::Answers;
use bxdf_study::session::{EntryId, MaterialEntry, Materials};
use entry::{Entry, List};

mod entry;

/// The share of the panel's height that the list may take; the rest is for the parameters.
const LIST_SHARE: f32 = 0.45;

/// What the picker keeps between frames.
#[derive(Default)]
pub struct Picker {
    list: List,
    search: String,
    /// Which of the entries listed Enter chooses.
    highlight: Highlight,
    /// Materials looked at before: their sliders stand as they were left.
    shelf: Vec<(EntryId, Material)>,
    /// The id of the chosen entry that its list was last scrolled to.
    scrolled_to: &'static str,
    thumbnails: Thumbnails,
    /// The material it was last shown beside.
    beside: Option<EntryId>,
    /// Whether the list is folded away, to leave its room to the parameters.
    is_folded: bool,
    /// Whether the next choice is added, in place of replacing the selected material.
    is_adding: bool,
}

/// What was done in the field of the search.
struct Typed {
    /// By how many rows Up and Down went.
    rows: isize,
    is_entered: bool,
    /// Whether what is typed goes there.
    has_focus: bool,
}

impl Picker {
    /// Lets the next choice be added, searched for by what is typed from here on; or not any more.
    pub fn start_adding(&mut self, ctx: &Context) {
        self.is_adding ^= true;
        self.clear_search();
        if self.is_adding {
            self.is_folded = false;
            ctx.memory_mut(|memory| memory.request_focus(field_id()));
        }
    }

    /// Whether what is typed next goes to the search.
    #[must_use]
    pub fn has_focus(&self, ctx: &Context) -> bool {
        ctx.memory(|memory| memory.has_focus(field_id()))
    }

    /// Shows all entries again, of the list in which the selected material stands.
    pub fn clear_search(&mut self) {
        if !self.search.is_empty() {
            self.search.clear();
            self.beside = None;
        }
        self.highlight.restart();
    }

    /// The switch, the search field, and the list that the search leaves. Choosing an entry replaces the selected
    /// material by the one chosen as that before, or by the entry as it stands in the list; while one is to be added, it
    /// adds that.
    ///
    /// # Errors
    /// [`bxdf::Error::Limit`] where there are as many materials as a session has.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        materials: &mut Materials,
        answers: &mut Answers,
    ) -> Result<()> {
        self.follow(materials.selected());
        if self.is_adding {
            self.is_folded = false;
            self.say_adding(ui);
        }
        self.switch(ui);
        if self.is_folded {
            return Ok(());
        }
        let typed = self.field(ui);
        let found = self.found();
        self.highlight.go(&found, typed.rows);
        self.say_found(ui, &found, materials.selected());
        let height = LIST_SHARE * ui.available_height();
        let area = ScrollArea::vertical()
            .id_salt(self.list.word())
            .max_height(height)
            .auto_shrink([false, true]);
        let next = self.highlight.at();
        let shown = next.filter(|_| typed.has_focus);
        let clicked = area.show(ui, |ui| {
            self.entries(ui, &found, shown, materials.selected(), answers)
        });
        let entered = next.filter(|_| typed.is_entered);
        let entered = entered.and_then(|at| found.listed().get(at).copied());
        let Some(entry) = clicked.inner.or(entered) else {
            return Ok(());
        };
        if entered.is_some() || self.is_adding {
            self.clear_search();
        }
        if std::mem::take(&mut self.is_adding) {
            return materials.add(entry.material()).map(|_| ());
        }
        if !entry.is_origin_of(&materials.selected().material) {
            self.replace(materials.selected_mut(), entry);
        }
        Ok(())
    }

    /// The field of the search, with a button that clears it. Escape clears it too, and ends the adding.
    fn field(&mut self, ui: &mut Ui) -> Typed {
        let name = format!("Search {}", self.list.word());
        let hint =
            "Find a model or a material by name, category, author or note; arrows and Enter choose";
        let had_focus = self.has_focus(ui.ctx());
        let rows = if had_focus { hits::take_rows(ui) } else { 0 };
        let is_clearable = !self.search.is_empty();
        let mut is_cleared = false;
        let field = ui.horizontal(|ui| {
            let button = theme::RESET_WIDTH + ui.spacing().item_spacing.x;
            let room = if is_clearable { button } else { 0.0 };
            let field = TextEdit::singleline(&mut self.search)
                .id(field_id())
                .hint_text(&name)
                .desired_width(ui.available_width() - room);
            let field = ui.add(field).on_hover_text(hint);
            if is_clearable {
                let clear = ui
                    .small_button("×")
                    .on_hover_text("Clear the search (Escape)");
                ui.ctx()
                    .accesskit_node_builder(clear.id, |node| node.set_label("Clear the search"));
                is_cleared = clear.clicked();
            }
            field
        });
        let field = field.inner;
        ui.ctx()
            .accesskit_node_builder(field.id, |node| node.set_label(name));
        if field.changed() {
            self.highlight.restart();
        }
        let is_pressed = |key| ui.input(|input| input.key_pressed(key));
        if is_cleared || field.lost_focus() && is_pressed(Key::Escape) {
            self.clear_search();
        }
        let has_focus = field.has_focus();
        Typed {
            rows,
            is_entered: had_focus && !has_focus && is_pressed(Key::Enter),
            has_focus,
        }
    }

    /// What the search finds, in both lists; without one, what stands in the list shown.
    fn found(&self) -> Found<Entry> {
        let mut all = self.list.entries();
        if !self.search.trim().is_empty() {
            all.extend(self.list.other().entries());
        }
        hits::found(&self.search, all, Entry::known)
    }

    /// Says where nothing has the words, and where what is selected is not among what has them.
    fn say_found(&self, ui: &mut Ui, found: &Found<Entry>, selected: &MaterialEntry) {
        if matches!(found, Found::Nearest(_)) {
            ui.weak("No model or material matches; the nearest names are");
        }
        let Some(origin) = Entry::of(&selected.material) else {
            return;
        };
        let mut listed = found.listed().iter();
        let is_hidden =
            !matches!(found, Found::All(_)) && !listed.any(|one| one.id() == origin.id());
        if is_hidden && !self.is_adding {
            let name = origin.known().names.first().copied().unwrap_or_default();
            ui.weak(format!("Selected, but not found by this search: {name}"));
        }
    }

    /// Which list is shown, and whether.
    fn switch(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            for (list, name, hint) in [
                (List::Models, "Models", "Formulas at their default parameters, each by itself"),
                (
                    List::Materials,
                    "Materials",
                    "Things to recognise: one or several models with parameters from a stated source",
                ),
            ] {
                let is_shown = self.list == list && !self.is_folded;
                if ui.selectable_label(is_shown, name).on_hover_text(hint).clicked() {
                    (self.list, self.is_folded) = (list, false);
                }
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let word = if self.is_folded { "Unfold" } else { "Fold" };
                let hint = "Collapse the list to make room for the parameters, or expand it";
                if ui.small_button(word).on_hover_text(hint).clicked() {
                    self.is_folded = !self.is_folded;
                }
            });
        });
    }

    /// Shows the list in which the selected material stands, where another one has been selected.
    fn follow(&mut self, selected: &MaterialEntry) {
        if self.beside == Some(selected.id()) {
            return;
        }
        self.beside = Some(selected.id());
        self.scrolled_to = "";
        match Entry::of(&selected.material) {
            Some(Entry::Named(_)) => self.list = List::Materials,
            Some(Entry::Model(_)) => self.list = List::Models,
            None => {}
        }
    }

    /// Says what the next choice does; Escape ends it.
    fn say_adding(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            ui.label(RichText::new("Choose what to add").strong());
            let cancel = ui
                .small_button("Cancel")
                .on_hover_text("Add nothing (Escape)");
            let is_escaped = ui.input(|input| input.key_pressed(Key::Escape));
            if cancel.clicked() || is_escaped {
                self.is_adding = false;
                self.clear_search();
            }
        });
    }

    /// Replaces the material; it is kept as it was left.
    fn replace(&mut self, chosen: &mut MaterialEntry, entry: Entry) {
        let id = chosen.id();
        // It is under the pointer: the list stays where it is.
        self.scrolled_to = entry.id();
        let is_kept = |(of, kept): &(EntryId, Material)| *of == id && entry.is_origin_of(kept);
        let kept = self.shelf.iter().position(is_kept);
        let next = kept.map_or_else(|| entry.material(), |index| self.shelf.swap_remove(index).1);
        self.shelf.push((id, chosen.material.clone()));
        chosen.replace(next);
    }

    /// What is listed, under its categories where all is. `next`: the row that Enter chooses. Returns the one that is
    /// chosen now.
    fn entries(
        &mut self,
        ui: &mut Ui,
        found: &Found<Entry>,
        next: Option<usize>,
        selected: &MaterialEntry,
        answers: &mut Answers,
    ) -> Option<Entry> {
        let is_moved = self.highlight.take_moved();
        let (mut chosen, mut index) = (None, 0);
        let mut show = |ui: &mut Ui, entry: &Entry| {
            let row = self.row(ui, *entry, selected, answers);
            if next == Some(index) {
                let stroke = ui.visuals().selection.stroke;
                ui.painter()
                    .rect_stroke(row.rect, 3.0, stroke, StrokeKind::Inside);
                if is_moved {
                    row.scroll_to_me(Some(Align::Center));
                }
            }
            if row.clicked() {
                chosen = Some(*entry);
            }
            index += 1;
        };
        if let Found::All(all) = found {
            for group in all.chunk_by(|one, other| one.category() == other.category()) {
                let Some(category) = group.first().map(|entry| entry.category()) else {
                    continue;
                };
                ui.label(RichText::new(category.title()).strong())
                    .on_hover_text(category.meaning());
                ui.indent(category.id(), |ui| {
                    for entry in group {
                        show(ui, entry);
                    }
                });
            }
        } else {
            let listed = found.listed().iter();
            listed.for_each(|entry| show(ui, entry));
        }
        chosen
    }

    /// A row.
    fn row(
        &mut self,
        ui: &mut Ui,
        entry: Entry,
        selected: &MaterialEntry,
        answers: &mut Answers,
    ) -> Response {
        let is_chosen = !self.is_adding && entry.is_origin_of(&selected.material);
        let row = match entry {
            Entry::Model(model) => ui.selectable_label(is_chosen, title(model)),
            Entry::Named(named) => self.pictured(ui, named, is_chosen, answers),
        };
        let row = row.on_hover_text(entry.hint());
        if is_chosen && self.scrolled_to != entry.id() {
            self.scrolled_to = entry.id();
            row.scroll_to_me(Some(Align::Center));
        }
        row
    }

    /// A row with a picture; the name says it all to those who do not see.
    fn pictured(
        &mut self,
        ui: &mut Ui,
        named: &'static Named,
        is_chosen: bool,
        answers: &mut Answers,
    ) -> Response {
        let salt = IdSalt::new(named.id);
        let picture = Atom::custom(salt, Vec2::splat(theme::THUMBNAIL_SIZE));
        let row = Button::selectable(is_chosen, (picture, named.material.name.as_str())).truncate();
        let row = row.atom_ui(ui);
        if let Some(rect) = row.rect(salt)
            && ui.is_rect_visible(rect)
            && let Some(texture) = self.thumbnails.get(ui.ctx(), named, answers)
        {
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            ui.painter().image(texture, rect, whole, Color32::WHITE);
        }
        row.response
    }
}

/// The id of the field of the search, known before it is shown.
fn field_id() -> Id {
    Id::unique("search of the picker")
}

/// The title, and the sides where they are not plain from it.
#[must_use]
pub fn title(model: &ModelSpec) -> String {
    let sides: Vec<&str> = [(Side::Reflection, "R"), (Side::Transmission, "T")]
        .into_iter()
        .filter(|(side, _)| model.lobes.iter().any(|lobe| lobe.side == *side))
        .map(|(_, letter)| letter)
        .collect();
    format!("{}  ({})", model.title, sides.join(" + "))
}
