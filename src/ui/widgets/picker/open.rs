//! The picker while it is shown: tabs, search, and the grid of pictures.

use std::ops::Range;

use egui::{
    Align, Area, Context, Frame, Id, Key, Label, Layout, Modifiers, Order, Rect, RichText,
    ScrollArea, Sense, TextEdit, Ui, Vec2, pos2,
};

use super::cell::Cell;
use super::entry::{Entry, List};
use super::grid;
use crate::theme;
use crate::widgets::category;
use crate::widgets::hits::{self, Found, Highlight};
use crate::widgets::small;
use crate::widgets::thumbnails::Thumbnails;
use bxdf::Category;
use bxdf_study::answers::Answers;
use bxdf_study::session::{MaterialEntry, Materials};

/// The room around the picker, in points.
const MARGIN: f32 = 6.0;

/// The lines of the picker above and below its grid, in points.
const AROUND_GRID: f32 = 88.0;

/// What the keys do, below the grid.
const KEYS: &str = "Arrows and Enter choose; Shift+Enter adds, and stays open";

/// The picker while it is shown.
pub(super) struct Open {
    list: List,
    search: String,
    /// Which of the entries found Enter chooses.
    highlight: Highlight,
    /// Whether what is chosen is added, in place of replacing the selected material.
    pub(super) is_adding: bool,
    /// Whether it was not shown yet: the click that opens it does not close it.
    is_new: bool,
}

/// What became of the picker in a frame.
#[derive(Default)]
pub(super) struct Outcome {
    /// What is chosen, and whether it is added while the picker stays.
    pub(super) chosen: Option<(Entry, bool)>,
    pub(super) is_left: bool,
}

/// What the keys ask for.
struct Keys {
    /// By how many places and rows the arrows go.
    steps: [isize; 2],
    /// Whether what is next is chosen, and whether it is added then.
    entered: Option<bool>,
}

impl Open {
    /// The picker, so that what is chosen is added where it `is_adding`, with the list in which `selected` stands.
    pub(super) fn new(is_adding: bool, selected: &MaterialEntry) -> Self {
        Self {
            list: List::of(&selected.material).unwrap_or_default(),
            search: String::new(),
            highlight: Highlight::default(),
            is_adding,
            is_new: true,
        }
    }

    /// The picker over `room`, or over what is beside it where that is too narrow for it.
    pub(super) fn show(
        &mut self,
        ctx: &Context,
        room: Rect,
        materials: &Materials,
        (thumbnails, answers): (&mut Thumbnails, &mut Answers),
    ) -> Outcome {
        let frame = Frame::popup(&ctx.style_of(ctx.theme()));
        let edge = frame.total_margin().sum() + Vec2::splat(2.0 * MARGIN);
        let columns = grid::columns(room.width() - edge.x);
        // Where the room beside the panel is too narrow for one column, it stands over the panel.
        let width = grid::width(columns);
        let left = (room.left() + MARGIN).min(ctx.content_rect().right() - width - edge.x);
        let height = (room.height() - edge.y).min(theme::GRID_HEIGHT);
        let area = Area::new(Id::unique("picker"))
            .order(Order::Foreground)
            .fixed_pos(pos2(left.max(0.0), room.top() + MARGIN))
            .show(ctx, |ui| {
                let framed = frame.show(ui, |ui| {
                    ui.set_width(width);
                    ui.set_max_height(height);
                    self.contents(ui, columns, materials, (thumbnails, answers))
                });
                framed.inner
            });
        let mut outcome = area.inner;
        if std::mem::take(&mut self.is_new) {
            // The click that opens it is one elsewhere to the field too, which gives up the focus for it.
            ctx.memory_mut(|memory| memory.request_focus(field_id()));
        } else {
            outcome.is_left |= area.response.clicked_elsewhere();
        }
        outcome
    }

    fn contents(
        &mut self,
        ui: &mut Ui,
        columns: usize,
        materials: &Materials,
        (thumbnails, answers): (&mut Thumbnails, &mut Answers),
    ) -> Outcome {
        let keys = keys(ui);
        let is_left = self.head(ui, &materials.title(materials.selected()));
        self.field(ui);
        let found = self.found();
        let rows = grid::rows(groups(&found).map(<[Entry]>::len), columns);
        let selected = materials.selected();
        self.go(&found, &rows, keys.steps, selected);
        if matches!(found, Found::Nearest(_)) {
            ui.weak("No model or material matches; the nearest names are");
        }
        let entered = keys.entered.zip(self.highlight.at());
        let entered = entered.and_then(|(is_added, at)| Some((*found.listed().get(at)?, is_added)));
        let height = (ui.max_rect().height() - AROUND_GRID).max(theme::CELL.y);
        let area = ScrollArea::vertical()
            .id_salt(self.list.word())
            .max_height(height)
            .auto_shrink([false, true]);
        let clicked = area
            .show(ui, |ui| {
                self.cells(ui, &found, columns, selected, (thumbnails, answers))
            })
            .inner;
        let is_shift = ui.input(|input| input.modifiers.shift);
        ui.weak(KEYS);
        Outcome {
            chosen: entered.or(clicked.map(|entry| (entry, is_shift))),
            is_left,
        }
    }

    /// What the next choice does, and the tabs. Returns whether the picker is left.
    fn head(&mut self, ui: &mut Ui, selected: &str) -> bool {
        let is_escaped = ui.input(|input| input.key_pressed(Key::Escape));
        let row = ui.horizontal(|ui| {
            for (list, name, hint) in List::ALL {
                let tab = ui.selectable_label(self.list == list, name);
                if tab.on_hover_text(hint).clicked() {
                    self.list = list;
                    self.highlight.restart();
                }
            }
            ui.separator();
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let cancel = ui.add(small::button(ui, "Cancel"));
                let is_cancelled = cancel.on_hover_text("Choose nothing (Escape)").clicked();
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let text = if self.is_adding {
                        "Choose what to add".to_owned()
                    } else {
                        format!("In place of {selected}")
                    };
                    ui.add(Label::new(RichText::new(text).strong()).truncate());
                });
                is_cancelled
            })
            .inner
        });
        row.inner || is_escaped
    }

    /// The field of the search, with a button that clears it.
    fn field(&mut self, ui: &mut Ui) {
        let name = format!("Search {}", self.list.word());
        let hint = "Find a model or a material by name, category, author or note, in both lists";
        ui.horizontal(|ui| {
            let button = theme::RESET_WIDTH + ui.spacing().item_spacing.x;
            let is_clearable = !self.search.is_empty();
            let room = if is_clearable { button } else { 0.0 };
            let field = TextEdit::singleline(&mut self.search)
                .id(field_id())
                .hint_text(&name)
                .desired_width(ui.available_width() - room);
            let field = ui.add(field).on_hover_text(hint);
            ui.ctx()
                .accesskit_node_builder(field_id(), |node| node.set_label(name));
            if field.changed() {
                self.highlight.restart();
            }
            if is_clearable {
                let clear = ui
                    .add(small::button(ui, "×"))
                    .on_hover_text("Clear the search");
                ui.ctx()
                    .accesskit_node_builder(clear.id, |node| node.set_label("Clear the search"));
                if clear.clicked() {
                    self.search.clear();
                    self.highlight.restart();
                }
            }
        });
    }

    /// What the search finds, in both lists; without one, what stands in the list shown.
    fn found(&self) -> Found<Entry> {
        let mut all = self.list.entries();
        if !self.search.trim().is_empty() {
            all.extend(self.list.other().entries());
        }
        hits::found(&self.search, all, Entry::known)
    }

    /// Goes where the arrows lead; from what is selected, where nothing is searched for.
    fn go(
        &mut self,
        found: &Found<Entry>,
        rows: &[Range<usize>],
        steps: [isize; 2],
        selected: &MaterialEntry,
    ) {
        if let (None, Found::All(all)) = (self.highlight.at(), found) {
            let is_origin = |entry: &Entry| entry.is_origin_of(&selected.material);
            if let Some(at) = all.iter().position(is_origin) {
                self.highlight.go_to(at);
            }
        }
        self.highlight.go(found, 0);
        if let Some(at) = grid::moved(rows, self.highlight.at(), steps) {
            self.highlight.go_to(at);
        }
    }

    /// The grid, under categories where nothing is searched for. Returns the entry that is clicked.
    fn cells(
        &mut self,
        ui: &mut Ui,
        found: &Found<Entry>,
        columns: usize,
        selected: &MaterialEntry,
        (thumbnails, answers): (&mut Thumbnails, &mut Answers),
    ) -> Option<Entry> {
        let is_moved = self.highlight.take_moved();
        let (mut clicked, mut index) = (None, 0);
        ui.spacing_mut().item_spacing = Vec2::splat(theme::CELL_GAP);
        for group in groups(found) {
            if let (Found::All(_), Some(first)) = (found, group.first()) {
                heading(ui, first.category());
            }
            for row in group.chunks(columns) {
                ui.horizontal(|ui| {
                    for entry in row {
                        let is_next = self.highlight.at() == Some(index);
                        let cell = Cell {
                            entry: *entry,
                            is_selected: !self.is_adding && entry.is_origin_of(&selected.material),
                            is_next,
                        };
                        let shown = cell.show(ui, thumbnails, answers);
                        if is_next && is_moved {
                            shown.scroll_to_me(Some(Align::Center));
                        }
                        if shown.clicked() {
                            clicked = Some(*entry);
                        }
                        index += 1;
                    }
                });
            }
        }
        clicked
    }
}

/// What is pressed, before the field would take it.
fn keys(ui: &Ui) -> Keys {
    let has_focus = ui.memory(|memory| memory.has_focus(field_id()));
    if !has_focus {
        // Unless something else is typed into or gone to, the search is.
        if ui.memory(|memory| memory.focused().is_none()) {
            ui.memory_mut(|memory| memory.request_focus(field_id()));
        }
        return Keys {
            steps: [0, 0],
            entered: None,
        };
    }
    let take = |modifiers| ui.input_mut(|input| input.consume_key(modifiers, Key::Enter));
    let is_added = take(Modifiers::SHIFT);
    let is_entered = is_added || take(Modifiers::NONE);
    Keys {
        steps: [hits::take_columns(ui), hits::take_rows(ui)],
        entered: is_entered.then_some(is_added),
    }
}

/// What stands together: the entries of a category, or all that a search finds.
fn groups(found: &Found<Entry>) -> impl Iterator<Item = &[Entry]> {
    let is_whole = !matches!(found, Found::All(_));
    let together = move |one: &Entry, other: &Entry| is_whole || one.category() == other.category();
    found.listed().chunk_by(together)
}

/// The name of a category, with its icon.
fn heading(ui: &mut Ui, category: Category) {
    ui.add_space(theme::CELL_GAP);
    ui.horizontal(|ui| {
        let side = Vec2::splat(theme::CATEGORY_ICON);
        let (rect, _) = ui.allocate_exact_size(side, Sense::hover());
        category::icon(ui.painter(), rect, category, ui.visuals().weak_text_color());
        ui.label(RichText::new(category.title()).strong())
            .on_hover_text(category.meaning());
    });
}

/// The id of the field of the search, known before it is shown.
pub(super) fn field_id() -> Id {
    Id::unique("search of the picker")
}
